#pragma once
#include <strike/element/element.hpp>
#include <strike/element/merged_corners.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// An element whose mass is scaled at the start so that it allows at least this `step` [time], before the step factor
/// of the run: for few elements that are much smaller than the others. A frequency sqrt(k/m) falls with the root of the
/// mass, and rates of decay fall at least so. Nodes get the mass; the density in the laws stays. The added mass:
/// `run.item<i>().added_mass()`, and the warnings of the run.
///   Part{MassScaled{Hex8{}, 2e-4}, copper, mesh.hexahedra}
template <class E>
struct MassScaled : E {
  double step;  ///< [time]

  void ranges(const auto& number) const {
    number(static_cast<const E&>(*this));
    number("step", step, range::not_negative);
  }

  template <class M, class T>
  struct State : E::template State<M, T> {
    T mass_factor{1.0};

    /// All its numbers beside those of another, where a section holds lists.
    template <class F>
    void visit_numbers(const State& other, const F& f) {
      using Own = typename E::template State<M, T>;
      strike::visit_numbers<T>(static_cast<Own&>(*this), static_cast<const Own&>(other), f);
      strike::visit_numbers<T>(mass_factor, other.mass_factor, f);
    }
  };

  /// `merged`: the MergedGradient of lanes with corners in the same node, or nothing, of elements that may have some.
  template <class M, class T, class... Merged>
  auto begin(State<M, T>& state, const M& material, const Nodal<T, E::nodes>& x, const Merged&... merged) const {
    auto given = E::begin(state, material, x);
    typename E::template State<M, T> trial = state;
    const Nodal<T, motions<E>> v = Nodal<T, motions<E>>::Constant(T(0.0));
    const T shortfall = step * [&]() -> T {
      if constexpr (sizeof...(Merged) > 0)
        if ((merged.has_value() && ...)) {
          VibrationSources<T> sources;
          const T V = E::advance(trial, material, x, v, 0.0, &sources).volume;
          return E::merged_rate(trial, material, *merged..., V, sources);
        }
      return E::advance(trial, material, x, v, 0.0).critical_rate;
    }();
    state.mass_factor = max(T(1.0), shortfall * shortfall);
    if constexpr (turns_nodes<E>())
      given.mass *= state.mass_factor, given.inertia *= state.mass_factor;
    else
      given *= state.mass_factor;
    return given;
  }

  template <class M, class T, class... Motion>
  auto advance(State<M, T>& state, const M& material, const Nodal<T, E::nodes>& x, const Motion&... v_dt) const
      -> decltype(std::declval<const E&>().advance(state, material, x, v_dt...)) {
    auto response = E::advance(state, material, x, v_dt...);
    response.critical_rate *= rsqrt(state.mass_factor);
    return response;
  }

  template <class M, class T>
  T merged_rate(const State<M, T>& state, const M& material, const MergedGradient<T>& merged, const T& V,
                const VibrationSources<T>& sources) const {
    return rsqrt(state.mass_factor) * E::merged_rate(state, material, merged, V, sources);
  }

  template <class M, class T>
  auto resistance(const State<M, T>& state, const M& material, const Nodal<T, E::nodes>& x,
                  const Nodal<T, motions<E>>& v, double dt) const
      -> decltype(std::declval<const E&>().resistance(state, material, x, v, dt)) {
    auto resistance = E::resistance(state, material, x, v, dt);
    resistance.mass *= state.mass_factor;
    if constexpr (turns_nodes<E>()) resistance.inertia *= state.mass_factor;
    return resistance;
  }
};
/// Fallback for particles: its static_assert reports them.
template <class E>
  requires(sees_neighbours<E>())
struct MassScaled<E> {
  static_assert(
      sizeof(E) == 0,
      "strike: MassScaled takes elements with a shape: particles of a part have one spacing, and so one step.");
  static constexpr bool sound = false;
  using Kinematics = typename E::Kinematics;
  static constexpr int nodes = E::nodes;
  E element;
  double step;
};
template <class E>
MassScaled(E, double) -> MassScaled<E>;

}  // namespace strike
