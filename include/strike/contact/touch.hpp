#pragma once
#include <array>
#include <cstddef>
#include <string>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The touch of a node with a face, kept from step to step.
struct Touch {
  Index node = 0;  ///< its place in the list of nodes
  Index face = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, to the side of the node: no order of corners turns it
  std::array<double, 2> place{};                       ///< on the face, (s, t) of a quadrilateral in the last step
  double initial_depth = 0;                            ///< initial penetration, tolerated without force [length]
  double stored = 0;                                   ///< of the law, such as the energy that it has taken [energy]
  Eigen::Vector3d friction = Eigen::Vector3d::Zero();  ///< in the last step [force]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(node, face, normal, place, initial_depth, stored, friction);
  }
};

/// Gives a pair what its touch remembers.
void remember(ContactPair& pair, auto& touch) { pair.stored = &touch.stored, pair.friction = &touch.friction; }

/// Error: a node that has come deeper into what it touches than a cell is large, by which no law means to hold it.
inline void check_depth(Index number, const Eigen::Vector3d& x, double depth, double cell) {
  if (!(depth > cell)) return;
  constexpr const char* advice =
      " deep into what it touches, more than a cell: the springs of a Penalty are too soft at this speed; take "
      "Kinematic, or a greater fraction or stiffness.";
  throw Error(joined({"strike: node ", std::to_string(number), " at ", text(x), " has come ", text(depth), advice}));
}

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
