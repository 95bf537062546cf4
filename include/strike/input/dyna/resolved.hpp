#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/input/dyna/blasts.hpp>
#include <strike/input/dyna/definitions.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/hardening.hpp>
#include <strike/input/dyna/lookup.hpp>
#include <strike/input/dyna/resolved_loads.hpp>
#include <strike/input/dyna/sets.hpp>
#include <strike/input/dyna/transformations.hpp>
#include <strike/input/raw_mesh.hpp>

namespace strike::detail::dyna {

/// An order in which each set comes after those that it names. Error: a set that contains itself.
inline std::vector<std::size_t> in_order(const std::vector<PendingSet>& sets, Named named, const Source& source) {
  std::map<FileNumber, std::size_t> places;
  for (std::size_t i = 0; i < sets.size(); ++i) places.try_emplace(sets[i].number, i);
  enum class State : char { unseen, open, done };
  std::vector<State> states(sets.size(), State::unseen);
  std::vector<std::size_t> order;
  struct Visit {
    std::size_t set, next;
  };
  std::vector<Visit> open;
  for (std::size_t root = 0; root < sets.size(); ++root) {
    if (states[root] != State::unseen) continue;
    open.push_back({root, 0});
    states[root] = State::open;
    while (!open.empty()) {
      auto& [set, next] = open.back();
      if (next == sets[set].choices.size()) {
        states[set] = State::done;
        order.push_back(set);
        open.pop_back();
        continue;
      }
      const Choice& choice = sets[set].choices[next++];
      const auto other = choice.named == named ? places.find(choice.number) : places.end();
      if (other == places.end() || states[other->second] == State::done) continue;
      if (states[other->second] == State::open)
        source.refuse(choice.line, {"set ", std::to_string(choice.number),
                                    " contains itself: take it out of one of "
                                    "the sets that it is made of."});
      states[other->second] = State::open;
      open.push_back({other->second, 0});
    }
  }
  return order;
}

/// The sets of parts, and those made of them.
inline std::vector<NamedSet> resolved_part_sets(Draft& draft, const File& file, Allowance& allowance) {
  std::vector<NamedSet> all;
  std::map<FileNumber, std::size_t> places;
  for (RawMesh::Set& set : draft.part_sets) {
    NamedSet named{set.number, std::move(set.name), {}};
    for (const RawMesh::Sequence& numbers : set.sequences) {
      if (numbers.first == numbers.last && !draft.parts.contains(numbers.first))
        file.source().refuse(numbers.line,
                             {"part ", std::to_string(numbers.first), " is not in the file: take it off the set."});
    }
    for (const RawMesh::Sequence& numbers : merged(std::move(set.sequences)))
      for (auto part = draft.parts.lower_bound(numbers.first); part != draft.parts.end() && part->first <= numbers.last;
           ++part) {
        allowance.take(1, numbers.line);
        if ((part->first - numbers.first) % numbers.step == 0) named.members.push_back(part->second);
      }
    named.members = ascending(std::move(named.members));
    places.try_emplace(named.number, all.size());
    all.push_back(std::move(named));
  }
  for (const std::size_t i : in_order(draft.part_sums, Named::part_set, file.source())) {
    NamedSet sum{draft.part_sums[i].number, std::move(draft.part_sums[i].name), {}};
    for (const Choice& choice : draft.part_sums[i].choices) {
      const auto other = places.find(choice.number);
      if (other == places.end()) refuse_missing(file, choice, "the set of parts", "*SET_PART");
      const std::vector<Index>& members = all[other->second].members;
      allowance.take(members.size(), choice.line);
      sum.members.insert(sum.members.end(), members.begin(), members.end());
    }
    sum.members = ascending(std::move(sum.members));
    places.try_emplace(sum.number, all.size());
    all.push_back(std::move(sum));
  }
  return all;
}
/// Sets of cells that are made of others, after these.
inline void add_cell_sums(Draft& draft, const File& file) {
  for (const FileNumber scope : {FileNumber(0), shells}) {
    std::vector<PendingSet>& sums = scope == 0 ? draft.solid_sums : draft.shell_sums;
    const std::string_view kind = scope == 0 ? solid_sets.name : shell_sets.name;
    for (const std::size_t i : in_order(sums, Named::set, file.source())) {
      RawMesh::Set sum{.number = sums[i].number, .name = std::move(sums[i].name), .line = sums[i].line};
      for (const Choice& choice : sums[i].choices) {
        const auto other = draft.set_places.find({kind, choice.number});
        if (other == draft.set_places.end())
          refuse_missing(file, choice, scope == 0 ? "the set of solids" : "the set of shells",
                         scope == 0 ? "*SET_SOLID" : "*SET_SHELL");
        sum.others.push_back(other->second);
      }
      draft.set_places.try_emplace({kind, sum.number}, draft.raw.element_sets.size());
      draft.raw.element_sets.push_back(std::move(sum));
    }
  }
}
/// The values of plates by their numbers in the mesh.
inline std::vector<ShellCard> resolved_shells(const Draft& draft, const Deck& deck) {
  if (draft.shells.empty()) return {};
  const std::size_t first = deck.mesh.hexahedra.size() + deck.mesh.tetrahedra.size();
  const Numbering plates({deck.cell_numbers.begin() + static_cast<std::ptrdiff_t>(first), deck.cell_numbers.end()});
  std::vector<ShellCard> all;
  for (const auto& [number, card] : draft.shells)
    if (const Index place = plates.find(number); place != nothing) {
      all.push_back(card);
      all.back().cell = static_cast<Index>(first + place);
    }
  std::sort(all.begin(), all.end(), [](const ShellCard& a, const ShellCard& b) { return a.cell < b.cell; });
  return all;
}
inline std::vector<SegmentSet> resolved_segments(Draft& draft, Finished& mesh, const File& file,
                                                 std::vector<std::string>& warnings) {
  std::vector<SegmentSet> all;
  for (PendingSegments& set : draft.segment_sets) {
    SegmentSet named{set.number, std::move(set.name), {}};
    std::size_t lost = 0;
    for (const auto& [corners, line] : set.segments) {
      std::array<Index, 4> segment;
      for (std::size_t i = 0; i < 4; ++i) segment[i] = mesh.node(corners[i], file.source(), line);
      if (std::find(segment.begin(), segment.end(), nothing) == segment.end())
        mesh.cut_faces.add_segment(segment, named.segments);
      else
        ++lost;
    }
    if (lost > 0)
      warnings.push_back(joined({"Segments (", std::to_string(lost), ") of set ", std::to_string(set.number),
                                 " lie on nodes without an element and were dropped."}));
    all.push_back(std::move(named));
  }
  return all;
}

/// Names the parts, nodes or faces of the side, by SSTYP or MSTYP.
inline void resolve_side(ContactSide& side, const Side& given, const char* type, std::uint32_t line,
                         const Lookup& lookup, const DynaDeck& deck, File& file) {
  if (given.number == 0 || given.kind == 5) return;
  const auto number = [&](Index part) { return deck.parts[part].number; };
  switch (given.kind) {
    case 0:
      side.segments = lookup.segments({Named::all, given.number, line});
      break;
    case 1:
      lookup.add_faces({Named::shell_set, given.number, line}, side.segments);
      break;
    case 2:
    case 3:
      for (const Index part : lookup.parts({given.kind == 2 ? Named::part_set : Named::part, given.number, line}))
        side.parts.push_back(number(part));
      break;
    case 4:
      side.nodes = lookup.nodes(std::array{Choice{Named::set, given.number, line}});
      break;
    case 6: {
      const std::vector<Index> exempt = lookup.parts({Named::part_set, given.number, line});
      for (Index part = 0; part < deck.parts.size(); ++part)
        if (!std::binary_search(exempt.begin(), exempt.end(), part)) side.parts.push_back(number(part));
      if (side.parts.empty())
        file.source().refuse(line, {"a contact exempts all parts: take some out of its set, or the contact."});
      break;
    }
    default:
      file.ignore_on_line(line, joined({type, " ", std::to_string(given.kind), " of a contact (all parts are taken)"}));
  }
}

/// The deck. Errors: those of the mesh; a card names a node, set or part that is not there.
inline DynaDeck resolved(Draft draft, File& file) {
  expect_closed_table(draft, file);
  move_nodes(draft, file);
  place_by_nodes(draft, file);
  add_cell_sums(draft, file);
  draft.raw.repeats_nodes = true;
  Finished mesh = finished(std::move(draft.raw), file.source());
  DynaDeck& deck = draft.deck;
  mesh.deck.title = std::move(deck.title);
  static_cast<Deck&>(deck) = std::move(mesh.deck);
  deck.part_sets = resolved_part_sets(draft, file, mesh.allowance);
  deck.shells = resolved_shells(draft, deck);
  complete_materials(draft, file, mesh.allowance);
  complete_equations_of_state(draft, file, mesh.allowance);
  deck.segment_sets = resolved_segments(draft, mesh, file, deck.warnings);

  deck.node_sets.reserve(deck.node_sets.size() + draft.general_sets.size());  // lookup points to them
  Lookup lookup(mesh, deck, draft, file);
  for (const std::size_t i : in_order(draft.general_sets, Named::set, file.source())) {
    PendingSet& set = draft.general_sets[i];
    deck.node_sets.push_back({set.number, std::move(set.name), lookup.nodes(set.choices)});
    lookup.add(deck.node_sets.back());
  }
  const auto add = [&](auto& cards, auto& pending) {
    for (auto& one : pending) {
      if constexpr (std::is_same_v<decltype(one.card), SupportCard>)
        if (one.system != 0) one.card.system = lookup.axes({Named::all, one.system, one.choices.front().line});
      one.card.nodes = lookup.nodes(one.choices);
      cards.push_back(std::move(one.card));
    }
  };
  add(deck.supports, draft.node_supports), add(deck.supports, draft.set_supports);
  add(deck.velocities, draft.velocities);
  resolve_controls(draft, lookup, deck);
  resolve_walls(draft, lookup, deck, file);
  resolve_bodies(draft, lookup, deck);
  resolve_blasts(draft, lookup, deck, file);
  resolve_loads(draft, lookup, deck, file);
  for (auto& [contact, slave, master, line] : draft.contacts) {
    resolve_side(contact.slave, slave, "SSTYP", line, lookup, deck, file);
    resolve_side(contact.master, master, "MSTYP", line, lookup, deck, file);
    deck.contacts.push_back(std::move(contact));
  }
  for (const auto& [material, system, line] : draft.rigid_systems)
    std::get<RigidMaterial>(deck.materials[material].material).system = lookup.axes({Named::all, system, line});
  file.tell(deck.warnings);
  return std::move(deck);
}

}  // namespace strike::detail::dyna
