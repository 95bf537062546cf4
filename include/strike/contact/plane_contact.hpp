#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/concepts.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/plates_beside.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/contact/spacing.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Nodes that may touch a rigid half-space and leave it but not enter, by the Kinematic law in the numbers of the run.
/// A node that would enter gets the impulse that brings it to the plane at the end of the step: an inelastic impact,
/// which takes m v^2/2 of it, for a bar of N elements 1/(2 N) of the energy. It works on the nodes of the scene
/// themselves: nodes that do not touch cost one look at their position and velocity. Plates touch it half their
/// thickness from their middle, which an Offset puts beside their nodes.
template <Friction F>
class PlaneContact {
 public:
  /// All nodes of the scene, or those given, with the thickness of their parts, or with the one given [length].
  PlaneContact(const RigidPlane& plane, F friction) : PlaneContact(plane, {}, friction) { everywhere_ = true; }
  PlaneContact(const RigidPlane& plane, std::vector<Index> nodes, F friction, std::optional<double> thickness = {})
      : point_(plane.point),
        normal_(direction(plane.normal)),
        friction_(friction),
        nodes_(std::move(nodes)),
        thickness_(thickness) {
    point_ += (0.5 * thickness.value_or(0.0)) * normal_;
  }

  void ranges(const auto& number) const {
    number("point", point_, range::point), number("normal", normal_, range::direction), number(friction_);
  }

  /// Nodes that start inside keep their initial depth without force until they leave. Error: no such node.
  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts = {}) {
    if (everywhere_) {
      places_.resize(nodes.size());
      std::iota(places_.begin(), places_.end(), Index{0});
    }
    for (const Index i : nodes_) nodes.check_number(i);
    if (!everywhere_) find_places(nodes);
    find_plates(nodes, parts);
    std::vector<Eigen::Vector3d> all;
    for (const Index place : places_) all.push_back(position(nodes, place));
    cells_ = spacing(all);
    const auto lifts = find_lifts(nodes);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Eigen::Vector3d& x = all[k];
      const double depth = normal_.dot(point_ - x) - static_cast<double>(lifts[k]);
      if (!(depth > 0)) continue;
      inside_.push_back({k, depth});
      const Index i = nodes.number(places_[k]);
      if (!(depth > std::max(depth_of_rounding(x, 0), rounding(nodes, i)))) continue;
      if (depth > std::max(1e-9 * x.norm(), rounding(nodes, i))) initial_.add(i, x, depth);
      initial_.overlaps.push_back({.nodes = {i}, .weights = {1}, .count = 1, .normal = normal_, .depth = depth});
    }
  }

  /// The step in which no node closes on the plane by more than its gap and a share of a cell.
  template <class N>
  double stable_step(double dt, const N& nodes) const {
    double step = dt;
    const auto lifts = find_lifts(nodes);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Eigen::Vector3d v = N::vector_of(nodes.velocity()[places_[k]]).template cast<double>();
      const double closing = -normal_.dot(v);
      if (!(closing * dt > closing_share * cells_[k])) continue;
      const double gap = normal_.dot(position(nodes, places_[k]) - point_) + static_cast<double>(lifts[k]);
      if (gap >= 0) step = std::min(step, closing_step(gap, closing, cells_[k]));
    }
    return step;
  }

  template <class N>
  void find_places(const N& nodes) {
    places_.clear();
    for (const Index i : nodes_) places_.push_back(nodes.place(i));
  }
  std::vector<Index> nodes_named() const {
    if (!everywhere_) return detail::ascending(beside_.nodes_named(), nodes_);
    std::vector<Index> all(places_.size());
    std::iota(all.begin(), all.end(), Index{0});
    return all;
  }

  template <class N, class Ledger>
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger) {
    using Number = typename N::Number;
    using Vector = typename N::Vector;
    touches_.clear();
    const auto lifts = find_lifts(nodes);
    reduce_initial_depths(nodes, lifts);
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Index place = places_[k];
      const Vector x = N::vector_of(nodes.position()[place]), v = N::vector_of(nodes.velocity()[place]);
      const Number approach = normal_.dot(v), below = normal_.dot(point_ - x) - lifts[k],
                   excess = below - step.dt * approach;
      if (!(excess > 0)) continue;
      const double initial_depth = initial_depth_of(k);
      const Number depth = below - initial_depth;
      const Index i = nodes.number(place);
      // Out no faster than in, so that no impulse adds energy; depths of rounding are taken out in full.
      const Number most = depth > rounding(nodes, i) ? Number(-2 * step.dt * approach) : excess;
      const Number way = min(initial_depth > 0 ? Number(excess - initial_depth) : excess, most);
      if (!(way > 0)) continue;
      if constexpr (std::is_same_v<Number, double>)
        if (nodes.is_rigid(i)) {
          on_bodies_.push_back({.node = i,
                                .body = nodes.body_of(i),
                                .x = x,
                                .v = v,
                                .wanted = approach + way / step.dt,
                                .depth = depth});
          continue;
        }
      const Eigen::Vector3d away = nodes.free(i, normal_);
      const double inverse_effective_mass = away.dot(normal_);  // times the mass: 1 of a free node, 0 of one held
      if (!(inverse_effective_mass > 1e-6)) continue;
      const double mass = nodes.mass(i);
      const Number push = mass * (way / step.dt) / inverse_effective_mass;
      const Vector sliding = nodes.free(i, Vector(v - approach * normal_));
      const Number drag = drag_per_velocity(push, Number(sliding.norm()), mass);
      const Vector given = push * away - drag * sliding;
      const Vector before = v - (step.kick() / mass) * nodes.f(i);
      const Vector after = v + (1 / mass) * given;
      nodes.set_velocity(i, after);
      ledger.contact.book_impulse(static_cast<double>(-push * away.dot(before)),
                                  static_cast<double>(-push * away.dot(after)));
      ledger.friction.book_impulse(static_cast<double>(drag * sliding.dot(before)),
                                   static_cast<double>(drag * sliding.dot(after)));
      touches_.push_back({i, given.template cast<double>(), static_cast<double>(depth)});
      impulse += touches_.back().impulse;
    }
    if constexpr (std::is_same_v<Number, double>)
      if (!on_bodies_.empty()) impulse += push_bodies(nodes, ledger);
    impulse_ += impulse;
    force_ = impulse / step.kick();
    kick_ = step.kick();
  }

  /// Plates that are not alive no longer shift their nodes, which keep their thickness.
  void remove(std::size_t part, const std::vector<bool>& alive) { beside_.remove(part, alive); }

  /// One sentence on nodes that start inside; empty if there are none.
  std::string warning() const { return initial_.warning(); }
  /// Nodes that started inside.
  const std::vector<Overlap>& overlaps() const { return initial_.overlaps; }

  /// The force on the nodes in the last step.
  const Eigen::Vector3d& force() const { return force_; }
  /// The impulse on the nodes since the start [force time].
  const Eigen::Vector3d& impulse() const { return impulse_; }
  /// The forces of the last step on every node of the scene, whose number is `nodes`.
  std::vector<Eigen::Vector3d> forces(std::size_t nodes) const {
    std::vector<Eigen::Vector3d> all(nodes, Eigen::Vector3d::Zero());
    for (const TouchingNode& touch : touches_) all.at(touch.node) = touch.impulse / kick_;
    return all;
  }
  /// The largest depth in the last step, less the initial depth [length].
  double penetration() const {
    double most = 0;
    for (const TouchingNode& touch : touches_) most = std::max(most, touch.depth);
    return most;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
    archive(force_, impulse_, kick_, inside_, touches_, beside_);
  }

 private:
  /// A node in contact: its impulse in this step [force time] and its depth at the start of the step [length].
  struct TouchingNode {
    Index node = 0;
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    double depth = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(node, impulse, depth);
    }
  };
  /// A node of a rigid body that touches, and the velocity along the normal that it shall have.
  struct OnBody {
    Index node;
    std::size_t body;
    Eigen::Vector3d x, v;
    double wanted, depth;
    double push = 0;
    Eigen::Vector3d drag = Eigen::Vector3d::Zero();
  };
  /// Initial penetration of entry k of the list of nodes, tolerated without force [length].
  struct InitialDepth {
    std::size_t k;
    double depth;
  };

  /// How far the middles of the plates of each node are above it, less half their thickness [length]; 0 of all others.
  template <class Number>
  struct Lifts {
    std::vector<Number> of_plates{};  // none if there are no such plates

    Number operator[](std::size_t k) const { return of_plates.empty() ? Number(0.0) : of_plates[k]; }
  };

  template <class N>
  Lifts<typename N::Number> find_lifts(const N& nodes) const {
    Lifts<typename N::Number> lifts;
    if (half_.empty() && beside_.empty()) return lifts;
    lifts.of_plates.assign(places_.size(), 0.0);
    if (!beside_.empty()) {
      const auto ways = beside_.ways(nodes, places_.size());
      for (std::size_t k = 0; k < ways.size(); ++k) lifts.of_plates[k] = normal_.dot(ways[k]);
    }
    for (std::size_t k = 0; k < half_.size(); ++k) lifts.of_plates[k] -= half_[k];
    return lifts;
  }
  template <class N>
  void find_plates(const N& nodes, std::span<const PartFaces> parts) {
    std::vector<Index> entry(nodes.size(), PlatesBeside::none);
    for (std::size_t k = 0; k < places_.size(); ++k) entry[nodes.number(places_[k])] = static_cast<Index>(k);
    std::vector<double> sum(places_.size(), 0.0), plates(places_.size(), 0.0);
    double thickest = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      beside_.add(p, parts[p], [&](Index number) { return entry[number]; });
      if (thickness_ || !(parts[p].thickness > 0)) continue;
      for (const Face& face : parts[p].faces)
        for (const Index i : face.nodes)
          if (const Index k = entry[i]; k != PlatesBeside::none)
            sum[k] += 0.5 * parts[p].thickness, ++plates[k], thickest = parts[p].thickness;
    }
    if (!(thickest > 0)) return;
    for (std::size_t k = 0; k < sum.size(); ++k) half_.push_back(plates[k] > 0 ? sum[k] / plates[k] : 0);
  }

  template <class N>
  static Eigen::Vector3d position(const N& nodes, Index place) {
    return N::vector_of(nodes.position()[place]).template cast<double>();
  }
  /// A node that has come up starts anew from its present depth, or from the plane.
  template <class N, class Lifts>
  void reduce_initial_depths(const N& nodes, const Lifts& lifts) {
    if (inside_.empty()) return;
    for (auto& [k, depth] : inside_) {
      const double now = normal_.dot(point_ - position(nodes, places_[k])) - static_cast<double>(lifts[k]);
      depth = std::clamp(now, 0.0, depth);
    }
    std::erase_if(inside_, [](const InitialDepth& initial) { return !(initial.depth > 0); });
  }
  double initial_depth_of(std::size_t k) const {
    if (inside_.empty()) return 0;
    const auto at = std::lower_bound(inside_.begin(), inside_.end(), k,
                                     [](const InitialDepth& initial, std::size_t key) { return initial.k < key; });
    return at != inside_.end() && at->k == k ? at->depth : 0;
  }

  /// The impulses on the nodes of rigid bodies, which move their bodies as a whole: node after node, forth and back,
  /// until none changes (Gauss and Seidel, projected; Moreau and Jean). Returns their sum.
  template <class N, class Ledger>
  Eigen::Vector3d push_bodies(N& nodes, Ledger& ledger) {
    std::stable_sort(on_bodies_.begin(), on_bodies_.end(),
                     [](const OnBody& a, const OnBody& b) { return a.body < b.body; });
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t first = 0, last = 0; first < on_bodies_.size(); first = last) {
      while (last < on_bodies_.size() && on_bodies_[last].body == on_bodies_[first].body) ++last;
      const std::span touching(on_bodies_.data() + first, last - first);
      RigidMotion& body = nodes.bodies()[on_bodies_[first].body];
      settle(body, touching);
      Eigen::Vector3d impulse = Eigen::Vector3d::Zero(), of_moment = impulse;
      for (const OnBody& at : touching) {
        const Eigen::Vector3d given = at.push * normal_ + at.drag;
        impulse += given, of_moment += cross(Eigen::Vector3d(at.x - body.centre()), given);
      }
      body.push_guided(impulse, of_moment);
      move_with(nodes, body);
      for (const OnBody& at : touching) {
        const Eigen::Vector3d before = at.v - body.kicked_at(at.x), after = body.velocity_at(at.x);
        ledger.contact.book_impulse(-at.push * normal_.dot(before), -at.push * normal_.dot(after));
        ledger.friction.book_impulse(-at.drag.dot(before), -at.drag.dot(after));
        touches_.push_back({at.node, at.push * normal_ + at.drag, at.depth});
      }
      sum += impulse;
    }
    on_bodies_.clear();
    return sum;
  }
  void settle(const RigidMotion& body, std::span<OnBody> touching) const {
    constexpr int most = 1000;
    Eigen::Vector3d velocity = body.velocity(), spin = body.angular_velocity();
    double fastest = 0;
    for (const OnBody& at : touching) fastest = std::max({fastest, at.v.norm(), std::abs(at.wanted)});
    for (int sweep = 0; sweep < most; ++sweep) {
      double changed = 0;
      for (std::size_t k = 0; k < touching.size(); ++k) {
        OnBody& at = touching[sweep % 2 == 0 ? k : touching.size() - 1 - k];
        const Eigen::Vector3d r = at.x - body.centre();
        const auto give = [&](const Eigen::Vector3d& J) {
          velocity += body.velocity_by(J), spin += body.spin_by(cross(r, J));
        };
        const Eigen::Vector3d arm = cross(r, normal_);
        const double response = body.response(normal_, arm), largest = body.largest_response(r.norm());
        if (!(response > 1e-9 * largest)) continue;  // its guides hold it
        const double before = at.push;
        at.push = std::max(0.0, at.push + (at.wanted - normal_.dot(velocity + cross(spin, r))) / response);
        give((at.push - before) * normal_);
        changed = std::max(changed, response * std::abs(at.push - before));
        if constexpr (!std::is_same_v<F, Frictionless>) {
          const Eigen::Vector3d v = velocity + cross(spin, r), dragged = at.drag;
          const Eigen::Vector3d sticks = dragged - (1 / largest) * (v - normal_.dot(v) * normal_);
          const double stops = sticks.norm();
          at.drag = stops > 0 ? Eigen::Vector3d((friction_.impulse(at.push, stops) / stops) * sticks) : sticks;
          give(at.drag - dragged);
          changed = std::max(changed, largest * (at.drag - dragged).norm());
        }
      }
      if (!(changed > 1e-12 * fastest)) return;
    }
  }

  /// Spacing of the coordinates of node i, below which no depth counts [length].
  template <class N>
  static double rounding(const N& nodes, Index i) {
    return 4 * nodes.resolution(i);
  }
  /// The impulse of friction over the speed of sliding [mass]: the mass of a node that sticks.
  template <class Number>
  Number drag_per_velocity(const Number& push, const Number& speed, double mass) const {
    static constexpr bool computes_in_number = requires(F friction) {
      { friction.impulse(push, push) } -> std::convertible_to<Number>;
    };
    static_assert(computes_in_number,
                  "strike: in a run of dual numbers the impulse(normal, stops) of a friction takes and returns these "
                  "numbers; make it a template over them, as Coulomb has it.");
    if constexpr (std::is_same_v<F, Frictionless> || !computes_in_number) {
      return Number(0.0);
    } else {
      if (!(speed > 0)) return Number(0.0);
      const Number stops = mass * speed, impulse = friction_.impulse(push, stops);
      return impulse < stops ? Number(impulse / speed) : Number(mass);
    }
  }

  Eigen::Vector3d point_, normal_;
  [[no_unique_address]] F friction_;
  bool everywhere_ = false;
  std::vector<Index> nodes_;         // numbers of those given
  std::optional<double> thickness_;  // of their plates, if it is not that of their parts [length]
  std::vector<double> half_;         // half the thickness of the plates of each node, if there are any [length]
  PlatesBeside beside_;
  std::vector<Index> places_;  // of the nodes in memory
  std::vector<double> cells_;  // their size at each node [length]
  std::vector<OnBody> on_bodies_;
  std::vector<InitialDepth> inside_;   // in ascending order of k
  std::vector<TouchingNode> touches_;  // of the last step
  InitialPenetration initial_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), impulse_ = Eigen::Vector3d::Zero();
  double kick_ = 1;
};

}  // namespace strike::detail
