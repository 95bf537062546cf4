#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <strike/calibrate/student_t.hpp>
#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/text.hpp>

#include <unsupported/Eigen/LevenbergMarquardt>

namespace strike::calibrate {

/// Sign of a parameter. A positive one is searched by its logarithm.
enum class Sign { positive, any };

/// A parameter to fit.
struct Unknown {
  std::string name;
  double start;  ///< the first guess, also the scale: not 0
  Sign sign = Sign::positive;

  void ranges(const auto& number) const {
    const bool negative = sign == Sign::any && start < 0;
    number("start", start, negative ? range::below(0) : range::positive, "it is also the scale of the parameter");
  }
};

struct FitOptions {
  double tolerance = 1e-8;       ///< of the parameters and of the sum of squares, relative
  std::size_t evaluations = 50;  ///< largest number
  double confidence = 0.95;      ///< the probability of the intervals

  void ranges(const auto& number) const {
    number("tolerance", tolerance, range::positive);
    number("evaluations", evaluations, range::count);
    number("confidence", confidence, Range{.low = 0, .high = 1});
  }
};

/// Reason for which a fit has stopped.
enum class FitEnd { converged, evaluations };

struct Interval {
  double lower, upper;

  bool contains(double value) const { return lower <= value && value <= upper; }
};

/// Estimate of N parameters from data.
template <std::size_t N>
struct Fit {
  std::array<Unknown, N> unknowns;
  std::array<double, N> parameters{}, standard_errors{};
  /// Symmetric about a parameter, or if that is positive about its logarithm.
  std::array<Interval, N> intervals{};
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();
  std::vector<double> residuals{};
  std::size_t degrees_of_freedom = 0;  ///< number of data less number of parameters
  std::size_t evaluations = 0, iterations = 0;
  FitEnd end = FitEnd::converged;

  double residual_norm() const {
    return Eigen::Map<const Eigen::VectorXd>(residuals.data(), Eigen::Index(residuals.size())).norm();
  }
  /// The scatter of the data about the model that the residuals show.
  double standard_deviation() const { return residual_norm() / std::sqrt(static_cast<double>(degrees_of_freedom)); }
  /// Correlation of two parameters: at -1 or 1 the data determine only a combination of both.
  double correlation(std::size_t i, std::size_t j) const {
    const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
    return covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
  }
};

namespace detail {
using namespace strike::detail;

/// The residuals and their slopes in the form of Eigen's Levenberg-Marquardt, in variables x of order one that are 1
/// at the start: x - 1 = ln(p/start) of a positive parameter, else p/start - 1.
template <std::size_t N>
class FitFunctor : public Eigen::DenseFunctor<double> {
 public:
  using Number = Dual<double, N>;
  using Residuals = std::function<std::vector<Number>(const std::array<Number, N>&)>;
  using Vector = Eigen::VectorXd;

  FitFunctor(Residuals residuals, std::span<const Unknown, N> unknowns)
      : residuals_(std::move(residuals)), unknowns_(unknowns), x_(Vector::Ones(N)) {
    for (const Unknown& unknown : unknowns_) check_ranges(unknown, joined({" '", unknown.name, "'"}));
    evaluate();
  }

  int inputs() const { return static_cast<int>(N); }
  int values() const { return static_cast<int>(r_.size()); }
  int operator()(const Vector& x, Vector& r) {
    if (x != x_) {
      x_ = x;
      evaluate();
    }
    for (std::size_t i = 0; i < r_.size(); ++i) r[static_cast<Eigen::Index>(i)] = r_[i].value();
    return 0;
  }
  int df(const Vector& x, JacobianType& J) {
    Vector r(values());
    operator()(x, r);
    for (std::size_t i = 0; i < r_.size(); ++i)
      for (std::size_t k = 0; k < N; ++k)
        J(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = r_[i].derivative(k);
    return 0;
  }

  /// The parameters, with their derivatives by x.
  std::array<Number, N> parameters() const {
    std::array<Number, N> p;
    for (std::size_t k = 0; k < N; ++k) {
      const Number x = Number::variable(x_[static_cast<Eigen::Index>(k)], k);
      p[k] = unknowns_[k].start * (unknowns_[k].sign == Sign::positive ? exp(x - 1.0) : x);
    }
    return p;
  }
  std::size_t evaluations() const { return evaluations_; }

 private:
  void evaluate() {
    const std::array<Number, N> p = parameters();
    const std::size_t before = r_.size();
    r_ = residuals_(p);
    ++evaluations_;
    const auto at = [&] {
      std::string list;
      for (std::size_t k = 0; k < N; ++k)
        list += joined({k > 0 ? ", " : "", unknowns_[k].name, " = ", text(p[k].value())});
      return list;
    };
    if (r_.size() <= N)
      throw Error(joined({"strike: ", std::to_string(r_.size()), " residuals do not determine ", std::to_string(N),
                          " parameters and their scatter; measure more or fit fewer."}));
    if (evaluations_ > 1 && r_.size() != before)
      throw Error(joined({"strike: the residuals were ", std::to_string(before), " and at ", at(), " are ",
                          std::to_string(r_.size()), "; return as many for all parameters."}));
    for (std::size_t i = 0; i < r_.size(); ++i) {
      bool finite = std::isfinite(r_[i].value());
      for (std::size_t k = 0; k < N; ++k) finite = finite && std::isfinite(r_[i].derivative(k));
      if (!finite)
        throw Error(joined({"strike: residual ", std::to_string(i), " or a derivative of it is not finite at ", at(),
                            "; begin nearer to the data or look for what is wrong in the model there."}));
    }
  }

  Residuals residuals_;
  std::span<const Unknown, N> unknowns_;
  Vector x_;
  std::vector<Number> r_;
  std::size_t evaluations_ = 0;
};

/// Error: slopes that leave a parameter, or a combination of some, undetermined.
template <std::size_t N>
void check_determined(const Eigen::MatrixXd& J, std::span<const Unknown, N> unknowns) {
  constexpr double least = 1e-8;  // the accuracy of derivatives
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinV);
  const Eigen::VectorXd& slopes = svd.singularValues();
  const auto last = static_cast<Eigen::Index>(N) - 1;
  if (slopes[last] > least * slopes[0]) return;
  std::string names;
  for (std::size_t k = 0; k < N; ++k)
    if (std::abs(svd.matrixV()(static_cast<Eigen::Index>(k), last)) > 0.1)
      names += joined({names.empty() ? "'" : " apart from '", unknowns[k].name, "'"});
  throw Error(joined({"strike: the data do not determine ", names, ": the residuals keep only ",
                      text(slopes[0] > 0 ? slopes[last] / slopes[0] : 0.0),
                      " of their largest slope along it; fix its value or measure what depends on it."}));
}

}  // namespace detail

/// Fits N parameters to data: the least sum of squares of residuals, by Levenberg and Marquardt (More 1978, MINPACK, as
/// in Eigen) with derivatives by dual numbers. `residuals(p)` gets the parameters as `std::array<Dual<double, N>, N>`
/// and returns a `std::vector<Dual<double, N>>`, for each datum the model less the measurement, in units of its
/// scatter, so that all have the same weight.
///   const auto fitted = fit(residuals, {{"yield stress", 0.3}, {"hardening modulus", 0.2}});
/// The covariance is that of the linearised model, s^2 (J^T J)^-1 with s^2 = |r|^2/(data - N), and the intervals are
/// Student's (Seber and Wild, Nonlinear Regression, 1989, section 2.1). Errors: no more data than parameters; a
/// residual that is not finite; parameters that the data do not determine.
template <std::size_t N, class Residuals>
Fit<N> fit(const Residuals& residuals, const Unknown (&unknowns)[N], const FitOptions& options = {}) {
  detail::check_ranges(options);
  detail::FitFunctor<N> functor(residuals, unknowns);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(N);
  Eigen::LevenbergMarquardt<detail::FitFunctor<N>> search(functor);
  search.setFtol(options.tolerance);
  search.setXtol(options.tolerance);
  search.setMaxfev(static_cast<Eigen::Index>(options.evaluations));
  search.setExternalScaling(true);  // the variables have scales
  search.diag() = Eigen::VectorXd::Ones(N);
  search.setFactor(0.5);  // the first step changes a parameter by half an e-folding at most
  const auto status = search.minimize(x);

  Eigen::VectorXd r(functor.values());
  Eigen::MatrixXd J(functor.values(), functor.inputs());
  functor(x, r);
  functor.df(x, J);
  detail::check_determined<N>(J, unknowns);

  Fit<N> result{.unknowns = std::to_array(unknowns)};
  result.residuals.assign(r.begin(), r.end());
  result.degrees_of_freedom = result.residuals.size() - N;
  result.evaluations = functor.evaluations();
  result.iterations = static_cast<std::size_t>(search.iterations());
  result.end =
      status == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation ? FitEnd::evaluations : FitEnd::converged;

  const double s = result.standard_deviation(), t = student_t_quantile(options.confidence, result.degrees_of_freedom);
  const Eigen::Matrix<double, N, N> of_x = s * s * (J.transpose() * J).inverse();
  const auto p = functor.parameters();
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      result.covariance(a, b) = p[i].derivative(i) * of_x(a, b) * p[j].derivative(j);
    }
    const double value = p[i].value(),
                 error = std::sqrt(result.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)));
    result.parameters[i] = value;
    result.standard_errors[i] = error;
    if (unknowns[i].sign == Sign::positive)
      result.intervals[i] = {value * std::exp(-t * error / value), value * std::exp(t * error / value)};
    else
      result.intervals[i] = {value - t * error, value + t * error};
  }
  return result;
}

}  // namespace strike::calibrate
