#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/crossing.hpp>
#include <strike/contact/first_touch.hpp>
#include <strike/contact/follow_touch.hpp>
#include <strike/contact/found_touches.hpp>
#include <strike/contact/interior.hpp>
#include <strike/contact/near_faces.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/rounding.hpp>
#include <strike/contact/spacing.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// Nodes that may touch faces, and the pairs of each step. A touch begins when a node meets a face from outside, and
/// lasts until it separates. In a contact of a surface with itself a node does not touch its own faces.
template <bool self>
class Approach {
 public:
  Approach() = default;
  /// `half` is half the thickness of the plates of every ContactNode, 0 of solids [length].
  Approach(std::vector<Index> nodes, Target target, std::vector<double> half)
      : nodes_(std::move(nodes)), faces_{std::move(target), std::move(half)} {}

  /// Nodes that start inside keep their initial depth without force until they separate.
  void begin(const ContactNodes& all, InitialPenetration& inside) {
    faces_.size = faces_.target.mean_size(all.x);
    edge_ = inside.around.edge, least_edge_ = faces_.size;
    for (const Index i : nodes_) least_edge_ = std::min(least_edge_, edge_[i]);
    if constexpr (self) {
      if (faces_.target.largest_half() > 0) start_ = all.x, neighbourhood_.find(faces_.target, start_);
    }
    near_.sort(all, nodes_, faces_, 0.5 * faces_.size, never());
    find_initial_depths(all, inside);
  }
  /// Other nodes and faces, both in ascending order of their numbers, after cells have gone. A touch goes on where its
  /// node and its face remain. Nodes keep their `half`, for they have one even when their cells have gone.
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
    if (!start_.empty()) neighbourhood_.find(faces_.target, start_);
    near_.forget(), has_changed_ = true;
  }

  /// Appends the pairs of the step, in the order of their nodes, each of which is decided alone, by one of the
  /// processes of a run. `rounding` are nodes that come round an edge; those that go past one are added to it.
  template <class Execution>
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs, Rounding& rounding,
            const Execution& execution) {
    near_.update(all, nodes_, faces_, step.dt, never(), execution);
    const auto ranks = ranks_of(execution);
    mine_ = nodes_.size() < least_dealt ? Turns{} : Turns(ranks);
    last_.swap(touches_), touches_.clear();
    found_.resize(std::max<std::size_t>((near_.awake().size() + per_chunk - 1) / per_chunk, 1));
    for_each_unlike(execution, found_.size(),
                    [&](std::size_t c) { visit_chunk(c, all, step.dt, rounding, found_[c]); });
    const std::size_t first_pair = pairs.size();
    const auto take = [&](const FoundTouches& found) {
      if (const auto& deep = found.too_deep)
        check_depth(all.number(deep->node), all.x[deep->node], deep->depth, deep->most);
      touches_.insert(touches_.end(), found.touches.begin(), found.touches.end());
      pairs.insert(pairs.end(), found.pairs.begin(), found.pairs.end());
      for (const Index i : found.gone_past) rounding.add(i);
    };
    if (mine_.ranks > 1)
      take(of_all(ranks, found_));
    else
      for (const FoundTouches& found : found_) take(found);
    for (std::size_t k = 0; k < touches_.size(); ++k) remember(pairs[first_pair + k], touches_[k]);
  }
  template <class Execution>
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs, const Execution& execution) {
    Rounding rounding;
    find(all, step, pairs, rounding, execution);
  }

  /// The step in which no node of this process closes on a face by more than their gap and a share of the face, for a
  /// step of about `dt`, when positions have moved for a time `moved` at the present velocities.
  double closing_step(const ContactNodes& all, double moved, double dt) {
    double step = dt;
    if (moved == 0 || has_changed_)  // before the first step, or after a deletion
      near_.update(all, nodes_, faces_, dt, never(), Serial{}), has_changed_ = false;
    if (!near_.may_close(dt, closing_share * least_edge_)) return step;
    for (const Touch& touch : touches_) {  // springs let nodes deeper
      const Index i = nodes_[touch.node];
      const Place place{touch.face, faces_.projection(touch.face, all, i, touch.place).N, touch.normal, 0};
      const double closing = -touch.normal.dot(faces_.pair(i, place, 0).velocity(all)),
                   cell = cell_at(i, touch.face, all);
      if (closing * dt > closing_share * cell) step = std::min(step, detail::closing_step(0, closing, cell));
    }
    for (const Index s : near_.awake()) {
      if (!mine_.has(s)) continue;
      const Index i = nodes_[s];
      near_.each_within(s, dt, [&](Index f) {
        const auto& corners = faces_.target.faces()[f];
        const bool is_triangle = faces_.target.count(f) == 3;
        Motion motion{{}, {}, all.x[i] + moved * all.v[i], dt * all.v[i], is_triangle};
        for (unsigned k = 0; k < 4; ++k) {
          motion.X[k] = all.x[corners[k]] + moved * all.v[corners[k]];
          motion.way_of_corners[k] = dt * all.v[corners[k]];
        }
        const Crossing meeting = crossing(motion, faces_.reach(i, f));
        if (!meeting.happens()) return;
        step = std::min(step, detail::closing_step(meeting.when * meeting.rate, meeting.rate / dt, cell_at(i, f, all)));
      });
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

  static constexpr std::size_t per_chunk = 32;     // of nodes that are awake
  static constexpr std::size_t least_dealt = 256;  // nodes that are worth an exchange

  /// Visits the nodes from the first of a chunk of awake ones to the next chunk: those that touch, and those that are
  /// awake and have a face that does not rest.
  void visit_chunk(std::size_t c, const ContactNodes& all, double dt, const Rounding& rounding, FoundTouches& found) {
    found.clear();
    const std::vector<Index>& awake = near_.awake();
    const std::size_t first = c * per_chunk, last = std::min(first + per_chunk, awake.size());
    const Index end = last < awake.size() ? awake[last] : static_cast<Index>(nodes_.size());
    const auto before = [](const Touch& touch, Index s) { return touch.node < s; };
    auto touch = c == 0 ? last_.begin() : std::lower_bound(last_.begin(), last_.end(), awake[first], before);
    const auto visit_next = [&](Index s) {
      const auto from = touch;
      while (touch != last_.end() && touch->node == s) ++touch;
      if (mine_.has(s)) visit(s, std::span(from, touch), all, dt, rounding, found);
    };
    const auto visit_touches_before = [&](Index s) {
      while (touch != last_.end() && touch->node < s) visit_next(touch->node);
    };
    for (std::size_t k = first; k < last; ++k)
      if (const Index s = awake[k]; !near_.rests(s) || rounding.has(nodes_[s])) visit_touches_before(s), visit_next(s);
    visit_touches_before(end);
  }
  /// Follows the touches of a node and begins others.
  void visit(Index s, std::span<const Touch> before, const ContactNodes& all, double dt, const Rounding& rounding,
             FoundTouches& found) {
    const std::size_t first = found.touches.size(), gone_past = found.gone_past.size();
    for (const Touch& touch : before) follow(touch, first, all, dt, found);
    const bool comes_round = found.gone_past.size() > gone_past || rounding.has(nodes_[s]);
    // Faces rest only as long as the touches stay on theirs.
    const auto now = std::span(found.touches).subspan(first);
    bool look_at_all = comes_round || !std::equal(before.begin(), before.end(), now.begin(), now.end(),
                                                  [](const Touch& a, const Touch& b) { return a.face == b.face; });
    if (!look_at_all && near_.rests(s)) return;
    while (found.touches.size() < first + most_touches &&
           begins_touch(s, first, all, dt, comes_round, look_at_all, found)) {
      look_at_all = true;
    }
  }
  /// A touch of the last step goes on while the node is inside or will be at the end of the step; `first` is the
  /// node's first touch of this step.
  void follow(Touch touch, std::size_t first, const ContactNodes& all, double dt, FoundTouches& found) const {
    const Index i = nodes_[touch.node];
    const auto place = FollowedTouch<self>(touch, i, faces_, all, near_.of(touch.node)).place();
    if (!place) return found.gone_past.push_back(i);
    for (std::size_t k = first; k < found.touches.size(); ++k)
      if (found.touches[k].face == place->face)
        return void(found.touches[k].stored += touch.stored);  // both have come here
    const double depth = faces_.depth(i, place->face, place->N), height = place->height - depth;
    touch.initial_depth = std::clamp(-height, 0.0, touch.initial_depth);
    const ContactPair pair = faces_.pair(i, *place, height + touch.initial_depth);
    const double most = std::max(std::min(faces_.size, std::numbers::sqrt2 * edge_[i]), depth);
    if (-pair.gap > most && !found.too_deep) found.too_deep = FoundTouches::TooDeep{i, -pair.gap, most};
    if (pair.gap > 0 && pair.gap + dt * pair.normal.dot(pair.velocity(all)) >= 0) return;
    touch.face = place->face, touch.place = place->on_face();
    touch.normal = touch_normal(*place, all);
    found.touches.push_back(touch), found.pairs.push_back(pair);
  }
  /// Appends a further touch of a node if it meets a face that its touches from `first` on do not cover.
  bool begins_touch(Index s, std::size_t first, const ContactNodes& all, double dt, bool comes_round, bool looks_at_all,
                    FoundTouches& found) {
    const Index i = nodes_[s];
    FirstTouch met(i, faces_, all, dt, std::span(found.touches).subspan(first), std::span(found.pairs).subspan(first),
                   comes_round, near_.reach());
    near_.each_awake(s, looks_at_all, [&](Index f) { return met.consider(f); });
    const auto place = met.place();
    if (!place) return false;
    found.touches.push_back({.node = s, .face = place->face, .normal = touch_normal(*place, all)});
    found.pairs.push_back(faces_.pair(i, *place, place->height - faces_.depth(i, place->face, place->N)));
    return true;
  }

  /// The least edge of a face and of the cells of a node, but no less than a tenth of a mean diagonal of the faces or
  /// of that edge, where one has collapsed [length].
  double cell_at(Index i, Index f, const ContactNodes& all) const {
    const Corners X = faces_.target.corners(f, all.x);
    const unsigned count = faces_.target.count(f);
    double cell = std::min(faces_.size, edge_[i]);
    const double least = 0.1 * cell;
    for (unsigned k = 0; k < count; ++k) cell = std::min(cell, (X[(k + 1) % count] - X[k]).norm());
    return std::max(cell, least);
  }

  /// Nodes within the depth of a plate or behind a near face of an open surface, and those inside a closed one.
  void find_initial_depths(const ContactNodes& all, InitialPenetration& inside) {
    const Target& target = faces_.target;
    if (target.faces().empty()) return;
    std::vector<Index> face(nodes_.size(), Target::none);
    const Interior interior(target, all.x);
    for (std::size_t s = 0; s < nodes_.size(); ++s)
      face[s] = interior.nearest_face(nodes_[s], inside.around.outward[nodes_[s]], faces_.tolerance());
    for (const Index s : near_.awake())
      if (face[s] == Target::none) face[s] = nearest_face(s, all);
    for (Index s = 0; s < nodes_.size(); ++s) {
      if (face[s] == Target::none) continue;
      const Index i = nodes_[s];
      const Foot foot = faces_.foot(face[s], all, i);
      const bool is_plate = target.is_plate(foot.face);
      const double within = faces_.depth(i, foot.face, foot.point.N), out = foot.normal.dot(inside.around.outward[i]);
      // A solid in a plate has come from the side that it does not look to, even if it is past the middle.
      const bool looks = std::abs(foot.height) < within && std::abs(out) > 0.5;
      const double side = is_plate && (looks ? out > 0 : foot.height < 0) ? -1 : 1;
      const Place place{foot.face, foot.point.N, side * foot.normal, side * foot.height};
      const double depth = within - place.height;
      if (!(depth > depth_of_rounding(all.x[i], faces_.size)) || (!is_plate && is_beside(foot, all))) continue;
      inside.add(all, faces_.pair(i, place, -depth), faces_.tolerance());
      if (!(depth > faces_.tolerance())) continue;
      touches_.push_back({.node = s, .face = foot.face, .normal = touch_normal(place, all), .initial_depth = depth});
    }
  }
  /// True beyond the border of an open surface.
  bool is_beside(const Foot& foot, const ContactNodes& all) const {
    const Eigen::Vector3d normal = faces_.normal(foot.face, foot.point.N, all);
    return foot.on_border && (foot.point.away - normal.dot(foot.point.away) * normal).norm() > faces_.tolerance();
  }
  Index nearest_face(Index s, const ContactNodes& all) const {
    const Index i = nodes_[s];
    Index best = Target::none;
    double least = std::numeric_limits<double>::infinity();
    for (const Index f : near_.of(s)) {
      if (self && !faces_.is_at_a_distance(i, f)) continue;
      const double distance2 = faces_.target.closest(f, faces_.target.corners(f, all.x), all.x[i]).distance2;
      if (distance2 < least) least = distance2, best = f;
    }
    return best;
  }
  /// The faces that a node of the surface does not touch: its own, of its neighbourhood, or of a piece left out.
  auto never() const {
    return [this](Index i, Index f) {
      return self && (faces_.target.has(f, i) || (faces_.is_at_a_distance(i, f) && neighbourhood_.has(i, f)) ||
                      !faces_.target.may_touch(i, f));
    };
  }
  /// The normal by which a touch remembers its side.
  Eigen::Vector3d touch_normal(const Place& place, const ContactNodes& all) const {
    return faces_.target.is_plate(place.face) ? faces_.side_of_plate(place, all) : place.normal;
  }

  std::vector<Index> nodes_;
  TouchedFaces faces_;
  std::vector<Touch> touches_, last_;  // of this step and of the last, in the order of their nodes
  std::vector<FoundTouches> found_;    // by their chunks
  std::vector<double> edge_;           // the least of the cells of every ContactNode at the start [length]
  double least_edge_ = 0;              // of those and the size of the faces [length]
  bool has_changed_ = false;           // cells have gone since the last search
  Turns mine_;                         // the nodes that this process decides
  NearFaces<self> near_;
  std::vector<Eigen::Vector3d> start_;  // of plates that may touch themselves
  Neighbourhood neighbourhood_;
};

}  // namespace strike::detail
