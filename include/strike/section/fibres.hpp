#pragma once
#include <cmath>
#include <concepts>
#include <type_traits>

#include <Eigen/Core>

#include <strike/material/kinematics.hpp>
#include <strike/material/plane_stiffness.hpp>
#include <strike/range.hpp>
#include <strike/scalar/math.hpp>
#include <strike/section/laminate_stiffness.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The direction in space from which the angles of plies count, about the normal of each plate: its part in the plane
/// of a plate at the start, which then turns with the plate. Such as the axis of rolls of prepreg.
///   Layered{LayUp{carbon, 0.125, {0, 45, -45, 90, 90, -45, 45, 0}}, FibreDirection{{1, 0, 0}}}
struct FibreDirection {
  Eigen::Vector3d direction;  ///< of any length

  void ranges(const auto& number) const { number("direction", direction, range::direction); }
};

namespace detail {

/// A plane material with axes of its own, which a section turns.
template <class M>
concept HasFibres = requires(const M m) {
  { m.plane_stiffness() } -> std::convertible_to<PlaneStiffness>;
  { m.transverse_stiffness() } -> std::convertible_to<Matrix2>;
  { m.fibre_angle() } -> std::convertible_to<double>;
};
template <class M>
concept HasSomeFibres = requires(const M m) { m.plane_stiffness(); } ||
                        requires(const M m) { m.transverse_stiffness(); } || requires(const M m) { m.fibre_angle(); };

/// Least part of a direction in the plane of a plate, of its length.
inline constexpr double least_in_plane = 1e-3;

/// The FibreDirection of a plate in its frame; zero, if it is normal to the plate.
template <bool has_fibres, class T>
struct Heading {};
template <class T>
struct Heading<true, T> {
  PlaneTurn<T> heading{T(1.0), T(0.0)};

  void align(const Eigen::Vector3d& direction, const Vector3<T>& e1, const Vector3<T>& e2) {
    const Eigen::Vector3d d = direction.normalized();
    const T x = d(0) * e1(0) + d(1) * e1(1) + d(2) * e1(2), y = d(0) * e2(0) + d(1) * e2(1) + d(2) * e2(2);
    const T square = x * x + y * y;
    const auto in_plane = square > least_in_plane * least_in_plane;
    const T per_length = select(in_plane, rsqrt(select(in_plane, square, T(1.0))), T(0.0));
    heading = {per_length * x, per_length * y};
  }
  PlateKinematics::Rate<T> into(const PlateKinematics::Rate<T>& rate) const {
    return {heading.into(rate.membrane), heading.into(rate.curvature), heading.into(rate.shear),
            rate.relative_thickness};
  }
  PlateKinematics::Stress<T> back(const PlateKinematics::Stress<T>& s) const {
    return {heading.back(s.force), heading.back(s.moment), heading.back(s.shear), s.normal_rate};
  }
};

/// Numbers of a section with fibres.
struct FibreSection {
  Eigen::Vector3d direction;
  LaminateStiffness stiffness;
  LaminateShear shear;
  Matrix2 shear_stiffness;  ///< that the policy makes of it
};

template <class T>
Vector2<T> in_plane_times(const Matrix2& A, const Vector2<T>& a) {
  return {A(0, 0) * a(0) + A(0, 1) * a(1), A(1, 0) * a(0) + A(1, 1) * a(1)};
}
template <class T>
Vector2<T> in_plane_times(double A, const Vector2<T>& a) {
  return T(A) * a;
}

}  // namespace detail

}  // namespace strike
