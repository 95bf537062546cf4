#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/crossing.hpp>
#include <strike/contact/first_touch.hpp>
#include <strike/contact/follow_touch.hpp>
#include <strike/contact/interior.hpp>
#include <strike/contact/near_faces.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/rounding.hpp>
#include <strike/contact/spacing.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// Nodes that may touch faces, and the pairs of each step. A touch begins when a node meets a face from outside, and
/// lasts until it separates. In a contact of a surface with itself a node does not touch its own faces.
template <bool self>
class Approach {
 public:
  Approach() = default;
  /// `depth` is the distance between the middle surfaces of touching plates, 0 of solids [length]; plates are
  /// two-sided.
  Approach(std::vector<Index> nodes, Target target, double depth, bool two_sided)
      : nodes_(std::move(nodes)), faces_{std::move(target), depth, two_sided} {}

  /// Nodes that start inside keep their initial depth without force until they separate.
  void begin(const ContactNodes& all, InitialPenetration& inside) {
    faces_.size = faces_.target.mean_size(all.x);
    if constexpr (self) {
      if (faces_.two_sided) start_ = all.x, neighbourhood_.find(faces_.target, start_, faces_.depth);
    }
    near_.sort(all, nodes_, faces_.target, faces_.depth, 0.5 * faces_.size);
    find_initial_depths(all, inside);
  }
  /// Other nodes and faces, both in ascending order of their numbers, after cells have gone. A touch goes on where its
  /// node and its face remain.
  void change(std::vector<Index> nodes, Target target) {
    std::vector<Touch> touches;
    std::size_t s = 0;
    for (Touch touch : touches_) {
      while (s < nodes.size() && nodes[s] < nodes_[touch.node]) ++s;
      if (s == nodes.size() || nodes[s] != nodes_[touch.node]) continue;
      touch.face = target.find(faces_.target.faces()[touch.face]);
      if (touch.face == Target::none) continue;
      touch.node = static_cast<Index>(s);
      touches.push_back(touch);
    }
    nodes_ = std::move(nodes), faces_.target = std::move(target), touches_ = std::move(touches);
    if (!start_.empty()) neighbourhood_.find(faces_.target, start_, faces_.depth);
    near_.forget();
  }

  /// Appends the pairs of the step, in the order of their nodes. `rounding` are nodes that come round an edge; those
  /// that go past one are added to it.
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs, Rounding& rounding) {
    near_.update(all, nodes_, faces_.target, faces_.depth, faces_.size, step.dt);
    last_.swap(touches_), touches_.clear();
    const std::size_t first_pair = pairs.size();
    auto touch = last_.begin();
    auto awake = near_.awake().begin();
    while (touch != last_.end() || awake != near_.awake().end()) {
      const bool touches = touch != last_.end() && (awake == near_.awake().end() || touch->node <= *awake);
      const Index s = touches ? touch->node : *awake;
      if (awake != near_.awake().end() && *awake == s) ++awake;
      const std::size_t first = touches_.size();
      for (; touch != last_.end() && touch->node == s; ++touch) follow(*touch, first, all, step.dt, pairs, rounding);
      while (touches_.size() < first + most_touches && begins_touch(s, first, all, step.dt, pairs, rounding)) {
      }
    }
    for (std::size_t k = 0; k < touches_.size(); ++k) remember(pairs[first_pair + k], touches_[k]);
  }
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    Rounding rounding;
    find(all, step, pairs, rounding);
  }
  /// Takes note that the impulses of the step have moved the nodes.
  void moved(const ContactNodes& all, double dt) { near_.moved(all, dt); }

  /// The step in which no node closes on a face by more than their gap and a share of the face, for a step of about
  /// `dt`, when positions have moved for a time `moved` at the present velocities.
  double closing_step(const ContactNodes& all, double moved, double dt) {
    double step = dt;
    if (moved == 0) near_.update(all, nodes_, faces_.target, faces_.depth, faces_.size, dt);  // before the first step
    if (!near_.may_close(dt, closing_share * faces_.size)) return step;
    for (const Index s : near_.awake()) {
      const Index i = nodes_[s];
      for (const Index f : near_.of(s)) {
        if (self && (faces_.target.has(f, i) || (faces_.two_sided && neighbourhood_.has(i, f)))) continue;
        const auto& corners = faces_.target.faces()[f];
        const bool is_triangle = faces_.target.count(f) == 3;
        Motion motion{{}, {}, all.x[i] + moved * all.v[i], dt * all.v[i], is_triangle};
        for (unsigned k = 0; k < 4; ++k) {
          motion.X[k] = all.x[corners[k]] + moved * all.v[corners[k]];
          motion.way_of_corners[k] = dt * all.v[corners[k]];
        }
        const Crossing meeting = crossing(motion, faces_.reach());
        if (!meeting.happens()) continue;
        double cell = faces_.size;
        for (unsigned k = 0; k < faces_.target.count(f); ++k)
          cell = std::min(cell, (motion.X[(k + 1) % faces_.target.count(f)] - motion.X[k]).norm());
        cell = std::max(cell, 0.1 * faces_.size);  // where an edge has collapsed
        step = std::min(step, detail::closing_step(meeting.when * meeting.rate, meeting.rate / dt, cell));
      }
    }
    return step;
  }

  /// True if a node, by its place among the nodes of the contact, touches.
  bool touches(Index i) const {
    const auto before = [&](const Touch& touch, Index node) { return nodes_[touch.node] < node; };
    const auto at = std::lower_bound(touches_.begin(), touches_.end(), i, before);
    return at != touches_.end() && nodes_[at->node] == i;
  }
  double size() const { return faces_.size; }
  /// The largest 1/m* of a node and a corner near it [1/mass]: a bound for the stiffness of springs.
  double largest_inverse_mass() const { return near_.largest_inverse_mass(); }
  std::size_t sorts() const { return near_.sorts(); }
  const std::vector<Index>& nodes() const { return nodes_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(nodes_, faces_.target, touches_, near_, neighbourhood_);
  }

 private:
  static constexpr std::size_t most_touches = 3;  // of a node, in the inner corner of three faces

  /// A touch of the last step goes on while the node is inside or will be at the end of the step; `first` is the
  /// node's first touch of this step.
  void follow(Touch touch, std::size_t first, const ContactNodes& all, double dt, std::vector<ContactPair>& pairs,
              Rounding& rounding) {
    const Index i = nodes_[touch.node];
    const auto place = FollowedTouch<self>(touch, i, faces_, all, near_.of(touch.node)).place();
    if (!place) return rounding.add(i);
    for (std::size_t k = first; k < touches_.size(); ++k)
      if (touches_[k].face == place->face) return void(touches_[k].stored += touch.stored);  // both have come here
    const double height = place->height - faces_.depth;
    touch.initial_depth = std::clamp(-height, 0.0, touch.initial_depth);
    const ContactPair pair = faces_.pair(i, *place, height + touch.initial_depth);
    check_depth(all.number(i), all.x[i], -pair.gap, std::max(faces_.size, faces_.depth));
    if (pair.gap > 0 && pair.gap + dt * pair.normal.dot(pair.velocity(all)) >= 0) return;
    touch.face = place->face;
    touch.normal = touch_normal(*place, all);
    touches_.push_back(touch), pairs.push_back(pair);
  }
  /// Appends a further touch of a node if it meets a face that its touches from `first` on do not cover.
  bool begins_touch(Index s, std::size_t first, const ContactNodes& all, double dt, std::vector<ContactPair>& pairs,
                    const Rounding& rounding) {
    const Index i = nodes_[s];
    FirstTouch<self> met(i, faces_, all, dt, neighbourhood_, std::span(touches_).subspan(first),
                         std::span(pairs).last(touches_.size() - first), rounding.has(i), near_.reach());
    for (const Index f : near_.of(s)) met.consider(f);
    const auto place = met.place();
    if (!place) return false;
    touches_.push_back({.node = s, .face = place->face, .normal = touch_normal(*place, all)});
    pairs.push_back(faces_.pair(i, *place, place->height - faces_.depth));
    return true;
  }

  /// Nodes within the depth of a plate or behind a near face of an open surface, and those inside a closed one.
  void find_initial_depths(const ContactNodes& all, InitialPenetration& inside) {
    if (faces_.target.faces().empty()) return;
    std::vector<Index> face(nodes_.size(), Target::none);
    if (!faces_.two_sided) {
      const Interior interior(faces_.target, all.x);
      for (std::size_t s = 0; s < nodes_.size(); ++s) face[s] = interior.nearest_face(nodes_[s]);
    }
    for (const Index s : near_.awake())
      if (face[s] == Target::none && (!self || faces_.two_sided)) face[s] = nearest_face(s, all);
    for (Index s = 0; s < nodes_.size(); ++s) {
      if (face[s] == Target::none) continue;
      const Index i = nodes_[s];
      const Foot foot = faces_.foot(face[s], all, i);
      const double side = faces_.two_sided && foot.height < 0 ? -1 : 1, depth = faces_.depth - side * foot.height;
      if (!(depth > faces_.reach().tolerance) || (foot.on_border && !faces_.two_sided)) continue;
      const Place place{foot.face, foot.point.N, side * foot.normal, side * foot.height};
      touches_.push_back({.node = s, .face = foot.face, .normal = touch_normal(place, all), .initial_depth = depth});
      inside.add(all.number(i), all.x[i], depth);
    }
  }
  Index nearest_face(Index s, const ContactNodes& all) const {
    const Index i = nodes_[s];
    Index best = Target::none;
    double least = std::numeric_limits<double>::infinity();
    for (const Index f : near_.of(s)) {
      if (self && neighbourhood_.has(i, f)) continue;
      const double distance2 = faces_.target.closest(f, faces_.target.corners(f, all.x), all.x[i]).distance2;
      if (distance2 < least) least = distance2, best = f;
    }
    return best;
  }
  /// The normal by which a touch remembers its side.
  Eigen::Vector3d touch_normal(const Place& place, const ContactNodes& all) const {
    return faces_.two_sided ? faces_.side_of_plate(place, all) : place.normal;
  }

  std::vector<Index> nodes_;
  TouchedFaces faces_;
  std::vector<Touch> touches_, last_;  // of this step and of the last, in the order of their nodes
  NearFaces<self> near_;
  std::vector<Eigen::Vector3d> start_;  // of plates that may touch themselves
  Neighbourhood neighbourhood_;
};

}  // namespace strike::detail
