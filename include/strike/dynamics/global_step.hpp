#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/estimated_blocks.hpp>
#include <strike/dynamics/lanczos.hpp>
#include <strike/dynamics/mesh_resistance.hpp>
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
    archive(bound_, hope_, lost_, earned_, price_, patience_, estimates_, products_, parts_.all());
  }

  /// Number of estimates so far, and of products with the matrix of the mesh in them.
  std::size_t estimates() const { return estimates_; }
  std::size_t products() const { return products_; }

 private:
  using Mesh = detail::MeshResistance<Nodes, Items>;

  /// The step that the mesh allows as it stands: by what is left of the bound of elements in the estimate, and by the
  /// other elements' own.
  template <class Execution>
  double allowed_step(Items& items, const Execution& execution) {
    double rate = 0;
    parts_.each_part(items, [&](auto& part, auto& estimated) {
      auto& blocks = estimated.blocks;
      blocks.resize(part.blocks().size());
      sums_.resize(part.patches().size());
      execution.for_each(sums_.size(), [&](std::size_t p) {
        const detail::Patch& patch = part.patches()[p];
        auto largest = blocks[patch.first_block].critical_rate(part.blocks()[patch.first_block].state, 1 / bound_);
        for (std::size_t b = patch.first_block + 1; b < patch.last_block; ++b)
          largest = max(largest, blocks[b].critical_rate(part.blocks()[b].state, 1 / bound_));
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
    const double share = mesh_.choose(1.2 * dt, dt, nodes, items, parts_);
    const double below = std::max(policy_.deviation * std::cbrt(share * share), 0.005);
    const std::size_t steps = detail::lanczos_steps(mesh_.size(), below, policy_.failure);
    using Fields = typename Mesh::Fields;
    const double mu = lanczos_.largest_eigenvalue(steps, estimates_, nodes.places(), mesh_.masses(), execution,
                                                  [&](Fields& q, Fields& product) {
                                                    ++products_;
                                                    mesh_.subtract_product(q, product, nodes, items, parts_, execution);
                                                  }) /
                      (1 - below);
    bound_ = mu > 1 ? dt / mu : dt / std::sqrt(mu);  // mu(dt) falls at least as dt and grows at most as dt^2
    hope_ = std::clamp(bound_ / own, 1.02, 1.25 * hope_);
    price_ = 1 + policy_.price * share * static_cast<double>(steps);
    ++estimates_;
  }

  GlobalStep policy_;
  double bound_ = 1;                                         // of the elements in the estimate, at its time
  double hope_ = 1.3;                                        // expected ratio of that to the least of their own
  double lost_ = 0, earned_ = 0, price_ = 0, patience_ = 1;  // [steps]
  std::size_t estimates_ = 0, products_ = 0;
  detail::EstimatedParts<Items> parts_;
  Mesh mesh_;
  typename Mesh::Iteration lanczos_;
  std::vector<double> sums_;
};

}  // namespace strike
