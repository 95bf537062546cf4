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

using namespace strike::verify;

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

/// The components of a tensor in space or in a plane.
template <class Tensor>
constexpr auto components() {
  if constexpr (requires(Tensor a) { a.zz; })
    return std::array{&Tensor::xx, &Tensor::yy, &Tensor::zz, &Tensor::xy, &Tensor::yz, &Tensor::zx};
  else
    return std::array{&Tensor::xx, &Tensor::yy, &Tensor::xy};
}
template <class Tensor>
inline constexpr auto component = components<Tensor>();

/// Stress and strain are tensors of one kind.
template <class M, class T = double>
using Tensor = typename M::Kinematics::template Stress<T>;

template <class M, class T>
struct Point {
  const M& material;
  typename M::template State<T> state{};
  T J = T(1.0);
  Tensor<M, T> stress{};

  explicit Point(const M& m) : material(m) {
    if constexpr (requires { material.begin(state); }) material.begin(state);
    stress = material.stress(std::as_const(state));
  }
  /// The rate that a strain increment e and a volume J make.
  static auto rate(const Tensor<M, T>& e, const T& J, double dt) {
    typename M::Kinematics::template Rate<T> rate{T(1 / dt) * e};
    if constexpr (SolidMaterial<M>) rate.relative_volume = J;
    return rate;
  }
  /// A step of the strain increment e, as mid-step kinematics has it.
  void step(const Tensor<M, T>& e, double dt) {
    if constexpr (SolidMaterial<M>) {
      const Matrix3<T> h = 0.5 * e.matrix(), I = Matrix3<T>::Identity();
      const auto det = [](const Matrix3<T>& A) -> T {
        return determinant(SymmetricTensor<T>{A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(1, 2), A(2, 0)});
      };
      J = J * (det(I + h) / det(I - h));
    }
    stress = material.stress(state, rate(e, J, dt), dt);
  }
  auto moduli() const { return material.moduli(state, rate({}, J, 1)); }
};

/// Strain increments that wander and come back now and then; the trace stays small, so that gases live too.
template <class M>
std::vector<Tensor<M>> wander(const Drive& drive, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Tensor<M>> path(drive.steps);
  Tensor<M> trend{};
  for (std::size_t i = 0; i < drive.steps; ++i) {
    if (i % 10 == 0)
      for (const auto c : component<Tensor<M>>) trend.*c = unit(random);
    for (const auto c : component<Tensor<M>>) path[i].*c = drive.strain * (0.7 * trend.*c + 0.3 * unit(random));
  }
  return path;
}

template <class A>
double norm(const A& a) {
  return std::sqrt(double_dot(a, a));
}

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
  for (const auto& e : wander<M>(drive, 1)) {
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
  for (const auto& e : detail::wander<M>(drive, 2)) point.step(e, drive.dt);
  rest();
}

/// Lane i of a pack gives what a double gives: to the rounding of the pack's numbers, which the modulus multiplies
/// because the volume is rounded too, and which the steps add up.
template <class P, class M>
void lanes_agree(const M& material, const Drive& drive) {
  const double rounding = std::numeric_limits<RealOf<P>>::epsilon() * detail::stress_scale(material, drive);
  detail::Point<M, P> pack(material);
  std::vector<detail::Point<M, double>> alone(lanes<P>, detail::Point<M, double>(material));
  std::vector<std::vector<detail::Tensor<M>>> paths;
  for (unsigned l = 0; l < lanes<P>; ++l) paths.push_back(detail::wander<M>(drive, 3 + l));
  for (std::size_t i = 0; i < drive.steps; ++i) {
    constexpr auto in_pack = detail::component<detail::Tensor<M, P>>;
    constexpr auto in_double = detail::component<detail::Tensor<M>>;
    detail::Tensor<M, P> strains{};
    for (std::size_t c = 0; c < in_pack.size(); ++c)
      strains.*in_pack[c] = P::generate([&](std::size_t l) { return l == 0 ? 0.0 : paths[l][i].*in_double[c]; });
    pack.step(strains, drive.dt);  // lane 0 stays at rest
    for (std::size_t l = 0; l < lanes<P>; ++l) {
      alone[l].step(l == 0 ? detail::Tensor<M>{} : paths[l][i], drive.dt);
      detail::Tensor<M> in_lane{};
      for (std::size_t c = 0; c < in_pack.size(); ++c)
        in_lane.*in_double[c] = static_cast<double>(lane(pack.stress.*in_pack[c], l));
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
      return Matrix3<double>(Matrix3<double>::NullaryExpr([&] { return amplitude * unit(random); }));
    };
    const std::array corners{corner(), corner(), Matrix3<double>(Matrix3<double>::Zero())};
    MaterialPoint point{material};
    double turnover = 0;
    Matrix3<double> begin = Matrix3<double>::Zero();
    for (const auto& end : corners) {
      for (int i = 1; i <= 50; ++i) {
        const double before = point.now().work;
        if constexpr (SolidMaterial<M>)
          point.deform(Matrix3<double>::Identity() + begin + i / 50. * (end - begin), drive.dt);
        else
          point.step((1 / (50 * drive.dt)) * (end - begin), drive.dt);
        turnover += std::abs(point.now().work - before);
      }
      begin = end;
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
  for (const auto& e : detail::wander<M>(drive, 6)) {
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
  constexpr auto component = detail::component<detail::Tensor<M>>;
  constexpr std::size_t n_strains = component.size();
  using D = Dual<double, n_strains>;
  constexpr auto dual_component = detail::component<detail::Tensor<M, D>>;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto path = detail::wander<M>(drive, 8);
  for (std::size_t steps = 1; steps <= path.size(); steps += 3) {
    detail::Point<M, D> point(material);
    for (std::size_t i = 0; i < steps; ++i) {
      const bool last = i + 1 == steps;
      detail::Tensor<M, D> e{};
      for (std::size_t c = 0; c < n_strains; ++c)
        e.*dual_component[c] = last ? D::variable(path[i].*component[c], c) : D(path[i].*component[c]);
      point.step(e, drive.dt);
    }
    double stress = 0;
    for (std::size_t c = 0; c < n_strains; ++c)
      stress = std::max(stress, std::abs((point.stress.*dual_component[c]).value()));
    const double bound = point.moduli().wave().value() + 2 * detail::viscosity(material) / drive.dt;
    for (int i = 0; i < 20; ++i) {
      Vector3<double> n = Vector3<double>::NullaryExpr([&] { return unit(random); });
      if constexpr (!SolidMaterial<M>) n(2) = 0;
      n.normalize();
      detail::Tensor<M> nn{}, change{};
      if constexpr (SolidMaterial<M>)
        nn = {n(0) * n(0), n(1) * n(1), n(2) * n(2), n(0) * n(1), n(1) * n(2), n(2) * n(0)};
      else
        nn = {n(0) * n(0), n(1) * n(1), n(0) * n(1)};
      for (std::size_t c = 0; c < n_strains; ++c)
        for (std::size_t k = 0; k < n_strains; ++k)
          change.*component[c] += (point.stress.*dual_component[c]).derivative(k) * nn.*component[k];
      detail::at_most(double_dot(nn, change), bound * (1 + 4 * drive.strain) + 4 * stress,
                      "the moduli bound the tangent", steps);
    }
  }
}

/// The rate across: none at rest, and in every step the volume changes by no more than what the change of the stress
/// presses together; lane i gives what a double gives.
template <PlaneMaterial M>
void knows_its_thickness(const M& material, const Drive& drive) {
  using P = Pack<double, 4>;
  detail::Point<M, double> point(material);
  detail::Point<M, P> pack(material);
  const auto strain_across = [&]<class T>(detail::Point<M, T>& p, const detail::Tensor<M, T>& e) -> T {
    const auto before = p.stress;
    p.step(e, drive.dt);
    return drive.dt * material.normal_rate(p.state, p.rate(e, p.J, drive.dt), drive.dt, p.stress - before);
  };
  detail::at_most(std::abs(strain_across(point, {})), 1e-15, "at rest the thickness stays", 0);
  strain_across(pack, {});
  std::size_t steps = 0;
  for (const auto& e : detail::wander<M>(drive, 10)) {
    ++steps;
    const auto before = point.stress;
    const double across = strain_across(point, e);
    const double pressed = std::abs(trace(point.stress - before)) / point.moduli().normal;  // 3 K >= E/(1 - nu^2)
    if constexpr (!requires { material.plane_stiffness(); })  // the volume of fibres follows from more than the trace
      detail::at_most(std::abs(trace(e) + across), pressed * (1 + 10 * drive.strain) + 4 * drive.strain * drive.strain,
                      "the volume follows from the stress", steps);
    const P in_lanes = strain_across(pack, {P(e.xx), P(e.yy), P(e.xy)});
    detail::at_most(std::abs(in_lanes[3] - across), 1e-15 * double(steps), "a lane gives what a double gives", steps);
  }
}

/// What has failed carries nothing, for ever.
template <class M>
void stays_failed(const M& material, const Drive& drive) {
  if constexpr (requires(typename M::template State<double> state) { material.intact(state); }) {
    detail::Point<M, double> point(material);
    bool failed = false;
    std::size_t i = 0;
    for (const auto& e : detail::wander<M>({.strain = 0.1, .dt = drive.dt, .steps = 400}, 9)) {
      if constexpr (SolidMaterial<M>)
        point.step(deviator(e), drive.dt);
      else
        point.step(e, drive.dt);
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
  const auto finite = [](const detail::Tensor<M, T>& a) {
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (const auto c : detail::component<detail::Tensor<M, T>>)
        if (!std::isfinite(lane(a.*c, l))) return false;
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
            detail::Tensor<M, T> rates{};
            if constexpr (SolidMaterial<M>)
              rates = {D, -D, 0.5 * D, D, -D, D};
            else
              rates = {D, -0.5 * D, D};
            const auto extreme = point.rate(T(dt) * rates, T(J), dt);
            const auto sigma = material.stress(point.state, extreme, dt);
            detail::holds(finite(sigma), "no NaN and no infinity in the stress", i);
            const T wave = material.moduli(point.state, extreme).wave();
            detail::holds(std::isfinite(lane(wave, 0)), "no NaN and no infinity in the moduli", i);
          }
        }
}

/// All laws.
template <class M>
  requires(SolidMaterial<M> || PlaneMaterial<M>)
void conforms(const M& material, const Drive& drive = {}) {
  detail::holds(density_of(material) > 0, "it has a density", 0);
  rests(material, drive);
  lanes_agree<Pack<double, 4>>(material, drive);
  lanes_agree<Pack<double, 8>>(material, drive);
  lanes_agree<Pack<float, 16>>(material, drive);
  gives_no_energy(material, drive);
  if constexpr (SolidMaterial<M>)
    is_frame_indifferent(material, drive);
  else
    knows_its_thickness(material, drive);
  bounds_its_tangent(material, drive);
  stays_failed(material, drive);
  bears_extremes<double>(material);
  bears_extremes<Pack<float, 16>>(material);
}

}  // namespace strike::testing
