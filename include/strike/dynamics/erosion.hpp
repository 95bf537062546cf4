#pragma once
#include <cmath>
#include <limits>

#include <strike/dynamics/removal.hpp>
#include <strike/range.hpp>

namespace strike {

namespace detail {
template <class M>
constexpr bool has_plastic_strain() {
  if constexpr (requires { M::has_plastic_strain; })
    return M::has_plastic_strain;
  else
    return requires(typename M::template State<double> state) { state.equivalent_plastic_strain; };
}
}  // namespace detail

/// Limits beyond which elements of a part are deleted. They are so too as soon as their material has failed at all
/// points, or they are inverted.
///   Part{Tet4{}, bird, mesh.tetrahedra, Erosion{.strain = 5, .volume = 0.05}}
struct Erosion {
  /// largest equivalent strain: the plastic one, mean over the points; where the material has none the geometric one
  double strain = std::numeric_limits<double>::infinity();
  double volume = 0;  ///< least V/V0, of a plate A/A0; 0: until it is inverted
  double step = 0;    ///< least stable step of the element, before the factor [time]

  void ranges(const auto& number) const {
    number("strain", strain, range::or_infinite(range::positive));
    number("volume", volume, range::not_negative);
    number("step", step, range::not_negative);
  }

  template <class M>
  static constexpr bool needs_geometric_strain_of = !detail::has_plastic_strain<M>();

  template <class State, class E, class M, class T, bool has_geometry>
  auto keeps(const State& state, const ElementCondition<E, M, T, has_geometry>& element) const {
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
    if constexpr (has_geometry)
      if (std::isfinite(strain)) plastic_strain = points * element.geometric_strain();
    return intact > 0.0 && plastic_strain <= points * strain && element.volume > volume * element.initial_volume &&
           element.critical_rate * step <= 1.0;
  }
};

}  // namespace strike
