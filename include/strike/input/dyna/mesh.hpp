#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>

// Nodes, elements, parts and sets.
namespace strike::detail::dyna {

inline constexpr FileNumber shells = RawMesh::scope;  ///< their numbers are others than those of the solids

/// TC and RC of a node: which of x, y, z are held.
inline std::array<bool, 3> held_by(FileNumber code, const File& file) {
  constexpr std::array<std::array<bool, 3>, 8> codes{{{false, false, false},
                                                      {true, false, false},
                                                      {false, true, false},
                                                      {false, false, true},
                                                      {true, true, false},
                                                      {false, true, true},
                                                      {true, false, true},
                                                      {true, true, true}}};
  if (code < 0 || code > 7) file.refuse({"the constraint ", std::to_string(code), " of a node is none: give 0 to 7."});
  return codes[static_cast<std::size_t>(code)];
}
inline void nodes(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    const FileNumber number = card.own_tag("the number of a node", "node", 8);
    Eigen::Vector3d x;
    for (Eigen::Index i = 0; i < 3; ++i) x[i] = card.number("the coordinate", 0, 16);
    draft.raw.nodes.push_back({number, x, file.line()});
    if (card.is_blank()) return;
    const auto held = held_by(card.integer("TC", 0, 8), file), held_turns = held_by(card.integer("RC", 0, 8), file);
    if (constexpr std::array free{false, false, false}; held != free || held_turns != free)
      draft.support_node({{}, held, held_turns}, {Named::node, number, file.line()});
  });
}

inline void solids(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    RawMesh::Element element{
        card.own_tag("the number of an element", "solid", 8), {}, 0, file.line(), RawMesh::Shape::hexahedron};
    element.group = draft.part(card.tag("PID", 8));
    if (card.is_blank()) card = file.card();  // the corners have a line of their own
    for (FileNumber& corner : element.corners) corner = card.tag("a corner", 8);
    for (std::size_t i = 4; i < 8; ++i)
      if (element.corners[i] == 0) element.corners[i] = element.corners[i - 1];
    if (card.tag("a corner", 8) != 0)
      file.refuse({"element ", std::to_string(element.number),
                   " is a tetrahedron of ten nodes: mesh in first order, with four."});
    draft.raw.elements.push_back(element);
  });
}
inline void plate(Card card, const File& file, Draft& draft) {
  const FileNumber number = card.own_tag("the number of an element", "shell", 8);
  RawMesh::Element element{shells + number, {}, 0, file.line(), RawMesh::Shape::quadrilateral};
  element.group = draft.part(card.tag("PID", 8));
  for (std::size_t i = 0; i < 4; ++i) element.corners[i] = card.tag("a corner", 8);
  if (element.corners[3] == 0) element.corners[3] = element.corners[2];
  if (card.tag("a corner", 8) != 0)
    file.refuse({"element ", std::to_string(number), " is a shell of more than four nodes: mesh in first order."});
  draft.raw.elements.push_back(element);
}
inline void plates(File& file, Draft& draft) {
  file.for_each_card([&](const Card& card) { plate(card, file, draft); });
}
inline void thick_plates(File& file, Draft& draft) {
  file.for_each_card([&](const Card& card) {
    plate(card, file, draft);
    if (file.pass_card()) file.ignore(1, "The thickness of each shell");
  });
}

/// The cards that follow that of a part.
enum class PartOption { none, inertia, contact };
template <PartOption option = PartOption::none>
void parts(File& file, Draft& draft) {
  file.for_each_headed_card([&](std::string_view heading, Card card) {
    const std::string name(heading);
    const FileNumber number = draft.own_number("part", card, file);
    draft.raw.parts[draft.part(number)].name = name;
    const FileNumber section = card.tag("SECID"), material = card.tag("MID"), eos = card.tag("EOSID");
    draft.deck.part_cards.push_back({number, name, section, material, eos, card.tag("HGID")});
    file.ignore_rest(card);
    if constexpr (option == PartOption::inertia) {
      file.ignore(1, "The inertia of each part");
      Card centre = file.card();
      centre.pass(4);
      for (int left = centre.integer("IRCS") == 1 ? 3 : 2; left > 0; --left) file.pass_card();
    }
    if constexpr (option == PartOption::contact)
      if (file.pass_card()) file.ignore(1, "The contact of each part");
  });
}

/// Numbers one by one, or in pairs of the first and the last.
enum class Listed { singly, in_ranges };
inline void set(File& file, Draft& draft, std::vector<RawMesh::Set>& sets, std::string_view kind, FileNumber scope,
                Listed listed) {
  std::string name = file.title();
  Card head = file.card();
  RawMesh::Set set{.number = draft.own_number(kind, head, file), .name = std::move(name), .line = file.line()};
  file.for_each_card([&](Card card) {
    for (int field = 0; field < 8; field += listed == Listed::singly ? 1 : 2) {
      const FileNumber first = card.tag("a number of the set");
      const FileNumber last = listed == Listed::singly ? first : card.tag("a number of the set");
      if (first > last || (first == 0 && last != 0))
        file.refuse({"the range from ", std::to_string(first), " to ", std::to_string(last),
                     " is empty: give the smaller number first."});
      if (first != 0) set.sequences.push_back({scope + first, scope + last, 1, file.line()});
    }
    file.ignore_rest(card);
  });
  sets.push_back(std::move(set));
}
template <Listed listed>
void node_set(File& file, Draft& draft) {
  set(file, draft, draft.raw.node_sets, "set of nodes", 0, listed);
}
template <Listed listed>
void solid_set(File& file, Draft& draft) {
  set(file, draft, draft.raw.element_sets, "set of solids", 0, listed);
}
template <Listed listed>
void shell_set(File& file, Draft& draft) {
  set(file, draft, draft.raw.element_sets, "set of shells", shells, listed);
}
template <Listed listed>
void part_set(File& file, Draft& draft) {
  set(file, draft, draft.part_sets, "set of parts", 0, listed);
}
inline PendingSet pending_set(File& file, Draft& draft) {
  std::string name = file.title();
  Card head = file.card();
  return {draft.own_number("set of nodes", head, file), std::move(name), {}};
}
inline void sum_of_node_sets(File& file, Draft& draft) {
  PendingSet set = pending_set(file, draft);
  file.for_each_card([&](Card card) {
    for (int field = 0; field < 8; ++field)
      if (const FileNumber other = card.tag("a number of the set"); other != 0)
        set.choices.push_back({Named::set, other, file.line()});
    file.ignore_rest(card);
  });
  draft.general_sets.push_back(std::move(set));
}
inline void general_node_set(File& file, Draft& draft) {
  PendingSet set = pending_set(file, draft);
  file.for_each_card([&](Card card) {
    const std::string option = upper(card.text());
    if (option == "ALL") {
      set.choices.push_back({Named::all, 0, file.line()});
      return;
    }
    if (option != "NODE" && option != "PART")
      file.refuse({"the option ", shown(option), " of ", file.name(), " is not read: give ALL, NODE or PART."});
    for (int field = 0; field < 7; ++field)
      if (const FileNumber number = card.tag("a number of the set"); number != 0)
        set.choices.push_back({option == "NODE" ? Named::node : Named::part, number, file.line()});
    file.ignore_rest(card);
  });
  draft.general_sets.push_back(std::move(set));
}

inline constexpr auto mesh_keywords = std::to_array<Keyword>({
    {"*NODE", nodes},
    {"*ELEMENT_SOLID", solids},
    {"*ELEMENT_SHELL", plates},
    {"*ELEMENT_SHELL_THICKNESS", thick_plates},
    {"*PART", parts<>},
    {"*PART_INERTIA", parts<PartOption::inertia>},
    {"*PART_CONTACT", parts<PartOption::contact>},
    {"*SET_NODE", node_set<Listed::singly>},
    {"*SET_NODE_LIST", node_set<Listed::singly>},
    {"*SET_NODE_LIST_GENERATE", node_set<Listed::in_ranges>},
    {"*SET_NODE_ADD", sum_of_node_sets},
    {"*SET_NODE_GENERAL", general_node_set},
    {"*SET_SOLID", solid_set<Listed::singly>},
    {"*SET_SOLID_GENERATE", solid_set<Listed::in_ranges>},
    {"*SET_SHELL", shell_set<Listed::singly>},
    {"*SET_SHELL_LIST", shell_set<Listed::singly>},
    {"*SET_SHELL_LIST_GENERATE", shell_set<Listed::in_ranges>},
    {"*SET_PART", part_set<Listed::singly>},
    {"*SET_PART_LIST", part_set<Listed::singly>},
    {"*SET_PART_LIST_GENERATE", part_set<Listed::in_ranges>},
});

}  // namespace strike::detail::dyna
