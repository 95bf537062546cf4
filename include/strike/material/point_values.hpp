#pragma once
#include <strike/tensor/plane.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

// Values of a point of any material, equal in name for layers of different materials:
//   part.field(PlasticStrain{}), and of the lowest layer of a plate part.field(0, Failed{})

/// The equivalent plastic strain; 0 of materials without plasticity.
struct PlasticStrain {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.equivalent_plastic_strain; })
      return point.equivalent_plastic_strain;
    else
      return 0.0;
  }
};

/// 1 of a failed point, or else 0.
struct Failed {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.intact; })
      return 1.0 - point.intact;
    else
      return 0.0;
  }
};

/// Von Mises' equivalent stress.
struct EquivalentStress {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.stress.zz; })
      return equivalent_stress(deviator(point.stress));
    else
      return equivalent_stress(point.stress);
  }
};

}  // namespace strike
