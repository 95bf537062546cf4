#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/first_touch.hpp>
#include <strike/contact/follow_touch.hpp>
#include <strike/contact/near_faces.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// Nodes that may touch faces, and the pairs of each step. A node touches if it is inside, or will be at the end of the
/// step with its present velocity. In a contact of a surface with itself a node does not touch its own faces.
template <bool self>
class Approach {
 public:
  Approach() = default;
  /// `depth` is the distance between the middle surfaces of touching plates, 0 of solids [length]; plates are
  /// two-sided.
  Approach(std::vector<Index> nodes, Target target, double depth, bool two_sided)
      : nodes_(std::move(nodes)), faces_{std::move(target), depth, two_sided}, touches_(nodes_.size()) {}

  /// Nodes that start inside keep their initial depth without force until they separate.
  void begin(const ContactNodes& all, InitialPenetration& inside) {
    faces_.size = faces_.target.mean_size(all.x);
    if constexpr (self) {
      if (faces_.two_sided) start_ = all.x, neighbourhood_.find(faces_.target, start_, faces_.depth);
    }
    near_.sort(all, nodes_, faces_.target, faces_.depth, 0.5 * faces_.size);
    if (!self || faces_.two_sided) find_initial_depths(all, inside);
  }
  /// Other nodes and faces, both in ascending order of their numbers, after cells have gone. A touch goes on where its
  /// node and its face remain.
  void change(std::vector<Index> nodes, Target target) {
    std::vector<Touch> touches(nodes.size());
    touching_.clear();
    std::size_t last = 0;
    for (std::size_t s = 0; s < nodes.size(); ++s) {
      while (last < nodes_.size() && nodes_[last] < nodes[s]) ++last;
      if (last == nodes_.size() || nodes_[last] != nodes[s] || touches_[last].side == 0) continue;
      const FaceCorners& corners = faces_.target.faces()[touches_[last].face];
      const Index face = target.find(corners);
      if (face == Target::none) continue;
      touches[s] = touches_[last], touches[s].face = face;
      if (target.faces()[face] != corners) touches[s].side = -touches[s].side;  // its piece faces the other side now
      touching_.push_back(static_cast<Index>(s));
    }
    nodes_ = std::move(nodes), faces_.target = std::move(target), touches_ = std::move(touches);
    if (!start_.empty()) neighbourhood_.find(faces_.target, start_, faces_.depth);
    near_.forget();
  }

  /// Appends the pairs of the step, in the order of their nodes.
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    near_.update(all, nodes_, faces_.target, faces_.depth, faces_.size, step.dt);
    ahead_.clear();
    visited_.clear();
    std::set_union(near_.awake().begin(), near_.awake().end(), touching_.begin(), touching_.end(),
                   std::back_inserter(visited_));
    touching_.clear();
    for (const Index s : visited_) {
      Touch& touch = touches_[s];
      const Index i = nodes_[s];
      if (touch.side != 0)
        follow<self>(touch, i, faces_, all, step.dt, pairs);
      else
        begin_touch(FirstTouch<self>(i, faces_, all, step.dt, near_.step_reach(), neighbourhood_), touch, near_.of(s),
                    ahead_, pairs);
      if (touch.side != 0) touching_.push_back(s);
    }
  }
  /// Takes note that the impulses of the step have moved the nodes.
  void moved(const ContactNodes& all, double dt) { near_.moved(all, dt); }

  double size() const { return faces_.size; }
  /// The largest 1/m* of a node and a corner near it [1/mass]: a bound for the stiffness of springs.
  double largest_inverse_mass() const { return near_.largest_inverse_mass(); }
  std::size_t sorts() const { return near_.sorts(); }
  const std::vector<Index>& nodes() const { return nodes_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(nodes_, faces_.target, touches_, touching_, near_, neighbourhood_);
  }

 private:
  void find_initial_depths(const ContactNodes& all, InitialPenetration& inside) {
    for (const Index s : near_.awake()) {
      const Index i = nodes_[s];
      Foot best;
      for (const Index f : near_.of(s)) {
        if (self && neighbourhood_.has(i, f)) continue;
        if (const Foot foot = faces_.foot(f, all, i); foot.point.distance2 < best.point.distance2) best = foot;
      }
      const double side = faces_.side_of(best), gap = side * best.height - faces_.depth;
      if (!(gap < 0) || best.point.distance2 > 1e30 || (best.on_border && !faces_.two_sided)) continue;
      touches_[s] = {.side = side, .initial_depth = -gap, .face = best.face};
      touching_.push_back(s);
      if (-gap > 1e-6 * faces_.size) inside.add(all.number(i), all.x[i], -gap);
    }
  }

  std::vector<Index> nodes_;
  TouchedFaces faces_;
  std::vector<Touch> touches_;
  std::vector<Index> touching_;  // places in the list of the nodes that touch, however deep
  std::vector<Index> visited_;   // and of those that the step looks at
  NearFaces<self> near_;
  PositionsAhead ahead_;
  std::vector<Eigen::Vector3d> start_;  // of plates that may touch themselves
  Neighbourhood neighbourhood_;
};

}  // namespace strike::detail
