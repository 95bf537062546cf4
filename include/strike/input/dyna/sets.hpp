#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>

// Sets of nodes, cells, parts and segments.
namespace strike::detail::dyna {

inline constexpr FileNumber shells = RawMesh::scope;  ///< their numbers are others than those of the solids

/// A kind of set: its place in the draft, and what its numbers count.
struct SetKind {
  std::string_view name;
  Id id;
  FileNumber scope;
  std::vector<RawMesh::Set>& (*sets)(Draft&);
};
inline constexpr SetKind node_sets{"set of nodes", Id::node, 0,
                                   [](Draft& draft) -> auto& { return draft.raw.node_sets; }};
inline constexpr SetKind solid_sets{"set of solids", Id::element, 0,
                                    [](Draft& draft) -> auto& { return draft.raw.element_sets; }};
inline constexpr SetKind shell_sets{"set of shells", Id::element, shells,
                                    [](Draft& draft) -> auto& { return draft.raw.element_sets; }};
inline constexpr SetKind part_sets{"set of parts", Id::part, 0, [](Draft& draft) -> auto& { return draft.part_sets; }};

/// DA1 to DA4, attributes that contacts take.
inline void tell_attributes(Card& head, File& file) {
  double sum = 0;
  for (int field = 0; field < 4; ++field) sum += std::abs(head.number("DA1 to DA4"));
  file.ignore(sum, "DA1 to DA4");
}

/// Numbers one by one, in pairs of the first and the last, or with a step.
enum class Listed { singly, in_ranges, in_steps };
template <const SetKind& kind, Listed listed = Listed::singly>
void set(File& file, Draft& draft) {
  std::string name = file.title();
  Card head = file.card();
  RawMesh::Set set{.name = std::move(name), .line = file.line()};
  std::vector<RawMesh::Set>& all = kind.sets(draft);
  set.number = file.collects() ? head.own_tag("the number of a set", kind.name, Id::set)
                               : draft.own_number(kind.name, Id::set, head, file);
  if (&kind != &solid_sets) tell_attributes(head, file);  // whose second field is SOLVER
  file.for_each_card([&](Card card) {
    constexpr int fields = listed == Listed::singly ? 1 : listed == Listed::in_ranges ? 2 : 3;
    for (int field = 0; field + fields <= 8; field += fields) {
      const FileNumber first = card.tag("a number of the set", kind.id);
      const FileNumber last = fields == 1 ? first : card.tag("a number of the set", kind.id);
      const FileNumber step = fields < 3 ? 1 : card.integer("INCR", 1);
      if (first > last || (first == 0 && last != 0) || step < 1)
        file.refuse({"the range from ", std::to_string(first), " to ", std::to_string(last),
                     " is empty: give the smaller number first."});
      if (first != 0) set.sequences.push_back({kind.scope + first, kind.scope + last, step, file.line()});
    }
    file.ignore_rest(card);
  });
  const auto [place, is_new] = draft.set_places.try_emplace({kind.name, set.number}, all.size());
  if (is_new) {
    draft.defined.try_emplace({kind.name, set.number}, set.line);
    all.push_back(std::move(set));
  } else {
    std::vector<RawMesh::Sequence>& sequences = all[place->second].sequences;
    sequences.insert(sequences.end(), set.sequences.begin(), set.sequences.end());
  }
}

inline PendingSet pending_set(File& file, Draft& draft, std::string_view kind) {
  std::string name = file.title();
  Card head = file.card();
  const FileNumber number = draft.own_number(kind, Id::set, head, file);
  if (kind != solid_sets.name) tell_attributes(head, file);
  return {number, std::move(name), file.line(), {}};
}
/// A set of the nodes, cells or parts of other sets.
template <const SetKind& kind>
void sum_of_sets(File& file, Draft& draft) {
  PendingSet set = pending_set(file, draft, kind.name);
  file.for_each_card([&](Card card) {
    for (int field = 0; field < 8; ++field)
      if (const FileNumber other = card.tag("a number of the set", Id::set); other != 0)
        set.choices.push_back({kind.id == Id::part ? Named::part_set : Named::set, other, file.line()});
    file.ignore_rest(card);
  });
  auto& sums = kind.id == Id::node   ? draft.general_sets
               : kind.id == Id::part ? draft.part_sums
               : kind.scope == 0     ? draft.solid_sums
                                     : draft.shell_sums;
  sums.push_back(std::move(set));
}
/// An option of *SET_NODE_GENERAL, and the same with D before it, which takes nodes out again.
struct GeneralOption {
  std::string_view name;
  Named named;
  Id id;
};
inline constexpr std::array<GeneralOption, 4> general_options{{{"ALL", Named::all, Id::other},
                                                               {"NODE", Named::node, Id::node},
                                                               {"PART", Named::part, Id::part},
                                                               {"BOX", Named::box, Id::define}}};
inline void general_node_set(File& file, Draft& draft) {
  PendingSet set = pending_set(file, draft, node_sets.name);
  file.for_each_card([&](Card card) {
    const std::string option = upper(card.text());
    const bool removes = option.starts_with('D');
    const auto known = std::find_if(general_options.begin(), general_options.end(), [&](const GeneralOption& general) {
      return general.name == std::string_view(option).substr(removes ? 1 : 0);
    });
    if (known == general_options.end() || (removes && known->named == Named::all))
      file.refuse({"the option ", shown(option), " of ", file.name(),
                   " is not read: give ALL, NODE, DNODE, PART, DPART, BOX or DBOX."});
    if (known->named == Named::all) {
      set.choices.push_back({Named::all, 0, file.line()});
      return;
    }
    for (int field = 0; field < 7; ++field)
      if (const FileNumber number = card.tag("a number of the set", known->id); number != 0)
        set.choices.push_back({known->named, number, file.line(), removes});
    file.ignore_rest(card);
  });
  draft.general_sets.push_back(std::move(set));
}
inline void box(File& file, Draft& draft) {
  file.title();
  Card card = file.card();
  Box& box = draft.boxes[draft.own_number("box", Id::define, card, file)];
  for (Eigen::Index i = 0; i < 3; ++i) box.least[i] = card.number("a bound"), box.most[i] = card.number("a bound");
}
/// Three or four corners. Errors: fewer, or more.
inline PendingSegments::Segment segment_of(Card& card, const File& file) {
  std::array<FileNumber, 4> corners;
  for (FileNumber& corner : corners) corner = card.tag("a corner", Id::node);
  if (corners[3] == 0) corners[3] = corners[2];
  if (corners[0] == 0 || corners[1] == 0 || corners[2] == 0)
    file.refuse({"a segment has fewer than three corners: give it three or four nodes."});
  return {corners, file.line()};
}
inline void segment_set(File& file, Draft& draft) {
  std::string name = file.title();
  Card head = file.card();
  PendingSegments set{draft.own_number("set of segments", Id::set, head, file), std::move(name), {}};
  tell_attributes(head, file);
  file.for_each_card([&](Card card) {
    set.segments.push_back(segment_of(card, file));
    file.ignore_rest(card);
  });
  draft.segment_sets.push_back(std::move(set));
}

inline constexpr Meaning of_node_sets{"`node_sets`, of sets before and after too", "nodes of other cards",
                                      "DA1 to DA4"};
inline constexpr Meaning of_general_sets{"`node_sets`, of ALL, NODE, PART, BOX and the same with D",
                                         "nodes of other cards", "DA1 to DA4; other options, which are refused"};
inline constexpr Meaning of_cell_sets{"`cell_sets`, of sets before and after too", "cells of other cards",
                                      "DA1 to DA4"};
inline constexpr Meaning of_part_sets{"`part_sets`, of sets before and after too", "parts of other cards",
                                      "DA1 to DA4"};
inline constexpr Meaning of_segment_sets{"`segment_sets`", "faces of other cards", "DA1 to DA4; A1 to A4 of a segment"};
inline constexpr Meaning of_boxes{"nodes of `*SET_NODE_GENERAL`", "the same", "nothing"};
inline constexpr auto set_keywords = std::to_array<Keyword>({
    {"*SET_NODE", set<node_sets>, Invariant::everywhere, &of_node_sets},
    {"*SET_NODE_LIST", set<node_sets>, Invariant::everywhere, &of_node_sets},
    {"*SET_NODE_LIST_GENERATE", set<node_sets, Listed::in_ranges>, Invariant::everywhere, &of_node_sets},
    {"*SET_NODE_LIST_GENERATE_INCREMENT", set<node_sets, Listed::in_steps>, Invariant::everywhere, &of_node_sets},
    {"*SET_NODE_ADD", sum_of_sets<node_sets>, Invariant::everywhere, &of_node_sets},
    {"*SET_NODE_GENERAL", general_node_set, Invariant::everywhere, &of_general_sets},
    {"*SET_SOLID", set<solid_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SOLID_LIST", set<solid_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SOLID_GENERATE", set<solid_sets, Listed::in_ranges>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SOLID_LIST_GENERATE", set<solid_sets, Listed::in_ranges>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SOLID_ADD", sum_of_sets<solid_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SHELL", set<shell_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SHELL_LIST", set<shell_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SHELL_LIST_GENERATE", set<shell_sets, Listed::in_ranges>, Invariant::everywhere, &of_cell_sets},
    {"*SET_SHELL_ADD", sum_of_sets<shell_sets>, Invariant::everywhere, &of_cell_sets},
    {"*SET_PART", set<part_sets>, Invariant::everywhere, &of_part_sets},
    {"*SET_PART_LIST", set<part_sets>, Invariant::everywhere, &of_part_sets},
    {"*SET_PART_LIST_GENERATE", set<part_sets, Listed::in_ranges>, Invariant::everywhere, &of_part_sets},
    {"*SET_PART_LIST_GENERATE_INCREMENT", set<part_sets, Listed::in_steps>, Invariant::everywhere, &of_part_sets},
    {"*SET_PART_ADD", sum_of_sets<part_sets>, Invariant::everywhere, &of_part_sets},
    {"*SET_SEGMENT", segment_set, Invariant::everywhere, &of_segment_sets},
    {"*DEFINE_BOX", box, Invariant::none, &of_boxes},
});

}  // namespace strike::detail::dyna
