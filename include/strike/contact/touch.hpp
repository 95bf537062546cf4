#pragma once
#include <cstddef>
#include <string>

#include <Eigen/Core>

#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The touch of a node, kept from step to step.
struct Touch {
  double side = 0;           ///< of a plate from which the node came: 1 or -1; 0: no touch
  double initial_depth = 0;  ///< initial penetration, tolerated without force [length]
  double stored = 0;         ///< energy that the law has taken and not given back [energy]
  Index face = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(side, initial_depth, stored, face);
  }
};

/// Count of the nodes that start inside, and the deepest of them.
struct InitialPenetration {
  std::size_t count = 0;
  Index deepest = 0;  ///< number of the deepest node in the scene
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double depth = 0;  ///< [length]

  void add(Index number, const Eigen::Vector3d& x, double d) {
    ++count;
    if (d > depth) depth = d, deepest = number, place = x;
  }
  /// One sentence for the user; empty if no node starts inside.
  std::string warning() const {
    if (count == 0) return {};
    return joined({std::to_string(count), count == 1 ? " node begins" : " nodes begin",
                   " inside what they may touch, the deepest, node ", std::to_string(deepest), " at ", text(place),
                   ", by ", text(depth),
                   "; they stay so deep without force until they leave: move the meshes apart if that is not meant."});
  }
};

}  // namespace strike::detail
