#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/approach.hpp>
#include <strike/contact/carried.hpp>
#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/edge_approach.hpp>
#include <strike/contact/orientation.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/contact/rigid_approach.hpp>
#include <strike/contact/surface.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>

namespace strike {

namespace detail {

/// Nodes of a contact from their numbers in the scene.
inline std::vector<Index> to_local(std::vector<Index> numbers, const ContactNodes& all) {
  for (Index& i : numbers) i = all.local(i);
  return numbers;
}
/// A surface, whose corners are numbers in the scene, as the target of a contact.
inline Target target_of(const Surface& surface, const ContactNodes& all) {
  std::vector<FaceCorners> faces, plates;
  std::vector<double> thickness;
  std::vector<Index> piece;
  for (Index p = 0; p < surface.pieces().size(); ++p) {
    const Surface::Piece& of = surface.pieces()[p];
    for (const Face& face : of.faces) {
      FaceCorners corners = face.nodes;
      for (Index& i : corners) i = all.local(i);
      faces.push_back(corners), thickness.push_back(of.thickness), piece.push_back(p);
      if (of.thickness > 0) plates.push_back(corners);
    }
  }
  face_one_side(plates);
  auto plate = plates.begin();
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (thickness[f] > 0) faces[f] = *plate++;
  Target target(std::move(faces), all.size(), std::move(thickness));
  target.keep_apart(surface.apart(), std::move(piece));
  return target;
}

/// The meeting of nodes with surfaces, in one or two ways.
template <bool self>
class SurfaceMeeting {
 public:
  explicit SurfaceMeeting(std::vector<Surface> surfaces) : surfaces_(std::move(surfaces)) {}

  /// Adds the way of nodes, of plates of that thickness, to a surface.
  void add(std::vector<Index> numbers, double thickness, std::size_t target, const ContactNodes& all) {
    add(numbers, true, 0, target, std::vector<double>(all.size(), 0.5 * thickness), all);
  }
  /// Adds the way of the nodes of a surface to another.
  void add(std::size_t from, std::size_t target, const ContactNodes& all) {
    std::vector<double> half(all.size());
    const Target own = target_of(surfaces_[from], all);
    for (Index i = 0; i < all.size(); ++i) half[i] = own.half(i);
    add(surface_nodes(surfaces_[from].faces()), false, from, target, std::move(half), all);
  }

  /// Adds the edges of a surface against those of another.
  void add_edges(std::size_t first, std::size_t second, const ContactNodes& all) {
    edges_.push_back(EdgeApproach<self>(target_of(surfaces_[first], all), target_of(surfaces_[second], all)));
    edged_ = {first, second};
  }

  void begin(const ContactNodes& all, InitialPenetration& inside) {
    for (auto& approach : approaches_) approach.begin(all, inside);
    for (auto& edges : edges_) edges.begin(all, inside);
  }
  template <class Execution>
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs, const Execution& execution) {
    for (auto& approach : approaches_) approach.find(all, step, pairs, rounding_, execution);
    const auto touches = [&](Index i) {
      return std::any_of(approaches_.begin(), approaches_.end(), [&](const auto& to) { return to.touches(i); });
    };
    for (auto& edges : edges_) edges.find(all, step, pairs, touches, rounding_, execution);
    rounding_.end_step();
  }
  double closing_step(const ContactNodes& all, double moved, double dt) {
    double step = dt;  // not that of one way for the next, which then depends on whose nodes have bounded the first
    for (auto& approach : approaches_) step = std::min(step, approach.closing_step(all, moved, dt));
    return step;
  }
  double largest_inverse_mass() const {
    double most = 0;
    for (const auto& approach : approaches_) most = std::max(most, approach.largest_inverse_mass());
    return most;
  }
  std::size_t sorts() const {
    std::size_t sum = 0;
    for (const auto& approach : approaches_) sum += approach.sorts();
    return sum;
  }

  /// Removes cells of a part from the surfaces. Nodes that come to the outside touch from now on, and nodes that have
  /// lost all their cells still do. Touches of other cells go on.
  void remove(std::size_t part, const std::vector<bool>& alive, const ContactNodes& all) {
    std::vector<bool> changed;
    for (Surface& surface : surfaces_) changed.push_back(surface.remove(part, alive));
    if (std::find(changed.begin(), changed.end(), true) == changed.end()) return;
    std::vector<Target> targets;
    for (const Surface& surface : surfaces_) targets.push_back(target_of(surface, all));
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      auto& [numbers, fixed, from, target] = ways_[k];
      if (!changed[from] && !changed[target]) continue;
      if (!fixed) numbers = ascending(std::move(numbers), surface_nodes(surfaces_[from].faces()));
      approaches_[k].change(to_local(numbers, all), targets[target]);
    }
    for (auto& edges : edges_)
      if (changed[edged_[0]] || changed[edged_[1]]) edges.change(targets[edged_[0]], targets[edged_[1]]);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(std::span(surfaces_), std::span(ways_), std::span(approaches_), std::span(edges_), rounding_);
  }

 private:
  void add(const std::vector<Index>& numbers, bool fixed, std::size_t from, std::size_t target,
           std::vector<double> half, const ContactNodes& all) {
    ways_.push_back({numbers, fixed, from, target});
    approaches_.push_back(Approach<self>(to_local(numbers, all), target_of(surfaces_[target], all), std::move(half)));
  }

  struct Way {
    std::vector<Index> nodes;  // numbers in the scene
    bool fixed;                // given by the user, not those of a surface
    std::size_t from, target;  // surfaces

    template <class Archive>
    void serialize(Archive& archive) {
      archive(nodes);
    }
  };

  std::vector<Surface> surfaces_;
  std::vector<Way> ways_;
  std::vector<Approach<self>> approaches_;
  std::vector<EdgeApproach<self>> edges_;  // none or one
  std::array<std::size_t, 2> edged_{};     // its surfaces
  Rounding rounding_;
};

}  // namespace detail

/// The pairing of nodes with a surface; give the nodes of the finer or softer of two bodies, such as a bird. Error: no
/// nodes.
struct NodeToSurface {
  std::vector<Index> nodes;
  Surface surface;
  double thickness = 0;  ///< of the plate that the nodes belong to, of particles their spacing [length]

  void ranges(const auto& number) const {
    number("thickness", thickness, range::not_negative);
    number(surface);
  }

  void see(std::span<const PartFaces> parts) const { surface.check_parts(parts); }
  std::vector<Index> numbers() const { return detail::ascending(nodes, surface.nodes()); }
  const std::vector<Index>& first() const { return nodes; }
  detail::SurfaceMeeting<false> start(const ContactNodes& all) const {
    if (nodes.empty()) throw Error("strike: a NodeToSurface has no nodes; give it some, such as surface_nodes(faces).");
    detail::SurfaceMeeting<false> meeting({surface});
    meeting.add(detail::ascending(nodes), thickness, 0, all);
    return meeting;
  }
};

/// The pairing of two surfaces, the nodes of each with the faces of the other; the nodes of the first come first.
struct TwoWay {
  Surface first_surface, second_surface;

  void ranges(const auto& number) const { number(first_surface), number(second_surface); }

  void see(std::span<const PartFaces> parts) const {
    first_surface.check_parts(parts), second_surface.check_parts(parts);
  }
  std::vector<Index> numbers() const { return detail::ascending(first_surface.nodes(), second_surface.nodes()); }
  std::vector<Index> first() const { return first_surface.nodes(); }
  detail::SurfaceMeeting<false> start(const ContactNodes& all) const {
    detail::SurfaceMeeting<false> meeting({first_surface, second_surface});
    meeting.add(0, 1, all);
    meeting.add(1, 0, all);
    meeting.add_edges(0, 1, all);
    return meeting;
  }
};

/// The pairing of a surface with itself: one that folds, or that of several bodies. Plates within a thickness of a node
/// at the start are its neighbourhood, which it never touches.
struct SelfContact {
  Surface surface;

  void ranges(const auto& number) const { number(surface); }

  void see(std::span<const PartFaces> parts) const { surface.check_parts(parts); }
  std::vector<Index> numbers() const { return surface.nodes(); }
  std::vector<Index> first() const { return surface.nodes(); }
  detail::SurfaceMeeting<true> start(const ContactNodes& all) const {
    detail::SurfaceMeeting<true> meeting({surface});
    meeting.add(0, 0, all);
    meeting.add_edges(0, 0, all);
    return meeting;
  }
};

/// The pairing of all parts of the scene with each other and each with itself: the outside of solids and the faces that
/// deletions expose, plates at half their thickness from where their Offset puts them, and particles, balls of half
/// their spacing, with all that are no particles. Plates within a thickness of a node at the start are its
/// neighbourhood, as in SelfContact.
struct Everything {
  /// Pairs of parts, by their places, that do not touch each other; a part with itself: it does not fold.
  std::vector<std::array<std::size_t, 2>> except{};
  std::optional<Surface> surface{};  ///< of all parts, found when a run begins

  std::vector<std::pair<std::vector<Index>, double>> particles{};  ///< the nodes of such parts, and their spacing

  void see(std::span<const PartFaces> parts) {
    surface = surface_of(parts);
    particles.clear();
    for (const PartFaces& part : parts)
      if (!part.particles.empty()) particles.push_back({part.particles, part.thickness});
  }
  std::vector<Index> numbers() const {
    std::vector<Index> all = surface ? surface->nodes() : std::vector<Index>{};
    for (const auto& [nodes, spacing] : particles) all = detail::ascending(std::move(all), nodes);
    return all;
  }
  std::vector<Index> first() const { return numbers(); }
  detail::SurfaceMeeting<true> start(const ContactNodes& all) const {
    if (!surface)
      throw Error("strike: Contact{Everything{}} finds no part that is made of hexahedra, tetrahedra or plates.");
    auto meeting = SelfContact{*surface}.start(all);
    for (const auto& [nodes, spacing] : particles) meeting.add(detail::ascending(nodes), spacing, 0, all);
    return meeting;
  }

 private:
  std::optional<Surface> surface_of(std::span<const PartFaces> parts) const {
    const bool solids_erode = std::any_of(parts.begin(), parts.end(),
                                          [](const PartFaces& part) { return part.erodes && !(part.thickness > 0); });
    std::vector<Surface::Piece> pieces;
    std::vector<Index> piece(parts.size(), detail::Target::none);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (parts[p].faces.empty()) continue;
      piece[p] = static_cast<Index>(pieces.size());
      pieces.push_back({.thickness = parts[p].thickness,
                        .part = p,
                        .cells = parts[p].cells,
                        .erodes = true,
                        .of_cells = parts[p].faces});
    }
    if (pieces.empty()) return std::nullopt;
    Surface all(std::move(pieces));
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (!(parts[p].thickness > 0 ? parts[p].erodes : solids_erode)) all.settle(p);
    if (solids_erode) all.settle_inside([&](std::size_t p) { return !parts[p].erodes; });
    for (const auto& [p, q] : except) {
      for (const std::size_t named : {p, q})
        if (named >= parts.size())
          throw Error(detail::joined({"strike: Everything excepts part ", std::to_string(named), ", but the scene has ",
                                      std::to_string(parts.size()), parts.size() == 1 ? " part" : " parts",
                                      "; count its parts from 0."}));
        else if (!parts[named].particles.empty())
          throw Error(detail::joined({"strike: Everything excepts part ", std::to_string(named),
                                      ", which is of particles; write the pairs of this scene one by one."}));
      if (piece[p] != detail::Target::none && piece[q] != detail::Target::none) all.keep_apart(piece[p], piece[q]);
    }
    return all;
  }
};

/// The pairing of nodes with a rigid body: a RigidPlane, RigidSphere, RigidCylinder, RigidSurface or your own
/// RigidObstacle, at rest or Carried. Errors of a RigidSurface: no faces; a face names a point that is not there.
template <class Body>
struct NodeToRigid {
  std::vector<Index> nodes;
  Body body;
  double thickness = 0;  ///< of the plate that the nodes belong to, of particles their spacing [length]

  void ranges(const auto& number) const {
    number("thickness", thickness, range::not_negative);
    number(body);
  }

  std::vector<Index> numbers() const {
    if constexpr (requires { body.frame; })
      return detail::ascending(nodes, body.frame.nodes);
    else
      return detail::ascending(nodes);
  }
  const std::vector<Index>& first() const { return nodes; }
  auto start(const ContactNodes& all) const
    requires RigidObstacle<Body>
  {
    return detail::RigidApproach<Body>{detail::to_local(detail::ascending(nodes), all), body, 0.5 * thickness};
  }
};
template <>
struct NodeToRigid<RigidSurface> {
  std::vector<Index> nodes;
  RigidSurface body;
  double thickness = 0;

  void ranges(const auto& number) const {
    number("thickness", thickness, range::not_negative);
    number(body);
  }

  std::vector<Index> numbers() const { return detail::ascending(nodes); }
  const std::vector<Index>& first() const { return nodes; }
  const std::vector<Eigen::Vector3d>& points() const { return body.points; }
  detail::Approach<false> start(const ContactNodes& all) const {
    std::vector<std::array<Index, 4>> faces;
    for (const Face& face : body.faces) {
      faces.push_back(face.nodes);
      for (Index& i : faces.back()) {
        if (i >= body.points.size())
          throw Error(
              detail::joined({"strike: a face of a RigidSurface names point ", std::to_string(i), ", but there are ",
                              std::to_string(body.points.size()), " points; count them from 0."}));
        i += all.first_point();
      }
    }
    if (faces.empty()) throw Error("strike: a RigidSurface has no faces; give it some, such as surface(mesh).");
    return {detail::to_local(numbers(), all),
            {std::move(faces), all.size()},
            std::vector<double>(all.size(), 0.5 * thickness)};
  }
};
template <class Body>
NodeToRigid(std::vector<Index>, Body) -> NodeToRigid<Body>;
template <class Body>
NodeToRigid(std::vector<Index>, Body, double) -> NodeToRigid<Body>;

}  // namespace strike
