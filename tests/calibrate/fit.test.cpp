#include <cmath>
#include <random>
#include <vector>

#include <strike/calibrate/fit.hpp>

#include "conformance/numbers.hpp"

using namespace strike;
using namespace strike::calibrate;
using Catch::Matchers::ContainsSubstring;

namespace {

/// y = a exp(-t/b) at ten times, with noise of a given standard deviation.
struct Decay {
  std::vector<double> times, values;

  explicit Decay(double noise = 0, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> scatter(0, 1);
    for (int i = 0; i < 10; ++i) {
      times.push_back(0.2 * i);
      values.push_back(2 * std::exp(-times.back() / 0.7) + noise * scatter(random));
    }
  }
  template <class Parameters>
  auto operator()(const Parameters& p) const {
    std::vector<typename Parameters::value_type> r;
    for (std::size_t i = 0; i < times.size(); ++i) r.push_back(p[0] * exp(-times[i] / p[1]) - values[i]);
    return r;
  }
};

}  // namespace

TEST_CASE("fit: quantiles of Student's t") {
  // Abramowitz and Stegun (1964), table 26.10, to its three decimals; t = tan(0.475 pi) for one degree of freedom
  CHECK(student_t_quantile(0.95, 1) == Approx(std::tan(0.475 * 3.14159265358979324)).epsilon(1e-13));
  CHECK(student_t_quantile(0.95, 2) == Approx(0.95 * std::sqrt(2 / (1 - 0.95 * 0.95))).epsilon(1e-13));
  for (const auto& [freedom, t] : {std::pair{3, 3.182}, {5, 2.571}, {10, 2.228}, {30, 2.042}, {120, 1.980}})
    CHECK(student_t_quantile(0.95, static_cast<std::size_t>(freedom)) == Approx(t).margin(5e-4));
  CHECK(student_t_quantile(0.99, 10) == Approx(3.169).margin(5e-4));
  CHECK(student_t_quantile(0.9, 4) == Approx(2.132).margin(5e-4));
}

TEST_CASE("fit: exact data give the parameters back") {
  const auto fitted = fit(Decay{}, {{"amplitude", 0.5}, {"time constant", 3}});
  CHECK(fitted.parameters[0] == Approx(2).epsilon(1e-12));
  CHECK(fitted.parameters[1] == Approx(0.7).epsilon(1e-12));
  CHECK(fitted.residual_norm() < 1e-12);
  CHECK(fitted.end == FitEnd::converged);
  CHECK(fitted.evaluations < 20);

  const auto line = fit(  // one that is negative, and linear: the covariance by hand
      [](const auto& p) {
        return std::vector{p[0] + p[1] + 1, p[0] - p[1], p[0] - 1.5};
      },
      {{"a", 1, Sign::any}, {"b", 1, Sign::any}});
  // mean 1.5 - 2 of (-1, 0, 1.5) with slopes (1, 1), (1, -1), (1, 0)
  CHECK(line.parameters[0] == Approx(0.5 / 3).epsilon(1e-9));
  CHECK(line.parameters[1] == Approx(-0.5).epsilon(1e-9));
  const double variance = line.residual_norm() * line.residual_norm();  // one degree of freedom
  CHECK(line.covariance(0, 0) == Approx(variance / 3).epsilon(1e-9));
  CHECK(line.covariance(1, 1) == Approx(variance / 2).epsilon(1e-9));
  CHECK(std::abs(line.correlation(0, 1)) < 1e-9);
  CHECK(line.intervals[1].upper + 0.5 == Approx(12.7062 * std::sqrt(variance / 2)).epsilon(1e-5));
}

TEST_CASE("fit: the intervals hold the truth as often as they say") {
  constexpr int repetitions = 400;
  int amplitude = 0, time_constant = 0;
  for (unsigned seed = 0; seed < repetitions; ++seed) {
    const auto fitted = fit(Decay{0.02, seed}, {{"amplitude", 1}, {"time constant", 1}});
    amplitude += fitted.intervals[0].contains(2);
    time_constant += fitted.intervals[1].contains(0.7);
  }
  // 380 of 400, with a binomial standard deviation of sqrt(400 0.95 0.05) = 4.4, three of which are allowed
  CHECK(std::abs(amplitude - 380) <= 13);
  CHECK(std::abs(time_constant - 380) <= 13);
}

TEST_CASE("fit: what cannot be fitted is one sentence") {
  const auto like = [](auto model) {
    return [=](const auto& p) {
      std::vector<std::decay_t<decltype(p[0])>> r;
      for (int i = 1; i < 5; ++i) r.push_back(model(p, i));
      return r;
    };
  };
  CHECK_THROWS_WITH(fit(like([](const auto& p, int i) { return p[0] * i - 1.0; }), {{"a", 1}, {"b", 2}}),
                    ContainsSubstring("do not determine 'b': "));
  CHECK_THROWS_WITH(fit(like([](const auto& p, int i) { return p[0] * p[1] * i - 1.0; }), {{"a", 1}, {"b", 2}}),
                    ContainsSubstring("do not determine 'a' apart from 'b': "));
  CHECK_THROWS_WITH(fit(like([](const auto& p, int i) { return log(p[0] - 3.5 + i); }), {{"a", 1}, {"b", 2}}),
                    ContainsSubstring("residual 0 or a derivative of it is not finite at a = 1, b = 2"));
  CHECK_THROWS_WITH(fit(
                        [](const auto& p) {
                          return std::vector{p[0], p[1]};
                        },
                        {{"a", 1}, {"b", 2}}),
                    ContainsSubstring("2 residuals do not determine 2 parameters"));
  CHECK_THROWS_WITH(fit(Decay{}, {{"a", 1}, {"b", -2}}),
                    ContainsSubstring("the start of Unknown 'b' is -2; it must be positive"));
}

TEST_CASE("conformance: wrong numbers of fits are refused") {
  testing::WrongNumbers tried;
  const auto fits = [](const Unknown& unknown, const FitOptions& options) {
    return std::isfinite(fit(Decay{0.02, 1}, {unknown, {"time constant", 1}}, options).intervals[0].upper);
  };
  testing::refuses_wrong_numbers(Unknown{"amplitude", 1}, tried,
                                 [&](const Unknown& unknown) { return fits(unknown, {}); });
  testing::refuses_wrong_numbers(FitOptions{}, tried, [&](const FitOptions& options) {
    return fits({"amplitude", 1}, options);
  });
  tried.print("fits");
}
