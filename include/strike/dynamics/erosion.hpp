#pragma once
#include <cstddef>
#include <limits>

#include <strike/element/element.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// The elements of a part stay whatever becomes of them: what its material makes fail gives no force, and the run ends
/// where another is inverted.
struct NoErosion {
  template <class T>
  struct Block {};
  struct Tally {};
};

/// An element of a part is deleted as soon as its material has failed at all its points, it is inverted, or one of
/// these limits is passed. Then it gives no force and does not limit the step; its mass stays with its nodes, which fly
/// on, and the energy that it held leaves with it: `Energy::eroded`.
///   Part{Tet4{}, bird, mesh.tetrahedra, Erosion{.strain = 5, .volume = 0.05}}
struct Erosion {
  double strain = std::numeric_limits<double>::infinity();  ///< largest equivalent plastic, the mean over its points
  double volume = 0;                                        ///< least V/V0, of a plate A/A0; 0: until it is inverted
  double step = 0;  ///< least stable step of the element, before the factor [time]

  template <class T>
  struct Block {
    T alive{1.0};  ///< 1, or 0 once deleted
    T initial_volume{};
    T energy{};  ///< held by the element
  };
  /// What has been deleted.
  struct Tally {
    std::size_t deleted = 0;
    double energy = 0;
  };

  /// Whether elements are within all limits.
  template <class T, class State, int n>
  auto keeps(const Block<T>& block, const State& state, const Response<T, n>& response) const {
    T plastic_strain = T(0.0), intact = T(0.0);
    double points = 0;
    state.each_point([&](const auto& point) {
      points += 1;
      if constexpr (requires { point.equivalent_plastic_strain; }) plastic_strain += point.equivalent_plastic_strain;
      if constexpr (requires { point.intact; })
        intact += point.intact;
      else
        intact += T(1.0);
    });
    return intact > 0.0 && plastic_strain <= points * strain && response.volume > volume * block.initial_volume &&
           response.critical_rate * step <= 1.0;
  }
};

}  // namespace strike
