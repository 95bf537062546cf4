#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/part.hpp>
#include <strike/dynamics/step_bound.hpp>
#include <strike/element/element.hpp>
#include <strike/motion/execution.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

namespace detail {

/// A material that knows by how much its shape has been strained.
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

/// An element that remembers its critical rate, one over the step that it allows alone.
template <class E>
struct Bounded : E {
  template <class W, class T>
  struct State : E::template State<W, T> {
    T own_rate{};

    /// Not less than what any of its points has been strained.
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
};

/// What a block of elements was when the mesh was last asked.
template <class E, class T>
struct AskedBlock {
  T rate{};  ///< the own one; 0: was not among those asked
  T strain{};
  typename E::template Resistance<T> resistance{};

  /// The critical rate now in a mesh whose own was then `bound`: that has grown as the element's, and by what its shape
  /// may have lost.
  template <class State>
  T critical_rate(const State& now, double bound) const {
    const T left = max(T(0.0), 1.0 - (now.strain() - strain));
    return select(rate > 0.0, bound * max(T(1.0), now.own_rate / rate) / left, now.own_rate);
  }

  /// But for the resistance, which is asked for anew.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(rate, strain);
  }
};
struct NoPart {
  void serialize(auto&) {}
};
template <class Thing>
struct AskedBlocksOf {
  using type = NoPart;
};
template <class E, class M, class T, class Nodes, class Removal>
struct AskedBlocksOf<RunningPart<E, M, T, Nodes, Removal>> {
  using type = std::vector<AskedBlock<E, T>>;
};
template <class Things>
struct AskedBlocks;
template <class... Things>
struct AskedBlocks<std::tuple<Things...>> : std::tuple<typename AskedBlocksOf<Things>::type...> {
  std::tuple<typename AskedBlocksOf<Things>::type...>& all() { return *this; }
};

/// The largest eigenvalue of the symmetric tridiagonal matrix of these diagonals, from above to rounding: no pivot of T
/// - x I is positive for x above it (Sturm).
inline double largest_eigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const std::size_t n = diagonal.size();
  double lower = 0, upper = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double row = (i > 0 ? std::abs(beside[i - 1]) : 0) + (i + 1 < n ? std::abs(beside[i]) : 0);
    lower = std::max(lower, diagonal[i]), upper = std::max(upper, diagonal[i] + row);
  }
  const auto is_above = [&](double x) {
    double pivot = -1;
    for (std::size_t i = 0; i < n && pivot < 0; ++i)
      pivot = diagonal[i] - x - (i > 0 ? beside[i - 1] * beside[i - 1] / pivot : 0);
    return pivot < 0;
  };
  while (upper - lower > 1e-12 * upper) {
    const double middle = 0.5 * (lower + upper);
    (is_above(middle) ? upper : lower) = middle;
  }
  return upper;
}

/// Number k of a sequence of independent numbers in (0, 1) (Steele, Lea and Flood 2014: splitmix64).
inline double random_number(std::uint64_t k) {
  std::uint64_t z = (k + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (static_cast<double>((z ^ (z >> 31)) >> 11) + 0.5) * 0x1p-53;
}
/// Normally distributed (Box and Muller 1958).
inline double random_normal(std::uint64_t k) {
  return std::sqrt(-2 * std::log(random_number(2 * k))) * std::cos(2 * std::numbers::pi * random_number(2 * k + 1));
}

/// How many steps of Lanczos's iteration from a random direction of n components leave the largest eigenvalue of a
/// positive matrix underestimated by more than the share `deviation` with a probability of at most `failure`: this is
/// 1.648 sqrt(n) exp(-sqrt(deviation) (2 k - 1)) (Kuczynski and Wozniakowski 1992).
inline std::size_t lanczos_steps(std::size_t n, double deviation, double failure) {
  const double twice = std::log(1.648 * std::sqrt(static_cast<double>(n)) / failure) / std::sqrt(deviation);
  return std::min(n, static_cast<std::size_t>(std::ceil(0.5 * (twice + 1))));
}

}  // namespace detail

/// The stable step of the mesh as a whole, larger than that of its elements, whose highest modes do not fit together.
/// Lanczos's iteration finds it on those elements that would need smaller steps, and it is followed from element to
/// element as the mesh deforms. They are asked again when the steps lost since amount to what that costs.
///   Explicit run{scene, options, GlobalStep{}};
struct GlobalStep {
  double failure = 1e-9;    ///< probability that an answer is less safe than it says
  double deviation = 0.15;  ///< how far the iteration may stay below the eigenvalue if all elements are asked; of the
                            ///< share s of them s^(2/3) of that, for they cost less. The step loses about half of it.
  double price = 0.5;       ///< of an iteration with all elements, in steps

  template <class E>
  using Element = detail::Bounded<E>;
  template <class M>
  using Material = detail::Watched<M>;
  template <class E, class M>
  static constexpr bool suits = detail::Resisting<E, M>;
  template <class Nodes, class Things>
  class Running;
};

/// The bound at work.
template <class Nodes, class Things>
class GlobalStep::Running {
 public:
  explicit Running(const GlobalStep& policy) : policy_(policy) {}

  template <class Execution>
  void extend(StableStep& stable, Nodes& nodes, Things& things, const Execution& execution) {
    const double own = stable.dt;
    if (!std::isfinite(own)) return;  // nothing is left that resists
    stable.dt = std::max(own, allowed_step(things, execution));
    earned_ += stable.dt / own - 1;
    lost_ += 1 - stable.dt / (hope_ * own);
    if (lost_ < patience_ * price_) return;
    patience_ = earned_ < price_ ? 2 * patience_ : 1;
    ask(own, nodes, things, execution);
    stable.dt = std::max(own, allowed_step(things, execution));
    lost_ = earned_ = 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bound_, hope_, lost_, earned_, price_, patience_, asked_, products_, blocks_.all());
  }

  /// How often the mesh was asked, and by how many products with its matrix.
  std::size_t asked() const { return asked_; }
  std::size_t products() const { return products_; }

 private:
  using Field = std::decay_t<decltype(std::declval<Nodes&>().motion().position)>;
  using Vector = typename Field::value_type;
  using Real = RealOf<Vector>;

  /// f(part, its blocks when they were asked).
  template <class F>
  void each_part(Things& things, const F& f) {
    const auto visit = [&](auto& thing, auto& asked) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(asked)>, detail::NoPart>) f(thing, asked);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (visit(std::get<i>(things), std::get<i>(blocks_)), ...);
    }(std::make_index_sequence<std::tuple_size_v<Things>>{});
  }

  /// What the mesh allows as it stands: of those asked what is left of their bound, of the others their own.
  template <class Execution>
  double allowed_step(Things& things, const Execution& execution) {
    double rate = 0;
    each_part(things, [&](auto& part, auto& asked) {
      asked.resize(part.blocks().size());
      sums_.resize(part.patches().size());
      execution.for_each(sums_.size(), [&](std::size_t p) {
        const detail::Patch& patch = part.patches()[p];
        auto largest = asked[patch.first_block].critical_rate(part.blocks()[patch.first_block].state, 1 / bound_);
        for (std::size_t b = patch.first_block + 1; b < patch.last_block; ++b)
          largest = max(largest, asked[b].critical_rate(part.blocks()[b].state, 1 / bound_));
        sums_[p] = static_cast<double>(reduce_max(largest));
      });
      for (const double largest : sums_) rate = std::max(rate, largest);
    });
    return 1 / rate;
  }

  /// Finds the bound anew; `own` is the least step of an element.
  template <class Execution>
  void ask(double own, Nodes& nodes, Things& things, const Execution& execution) {
    const double dt = hope_ * own;  // near what will be found, for damping scales otherwise than stiffness
    const double share = choose(1.2 * dt, dt, nodes, things);
    const double below = std::max(policy_.deviation * std::cbrt(share * share), 0.005);
    const std::size_t steps = detail::lanczos_steps(3 * places_.size(), below, policy_.failure);
    const double mu = lanczos(steps, nodes, things, execution) / (1 - below);
    bound_ = mu > 1 ? dt / mu : dt / std::sqrt(mu);  // mu(dt) falls at least as dt and grows at most as dt^2
    hope_ = std::clamp(bound_ / own, 1.02, 1.25 * hope_);
    price_ = 1 + policy_.price * share * static_cast<double>(steps);
    ++asked_;
  }

  /// Chooses whom to ask: the elements whose own step is below `target`, and their neighbours. They have only their own
  /// masses, so that the others are safe with theirs. Returns the share of those chosen.
  double choose(double target, double dt, Nodes& nodes, Things& things) {
    std::vector<bool> near(nodes.size());
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    each_part(things, [&](const auto& part, const auto&) {
      for (std::size_t b = 0; b < part.blocks().size(); ++b) {
        const auto& corners = part.blocks()[b].nodes;
        const auto& state = part.blocks()[b].state;
        for (std::size_t l = 0; l < part.count(b); ++l)
          if (static_cast<double>(lane(state.own_rate, l)) * target > 1)
            for (const auto& corner : corners) near[place(corner[l])] = true;
      }
    });

    std::size_t chosen = 0, all = 0;
    mass_.assign(nodes.size(), 0);
    patches_.clear();
    each_part(things, [&](auto& part, auto& asked) {
      auto& mine = patches_.emplace_back();
      for (std::size_t p = 0; p < part.patches().size(); ++p) {
        const std::size_t before = chosen;
        for (std::size_t b = part.patches()[p].first_block; b < part.patches()[p].last_block; ++b)
          chosen += choose_in(part, asked[b], b, dt, nodes, near);
        if (chosen > before) mine.push_back(p);
      }
      all += part.size();
    });
    places_.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (mass_[i] > 0) places_.push_back(static_cast<Index>(i));
    return static_cast<double>(chosen) / static_cast<double>(all);
  }

  /// The same in block b; what has failed, and has no rate, is not asked.
  template <class Part, class E, class T>
  std::size_t choose_in(const Part& part, detail::AskedBlock<E, T>& asked, std::size_t b, double dt, Nodes& nodes,
                        const std::vector<bool>& near) {
    const auto& corners = part.blocks()[b].nodes;
    const auto& state = part.blocks()[b].state;
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    const auto is_near = [&](std::size_t l) {
      return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) { return near[place(corner[l])]; });
    };
    asked.rate = T(0.0);
    for (std::size_t l = 0; l < lanes<T>; ++l)
      if (is_near(l)) set_lane(asked.rate, l, lane(state.own_rate, l));
    if (!any(asked.rate > 0.0)) return 0;

    asked.strain = state.strain();
    asked.resistance =
        part.element().resistance(state, part.material(), gather<T, Part::n>(nodes.motion().position, corners),
                                  gather<T, Part::n>(nodes.motion().velocity, corners), dt);
    std::size_t count = 0;
    for (std::size_t l = 0; l < part.count(b); ++l)
      if (lane(asked.rate, l) > 0) {
        ++count;
        for (const auto& corner : corners) mass_[place(corner[l])] += lane(asked.resistance.mass, l);
      }
    return count;
  }

  /// The largest eigenvalue of those asked over their masses as so many steps of Lanczos's iteration know it, from
  /// below. With the vectors q over the masses:  b q_next = A q/m - a q - b_before q_before,  a = q.A q,  |q| = 1.
  template <class Execution>
  double lanczos(std::size_t steps, Nodes& nodes, Things& things, const Execution& execution) {
    for (Field* field : {&q_, &q_before_, &resistance_}) field->assign(nodes.places(), Vector(0));
    for (const Index i : places_)
      for (std::size_t c = 0; c < 3; ++c)
        q_[i].set(c, static_cast<Real>(detail::random_normal((asked_ << 40) + 3 * std::uint64_t{i} + c) /
                                       std::sqrt(static_cast<double>(mass_[i]))));

    std::vector<double> diagonal, beside;
    double norm = std::sqrt(sum(execution, [&](Index i) { return mass_[i] * dot(q_[i], q_[i]); }));
    for (std::size_t k = 0; k < steps && norm > 0; ++k) {
      if (k > 0) beside.push_back(norm);
      const Vector b = k > 0 ? static_cast<Real>(norm) : 0, per_norm = static_cast<Real>(1 / norm);
      sum(execution, [&](Index i) {
        q_[i] *= per_norm;
        resistance_[i] = 0;
        return Real(0);
      });
      resist(nodes, things, execution);
      diagonal.push_back(-sum(execution, [&](Index i) { return dot(q_[i], resistance_[i]); }));
      const Vector a = static_cast<Real>(diagonal.back());
      norm = std::sqrt(sum(execution, [&](Index i) {
        q_before_[i] = -(a * q_[i] + b * q_before_[i] + Vector(1 / mass_[i]) * resistance_[i]);
        return mass_[i] * dot(q_before_[i], q_before_[i]);
      }));
      std::swap(q_, q_before_);
    }
    return detail::largest_eigenvalue(diagonal, beside);
  }

  static Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// The sum of f(i) over the nodes of those asked, in an order that does not depend on the threads.
  template <class Execution, class F>
  double sum(const Execution& execution, const F& f) {
    sums_.resize(detail::chunks(places_.size()));
    detail::for_each_chunk(execution, places_.size(), [&](std::size_t k, std::size_t first, std::size_t last) {
      double mine = 0;
      for (std::size_t j = first; j < last; ++j) mine += static_cast<double>(f(places_[j]));
      sums_[k] = mine;
    });
    return std::accumulate(sums_.begin(), sums_.end(), 0.0);
  }

  /// resistance -= A q.
  template <class Execution>
  void resist(Nodes& nodes, Things& things, const Execution& execution) {
    ++products_;
    auto patches = patches_.begin();
    each_part(things, [&](const auto& part, const auto& asked) {
      execution.for_each(patches->size(),
                         [&, &mine = *patches](std::size_t k) { resist(part, asked, part.patches()[mine[k]], nodes); });
      for (const std::size_t p : *patches) part.patches().gather(part.patches()[p], resistance_);
      ++patches;
    });
  }
  template <class Part, class E, class T>
  [[gnu::flatten]] void resist(const Part& part, const std::vector<detail::AskedBlock<E, T>>& blocks,
                               const detail::Patch& patch, Nodes& nodes) {
    constexpr std::size_t n = Part::n;
    part.patches().refresh(patch, q_, resistance_);
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      const auto asked = blocks[b].rate > 0.0;
      if (!any(asked)) continue;
      const auto& corners = part.blocks()[b].nodes;
      const Nodal<T, static_cast<int>(n)> f =
          blocks[b].resistance(gather<T, n>(nodes.motion().position, corners), gather<T, n>(q_, corners));
      scatter_subtract<T, n>(f.unaryExpr([&](const T& f_i) -> T { return select(asked, f_i, T(0.0)); }).eval(),
                             resistance_, corners, part.count(b));
    }
  }

  GlobalStep policy_;
  double bound_ = 1;                                         // of those asked, when they were asked
  double hope_ = 1.3;                                        // what that may be over the least of their own
  double lost_ = 0, earned_ = 0, price_ = 0, patience_ = 1;  // [steps]
  std::size_t asked_ = 0, products_ = 0;
  detail::AskedBlocks<Things> blocks_;
  std::vector<std::vector<std::size_t>> patches_;  // of each part, those with elements that are asked
  std::vector<Index> places_;                      // of their nodes
  std::vector<Real> mass_;                         // place by place, of those asked alone
  Field q_, q_before_, resistance_;
  std::vector<double> sums_;
};

}  // namespace strike
