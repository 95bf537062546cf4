#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/element/cell_shape.hpp>
#include <strike/element/element.hpp>
#include <strike/error.hpp>
#include <strike/mesh/check_cell.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>
#include <strike/scalar/bisect.hpp>
#include <strike/verify/eigenmodes.hpp>
#include <strike/verify/single_element.hpp>

namespace strike::verify {

/// The largest stable step of an element alone, claimed and exact [time].
struct StepStudy {
  double claimed;   ///< by the element
  double exact;     ///< that of its vibrations, viscosities included
  double undamped;  ///< 2/w_max

  /// Unused part of the stable step, above 1; below 1 the element is unstable.
  double ratio() const { return exact / claimed; }
};

/// Stable step of an element whose nodes move at the velocities v.
template <class E, class M>
StepStudy step_study(SingleElement<E, M> single,
                     const Nodal<double, motions<E>>& v = Nodal<double, motions<E>>::Zero()) {
  const auto vibration = single.vibration(v);
  const double undamped = 2 / vibration.frequencies().maxCoeff(), exact = vibration.critical_step();
  return {single.step(v, 1e-9 * single.now().stable_step).stable_step, exact, undamped};
}

/// Stable step of an element that loses a share of its volume in each step, so that bulk viscosity acts.
template <class E, class M>
StepStudy step_in_compression(const SingleElement<E, M>& single, double share = 0.01) {
  constexpr int n = E::nodes, dimensions = turns_nodes<E>() ? 2 : 3;
  Nodal<double, motions<E>> v = Nodal<double, motions<E>>::Zero();
  v.template leftCols<n>() =
      -share / dimensions / single.now().stable_step * (single.now().x.colwise() - single.now().x.rowwise().mean());
  return step_study(single, v);
}

/// A rigid rotation of an element: the errors of its nodal forces, each relative to the largest force of a uniform
/// strain, 0 for a sound element.
struct RotationStudy {
  double unstrained;  ///< the largest force while it turns without having been strained
  double strained;    ///< the largest difference of the forces from those that turn with it, after a strain of 1e-3
  double revolutions;
};

/// Turns an element about an oblique axis, by `angle` [rad] in each of the steps. Its material should not flow at
/// strains of 1e-3, or it relaxes while it turns if it depends on the rate.
template <class E, class M>
RotationStudy rotation_study(const E& element, const M& material, const Nodal<double, E::nodes>& x, double angle = 0.1,
                             std::size_t steps = 63) {
  constexpr int n = E::nodes, m = motions<E>;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -2) / 3, middle = x.rowwise().mean();
  const Nodal<double, n> centred = x.colwise() - middle;
  SingleElement still{element, material, centred}, strained = still;
  const double dt = still.now().stable_step, rate = 2 * std::tan(angle / 2) / dt;

  Eigen::Matrix3d L;
  L << 0.6, 0.3, -0.2, 0.1, 0.4, 0.5, -0.3, 0.2, 0.7;
  strained.run(motion::homogeneous(1e-3 / dt * L), dt, 1);
  const Nodal<double, m> before = strained.step(Nodal<double, m>::Zero(), dt).force;

  RotationStudy study{0, 0, static_cast<double>(steps) * angle / (2 * std::numbers::pi)};
  const auto turning = motion::rotation(rate * axis);
  for (const auto& record : still.run(turning, dt, steps))
    study.unstrained = std::max(study.unstrained, record.force.cwiseAbs().maxCoeff());
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d once = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  for (std::size_t i = 0; i < steps; ++i) {
    const auto after = strained.run(turning, dt, 1).back().force;
    turn = once * turn;
    study.strained = std::max(study.strained, (after - turn * before).cwiseAbs().maxCoeff());
  }
  const auto uniform = uniform_motions(still);
  const double scale = (still.vibration().stiffness * uniform.straining).cwiseAbs().maxCoeff();
  study.unstrained /= scale, study.strained /= before.cwiseAbs().maxCoeff();
  return study;
}

/// A way to distort an element, given in the box of its undistorted shape.
struct Distortion {
  std::string name, unit;
  double largest;  ///< the largest amount of a sweep
  /// Position of a point after the distortion: x from the middle of the box; xi, x over the size of the box, from -1/2
  /// to 1/2.
  Eigen::Vector3d (*map)(const Eigen::Vector3d& x, const Eigen::Vector3d& xi, double amount);
};

namespace distortions {

/// Shear of y along x by an angle.
inline const Distortion skew{"skew", "deg", 85, [](const auto& x, const auto&, double amount) -> Eigen::Vector3d {
                               return {x.x() + std::tan(amount * std::numbers::pi / 180) * x.y(), x.y(), x.z()};
                             }};
/// The side at the end of y shrinks along x: at 1 to a point or an edge.
inline const Distortion taper{"taper", "1", 1.2, [](const auto& x, const auto& xi, double amount) -> Eigen::Vector3d {
                                return {x.x() * (1 - amount * (xi.y() + 0.5)), x.y(), x.z()};
                              }};
/// The sides at both ends of x turn against each other about it: a plate warps.
inline const Distortion twist{
    "twist", "deg", 180, [](const auto& x, const auto& xi, double amount) -> Eigen::Vector3d {
      return Eigen::AngleAxisd(amount * std::numbers::pi / 180 * xi.x(), Eigen::Vector3d::UnitX()) * x;
    }};
/// The box loses its height: at 1 it is flat.
inline const Distortion flatten{"flatten", "1", 1.2, [](const auto& x, const auto&, double amount) -> Eigen::Vector3d {
                                  return {x.x(), x.y(), (1 - amount) * x.z()};
                                }};
/// The corner at the end of x, y and z goes to the opposite one: at 1/2 through the middle.
inline const Distortion dent{"dent", "1", 1, [](const auto& x, const auto& xi, double amount) -> Eigen::Vector3d {
                               const double weight = (xi.x() + 0.5) * (xi.y() + 0.5) * (xi.z() + 0.5);
                               return (1 - 2 * amount * weight) * x;
                             }};

}  // namespace distortions

/// The corners, stretched along x by `aspect` and distorted. A flat shape is at the end of its box in z.
template <int n>
Nodal<double, n> distorted(const Nodal<double, n>& corners, const Distortion& distortion, double aspect,
                           double amount) {
  const Eigen::Vector3d low = corners.rowwise().minCoeff(), high = corners.rowwise().maxCoeff(), size = high - low;
  Nodal<double, n> x;
  for (int i = 0; i < n; ++i) {
    Eigen::Vector3d xi;
    for (int k = 0; k < 3; ++k) xi(k) = size(k) > 0 ? (corners(k, i) - low(k)) / size(k) - 0.5 : 0.5;
    const Eigen::Vector3d place(aspect * size.x() * xi.x(), size.y() * xi.y(), size.z() * xi.z());
    x.col(i) = distortion.map(place, xi, amount);
  }
  return x;
}

/// State of a distorted element.
enum class Soundness {
  sound,
  inverted,    ///< flat or inside out, so that no mesh may have it
  unstable,    ///< its claimed step exceeds the exact one
  inaccurate,  ///< its stiffness under uniform strains is wrong
};

inline const char* to_string(Soundness soundness) {
  constexpr const char* names[] = {"sound", "inverted", "unstable", "inaccurate"};
  return names[static_cast<int>(soundness)];
}

/// An element of one shape.
struct DistortedElement {
  double aspect, amount;
  Soundness soundness = Soundness::inverted;
  double volume = 0;         ///< of a plate the area; 0 if inverted, like the numbers below
  double claimed = 0;        ///< its stable step
  double exact = 0;          ///< the exact one
  double uniform_error = 0;  ///< uniform_strain_error

  double ratio() const { return exact / claimed; }
};

/// First failure of an element between no distortion and the largest.
struct DistortionLimit {
  double aspect, amount;
  Soundness reason;  ///< `sound` if it has not failed
};

/// Studies of an element under a distortion that grows to its largest amount or until the element fails, for every
/// aspect ratio.
struct DistortionSweep {
  Distortion distortion;
  std::vector<DistortedElement> elements;  ///< by aspect, then by amount; each way ends with the first that fails
  std::vector<DistortionLimit> limits;     ///< for each aspect: the stability envelope

  /// The least exact over claimed step of all elements that are not inverted: below 1 some are unstable.
  double least_ratio() const {
    double least = std::numeric_limits<double>::infinity();
    for (const DistortedElement& e : elements)
      if (e.soundness != Soundness::inverted) least = std::min(least, e.ratio());
    return least;
  }
};

struct SweepOptions {
  std::vector<double> aspects = {1, 2, 5, 10, 100};
  std::size_t steps = 24;      ///< from no distortion to the largest
  double accuracy = 0.1;       ///< the largest uniform_strain_error of a sound element
  double rounding = 1e-9;      ///< by which the claimed step may exceed the exact one, relative
  double resolution = 1.0e-4;  ///< of the limits, as a share of the largest amount

  void ranges(const auto& number) const {
    number("aspects", aspects, range::positive);
    number("steps", steps, range::count);
    number("accuracy", accuracy, range::or_infinite(range::positive));
    number("rounding", rounding, range::not_negative);
    number("resolution", resolution, Range{.low = 0, .high = 1});
  }
};

/// The soundness of an element of this shape.
template <class E, class M>
DistortedElement judged(const E& element, const M& material, const Nodal<double, E::nodes>& x,
                        const SweepOptions& options = {}) {
  DistortedElement result{1, 0};
  if constexpr (E::nodes == 8 || E::nodes == 4 || E::nodes == 3) {
    constexpr CellShape shape = E::nodes == 8      ? CellShape::hexahedron
                                : E::nodes == 3    ? CellShape::triangle
                                : turns_nodes<E>() ? CellShape::quadrilateral
                                                   : CellShape::tetrahedron;
    std::array<Index, E::nodes> cell;
    detail::CellCorners<E::nodes> corners;
    for (std::size_t i = 0; i < cell.size(); ++i)
      cell[i] = static_cast<Index>(i), corners[i] = x.col(static_cast<Eigen::Index>(i));
    bool inverted = false;
    detail::CellLaws<shape>::each_corner(
        cell, corners, [&](const auto& corner) { inverted = inverted || !(corner.margin(detail::flat) > 0); });
    if (inverted) return result;
  }
  try {
    const SingleElement single{element, material, x};
    result.volume = single.now().volume, result.claimed = single.now().stable_step;
    if (!(result.volume > 0)) return result;
    result.exact = single.vibration().critical_step();
    result.uniform_error = uniform_strain_error(single);
  } catch (const Error&) {
    return result;
  }
  result.soundness = !(result.exact >= (1 - options.rounding) * result.claimed) ? Soundness::unstable
                     : !(result.uniform_error <= options.accuracy)              ? Soundness::inaccurate
                                                                                : Soundness::sound;
  return result;
}

/// Distorts an element from its undistorted corners.
template <class E, class M>
DistortionSweep distortion_sweep(const E& element, const M& material, const Nodal<double, E::nodes>& corners,
                                 const Distortion& distortion, const SweepOptions& options = {}) {
  detail::check_ranges(options);
  DistortionSweep sweep{distortion, {}, {}};
  for (const double aspect : options.aspects) {
    const auto at = [&](double amount) {
      DistortedElement result = judged(element, material, distorted(corners, distortion, aspect, amount), options);
      result.aspect = aspect, result.amount = amount;
      return result;
    };
    DistortionLimit limit{aspect, distortion.largest, Soundness::sound};
    double sound = 0;
    for (std::size_t i = 0; i <= options.steps; ++i) {
      sweep.elements.push_back(at(distortion.largest * static_cast<double>(i) / static_cast<double>(options.steps)));
      const DistortedElement& last = sweep.elements.back();
      if (last.soundness == Soundness::sound) {
        sound = last.amount;
        continue;
      }
      limit.reason = last.soundness;
      const auto is_sound = [&](double amount) {
        const Soundness soundness = at(amount).soundness;
        if (soundness != Soundness::sound) limit.reason = soundness;
        return soundness == Soundness::sound;
      };
      const auto is_wide = [&](const Bracket<double>& b) {
        return b.upper - b.lower > options.resolution * distortion.largest;
      };
      limit.amount = bisect(Bracket<double>{sound, last.amount}, is_sound, is_wide).lower;
      break;
    }
    sweep.limits.push_back(limit);
  }
  return sweep;
}

}  // namespace strike::verify
