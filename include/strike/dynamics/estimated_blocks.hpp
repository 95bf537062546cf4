#pragma once
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/growth_of_rates.hpp>
#include <strike/dynamics/nodal_volume.hpp>
#include <strike/dynamics/running_part.hpp>
#include <strike/element/element.hpp>
#include <strike/section/linear_stress.hpp>
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
  template <class T, class Linear>
  auto stress(State<T>& state, Linear& linear, const typename M::Kinematics::template Rate<T>& rate,
              const LinearRate<T>& linear_rate, double dt, LinearResultants<T>& resultants) const {
    state.watched_strain += T(dt) * rate_of_shape(rate);
    return M::stress(static_cast<typename M::template State<T>&>(state), linear, rate, linear_rate, dt, resultants);
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

/// An element that remembers its critical rate, one over the step that it allows alone.
template <class E>
struct Bounded : E {
  template <class W, class T>
  struct State : E::template State<W, T> {
    FollowedRate<T> followed{};

    /// The largest at a point.
    T strain() const {
      T largest = T(0.0);
      each_watched(*this, [&](const auto& point) { largest = max(largest, point.watched_strain); });
      return largest;
    }
    /// Begins to follow it in lanes where `estimated` is 1.
    void follow(const T& estimated) {
      followed.per_estimated = select(estimated > 0.0 && followed.now > 0.0, 1.0 / followed.now, T(0.0));
      each_watched(*this, [](auto& point) { point.watched_strain = T(0.0); });
    }

   private:
    /// f(state of the material), of an element with several points of each.
    template <class Self, class F>
    static void each_watched(Self& state, const F& f) {
      if constexpr (requires { state.material.watched_strain; })
        f(state.material);
      else
        for (auto& point : state.material) f(point);
    }
  };

  template <class W, class T, class... Motion>
  auto advance(State<W, T>& state, const W& material, const Nodal<T, E::nodes>& x, const Motion&... v_dt) const
      -> decltype(std::declval<const E&>().advance(state, material, x, v_dt...)) {
    const Response<T, motions<E>> response = E::advance(state, material, x, v_dt...);
    state.followed.now = response.critical_rate;
    return response;
  }
  /// The rate of elements that may just have been deleted.
  template <class W, class T>
  void record(State<W, T>& state, const Response<T, motions<E>>& response) const {
    state.followed.now = response.critical_rate;
  }
};

/// Memory of a part for an estimate: the resistance of its elements, the patches that have any of it, and their volumes
/// at nodes.
template <class E, class T>
struct EstimatedPart {
  struct NoVolume {};
  static constexpr bool averages_volume = requires { requires E::averages_volume; };

  std::vector<typename E::template Resistance<T>> resistance;
  std::vector<std::size_t> patches, own_patches;  ///< with chosen elements, and those of this process
  [[no_unique_address]] std::conditional_t<averages_volume, NodalVolume<LaneOf<T>, true>, NoVolume> volume;
};
struct NoPart {};
template <class Item>
struct EstimatedPartOf {
  using type = NoPart;
};
template <class E, class M, class T, class Nodes, class Removal>
struct EstimatedPartOf<RunningPart<E, M, T, Nodes, Removal>> {
  using type = EstimatedPart<E, T>;
};
template <class Item>
struct EstimatedPartOf<std::vector<Item>> {
  using type = std::vector<typename EstimatedPartOf<Item>::type>;
};
template <class... Items>
struct EstimatedPartOf<std::variant<Items...>> {
  using type = std::variant<typename EstimatedPartOf<Items>::type...>;
};
template <class Items>
struct EstimatedParts;
template <class... Items>
struct EstimatedParts<std::tuple<Items...>> : std::tuple<typename EstimatedPartOf<Items>::type...> {
  /// f(part, the same at the last estimate).
  template <class Tuple, class F>
  void each_part(Tuple& items, const F& f) {
    std::tuple<typename EstimatedPartOf<Items>::type...>& parts = *this;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (visit(std::get<i>(items), std::get<i>(parts), f), ...);
    }(std::index_sequence_for<Items...>{});
  }

 private:
  template <class Item, class Estimated, class F>
  static void visit(Item& item, Estimated& estimated, const F& f) {
    if constexpr (is_vector<std::remove_const_t<Item>>) {
      estimated.resize(item.size());
      for (std::size_t i = 0; i < item.size(); ++i) visit(item[i], estimated[i], f);
    } else if constexpr (is_variant<std::remove_const_t<Item>>) {
      with_alternative(item, [&]<std::size_t i>(auto& one, std::integral_constant<std::size_t, i>) {
        if (estimated.index() != i) estimated.template emplace<i>();
        visit(one, *std::get_if<i>(&estimated), f);
      });
    } else if constexpr (!std::is_same_v<Estimated, NoPart>) {
      f(item, estimated);
    }
  }
};

}  // namespace strike::detail
