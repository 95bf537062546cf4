#pragma once
#include <algorithm>
#include <optional>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// A face around may be closer although the foot is inside its own: in a dent, or deep below a crest.
inline bool leans(const Foot& foot, const TouchedFaces& faces) {
  return foot.point.distance2 > 1e-4 * faces.size * faces.size;
}

/// Past the border of an open surface rather than through it.
inline bool slid_off(const Foot& foot, const TouchedFaces& faces, const ContactNodes& all) {
  const Corners X = faces.target.corners(foot.face, all.x);
  const double down = faces.face_normal(foot, X).dot(foot.point.away);
  return foot.point.distance2 > 2 * down * down + 1e-24 * faces.size * faces.size;
}

/// The pair of node i, which touches already, as long as it is inside or will be at the end of the step. Only its face
/// and those around it are looked at, so that a deep node is not taken for one that came through from behind.
template <bool self>
std::optional<ContactPair> follow(Touch& touch, Index i, const TouchedFaces& faces, const ContactNodes& all,
                                  double dt) {
  Foot best = faces.foot(touch.face, all, i);
  if (best.point.where != ClosestPoint::inside || leans(best, faces))
    faces.take_nearest_around(
        touch.face, all.x[i], all.x, [&](Index f) { return self && faces.target.has(f, i); }, best);
  double side = touch.side;
  if (best.on_border) {
    if (faces.two_sided) {
      side = best.height < 0 ? -1 : 1;  // round the edge of a plate
    } else if (slid_off(best, faces, all)) {
      touch = {};
      return std::nullopt;
    }
  }
  touch.face = best.face, touch.side = side;
  const double height = side * best.height - faces.depth;
  touch.initial_depth = std::clamp(-height, 0.0, touch.initial_depth);
  const ContactPair pair = faces.pair(i, best, side, height + touch.initial_depth, touch);
  if (pair.gap > 0 && pair.gap + dt * pair.normal.dot(pair.velocity(all)) >= 0) {
    touch = {};
    return std::nullopt;
  }
  return pair;
}

}  // namespace strike::detail
