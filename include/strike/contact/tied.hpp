#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/surface.hpp>
#include <strike/contact/target.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// The forces at which the tie of a node breaks: where (F_n/normal)^2 + (F_s/shear)^2 reaches 1 with the tension F_n
/// along the normal of the face and the shear F_s along it [force]. Pressure breaks no tie.
struct TieStrength {
  double normal = std::numeric_limits<double>::infinity();
  double shear = std::numeric_limits<double>::infinity();

  void ranges(const auto& number) const {
    number("normal", normal, range::or_infinite(range::positive));
    number("shear", shear, range::or_infinite(range::positive));
  }
};

/// Nodes tied to their places on a surface: a joint of meshes that need not fit. Impulses remove the velocity of every
/// node relative to its point, node after node, until all fit; they keep momentum, and its moment where nodes lie on
/// the faces, and need no smaller step. Either side may belong to a RigidBody: its points are then off by the square of
/// its turn in a step. On a surface of a part (`solid_surface`, `plate_surface`) a tie ends with the
/// element that it is tied to; with a TieStrength, after the step in which its force has reached it.
class Tied {
 public:
  /// `tolerance` is the largest distance of a node from the surface [length]; 0: a tenth of the mean diagonal of a
  /// face. Errors: no nodes; a number out of its range; at the start, a node farther from the surface, or one that
  /// belongs to it.
  Tied(std::vector<Index> nodes, Surface surface, TieStrength strength)
      : Tied(std::move(nodes), std::move(surface), 0, strength) {}
  Tied(std::vector<Index> nodes, Surface surface, double tolerance = 0, TieStrength strength = {})
      : nodes_(detail::ascending(std::move(nodes))),
        surface_(std::move(surface)),
        tolerance_(tolerance),
        strength_(strength) {
    detail::check_ranges(*this);
    if (nodes_.empty()) throw Error("strike: a Tied has no nodes; give it some, such as surface_nodes(faces).");
  }

  void ranges(const auto& number) const {
    number("tolerance", tolerance_, range::not_negative);
    number(strength_);
    number(surface_);
  }

  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts = {}) {
    if (!parts.empty()) surface_.check_parts(parts);
    detail::refuse_dual_numbers<N>();
    if constexpr (detail::is_plain<N>) {
      all_.begin(nodes, detail::ascending(nodes_, surface_nodes(surface_.faces())), {}, {});
      tie();
    }
  }

  std::vector<Index> nodes_named() const { return all_.nodes_named(); }
  template <class N>
  void find_places(const N& nodes) {
    all_.find_places(nodes);
  }

  template <class N, class Ledger>
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger)
    requires detail::is_plain<N>
  {
    all_.gather(nodes, Serial{});
    all_.find_held_directions(nodes);
    all_.gather_forces(nodes, ties_, step.kick(), Serial{});
    double fastest = 0, farthest = 0;
    for (const auto& v : all_.v) fastest = std::max(fastest, v.norm());
    for (const auto& x : all_.x) farthest = std::max(farthest, x.norm());
    sweeps_ = 0;
    pulled_.assign(ties_.size(), Eigen::Vector3d::Zero());
    const bool on_bodies = !all_.bodies().empty();  // whose ties all change each other's velocities
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * farthest / step.dt,
                 enough = std::max(1e-12 * fastest, rounding);
    double left = ties_.empty() ? 0 : std::numeric_limits<double>::infinity();
    for (; left > enough && sweeps_ < (on_bodies ? 5000 : 100); ++sweeps_) {
      left = 0;
      for (std::size_t k = 0; k < ties_.size(); ++k) left = std::max(left, pull(k, step.dt));
    }
    if (on_bodies && left > 1e-6 * fastest + rounding)
      throw Error(
          "strike: the ties of a rigid body do not fit, for it is far lighter than what is tied to it; make the tied "
          "nodes its own, by RigidBody{...}.with_nodes(nodes).");
    all_.scatter(nodes, ledger, Serial{});
    step_ = step;
    break_ties();
  }

  /// Unties the nodes from the cells of a part that are not alive.
  void remove(std::size_t part, const std::vector<bool>& alive) {
    if (!surface_.is_of(part)) return;
    std::size_t left = 0;
    for (std::size_t k = 0; k < ties_.size(); ++k)
      if (cells_[faces_[k]].part != part || alive.at(cells_[faces_[k]].number))
        ties_[left] = ties_[k], faces_[left] = faces_[k], ++left;
    ties_.resize(left), faces_.resize(left);
  }
  /// Number of the nodes that are tied, and of the ties that have broken.
  std::size_t size() const { return ties_.size(); }
  std::size_t broken() const { return broken_; }

  /// The force on the tied nodes in the last step.
  const Eigen::Vector3d& force() const { return force_; }
  /// Number of sweeps over the nodes in the last step.
  int sweeps() const { return sweeps_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(all_, step_, sweeps_, ties_, faces_, force_, broken_);
  }

 private:
  /// Finds the place of every node on the surface.
  void tie() {
    target_ = detail::target_of(surface_, all_);
    for (const Surface::Piece& piece : surface_.pieces())
      for (const Face& face : piece.faces) cells_.push_back({piece.part, face.cell});
    const std::vector<Index> local = detail::to_local(nodes_, all_);
    if (!(tolerance_ > 0)) tolerance_ = 0.1 * target_.mean_size(all_.x);
    detail::BucketSearch search;
    search.sort(local, target_.faces(), all_.x, tolerance_);
    for (std::size_t s = 0; s < local.size(); ++s) {
      const detail::Foot foot = nearest(s, local[s], search);
      const detail::FaceCorners& corners = target_.faces()[foot.face];
      ContactPair pair;
      pair.add(local[s], 1);
      for (unsigned k = 0; k < target_.count(foot.face); ++k) pair.add(corners[k], -foot.point.N[k]);
      pair.gap = normal_of(pair, foot.face, target_.corners(foot.face, all_.x)).dot(foot.point.away);
      if (std::abs(pair.gap) < 1e-9 * tolerance_) pair.gap = 0;
      ties_.push_back(pair);
      faces_.push_back(foot.face);
    }
  }
  /// The normal of a face where a tie has its place.
  Eigen::Vector3d normal_of(const ContactPair& tie, Index face, const detail::Corners& X) const {
    std::array<double, 4> N{};
    for (unsigned i = 1; i < tie.count; ++i) N[i - 1] = -tie.weights[i];
    return detail::normal_at(X, N, target_.count(face) == 3);
  }
  /// The foot of tied node s on the nearest face.
  detail::Foot nearest(std::size_t s, Index node, const detail::BucketSearch& search) const {
    detail::Foot best;
    for (const Index f : search.near(s)) {
      if (target_.has(f, node))
        throw Error(detail::joined({"strike: node ", std::to_string(nodes_[s]), " at ", detail::text(all_.x[node]),
                                    " is tied to a surface that it belongs to; take it out of the tied nodes."}));
      const detail::Foot foot = target_.foot(f, target_.corners(f, all_.x), all_.x[node], all_.x);
      if (foot.point.distance2 < best.point.distance2) best = foot;
    }
    if (!(best.point.distance2 <= tolerance_ * tolerance_))
      throw Error(detail::joined({"strike: node ", std::to_string(nodes_[s]), " at ", detail::text(all_.x[node]),
                                  " is farther than ", detail::text(tolerance_),
                                  " from the surface that it is tied to; move it there or raise the tolerance."}));
    return best;
  }

  /// Removes the misfit of a tie at the end of the step; returns the misfit over the step [velocity].
  double pull(std::size_t k, double dt) {
    using namespace detail;
    ContactPair& tie = ties_[k];
    const auto ahead = [&](Index i) { return all_.x[i] + dt * all_.v[i]; };
    Eigen::Vector3d off{0, 0, 0};
    for (unsigned i = 0; i < tie.count; ++i) off += tie.weights[i] * ahead(tie.nodes[i]);
    if (tie.gap != 0) off -= tie.gap * normal_of(tie, faces_[k], target_.corners(faces_[k], all_.x, all_.v, dt));
    const Eigen::Vector3d v = off / dt;
    for (int a = 0; a < 3; ++a) {
      tie.normal = unit(Axis{a});
      if (const double inverse_effective_mass = tie.inverse_effective_mass_along(all_, tie.normal);
          inverse_effective_mass > 0) {
        tie.push(all_, -v[a] / inverse_effective_mass);
        pulled_[k](a) -= v[a] / inverse_effective_mass;
      }
    }
    return v.norm();
  }

  /// Sums the forces of the step, and removes the ties that have reached their strength.
  void break_ties() {
    force_.setZero();
    std::size_t left = 0;
    for (std::size_t k = 0; k < ties_.size(); ++k) {
      const Eigen::Vector3d force = (1 / step_.kick()) * pulled_[k];  // on the node
      force_ += force;
      const Eigen::Vector3d n = normal_of(ties_[k], faces_[k], target_.corners(faces_[k], all_.x));
      const double along = n.dot(force), side = target_.is_plate(faces_[k]) && ties_[k].gap < 0 ? -1 : 1;
      const double tension = std::max(0.0, -side * along) / strength_.normal,
                   shear = (force - along * n).norm() / strength_.shear;
      if (tension * tension + shear * shear >= 1)
        ++broken_;
      else
        ties_[left] = ties_[k], faces_[left] = faces_[k], ++left;
    }
    ties_.resize(left), faces_.resize(left);
  }

  std::vector<Index> nodes_, faces_;
  Surface surface_;
  struct Cell {
    std::optional<std::size_t> part;
    Index number;
  };
  std::vector<Cell> cells_;  // of the faces of the surface
  double tolerance_;
  TieStrength strength_;
  ContactNodes all_;
  detail::Target target_;
  std::vector<ContactPair> ties_;
  std::vector<Eigen::Vector3d> pulled_;  // impulse on the node of each tie in this step [force time]
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  Step step_;
  int sweeps_ = 0;
  std::size_t broken_ = 0;
};

/// Those of some nodes that lie within a distance of a surface and do not belong to it, in ascending order; `x` are the
/// positions of all nodes. Such as the nodes of one part that are to be tied to another:
///   Tied{nodes_near(mesh.nodes, surface_nodes(patch), surface, 0.5), surface, 0.5}
inline std::vector<Index> nodes_near(const std::vector<Eigen::Vector3d>& x, std::vector<Index> nodes,
                                     const Surface& surface, double distance) {
  const std::vector<Face> faces = surface.faces();
  const std::vector<Index> own = surface_nodes(faces);
  nodes = detail::ascending(std::move(nodes));
  std::erase_if(nodes, [&](Index i) { return std::binary_search(own.begin(), own.end(), i); });
  std::vector<detail::FaceCorners> corners;
  for (const Face& face : faces) corners.push_back(face.nodes);
  detail::BucketSearch search;
  search.sort(nodes, corners, x, distance);
  std::vector<Index> near;
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    const auto is_near = [&](Index f) {
      const auto& c = corners[f];
      const detail::Corners X{x[c[0]], x[c[1]], x[c[2]], x[c[3]]};
      const detail::ClosestPoint point =
          c[2] == c[3] ? detail::closest_on_triangle(X, x[nodes[s]]) : detail::closest_on_quadrilateral(X, x[nodes[s]]);
      return point.distance2 <= distance * distance;
    };
    const auto faces_near = search.near(s);
    if (std::any_of(faces_near.begin(), faces_near.end(), is_near)) near.push_back(nodes[s]);
  }
  return near;
}

}  // namespace strike
