#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/dyna/definitions.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/sets.hpp>

// Nodes, elements and parts.
namespace strike::detail::dyna {

inline void nodes(File& file, Draft& draft) {
  MovedNodes moved{file.motion(), draft.raw.nodes.size(), 0, 0};
  file.for_each_card([&](Card card) {
    const FileNumber number = card.own_tag("the number of a node", "node", Id::node, 8);
    Eigen::Vector3d x;
    for (Eigen::Index i = 0; i < 3; ++i) x[i] = card.number("the coordinate", 0, 16);
    draft.raw.nodes.push_back({number, x, file.line()});
    if (card.is_blank()) return;

    const auto held = held_by(card.integer("TC", 0, 8), "a node", file),
               held_turns = held_by(card.integer("RC", 0, 8), "a node", file);
    if (constexpr std::array free{false, false, false}; held != free || held_turns != free)
      draft.support_node({{}, held, held_turns}, {Named::node, number, file.line()}), moved.held = file.line();
  });
  moved.last = draft.raw.nodes.size();
  if (moved.motion != 0 && moved.first != moved.last) draft.moved.push_back(moved);
}

inline void solids(File& file, Draft& draft, int further_cards) {
  file.for_each_card([&](Card card) {
    RawMesh::Element element{card.own_tag("the number of an element", "solid", Id::element, 8),
                             {},
                             0,
                             file.line(),
                             RawMesh::Shape::hexahedron};
    element.group = draft.part(card.tag("PID", Id::part, 8));
    if (card.is_blank()) card = file.card();  // the corners have a line of their own
    for (FileNumber& corner : element.corners) corner = card.tag("a corner", Id::node, 8);
    for (std::size_t i = 4; i < 8; ++i)  // blank ones repeat those before them
      if (element.corners[i] == 0) element.corners[i] = element.corners[i - 1];
    const FileNumber ninth = card.tag("a mid node", Id::node, 8), tenth = card.tag("a mid node", Id::node, 8);
    if (ninth != 0) {
      if (draft.raw.second_order == SecondOrder::refused)
        file.refuse({"element ", std::to_string(element.number), " is a tetrahedron of ten nodes: ", cut_them, "."});
      if (tenth == 0)
        file.refuse({"element ", std::to_string(element.number), " has nine nodes of ten: give it the last one."});
      const auto& c = element.corners;
      const std::array mids{c[4], c[5], c[6], c[7], ninth, tenth};
      element.shape = RawMesh::Shape::tetrahedron, element.second = SecondOrderKind::tetrahedron10;
      draft.raw.set_mids(element, mids);
    }
    draft.raw.elements.push_back(element);
    for (int left = further_cards; left > 0; --left) file.ignore(file.card().says_more(), "The axes of each solid");
  });
}
inline void all_solids(File& file, Draft& draft) { solids(file, draft, 0); }
/// Solids with the axes of their material, which have no counterpart.
inline void oriented_solids(File& file, Draft& draft) { solids(file, draft, 2); }

/// Solids of second order, ten nodes on a line. Their corners alone are read.
template <SecondOrderKind kind>
void solids_of_second_order(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    RawMesh::Element element{card.own_tag("the number of an element", "solid", Id::element, 8),
                             {},
                             0,
                             file.line(),
                             RawMesh::Shape::hexahedron,
                             false,
                             kind};
    element.group = draft.part(card.tag("PID", Id::part, 8));
    if (draft.raw.second_order == SecondOrder::refused)
      file.refuse({"element ", std::to_string(element.number), " is of second order: ", cut_them, "."});
    if (kind == SecondOrderKind::hexahedron27 && draft.raw.second_order == SecondOrder::in_pieces)
      file.refuse({file.name(),
                   " cannot be cut in pieces, as the order of its mid nodes is not read: take cells by "
                   "their corners with {.second_order = SecondOrder::to_corners}."});
    std::array<FileNumber, 27> nodes;
    constexpr std::size_t count = 8 + mid_nodes(kind).size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 10 == 0) card = file.card();
      nodes[i] = card.tag("a node", Id::node, 8);
    }
    std::copy_n(nodes.begin(), 8, element.corners.begin());
    draft.raw.set_mids(element, std::span(nodes).subspan(8, count - 8));
    draft.raw.elements.push_back(element);
  });
}

inline constexpr std::array<std::string_view, 5> shell_options{"_THICKNESS", "_BETA", "_MCID", "_OFFSET", "_DOF"};
inline void plates(File& file, Draft& draft) {
  std::array<bool, 5> has;
  has_options(file.base().substr(std::string_view("*ELEMENT_SHELL").size()), shell_options, has);
  const bool thickness = has[0], beta = has[1], system = has[2], offset = has[3], scalars = has[4];
  file.for_each_card([&](Card card) {
    const FileNumber number = card.own_tag("the number of an element", "shell", Id::element, 8);
    RawMesh::Element element{shells + number, {}, 0, file.line(), RawMesh::Shape::quadrilateral};
    element.group = draft.part(card.tag("PID", Id::part, 8));
    for (std::size_t i = 0; i < 4; ++i) element.corners[i] = card.tag("a corner", Id::node, 8);
    if (element.corners[3] == 0) element.corners[3] = element.corners[2];
    std::array<FileNumber, 4> mids;
    for (FileNumber& mid : mids) mid = card.tag("a mid node", Id::node, 8);
    if (mids != std::array<FileNumber, 4>{}) {
      if (draft.raw.second_order == SecondOrder::refused)
        file.refuse({"element ", std::to_string(number), " is a shell of more than four nodes: ", cut_them, "."});
      if (element.corners[2] != element.corners[3] && std::find(mids.begin(), mids.end(), 0) != mids.end())
        file.refuse({"element ", std::to_string(number),
                     " is a shell of six nodes whose corners are not clear: repeat the third as the fourth."});
      element.second = SecondOrderKind::quadrilateral8;
      draft.raw.set_mids(element, mids);
    }
    draft.raw.elements.push_back(element);
    ShellCard values{};
    if (thickness || beta || system) {
      Card first = file.card();
      for (double& t : values.corner_thickness) t = first.number("THIC1 to THIC4", 0, 16);
      if (!system)
        values.angle = first.number("BETA", 0, 16);
      else
        file.ignore(first.number("MCID", 0, 16), "MCID");
    }
    if (offset) values.offset = file.card().number("OFFSET", 0, 16);
    if (scalars) file.ignore(file.card().says_more(), "The scalar nodes");
    if (values.corner_thickness != std::array<double, 4>{} || values.angle != 0 || values.offset != 0)
      draft.shells.push_back({number, values});
  });
}

/// The inertia of a part or a rigid body, at this place in the deck or the draft.
inline InertiaCard inertia_card(FileNumber part, File& file, Draft& draft, std::size_t place, bool of_body) {
  Card first = file.card(), second = file.card();
  InertiaCard card{part, first.vector("XC to ZC"), first.number("TM"), {}, {}, {}};
  const FileNumber kind = first.integer("IRCS");
  if (const FileNumber node = first.tag("NODEID", Id::node); node != 0)
    draft.centres.push_back({place, node, file.line(), of_body});
  const double xx = second.number("IXX"), xy = second.number("IXY"), xz = second.number("IXZ");
  const double yy = second.number("IYY"), yz = second.number("IYZ"), zz = second.number("IZZ");
  card.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  Card motion = file.card();
  card.velocity = motion.vector("VTX to VTZ"), card.spin = motion.vector("VRX to VRZ");
  if (kind == 1) {
    Card local = file.card();
    const Eigen::Vector3d along = local.vector("XL to ZL"), in_plane = local.vector("XLIP to ZLIP");
    if (const FileNumber system = local.tag("CID", Id::define); system != 0)
      draft.inertia_systems.push_back({place, system, file.line(), of_body});
    else
      card.turn(axes_of(along, in_plane, 0, file.source(), file.line()));
  }
  return card;
}
inline void inertia(FileNumber part, File& file, Draft& draft) {
  draft.deck.inertias.push_back(inertia_card(part, file, draft, draft.deck.inertias.size(), false));
}
inline PartContact part_contact(File& file) {
  Card card = file.card();
  PartContact contact{card.number("FS"), card.number("FD"), card.number("DC"), 0};
  file.ignore(card.number("VC"), "VC");
  contact.thickness = card.number("OPTT");
  for (const char* what : {"SFT", "SSF", "CPARM8"}) file.ignore(card.number(what), what);
  return contact;
}

inline constexpr std::array<std::string_view, 5> part_options{"_INERTIA", "_REPOSITION", "_CONTACT", "_PRINT",
                                                              "_ATTACHMENT_NODES"};
inline void parts(File& file, Draft& draft) {
  std::array<bool, 5> has;
  has_options(file.base().substr(std::string_view("*PART").size()), part_options, has);
  const bool with_inertia = has[0], repositions = has[1], with_contact = has[2], prints = has[3], attaches = has[4];
  file.for_each_headed_card([&](const std::string& name, Card card) {
    const FileNumber number = draft.own_number("part", Id::part, card, file);
    draft.raw.parts[draft.part(number)].name = name;
    const FileNumber section = card.tag("SECID", Id::other), material = card.tag("MID", Id::material),
                     eos = card.tag("EOSID", Id::material);
    PartCard part{number, name, section, material, eos, card.tag("HGID", Id::other)};
    file.ignore_rest(card);
    if (with_inertia) inertia(number, file, draft);
    if (repositions) file.ignore(file.card().says_more(), "The position of each part");
    if (with_contact) part.contact = part_contact(file);
    if (prints) file.pass_card();
    if (attaches) file.ignore(file.card().says_more(), "The attachment nodes of each part");
    draft.deck.part_cards.push_back(std::move(part));
  });
}
/// One part; its layers stand two on a line.
inline void composite(File& file, Draft& draft) {
  std::string name = file.part_heading();
  Card card = file.card();
  const FileNumber number = draft.own_number("part", Id::part, card, file);
  draft.raw.parts[draft.part(number)].name = name;
  CompositeCard composite{number, card.integer("ELFORM"), card.number("SHRF", 1), card.number("NLOC"), {}};
  file.ignore(card.number("MAREA"), "MAREA");
  PartCard part{number, std::move(name), 0, 0, 0, card.tag("HGID", Id::other)};
  if (file.base() == "*PART_COMPOSITE_CONTACT") part.contact = part_contact(file);
  file.for_each_card([&](Card layers) {
    for (int i = 0; i < 2; ++i) {
      const FileNumber material = layers.tag("MID", Id::material);
      const double thickness = layers.number("THICK"), angle = layers.number("B");
      layers.pass(1);
      if (material == 0 && thickness != 0) file.refuse({"a layer has no MID: give it a material."});
      if (material == 0) continue;
      if (!(thickness > 0)) file.refuse({"THICK of a layer is not positive: give it its thickness."});
      composite.layers.push_back({material, thickness, angle});
    }
  });
  draft.deck.part_cards.push_back(std::move(part));
  draft.deck.composites.push_back(std::move(composite));
}

inline constexpr Meaning of_nodes{"nodes; `supports` of TC and RC", "nodes; `Support`", "nothing"};
inline constexpr Meaning of_solids{
    "cells, of one line or two",
    "`Hex8{ViscousHourglass{QM}}` of fluids, and of ELFORM 1 with IHQ 1 to 3 or none; else `Hex8{}`; `Tet4{}`",
    "in a scene: ELFORM other than 1, IHQ other than 1 to 3, 6 and 7, for which another element stands"};
inline constexpr Meaning of_oriented_solids{"cells", "as `*ELEMENT_SOLID`", "the axes of each solid"};
inline constexpr Meaning of_second_order{"cells of first order, cut on request", "as `*ELEMENT_SOLID`",
                                         "refused unless the options cut them; the mid nodes of `_H27`"};
inline constexpr Meaning of_shells{
    "cells; `shells`: thickness, angle and offset of each that has some",
    "`Plate4{}`, `Plate3{}`; the thickness of a part, and of layers angle and offset, that all its shells have",
    "MCID; the scalar nodes of `_DOF`; in a scene: values that differ within a part, OFFSET without layers, ELFORM "
    "other than 2 and hourglass control, for which those of the plates stand"};
inline constexpr Meaning of_parts{
    "`parts`, `part_cards`; `inertias` of `_INERTIA`; of `_CONTACT` friction and OPTT",
    "`Part`; a `RigidBody` of `*MAT_RIGID`, with mass, centre, tensor and velocity of `_INERTIA`, whatever "
    "`*INITIAL_VELOCITY` says",
    "GRAV, ADPOPT, TMID; VC, SFT, SSF, CPARM8 of `_CONTACT`; the cards of `_REPOSITION` and `_ATTACHMENT_NODES`; in a "
    "scene: `_CONTACT`, `_INERTIA` of a part that moves with another"};
inline constexpr Meaning of_composites{
    "`parts`, `part_cards`; `composites`: layers, ELFORM, SHRF, NLOC",
    "`Layered{PlyStack{{Ply{...}, ...}}, Offset{...}, FibreDirection{...}}` of `FailingPly`, with `Erosion{}`",
    "MAREA; in a scene: layers of other materials than plies and `*MAT_ELASTIC`, SHRF, for which the shear by "
    "equilibrium stands"};
inline constexpr auto mesh_keywords = std::to_array<Keyword>({
    {"*NODE", nodes, Invariant::everywhere, &of_nodes},
    {"*ELEMENT_SOLID", all_solids, Invariant::everywhere, &of_solids},
    {"*ELEMENT_SOLID_ORTHO", oriented_solids, Invariant::none, &of_oriented_solids},
    {"*ELEMENT_SOLID_H20", solids_of_second_order<SecondOrderKind::hexahedron20>, Invariant::everywhere,
     &of_second_order},
    {"*ELEMENT_SOLID_H27", solids_of_second_order<SecondOrderKind::hexahedron27>, Invariant::everywhere,
     &of_second_order},
    {"*ELEMENT_SHELL", plates, Invariant::everywhere, &of_shells},
    {"*PART", parts, Invariant::everywhere, &of_parts},
    {"*PART_COMPOSITE", composite, Invariant::moved, &of_composites},
    {"*PART_COMPOSITE_CONTACT", composite, Invariant::moved, &of_composites},
});

/// The readers of *ELEMENT_SHELL and *PART with any of their options; null for other keywords.
inline const Keyword* keyword_with_options(std::string_view name) {
  static constexpr Keyword shell{"*ELEMENT_SHELL", plates, Invariant::moved, &of_shells},
      part{"*PART", parts, Invariant::none, &of_parts};
  std::array<bool, 5> has;
  if (name.starts_with(shell.name) && has_options(name.substr(shell.name.size()), shell_options, has)) return &shell;
  if (name.starts_with(part.name) && has_options(name.substr(part.name.size()), part_options, has)) return &part;
  return nullptr;
}
inline constexpr auto mesh_families = std::to_array<Family>({
    {"*ELEMENT_SHELL", {}, shell_options, keyword_with_options},
    {"*PART", {}, part_options, keyword_with_options},
});

}  // namespace strike::detail::dyna
