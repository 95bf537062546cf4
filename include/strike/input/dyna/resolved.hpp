#pragma once
#include <array>
#include <map>
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
  Lookup(const Finished& mesh, const DynaDeck& deck, const std::map<FileNumber, std::uint32_t>& parts,
         const Source& source)
      : mesh_(mesh), deck_(deck), parts_(parts), source_(source) {
    for (const NamedSet& set : deck.node_sets) node_sets_.try_emplace(set.number, &set);
    for (const NamedSet& set : deck.part_sets) part_sets_.try_emplace(set.number, &set);
  }

  /// The chosen nodes by their numbers in the mesh, in ascending order.
  std::vector<Index> nodes(std::span<const Choice> choices) const {
    std::vector<Index> nodes;
    const auto add = [&](const std::vector<Index>& more) { nodes.insert(nodes.end(), more.begin(), more.end()); };
    for (const Choice& choice : choices) switch (choice.named) {
        case Named::all:
          add(all_nodes(deck_.mesh.nodes));
          break;
        case Named::node:
          if (const Index n = mesh_.node(choice.number, source_, choice.line); n != nothing) nodes.push_back(n);
          break;
        case Named::set:
          add(found(node_sets_, choice, "the set of nodes")->members);
          break;
        default:
          for (const Index part : parts(choice)) add(deck_.cells(deck_.parts[part].members).nodes());
      }
    return ascending(std::move(nodes));
  }
  /// The places of a part, or of the parts of a set.
  std::vector<Index> parts(const Choice& choice) const {
    if (choice.named == Named::part) return {found(parts_, choice, "part")};
    return found(part_sets_, choice, "the set of parts")->members;
  }

 private:
  template <class Value>
  Value found(const std::map<FileNumber, Value>& things, const Choice& choice, const char* kind) const {
    const auto thing = things.find(choice.number);
    if (thing == things.end())
      source_.refuse(choice.line,
                     {kind, " ", std::to_string(choice.number), " is not in the file: define it or correct the card."});
    return thing->second;
  }

  const Finished& mesh_;
  const DynaDeck& deck_;
  const std::map<FileNumber, std::uint32_t>& parts_;
  const Source& source_;
  std::map<FileNumber, const NamedSet*> node_sets_ = {}, part_sets_ = {};
};

inline std::vector<NamedSet> part_sets(Draft& draft, const Source& source) {
  std::vector<NamedSet> all;
  for (RawMesh::Set& set : draft.part_sets) {
    NamedSet named{set.number, std::move(set.name), {}};
    for (const RawMesh::Sequence& numbers : set.sequences) {
      const auto part = draft.parts.find(numbers.first);
      if (part == draft.parts.end())
        source.refuse(numbers.line,
                      {"part ", std::to_string(numbers.first), " is not in the file: take it off the set."});
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
  deck.part_sets = part_sets(draft, file.source());

  const Lookup lookup(mesh, deck, draft.parts, file.source());
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
