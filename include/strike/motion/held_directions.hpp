#pragma once
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/text.hpp>

namespace strike {

/// What becomes of a direction of a node's motion that is not free: it does not move, or moves as it is told.
enum class Held { still, moved };

namespace detail {

/// The directions that conditions take from the motion of nodes.
class HeldDirections {
 public:
  /// See Nodes::hold; `place` is for the message.
  Eigen::Vector3d hold(std::size_t i, const Eigen::Vector3d& place, Eigen::Vector3d direction, Held how) {
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) {
      const double overlap = h->second.direction.dot(direction);
      if (std::abs(overlap) > 1e-6 && (how == Held::moved || h->second.how == Held::moved))
        throw Error(joined({"strike: node ", std::to_string(i), " at ", text(place), " has two conditions along ",
                            text(direction), ", and one prescribes its motion; take it out of the other."}));
      direction -= overlap * h->second.direction;
    }
    if (direction.norm() < 1e-6) return Eigen::Vector3d::Zero();
    direction.normalize();
    held_.insert({i, {direction, how}});
    return direction;
  }
  /// The part of a vector along which node i is free to move.
  template <class Vector>
  Vector free(std::size_t i, Vector a) const {
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) a -= h->second.direction.dot(a) * h->second.direction;
    return a;
  }

 private:
  struct HeldDirection {
    Eigen::Vector3d direction;
    Held how;
  };

  std::multimap<std::size_t, HeldDirection> held_;
};

}  // namespace detail

}  // namespace strike
