#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/estimated_blocks.hpp>
#include <strike/dynamics/lanczos.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/dynamics/running_part.hpp>
#include <strike/dynamics/step_bound.hpp>
#include <strike/element/element.hpp>
#include <strike/motion/execution.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The stable step of the mesh as a whole: larger than that of its elements alone, whose highest modes do not fit
/// together. Lanczos's iteration estimates it on the elements that would need smaller steps; it is then followed from
/// element to element as the mesh deforms, and estimated anew when the steps lost since amount to its price.
///   Explicit run{scene, GlobalStep{}};
struct GlobalStep {
  double failure = 1e-9;    ///< probability that an estimate is less safe than it says
  double deviation = 0.15;  ///< relative tolerance of the iteration with all elements; with a share s of them it is
                            ///< s^(2/3) of that, for they cost less. The step loses about half of it.
  double price = 0.5;       ///< of an iteration with all elements, in steps

  void ranges(const auto& number) const {
    number("failure", failure, Range{.low = 0, .high = 1});
    number("deviation", deviation, Range{.low = 0, .high = 1});
    number("price", price, range::not_negative);
  }

  template <class E>
  using Element = detail::Bounded<E>;
  template <class M>
  using Material = detail::Watched<M>;
  template <class E, class M>
  static constexpr bool suits = detail::Resisting<E, M>;
  template <class Nodes, class Items>
  class Running;
};

/// The bound at work.
template <class Nodes, class Items>
class GlobalStep::Running {
 public:
  explicit Running(const GlobalStep& policy) : policy_(policy) {}

  template <class Execution>
  void extend(StableStep& stable, Nodes& nodes, Items& items, const Execution& execution) {
    const double own = stable.dt;
    if (!std::isfinite(own)) return;  // nothing is left that resists
    stable.dt = std::max(own, allowed_step(items, execution));
    earned_ += stable.dt / own - 1;
    lost_ += 1 - stable.dt / (hope_ * own);
    if (lost_ < patience_ * price_) return;
    patience_ = earned_ < price_ ? 2 * patience_ : 1;
    estimate(own, nodes, items, execution);
    stable.dt = std::max(own, allowed_step(items, execution));
    lost_ = earned_ = 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bound_, hope_, lost_, earned_, price_, patience_, estimates_, products_, blocks_.all());
  }

  /// Number of estimates so far, and of products with the matrix of the mesh in them.
  std::size_t estimates() const { return estimates_; }
  std::size_t products() const { return products_; }

 private:
  using Field = std::decay_t<decltype(std::declval<Nodes&>().motion().position)>;
  using Vector = typename Field::value_type;
  using Real = RealOf<Vector>;

  /// f(part, its blocks at the last estimate).
  template <class F>
  void each_part(Items& items, const F& f) {
    const auto visit = [&](auto& item, auto& estimated) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(estimated)>, detail::NoPart>) f(item, estimated);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (visit(std::get<i>(items), std::get<i>(blocks_)), ...);
    }(std::make_index_sequence<std::tuple_size_v<Items>>{});
  }

  /// The step that the mesh allows as it stands: by what is left of the bound of elements in the estimate, and by the
  /// other elements' own.
  template <class Execution>
  double allowed_step(Items& items, const Execution& execution) {
    double rate = 0;
    each_part(items, [&](auto& part, auto& estimated) {
      estimated.resize(part.blocks().size());
      sums_.resize(part.patches().size());
      execution.for_each(sums_.size(), [&](std::size_t p) {
        const detail::Patch& patch = part.patches()[p];
        auto largest = estimated[patch.first_block].critical_rate(part.blocks()[patch.first_block].state, 1 / bound_);
        for (std::size_t b = patch.first_block + 1; b < patch.last_block; ++b)
          largest = max(largest, estimated[b].critical_rate(part.blocks()[b].state, 1 / bound_));
        sums_[p] = static_cast<double>(reduce_max(largest));
      });
      for (const double largest : sums_) rate = std::max(rate, largest);
    });
    return 1 / rate;
  }

  /// Estimates the bound anew; `own` is the least step of an element.
  template <class Execution>
  void estimate(double own, Nodes& nodes, Items& items, const Execution& execution) {
    const double dt = hope_ * own;  // near what will be found, for damping scales otherwise than stiffness
    const double share = choose(1.2 * dt, dt, nodes, items);
    const double below = std::max(policy_.deviation * std::cbrt(share * share), 0.005);
    const std::size_t steps = detail::lanczos_steps(3 * places_.size(), below, policy_.failure);
    const double mu =
        lanczos_.largest_eigenvalue(steps, estimates_, nodes.places(), places_, mass_, execution,
                                    [&](Field& q, Field& product) { resist(q, product, nodes, items, execution); }) /
        (1 - below);
    bound_ = mu > 1 ? dt / mu : dt / std::sqrt(mu);  // mu(dt) falls at least as dt and grows at most as dt^2
    hope_ = std::clamp(bound_ / own, 1.02, 1.25 * hope_);
    price_ = 1 + policy_.price * share * static_cast<double>(steps);
    ++estimates_;
  }

  /// Chooses the elements of the estimate: those whose own step is below `target`, and their neighbours. They have only
  /// their own masses, so that the others are safe with theirs. Returns their share of all.
  double choose(double target, double dt, Nodes& nodes, Items& items) {
    std::vector<bool> near(nodes.size());
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    each_part(items, [&](const auto& part, const auto&) {
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
    each_part(items, [&](auto& part, auto& estimated) {
      auto& mine = patches_.emplace_back();
      for (std::size_t p = 0; p < part.patches().size(); ++p) {
        const std::size_t before = chosen;
        for (std::size_t b = part.patches()[p].first_block; b < part.patches()[p].last_block; ++b)
          chosen += choose_in(part, estimated[b], b, dt, nodes, near);
        if (chosen > before) mine.push_back(p);
      }
      all += part.size();
    });
    places_.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (mass_[i] > 0) places_.push_back(static_cast<Index>(i));
    return static_cast<double>(chosen) / static_cast<double>(all);
  }

  /// The same in block b; failed elements have no rate and no part in the estimate.
  template <class Part, class E, class T>
  std::size_t choose_in(const Part& part, detail::EstimatedBlock<E, T>& estimated, std::size_t b, double dt,
                        Nodes& nodes, const std::vector<bool>& near) {
    const auto& corners = part.blocks()[b].nodes;
    const auto& state = part.blocks()[b].state;
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    const auto is_near = [&](std::size_t l) {
      return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) { return near[place(corner[l])]; });
    };
    estimated.rate = T(0.0);
    for (std::size_t l = 0; l < lanes<T>; ++l)
      if (is_near(l)) set_lane(estimated.rate, l, lane(state.own_rate, l));
    if (!any(estimated.rate > 0.0)) return 0;

    estimated.strain = state.strain();
    estimated.resistance =
        part.element().resistance(state, part.material(), gather<T, Part::n>(nodes.motion().position, corners),
                                  gather<T, Part::n>(nodes.motion().velocity, corners), dt);
    std::size_t count = 0;
    for (std::size_t l = 0; l < part.count(b); ++l)
      if (lane(estimated.rate, l) > 0) {
        ++count;
        for (const auto& corner : corners) mass_[place(corner[l])] += lane(estimated.resistance.mass, l);
      }
    return count;
  }

  /// product -= A q, with the ghosts of both.
  template <class Execution>
  void resist(Field& q, Field& product, Nodes& nodes, Items& items, const Execution& execution) {
    ++products_;
    auto patches = patches_.begin();
    each_part(items, [&](const auto& part, const auto& estimated) {
      execution.for_each(patches->size(), [&, &mine = *patches](std::size_t k) {
        resist(part, estimated, part.patches()[mine[k]], nodes, q, product);
      });
      for (const std::size_t p : *patches) part.patches().gather(part.patches()[p], product);
      ++patches;
    });
  }
  template <class Part, class E, class T>
  [[gnu::flatten]] void resist(const Part& part, const std::vector<detail::EstimatedBlock<E, T>>& blocks,
                               const detail::Patch& patch, Nodes& nodes, Field& q, Field& product) {
    constexpr std::size_t n = Part::n;
    part.patches().refresh(patch, q, product);
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      const auto estimated = blocks[b].rate > 0.0;
      if (!any(estimated)) continue;
      const auto& corners = part.blocks()[b].nodes;
      const Nodal<T, static_cast<int>(n)> f =
          blocks[b].resistance(gather<T, n>(nodes.motion().position, corners), gather<T, n>(q, corners));
      scatter_subtract<T, n>(f.unaryExpr([&](const T& f_i) -> T { return select(estimated, f_i, T(0.0)); }).eval(),
                             product, corners, part.count(b));
    }
  }

  GlobalStep policy_;
  double bound_ = 1;                                         // of the elements in the estimate, at its time
  double hope_ = 1.3;                                        // expected ratio of that to the least of their own
  double lost_ = 0, earned_ = 0, price_ = 0, patience_ = 1;  // [steps]
  std::size_t estimates_ = 0, products_ = 0;
  detail::EstimatedBlocks<Items> blocks_;
  std::vector<std::vector<std::size_t>> patches_;  // of each part, those with elements in the estimate
  std::vector<Index> places_;                      // of the nodes of these elements
  std::vector<Real> mass_;                         // place by place, of these elements alone
  detail::Lanczos<Vector> lanczos_;
  std::vector<double> sums_;
};

}  // namespace strike
