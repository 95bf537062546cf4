#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/motion/by_number.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// State of a direction of a node's motion that is not free: at rest, or moved as prescribed.
enum class Held { still, moved };

namespace detail {

/// The directions that conditions take from the motion of nodes.
class HeldDirections {
 public:
  /// See Nodes::hold; `place` is the position in messages.
  Eigen::Vector3d hold(std::size_t i, const Eigen::Vector3d& place, Eigen::Vector3d direction, Held how) {
    std::size_t* last = &first_.at(i);
    for (; *last != none; last = &held_[*last].next) {
      const HeldDirection& h = held_[*last];
      const double overlap = h.direction.dot(direction);
      if (std::abs(overlap) > 1e-6 && (how == Held::moved || h.how == Held::moved))
        throw Error(joined({"strike: node ", std::to_string(i), " at ", text(place), " has two conditions along ",
                            text(direction), ", and one prescribes its motion; take it out of the other."}));
      direction = direction - overlap * h.direction;
    }
    if (direction.norm() < 1e-6) return Eigen::Vector3d::Zero();
    direction = direction / direction.norm();
    *last = held_.size();
    held_.push_back({direction, how, none});
    return direction;
  }
  /// The part of a vector along which node i is free to move.
  template <class Vector>
  Vector free(std::size_t i, Vector a) const {
    for (std::size_t h = first_[i]; h != none; h = held_[h].next) a -= held_[h].direction.dot(a) * held_[h].direction;
    return a;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  struct HeldDirection {
    Eigen::Vector3d direction;
    Held how;
    std::size_t next;  ///< of the same node
  };

  ByNumber<std::size_t> first_{none};
  std::vector<HeldDirection> held_;
};

}  // namespace detail

}  // namespace strike
