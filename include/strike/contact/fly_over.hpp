#pragma once
#include <cmath>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// The step carries node i by more than a quarter of the size of face f, so that the nearest face now need not be the
/// one that it meets. `reach` bounds the way of any node in the step [length].
inline bool flies_over(Index f, const TouchedFaces& faces, const ContactNodes& all, Index i, double dt, double reach) {
  if (4 * reach < faces.size) return false;
  const auto& c = faces.target.faces()[f];
  const Eigen::Vector3d v = all.v[i] - 0.25 * (all.v[c[0]] + all.v[c[1]] + all.v[c[2]] + all.v[c[3]]);
  return 4 * dt * v.norm() > faces.size;
}

/// The time at which node i meets the face of a foot, as a fraction of the step; 2 if it misses it.
inline double time_of_meeting(const Foot& foot, const TouchedFaces& faces, const ContactNodes& all, Index i,
                              double dt) {
  constexpr double never = 2;
  const Corners X = faces.target.corners(foot.face, all.x);
  const Eigen::Vector3d normal = faces.face_normal(foot, X);
  Eigen::Vector3d v = all.v[i];
  for (unsigned k = 0; k < 4; ++k) v -= foot.point.N[k] * all.v[faces.target.faces()[foot.face][k]];
  double height = normal.dot(foot.point.away), rate = dt * normal.dot(v);
  if (faces.two_sided && height < 0) height = -height, rate = -rate;
  if (!faces.two_sided && height < -1e-6 * faces.size) return never;
  const double gap = height - faces.depth;
  if (gap + rate >= 0) return never;
  const double when = gap > 0 ? -gap / rate : 0.0;
  const Corners then = faces.target.corners(foot.face, all.x, all.v, when * dt);
  const Eigen::Vector3d at = all.x[i] + when * dt * all.v[i];
  return std::sqrt(faces.target.closest(foot.face, then, at).distance2) <= faces.depth + 0.02 * faces.size ? when
                                                                                                           : never;
}

}  // namespace strike::detail
