#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// How long sweeps over pairs go on, forward and backward in turn: until the largest change of velocity in one is 1e-6
/// of the fastest, so that their order does not count, or until they no longer bring anything. Two surfaces that lie on
/// each other ask more of their nodes than these can give, and impulses that add up to nothing settle slowly.
class Settling {
 public:
  static constexpr int patience = 10;  ///< sweeps, after which the directions of those before are worth their price
  static constexpr int stalled = 120;  ///< sweeps that have not halved the change

  Settling(double fastest, int most_sweeps) : enough_(1e-6 * fastest), most_sweeps_(most_sweeps) {}

  bool goes_on() const { return !ended_ && change_ > enough_; }
  bool is_forward() const { return sweep_ % 2 == 0; }
  /// True if no sweep comes after this one, whatever it changes.
  bool is_last() const { return sweep_ + 1 >= most_sweeps_ || sweep_ > halved_ + stalled; }
  int sweep() const { return sweep_; }
  /// Ends a sweep, in which no velocity has changed more than by that.
  void note(double change) {
    ended_ = is_last(), change_ = change;
    if (change_ < 0.5 * least_) least_ = change_, halved_ = sweep_;
    ++sweep_;
  }

 private:
  double enough_, change_ = std::numeric_limits<double>::infinity(), least_ = change_;
  int most_sweeps_, sweep_ = 0, halved_ = 0;  // the sweep that halved the change last
  bool ended_ = false;
};

/// Pairs that share nodes, for laws that correct one after the other (Gauss-Seidel): each sees the velocities that the
/// others have left. They stand in blocks, and blocks of a colour share no node: these are served side by side, colour
/// after colour, so that no result depends on threads. The velocities are its own until `end`.
class CoupledPairs {
 public:
  template <class Execution>
  CoupledPairs(std::span<const ContactPair> pairs, const ContactNodes& nodes, const Execution& execution)
      : nodes_(nodes), rows_(pairs.size()) {
    number_nodes(pairs);
    velocity_.resize(number_.size());
    for_each_chunk(execution, number_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) velocity_[k] << nodes.v[number_[k]], nodes.inverse_mass(number_[k]);
    });
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
  void give(std::size_t p, const Eigen::Vector3d& impulse) { give(rows_[p], {impulse[0], impulse[1], impulse[2], 0}); }
  void give(std::size_t p, double J) { give(rows_[p], J * rows_[p].normal); }

  /// Calls correct(p) for all pairs, forward or backward. Returns the largest of its results.
  template <class Execution, class Correct>
  double sweep(const Execution& execution, bool forward, const Correct& correct) {
    for (std::size_t c = 0; c < colours_.size(); ++c) {
      const auto& colour = colours_[forward ? c : colours_.size() - 1 - c];
      execution.for_each(colour.size(), [&](std::size_t k) {
        const std::size_t b = colour[k];
        double most = 0;
        for (std::size_t i = 0; i < per_block; ++i) {
          const std::size_t p = first(b) + apart(forward ? i : per_block - 1 - i);
          if (p < last(b)) most = std::max(most, correct(p));
        }
        most_[b] = most;
      });
    }
    double most = 0;
    for (const double of_block : most_) most = std::max(most, of_block);
    return most;
  }
  /// Calls f(p) for all pairs, which may write to their nodes.
  template <class Execution, class F>
  void each(const Execution& execution, const F& f) {
    sweep(execution, true, [&](std::size_t p) { return f(p), 0.0; });
  }

 private:
  static constexpr std::size_t per_block = 64;

  /// A pair as its laws need it in a sweep.
  struct Row {
    Eigen::Vector4d normal;  // and 0
    std::array<double, 5> weights;
    std::array<Index, 5> nodes;  // by their places among those of all pairs
    unsigned short count, is_held;
  };

  /// An order in which neighbours, which share nodes, do not follow each other, so that none waits for the other.
  static std::size_t apart(std::size_t i) { return i % 8 * 8 + i / 8; }
  std::size_t blocks() const { return (rows_.size() + per_block - 1) / per_block; }
  std::size_t first(std::size_t b) const { return b * per_block; }
  std::size_t last(std::size_t b) const { return std::min((b + 1) * per_block, rows_.size()); }

  /// The relative velocity, and a number without a meaning.
  Eigen::Vector4d sum(std::size_t p) const {
    const Row& row = rows_[p];
    Eigen::Vector4d one = row.weights[0] * velocity_[row.nodes[0]], other = Eigen::Vector4d::Zero();
    each_node(row, [&](unsigned k) {  // in two sums, neither of which waits for the other
      if (k > 0) (k % 2 == 0 ? one : other) += row.weights[k] * velocity_[row.nodes[k]];
    });
    return one + other;
  }
  /// The fourth number of the impulse is 0.
  void give(const Row& row, const Eigen::Vector4d& impulse) {
    each_node(row, [&](unsigned k) {
      Eigen::Vector4d& v = velocity_[row.nodes[k]];
      if (!row.is_held)
        v += (row.weights[k] * v[3]) * impulse;
      else
        v.head<3>() += (row.weights[k] * v[3]) * nodes_.free(number_[row.nodes[k]], impulse.head<3>());
    });
  }
  /// A node and a quadrilateral are most pairs.
  template <class F>
  static void each_node(const Row& row, const F& f) {
    if (row.count == 5)
      for (unsigned k = 0; k < 5; ++k) f(k);
    else
      for (unsigned k = 0; k < row.count; ++k) f(k);
  }

  /// Sets the rows, and the colour of each block: the first that no block before it with a node of its own has. Blocks
  /// that find none follow one by one.
  void number_nodes(std::span<const ContactPair> pairs) {
    constexpr std::size_t most_colours = 64;
    constexpr Index none = std::numeric_limits<Index>::max();
    std::vector<Index> place(nodes_.size(), none);
    std::vector<std::uint64_t> taken;
    most_.assign(blocks(), 0.0);
    for (std::size_t b = 0; b < blocks(); ++b) {
      std::uint64_t around = 0;
      for (std::size_t p = first(b); p < last(b); ++p) {
        const ContactPair& pair = pairs[p];
        Row& row = rows_[p];
        row.normal << pair.normal, 0;
        row.weights = pair.weights, row.count = static_cast<unsigned short>(pair.count), row.is_held = 0;
        for (unsigned k = 0; k < pair.count; ++k) {
          Index& at = place[pair.nodes[k]];
          if (at == none) at = static_cast<Index>(number_.size()), number_.push_back(pair.nodes[k]), taken.push_back(0);
          row.nodes[k] = at, around |= taken[at];
          if (nodes_.is_held(pair.nodes[k])) row.is_held = 1;
        }
      }
      const auto colour = static_cast<std::size_t>(std::countr_one(around));
      if (colour >= most_colours) {
        colours_.push_back({b});
        continue;
      }
      while (colours_.size() <= colour) colours_.emplace_back();
      colours_[colour].push_back(b);
      for (std::size_t p = first(b); p < last(b); ++p)
        for (unsigned k = 0; k < rows_[p].count; ++k) taken[rows_[p].nodes[k]] |= std::uint64_t{1} << colour;
    }
  }

  const ContactNodes& nodes_;
  std::vector<Row> rows_;
  std::vector<Index> number_;              // of the nodes of the pairs, each once
  std::vector<Eigen::Vector4d> velocity_;  // of each of them, and 1/m
  std::vector<std::vector<std::size_t>> colours_;
  std::vector<double> most_;  // of each block
};

}  // namespace strike::detail
