#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Pairs that share nodes, whose impulses change each other's velocities. They stand in blocks, and blocks of a colour
/// share no node: these are served side by side, colour after colour, so that no result depends on threads. The
/// velocities are its own until `end`.
class CoupledPairs {
 public:
  template <class Execution>
  CoupledPairs(std::span<const ContactPair> pairs, const ContactNodes& nodes, const Execution& execution)
      : nodes_(nodes), pairs_(pairs), rows_(pairs.size()) {
    number_nodes();
    velocity_.resize(number_.size());
    for_each_chunk(execution, number_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) velocity_[k] << nodes.v[number_[k]], nodes.inverse_mass(number_[k]);
    });
    if (!on_bodies_.empty()) given_.assign(pairs.size(), Eigen::Vector3d::Zero());
  }
  /// Gives the velocities to the nodes.
  template <class Execution>
  void end(ContactNodes& nodes, const Execution& execution) const {
    for_each_chunk(execution, number_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) nodes.v[number_[k]] = velocity_[k].head<3>();
    });
  }

  /// The normal velocity of the points of pair p relative to each other, and the whole of it.
  double approach(std::size_t p) const { return rows_[p].normal.dot(sum(p)); }
  Eigen::Vector3d velocity(std::size_t p) const { return sum(p).head<3>(); }
  /// Changes the velocities of its nodes by an impulse on the pair, or by J along its normal [force time].
  void give(std::size_t p, const Eigen::Vector3d& impulse) {
    give(p, Eigen::Vector4d(impulse[0], impulse[1], impulse[2], 0));
  }
  void give(std::size_t p, double J) { give(p, Eigen::Vector4d(J * rows_[p].normal)); }

  /// Calls f(p) for all pairs, which may write to their nodes, but to those of rigid bodies.
  template <class Execution, class F>
  void each(const Execution& execution, const F& f) {
    for (const auto& colour : colours_)
      side_by_side(execution, colour.size(), [&](std::size_t k) { each_of_block(colour[k], f); });
    if (!on_bodies_.empty()) move_bodies();
  }
  /// Calls f(p) for the pairs that have nodes of rigid bodies, one after the other.
  template <class F>
  void each_on_bodies(const F& f) const {
    for (const std::size_t p : on_bodies_) f(p);
  }
  /// The largest f(p) of all pairs.
  template <class Execution, class F>
  double largest(const Execution& execution, const F& f) {
    std::vector<double> most(blocks(), 0.0);
    side_by_side(execution, blocks(),
                 [&](std::size_t b) { each_of_block(b, [&](std::size_t p) { most[b] = std::max(most[b], f(p)); }); });
    return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
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
    std::vector<OfBlock> of_block(blocks());
    // All that a block calls in one function: its loops take most of the time.
    const auto ask = [&](std::size_t b) __attribute__((__flatten__)) {
      OfBlock sum;
      for (std::size_t i = 0; i < per_block; ++i) {
        const std::size_t p = first(b) + apart(i);
        if (p >= last(b) || !(response[p] > 0)) continue;
        next[p] = allowed(p, Impulse(at[p] + inverse[p] * missing(p)));
        const Impulse back = at[p] - next[p];
        sum.missed = std::max(sum.missed, response[p] * size(back));
        sum.turned += response[p] * product(back, Impulse(next[p] - impulses[p]));
      }
      of_block[b] = sum;
    };
    double momentum = 1;
    for (int iteration = 1; iteration <= most; ++iteration) {
      side_by_side(execution, blocks(), ask);
      OfBlock all;
      for (const OfBlock& sum : of_block) all.missed = std::max(all.missed, sum.missed), all.turned += sum.turned;
      const bool ends = !(all.missed > enough) || iteration == most;
      if (all.turned > 0) momentum = 1;
      const double before = momentum;
      momentum = 0.5 * (1 + std::sqrt(1 + 4 * before * before));
      const double beyond = ends ? 0 : (before - 1) / momentum;
      each(execution, [&](std::size_t p) {
        const Impulse there = next[p] + beyond * (next[p] - impulses[p]);
        give(p, Impulse(there - at[p]));
        impulses[p] = next[p], at[p] = there;
      });
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
    bool is_held, is_on_body, yields;
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
    for (std::size_t i = 0; i < per_block; ++i)
      if (const std::size_t p = first(b) + apart(i); p < last(b)) f(p);
  }

  /// For each pair p a bound D of what impulses do to it [1/mass], so that D - A is positive semidefinite, where A_pq
  /// is the velocity of p by a unit impulse of q; 0 if conditions hold it. D_p = sum of |A_pq| w_p/w_q with w = 1/m* of
  /// each pair (Perron): w_p if it shares no node, and the same for a model cut at a plane of symmetry.
  template <bool along_normals, class Execution>
  std::vector<double> responses(const Execution& execution) {
    std::vector<double> of_pair(rows_.size()), at_node(number_.size(), 0.0);
    const std::vector<OnBody> on_bodies = responses_of_bodies<along_normals>();
    for (const OnBody& on : on_bodies) of_pair[on.pair] += on.response * on.response;
    each(execution, [&](std::size_t p) {
      double own = 0, free = 0;
      each_response<along_normals>(rows_[p], [&](std::size_t k, double a) {
        own += a * a;
        if (!is_rigid(rows_[p].nodes[k]))
          free += rows_[p].weights[k] * rows_[p].weights[k] * velocity_[rows_[p].nodes[k]][3];
      });
      of_pair[p] = rows_[p].yields ? of_pair[p] + (own > 1e-6 * free ? own : 0) : 0;
      if (of_pair[p] > 0)
        each_response<along_normals>(rows_[p],
                                     [&](std::size_t k, double a) { at_node[rows_[p].nodes[k]] += a / of_pair[p]; });
    });
    std::vector<double> at_body(nodes_.bodies().all().size(), 0.0),
        by_bodies(on_bodies.empty() ? 0 : rows_.size(), 0.0);
    for (const OnBody& on : on_bodies)
      if (of_pair[on.pair] > 0) at_body[on.body] += on.response / of_pair[on.pair];
    for (const OnBody& on : on_bodies) by_bodies[on.pair] += on.response * at_body[on.body];
    side_by_side(execution, blocks(), [&](std::size_t b) {
      each_of_block(b, [&](std::size_t p) {
        double sum = by_bodies.empty() ? 0 : by_bodies[p];
        each_response<along_normals>(rows_[p], [&](std::size_t k, double a) { sum += a * at_node[rows_[p].nodes[k]]; });
        of_pair[p] *= sum;
      });
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
  /// Calls f(k, |w| sqrt(1/m)) for the nodes of a pair, with the 1/m that conditions leave along its normal, or in any
  /// direction; 0 of nodes of rigid bodies.
  template <bool along_normals, class F>
  void each_response(const Row& row, const F& f) const {
    for (std::size_t k = 0; k < 5; ++k) {
      double inverse_mass = velocity_[row.nodes[k]][3];
      if (row.is_held) {
        const Index node = number_[row.nodes[k]];
        if (nodes_.is_rigid(node))
          inverse_mass = 0;
        else if (along_normals)
          inverse_mass = nodes_.inverse_mass_along(node, row.normal.template head<3>());
        else if (nodes_.is_held_fast(node))
          inverse_mass = 0;
      }
      f(k, std::abs(row.weights[k]) * std::sqrt(inverse_mass));
    }
  }

  /// An order in which neighbours, which share nodes, do not follow each other, so that none waits for the other.
  static std::size_t apart(std::size_t i) { return i % 8 * 8 + i / 8; }
  std::size_t blocks() const { return (rows_.size() + per_block - 1) / per_block; }
  std::size_t first(std::size_t b) const { return b * per_block; }
  std::size_t last(std::size_t b) const { return std::min((b + 1) * per_block, rows_.size()); }

  /// The relative velocity, and a number without a meaning.
  Eigen::Vector4d sum(std::size_t p) const {
    const auto& [w, nodes] = std::tie(rows_[p].weights, rows_[p].nodes);
    // In two sums, neither of which waits for the other.
    const Eigen::Vector4d one = w[0] * velocity_[nodes[0]] + w[2] * velocity_[nodes[2]] + w[4] * velocity_[nodes[4]],
                          other = w[1] * velocity_[nodes[1]] + w[3] * velocity_[nodes[3]];
    return one + other;
  }
  /// The fourth number of the impulse is 0.
  void give(std::size_t p, const Eigen::Vector4d& impulse) {
    const Row& row = rows_[p];
    if (row.is_on_body) given_[p] += impulse.head<3>();
    if (row.is_held) return give_held(row, impulse.head<3>());
    for (std::size_t k = 0; k < 5; ++k) {
      Eigen::Vector4d& v = velocity_[row.nodes[k]];
      v += (row.weights[k] * v[3]) * impulse;
    }
  }
  void give_held(const Row& row, const Eigen::Vector3d& impulse) {
    for (std::size_t k = 0; k < 5; ++k) {
      if (is_rigid(row.nodes[k])) continue;
      Eigen::Vector4d& v = velocity_[row.nodes[k]];
      v.head<3>() += (row.weights[k] * v[3]) * nodes_.free(number_[row.nodes[k]], impulse);
    }
  }
  bool is_rigid(Index k) const { return !on_bodies_.empty() && nodes_.is_rigid(number_[k]); }
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

  /// Sets the rows, and the colour of each block: the first that no block before it with a node of its own has. Blocks
  /// that find none follow one by one.
  void number_nodes() {
    constexpr std::size_t most_colours = 64;
    constexpr Index none = std::numeric_limits<Index>::max();
    std::vector<Index> place(nodes_.size(), none);
    std::vector<std::uint64_t> taken;
    for (std::size_t b = 0; b < blocks(); ++b) {
      std::uint64_t around = 0;
      for (std::size_t p = first(b); p < last(b); ++p) {
        const ContactPair& pair = pairs_[p];
        Row& row = rows_[p];
        row.normal << pair.normal, 0;
        row.weights = pair.weights, row.is_held = row.is_on_body = false, row.yields = true;
        for (unsigned k = 0; k < pair.count; ++k) {
          Index& at = place[pair.nodes[k]];
          if (at == none) at = static_cast<Index>(number_.size()), number_.push_back(pair.nodes[k]), taken.push_back(0);
          row.nodes[k] = at, around |= taken[at];
          row.is_on_body = row.is_on_body || nodes_.is_rigid(pair.nodes[k]);
          row.is_held = row.is_held || row.is_on_body || nodes_.is_held(pair.nodes[k]);
        }
        if (row.is_on_body) on_bodies_.push_back(p), row.yields = pair.inverse_effective_mass > 0;
        std::fill(row.nodes.begin() + pair.count, row.nodes.end(), row.nodes[0]);
        std::fill(row.weights.begin() + pair.count, row.weights.end(), 0.0);
      }
      const auto colour = static_cast<std::size_t>(std::countr_one(around));
      if (colour >= most_colours) {
        colours_.push_back({b});
        continue;
      }
      while (colours_.size() <= colour) colours_.emplace_back();
      colours_[colour].push_back(b);
      for (std::size_t p = first(b); p < last(b); ++p)
        for (const Index k : rows_[p].nodes) taken[k] |= std::uint64_t{1} << colour;
    }
  }

  const ContactNodes& nodes_;
  std::span<const ContactPair> pairs_;
  std::vector<Row> rows_;
  std::vector<Index> number_;              // of the nodes of the pairs, each once
  std::vector<Eigen::Vector4d> velocity_;  // of each of them, and 1/m
  std::vector<std::size_t> on_bodies_;     // pairs that have nodes of rigid bodies
  std::vector<Eigen::Vector3d> given_;     // impulses that the pairs have got, if there are such
  std::vector<std::vector<std::size_t>> colours_;
};

}  // namespace strike::detail
