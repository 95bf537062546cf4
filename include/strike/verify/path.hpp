#pragma once
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike::verify {

/// Prescribed components of the Cauchy stress; the free ones follow from the motion.
struct PrescribedStress {
  static constexpr double free = std::numeric_limits<double>::quiet_NaN();
  double xx = free, yy = free, zz = free, xy = free, yz = free, zx = free;

  void ranges(const auto& number) const {
    number("xx", xx, range::or_nan(range::finite)), number("yy", yy, range::or_nan(range::finite));
    number("zz", zz, range::or_nan(range::finite)), number("xy", xy, range::or_nan(range::finite));
    number("yz", yz, range::or_nan(range::finite)), number("zx", zx, range::or_nan(range::finite));
  }
};

/// A part of a path in equal steps. The motion follows the velocity gradient; where a stress is prescribed, it runs
/// linearly from its present value to that value at the end, and the rate of deformation of that component follows from
/// it. The spin is always that of the velocity gradient.
struct Segment {
  double duration;  ///< [time]
  std::size_t steps = 100;
  Matrix3<double> velocity_gradient = Matrix3<double>::Zero();  ///< L [1/time], in the middle of each step
  PrescribedStress stress = {};

  void ranges(const auto& number) const {
    number("duration", duration, range::positive);
    number("steps", steps, range::count);
    number("velocity_gradient", velocity_gradient, range::point);
    number(stress);
  }
};

/// The strain history of a material point, one segment after the other: `uniaxial_stress({.strain = .1}) + hold(1)`.
struct Path {
  std::vector<Segment> segments;

  friend Path operator+(Path a, const Path& b) {
    a.segments.insert(a.segments.end(), b.segments.begin(), b.segments.end());
    return a;
  }
};

/// A strain reached at a constant rate.
struct Ramp {
  double strain;    ///< logarithmic; of a shear gamma = tan of its angle; negative: the other way
  double rate = 1;  ///< d strain/dt without its sign [1/time]
  std::size_t steps = 100;

  void ranges(const auto& number) const {
    number("strain", strain, range::finite);
    number("rate", rate, range::positive);
    number("steps", steps, range::count);
  }
};

namespace detail {
using namespace strike::detail;

inline Path ramp(const Ramp& ramp, int row, int column, const PrescribedStress& stress = {}) {
  check_ranges(ramp);
  if (ramp.strain == 0) throw Error("strike: a Ramp to the strain 0 has no duration: give another strain.");
  Segment segment{.duration = std::abs(ramp.strain) / ramp.rate, .steps = ramp.steps, .stress = stress};
  segment.velocity_gradient(row, column) = std::copysign(ramp.rate, ramp.strain);
  return {{segment}};
}

}  // namespace detail

/// Strain along x alone.
inline Path uniaxial_strain(const Ramp& ramp) { return detail::ramp(ramp, 0, 0); }

/// Strain along x under no other stress than that along x: the tension test.
inline Path uniaxial_stress(const Ramp& ramp) { return detail::ramp(ramp, 0, 0, {.yy = 0, .zz = 0}); }

/// Shear of the planes y = const along x: F = I + gamma x (x) y.
inline Path simple_shear(const Ramp& ramp) { return detail::ramp(ramp, 0, 1); }

/// Change of volume without change of shape; the strain is that of the volume, ln J.
inline Path hydrostatic(const Ramp& ramp) {
  Path path = detail::ramp(ramp, 0, 0);
  Matrix3<double>& L = path.segments.front().velocity_gradient;
  L = Matrix3<double>::Identity() * (L(0, 0) / 3);
  return path;
}

/// A pause without motion, in which stresses relax.
inline Path hold(double duration, std::size_t steps = 100) { return {{Segment{.duration = duration, .steps = steps}}}; }

/// The motion of the path run back, under the same prescribed stresses: unloading.
inline Path back(const Path& path) {
  Path reversed{{path.segments.rbegin(), path.segments.rend()}};
  for (Segment& segment : reversed.segments) segment.velocity_gradient *= -1;
  return reversed;
}

/// Cycles of four quarters: the path, back, as far to the other side, and back; `cycles` times.
inline Path cyclic(const Path& quarter, int cycles = 1) {
  const Path reversed = back(quarter), cycle = quarter + reversed + reversed + quarter;
  Path path;
  for (int i = 0; i < cycles; ++i) path = path + cycle;
  return path;
}

/// A loading at one rate after the other, over the ramp's strain at each: `rate_jumps(uniaxial_stress, {.strain
/// = .05}, {1e-3, 1e3, 1e-3})`.
template <class Loading>
Path rate_jumps(Loading loading, Ramp each, std::initializer_list<double> rates) {
  Path path;
  for (const double rate : rates) {
    each.rate = rate;
    path = path + loading(each);
  }
  return path;
}

}  // namespace strike::verify
