#pragma once
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/nodal_volume.hpp>
#include <strike/dynamics/running_part.hpp>
#include <strike/element/element.hpp>
#include <strike/tensor/plane.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Rate at which no length of an element grows or shrinks faster, but for its volume or area [1/time].
template <class T>
T rate_of_shape(const SolidKinematics::Rate<T>& rate) {
  const SymmetricTensor<T> d = deviator(rate.rate_of_deformation);
  return sqrt((2.0 / 3.0) * double_dot(d, d));
}
template <class T>
T rate_of_shape(const PlateKinematics::Rate<T>& rate) {
  const PlaneTensor<T>& D = rate.membrane;
  const T half = 0.5 * (D.xx - D.yy);
  return sqrt(half * half + D.xy * D.xy);
}
template <class R>
concept TellsShape = requires(const R rate) { rate_of_shape(rate); };

/// A material that remembers the strain of its shape.
template <class M>
struct Watched : M {
  template <class T>
  struct State : M::template State<T> {
    T watched_strain{};  ///< by no more than it lengths have shrunk, but for the volume
  };

  template <class T>
  auto stress(State<T>& state, const typename M::Kinematics::template Rate<T>& rate, double dt) const {
    state.watched_strain += T(dt) * rate_of_shape(rate);
    return M::stress(static_cast<typename M::template State<T>&>(state), rate, dt);
  }
  template <class T>
  auto stress(const State<T>& state) const {
    return M::stress(static_cast<const typename M::template State<T>&>(state));
  }
  template <class T>
    requires requires(const M m, const typename M::template State<T> s, const T t) { m.stress(s, t); }
  auto stress(const State<T>& state, const T& relative_thickness) const {
    return M::stress(static_cast<const typename M::template State<T>&>(state), relative_thickness);
  }
};

template <class E, class M>
concept Resisting = TellsShape<typename M::Kinematics::template Rate<double>> &&
                    requires(const E e, typename E::template State<M, double> state, const M m,
                             const Nodal<double, E::nodes> x, const Nodal<double, motions<E>> v) {
                      { e.resistance(state, m, x, v, 1.0)(x, v) } -> std::convertible_to<Nodal<double, motions<E>>>;
                    };

/// An element that remembers its critical rate, one over the step that it allows alone [1/time].
template <class E>
struct Bounded : E {
  template <class W, class T>
  struct State : E::template State<W, T> {
    T own_rate{};

    /// At least the strain of any of its points.
    T strain() const {
      if constexpr (requires { this->material.watched_strain; }) {
        return this->material.watched_strain;
      } else {
        T sum = T(0.0);
        this->each_point([&](const auto& point) { sum += point.watched_strain; });
        return sum;
      }
    }
  };

  template <class W, class T, class... Motion>
  auto advance(State<W, T>& state, const W& material, const Nodal<T, E::nodes>& x, const Motion&... v_dt) const
      -> decltype(std::declval<const E&>().advance(state, material, x, v_dt...)) {
    const Response<T, motions<E>> response = E::advance(state, material, x, v_dt...);
    state.own_rate = response.critical_rate;
    return response;
  }
  /// The rate of elements that may just have been deleted.
  template <class W, class T>
  void record(State<W, T>& state, const Response<T, motions<E>>& response) const {
    state.own_rate = response.critical_rate;
  }
};

/// A block of elements at the last estimate of the mesh's step.
template <class T>
struct EstimatedBlock {
  T rate{};  ///< of the element alone; 0: was not part of the estimate [1/time]
  T strain{};

  /// The critical rate now in a mesh whose own was then `bound`: it has grown as that of the element, and by the length
  /// that its shape may have lost.
  template <class State>
  T critical_rate(const State& now, double bound) const {
    const T left = max(T(0.0), 1.0 - (now.strain() - strain));
    return select(rate > 0.0, bound * max(T(1.0), now.own_rate / rate) / left, now.own_rate);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(rate, strain);
  }
};

/// A part at the last estimate, with what the next one renews: the resistance of its elements, the patches that have
/// any of the estimate, and their volumes at nodes.
template <class E, class T>
struct EstimatedPart {
  struct NoVolume {};
  static constexpr bool averages_volume = requires { requires E::averages_volume; };

  std::vector<EstimatedBlock<T>> blocks;
  std::vector<typename E::template Resistance<T>> resistance;
  std::vector<std::size_t> patches;
  [[no_unique_address]] std::conditional_t<averages_volume, NodalVolume<LaneOf<T>, true>, NoVolume> volume;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks);
  }
};
struct NoPart {
  void serialize(auto&) {}
};
template <class Item>
struct EstimatedPartOf {
  using type = NoPart;
};
template <class E, class M, class T, class Nodes, class Removal>
struct EstimatedPartOf<RunningPart<E, M, T, Nodes, Removal>> {
  using type = EstimatedPart<E, T>;
};
template <class Items>
struct EstimatedParts;
template <class... Items>
struct EstimatedParts<std::tuple<Items...>> : std::tuple<typename EstimatedPartOf<Items>::type...> {
  std::tuple<typename EstimatedPartOf<Items>::type...>& all() { return *this; }

  /// f(part, the same at the last estimate).
  template <class Tuple, class F>
  void each_part(Tuple& items, const F& f) {
    const auto visit = [&](auto& item, auto& estimated) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(estimated)>, NoPart>) f(item, estimated);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (visit(std::get<i>(items), std::get<i>(all())), ...);
    }(std::index_sequence_for<Items...>{});
  }
};

}  // namespace strike::detail
