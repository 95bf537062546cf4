#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/error.hpp>
#include <strike/input/source.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike {

/// The cells of a part, ready for `Part{element, material, cells}`.
struct PartCells {
  Cells<8> hexahedra = {};
  Cells<4> tetrahedra = {};
  Cells<4> quadrilaterals = {};
  Cells<3> triangles = {};

  /// Numbers of their nodes, in ascending order.
  std::vector<Index> nodes() const {
    std::vector<Index> all;
    const auto add = [&](const auto& cells) {
      for (const auto& cell : cells) all.insert(all.end(), cell.begin(), cell.end());
    };
    add(hexahedra), add(tetrahedra), add(quadrilaterals), add(triangles);
    return detail::ascending(std::move(all));
  }
};

/// Nodes or cells under a name, a number or both.
struct NamedSet {
  FileNumber number = 0;  ///< 0 if the file gives a name alone
  std::string name = {};
  std::vector<Index> members = {};  ///< in ascending order
};

/// The mesh of a file, in the file's units. Cells are numbered hexahedra first, then tetrahedra, then quadrilaterals,
/// then triangles. Parts and sets are found by name, or by their number in the file.
struct Deck {
  std::string title = {};
  Mesh mesh = {};
  std::vector<FileNumber> node_numbers = {};  ///< of each node of the mesh, that in the file
  std::vector<FileNumber> cell_numbers = {};  ///< of each cell of the mesh, that in the file
  std::vector<NamedSet> parts = {};           ///< of cells
  std::vector<NamedSet> cell_sets = {};
  std::vector<NamedSet> node_sets = {};
  std::vector<std::string> warnings = {};  ///< a sentence for each kind of input skipped, dropped or ignored

  /// The cells of a part or, if no part has that name, of a set of cells. Error: neither is there.
  PartCells part(std::string_view name) const {
    for (const auto* sets : {&parts, &cell_sets})
      if (const NamedSet* set = find(*sets, name)) return cells(set->members);
    throw Error(detail::joined({"strike: no part is called '", name, "': ", choice_of(parts)}));
  }
  PartCells part(FileNumber number) const {
    if (const NamedSet* set = find(parts, number)) return cells(set->members);
    throw Error(detail::joined({"strike: no part has the number ", std::to_string(number), ": ", choice_of(parts)}));
  }
  /// The mesh of those parts alone, with all nodes. Error: a part is not there.
  Mesh cells_of(const std::vector<FileNumber>& numbers) const {
    Mesh all{mesh.nodes};
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    for (const FileNumber number : numbers) {
      const PartCells cells = part(number);
      add(all.hexahedra, cells.hexahedra), add(all.tetrahedra, cells.tetrahedra);
      add(all.quadrilaterals, cells.quadrilaterals), add(all.triangles, cells.triangles);
    }
    return all;
  }
  /// The nodes of a set. Error: it is not there.
  const std::vector<Index>& nodes(std::string_view name) const {
    if (const NamedSet* set = find(node_sets, name)) return set->members;
    throw Error(detail::joined({"strike: no set of nodes is called '", name, "': ", choice_of(node_sets)}));
  }
  const std::vector<Index>& nodes(FileNumber number) const {
    if (const NamedSet* set = find(node_sets, number)) return set->members;
    throw Error(detail::joined(
        {"strike: no set of nodes has the number ", std::to_string(number), ": ", choice_of(node_sets)}));
  }
  /// The cells with these numbers in the mesh, all counted together.
  PartCells cells(std::span<const Index> numbers) const {
    PartCells chosen;
    const std::size_t tetrahedra = mesh.hexahedra.size(), quadrilaterals = tetrahedra + mesh.tetrahedra.size(),
                      triangles = quadrilaterals + mesh.quadrilaterals.size();
    for (const Index e : numbers)
      if (e < tetrahedra)
        chosen.hexahedra.push_back(mesh.hexahedra[e]);
      else if (e < quadrilaterals)
        chosen.tetrahedra.push_back(mesh.tetrahedra[e - tetrahedra]);
      else if (e < triangles)
        chosen.quadrilaterals.push_back(mesh.quadrilaterals[e - quadrilaterals]);
      else
        chosen.triangles.push_back(mesh.triangles.at(e - triangles));
    return chosen;
  }

 protected:
  static const NamedSet* find(const std::vector<NamedSet>& sets, std::string_view name) {
    return only(sets, [&](const NamedSet& set) { return set.name == name; });
  }
  static const NamedSet* find(const std::vector<NamedSet>& sets, FileNumber number) {
    return only(sets, [&](const NamedSet& set) { return set.number == number; });
  }
  template <class Predicate>
  static const NamedSet* only(const std::vector<NamedSet>& sets, Predicate is_it) {
    const auto set = std::find_if(sets.begin(), sets.end(), is_it);
    if (set == sets.end()) return nullptr;
    if (const auto other = std::find_if(set + 1, sets.end(), is_it); other != sets.end())
      throw Error(detail::joined({"strike: the name or number names both ", std::to_string(set->number), " '",
                                  set->name, "' and ", std::to_string(other->number), " '", other->name,
                                  "': give the one that tells them apart."}));
    return &*set;
  }
  /// Advice in place of a name or a number that is not there.
  static std::string choice_of(const std::vector<NamedSet>& sets) {
    if (sets.empty()) return "the deck has none.";
    std::string all = sets.size() == 1 ? "give " : "give one of ";
    const auto first = std::span(sets).first(std::min<std::size_t>(sets.size(), 10));
    for (const NamedSet& set : first) {
      if (&set != first.data()) all += ", ";
      all += set.name.empty() ? std::to_string(set.number) : detail::joined({"'", set.name, "'"});
    }
    return all + (sets.size() > first.size() ? ", ..." : ".");
  }
};

}  // namespace strike
