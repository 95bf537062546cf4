#pragma once
// The laws of the Material concept for the sections of plates, as one suite:
//   TEST_CASE("conformance: my section") { testing::conforms(my_section); }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <strike/material/material.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>

#include "conformance/material.hpp"

namespace strike::testing {

namespace detail {

/// What strains a section in a step: the membrane, the curvature per 2/thickness, the transverse shear.
using SectionStrain = std::array<double, 8>;

template <class M, class T>
struct SectionPoint {
  const M& section;
  typename M::template State<T> state{};
  PlateKinematics::Stress<T> stress{};
  T work{0.0};  ///< per area

  explicit SectionPoint(const M& s) : section(s) {
    if constexpr (requires { section.begin(state); }) section.begin(state);
    stress = section.stress(std::as_const(state));
  }
  static PlateKinematics::Rate<T> rate(const M& section, const std::array<T, 8>& e, double dt) {
    const T a = T(1 / dt), b = T(2 / (section.thickness() * dt));
    return {{a * e[0], a * e[1], a * e[2]}, {b * e[3], b * e[4], b * e[5]}, {a * e[6], a * e[7]}};
  }
  void step(const std::array<T, 8>& e, double dt) {
    const auto r = rate(section, e, dt);
    const auto before = stress;
    stress = section.stress(state, r, dt);
    work +=
        0.5 * dt *
        (double_dot(before.force + stress.force, r.membrane) + double_dot(before.moment + stress.moment, r.curvature) +
         (before.shear(0) + stress.shear(0)) * r.shear(0) + (before.shear(1) + stress.shear(1)) * r.shear(1));
  }
  PlateKinematics::Moduli<T> moduli() const { return section.moduli(state, PlateKinematics::Rate<T>{}); }
  /// All in units of N.
  std::array<T, 8> numbers() const {
    const T c = T(2 / section.thickness());
    return {stress.force.xx,      stress.force.yy,      stress.force.xy, c * stress.moment.xx,
            c * stress.moment.yy, c * stress.moment.xy, stress.shear(0), stress.shear(1)};
  }
};

inline std::vector<SectionStrain> section_wander(const Drive& drive, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SectionStrain> path(drive.steps);
  SectionStrain trend{};
  for (std::size_t i = 0; i < drive.steps; ++i)
    for (std::size_t c = 0; c < 8; ++c) {
      if (i % 10 == 0) trend[c] = unit(random);
      path[i][c] = drive.strain * (0.7 * trend[c] + 0.3 * unit(random));
    }
  return path;
}

inline double norm(const std::array<double, 8>& a) {
  double sum = 0;
  for (const double x : a) sum += x * x;
  return std::sqrt(sum);
}
template <class M>
double section_scale(const M& section) {
  const auto m = SectionPoint<M, double>(section).moduli();
  const double h = section.thickness();
  return std::max(
      {m.extension.normal, 2 / h * std::abs(m.coupling.normal), 4 / (h * h) * m.bending.normal, m.transverse_shear});
}

}  // namespace detail

/// At rest the resultants do not grow.
template <PlateSection M>
void rests(const M& section, const Drive& drive) {
  detail::SectionPoint<M, double> point(section);
  const double rounding = 1e-14 * detail::section_scale(section) * drive.strain;
  const auto rest = [&] {
    for (std::size_t i = 0; i < 5; ++i) {
      const double before = detail::norm(point.numbers());
      point.step({}, drive.dt);
      detail::at_most(detail::norm(point.numbers()), before + rounding, "at rest the resultants do not grow", i);
    }
  };
  rest();
  for (const auto& e : detail::section_wander(drive, 2)) point.step(e, drive.dt);
  rest();
}

/// Lane i of a pack gives what a double gives.
template <class P, PlateSection M>
void lanes_agree(const M& section, const Drive& drive) {
  const double rounding = std::numeric_limits<RealOf<P>>::epsilon() * detail::section_scale(section);
  detail::SectionPoint<M, P> pack(section);
  std::vector<detail::SectionPoint<M, double>> alone(lanes<P>, detail::SectionPoint<M, double>(section));
  std::vector<std::vector<detail::SectionStrain>> paths;
  for (unsigned l = 0; l < lanes<P>; ++l) paths.push_back(detail::section_wander(drive, 3 + l));
  for (std::size_t i = 0; i < drive.steps; ++i) {
    std::array<P, 8> e;
    for (std::size_t c = 0; c < 8; ++c)
      e[c] = P::generate([&](std::size_t l) { return l == 0 ? 0.0 : paths[l][i][c]; });  // lane 0 stays at rest
    pack.step(e, drive.dt);
    const auto numbers = pack.numbers();
    for (std::size_t l = 0; l < lanes<P>; ++l) {
      alone[l].step(l == 0 ? detail::SectionStrain{} : paths[l][i], drive.dt);
      std::array<double, 8> difference = alone[l].numbers();
      for (std::size_t c = 0; c < 8; ++c) difference[c] -= static_cast<double>(lane(numbers[c], l));
      detail::at_most(detail::norm(difference), 16 * double(i + 1) * rounding, "a lane gives what a double gives", i);
    }
  }
}

/// A closed cycle of strain gives no energy back, but for a part of the order of the strain (see the solids).
template <PlateSection M>
void gives_no_energy(const M& section, const Drive& drive) {
  for (unsigned loop = 0; loop < 10; ++loop) {
    const auto corners = detail::section_wander({.strain = drive.strain, .dt = drive.dt, .steps = 11}, 40 + loop);
    detail::SectionPoint<M, double> point(section);
    double turnover = 0;
    detail::SectionStrain last{};
    for (const auto& end : {corners[0], corners[10], detail::SectionStrain{}}) {
      for (int i = 0; i < 50; ++i) {
        detail::SectionStrain e;
        for (std::size_t c = 0; c < 8; ++c) e[c] = (end[c] - last[c]) / 50;
        const double before = point.work;
        point.step(e, drive.dt);
        turnover += std::abs(point.work - before);
      }
      last = end;
    }
    detail::at_most(-point.work, 2 * drive.strain * turnover, "a closed cycle gives no energy", loop);
  }
}

/// The moduli bound the tangent in every direction n, which dual numbers give: for the strains a n (x) n, the
/// curvatures b n (x) n and the shear c n.
template <PlateSection M>
void bounds_its_tangent(const M& section, const Drive& drive) {
  using D = Dual<double, 8>;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto path = detail::section_wander(drive, 8);
  const double h = section.thickness();
  for (std::size_t steps = 1; steps <= path.size(); steps += 3) {
    detail::SectionPoint<M, D> point(section);
    for (std::size_t i = 0; i < steps; ++i) {
      std::array<D, 8> e;
      for (std::size_t c = 0; c < 8; ++c) e[c] = i + 1 == steps ? D::variable(path[i][c], c) : D(path[i][c]);
      point.step(e, drive.dt);
    }
    const auto s = point.numbers();
    const auto m = point.moduli();
    for (int i = 0; i < 20; ++i) {
      const double phi = 3.2 * unit(random), x = std::cos(phi), y = std::sin(phi);
      const double a = unit(random), b = unit(random), c = unit(random);
      const std::array<double, 8> e{a * x * x, a * y * y, a * x * y, b * x * x, b * y * y, b * x * y, c * x, c * y};
      const std::array<double, 8> conjugate{e[0], e[1], 2 * e[2], e[3], e[4], 2 * e[5], e[6], e[7]};
      double tangent = 0;
      for (std::size_t j = 0; j < 8; ++j)
        for (std::size_t k = 0; k < 8; ++k) tangent += conjugate[j] * s[j].derivative(k) * e[k];
      const double bound = m.extension.normal.value() * a * a + 4 / h * m.coupling.normal.value() * a * b +
                           4 / (h * h) * m.bending.normal.value() * b * b + m.transverse_shear.value() * c * c;
      detail::at_most(tangent, bound * (1 + 4 * drive.strain) + 1e-10 * detail::section_scale(section),
                      "the moduli bound the tangent", steps);
    }
  }
}

/// What has failed carries nothing, for ever.
template <PlateSection M>
void stays_failed(const M& section, const Drive& drive) {
  if constexpr (requires(typename M::template State<double> state) { section.intact(state); }) {
    detail::SectionPoint<M, double> point(section);
    bool failed = false;
    std::size_t i = 0;
    for (const auto& e : detail::section_wander({.strain = 0.1, .dt = drive.dt, .steps = 400}, 9)) {
      point.step(e, drive.dt);
      const double intact = section.intact(point.state);
      detail::holds(intact == 0 || (intact == 1 && !failed), "what has failed stays so", i);
      failed = intact == 0;
      if (failed) detail::at_most(detail::norm(point.numbers()), 0, "what has failed carries nothing", i);
      ++i;
    }
    detail::holds(failed, "strains of 0.1 a step break it", i);
  }
}

/// No NaN and no infinity.
template <class T, PlateSection M>
void bears_extremes(const M& section) {
  for (const double strain : {0.0, 1e-30, 1e-9, 1e-3, 0.5})
    for (const double dt : {1e-12, 1.0, 1e12}) {
      detail::SectionPoint<M, T> point(section);
      std::array<T, 8> e;
      for (std::size_t c = 0; c < 8; ++c) e[c] = T(c % 3 == 0 ? -strain : strain);
      for (std::size_t i = 0; i < 3; ++i) {
        point.step(e, dt);
        for (const T& x : point.numbers())
          detail::holds(std::isfinite(lane(x, 0)), "no NaN and no infinity in the resultants", i);
        detail::holds(std::isfinite(lane(point.moduli().wave(), 0)), "no NaN and no infinity in the moduli", i);
      }
    }
}

/// All laws.
template <PlateSection M>
void conforms(const M& section, const Drive& drive = {}) {
  detail::holds(section.density() > 0 && section.thickness() > 0 && section.rotary_inertia() > 0,
                "it has a density, a thickness and a rotary inertia", 0);
  rests(section, drive);
  lanes_agree<Pack<double, 4>>(section, drive);
  lanes_agree<Pack<double, 8>>(section, drive);
  lanes_agree<Pack<float, 16>>(section, drive);
  gives_no_energy(section, drive);
  bounds_its_tangent(section, drive);
  stays_failed(section, drive);
  bears_extremes<double>(section);
  bears_extremes<Pack<float, 16>>(section);
}

}  // namespace strike::testing
