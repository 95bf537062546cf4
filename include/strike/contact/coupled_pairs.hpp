#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Pairs that share nodes, whose impulses change each other's velocities. Pairs are served side by side, each of which
/// writes what is its own; then nodes, each of which collects from its pairs in their order: no result depends on
/// threads. The velocities are its own until `end`.
class CoupledPairs {
 public:
  template <class Execution>
  CoupledPairs(std::span<const ContactPair> pairs, const ContactNodes& nodes, const Execution& execution)
      : nodes_(nodes), pairs_(pairs), rows_(pairs.size()) {
    number_nodes();
    velocity_.resize(number_.size());
    each_node(execution, [&](std::size_t k) { velocity_[k] << nodes.v[number_[k]], nodes.inverse_mass(number_[k]); });
    if (!on_bodies_.empty()) given_.assign(pairs.size(), Eigen::Vector3d::Zero());
  }
  /// Gives the velocities to the nodes.
  template <class Execution>
  void end(ContactNodes& nodes, const Execution& execution) const {
    each_node(execution, [&](std::size_t k) { nodes.v[number_[k]] = velocity_[k].head<3>(); });
  }

  /// The normal velocity of the points of pair p relative to each other, and the whole of it.
  double approach(std::size_t p) const { return rows_[p].normal.dot(sum(p)); }
  Eigen::Vector3d velocity(std::size_t p) const { return sum(p).head<3>(); }

  /// Calls f(p) for all pairs.
  template <class Execution, class F>
  void each(const Execution& execution, const F& f) const {
    side_by_side(execution, blocks(rows_.size()), [&](std::size_t b) { each_of_block(b, f); });
  }
  /// Calls f(p) for the pairs that have nodes of rigid bodies, one after the other.
  template <class F>
  void each_on_bodies(const F& f) const {
    for (const std::size_t p : on_bodies_) f(p);
  }
  /// The largest f(p) of all pairs.
  template <class Execution, class F>
  double largest(const Execution& execution, const F& f) const {
    std::vector<double> most(blocks(rows_.size()), 0.0);
    side_by_side(execution, most.size(),
                 [&](std::size_t b) { each_of_block(b, [&](std::size_t p) { most[b] = std::max(most[b], f(p)); }); });
    return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
  }

  /// Changes the velocities by the impulse of each pair, a number along its normal or a vector [force time].
  template <class Execution, class Impulse>
  void give(const Execution& execution, const std::vector<Impulse>& impulses) {
    each_node(execution, [&](std::size_t k) {
      if (is_rigid(k)) return;
      Eigen::Vector4d impulse = sum_of_shares(k, impulses), &v = velocity_[k];
      if (is_held_[k]) impulse.head<3>() = nodes_.free(number_[k], impulse.head<3>());
      v += v[3] * impulse;
    });
    for (const std::size_t p : on_bodies_) given_[p] += vector(p, impulses[p]).template head<3>();
    if (!on_bodies_.empty()) move_bodies();
  }
  /// Takes back the impulses that all pairs have got, and sets them to none.
  template <class Execution, class Impulse>
  void take_back(const Execution& execution, std::vector<Impulse>& impulses, const Impulse& none) {
    for (Impulse& J : impulses) J = -J;
    give(execution, impulses);
    std::fill(impulses.begin(), impulses.end(), none);
  }
  /// Calls f(node, impulse) for the nodes of pairs with what they get by the impulse of each pair.
  template <class Execution, class Impulse, class F>
  void each_share(const Execution& execution, const std::vector<Impulse>& impulses, const F& f) const {
    each_node(execution,
              [&](std::size_t k) { f(number_[k], Eigen::Vector3d(sum_of_shares(k, impulses).template head<3>())); });
  }
  /// For each node the sum of f(node, p, weight) over its pairs, by places that largest_at_nodes() knows.
  template <class Execution, class F>
  std::vector<double> sums_at_nodes(const Execution& execution, const F& f) const {
    std::vector<double> sums(number_.size(), 0.0);
    each_node(execution, [&](std::size_t k) {
      for (const Share& share : shares(k)) sums[k] += f(number_[k], share.pair, share.weight);
    });
    return sums;
  }
  /// The largest of them at the nodes of pair p.
  double largest_at_nodes(const std::vector<double>& sums, std::size_t p) const {
    double most = 0;
    for (const Index k : rows_[p].nodes) most = std::max(most, sums[k]);
    return most;
  }

  /// The impulses of all pairs together, numbers along their normals or vectors, from those that they have got: each is
  /// what `allowed(p, J)` makes of the J that would give the pair the velocity `missing(p)`. Accelerated projected
  /// gradients (Nesterov 1983), which begin anew when they turn back (O'Donoghue and Candes 2015), as Mazhar, Heyn,
  /// Negrut and Tasora (2015) solve contact: all pairs at once, so that their order does not count, however few
  /// iterations they are given. They end when no pair misses more than `enough` [velocity], or after `most` iterations.
  template <class Impulse, class Execution, class Missing, class Allowed>
  void settle(const Execution& execution, std::vector<Impulse>& impulses, double enough, int most,
              const Missing& missing, const Allowed& allowed) {
    constexpr bool along_normals = std::is_same_v<Impulse, double>;
    const std::vector<double> response = responses<along_normals>(execution);
    std::vector<double> inverse(response.size());
    for (std::size_t p = 0; p < response.size(); ++p) inverse[p] = 1 / response[p];
    std::vector<Impulse> at = impulses, next = impulses;  // the velocities are those of `at`
    std::vector<Eigen::Vector4d> more(impulses.size());
    std::vector<OfBlock> of_block(blocks(rows_.size()));
    // All that a block calls in one function: its loops take most of the time.
    const auto ask = [&](std::size_t b) __attribute__((__flatten__)) {
      OfBlock sum;
      for (std::size_t i = first(b); i < last(b, order_.size()); ++i) {
        const std::size_t p = order_[i];
        if (!(response[p] > 0)) continue;
        next[p] = allowed(p, Impulse(at[p] + inverse[p] * missing(p)));
        const Impulse back = at[p] - next[p];
        sum.missed = std::max(sum.missed, response[p] * size(back));
        sum.turned += response[p] * product(back, Impulse(next[p] - impulses[p]));
      }
      of_block[b] = sum;
    };
    double momentum = 1;
    for (int iteration = 1; iteration <= most; ++iteration) {
      side_by_side(execution, of_block.size(), ask);
      OfBlock all;
      for (const OfBlock& sum : of_block) all.missed = std::max(all.missed, sum.missed), all.turned += sum.turned;
      const bool ends = !(all.missed > enough) || iteration == most;
      if (all.turned > 0) momentum = 1;
      const double before = momentum;
      momentum = 0.5 * (1 + std::sqrt(1 + 4 * before * before));
      const double beyond = ends ? 0 : (before - 1) / momentum;
      each(execution, [&](std::size_t p) {
        const Impulse there = next[p] + beyond * (next[p] - impulses[p]);
        more[p] = vector(p, Impulse(there - at[p])), impulses[p] = next[p], at[p] = there;
      });
      give(execution, more);
      if (ends) return;
    }
  }

 private:
  static constexpr std::size_t per_block = 64;

  /// The largest velocity that a pair of a block misses, and a sum that is positive when the iteration turns back.
  struct OfBlock {
    double missed = 0, turned = 0;
  };
  /// The part of a pair that all iterations read. One of fewer nodes has its first once more, without a weight.
  struct Row {
    Eigen::Vector4d normal;  // and 0
    std::array<double, 5> weights;
    std::array<Index, 5> nodes;  // by their places among those of all pairs
    bool is_held, yields;
  };
  /// The part of a node in a pair.
  struct Share {
    std::size_t pair;
    double weight;
  };

  static double size(double J) { return std::abs(J); }
  static double size(const Eigen::Vector3d& J) { return J.norm(); }
  static double product(double a, double b) { return a * b; }
  static double product(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.dot(b); }

  /// Calls f(0), ..., f(n - 1) for blocks: in turns where they are so few that threads would cost more than they save.
  template <class Execution, class F>
  static void side_by_side(const Execution& execution, std::size_t n, const F& f) {
    constexpr std::size_t few = 4;
    if (n < few)
      Serial{}.for_each(n, f);
    else
      execution.for_each(n, f);
  }
  /// Calls f(p) for the pairs of a block.
  template <class F>
  void each_of_block(std::size_t b, const F& f) const {
    for (std::size_t i = first(b); i < last(b, order_.size()); ++i) f(order_[i]);
  }
  /// Calls f(k) for the nodes, by their places.
  template <class Execution, class F>
  void each_node(const Execution& execution, const F& f) const {
    side_by_side(execution, blocks(number_.size()), [&](std::size_t b) {
      for (std::size_t k = first(b); k < last(b, number_.size()); ++k) f(k);
    });
  }
  std::span<const Share> shares(std::size_t k) const {
    return std::span(shares_).subspan(first_share_[k], first_share_[k + 1] - first_share_[k]);
  }
  /// The impulse that a node gets by those of its pairs.
  template <class Impulse>
  Eigen::Vector4d sum_of_shares(std::size_t k, const std::vector<Impulse>& impulses) const {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (const Share& share : shares(k)) sum += share.weight * vector(share.pair, impulses[share.pair]);
    return sum;
  }

  /// For each pair p a bound D of what impulses do to it [1/mass], so that D - A is positive semidefinite, where A_pq
  /// is the velocity of p by a unit impulse of q; 0 if conditions hold it. D_p = sum of |A_pq| w_p/w_q with w = 1/m* of
  /// each pair (Perron): w_p if it shares no node, and the same for a model cut at a plane of symmetry.
  template <bool along_normals, class Execution>
  std::vector<double> responses(const Execution& execution) {
    std::vector<double> of_pair(rows_.size());
    const std::vector<OnBody> on_bodies = responses_of_bodies<along_normals>();
    for (const OnBody& on : on_bodies) of_pair[on.pair] += on.response * on.response;
    each(execution, [&](std::size_t p) {
      const Row& row = rows_[p];
      double own = 0, free = 0;
      for (std::size_t i = 0; i < 5; ++i) {
        own += square(response<along_normals>(row, row.nodes[i], row.weights[i]));
        if (!is_rigid(row.nodes[i])) free += square(row.weights[i]) * velocity_[row.nodes[i]][3];
      }
      of_pair[p] = row.yields ? of_pair[p] + (own > 1e-6 * free ? own : 0) : 0;
    });
    std::vector<double> at_node(number_.size(), 0.0);
    each_node(execution, [&](std::size_t k) {
      for (const Share& share : shares(k))
        if (of_pair[share.pair] > 0)
          at_node[k] +=
              response<along_normals>(rows_[share.pair], static_cast<Index>(k), share.weight) / of_pair[share.pair];
    });
    std::vector<double> at_body(nodes_.bodies().all().size(), 0.0),
        by_bodies(on_bodies.empty() ? 0 : rows_.size(), 0.0);
    for (const OnBody& on : on_bodies)
      if (of_pair[on.pair] > 0) at_body[on.body] += on.response / of_pair[on.pair];
    for (const OnBody& on : on_bodies) by_bodies[on.pair] += on.response * at_body[on.body];
    each(execution, [&](std::size_t p) {
      const Row& row = rows_[p];
      double sum = by_bodies.empty() ? 0 : by_bodies[p];
      for (std::size_t i = 0; i < 5; ++i)
        sum += response<along_normals>(row, row.nodes[i], row.weights[i]) * at_node[row.nodes[i]];
      of_pair[p] *= sum;
    });
    return of_pair;
  }
  /// The root of the velocity that a unit impulse on a pair, along its normal or in any direction, gives it by moving a
  /// rigid body.
  struct OnBody {
    std::size_t pair, body;
    double response;
  };
  template <bool along_normals>
  std::vector<OnBody> responses_of_bodies() const {
    std::vector<OnBody> all;
    each_on_bodies([&](std::size_t p) {
      const auto along = [&](const Eigen::Vector3d& a, const auto& f) {
        pairs_[p].on_bodies(nodes_, a).each_response(nodes_.bodies(), f);
      };
      const std::size_t first = all.size();
      along(pairs_[p].normal, [&](std::size_t b, double response) { all.push_back({p, b, response}); });
      if constexpr (!along_normals) {  // the trace bounds the largest
        for (std::size_t k = first; k < all.size(); ++k) all[k].response = 0;
        for (const int axis : {0, 1, 2}) {
          std::size_t k = first;
          along(Eigen::Vector3d::Unit(axis), [&](std::size_t, double response) { all[k++].response += response; });
        }
      }
      for (std::size_t k = first; k < all.size(); ++k) all[k].response = std::sqrt(all[k].response);
    });
    return all;
  }
  /// |w| sqrt(1/m) of a node of a pair, with the 1/m that conditions leave along its normal, or in any direction; 0 of
  /// nodes of rigid bodies.
  template <bool along_normals>
  double response(const Row& row, Index k, double weight) const {
    double inverse_mass = velocity_[k][3];
    if (row.is_held) {
      const Index node = number_[k];
      if (nodes_.is_rigid(node))
        inverse_mass = 0;
      else if (along_normals)
        inverse_mass = nodes_.inverse_mass_along(node, row.normal.template head<3>());
      else if (nodes_.is_held_fast(node))
        inverse_mass = 0;
    }
    return std::abs(weight) * std::sqrt(inverse_mass);
  }
  static double square(double a) { return a * a; }

  static std::size_t blocks(std::size_t n) { return (n + per_block - 1) / per_block; }
  static std::size_t first(std::size_t b) { return b * per_block; }
  static std::size_t last(std::size_t b, std::size_t n) { return std::min((b + 1) * per_block, n); }

  /// The impulse on a pair, and 0.
  Eigen::Vector4d vector(std::size_t p, double J) const { return J * rows_[p].normal; }
  Eigen::Vector4d vector(std::size_t, const Eigen::Vector3d& J) const { return {J[0], J[1], J[2], 0}; }
  const Eigen::Vector4d& vector(std::size_t, const Eigen::Vector4d& J) const { return J; }
  /// The relative velocity, and a number without a meaning.
  Eigen::Vector4d sum(std::size_t p) const {
    const auto& [w, nodes] = std::tie(rows_[p].weights, rows_[p].nodes);
    // In two sums, neither of which waits for the other.
    const Eigen::Vector4d one = w[0] * velocity_[nodes[0]] + w[2] * velocity_[nodes[2]] + w[4] * velocity_[nodes[4]],
                          other = w[1] * velocity_[nodes[1]] + w[3] * velocity_[nodes[3]];
    return one + other;
  }
  bool is_rigid(std::size_t k) const { return !on_bodies_.empty() && nodes_.is_rigid(number_[k]); }
  /// Gives the nodes of rigid bodies the velocities that follow from all impulses, in the order of the pairs.
  void move_bodies() {
    const ContactBodies& bodies = nodes_.bodies();
    std::vector<Eigen::Vector3d> impulse(bodies.all().size(), Eigen::Vector3d::Zero()), of_moment = impulse;
    for (const std::size_t p : on_bodies_)
      for (std::size_t k = 0; k < 5; ++k) {
        const Index i = number_[rows_[p].nodes[k]];
        if (rows_[p].weights[k] == 0 || !nodes_.is_rigid(i)) continue;
        const Eigen::Vector3d J = rows_[p].weights[k] * given_[p];
        impulse[bodies.of(i)] += J;
        of_moment[bodies.of(i)] += cross(Eigen::Vector3d(nodes_.x[i] - bodies.centre(i)), J);
      }
    for (std::size_t b = 0; b < impulse.size(); ++b) {
      const RigidMotion& motion = *bodies.all()[b].motion;
      impulse[b] = motion.velocity_by(impulse[b]), of_moment[b] = motion.spin_by(of_moment[b]);
    }
    for (std::size_t k = 0; k < number_.size(); ++k) {
      const Index i = number_[k];
      if (!nodes_.is_rigid(i)) continue;
      const std::size_t b = bodies.of(i);
      velocity_[k].head<3>() =
          nodes_.v[i] + impulse[b] + cross(of_moment[b], Eigen::Vector3d(nodes_.x[i] - bodies.centre(i)));
    }
  }

  /// Pairs by their least node, so that those that share nodes, on either side, stand together.
  void find_order() {
    std::vector<std::pair<Index, std::size_t>> least(pairs_.size());
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      least[p] = {*std::min_element(pairs_[p].nodes.begin(), pairs_[p].nodes.begin() + pairs_[p].count), p};
    std::sort(least.begin(), least.end());
    order_.resize(least.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = least[i].second;
  }
  /// Sets the rows and the shares of each node.
  void number_nodes() {
    constexpr Index none = std::numeric_limits<Index>::max();
    std::vector<Index> place(nodes_.size(), none);
    find_order();
    for (const std::size_t p : order_) {
      const ContactPair& pair = pairs_[p];
      Row& row = rows_[p];
      row.normal << pair.normal, 0;
      row.weights = pair.weights, row.is_held = false, row.yields = true;
      bool is_on_body = false;
      for (unsigned k = 0; k < pair.count; ++k) {
        Index& at = place[pair.nodes[k]];
        if (at == none)
          at = static_cast<Index>(number_.size()), number_.push_back(pair.nodes[k]),
          is_held_.push_back(nodes_.is_held(pair.nodes[k]));
        row.nodes[k] = at;
        is_on_body = is_on_body || nodes_.is_rigid(pair.nodes[k]);
        row.is_held = row.is_held || is_on_body || is_held_[at];
      }
      if (is_on_body) on_bodies_.push_back(p), row.yields = pair.inverse_effective_mass > 0;
      std::fill(row.nodes.begin() + pair.count, row.nodes.end(), row.nodes[0]);
      std::fill(row.weights.begin() + pair.count, row.weights.end(), 0.0);
    }
    first_share_.assign(number_.size() + 2, 0);
    for (std::size_t p = 0; p < rows_.size(); ++p)
      for (unsigned k = 0; k < pairs_[p].count; ++k) ++first_share_[rows_[p].nodes[k] + 2];
    std::partial_sum(first_share_.begin(), first_share_.end(), first_share_.begin());
    shares_.resize(first_share_.back());
    for (std::size_t p = 0; p < rows_.size(); ++p)
      for (unsigned k = 0; k < pairs_[p].count; ++k)
        shares_[first_share_[rows_[p].nodes[k] + 1]++] = {p, rows_[p].weights[k]};
  }

  const ContactNodes& nodes_;
  std::span<const ContactPair> pairs_;
  std::vector<Row> rows_;
  std::vector<std::size_t> order_;         // in which pairs are served
  std::vector<Index> number_;              // of the nodes of the pairs, each once
  std::vector<unsigned char> is_held_;     // by conditions, each of them
  std::vector<Eigen::Vector4d> velocity_;  // of each of them, and 1/m
  std::vector<std::size_t> on_bodies_;     // pairs that have nodes of rigid bodies
  std::vector<Eigen::Vector3d> given_;     // impulses that the pairs have got, if there are such
  std::vector<std::size_t> first_share_;   // of each node, and the end
  std::vector<Share> shares_;              // in the order of the pairs
};

}  // namespace strike::detail
