#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/ascending.hpp>
#include <strike/input/abaqus/file.hpp>
#include <strike/input/abaqus_cards.hpp>
#include <strike/input/raw_mesh.hpp>

namespace strike::detail::abaqus {

/// Sets of nodes or of elements by name.
using SetPlaces = std::map<std::string, std::size_t>;

/// A set that was named before it was defined, and whose set names it.
struct LateName {
  bool of_nodes;
  std::size_t set;
  std::string prefix, name, shown_name;
  std::uint32_t line;
};
/// A set of the nodes of a set of elements.
struct NodesOfElements {
  std::string set, prefix, elements, shown_elements;
  std::uint32_t line;
};
/// Elements of a type that is not read.
struct LeftOut {
  std::string type;
  std::size_t count;
  std::uint32_t line;
};

/// *SOLID SECTION or *SHELL SECTION.
struct PendingSection {
  std::string set, material;
  SectionCard section;
  std::uint32_t line;
};
/// A line of *SURFACE: elements and their face, or nodes.
struct SurfaceLine {
  std::string where, face;
  std::uint32_t line;
};
struct PendingSurface {
  std::string name;
  bool is_of_nodes;
  std::vector<SurfaceLine> lines;
  std::vector<std::array<FileNumber, 4>> segments;  ///< by the numbers of the file
  std::uint32_t line;
};

/// A part, or everything outside of parts, with its sets by name.
struct Model {
  RawMesh raw = {};
  SetPlaces node_sets = {}, element_sets = {};
  std::vector<LateName> late = {};
  std::vector<NodesOfElements> nodes_of_elements = {};
  std::set<std::string> unsorted = {};  ///< sets of nodes in an order of their own
  std::vector<LeftOut> left_out = {};
  std::vector<PendingSection> sections = {};
  std::vector<PendingSurface> surfaces = {};
  std::uint32_t group = nothing;  ///< of the elements that are in no instance
  std::string name = {};
  std::uint32_t line = 0;
  bool is_placed = false;

  /// Places of the nodes and of the elements by number, so far.
  const std::map<FileNumber, Index>& node_places() { return places(raw.nodes, nodes_, nodes_seen_); }
  const std::map<FileNumber, Index>& element_places() { return places(raw.elements, elements_, elements_seen_); }

 private:
  template <class List>
  static const std::map<FileNumber, Index>& places(const List& list, std::map<FileNumber, Index>& known,
                                                   std::size_t& seen) {
    for (; seen < list.size(); ++seen) known.insert_or_assign(list[seen].number, static_cast<Index>(seen));
    return known;
  }

  std::map<FileNumber, Index> nodes_ = {}, elements_ = {};
  std::size_t nodes_seen_ = 0, elements_seen_ = 0;
};

/// The set of that name, a new one if there is none.
inline RawMesh::Set& set_of(std::vector<RawMesh::Set>& sets, SetPlaces& places, const std::string& name,
                            std::uint32_t line) {
  const auto [place, is_new] = places.try_emplace(label(name), sets.size());
  if (is_new) sets.push_back({.name = name, .line = line});
  sets[place->second].is_listed = true;
  return sets[place->second];
}

/// The numbers of a set that are known, in ascending order.
inline std::vector<FileNumber> members(const std::vector<RawMesh::Set>& sets, std::size_t first,
                                       const std::map<FileNumber, Index>& known, Allowance& allowance,
                                       std::uint32_t line) {
  std::vector<std::size_t> open{first};
  std::set<std::size_t> seen{first};
  std::vector<FileNumber> all;
  while (!open.empty()) {
    const RawMesh::Set& set = sets[open.back()];
    open.pop_back();
    allowance.take(1 + set.sequences.size(), line);
    for (const std::size_t other : set.others)
      if (seen.insert(other).second) open.push_back(other);
    for (const auto& [from, last, step, at] : set.sequences) {
      if (from == last) {
        if (known.contains(from)) all.push_back(from);
        continue;
      }
      for (auto next = known.lower_bound(from); next != known.end() && next->first <= last; ++next) {
        allowance.take(1, line);
        if ((next->first - from) % step == 0) all.push_back(next->first);
      }
    }
  }
  return ascending(std::move(all));
}

/// Reorders sets so that each stands after those that it names. Error: a set that holds itself.
inline void put_in_order(std::vector<RawMesh::Set>& sets, SetPlaces& places, const File& file) {
  enum class Visit : char { none, open, done };
  std::vector<Visit> visits(sets.size(), Visit::none);
  std::vector<std::size_t> order, place(sets.size());
  std::vector<std::pair<std::size_t, std::size_t>> path;  // a set, and the next of those that it names
  for (std::size_t root = 0; root < sets.size(); ++root) {
    if (visits[root] != Visit::none) continue;
    path.push_back({root, 0});
    visits[root] = Visit::open;
    while (!path.empty()) {
      auto& [set, next] = path.back();
      if (next == sets[set].others.size()) {
        visits[set] = Visit::done, place[set] = order.size(), order.push_back(set);
        path.pop_back();
        continue;
      }
      const std::size_t other = sets[set].others[next++];
      if (visits[other] == Visit::open)
        file.refuse(sets[set].line, {"set '", sets[set].name, "' holds itself by way of others: take it out of one."});
      if (visits[other] == Visit::none) visits[other] = Visit::open, path.push_back({other, 0});
    }
  }
  std::vector<RawMesh::Set> ordered;
  ordered.reserve(sets.size());
  for (const std::size_t set : order) {
    ordered.push_back(std::move(sets[set]));
    for (std::size_t& other : ordered.back().others) other = place[other];
  }
  sets = std::move(ordered);
  for (auto& [name, set] : places) set = place[set];
}

/// Finds the sets that were named before they were defined, and the nodes of elements. Error: there is no such set.
inline void resolve_names(Model& model, const File& file, Allowance& allowance) {
  for (const LateName& late : model.late) {
    auto& sets = late.of_nodes ? model.raw.node_sets : model.raw.element_sets;
    const auto& places = late.of_nodes ? model.node_sets : model.element_sets;
    const auto other = places.find(late.prefix + late.name);
    if (other == places.end())
      file.refuse(late.line, {"set '", sets[late.set].name, "' holds ", shown(late.shown_name),
                              ", which is neither a number nor a set of the file: define that set."});
    if (other->second != late.set) sets[late.set].others.push_back(other->second);
  }
  if (!model.late.empty()) {
    put_in_order(model.raw.node_sets, model.node_sets, file);
    put_in_order(model.raw.element_sets, model.element_sets, file);
  }
  model.late.clear();

  for (const NodesOfElements& wanted : model.nodes_of_elements) {
    const auto found = model.element_sets.find(wanted.prefix + wanted.elements);
    if (found == model.element_sets.end())
      file.refuse(wanted.line,
                  {"the set of elements ", shown(wanted.shown_elements), " is not in the file: define it."});
    const std::size_t set = model.node_sets.at(wanted.set);
    const auto& known = model.element_places();
    for (const FileNumber number : members(model.raw.element_sets, found->second, known, allowance, wanted.line)) {
      const RawMesh::Element& element = model.raw.elements[known.at(number)];
      allowance.take(corner_count(element.shape), wanted.line);
      for (std::size_t i = 0; i < corner_count(element.shape); ++i)
        model.raw.node_sets[set].sequences.push_back({element.corners[i], element.corners[i], 1, wanted.line});
      allowance.take(mid_nodes(element.second).size(), wanted.line);
      for (const FileNumber mid : model.raw.mids_of(element))
        model.raw.node_sets[set].sequences.push_back({mid, mid, 1, wanted.line});
    }
  }
  model.nodes_of_elements.clear();
}

}  // namespace strike::detail::abaqus
