#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/execution.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/step_bound.hpp>
#include <strike/element/element.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

namespace detail {

/// A material that knows by how much its shape has been strained.
template <class M>
struct Watched : M {
  template <class T>
  struct State : M::template State<T> {
    T strain{};  ///< sum of sqrt(2/3 d:d) dt, d = dev D: but for the volume no length has shrunk by more
  };

  template <class T>
  auto stress(State<T>& state, const typename M::Kinematics::template Rate<T>& rate, double dt) const {
    const SymmetricTensor<T> d = deviator(rate.rate_of_deformation);
    state.strain += T(dt) * sqrt((2.0 / 3.0) * double_dot(d, d));
    return M::stress(static_cast<typename M::template State<T>&>(state), rate, dt);
  }
  template <class T>
  auto stress(const State<T>& state) const {
    return M::stress(static_cast<const typename M::template State<T>&>(state));
  }
};

template <class E, class M>
concept Resisting = requires(const E e, typename E::template State<M, double> state, const M m,
                             const Nodal<double, E::nodes> x) {
  { e.resistance(state, m, x, x, 1.0)(x, x) } -> std::convertible_to<Nodal<double, E::nodes>>;
};
struct NoResistance {};
template <class E, class T>
struct ResistanceOf {
  using type = NoResistance;
};
template <class E, class T>
requires requires { typename E::template Resistance<T>; }
struct ResistanceOf<E, T> {
  using type = typename E::template Resistance<T>;
};

/// An element that knows its mass, the step that it allows alone, and what it was when the mesh was last asked.
template <class E, class M>
struct Bounded : E {
  static constexpr bool sound = Resisting<E, M>;
  static_assert(sound,
                "strike: GlobalStep needs an element with resistance(state, material, x, v, dt), such as Hex8; give "
                "yours one (see strike/element/hex8.hpp) or leave the step to ElementStep.");

  template <class W, class T>
  struct State : E::template State<W, T> {
    T nodal_mass{};
    T own_step{};         ///< at the last step
    T step_when_asked{};  ///< the same when the mesh was last asked; 0: was not among those asked
    T strain_when_asked{};
    typename ResistanceOf<E, T>::type resistance{};

    /// Not less than what any of its points has been strained.
    T strain() const {
      T sum = T(0.0);
      this->each_point([&](const auto& point) { sum += point.strain; });
      return sum;
    }
    /// What is left of the bound of those asked: no more than of its own, less what its shape may have lost.
    T share_left() const {
      return min(T(1.0), own_step / step_when_asked) * max(T(0.0), 1.0 - (strain() - strain_when_asked));
    }
  };

  template <class W, class T>
  T begin(State<W, T>& state, const W& material, const Nodal<T, E::nodes>& x) const {
    return state.nodal_mass = E::begin(state, material, x);
  }
  template <class W, class T>
  Response<T, E::nodes> advance(State<W, T>& state, const W& material, const Nodal<T, E::nodes>& x,
                                const Nodal<T, E::nodes>& v, double dt) const {
    Response<T, E::nodes> response = E::advance(state, material, x, v, dt);
    state.own_step = response.stable_step;
    return response;
  }
};

/// The largest eigenvalue of the symmetric tridiagonal matrix of these diagonals, from above to rounding: no pivot of T
/// - x I is positive for x above it (Sturm).
inline double largest_eigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const std::size_t n = diagonal.size();
  double lower = 0, upper = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double row = (i > 0 ? beside[i - 1] : 0) + (i + 1 < n ? beside[i] : 0);
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

/// How many steps of Lanczos's iteration from a random vector of n components leave the largest eigenvalue of a
/// positive matrix underestimated by more than the share `deviation` with a probability of at most `failure`: 1.648
/// sqrt(n) exp(-sqrt(deviation) (2 k - 1)) (Kuczynski and Wozniakowski 1992, theorem 4.2).
inline std::size_t lanczos_steps(std::size_t n, double deviation, double failure) {
  const double steps = std::log(1.648 * std::sqrt(static_cast<double>(n)) / failure) / std::sqrt(deviation);
  return std::min(n, static_cast<std::size_t>(std::ceil(0.5 * (steps + 1))));
}

}  // namespace detail

/// The stable step of the mesh as a whole, which is larger than that of its elements: their highest modes do not fit
/// together. It is found by Lanczos's iteration on the assembled mesh, of which only those elements take part that
/// would need smaller steps, and followed from element to element as the mesh deforms. The mesh is asked again when the
/// steps lost since amount to what that costs.
///   Explicit run{scene, options, GlobalStep{}};
struct GlobalStep {
  double deviation = 0.1;  ///< how far the iteration may stay below the eigenvalue: about twice what the step loses
  double failure = 1e-9;   ///< probability that it stays further below
  double price = 0.5;      ///< of an iteration, in steps

  template <class E, class M>
  using Element = detail::Bounded<E, M>;
  template <class M>
  using Material = detail::Watched<M>;
  template <class Real>
  class Running;
};

template <class Real>
class GlobalStep::Running {
 public:
  explicit Running(const GlobalStep& policy) : policy_(policy) {}

  template <class Things, class Execution>
  void extend(StableStep& stable, Nodes<Real>& nodes, Things& things, const Execution& execution) {
    const double own = stable.dt;
    const double allowed = std::max(own, allowed_step(things, execution));
    earned_ += allowed / own - 1;
    lost_ += 1 - allowed / (hope_ * own);
    stable.dt = allowed;
    if (lost_ < price_ * patience_) return;
    patience_ = earned_ < price_ ? 2 * patience_ : 1;
    refresh(own, nodes, things, execution);
    stable.dt = std::max(own, allowed_step(things, execution));
    earned_ = lost_ = 0;
  }

  /// How often the mesh was asked, and by how many products with its matrix.
  std::size_t refreshes() const { return refreshes_; }
  std::size_t products() const { return products_; }

 private:
  using Field = typename Nodes<Real>::Field;

  template <class Things, class F>
  static void each_part(Things& things, const F& f) {
    const auto ask = [&](auto& thing) {
      if constexpr (requires { thing.patches(); }) f(thing);
    };
    std::apply([&](auto&... thing) { (ask(thing), ...); }, things);
  }

  /// The step at which the strained mesh is still safe: those asked have together the bound of then, less what their
  /// own bounds and their shapes have lost; the others have their own.
  template <class Things, class Execution>
  double allowed_step(Things& things, const Execution& execution) {
    double allowed = std::numeric_limits<double>::infinity();
    each_part(things, [&](auto& part) {
      using T = std::decay_t<decltype(part.blocks()[0].state.own_step)>;
      least_.assign(part.patches().size(), 0);
      execution.for_each(part.patches().size(), [&](std::size_t p) {
        T least = T(std::numeric_limits<RealOf<T>>::max());
        for (std::size_t b = part.patches()[p].first_block; b < part.patches()[p].last_block; ++b) {
          const auto& state = part.blocks()[b].state;
          least = min(least, select(state.step_when_asked > 0.0, T(bound_) * state.share_left(), state.own_step));
        }
        least_[p] = static_cast<double>(reduce_min(least));
      });
      for (const double least : least_) allowed = std::min(allowed, least);
    });
    return allowed;
  }

  /// Asks the mesh.
  template <class Things, class Execution>
  void refresh(double own, Nodes<Real>& nodes, Things& things, const Execution& execution) {
    const double dt = hope_ * own;  // near what will be found, for the damping scales otherwise than the stiffness
    const double share = choose(1.1 * dt, dt, nodes, things);
    const std::size_t steps = detail::lanczos_steps(3 * places_.size(), policy_.deviation, policy_.failure);
    const double mu = lanczos(steps, nodes, things, execution) / (1 - policy_.deviation);
    bound_ = mu > 1 ? dt / mu : dt / std::sqrt(mu);  // mu(dt) grows at least as dt and at most as dt^2
    hope_ = std::clamp(bound_ / own, 1.02, 1.25 * hope_);
    price_ = 1 + policy_.price * share * static_cast<double>(steps);
    ++refreshes_;
  }

  /// Those to ask: the elements that would need a step below `target`, and their neighbours, with their own masses
  /// alone. The others are safe with what mass is left. Returns the share of those asked.
  template <class Things>
  double choose(double target, double dt, Nodes<Real>& nodes, Things& things) {
    std::vector<char> near(nodes.size(), 0);
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    each_part(things, [&](auto& part) {
      for (std::size_t b = 0; b < part.blocks().size(); ++b)
        for (std::size_t l = 0; l < part.count(b); ++l)
          if (static_cast<double>(lane(part.blocks()[b].state.own_step, l)) < target)
            for (const auto& corner : part.blocks()[b].nodes) near[place(corner[l])] = 1;
    });

    mass_.assign(nodes.size(), 0);
    std::size_t asked = 0, all = 0;
    each_part(things, [&](auto& part) {
      for (std::size_t b = 0; b < part.blocks().size(); ++b) {
        auto& [corners, state] = part.blocks()[b];
        using State = std::decay_t<decltype(state)>;
        using T = decltype(State::own_step);
        constexpr int n = std::decay_t<decltype(part.element())>::nodes;
        const T silent = T(std::numeric_limits<RealOf<T>>::max());
        state.step_when_asked = T(0.0);
        for (std::size_t l = 0; l < lanes<T>; ++l) {
          const bool is_near = std::any_of(corners.begin(), corners.end(), [&](const auto& c) { return near[place(c[l])]; });
          if (is_near) set_lane(state.step_when_asked, l, lane(state.own_step, l));
        }
        state.step_when_asked = select(state.own_step < silent, state.step_when_asked, T(0.0));
        if (!any(state.step_when_asked > 0.0)) continue;
        state.strain_when_asked = state.strain();
        const Nodal<T, n> x = gather_positions<T, n>(nodes.position(), corners), v = gather<T, n>(nodes.velocity(), corners);
        state.resistance = part.element().resistance(state, part.material(), x, v, dt);
        for (std::size_t l = 0; l < part.count(b); ++l)
          if (lane(state.step_when_asked, l) > 0) {
            ++asked;
            for (const auto& corner : corners) mass_[place(corner[l])] += lane(state.nodal_mass, l);
          }
      }
      all += part.size();
    });
    places_.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (mass_[i] > 0) places_.push_back(static_cast<Index>(i));
    return static_cast<double>(asked) / static_cast<double>(all);
  }

  /// The largest eigenvalue over the masses after so many steps of Lanczos's iteration, which approaches it from below.
  template <class Things, class Execution>
  double lanczos(std::size_t steps, Nodes<Real>& nodes, Things& things, const Execution& execution) {
    for (Field* field : {&now_, &before_, &product_}) field->assign(nodes.places(), {});
    for (const Index i : places_)
      for (int c = 0; c < 3; ++c)
        now_[i].x[c] = static_cast<Real>(
            detail::random_normal((refreshes_ << 40) + 4 * std::uint64_t{i} + static_cast<std::uint64_t>(c)) /
            std::sqrt(static_cast<double>(mass_[i])));

    std::vector<double> diagonal, beside;
    double norm = std::sqrt(sum(execution, [&](Index i) { return mass_[i] * squared(now_[i]); }));
    for (std::size_t k = 0; k < steps && norm > 0; ++k) {
      if (k > 0) beside.push_back(norm);
      const Real scale = static_cast<Real>(1 / norm), beta = static_cast<Real>(k > 0 ? norm : 0);
      sum(execution, [&](Index i) {
        for (int c = 0; c < 3; ++c) now_[i].x[c] *= scale, product_[i].x[c] = 0;
        return Real(0);
      });
      multiply(nodes, things, execution);  // product = -A now
      const double alpha = -sum(execution, [&](Index i) {
        return now_[i].x[0] * product_[i].x[0] + now_[i].x[1] * product_[i].x[1] + now_[i].x[2] * product_[i].x[2];
      });
      diagonal.push_back(alpha);
      norm = std::sqrt(sum(execution, [&](Index i) {
        const Real a = static_cast<Real>(alpha);
        for (int c = 0; c < 3; ++c)
          before_[i].x[c] = -product_[i].x[c] / mass_[i] - a * now_[i].x[c] - beta * before_[i].x[c];
        return mass_[i] * squared(before_[i]);
      }));
      std::swap(now_, before_);
    }
    return diagonal.empty() ? 0 : detail::largest_eigenvalue(diagonal, beside);
  }

  static Real squared(const Padded<Real>& a) { return a.x[0] * a.x[0] + a.x[1] * a.x[1] + a.x[2] * a.x[2]; }

  /// The sum of f(i) over the places of those asked, in an order that does not depend on the threads.
  template <class Execution, class F>
  double sum(const Execution& execution, const F& f) {
    least_.assign(detail::chunks(places_.size()), 0);
    detail::for_each_chunk(execution, places_.size(), [&](std::size_t k, std::size_t first, std::size_t last) {
      double mine = 0;
      for (std::size_t j = first; j < last; ++j) mine += static_cast<double>(f(places_[j]));
      least_[k] = mine;
    });
    double all = 0;
    for (const double mine : least_) all += mine;
    return all;
  }

  /// Subtracts the resistance of those asked against the field `now_` from `product_`.
  template <class Things, class Execution>
  void multiply(Nodes<Real>& nodes, Things& things, const Execution& execution) {
    ++products_;
    each_part(things, [&](auto& part) {
      using T = std::decay_t<decltype(part.blocks()[0].state.own_step)>;
      constexpr std::size_t n = std::decay_t<decltype(part)>::n;
      execution.for_each(part.patches().size(), [&](std::size_t p) {
        const detail::Patch& patch = part.patches()[p];
        part.patches().refresh(patch, now_, product_);
        for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
          const auto& [corners, state] = part.blocks()[b];
          const auto asked = state.step_when_asked > 0.0;
          if (!any(asked)) continue;
          const auto masked = [&](const T& f) -> T { return select(asked, f, T(0.0)); };
          const Nodal<T, n> x = gather_positions<T, n>(nodes.position(), corners), p_b = gather<T, n>(now_, corners);
          const Nodal<T, n> f = state.resistance(x, p_b).unaryExpr(masked);
          scatter_subtract<T, n>(f, product_, corners, part.count(b));
        }
      });
      part.patches().gather(product_, execution);
    });
  }

  GlobalStep policy_;
  double bound_ = 0;     // of those asked, when they were asked
  double hope_ = 1.3;    // the step of the mesh over that of its elements
  double lost_ = 0, earned_ = 0, price_ = 0, patience_ = 1;  // in steps
  std::size_t refreshes_ = 0, products_ = 0;
  std::vector<Index> places_;  // of the nodes of those asked, and their masses
  std::vector<Real> mass_;
  Field now_, before_, product_;
  std::vector<double> least_;
};

}  // namespace strike
