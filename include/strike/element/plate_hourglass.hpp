#pragma once
#include <strike/element/policies.hpp>
#include <strike/range.hpp>

namespace strike {

/// Resistance against the hourglass modes themselves (Belytschko, Lin and Tsay 1984, eq. 44, written in the stiffness
/// of any section as Chiang 1992, eq. 49: E h is A11, E h^3/12 is D, kappa G h is K):
///   membrane r A11 A/8 b.b,   bending r (D + K A/9) A/16 b.b,   across r K h^2/12 b.b.
struct PlateHourglass {
  double membrane = 0.03, bending = 0.03, shear = 0.03;  ///< r, usually 0.01 to 0.05

  void ranges(const auto& number) const {
    number("membrane", membrane, range::between(0, 100));
    number("bending", bending, range::between(0, 100));
    number("shear", shear, range::between(0, 100));
  }

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

/// Absence of a resistance to the hourglass modes.
struct NoPlateHourglass {
  template <class T>
  struct State {};
};

}  // namespace strike
