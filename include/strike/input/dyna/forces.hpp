#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/sets.hpp>

// Body loads, nodal loads, pressures and prescribed motions.
namespace strike::detail::dyna {

/// True for times of death beyond the end of any run, which have no effect.
inline double early(double death) { return death < 1e20 ? death : 0; }

/// The unit vector of degree of freedom 1, 2 or 3.
inline Eigen::Vector3d unit_of(FileNumber axis) { return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis - 1)); }

/// LCID and SF. Error: no curve.
inline CardHistory history_of(Card& card, const File& file) {
  CardHistory history{.curve = card.tag("LCID", Id::curve)};
  history.scale = card.number("SF", 1);
  if (history.curve == 0) file.refuse({file.name(), " has no LCID: give it a curve."});
  return history;
}

template <int axis>
void body_load(File& file, Draft& draft) {
  Card card = file.card(), later = card;
  later.pass(2);
  const double relaxing = later.number("LCIDDR");
  file.ignore(relaxing, "LCIDDR");
  if (relaxing != 0 && Card(card).tag("LCID", Id::curve) == 0) return;  // a load before the run alone
  BodyLoadCard load{-unit_of(axis), history_of(card, file)};
  card.pass(1);
  card.pass(3);  // the centre of a rotation
  const FileNumber system = card.tag("CID", Id::define);
  draft.body_loads.push_back({std::move(load), {}, system, file.line()});
}
inline void body_load_parts(File& file, Draft& draft) {
  if (const FileNumber set = file.card().tag("PSID", Id::set); set != 0)
    draft.body_load_parts.push_back({Named::part_set, set, file.line()});
}

/// Lines that load other nodes alike are one load; a node that is loaded twice begins another.
template <Named named>
void nodal_loads(File& file, Draft& draft) {
  struct Group {
    std::size_t load;
    std::set<FileNumber> nodes = {};
  };
  std::map<std::tuple<FileNumber, FileNumber, double, FileNumber>, Group> groups;  // by DOF, curve, scale and system
  file.for_each_titled_card([&](Card card) {
    const char* const field = named == Named::node ? "NID" : "NSID";
    const FileNumber number = card.tag(field, named == Named::node ? Id::node : Id::set);
    const FileNumber freedom = card.integer("DOF");
    if (number == 0 && freedom == 0) return;
    if (number == 0) file.refuse({"a nodal load has no ", field, ": give it one."});
    if (freedom < 1 || freedom > 8)
      file.refuse({"DOF ", std::to_string(freedom), " of a nodal load is none: give 1 to 3, or 5 to 7 for a moment."});
    NodalLoadCard load{{}, Eigen::Vector3d::Zero(), freedom > 4, history_of(card, file)};
    const FileNumber system = card.tag("CID", Id::define);
    if (freedom == 4 || freedom == 8) return file.ignore(1, "A force that follows its nodes (DOF 4 or 8)");
    load.direction = unit_of(load.turns ? freedom - 4 : freedom);
    auto& all = draft.nodal_loads;
    const std::tuple key(freedom, load.history.curve, load.history.scale, system);
    const auto [group, is_new] = groups.try_emplace(key, Group{all.size()});
    if (!is_new && (named != Named::node || group->second.nodes.contains(number))) group->second = {all.size()};
    if (group->second.load == all.size()) all.push_back({std::move(load), {}, system, file.line()});
    all[group->second.load].choices.push_back({named, number, file.line()});
    if (named == Named::node) group->second.nodes.insert(number);
  });
}

/// Places in the draft by curve, scale and birth.
using PressurePlaces = std::map<std::tuple<FileNumber, double, double>, std::size_t>;
/// The pressure that a line joins: that of its keyword with the same history.
inline PendingPressure& pressure_of(CardHistory history, PressurePlaces& places, File& file, Draft& draft) {
  auto& all = draft.pressures;
  const auto [place, is_new] = places.try_emplace({history.curve, history.scale, history.birth}, all.size());
  if (is_new) all.push_back({{{}, std::move(history)}, {}, {}, file.line()});
  return all[place->second];
}
/// LCID, SF and AT. LCID -2 stands for the pressure of *LOAD_BLAST.
inline constexpr FileNumber of_blast = -2;
inline CardHistory pressure_history(Card& card, File& file) {
  Card first = card;
  if (first.integer("LCID") == of_blast) {
    const double scale = first.number("SF", 1);
    file.ignore(scale == 1 ? 0 : scale, "SF of a blast");
    file.ignore(first.number("AT"), "AT of a blast");
    card = first;
    return {.curve = of_blast};
  }
  CardHistory history = history_of(card, file);
  history.birth = card.number("AT");
  return history;
}
inline void segment_pressures(File& file, Draft& draft) {
  PressurePlaces places;
  file.for_each_titled_card([&](Card card) {
    CardHistory history = pressure_history(card, file);
    PendingPressure& pressure = pressure_of(std::move(history), places, file, draft);
    pressure.segments.push_back(segment_of(card, file));
    if (card.tag("N5", Id::node) != 0 && draft.raw.second_order == SecondOrder::refused)
      file.refuse({"a segment has more than four corners: ", cut_them, "."});
  });
}
template <Named named>
void pressures(File& file, Draft& draft) {
  PressurePlaces places;
  file.for_each_titled_card([&](Card card) {
    const char* const field = named == Named::segment_set ? "SSID" : named == Named::shell ? "EID" : "ESID";
    const FileNumber number = card.tag(field, named == Named::shell ? Id::element : Id::set);
    if (number == 0 && !card.says_more()) return;
    if (number == 0) file.refuse({"a pressure has no ", field, ": give it one."});
    CardHistory history = pressure_history(card, file);
    file.ignore_rest(card);
    pressure_of(std::move(history), places, file, draft).choices.push_back({named, number, file.line()});
  });
}

/// Motions of nodes that are alike are one.
template <Named named>
void prescribed_motions(File& file, Draft& draft) {
  using Kind = PrescribedMotionCard::Kind;
  std::map<std::tuple<FileNumber, FileNumber, FileNumber, FileNumber, double, double, double>, std::size_t> places;
  file.for_each_titled_card([&](Card card) {
    constexpr bool of_part = named == Named::part;
    const char* const field = of_part ? "PID" : named == Named::node ? "NID" : "NSID";
    const std::uint32_t line = file.line();
    const FileNumber number = card.tag(field, of_part ? Id::part : named == Named::node ? Id::node : Id::set);
    const FileNumber freedom = card.integer("DOF"), kind = card.integer("VAD");
    if (number == 0 && freedom == 0) return;
    if (number == 0) file.refuse({"a prescribed motion has no ", field, ": give it one."});
    PrescribedMotionCard motion{};
    motion.history = history_of(card, file);
    const FileNumber vector = card.tag("VID", Id::define);
    if (const double death = card.number("DEATH"); death > 0 && early(death) != 0) motion.history.death = death;
    motion.history.birth = card.number("BIRTH");
    const FileNumber size = freedom < -12 ? 13 : std::abs(freedom);
    if (size < 1 || size > 12 || (freedom < 0 && (size < 8 || size == 12) && size != 4))
      file.refuse({"DOF ", std::to_string(freedom),
                   " of a prescribed motion is none: give 1 to 3, 5 to 7, or 4 and 8 with a VID."});
    if (kind < 0 || kind > 4)
      file.refuse({"VAD ", std::to_string(kind), " is none: give 0 (velocity), 1 (acceleration) or 2 (displacement)."});
    const auto leave = [&](const char* what) { file.ignore_on_line(line, joined({what, " of ", file.name()})); };
    if ((size >= 9 && size <= 11) || kind == 4) file.pass_card();
    if (size > 8) return leave("A motion about an offset axis or along normals (DOF 9 to 12)");
    if (kind > 2) return leave("A motion over displacements, or of one body to another (VAD 3 or 4)");
    const bool by_vector = size == 4 || size == 8;
    if (by_vector && vector == 0)
      file.refuse({"DOF ", std::to_string(freedom), " of a prescribed motion has no VID: give it a *DEFINE_VECTOR."});
    motion.turns = size > 4;
    motion.holds_others = freedom < 0;
    motion.kind = kind == 0 ? Kind::velocity : kind == 1 ? Kind::acceleration : Kind::displacement;
    motion.direction = by_vector ? Eigen::Vector3d::Zero().eval() : unit_of(motion.turns ? size - 4 : size);
    if (of_part) motion.body = number;
    auto& all = draft.motions;
    const FileNumber along = by_vector ? vector : 0;
    const CardHistory& history = motion.history;
    const std::tuple key(freedom, kind, along, history.curve, history.scale, history.birth, history.death);
    const auto [place, is_new] = places.try_emplace(key, all.size());
    if (!is_new && of_part) place->second = all.size();
    if (place->second == all.size()) all.push_back({std::move(motion), {}, along, line});
    all[place->second].choices.push_back({named, number, line});
  });
}

inline constexpr Meaning of_body_loads{"`body_loads`, which push against their axes", "`BodyForce`", "LCIDDR"};
inline constexpr Meaning of_body_load_parts{"`parts` of `body_loads`", "-",
                                            "in a scene: all parts feel the body force"};
inline constexpr Meaning of_nodal_loads{"`nodal_loads`: forces and moments, along the axes of CID", "`NodalForce`",
                                        "forces that follow their nodes (DOF 4 and 8); in a scene: moments"};
inline constexpr Meaning of_segment_pressures{"`pressures`, against the normal", "`Pressure`",
                                              "SF and AT of a blast (LCID -2)"};
inline constexpr Meaning of_pressures{"`pressures`, against the normal", "`Pressure`",
                                      "SF and AT of a blast (LCID -2), further fields"};
inline constexpr Meaning of_motions{
    "`motions`: velocities, accelerations, displacements, along an axis or VID",
    "`PrescribedVelocity`, `PrescribedDisplacement`",
    "DOF 9 to 12, VAD 3 and 4; in a scene: accelerations, turns, DOF below 0, BIRTH and DEATH within the run"};
inline constexpr Meaning of_body_motions{"`motions` of a `body`",
                                         "`BodyVelocity`, `BodyDisplacement` of the `RigidBody`",
                                         "as of nodes; in a scene: a second motion of a body"};
inline constexpr auto force_keywords = std::to_array<Keyword>({
    {"*LOAD_BODY_X", body_load<1>, Invariant::none, &of_body_loads},
    {"*LOAD_BODY_Y", body_load<2>, Invariant::none, &of_body_loads},
    {"*LOAD_BODY_Z", body_load<3>, Invariant::none, &of_body_loads},
    {"*LOAD_BODY_PARTS", body_load_parts, Invariant::everywhere, &of_body_load_parts},
    {"*LOAD_NODE_POINT", nodal_loads<Named::node>, Invariant::none, &of_nodal_loads},
    {"*LOAD_NODE_SET", nodal_loads<Named::set>, Invariant::none, &of_nodal_loads},
    {"*LOAD_SEGMENT", segment_pressures, Invariant::moved, &of_segment_pressures},
    {"*LOAD_SEGMENT_SET", pressures<Named::segment_set>, Invariant::moved, &of_pressures},
    {"*LOAD_SHELL_ELEMENT", pressures<Named::shell>, Invariant::moved, &of_pressures},
    {"*LOAD_SHELL_SET", pressures<Named::shell_set>, Invariant::moved, &of_pressures},
    {"*BOUNDARY_PRESCRIBED_MOTION_NODE", prescribed_motions<Named::node>, Invariant::none, &of_motions},
    {"*BOUNDARY_PRESCRIBED_MOTION_SET", prescribed_motions<Named::set>, Invariant::none, &of_motions},
    {"*BOUNDARY_PRESCRIBED_MOTION_RIGID", prescribed_motions<Named::part>, Invariant::none, &of_body_motions},
});

}  // namespace strike::detail::dyna
