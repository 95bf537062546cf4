#pragma once
#include <concepts>

#include <strike/material/kinematics.hpp>
#include <strike/tensor/plane.hpp>

namespace strike {

/// The rates of the hourglass modes of a plate in its frame, or the resistance to them: of the motion in the plane and
/// across it, and of the rotations.
template <class T>
struct PlateHourglassModes {
  Vector2<T> membrane = Vector2<T>::Zero(), bending = Vector2<T>::Zero();
  T shear{};
};

/// What an hourglass control may know of its plate: its area, thickness and b_iI b_iI, and the stiffness of its
/// section.
template <class T, class Moduli>
struct PlateHourglassElement {
  T area, thickness, gradient_squared;
  Moduli moduli;
};

/// The stiffness of the control of each family [force/length, and force length for the rotations].
template <class T>
struct PlateHourglassStiffness {
  T membrane, bending, shear;
};

/// Resistance against the hourglass modes themselves (Belytschko, Lin and Tsay 1984, eq. 44, written in the stiffness
/// of any section as Chiang 1992, eq. 49: E h is A11, E h^3/12 is D, kappa G h is K):
///   membrane r A11 A/8 b.b,   bending r (D + K A/9) A/16 b.b,   across r K h^2/12 b.b.
struct PlateHourglass {
  double membrane = 0.03, bending = 0.03, shear = 0.03;  ///< r, usually 0.01 to 0.05

  template <class T>
  using State = PlateHourglassModes<T>;

  template <class T, class Moduli>
  PlateHourglassStiffness<T> stiffness(const PlateHourglassElement<T, Moduli>& e) const {
    const T &A = e.area, &bb = e.gradient_squared, &K = e.moduli.transverse_shear;
    return {(membrane / 8) * e.moduli.extension.normal * A * bb,
            (bending / 16) * (e.moduli.bending.normal + K * A * (1.0 / 9.0)) * A * bb,
            (shear / 12) * K * e.thickness * e.thickness * bb};
  }
};

/// Nothing resists the hourglass modes.
struct NoPlateHourglass {
  template <class T>
  struct State {};
};

/// A stiffness against the hourglass modes of a plate, or none.
template <class H>
concept PlateHourglassControl =
    std::same_as<H, NoPlateHourglass> ||
    requires(const H control, const PlateHourglassElement<double, PlateKinematics::Moduli<double>> e) {
      { control.stiffness(e) } -> std::same_as<PlateHourglassStiffness<double>>;
    };

}  // namespace strike
