#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/crossing.hpp>
#include <strike/contact/follow_touch.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// The faces that a node meets from outside, in the step to come with its present velocity or in the last one as it
/// was, for impulses of other pairs may have carried it in. The first counts; of those that it meets at once, on their
/// common edge, each by its rate of approach: a face along which it flies does not, a ridge gives its mean.
/// `touches` are those that the node has already, in `pairs`; a node that comes round an edge, where another touch has
/// ended, may be a little inside.
class FirstTouch {
 public:
  FirstTouch(Index i, const TouchedFaces& faces, const ContactNodes& all, double dt, std::span<const Touch> touches,
             std::span<const ContactPair> pairs, bool comes_round, double farthest)
      : i_(i),
        faces_(faces),
        all_(all),
        dt_(dt),
        way_(dt * all.v[i]),
        farthest_(farthest + faces.tolerance()),
        comes_round_(comes_round),
        touches_(touches) {
    // Touches let the node no deeper into their faces.
    for (const ContactPair& pair : pairs)
      way_ += std::max(0.0, -std::max(0.0, pair.gap) - dt * pair.normal.dot(pair.velocity(all))) * pair.normal;
  }

  /// Looks whether the node meets face f. Returns by how much both may move relative to each other before they can, as
  /// long as the node's touches stay on their faces [length].
  double consider(Index f) {
    const bool slack = comes_round_ && !faces_.is_at_a_distance(i_, f);
    const double deep = faces_.largest_depth(i_, f) + (slack ? faces_.slack() : 0);
    const Disc disc(faces_.target, f, all_.x, all_.x[i_]);
    for (const Touch& touch : touches_) {  // a face that goes on from one that the node touches
      if (touch.face == f) return never;
      const double cosine = std::abs(touch.normal.dot(disc.area)) / std::sqrt(disc.area2);
      if (cosine > in_line && faces_.go_together(f, touch.face)) {
        const double turns = sine(in_line) - sine(cosine);  // a bound from below of the angle by which they may turn
        // 8 ways of its corners turn a square by 1, and both may turn.
        return turns * std::sqrt(disc.area2 / disc.radius2) / 32;
      }
    }
    const double clearance = disc.distance() - deep;
    if (clearance > farthest_ || (clearance > 0 && clearance > way_to(f) + faces_.tolerance())) return clearance;
    const Corners X = faces_.target.corners(f, all_.x);
    Reach reach = faces_.reach(i_, f);
    if (slack) reach.slack = faces_.slack();
    const bool is_at = !(disc.above - deep > reach.tolerance);
    if (reach.two_sided || disc.height > 0 || is_at) {
      if (const Crossing next = in_step(f, X, reach); next.happens()) return meet(f, next, next.when), 0;
    }
    if (reach.two_sided || disc.height <= 0 || is_at) {
      if (const Crossing last = in_last_step(f, X, reach); last.happens()) meet(f, last, last.when - 1);
    }
    return 0;
  }

  /// Where the node touches first, as it stands now; nothing if it meets no face.
  std::optional<Place> place() const {
    if (first_.face == Target::none) return std::nullopt;
    return now(first_.face, first_.crossing, direction(sum_));
  }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr double in_line = 0.9;  // cosine of normals, from which on a face goes on from another

  /// A disc around a face, as thick as its warp, seen from a node.
  struct Disc {
    Eigen::Vector3d area;  // normal, twice the area long
    double area2, radius2, height, above, beside;

    [[gnu::__flatten__]] Disc(const Target& target, Index f, std::span<const Eigen::Vector3d> positions,
                              const Eigen::Vector3d& x) {
      const Corners X = target.corners(f, positions);
      const Eigen::Vector3d diagonals[] = {X[2] - X[0], X[3] - X[1]}, from = x - 0.25 * (X[0] + X[1] + X[2] + X[3]);
      const double warp = 0.25 * (X[0] - X[1] + X[2] - X[3]).norm();
      area = cross<double>(diagonals[0], diagonals[1]), area2 = area.squaredNorm();
      radius2 = 0.25 * std::max(diagonals[0].squaredNorm(), diagonals[1].squaredNorm());
      height = from.dot(area);
      const double up2 = height * height / area2, along = std::sqrt(std::max(0.0, from.squaredNorm() - up2));
      above = std::sqrt(up2) - (target.count(f) == 3 ? 0 : warp), beside = along - std::sqrt(radius2) - warp;
    }
    double distance() const {
      const double a = std::max(0.0, above), b = std::max(0.0, beside);
      return std::sqrt(a * a + b * b);
    }
  };

  /// The farthest way of the node relative to a corner of the face, in the step to come or in the last one [length].
  [[gnu::__flatten__]] double way_to(Index f) const {
    const Eigen::Vector3d last = all_.x[i_] - all_.x_before[i_];
    double most2 = 0;
    for (const Index k : faces_.target.faces()[f]) {
      const Eigen::Vector3d next_way = way_ - dt_ * all_.v[k], last_way = last - (all_.x[k] - all_.x_before[k]);
      most2 = std::max({most2, next_way.squaredNorm(), last_way.squaredNorm()});
    }
    return std::sqrt(most2);
  }
  static double sine(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }

  struct Met {
    Index face = Target::none;
    Crossing crossing;
    double when = 2;  // in steps, from now
  };

  Crossing in_step(Index f, const Corners& X, const Reach& reach) const {
    Motion motion{X, {}, all_.x[i_], way_, faces_.target.count(f) == 3};
    for (unsigned k = 0; k < 4; ++k) motion.way_of_corners[k] = dt_ * all_.v[faces_.target.faces()[f][k]];
    return crossing(motion, reach);
  }
  Crossing in_last_step(Index f, const Corners& X, const Reach& reach) const {
    const Target& target = faces_.target;
    Motion motion{
        target.corners(f, all_.x_before), {}, all_.x_before[i_], all_.x[i_] - all_.x_before[i_], target.count(f) == 3};
    for (unsigned k = 0; k < 4; ++k) motion.way_of_corners[k] = X[k] - motion.X[k];
    return crossing(motion, reach);
  }

  void meet(Index f, const Crossing& crossing, double when) {
    const bool at_a_distance = faces_.is_at_a_distance(i_, f);
    if (is_part_of_a_touch(f, crossing)) return;
    // At a distance the faces of a common edge have one normal, that of the one which is met first.
    const double rate = std::max(crossing.rate, first_.crossing.rate);
    const double near = at_a_distance ? 0.0 : 4 * faces_.tolerance();
    const bool at_once = std::abs(when - first_.when) * rate <= near;
    if (!at_once && when > first_.when) return;
    if (at_once && first_.face != Target::none && !is_crest(f, first_.face)) {  // in a dent each is a touch of its own
      if (crossing.rate > first_.crossing.rate) sum_ = crossing.normal, first_ = {f, crossing, when};
      return;
    }
    if (!at_once) sum_.setZero(), first_ = {};
    const double weight = std::pow(std::min(crossing.rate, first_.crossing.rate) / rate, 4);
    if (crossing.rate > first_.crossing.rate) {
      sum_ = weight * sum_ + crossing.normal;
      first_ = {f, crossing, when};
    } else {
      sum_ += weight * crossing.normal;
    }
  }

  /// True for what a touch of the node will pass to by itself, or which lies beyond a crest that the node touches.
  bool is_part_of_a_touch(Index f, const Crossing& crossing) const {
    for (const Touch& touch : touches_) {
      if (touch.face == f) return true;
      const bool connected = faces_.go_together(f, touch.face);
      if (goes_on(touch.normal, crossing.normal)) {
        const double apart = std::abs(touch.normal.dot(faces_.way_to(i_, f, crossing.point.N, all_)));
        if (connected ? !is_sharp_dent(touch, f) : apart < 0.02 * faces_.size) return true;
      } else if (faces_.target.is_plate(f) ? connected && crossing.point.where != ClosestPoint::inside
                                           : is_below_crest(touch, f)) {
        return true;
      }
    }
    return false;
  }
  /// True if two faces hang together and each lies behind the other or in its plane.
  bool is_crest(Index f, Index other) const {
    const Eigen::Vector3d apart = faces_.target.middle(other, all_.x) - faces_.target.middle(f, all_.x);
    const double level = 1e-3 * apart.norm();
    return faces_.are_connected(f, other) && faces_.normal(f, all_).dot(apart) < level &&
           faces_.normal(other, all_).dot(apart) > -level;
  }
  /// True if the touched face of a solid and face f meet in a dent of more than 25 degrees, where a node touches both.
  bool is_sharp_dent(const Touch& touch, Index f) const {
    const Eigen::Vector3d normal = faces_.normal(f, all_), own = faces_.normal(touch.face, all_);
    const Eigen::Vector3d apart = faces_.target.middle(f, all_.x) - faces_.target.middle(touch.face, all_.x);
    return !faces_.is_at_a_distance(i_, f) && own.dot(normal) < 0.9 && own.dot(apart) > 0 && normal.dot(apart) < 0;
  }
  /// True if the node is near a crest of face f that its touch has reached from the other side: as deep as it is
  /// behind its face it may be beside the crest.
  bool is_below_crest(const Touch& touch, Index f) const {
    const Target& target = faces_.target;
    const Projection foot = faces_.projection(touch.face, all_, i_);
    const double near = std::max(0.0, -touch.normal.dot(foot.away)) + 0.02 * faces_.size;
    const Corners X = target.corners(f, all_.x);
    for (unsigned k = 0; k < target.count(f); ++k) {
      const Index other = target.across(f, k);
      if (other == Target::none || !goes_on(touch.normal, faces_.normal(other, all_))) continue;
      const Eigen::Vector3d from = all_.x[i_] - X[k], edge = direction(X[(k + 1) % target.count(f)] - X[k]);
      const bool is_dent = faces_.normal(f, all_).dot(target.middle(other, all_.x) - X[k]) > 0;
      if (!is_dent && (from - edge.dot(from) * edge).norm() < near) return true;
    }
    return false;
  }

  /// The place of a crossing at the start of the step, with the normal through both points where the step is short: no
  /// impulse then has a moment.
  Place now(Index f, const Crossing& crossing, const Eigen::Vector3d& normal) const {
    Place place{f, crossing.point.N, normal, 0};
    const bool on_ridge = normal.dot(crossing.normal) < 1 - 1e-9;
    if (const Projection foot = faces_.projection(f, all_, i_);
        !on_ridge && foot.beyond < 0.5 &&
        (!faces_.is_at_a_distance(i_, f) || crossing.point.where == ClosestPoint::inside)) {
      const Eigen::Vector3d n = faces_.normal(f, foot.N, all_);
      place.N = foot.N, place.normal = n.dot(normal) < 0 ? -n : n;
    } else if (const Foot near = faces_.foot(f, all_, i_);
               on_ridge || crossing.rate < faces_.depth(i_, f, crossing.point.N)) {
      const double side = near.normal.dot(normal) < 0 ? -1 : 1;
      if (side * near.normal.dot(normal) > 0.9) place.N = near.point.N, place.normal = side * near.normal;
    }
    place.height = place.normal.dot(faces_.way_to(i_, f, place.N, all_));
    return place;
  }

  Index i_;
  const TouchedFaces& faces_;
  const ContactNodes& all_;
  double dt_;
  Eigen::Vector3d way_;  // of the node in the step to come [length]
  double farthest_;      // way relative to a face in a step [length]
  bool comes_round_;
  std::span<const Touch> touches_;
  Met first_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
};

}  // namespace strike::detail
