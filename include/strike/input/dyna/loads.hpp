#pragma once
#include <array>
#include <string>
#include <utility>

#include <strike/input/dyna/draft.hpp>

// Supports and initial velocities.
namespace strike::detail::dyna {

/// Calls f with each support and the choice of its nodes; a line of zeros is none.
template <class F>
void supports(Named named, File& file, F f) {
  file.for_each_titled_card([&](Card card) {
    const char* const field = named == Named::node ? "NID" : "NSID";
    const Choice choice{named, card.tag(field, named == Named::node ? Id::node : Id::set), file.line()};
    const FileNumber system = card.tag("CID", Id::define);
    SupportCard support{};
    bool holds = system != 0;
    for (auto* const degrees : {&support.held, &support.held_turns})
      for (bool& held : *degrees) holds |= held = card.integer("DOFX to DOFRZ") != 0;
    if (choice.number == 0 && holds) file.refuse({"a support has no ", field, ": give it one."});
    if (choice.number != 0) f(support, choice, system);
  });
}
inline void node_supports(File& file, Draft& draft) {
  supports(Named::node, file,
           [&](const auto& way, const Choice& node, FileNumber system) { draft.support_node(way, node, system); });
}
inline void set_supports(File& file, Draft& draft) {
  supports(Named::set, file, [&](const auto& way, const Choice& set, FileNumber system) {
    draft.set_supports.push_back({way, {set}, system});
  });
}

/// The nodes of a set, or all if it has no number.
inline Choice set_or_all(FileNumber set, std::uint32_t line) { return {set == 0 ? Named::all : Named::set, set, line}; }
inline void velocity(File& file, Draft& draft) {
  Card card = file.card(), values = file.card();
  const FileNumber set = card.tag("NSID", Id::set);
  for (const char* what : {"NSIDEX", "BOXID", "IRIGID", "ICID"}) file.ignore(card.number(what), what);
  const VelocityCard velocity{{}, values.vector("VX to VZ")};
  file.ignore(values.vector("VXR to VZR").norm(), "VXR to VZR");
  draft.velocities.push_back({velocity, {set_or_all(set, file.line())}});
}
/// One card for successive nodes of the same velocity.
inline void node_velocities(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    const Choice node{Named::node, card.own_tag("NID", "velocity", Id::node), file.line()};
    const VelocityCard velocity{{}, card.vector("VX to VZ")};
    file.ignore(card.vector("VXR to VZR").norm(), "VXR to VZR");
    file.ignore(card.number("ICID"), "ICID");
    auto& all = draft.velocities;
    if (all.empty() || all.back().card.velocity != velocity.velocity || all.back().choices[0].named != Named::node)
      all.push_back({velocity, {}});
    all.back().choices.push_back(node);
  });
}
inline void generated_velocities(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    const std::uint32_t line = file.line();
    Card later = card;
    later.pass(1);
    const FileNumber kind = later.integer("STYP"), number = card.tag("ID", kind == 2 ? Id::part : Id::set);
    card.pass(1);
    const double omega = card.number("OMEGA");
    VelocityCard velocity{{}, card.vector("VX to VZ")};
    Card turn = file.card();
    velocity.centre = turn.vector("XC to ZC");
    const Eigen::Vector3d axis = turn.vector("NX to NZ");
    if (omega != 0 && axis[0] == -999)
      file.ignore(1, "OMEGA about an axis between nodes");
    else if (omega != 0) {
      if (!(axis.norm() > 0)) file.refuse({"the axis of a spin has no direction: give NX, NY and NZ."});
      velocity.spin = omega / axis.norm() * axis;
    }
    file.ignore(turn.number("PHASE"), "PHASE");
    file.ignore_rest(card, turn);
    if (number != 0 && (kind < 1 || kind > 3))
      file.refuse({"STYP ", std::to_string(kind), " is none: give 1 (part set), 2 (part) or 3 (node set)."});
    constexpr std::array<Named, 4> kinds{Named::all, Named::part_set, Named::part, Named::set};
    draft.velocities.push_back({velocity, {{kinds[number == 0 ? 0 : std::size_t(kind)], number, line}}});
  });
}

inline constexpr Meaning of_supports{"`supports`, with the axes of CID", "`Support`", "nothing"};
inline constexpr Meaning of_velocity{"`velocities`", "`InitialVelocity`", "NSIDEX, BOXID, IRIGID, ICID, VXR to VZR"};
inline constexpr Meaning of_node_velocities{"`velocities`", "`InitialVelocity`", "VXR to VZR, ICID"};
inline constexpr Meaning of_generated_velocities{"`velocities`, with spin", "`InitialVelocity` with `Spin`",
                                                 "an axis between nodes (NX -999), PHASE, further fields"};
inline constexpr auto load_keywords = std::to_array<Keyword>({
    {"*BOUNDARY_SPC_NODE", node_supports, Invariant::none, &of_supports},
    {"*BOUNDARY_SPC_SET", set_supports, Invariant::none, &of_supports},
    {"*INITIAL_VELOCITY", velocity, Invariant::none, &of_velocity},
    {"*INITIAL_VELOCITY_NODE", node_velocities, Invariant::none, &of_node_velocities},
    {"*INITIAL_VELOCITY_GENERATION", generated_velocities, Invariant::none, &of_generated_velocities},
});

}  // namespace strike::detail::dyna
