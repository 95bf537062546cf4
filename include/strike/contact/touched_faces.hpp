#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/crossing.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Where a node and a face press on each other.
struct Place {
  Index face = 0;
  std::array<double, 4> N{};  ///< of the face's corners, of sum 1
  Eigen::Vector3d normal;     ///< unit, to the side of the node
  double height = 0;          ///< of the node over the face along it; negative behind [length]

  /// (s, t) of a quadrilateral.
  std::array<double, 2> on_face() const { return {N[1] + N[2] - N[0] - N[3], N[2] + N[3] - N[0] - N[1]}; }
};

/// Faces that nodes may touch, at what distance and from which sides.
struct TouchedFaces {
  Target target;
  std::vector<double> half;  ///< half the thickness of the plate that a node belongs to, 0 of solids [length]
  double size = 0;           ///< mean diagonal of a face at the start [length]

  /// The distance from node i at which it touches face f at shape functions N [length].
  double depth(Index i, Index f, const std::array<double, 4>& N) const { return half[i] + target.half(f, N); }
  /// A node of a plate or the face of one: they touch at a distance from their middle.
  bool is_at_a_distance(Index i, Index f) const { return half[i] > 0 || target.is_plate(f); }
  /// The largest such distance [length].
  double largest_depth() const {
    return (half.empty() ? 0.0 : *std::max_element(half.begin(), half.end())) + target.largest_half();
  }
  /// That of node i and face f [length].
  double largest_depth(Index i, Index f) const { return half[i] + target.largest_half(f); }
  double tolerance() const { return 1e-6 * size; }
  Reach reach(Index i, Index f) const {
    Reach reach{.own = half[i], .tolerance = tolerance(), .two_sided = target.is_plate(f)};
    if (reach.two_sided)
      for (unsigned k = 0; k < target.count(f); ++k) reach.of_corners[k] = target.half(target.faces()[f][k]);
    return reach;
  }
  /// By how much a node may be inside a face to which it passes round an edge [length].
  double slack() const { return 0.05 * size; }

  /// The foot of node i on face f; `start` is near it, at (s, t) of a quadrilateral.
  Foot foot(Index f, const ContactNodes& all, Index i, const std::array<double, 2>& start = {0, 0}) const {
    const Corners X = target.corners(f, all.x);
    return target.foot(f, X, target.closest(f, X, all.x[i], start), all.x);
  }
  Projection projection(Index f, const ContactNodes& all, Index i, const std::array<double, 2>& start = {0, 0}) const {
    return project(target.corners(f, all.x), all.x[i], target.count(f) == 3, start);
  }
  /// The normal of face f at shape functions N, from the side to which its corners turn counter-clockwise.
  Eigen::Vector3d normal(Index f, const std::array<double, 4>& N, const ContactNodes& all) const {
    return normal_at(target.corners(f, all.x), N, target.count(f) == 3);
  }
  /// The normal of face f in its middle.
  Eigen::Vector3d normal(Index f, const ContactNodes& all) const { return target.normal(f, all.x); }
  /// From a point of the face, by its shape functions, to node i [length].
  Eigen::Vector3d way_to(Index i, Index f, const std::array<double, 4>& N, const ContactNodes& all) const {
    Eigen::Vector3d way = all.x[i];
    for (unsigned k = 0; k < target.count(f); ++k) way -= N[k] * all.x[target.faces()[f][k]];
    return way;
  }
  /// Calls g(other) for the faces of its kind around face f, itself among them; some come more than once.
  template <class G>
  void each_around(Index f, const G& g) const {
    for (unsigned k = 0; k < target.count(f); ++k)
      for (const Index other : target.at(target.faces()[f][k]))
        if (target.are_alike(f, other)) g(other);
  }
  /// They are of one kind and share a corner.
  bool go_together(Index f, Index other) const { return target.are_alike(f, other) && are_connected(f, other); }
  bool are_connected(Index f, Index other) const {
    const auto& c = target.faces()[f];
    return std::any_of(c.begin(), c.end(), [&](Index corner) { return target.has(other, corner); });
  }

  /// The normal of a plate's middle surface at a place, to the side of the node; Place::normal may lead from its edge.
  Eigen::Vector3d side_of_plate(const Place& place, const ContactNodes& all) const {
    const Eigen::Vector3d n = normal(place.face, place.N, all);
    return n.dot(place.normal) < 0 ? -n : n;
  }

  /// The pair of node i with a place, `gap` apart along the normal.
  ContactPair pair(Index i, const Place& place, double gap) const {
    ContactPair pair(place.normal, gap);
    pair.add(i, 1);
    for (unsigned k = 0; k < target.count(place.face); ++k) pair.add(target.faces()[place.face][k], -place.N[k]);
    return pair;
  }
};

}  // namespace strike::detail
