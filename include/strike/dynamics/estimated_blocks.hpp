#pragma once
#include <concepts>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/running_part.hpp>
#include <strike/element/element.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// A material that remembers the strain of its shape.
template <class M>
struct Watched : M {
  template <class T>
  struct State : M::template State<T> {
    T watched_strain{};  ///< sum of sqrt(2/3 d:d) dt, d = dev D: but for the volume no length has shrunk by more
  };

  template <class T>
  auto stress(State<T>& state, const typename M::Kinematics::template Rate<T>& rate, double dt) const {
    const SymmetricTensor<T> d = deviator(rate.rate_of_deformation);
    state.watched_strain += T(dt) * sqrt((2.0 / 3.0) * double_dot(d, d));
    return M::stress(static_cast<typename M::template State<T>&>(state), rate, dt);
  }
  template <class T>
  auto stress(const State<T>& state) const {
    return M::stress(static_cast<const typename M::template State<T>&>(state));
  }
};

template <class E, class M>
concept Resisting =
    requires(const E e, typename E::template State<M, double> state, const M m, const Nodal<double, E::nodes> x) {
      { e.resistance(state, m, x, x, 1.0)(x, x) } -> std::convertible_to<Nodal<double, E::nodes>>;
    };

/// An element that remembers its critical rate, one over the step that it allows alone [1/time].
template <class E>
struct Bounded : E {
  template <class W, class T>
  struct State : E::template State<W, T> {
    T own_rate{};

    /// At least the strain of any of its points.
    T strain() const {
      T sum = T(0.0);
      this->each_point([&](const auto& point) { sum += point.watched_strain; });
      return sum;
    }
  };

  template <class W, class T, class Velocities>
  auto advance(State<W, T>& state, const W& material, const Nodal<T, E::nodes>& x, const Velocities& v, double dt) const
      -> decltype(std::declval<const E&>().advance(state, material, x, v, dt)) {
    const Response<T, E::nodes> response = E::advance(state, material, x, v, dt);
    state.own_rate = response.critical_rate;
    return response;
  }
  /// The rate of elements that may just have been deleted.
  template <class W, class T>
  void record(State<W, T>& state, const Response<T, E::nodes>& response) const {
    state.own_rate = response.critical_rate;
  }
};

/// A block of elements at the last estimate of the mesh's step.
template <class E, class T>
struct EstimatedBlock {
  T rate{};  ///< of the element alone; 0: was not part of the estimate [1/time]
  T strain{};
  typename E::template Resistance<T> resistance{};

  /// The critical rate now in a mesh whose own was then `bound`: it has grown as that of the element, and by the length
  /// that its shape may have lost.
  template <class State>
  T critical_rate(const State& now, double bound) const {
    const T left = max(T(0.0), 1.0 - (now.strain() - strain));
    return select(rate > 0.0, bound * max(T(1.0), now.own_rate / rate) / left, now.own_rate);
  }

  /// Without the resistance, which the next estimate renews.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(rate, strain);
  }
};
struct NoPart {
  void serialize(auto&) {}
};
template <class Item>
struct EstimatedBlocksOf {
  using type = NoPart;
};
template <class E, class M, class T, class Nodes, class Removal>
struct EstimatedBlocksOf<RunningPart<E, M, T, Nodes, Removal>> {
  using type = std::vector<EstimatedBlock<E, T>>;
};
template <class Items>
struct EstimatedBlocks;
template <class... Items>
struct EstimatedBlocks<std::tuple<Items...>> : std::tuple<typename EstimatedBlocksOf<Items>::type...> {
  std::tuple<typename EstimatedBlocksOf<Items>::type...>& all() { return *this; }
};

}  // namespace strike::detail
