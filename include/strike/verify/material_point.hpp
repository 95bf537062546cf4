#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <strike/dynamics/method.hpp>
#include <strike/element/element.hpp>
#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/output/history.hpp>
#include <strike/range.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/verify/path.hpp>

namespace strike::verify {

/// A material point at one time.
template <class M, class T = double>
struct Record {
  double time = 0;
  Matrix3<T> deformation_gradient = Matrix3<T>::Identity();  ///< F
  SymmetricTensor<T> rate_of_deformation{};                  ///< D in the middle of the step that led here
  SymmetricTensor<T> stress{};                               ///< Cauchy
  T work{};                                                  ///< of the stress, per reference volume
  typename M::template State<T> state{};                     ///< state of the material

  T relative_volume() const { return deformation_gradient.determinant(); }
  /// Logarithmic strain of Hencky, ln V with F = V R.
  SymmetricTensor<double> strain() const {
    const Matrix3<double> F = deformation_gradient.template cast<double>();
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> V2(F * F.transpose());
    const Vector3<double> half_log = 0.5 * V2.eigenvalues().array().log();
    return symmetric_part<double>(V2.eigenvectors() * half_log.asDiagonal() * V2.eigenvectors().transpose());
  }
};

/// One material point without a mesh, to verify a law: strain or stress is prescribed component by component; the
/// result is the history. The kinematics are those of the elements at mid-step, and `rotation` turns the state.
///   MaterialPoint point{copper};
///   const auto history = point.run(cyclic(uniaxial_stress({.strain = 0.02, .rate = 1e3}), 3));
///   write("curve.csv", history);
/// In dual numbers (`MaterialPoint{copper, in<Dual<double, 2>>}`) the history has derivatives.
/// A material in plane stress is in the frame of its plate, without spin; the strain across the plate follows from the
/// law. Errors: a prescribed stress that the material does not reach; a step that turns the point inside out. The point
/// then has its state of before the step.
template <class M, Rotation R = HughesWinget, class T = double>
  requires(SolidMaterial<M> || PlaneMaterial<M>)
class MaterialPoint {
 public:
  explicit MaterialPoint(M material, R rotation = {}, In<T> = {})
      : material_(std::move(material)), rotation_(std::move(rotation)) {
    detail::check_ranges(material_);
    if constexpr (requires { material_.begin(now_.state); }) material_.begin(now_.state);
    now_.stress = in_space(material_.stress(std::as_const(now_.state)));
  }

  MaterialPoint(M material, In<T> number) : MaterialPoint(std::move(material), R{}, number) {}

  const M& material() const { return material_; }
  const Record<M, T>& now() const { return now_; }
  typename M::Kinematics::template Moduli<T> moduli() const {
    if constexpr (is_plane)
      return material_.moduli(now_.state, {in_plane(now_.rate_of_deformation)});
    else
      return material_.moduli(now_.state, {now_.rate_of_deformation, now_.relative_volume()});
  }

  /// One step with the velocity gradient L in its middle. A component with a prescribed stress reaches it; L holds the
  /// first guess of its rate.
  const Record<M, T>& step(const Matrix3<T>& L, double dt, const PrescribedStress& stress = {}) {
    Target target;
    for (std::size_t c = 0; c < 6; ++c) target[c] = stress.*prescribed[c];
    return advance(symmetric_part(L), spin(L), dt, target);
  }

  /// One step to the deformation gradient F: L dt = 2 (F - F_old) (F + F_old)^-1.
  const Record<M, T>& deform(const Matrix3<T>& F, double dt) {
    const Matrix3<T>& F_old = now_.deformation_gradient;
    return step((2 / dt) * (F - F_old) * (F + F_old).inverse(), dt);
  }

  /// Follows the path and returns the record of every step, the present one first.
  std::vector<Record<M, T>> run(const Path& path) {
    std::vector<Record<M, T>> history{now_};
    run(path, [&](const Record<M, T>& record) { history.push_back(record); });
    return history;
  }

  /// Follows the path and calls observe(record) after each step.
  template <class Observer>
  void run(const Path& path, Observer&& observe) {
    for (const Segment& segment : path.segments) {
      detail::check_ranges(segment);
      const Tensor initial_stress = now_.stress;
      const double dt = segment.duration / static_cast<double>(segment.steps);
      const Matrix3<T> L = segment.velocity_gradient.template cast<T>();
      Tensor D = symmetric_part(L);
      for (std::size_t i = 1; i <= segment.steps; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(segment.steps);
        Target target;
        for (std::size_t c = 0; c < 6; ++c)
          target[c] =
              initial_stress.*component[c] + part * (segment.stress.*prescribed[c] - initial_stress.*component[c]);
        advance(D, spin(L), dt, target);
        D = now_.rate_of_deformation;
        observe(now_);
      }
    }
  }

 private:
  using Tensor = SymmetricTensor<T>;
  using Target = std::array<T, 6>;  ///< stresses that are prescribed, or NaN
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  static constexpr std::array component{&Tensor::xx, &Tensor::yy, &Tensor::zz, &Tensor::xy, &Tensor::yz, &Tensor::zx};
  static constexpr std::array prescribed{&PrescribedStress::xx, &PrescribedStress::yy, &PrescribedStress::zz,
                                         &PrescribedStress::xy, &PrescribedStress::yz, &PrescribedStress::zx};
  static constexpr std::array name{"xx", "yy", "zz", "xy", "yz", "zx"};
  static constexpr bool is_plane = PlaneMaterial<M>;
  static Tensor in_space(const Tensor& a) { return a; }
  static Tensor in_space(const PlaneTensor<T>& a) { return {.xx = a.xx, .yy = a.yy, .xy = a.xy}; }
  static PlaneTensor<T> in_plane(const Tensor& a) { return {a.xx, a.yy, a.xy}; }
  static Vector3<T> spin(const Matrix3<T>& L) { return is_plane ? Vector3<T>(Vector3<T>::Zero()) : axial_vector(L); }
  static bool is_given(const T& stress) { return stress == stress; }

  /// Record after a step with this rate of deformation and the axial vector w of the spin.
  Record<M, T> answer(const Tensor& rate_of_deformation, const Vector3<T>& w, double dt) const {
    Record<M, T> next = now_;
    next.time += dt;
    Tensor D = rate_of_deformation;
    if constexpr (is_plane) {
      const PlaneStressKinematics::Rate<T> rate{in_plane(D)};
      next.stress = in_space(material_.stress(next.state, rate, dt));
      D = in_space(rate.rate_of_deformation);
      D.zz = material_.normal_rate(next.state, rate, dt, in_plane(next.stress - now_.stress));
    }
    next.rate_of_deformation = D;
    Matrix3<T> W;
    W << T(0.0), -w(2), w(1), w(2), T(0.0), -w(0), -w(1), w(0), T(0.0);
    const Matrix3<T> h = 0.5 * dt * (D.matrix() + W), I = Matrix3<T>::Identity();
    next.deformation_gradient = (I - h).inverse() * (I + h) * now_.deformation_gradient;
    const T J = next.relative_volume(), J_mid = J - 0.5 * volume_increment<T>(J, dt * trace(D));

    const auto turn = rotation_.turn(Vector3<T>(dt * w));
    turn_tensors(turn, next.state);
    const Tensor before = turn(now_.stress);
    const Tensor D_end = rotation_.turn(Vector3<T>(0.5 * dt * w))(D);  // half the spin is still to come
    if constexpr (!is_plane) next.stress = material_.stress(next.state, {D_end, J}, dt);
    next.work += J_mid * dt * 0.5 * double_dot(before + next.stress, D_end);
    return next;
  }

  const Record<M, T>& advance(const Tensor& D, const Vector3<T>& w, double dt, const Target& target) {
    Record<M, T> next = answer(D, w, dt);
    if (std::any_of(target.begin(), target.end(), is_given)) next = reach(target, std::move(next), w, dt);
    if (!(next.relative_volume() > 0))
      throw Error(detail::joined({"strike: the material point at t = ", detail::text(next.time),
                                  ": the relative volume becomes ",
                                  detail::text(static_cast<double>(next.relative_volume())), "; take smaller steps."}));
    return now_ = std::move(next);
  }

  /// Newton's method for the rates of the components with a prescribed stress, from the guess `next`. Unknowns are
  /// strain increments; residuals are stresses over the wave modulus. The tangent is a difference quotient, so that the
  /// law needs no dual numbers; where it is singular, as in the shear of a fluid, the rates that it leaves open stay as
  /// they are.
  Record<M, T> reach(const Target& target, Record<M, T> next, const Vector3<T>& w, double dt) const {
    constexpr double rounding = std::numeric_limits<double>::epsilon(), tolerance = 64 * rounding;
    const double difference = std::sqrt(rounding);  // balances the rounding of the volume and the curvature

    double modulus = static_cast<double>(moduli().wave());
    for (const T& stress : target)
      if (is_given(stress)) modulus = std::max(modulus, std::abs(static_cast<double>(stress)));
    const auto error = [&](const Record<M, T>& record, std::size_t c) -> T {
      if (!is_given(target[c])) return T(0.0);
      return (record.stress.*component[c] - target[c]) / modulus;
    };
    const auto residual = [&](const Record<M, T>& record) {
      Vector6 r = Vector6::Zero();
      for (std::size_t c = 0; c < 6; ++c)
        if (is_given(target[c]) && record.stress.*component[c] != target[c])
          r[static_cast<int>(c)] = static_cast<double>(error(record, c));
      return r;
    };
    const auto changed = [&](const Record<M, T>& record, const auto& strain) {
      Tensor D = record.rate_of_deformation;
      for (std::size_t c = 0; c < 6; ++c)
        if (is_given(target[c])) D.*component[c] += strain[static_cast<int>(c)] / dt;
      return answer(D, w, dt);
    };
    const auto tangent = [&](const Record<M, T>& record, const Vector6& r) {
      Matrix6 columns;
      for (int c = 0; c < 6; ++c)
        columns.col(c) = (residual(changed(record, Vector6(difference * Vector6::Unit(c)))) - r) / difference;
      Eigen::FullPivLU<Matrix6> lu(columns);
      lu.setThreshold(100 * difference);
      return lu;
    };

    Vector6 r = residual(next);
    for (int i = 0; i < 50 && !(r.norm() <= tolerance); ++i) {
      Vector6 strain = tangent(next, r).solve(-r);
      strain *= std::min(1.0, 0.5 / strain.template lpNorm<Eigen::Infinity>());

      Record<M, T> trial = changed(next, strain);
      for (int halving = 0; halving < 20 && !(residual(trial).norm() < r.norm()); ++halving)
        trial = changed(next, strain *= 0.5);
      next = std::move(trial);
      r = residual(next);
    }
    if (!(r.norm() <= tolerance)) refuse(target, next, r);

    if constexpr (requires(T a) { a.derivative(0); }) {
      // The derivatives are those of the implicit function; the second step removes the error of the difference
      // quotients.
      const Eigen::FullPivLU<Matrix6> lu = tangent(next, r);
      for (int i = 0; i < 2; ++i) {
        Eigen::Matrix<double, 6, static_cast<int>(T::variables())> slopes;
        for (int c = 0; c < 6; ++c)
          for (int k = 0; k < slopes.cols(); ++k)
            slopes(c, k) = error(next, static_cast<std::size_t>(c)).derivative(static_cast<std::size_t>(k));
        slopes = lu.solve(-slopes).eval();
        Eigen::Matrix<T, 6, 1> strain;
        for (int c = 0; c < 6; ++c) {
          std::array<double, T::variables()> derivatives;
          for (int k = 0; k < slopes.cols(); ++k) derivatives[static_cast<std::size_t>(k)] = slopes(c, k);
          strain[c] = T(0.0, derivatives);
        }
        next = changed(next, strain);
      }
    }
    return next;
  }

  [[noreturn]] void refuse(const Target& target, const Record<M, T>& nearest, const Vector6& r) const {
    int worst = 0;
    r.cwiseAbs().maxCoeff(&worst);
    const auto c = static_cast<std::size_t>(worst);
    throw Error(detail::joined({"strike: the material point at t = ", detail::text(nearest.time),
                                ": the prescribed stress ", name[c], " = ",
                                detail::text(static_cast<double>(target[c])), " is beyond the material, which gives ",
                                detail::text(static_cast<double>(nearest.stress.*component[c])),
                                "; lower it or prescribe the strain instead."}));
  }

  M material_;
  R rotation_;
  Record<M, T> now_;
};

template <class M>
MaterialPoint(M) -> MaterialPoint<M>;
template <class M, class R>
MaterialPoint(M, R) -> MaterialPoint<M, R>;
template <class M, class T>
MaterialPoint(M, In<T>) -> MaterialPoint<M, HughesWinget, T>;
template <class M, class R, class T>
MaterialPoint(M, R, In<T>) -> MaterialPoint<M, R, T>;

/// The value f(record) of every record, for a chart.
template <class M, class F>
std::vector<double> values(const std::vector<Record<M>>& history, F f) {
  std::vector<double> all;
  all.reserve(history.size());
  for (const Record<M>& record : history) all.push_back(f(record));
  return all;
}

/// Writes the records as CSV: time, logarithmic strain, Cauchy stress, its von Mises equivalent, relative volume, work
/// per reference volume, and of the material's state the internal energy, plastic strain, temperature rise and
/// intactness, where it has them.
template <class M>
void write(const std::string& path, const std::vector<Record<M>>& history) {
  using State = typename M::template State<double>;
  constexpr bool energy = requires(State s) { s.internal_energy; };
  constexpr bool plastic = requires(State s) { s.equivalent_plastic_strain; };
  constexpr bool thermal = requires(State s) { s.temperature_rise; };
  constexpr bool failing = requires(State s) { s.intact; };

  std::vector<Column> columns{{"time"}};
  for (const char* quantity : {"strain", "stress"})
    for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
      columns.push_back({detail::joined({quantity, " ", component})});
  for (const char* quantity : {"equivalent stress", "relative volume", "work"}) columns.push_back({quantity});
  if (energy) columns.push_back({"internal energy"});
  if (plastic) columns.push_back({"equivalent plastic strain"});
  if (thermal) columns.push_back({"temperature rise"});
  if (failing) columns.push_back({"intact"});

  History file(path, columns);
  for (const Record<M>& r : history) {
    const SymmetricTensor<double> e = r.strain(), &s = r.stress;
    std::vector<double> row{r.time, e.xx, e.yy, e.zz, e.xy, e.yz, e.zx, s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
    row.insert(row.end(), {equivalent_stress(deviator(s)), r.relative_volume(), r.work});
    if constexpr (energy) row.push_back(r.state.internal_energy);
    if constexpr (plastic) row.push_back(r.state.equivalent_plastic_strain);
    if constexpr (thermal) row.push_back(r.state.temperature_rise);
    if constexpr (failing) row.push_back(r.state.intact);
    file.row(row);
  }
}

}  // namespace strike::verify
