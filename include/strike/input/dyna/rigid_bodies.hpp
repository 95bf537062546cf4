#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/mesh.hpp>

// Rigid bodies of nodes, bodies that move with others, and nodes that move with a part.
namespace strike::detail::dyna {

inline constexpr std::string_view nodal_rigid_body = "*CONSTRAINED_NODAL_RIGID_BODY";
inline constexpr std::array<std::string_view, 4> rigid_body_options{"_SPC", "_INERTIA", "_OVERRIDE", "_TITLE"};

inline void rigid_bodies(File& file, Draft& draft) {
  std::array<bool, 4> has;
  has_options(file.base().substr(nodal_rigid_body.size()), rigid_body_options, has);
  const bool holds = has[0], with_inertia = has[1], overrides = has[2], titled = has[3];
  const auto body = [&](Card card) {
    const FileNumber number = draft.own_number("rigid body", Id::part, card, file);
    const std::uint32_t line = file.line();
    file.ignore(card.number("CID"), "CID");
    FileNumber set = card.tag("NSID", Id::set);
    if (set == 0) set = number;
    file.ignore(card.number("PNODE"), "PNODE");
    card.pass(1);  // IPRT
    file.ignore(card.number("DRFLAG"), "DRFLAG");
    file.ignore(card.number("RRFLAG"), "RRFLAG");
    Pending<RigidBodyCard> pending{{number, {}}, {{Named::set, set, line}}, 0, line};
    if (holds) {
      Card constraint = file.card();
      pending.system = held_by_body(constraint, pending.card.held, "a rigid body", file);
    }
    if (with_inertia) pending.card.inertia = inertia_card(number, file, draft, draft.rigid_bodies.size(), true);
    if (overrides) file.ignore(file.card().says_more(), "The overriding switches of contacts");
    draft.rigid_bodies.push_back(std::move(pending));
  };
  if (titled)
    file.for_each_headed_card([&](const std::string&, const Card& card) { body(card); });
  else
    file.for_each_titled_card(body);
}
inline void rigid_merges(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber lead = card.tag("PIDL", Id::part), constrained = card.tag("PIDC", Id::part);
    file.ignore(card.number("IFLAG"), "IFLAG");
    if (lead == 0 && constrained == 0) return;
    if (lead == 0 || constrained == 0 || lead == constrained)
      file.refuse({"PIDL and PIDC are not two bodies: give the part that leads and the one that moves with it."});
    draft.rigid_merges.push_back({{lead, constrained}, {}, 0, file.line()});
  });
}
template <Named named>
void extra_nodes(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber part = card.tag("PID", Id::part);
    const FileNumber number =
        card.tag(named == Named::node ? "NID" : "NSID", named == Named::node ? Id::node : Id::set);
    file.ignore(card.number("IFLAG"), "IFLAG");
    if (part == 0 && number == 0) return;
    if (part == 0 || number == 0) file.refuse({"extra nodes have no part or no nodes: give PID and the nodes."});
    auto& all = draft.extra_nodes;
    if (all.empty() || all.back().card.part != part) all.push_back({{part, {}}, {}, 0, file.line()});
    all.back().choices.push_back({named, number, file.line()});
  });
}

inline constexpr Meaning of_rigid_merges{"`rigid_merges`: numbers of parts or bodies",
                                         "one `RigidBody` of the cells of the parts",
                                         "IFLAG; in a scene: merges of bodies of nodes"};
inline constexpr Meaning of_extra_nodes{"`extra_nodes` of a part or body", "`.with_nodes(...)` of the `RigidBody`",
                                        "IFLAG"};
inline constexpr Meaning of_rigid_bodies{
    "`rigid_bodies`: nodes, what holds them (`_SPC`), inertia",
    "`RigidBody` of the nodes, with `HeldBody`; of `_INERTIA` with its mass, centre and tensor as `TotalInertia`, and "
    "its velocity, whatever `*INITIAL_VELOCITY` says",
    "CID, PNODE, DRFLAG, RRFLAG, the card of `_OVERRIDE`"};
inline constexpr auto rigid_keywords = std::to_array<Keyword>({
    {"*CONSTRAINED_RIGID_BODIES", rigid_merges, Invariant::everywhere, &of_rigid_merges},
    {"*CONSTRAINED_EXTRA_NODES_NODE", extra_nodes<Named::node>, Invariant::everywhere, &of_extra_nodes},
    {"*CONSTRAINED_EXTRA_NODES_SET", extra_nodes<Named::set>, Invariant::everywhere, &of_extra_nodes},
});
/// The reader of *CONSTRAINED_NODAL_RIGID_BODY with any of its options; null for other keywords.
inline const Keyword* rigid_body_keyword(std::string_view name) {
  static constexpr Keyword plain{nodal_rigid_body, rigid_bodies, Invariant::everywhere, &of_rigid_bodies},
      in_place{nodal_rigid_body, rigid_bodies, Invariant::none, &of_rigid_bodies};
  std::array<bool, 4> has;
  if (!name.starts_with(nodal_rigid_body)) return nullptr;
  if (!has_options(name.substr(nodal_rigid_body.size()), rigid_body_options, has)) return nullptr;
  return has[0] || has[1] ? &in_place : &plain;
}
inline constexpr auto rigid_families = std::to_array<Family>({
    {nodal_rigid_body, {}, rigid_body_options, rigid_body_keyword},
});

}  // namespace strike::detail::dyna
