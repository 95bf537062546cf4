#pragma once
// The laws of the Material concept (strike/material/material.hpp) as one suite:
//   TEST_CASE("conformance: my law") { testing::conforms(my_material); }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <strike/material/material.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

namespace strike::testing {

/// The steps in which a material is driven: strains at which it does what it is made for.
struct Drive {
  double strain = 1e-3;  ///< largest component of a step
  double dt = 1e-6;      ///< [time]
  std::size_t steps = 40;
};

namespace detail {

// The checks of Catch stand here once and not in every template.
inline void at_most(double value, double bound, const char* law, std::size_t step) {
  CAPTURE(law, step);
  CHECK(value <= bound);  // NaN is refused
}
inline void holds(bool truth, const char* law, std::size_t step) {
  CAPTURE(law, step);
  CHECK(truth);
}

inline constexpr std::array component{&SymmetricTensor<double>::xx, &SymmetricTensor<double>::yy,
                                      &SymmetricTensor<double>::zz, &SymmetricTensor<double>::xy,
                                      &SymmetricTensor<double>::yz, &SymmetricTensor<double>::zx};

template <class M, class T>
struct Point {
  const M& material;
  typename M::template State<T> state{};
  T J = T(1.0);
  SymmetricTensor<T> stress{};

  explicit Point(const M& m) : material(m) {
    if constexpr (requires { material.begin(state); }) material.begin(state);
    stress = material.stress(std::as_const(state));
  }
  /// A step of the strain increment e, as mid-step kinematics has it.
  void step(const SymmetricTensor<T>& e, double dt) {
    const Matrix3<T> h = 0.5 * e.matrix(), I = Matrix3<T>::Identity();
    const auto det = [](const Matrix3<T>& A) -> T {
      return determinant(SymmetricTensor<T>{A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(1, 2), A(2, 0)});
    };
    J = J * (det(I + h) / det(I - h));
    stress = material.stress(state, {T(1 / dt) * e, J}, dt);
  }
  Moduli<T> moduli() const { return material.moduli(state, {{}, J}); }
};

/// Strain increments that wander and come back now and then; the trace stays small, so that gases live too.
inline std::vector<SymmetricTensor<double>> wander(const Drive& drive, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SymmetricTensor<double>> path(drive.steps);
  SymmetricTensor<double> trend{};
  for (std::size_t i = 0; i < drive.steps; ++i) {
    if (i % 10 == 0)
      for (const auto c : component) trend.*c = unit(random);
    for (const auto c : component) path[i].*c = drive.strain * (0.7 * trend.*c + 0.3 * unit(random));
  }
  return path;
}

inline double norm(const SymmetricTensor<double>& a) { return a.matrix().norm(); }

template <class M>
double viscosity(const M& material) {
  if constexpr (requires { material.viscosity(); })
    return material.viscosity();
  else
    return 0;
}

/// What stresses are measured by: the modulus, and what rates add to it in a step.
template <class M>
double stress_scale(const M& material, const Drive& drive) {
  Point<M, double> point(material);
  double scale = point.moduli().wave();
  for (const auto& e : wander(drive, 1)) {
    point.step(e, drive.dt);
    scale = std::max({scale, point.moduli().wave(), norm(point.stress)});
  }
  return scale + 2 * viscosity(material) / drive.dt;
}

}  // namespace detail

/// At rest the stress does not grow.
template <class M>
void rests(const M& material, const Drive& drive) {
  detail::Point<M, double> point(material);
  const double rounding = 1e-15 * detail::stress_scale(material, drive);
  const auto rest = [&] {
    for (std::size_t i = 0; i < 5; ++i) {
      const double before = detail::norm(point.stress);
      point.step({}, drive.dt);
      detail::at_most(detail::norm(point.stress), before + rounding, "at rest the stress does not grow", i);
    }
  };
  rest();
  for (const auto& e : detail::wander(drive, 2)) point.step(e, drive.dt);
  rest();
}

/// Lane i of a pack gives what a double gives: to the rounding of the pack's numbers, which the modulus multiplies
/// because the volume is rounded too, and which the steps add up.
template <class P, class M>
void lanes_agree(const M& material, const Drive& drive) {
  const double rounding = std::numeric_limits<RealOf<P>>::epsilon() * detail::stress_scale(material, drive);
  detail::Point<M, P> pack(material);
  std::vector<detail::Point<M, double>> alone(lanes<P>, detail::Point<M, double>(material));
  std::vector<std::vector<SymmetricTensor<double>>> paths;
  for (unsigned l = 0; l < lanes<P>; ++l) paths.push_back(detail::wander(drive, 3 + l));
  for (std::size_t i = 0; i < drive.steps; ++i) {
    const auto of_lanes = [&](auto c) {
      return P::generate([&](std::size_t l) { return l == 0 ? 0.0 : paths[l][i].*c; });  // lane 0 stays at rest
    };
    using S = SymmetricTensor<double>;
    pack.step(
        {of_lanes(&S::xx), of_lanes(&S::yy), of_lanes(&S::zz), of_lanes(&S::xy), of_lanes(&S::yz), of_lanes(&S::zx)},
        drive.dt);
    for (std::size_t l = 0; l < lanes<P>; ++l) {
      alone[l].step(l == 0 ? S{} : paths[l][i], drive.dt);
      const auto at = [&](const P& x) { return static_cast<double>(lane(x, l)); };
      const S in_lane{at(pack.stress.xx), at(pack.stress.yy), at(pack.stress.zz),
                      at(pack.stress.xy), at(pack.stress.yz), at(pack.stress.zx)};
      detail::at_most(detail::norm(in_lane - alone[l].stress), 16 * double(i + 1) * rounding,
                      "a lane gives what a double gives", i);
    }
  }
}

/// A closed cycle of strain gives no energy back. But for a small part: laws between rates are conservative to second
/// order in the strain only, and a step errs in the third.
template <class M>
void gives_no_energy(const M& material, const Drive& drive) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double amplitude = 10 * drive.strain;
  for (std::size_t loop = 0; loop < 10; ++loop) {
    const auto corner = [&] {
      Matrix3<double> F = Matrix3<double>::NullaryExpr([&] { return amplitude * unit(random); });
      return Matrix3<double>(Matrix3<double>::Identity() + F);
    };
    const std::array corners{corner(), corner(), Matrix3<double>(Matrix3<double>::Identity())};
    MaterialPoint point{material};
    double turnover = 0;
    for (const auto& end : corners) {
      const Matrix3<double> begin = point.now().deformation_gradient;
      for (int i = 1; i <= 50; ++i) {
        const double before = point.now().work;
        point.deform(begin + i / 50. * (end - begin), drive.dt);
        turnover += std::abs(point.now().work - before);
      }
    }
    detail::at_most(-point.now().work, 2 * amplitude * turnover, "a closed cycle gives no energy", loop);
  }
}

/// Frame indifference: rigid rotations between the steps turn the stress and change nothing else.
template <class M>
void is_frame_indifferent(const M& material, const Drive& drive) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double rounding = 1e-15 * detail::stress_scale(material, drive);
  MaterialPoint still{material};
  MaterialPoint turning{material};
  Matrix3<double> Q = Matrix3<double>::Identity();
  std::size_t steps = 0;
  for (const auto& e : detail::wander(drive, 6)) {
    const Vector3<double> axis = Vector3<double>::NullaryExpr([&] { return unit(random); }).normalized();
    const Matrix3<double> turn = Eigen::AngleAxisd(2 * unit(random), axis).toRotationMatrix();
    turning.deform(turn * turning.now().deformation_gradient, drive.dt);
    still.step(Matrix3<double>::Zero(), drive.dt);
    Q = turn * Q;

    const Matrix3<double> L = e.matrix() / drive.dt;
    still.step(L, drive.dt);
    turning.step(Q * L * Q.transpose(), drive.dt);
    ++steps;
    const Matrix3<double> expected = Q * still.now().stress.matrix() * Q.transpose();
    detail::at_most((turning.now().stress.matrix() - expected).norm(), 64 * double(steps) * rounding,
                    "a rotation turns the stress and no more", steps);
  }
}

/// rho c^2 + 2 viscosity/dt bounds the tangent n.(d sigma_n/d strain_n) in every direction n, which dual numbers give.
/// Moduli leave out terms of the order of the stress, and of the strain of the step.
template <class M>
void bounds_its_tangent(const M& material, const Drive& drive) {
  using D = Dual<double, 6>;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto path = detail::wander(drive, 8);
  for (std::size_t steps = 1; steps <= path.size(); steps += 3) {
    detail::Point<M, D> point(material);
    for (std::size_t i = 0; i < steps; ++i) {
      const bool last = i + 1 == steps;
      const auto of = [&](std::size_t c) {
        const double value = path[i].*detail::component[c];
        return last ? D::variable(value, c) : D(value);
      };
      point.step({of(0), of(1), of(2), of(3), of(4), of(5)}, drive.dt);
    }
    const SymmetricTensor<D>& s = point.stress;
    const double stress = std::max({std::abs(s.xx.value()), std::abs(s.yy.value()), std::abs(s.zz.value())});
    const double bound = point.moduli().wave().value() + 2 * detail::viscosity(material) / drive.dt;
    for (int i = 0; i < 20; ++i) {
      const Vector3<double> n = Vector3<double>::NullaryExpr([&] { return unit(random); }).normalized();
      const Vector3<D> n_dual(D(n(0)), D(n(1)), D(n(2)));
      const D normal_stress = quadratic_form(s, n_dual);
      const auto slope = [&](std::size_t c) { return normal_stress.derivative(c); };  // of a component and its mirror
      const double tangent = slope(0) * n(0) * n(0) + slope(1) * n(1) * n(1) + slope(2) * n(2) * n(2) +
                             slope(3) * n(0) * n(1) + slope(4) * n(1) * n(2) + slope(5) * n(2) * n(0);
      detail::at_most(tangent, bound * (1 + 4 * drive.strain) + 4 * stress, "the moduli bound the tangent", steps);
    }
  }
}

/// What has failed carries nothing, for ever.
template <class M>
void stays_failed(const M& material, const Drive& drive) {
  if constexpr (requires(typename M::template State<double> state) { material.intact(state); }) {
    detail::Point<M, double> point(material);
    bool failed = false;
    std::size_t i = 0;
    for (const auto& e : detail::wander({.strain = 0.1, .dt = drive.dt, .steps = 400}, 9)) {
      point.step(deviator(e), drive.dt);
      const double intact = material.intact(point.state);
      detail::holds(intact == 0 || (intact == 1 && !failed), "what has failed stays so", i);
      failed = intact == 0;
      if (failed) detail::at_most(detail::norm(point.stress), 0, "what has failed carries nothing", i);
      ++i;
    }
    detail::holds(failed, "strains of 0.1 a step break it", i);
  }
}

/// No NaN and no infinity from rates and volumes at the ends of what can be.
template <class T, class M>
void bears_extremes(const M& material) {
  const auto finite = [](const SymmetricTensor<T>& a) {
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (const T* x : {&a.xx, &a.yy, &a.zz, &a.xy, &a.yz, &a.zx})
        if (!std::isfinite(lane(*x, l))) return false;
    return true;
  };
  using Real = RealOf<T>;
  const double least = std::numeric_limits<Real>::denorm_min();
  for (const double rate : {0.0, least, 1e-30, 1.0, 1e12})
    for (const double strain : {1e-9, 1e-3, 0.5})
      for (const double J : {0.7, 1.0, 1.5, 100.0})
        for (const double sign : {-1.0, 1.0}) {
          const double dt = rate > 1e-12 ? strain / rate : 1;
          detail::Point<M, T> point(material);
          const T D = T(static_cast<Real>(sign * rate));
          for (std::size_t i = 0; i < 3; ++i) {
            const auto sigma = material.stress(point.state, {{D, -D, 0.5 * D, D, -D, D}, T(J)}, dt);
            detail::holds(finite(sigma), "no NaN and no infinity in the stress", i);
            const T wave = material.moduli(point.state, {{}, T(J)}).wave();
            detail::holds(std::isfinite(lane(wave, 0)), "no NaN and no infinity in the moduli", i);
          }
        }
}

/// All laws.
template <SolidMaterial M>
void conforms(const M& material, const Drive& drive = {}) {
  detail::holds(material.density() > 0, "it has a density", 0);
  rests(material, drive);
  lanes_agree<Pack<double, 4>>(material, drive);
  lanes_agree<Pack<double, 8>>(material, drive);
  lanes_agree<Pack<float, 16>>(material, drive);
  gives_no_energy(material, drive);
  is_frame_indifferent(material, drive);
  bounds_its_tangent(material, drive);
  stays_failed(material, drive);
  bears_extremes<double>(material);
  bears_extremes<Pack<float, 16>>(material);
}

}  // namespace strike::testing
