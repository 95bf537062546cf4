#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/overlap.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/tensor/tensor.hpp>
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

/// The cells around the nodes of a contact at the start, as far as parts are known.
struct CellsAround {
  /// Unit vectors out of the solids, the mean of the normals of the faces around each node, weighted by their angles;
  /// zero of nodes of plates alone.
  std::vector<Eigen::Vector3d> outward{};
  std::vector<double> edge{};  ///< the least of the cells of each node; infinite of others [length]

  CellsAround() = default;
  template <class N>
  CellsAround(const ContactNodes& all, const N& nodes, std::span<const PartFaces> parts)
      : outward(all.size(), Eigen::Vector3d{0, 0, 0}), edge(all.size(), std::numeric_limits<double>::infinity()) {
    std::vector<Index> local(nodes.size(), all.first_point());
    for (Index i = 0; i < all.first_point(); ++i) local[all.number(i)] = i;
    for (const PartFaces& part : parts)
      for (const Face& face : part.faces) {
        const unsigned count = face.is_triangle() ? 3 : 4;
        const auto x = [&](unsigned k) -> Eigen::Vector3d {
          return nodes.x(face.nodes[k % count]).template cast<double>();
        };
        for (unsigned k = 0; k < count; ++k) {
          const Index i = local[face.nodes[k]];
          if (i == all.first_point()) continue;
          const Eigen::Vector3d a = x(k + 1) - x(k), b = x(k + count - 1) - x(k), area = cross<double>(a, b);
          if (a.norm() > 0) edge[i] = std::min(edge[i], a.norm());
          if (b.norm() > 0) edge[i] = std::min(edge[i], b.norm());
          if (part.thickness > 0 || !(area.norm() > 0)) continue;
          outward[i] += std::atan2(area.norm(), a.dot(b)) * direction(area);  // faces between two cells cancel
        }
      }
    for (Eigen::Vector3d& n : outward) n = n.norm() > 1e-6 ? direction(n) : Eigen::Vector3d{0, 0, 0};
  }
};

/// Depths below which nothing is inside: what the spacing of the coordinates makes, or a share of the size of a cell.
inline double depth_of_rounding(const Eigen::Vector3d& x, double size) {
  return std::max(8 * std::numeric_limits<double>::epsilon() * x.norm(), 1e-10 * size);
}

/// The nodes that start inside: their number, the deepest of them, and how they overlap; and edges that pass through
/// faces with neither end inside.
struct InitialPenetration {
  std::vector<Overlap> overlaps{};
  CellsAround around{};  ///< known while a contact begins
  std::size_t count = 0;
  Index deepest = 0;  ///< number of the deepest node in the scene
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double depth = 0;  ///< [length]
  std::size_t piercing = 0;
  std::array<Index, 2> first_piercing{};                       ///< numbers of its ends in the scene
  Eigen::Vector3d where_it_pierces = Eigen::Vector3d::Zero();  ///< the middle of that edge

  void add(Index number, const Eigen::Vector3d& x, double d) {
    ++count;
    if (d > depth) depth = d, deepest = number, place = x;
  }
  /// The same for the first node of a pair, whose gap is negative; below `tolerance` it overlaps, but is not counted.
  void add(const ContactNodes& all, const ContactPair& pair, double tolerance = 0) {
    const Index i = pair.nodes[0];
    if (-pair.gap > tolerance) add(all.number(i), all.x[i], -pair.gap);
    Overlap overlap{.normal = pair.normal, .depth = -pair.gap};
    for (unsigned k = 0; k < pair.count; ++k)
      if (pair.nodes[k] < all.first_point())
        overlap.nodes[overlap.count] = all.number(pair.nodes[k]), overlap.weights[overlap.count++] = pair.weights[k];
    overlaps.push_back(overlap);
  }
  /// The edge between two nodes of the contact passes through a face.
  void add_piercing(const ContactNodes& all, const std::array<Index, 2>& ends) {
    if (piercing++ > 0) return;
    first_piercing = {all.number(ends[0]), all.number(ends[1])};
    where_it_pierces = 0.5 * (all.x[ends[0]] + all.x[ends[1]]);
  }
  /// A sentence for the user on each; empty if nothing starts inside.
  std::string warning() const { return joined({of_nodes(), count > 0 && piercing > 0 ? " " : "", of_edges()}); }

 private:
  std::string of_edges() const {
    if (piercing == 0) return {};
    return joined({std::to_string(piercing), piercing == 1 ? " edge passes" : " edges pass",
                   " through faces at the start with neither end inside, the first, from node ",
                   std::to_string(first_piercing[0]), " to node ", std::to_string(first_piercing[1]), ", at ",
                   text(where_it_pierces), "; no contact keeps these bodies apart: move the meshes."});
  }
  std::string of_nodes() const {
    if (count == 0) return {};
    return joined(
        {std::to_string(count), count == 1 ? " node begins" : " nodes begin",
         " inside what they may touch, the deepest, node ", std::to_string(deepest), " at ", text(place), ", by ",
         text(depth),
         "; they stay so deep without force until they leave: if that is not meant, take pushed_apart(scene), or "
         "move the meshes."});
  }
};

}  // namespace strike::detail
