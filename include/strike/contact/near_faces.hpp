#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>

namespace strike::detail {

/// The faces near each node, found by a BucketSearch with a margin and kept until nodes and faces may have moved by it.
/// A face that is farther from a node than they can have come since rests.
template <bool self>
class NearFaces {
 public:
  /// Searches the faces that nodes touch within a `margin` [length], but for those that `never(i, f)` meet.
  template <class Never, Execution E = Serial>
  void sort(const ContactNodes& all, std::span<const Index> nodes, const TouchedFaces& faces, double margin,
            const Never& never, const E& execution = {}) {
    ++sorts_;
    const Target& target = faces.target;
    const double depth = faces.largest_depth();
    const auto less = [&](Index s, Index f) {
      return never(nodes[s], f) ? std::numeric_limits<double>::infinity() : depth - faces.largest_depth(nodes[s], f);
    };
    const double apart = search_.sort(nodes, target.faces(), all.x, depth + margin, execution, less);
    margin_ = margin + apart, travelled_ = 0;
    wake_all();
    // A face rests until what is left of the margin beside its box has been travelled.
    const std::vector<double>& room = search_.room();
    for_each_chunk(execution, search_.nodes(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s)
        for (std::size_t k = search_.first(s); k < search_.first(s) + search_.near(s).size(); ++k) {
          wakes_[k] = std::max(0.0, margin - room[k] - faces.tolerance());
          first_wakes_[s] = k == search_.first(s) ? wakes_[k] : std::min(first_wakes_[s], wakes_[k]);
        }
    });
    largest_inverse_mass_ = 0;
    for (const Index s : search_.awake()) {
      double corner = 0;
      for (const Index f : search_.near(s))
        for (const Index i : target.faces()[f]) corner = std::max(corner, all.largest_inverse_mass(i));
      largest_inverse_mass_ = std::max(largest_inverse_mass_, all.largest_inverse_mass(nodes[s]) + corner);
    }
  }
  /// Searches again if nodes and faces may have moved by the margin at the end of a step.
  template <class Never, class Execution>
  void update(const ContactNodes& all, const std::vector<Index>& nodes, const TouchedFaces& faces, double dt,
              const Never& never, const Execution& execution) {
    if (corners_.empty()) {
      for (const auto& face : faces.target.faces()) corners_.insert(corners_.end(), face.begin(), face.end());
      corners_ = ascending(std::move(corners_));
      are_corners_ = self && std::includes(corners_.begin(), corners_.end(), nodes.begin(), nodes.end());
    }
    // The way of the last step, with all impulses, takes the place of the one that was expected.
    const double before = step_reach_;
    find_fastest(all, nodes, execution);
    travelled_ += last_reach_ - before;
    step_reach_ = dt * speed_;
    // Twice the way, so that the step after this one is seen too.
    if (!(travelled_ + 2 * step_reach_ <= margin_))
      sort(all, nodes, faces, std::max(8 * step_reach_, 0.5 * faces.size), never, execution);
    travelled_ += step_reach_;
  }
  /// Bound of the way of a node relative to a face in this step, or in the last one [length].
  double reach() const { return std::max(step_reach_, last_reach_); }
  /// False if nothing comes nearer by more than `way` in a time dt.
  bool may_close(double dt, double way) const { return dt * speed_ > way; }
  /// Drops what belongs to faces that have changed.
  void forget() { corners_.clear(), margin_ = -1; }

  /// Calls clearance = look(f) for the faces near node s of the list that do not rest, or for all of them: how far the
  /// face and the node may move relative to each other before they need a look again.
  template <class Look>
  void each_awake(std::size_t s, bool all, const Look& look) {
    const auto faces = search_.near(s);
    const auto wakes = std::span(wakes_).subspan(search_.first(s), faces.size());
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < faces.size(); ++k) {
      if (all || !(travelled_ < wakes[k])) wakes[k] = travelled_ - step_reach_ + look(faces[k]);
      first = std::min(first, wakes[k]);
    }
    first_wakes_[s] = first;
  }
  /// Calls f(face) for the faces near node s that it may meet in a time dt after this step.
  template <class F>
  void each_within(std::size_t s, double dt, const F& f) const {
    const double reach = travelled_ + dt * speed_;
    if (reach < first_wakes_[s]) return;
    const auto faces = search_.near(s);
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (!(reach < wakes_[search_.first(s) + k])) f(faces[k]);
  }
  /// True if all faces near node s rest.
  bool rests(std::size_t s) const { return travelled_ < first_wakes_[s]; }

  /// Faces near node s of the list, in ascending order.
  std::span<const Index> of(std::size_t s) const { return search_.near(s); }
  /// Nodes that have a face near, by their places in the list.
  const std::vector<Index>& awake() const { return search_.awake(); }
  /// The largest 1/m* of a node and a corner near it [1/mass]: a bound for the stiffness of springs.
  double largest_inverse_mass() const { return largest_inverse_mass_; }
  std::size_t sorts() const { return sorts_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(corners_, search_, margin_, travelled_, step_reach_, largest_inverse_mass_, sorts_);
    wake_all();
  }

 private:
  void wake_all() { wakes_.assign(search_.size(), 0.0), first_wakes_.assign(search_.nodes(), 0.0); }

  /// Sets bounds of the way in the last step and of the velocity of a node relative to a face: the sum of the largest
  /// of both relative to the mean of some corners of faces.
  template <class Execution>
  void find_fastest(const ContactNodes& all, const std::vector<Index>& nodes, const Execution& execution) {
    Eigen::Vector3d mean_way{0, 0, 0}, mean_velocity{0, 0, 0};
    const std::size_t stride = corners_.size() / 64 + 1;
    for (std::size_t k = 0; k < corners_.size(); k += stride)
      mean_way += all.x[corners_[k]] - all.x_before[corners_[k]], mean_velocity += all.v[corners_[k]];
    const double share = 1 / static_cast<double>((corners_.size() + stride - 1) / stride);
    mean_way *= share, mean_velocity *= share;
    struct Squares {
      double way = 0, velocity = 0;
    };
    const auto most = [&](const std::vector<Index>& some) {
      std::vector<Squares> squares(chunks(some.size()));
      for_each_chunk(execution, some.size(), [&](std::size_t c, std::size_t first, std::size_t last) {
        Squares of_chunk;
        for (std::size_t k = first; k < last; ++k) {
          const Index i = some[k];
          of_chunk.way = std::max(of_chunk.way, (all.x[i] - all.x_before[i] - mean_way).squaredNorm());
          of_chunk.velocity = std::max(of_chunk.velocity, (all.v[i] - mean_velocity).squaredNorm());
        }
        squares[c] = of_chunk;
      });
      Squares largest;
      for (const Squares& of_chunk : squares) {
        largest.way = std::max(largest.way, of_chunk.way);
        largest.velocity = std::max(largest.velocity, of_chunk.velocity);
      }
      return Squares{std::sqrt(largest.way), std::sqrt(largest.velocity)};
    };
    const Squares of_faces = most(corners_), of_nodes = are_corners_ ? of_faces : most(nodes);
    last_reach_ = of_faces.way + of_nodes.way, speed_ = of_faces.velocity + of_nodes.velocity;
  }

  BucketSearch search_;
  std::vector<Index> corners_;  // of the faces, each once
  bool are_corners_ = false;    // all nodes are among them, and none is a particle or what a deleted cell has left
  double margin_ = -1, travelled_ = 0, speed_ = 0, step_reach_ = 0, last_reach_ = 0, largest_inverse_mass_ = 0;
  std::size_t sorts_ = 0;
  std::vector<double> wakes_,
      first_wakes_;  // what has to be travelled first, of each face near a node, and of the node
};

}  // namespace strike::detail
