#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/fly_over.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Positions at the end of the step with the present velocities, computed at the first demand.
class PositionsAhead {
 public:
  void clear() { x_.clear(); }
  const std::vector<Eigen::Vector3d>& of(const ContactNodes& all, double dt) {
    if (x_.empty())
      for (std::size_t k = 0; k < all.size(); ++k) x_.push_back(all.x[k] + dt * all.v[k]);
    return x_;
  }

 private:
  std::vector<Eigen::Vector3d> x_;
};

/// Candidates for the first touch of node i: the nearest of the faces that it may meet in this step from outside, or,
/// if it flies over faces, the one that it meets first. `neighbourhood` is that of self-contact of plates.
template <bool self>
class FirstTouch {
 public:
  FirstTouch(Index i, const TouchedFaces& faces, const ContactNodes& all, double dt, double reach,
             const Neighbourhood& neighbourhood)
      : i_(i), faces_(faces), all_(all), dt_(dt), reach_(reach), neighbourhood_(neighbourhood) {}

  void consider(Index f) {
    const Target& target = faces_.target;
    if (self && target.has(f, i_)) return;
    const Corners X = target.corners(f, all_.x);
    const bool flies = flies_over(f, faces_, all_, i_, dt_, reach_);
    if (!flies && (first_ <= 1 || is_farther(X))) return;
    if (is_off_plane(X)) return;
    if (self && faces_.two_sided && neighbourhood_.has(i_, f)) return;
    const ClosestPoint point = target.closest(f, X, all_.x[i_]);
    if (!flies && point.distance2 >= best_.point.distance2) return;
    const Foot foot = target.foot(f, X, point, all_.x);
    if (flies) {
      if (const double when = time_of_meeting(foot, faces_, all_, i_, dt_); when < first_) first_ = when, best_ = foot;
    } else if (faces_.is_outside(foot)) {
      best_ = foot;
    }
  }
  const Foot& best() const { return best_; }
  bool found() const { return best_.point.distance2 <= 1e30; }

  /// Appends the pair with the best of the faces, if the node is inside or will be at the end of the step.
  void begin(Touch& touch, PositionsAhead& ahead, std::vector<ContactPair>& pairs) {
    touch.face = best_.face;
    if (!found()) return;
    const double side = faces_.side_of(best_);
    if (first_ <= 1 && best_.point.where != ClosestPoint::inside) {  // along the normal of the face, not from its edge
      const Corners X = faces_.target.corners(best_.face, all_.x);
      best_.normal = faces_.face_normal(best_, X);
      best_.height = best_.normal.dot(best_.point.away);
    }
    const double gap = side * best_.height - faces_.depth;
    const ContactPair pair = faces_.pair(i_, best_, side, gap, touch);
    if (gap > 0) {
      if (gap + dt_ * pair.normal.dot(pair.velocity(all_)) >= 0) return;
      if (first_ > 1 && best_.point.where != ClosestPoint::inside && !will_be_inside(ahead.of(all_, dt_), side)) return;
    }
    touch = {.side = side, .initial_depth = std::max(-gap, 0.0), .face = best_.face};
    pairs.push_back(pair);
    pairs.back().gap = std::max(gap, 0.0);
  }

 private:
  /// True if the box around a face is farther than the best face.
  bool is_farther(const Corners& X) const {
    const Eigen::Vector3d& x = all_.x[i_];
    double distance2 = 0;
    for (int c = 0; c < 3; ++c) {
      const auto [lower, upper] = std::minmax({X[0](c), X[1](c), X[2](c), X[3](c)});
      const double apart = std::max({lower - x(c), x(c) - upper, 0.0});
      distance2 += apart * apart;
    }
    return distance2 >= best_.point.distance2;
  }
  /// True if the node is farther from the plane of a face than the step carries it; the warp of the face counts too.
  bool is_off_plane(const Corners& X) const {
    const Eigen::Vector3d area = cross<double>(X[2] - X[0], X[3] - X[1]);
    const double from_plane = (all_.x[i_] - 0.25 * (X[0] + X[1] + X[2] + X[3])).dot(area),
                 warp = 0.25 * (X[0] - X[1] + X[2] - X[3]).norm();
    return std::abs(from_plane) > (faces_.depth + reach_ + warp) * area.norm();
  }
  /// True if a node that comes to an edge or a corner is inside at the end of the step, rather than past it.
  bool will_be_inside(std::span<const Eigen::Vector3d> ahead, double side) const {
    Foot foot;
    faces_.take_nearest_around(
        best_.face, ahead[i_], ahead, [&](Index f) { return self && faces_.target.has(f, i_); }, foot);
    if (foot.on_border && !faces_.two_sided) return false;
    return (foot.on_border ? std::abs(foot.height) : side * foot.height) < faces_.depth;
  }

  Index i_;
  const TouchedFaces& faces_;
  const ContactNodes& all_;
  double dt_, reach_;
  const Neighbourhood& neighbourhood_;
  Foot best_;
  double first_ = 2;  // when the node meets the best face, as a fraction of the step; 2: it does not fly over faces
};

/// Appends the pair of a first touch with one of the faces near a node; the face of the step before is considered
/// first, for it spares most others.
template <bool self>
void begin_touch(FirstTouch<self> candidates, Touch& touch, std::span<const Index> near, PositionsAhead& ahead,
                 std::vector<ContactPair>& pairs) {
  const Index last = touch.face;
  if (std::find(near.begin(), near.end(), last) != near.end()) candidates.consider(last);
  for (const Index f : near)
    if (f != last || !candidates.found()) candidates.consider(f);
  candidates.begin(touch, ahead, pairs);
}

}  // namespace strike::detail
