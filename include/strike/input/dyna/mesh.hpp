#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/sets.hpp>

// Nodes, elements and parts.
namespace strike::detail::dyna {

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
  MovedNodes moved{file.motion(), draft.raw.nodes.size(), 0, 0};
  file.for_each_card([&](Card card) {
    const FileNumber number = card.own_tag("the number of a node", "node", Id::node, 8);
    Eigen::Vector3d x;
    for (Eigen::Index i = 0; i < 3; ++i) x[i] = card.number("the coordinate", 0, 16);
    draft.raw.nodes.push_back({number, x, file.line()});
    if (card.is_blank()) return;

    const auto held = held_by(card.integer("TC", 0, 8), file), held_turns = held_by(card.integer("RC", 0, 8), file);
    if (constexpr std::array free{false, false, false}; held != free || held_turns != free)
      draft.support_node({{}, held, held_turns}, {Named::node, number, file.line()}), moved.held = file.line();
  });
  moved.last = draft.raw.nodes.size();
  if (moved.motion != 0 && moved.first != moved.last) draft.moved.push_back(moved);
}

inline void solids(File& file, Draft& draft) {
  file.for_each_card([&](Card card) {
    RawMesh::Element element{card.own_tag("the number of an element", "solid", Id::element, 8),
                             {},
                             0,
                             file.line(),
                             RawMesh::Shape::hexahedron};
    element.group = draft.part(card.tag("PID", Id::part, 8));
    if (card.is_blank()) card = file.card();  // the corners have a line of their own
    for (FileNumber& corner : element.corners) corner = card.tag("a corner", Id::node, 8);
    for (std::size_t i = 4; i < 8; ++i)
      if (element.corners[i] == 0) element.corners[i] = element.corners[i - 1];
    if (card.tag("a corner", Id::node, 8) != 0)
      file.refuse({"element ", std::to_string(element.number),
                   " is a tetrahedron of ten nodes: mesh in first order, with four."});
    draft.raw.elements.push_back(element);
  });
}
inline void plate(Card card, const File& file, Draft& draft) {
  const FileNumber number = card.own_tag("the number of an element", "shell", Id::element, 8);
  RawMesh::Element element{shells + number, {}, 0, file.line(), RawMesh::Shape::quadrilateral};
  element.group = draft.part(card.tag("PID", Id::part, 8));
  for (std::size_t i = 0; i < 4; ++i) element.corners[i] = card.tag("a corner", Id::node, 8);
  if (element.corners[3] == 0) element.corners[3] = element.corners[2];
  if (card.tag("a corner", Id::node, 8) != 0)
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
  file.for_each_headed_card([&](const std::string& name, Card card) {
    const FileNumber number = draft.own_number("part", Id::part, card, file);
    draft.raw.parts[draft.part(number)].name = name;
    const FileNumber section = card.tag("SECID", Id::other), material = card.tag("MID", Id::material),
                     eos = card.tag("EOSID", Id::material);
    draft.deck.part_cards.push_back({number, name, section, material, eos, card.tag("HGID", Id::other)});
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

inline constexpr auto mesh_keywords = std::to_array<Keyword>({
    {"*NODE", nodes, Invariant::everywhere},
    {"*ELEMENT_SOLID", solids, Invariant::everywhere},
    {"*ELEMENT_SHELL", plates, Invariant::everywhere},
    {"*ELEMENT_SHELL_THICKNESS", thick_plates},
    {"*PART", parts<>, Invariant::everywhere},
    {"*PART_INERTIA", parts<PartOption::inertia>, Invariant::none},
    {"*PART_CONTACT", parts<PartOption::contact>},
});

}  // namespace strike::detail::dyna
