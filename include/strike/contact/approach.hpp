#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// What a node remembers while it touches.
struct Touch {
  double side = 0;        ///< of the plate that it came to: 1 or -1; 0: it touches nothing
  double given_away = 0;  ///< how deep it may be, for it began so deep [length]
  double stored = 0;      ///< by the law [energy]
  Index face = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(side, given_away, stored, face);
  }
};

/// The nodes that began inside, and the deepest of them.
struct Beginners {
  std::size_t count = 0;
  Index deepest = 0;  ///< its number in the scene
  double depth = 0;

  void take(Index number, double d) {
    ++count;
    if (d > depth) depth = d, deepest = number;
  }
};

/// Nodes on their way to the faces of a target: who touches what in the step to come. A node touches if it is inside,
/// or will be at the end of the step with the velocities that it has. While it does, only its face and those around it
/// are looked at, so that what is deep is not taken for what has come through from behind. In a contact of a surface
/// with itself a node does not touch the faces that it belongs to.
template <bool self>
class Approach {
 public:
  Approach() = default;
  /// `depth` is the distance between the middle surfaces of touching plates, 0 of solids; two-sided if plates.
  Approach(std::vector<Index> nodes, Target target, double depth, bool two_sided)
      : nodes_(std::move(nodes)), target_(std::move(target)), depth_(depth), two_sided_(two_sided) {
    touches_.resize(nodes_.size());
  }

  /// Those that are inside at the start stay as deep as they are without force, until they leave.
  void begin(const ContactNodes& all, Beginners& beginners) {
    size_ = target_.mean_size(all.x);
    if constexpr (self) {
      if (two_sided_) at_begin_ = all.x;
    }
    sort(all, 0.5 * size_);
    if constexpr (self) return;
    for (const Index s : search_.awake()) {
      const Index i = nodes_[s];
      Foot best;
      for (const Index f : search_.near(s))
        if (const Foot foot = over(f, all, i); foot.point.distance2 < best.point.distance2) best = foot;
      const double side = two_sided_ && best.height < 0 ? -1 : 1, gap = side * best.height - depth_;
      if (!(gap < 0) || best.point.distance2 > 1e30 || (best.on_border && !two_sided_)) continue;
      touches_[s] = {.side = side, .given_away = -gap, .face = best.face};
      if (-gap > 1e-6 * size_) beginners.take(all.number(i), -gap);
    }
  }
  /// What was known of faces that are no more.
  void forget(std::vector<Index> nodes, Target target) {
    nodes_ = std::move(nodes), target_ = std::move(target);
    touches_.assign(nodes_.size(), {}), corners_.clear(), margin_ = -1;
  }

  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    const double speed = relative_speed(all);
    reach_ = step.dt * speed;
    if (!(travelled_ + reach_ <= margin_)) sort(all, std::max(3 * reach_, 0.25 * size_));
    travelled_ += reach_;
    ahead_.clear();
    for (const Index s : search_.awake()) {
      Touch& touch = touches_[s];
      if (touch.side != 0)
        stay(s, all, step, pairs);
      else
        come(s, all, step, pairs);
    }
  }
  /// After the impulses of the step: nodes that they have sped up have come farther than was foreseen.
  void moved(const ContactNodes& all, double dt) {
    double most = 0;
    for (const Index i : all.touched()) most = std::max(most, (all.v[i] - mean_velocity_).norm());
    travelled_ += std::max(0.0, 2 * dt * most - reach_);
  }

  double size() const { return size_; }
  /// The largest 1/m* of a node and a corner near it: what a spring needs at most.
  double largest_inverse_mass() const { return largest_inverse_mass_; }
  std::size_t sorts() const { return sorts_; }
  const std::vector<Index>& nodes() const { return nodes_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(nodes_, corners_, target_, touches_, search_, margin_, travelled_, largest_inverse_mass_, sorts_);
  }

 private:
  void sort(const ContactNodes& all, double margin) {
    ++sorts_;
    const double asleep = search_.sort(nodes_, target_.faces(), all.x, depth_ + margin);
    margin_ = margin + asleep, travelled_ = 0;
    largest_inverse_mass_ = 0;
    for (const Index s : search_.awake()) {
      double corner = 0;
      for (const Index f : search_.near(s))
        for (const Index i : target_.faces()[f]) corner = std::max(corner, all.inverse_mass(i));
      largest_inverse_mass_ = std::max(largest_inverse_mass_, all.inverse_mass(nodes_[s]) + corner);
    }
  }

  /// The largest speed of the nodes and of the faces relative to what these do on the average.
  double relative_speed(const ContactNodes& all) {
    if (corners_.empty()) {
      for (const auto& face : target_.faces()) corners_.insert(corners_.end(), face.begin(), face.end());
      std::sort(corners_.begin(), corners_.end());
      corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Index i : corners_) sum += all.v[i];
    mean_velocity_ = (1 / static_cast<double>(corners_.size())) * sum;
    const auto fastest = [&](const std::vector<Index>& some) {
      double most = 0;
      for (const Index i : some) most = std::max(most, (all.v[i] - mean_velocity_).squaredNorm());
      return std::sqrt(most);
    };
    const double of_faces = fastest(corners_);
    return of_faces + (self ? of_faces : fastest(nodes_));
  }

  Foot over(Index f, const ContactNodes& all, Index i) const {
    return target_.foot(f, target_.corners(f, all.x), all.x[i], all.x);
  }

  ContactPair pair_of(Index s, const Foot& foot, double side, double gap) {
    const Index f = foot.face;
    ContactPair pair;
    pair.node = nodes_[s], pair.N = foot.point.N, pair.count = target_.count(f);
    pair.corners = target_.faces()[f];
    pair.normal = side * foot.normal;
    pair.gap = gap;
    pair.stored = &touches_[s].stored;
    return pair;
  }

  /// A node that has touched: it still does as long as it is inside or will be.
  void stay(Index s, const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    Touch& touch = touches_[s];
    const Index i = nodes_[s];
    Foot best = over(touch.face, all, i);
    const auto consider = [&](Index f) {
      if (self && target_.has(f, i)) return;
      if (const Foot foot = over(f, all, i); foot.point.distance2 < best.point.distance2) best = foot;
    };
    if (best.point.where != ClosestPoint::inside || leans(best))
      for (unsigned k = 0; k < target_.count(touch.face); ++k)
        for (const Index f : target_.at(target_.faces()[touch.face][k])) consider(f);
    double side = touch.side;
    if (best.on_border) {
      if (two_sided_)
        side = best.height < 0 ? -1 : 1;  // round the edge of a plate
      else if (slid_off(best, all))
        return void(touch = {});
    }
    touch.face = best.face, touch.side = side;
    const double height = side * best.height - depth_;
    touch.given_away = std::clamp(-height, 0.0, touch.given_away);
    ContactPair pair = pair_of(s, best, side, height + touch.given_away);
    if (pair.gap > 0 && pair.gap + step.dt * pair.normal.dot(pair.velocity(all)) >= 0) return void(touch = {});
    pairs.push_back(pair);
  }
  /// Whether a face around may be closer although the foot is inside this one: in a dent, or deep below a crest.
  bool leans(const Foot& foot) const { return foot.point.distance2 > 1e-4 * size_ * size_; }
  /// Past the border of an open surface rather than through it.
  bool slid_off(const Foot& foot, const ContactNodes& all) const {
    const Corners X = target_.corners(foot.face, all.x);
    const double down = normal_at(X, foot.point.N, target_.count(foot.face) == 3).dot(foot.point.away);
    return foot.point.distance2 > 2 * down * down + 1e-24 * size_ * size_;
  }

  /// A node that touches nothing yet: the nearest face that it may meet in this step from outside.
  void come(Index s, const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    const Index i = nodes_[s];
    Foot best;
    double first = 2;  // when, as a part of the step, it meets a face that it flies to
    const auto consider = [&](Index f) {
      if (self && target_.has(f, i)) return;
      const Corners X = target_.corners(f, all.x);
      const bool flies = flies_over(f, all, i, step.dt);
      if (!flies && (first <= 1 || farther(X, all.x[i], best.point.distance2))) return;
      const Eigen::Vector3d area = cross<double>(X[2] - X[0], X[3] - X[1]);
      const double from_plane = (all.x[i] - 0.25 * (X[0] + X[1] + X[2] + X[3])).dot(area),
                   warp = 0.25 * (X[0] - X[1] + X[2] - X[3]).norm();
      if (std::abs(from_plane) > (depth_ + reach_ + warp) * area.norm()) return;
      if (self && two_sided_ && is_neighbourhood(f, i)) return;
      const ClosestPoint point = target_.closest(f, X, all.x[i]);
      if (!flies && point.distance2 >= best.point.distance2) return;
      const Foot foot = target_.foot(f, X, point, all.x);
      if (flies) {
        if (const double when = meets(foot, all, i, step.dt); when < first) first = when, best = foot;
      } else if (is_outside(foot)) {
        best = foot;
      }
    };
    const Index last = touches_[s].face;  // the nearest of the step before comes first, and spares the others
    const auto near = search_.near(s);
    if (std::find(near.begin(), near.end(), last) != near.end()) consider(last);
    for (const Index f : near)
      if (f != last || best.point.distance2 > 1e30) consider(f);
    touches_[s].face = best.face;
    if (best.point.distance2 > 1e30) return;
    const double side = two_sided_ && best.height < 0 ? -1 : 1;
    if (first <= 1 && best.point.where != ClosestPoint::inside) {  // along the normal of the face, not from its edge
      const Corners X = target_.corners(best.face, all.x);
      best.normal = normal_at(X, best.point.N, target_.count(best.face) == 3);
      best.height = best.normal.dot(best.point.away);
    }
    const double gap = side * best.height - depth_;
    const ContactPair pair = pair_of(s, best, side, gap);
    if (gap > 0) {
      if (gap + step.dt * pair.normal.dot(pair.velocity(all)) >= 0) return;
      if (first > 1 && best.point.where != ClosestPoint::inside && !will_be_inside(best, all, i, step.dt, side)) return;
    }
    touches_[s] = {.side = side, .given_away = std::max(-gap, 0.0), .face = best.face};
    pairs.push_back(pair);
    pairs.back().gap = std::max(gap, 0.0);
  }

  /// Whether the box around a face is farther than a distance.
  static bool farther(const Corners& X, const Eigen::Vector3d& x, double distance2) {
    const Eigen::Vector3d lower = X[0].cwiseMin(X[1]).cwiseMin(X[2].cwiseMin(X[3])),
                          upper = X[0].cwiseMax(X[1]).cwiseMax(X[2].cwiseMax(X[3]));
    return (lower - x).cwiseMax(x - upper).cwiseMax(0.0).squaredNorm() >= distance2;
  }
  bool is_outside(const Foot& foot) const { return two_sided_ || foot.height >= -1e-6 * size_; }
  /// Plates within a thickness of a node at the start are its own neighbourhood.
  bool is_neighbourhood(Index f, Index i) const {
    return target_.foot(f, target_.corners(f, at_begin_), at_begin_[i], at_begin_).point.distance2 <
           1.02 * depth_ * depth_;
  }
  /// Whether a step carries the node by as much as the size of the face, so that the face that is nearest now need not
  /// be the one that it meets.
  bool flies_over(Index f, const ContactNodes& all, Index i, double dt) const {
    if (4 * reach_ < size_) return false;
    const auto& c = target_.faces()[f];
    const Eigen::Vector3d v = all.v[i] - 0.25 * (all.v[c[0]] + all.v[c[1]] + all.v[c[2]] + all.v[c[3]]);
    return 4 * dt * v.norm() > size_;
  }
  /// When the node meets the face, as a part of the step; 2 if it misses it.
  double meets(const Foot& foot, const ContactNodes& all, Index i, double dt) const {
    const Corners X = target_.corners(foot.face, all.x);
    const Eigen::Vector3d normal = normal_at(X, foot.point.N, target_.count(foot.face) == 3);
    Eigen::Vector3d v = all.v[i];
    for (unsigned k = 0; k < 4; ++k) v -= foot.point.N[k] * all.v[target_.faces()[foot.face][k]];
    double height = normal.dot(foot.point.away), rate = dt * normal.dot(v);
    if (two_sided_ && height < 0) height = -height, rate = -rate;
    if (!two_sided_ && height < -1e-6 * size_) return 2;
    const double gap = height - depth_;
    if (gap + rate >= 0) return 2;
    const double when = gap > 0 ? -gap / rate : 0.0;
    const Corners then = target_.corners(foot.face, all.x, all.v, when * dt);
    const Eigen::Vector3d at = all.x[i] + when * dt * all.v[i];
    return std::sqrt(target_.closest(foot.face, then, at).distance2) <= depth_ + 0.02 * size_ ? when : 2;
  }
  /// Whether a node that comes to an edge or a corner will really be inside, or flies past.
  bool will_be_inside(const Foot& foot, const ContactNodes& all, Index i, double dt, double side) {
    if (ahead_.empty())
      for (std::size_t k = 0; k < all.size(); ++k) ahead_.push_back(all.x[k] + dt * all.v[k]);
    Foot best;
    const auto& own = target_.faces()[foot.face];
    for (unsigned k = 0; k < target_.count(foot.face); ++k)
      for (const Index f : target_.at(own[k])) {
        if (self && target_.has(f, i)) continue;
        const Foot other = target_.foot(f, target_.corners(f, ahead_), ahead_[i], ahead_);
        if (other.point.distance2 < best.point.distance2) best = other;
      }
    if (best.on_border && !two_sided_) return false;
    return (best.on_border ? std::abs(best.height) : side * best.height) < depth_;
  }

  std::vector<Index> nodes_, corners_;
  Target target_;
  double depth_ = 0;
  bool two_sided_ = false;
  std::vector<Touch> touches_;
  BucketSearch search_;
  std::vector<Eigen::Vector3d> at_begin_, ahead_;
  Eigen::Vector3d mean_velocity_ = Eigen::Vector3d::Zero();
  double size_ = 0, margin_ = -1, travelled_ = 0, reach_ = 0, largest_inverse_mass_ = 0;
  std::size_t sorts_ = 0;
};

}  // namespace strike::detail
