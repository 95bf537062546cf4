#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
  double failure = 1e-6;  ///< probability that an estimate is less safe than it says
  double price = 0.3;     ///< of a product with the matrix of all elements, in steps

  void ranges(const auto& number) const {
    number("failure", failure, Range{.low = 0, .high = 1});
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
    ++age_;
    stable.dt = std::max(own, allowed_step(items));
    earned_ += stable.dt / own - 1;
    lost_ += 1 - stable.dt / (hope_ * own);
    if (lost_ < patience_ * price_) return;
    patience_ = earned_ < price_ ? 2 * patience_ : 1;
    estimate(own, nodes, items, execution);
    stable.dt = std::max(own, 1 / std::max(1 / bound_, mesh_.rate_of_others()));
    age_ = lost_ = earned_ = 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bound_, hope_, age_, lost_, earned_, price_, patience_, estimates_, products_);
  }

  /// Number of estimates so far, and of products with the matrix of the mesh in them.
  std::size_t estimates() const { return estimates_; }
  std::size_t products() const { return products_; }

 private:
  using Mesh = detail::MeshResistance<Nodes, Items>;

  /// The step that the mesh allows as it stands, by the other elements' own and by what is left of the bound of those
  /// in the estimate: their critical rate has grown as that of each alone, and by the length that its shape may have
  /// lost.
  double allowed_step(Items& items) {
    double rate = 0;
    parts_.each_part(items, [&](const auto& part, const auto&) {
      for (const detail::Outcome& outcome : part.outcomes()) {
        const auto& [ratio, strain, others] = outcome.growth;
        rate = std::max({rate, others, ratio > 0 ? std::max(1.0, ratio) / (bound_ * std::max(0.0, 1 - strain)) : 0});
      }
    });
    return 1 / rate;
  }

  /// Estimates the bound anew; `own` is the least step of an element. Damping scales otherwise than stiffness, so that
  /// the estimate must be made near the step that will be found, and rather below it.
  template <class Execution>
  void estimate(double own, Nodes& nodes, Items& items, const Execution& execution) {
    double dt = 0.95 * hope_ * own, mu = 1,
           theta = 1;  // mu is not exceeded by the largest eigenvalue, nor theta in excess
    std::size_t products = 0;
    for (int trial = 0; trial < 3; ++trial) {
      const double share = mesh_.choose(1.25 * dt, dt, nodes, items, parts_);
      const double price_of_product = policy_.price * share, life = std::max(age_, 30.0);
      std::size_t k = 0;
      using Fields = typename Mesh::Fields;
      lanczos_.iterate(
          estimates_++, nodes.places(), mesh_.masses(), execution,
          [&](Fields& q, Fields& product) { mesh_.subtract_product(q, product, nodes, items, parts_, execution); },
          [&](const std::vector<double>& diagonal, const std::vector<double>& beside) {
            if (++k % 4 > 0 && k < mesh_.size()) return false;
            theta = detail::largest_eigenvalue(diagonal, {beside.begin(), beside.end() - 1});
            mu = detail::eigenvalue_bound(diagonal, beside, mesh_.size(), policy_.failure);
            const bool is_far = trial < 2 && k == 8 && !(theta > 0.6 && theta < 1.05);
            return is_far ||
                   life * (mu / theta - 1) < price_of_product * static_cast<double>(k);  // mu - theta falls as 1/k^2
          });
      products += k;
      price_ = 1 + price_of_product * static_cast<double>(products);
      if (theta > 0.6 && theta < 1.05) break;
      dt /= std::sqrt(1.2 * theta);
    }
    const auto step_at = [&](double eigenvalue) {  // mu(dt) falls at least as dt and grows at most as dt^2
      return eigenvalue > 1 ? dt / eigenvalue : dt / std::sqrt(eigenvalue);
    };
    bound_ = step_at(mu);
    hope_ = std::max(1.02, step_at(theta) / own);
    products_ += products;
  }

  GlobalStep policy_;
  double bound_ = std::numeric_limits<double>::infinity();  // of the elements in the estimate, at its time
  double hope_ = 1.3;                                       // expected ratio of that to the least of their own
  double age_ = 200, lost_ = 0, earned_ = 0, price_ = 0, patience_ = 1;  // [steps]
  std::size_t estimates_ = 0, products_ = 0;
  detail::EstimatedParts<Items> parts_;
  Mesh mesh_;
  typename Mesh::Iteration lanczos_;
};

}  // namespace strike
