#pragma once
#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/mesh/select.hpp>

namespace strike::detail::dyna {

/// Nodes and parts that cards name, in a deck that is complete but for them.
class Lookup {
 public:
  Lookup(Finished& mesh, const DynaDeck& deck, const std::map<FileNumber, std::uint32_t>& parts, const File& file)
      : mesh_(mesh), deck_(deck), parts_(parts), file_(file) {
    for (const NamedSet& set : deck.node_sets) add(set);
    for (const NamedSet& set : deck.part_sets) part_sets_.try_emplace(set.number, &set);
  }
  void add(const NamedSet& node_set) { node_sets_.try_emplace(node_set.number, &node_set); }

  /// The chosen nodes by their numbers in the mesh, in ascending order.
  std::vector<Index> nodes(std::span<const Choice> choices) const {
    std::vector<Index> nodes;
    const auto add = [&](const std::vector<Index>& more, std::uint32_t line) {
      mesh_.allowance.take(more.size(), line);
      nodes.insert(nodes.end(), more.begin(), more.end());
    };
    std::set<std::pair<Named, FileNumber>> seen;
    for (const Choice& choice : choices) {
      if (choice.named != Named::node && !seen.emplace(choice.named, choice.number).second) continue;
      switch (choice.named) {
        case Named::all:
          add(all_nodes(deck_.mesh.nodes), choice.line);
          break;
        case Named::node:
          if (const Index n = mesh_.node(choice.number, file_.source(), choice.line); n != nothing) nodes.push_back(n);
          break;
        case Named::set:
          add(found(node_sets_, choice, "the set of nodes", "*SET_NODE")->members, choice.line);
          break;
        default:
          for (const Index part : parts(choice)) {
            const std::vector<Index>& cells = deck_.parts[part].members;
            mesh_.allowance.take(8 * cells.size(), choice.line);
            add(deck_.cells(cells).nodes(), choice.line);
          }
      }
    }
    return ascending(std::move(nodes));
  }
  /// The places of a part, or of the parts of a set.
  std::vector<Index> parts(const Choice& choice) const {
    if (choice.named == Named::part) return {found(parts_, choice, "part", "*PART")};
    const std::vector<Index>& members = found(part_sets_, choice, "the set of parts", "*SET_PART")->members;
    mesh_.allowance.take(members.size(), choice.line);
    return members;
  }

 private:
  template <class Value>
  Value found(const std::map<FileNumber, Value>& things, const Choice& choice, const char* kind,
              const char* keyword) const {
    const auto thing = things.find(choice.number);
    if (thing != things.end()) return thing->second;
    const std::string skipped = file_.skipped(keyword);
    file_.source().refuse(
        choice.line, {kind, " ", std::to_string(choice.number),
                      skipped.empty() ? " is not in the file" : " is not among those read (", skipped,
                      skipped.empty() ? "" : " was skipped)", ": define it before this card or correct the card."});
  }

  Finished& mesh_;
  const DynaDeck& deck_;
  const std::map<FileNumber, std::uint32_t>& parts_;
  const File& file_;
  std::map<FileNumber, const NamedSet*> node_sets_ = {}, part_sets_ = {};
};

inline std::vector<NamedSet> part_sets(Draft& draft, const Source& source, Allowance& allowance) {
  std::vector<NamedSet> all;
  for (RawMesh::Set& set : draft.part_sets) {
    NamedSet named{set.number, std::move(set.name), {}};
    for (const RawMesh::Sequence& numbers : set.sequences) {
      if (numbers.first == numbers.last && !draft.parts.contains(numbers.first))
        source.refuse(numbers.line,
                      {"part ", std::to_string(numbers.first), " is not in the file: take it off the set."});
    }
    for (const RawMesh::Sequence& numbers : merged(std::move(set.sequences)))
      for (auto part = draft.parts.lower_bound(numbers.first); part != draft.parts.end() && part->first <= numbers.last;
           ++part) {
        allowance.take(1, numbers.line);
        named.members.push_back(part->second);
      }
    all.push_back(std::move(named));
  }
  return all;
}

inline ContactSide contact_side(const Side& side, const char* type, std::uint32_t line, const Lookup& lookup,
                                const DynaDeck& deck, File& file) {
  ContactSide result;
  if (side.number == 0 || side.kind == 5) return result;
  if (side.kind == 4)
    result.nodes = lookup.nodes(std::array{Choice{Named::set, side.number, line}});
  else if (side.kind == 2 || side.kind == 3)
    for (const Index part : lookup.parts({side.kind == 2 ? Named::part_set : Named::part, side.number, line}))
      result.parts.push_back(deck.parts[part].number);
  else
    file.ignore_on_line(line, joined({type, " ", std::to_string(side.kind), " of a contact (all parts are taken)"}));
  return result;
}

/// The deck. Errors: those of the mesh; a card names a node, set or part that is not there.
inline DynaDeck resolved(Draft draft, File& file) {
  Finished mesh = finished(std::move(draft.raw), file.source());
  DynaDeck& deck = draft.deck;
  mesh.deck.title = std::move(deck.title);
  static_cast<Deck&>(deck) = std::move(mesh.deck);
  deck.part_sets = part_sets(draft, file.source(), mesh.allowance);

  deck.node_sets.reserve(deck.node_sets.size() + draft.general_sets.size());  // lookup points to them
  Lookup lookup(mesh, deck, draft.parts, file);
  for (PendingSet& set : draft.general_sets) {
    deck.node_sets.push_back({set.number, std::move(set.name), lookup.nodes(set.choices)});
    lookup.add(deck.node_sets.back());
  }
  const auto add = [&](auto& cards, auto& pending) {
    for (auto& [card, choices] : pending) {
      card.nodes = lookup.nodes(choices);
      cards.push_back(std::move(card));
    }
  };
  add(deck.supports, draft.node_supports), add(deck.supports, draft.set_supports);
  add(deck.velocities, draft.velocities), add(deck.walls, draft.walls);
  for (auto& [contact, slave, master, line] : draft.contacts) {
    contact.slave = contact_side(slave, "SSTYP", line, lookup, deck, file);
    contact.master = contact_side(master, "MSTYP", line, lookup, deck, file);
    deck.contacts.push_back(std::move(contact));
  }
  file.tell(deck.warnings);
  return std::move(deck);
}

}  // namespace strike::detail::dyna
