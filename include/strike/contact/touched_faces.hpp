#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// Faces that nodes may touch, at what distance and from which sides.
struct TouchedFaces {
  Target target;
  double depth = 0;        ///< between the middle surfaces of touching plates, 0 of solids [length]
  bool two_sided = false;  ///< plates: touched from both sides
  double size = 0;         ///< mean diagonal of a face at the start [length]

  /// The foot of node i on face f.
  Foot foot(Index f, const ContactNodes& all, Index i) const {
    return target.foot(f, target.corners(f, all.x), all.x[i], all.x);
  }
  /// The foot of a point on the nearest of the faces around face f; `skips(other)` leaves faces out.
  template <class Skips>
  void take_nearest_around(Index f, const Eigen::Vector3d& at, std::span<const Eigen::Vector3d> x, const Skips& skips,
                           Foot& best) const {
    for (unsigned k = 0; k < target.count(f); ++k)
      for (const Index other : target.at(target.faces()[f][k])) {
        if (skips(other)) continue;
        const Foot foot = target.foot(other, target.corners(other, x), at, x);
        if (foot.point.distance2 < best.point.distance2) best = foot;
      }
  }
  /// The normal of a face at the foot, where `Foot::normal` may lead away from an edge.
  Eigen::Vector3d face_normal(const Foot& foot, const Corners& X) const {
    return normal_at(X, foot.point.N, target.count(foot.face) == 3);
  }
  /// The side of a plate on which a foot's node is: 1 or -1; 1 of solids.
  double side_of(const Foot& foot) const { return two_sided && foot.height < 0 ? -1 : 1; }
  /// On the side from which the faces are touched; plates have both.
  bool is_outside(const Foot& foot) const { return two_sided || foot.height >= -1e-6 * size; }

  ContactPair pair(Index node, const Foot& foot, double side, double gap, Touch& touch) const {
    ContactPair pair;
    pair.node = node, pair.N = foot.point.N, pair.count = target.count(foot.face);
    pair.corners = target.faces()[foot.face];
    pair.normal = side * foot.normal;
    pair.gap = gap;
    pair.stored = &touch.stored;
    return pair;
  }
};

}  // namespace strike::detail
