#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/ascending.hpp>
#include <strike/input/deck.hpp>
#include <strike/input/source.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

inline constexpr Index nothing = std::numeric_limits<Index>::max();

/// Places of nodes, elements or parts by their numbers: a table if the numbers are close together, else a sorted list.
class Numbering {
 public:
  Numbering() = default;
  explicit Numbering(std::vector<FileNumber> numbers) : numbers_(std::move(numbers)) {
    if (numbers_.empty()) return;
    const auto [least, most] = std::minmax_element(numbers_.begin(), numbers_.end());
    first_ = *least, last_ = *most;
    if (static_cast<std::uint64_t>(last_ - first_) < 4 * std::uint64_t(numbers_.size()) + 1024) {
      table_.assign(static_cast<std::size_t>(last_ - first_) + 1, nothing);
      for (Index i = 0; i < numbers_.size(); ++i) {
        Index& place = table_[static_cast<std::size_t>(numbers_[i] - first_)];
        if (place == nothing)
          place = i;
        else if (twice_ == nothing)
          twice_ = i;
      }
    } else {
      for (Index i = 0; i < numbers_.size(); ++i) sorted_.emplace_back(numbers_[i], i);
      std::sort(sorted_.begin(), sorted_.end());
      for (std::size_t i = 1; i < sorted_.size() && twice_ == nothing; ++i)
        if (sorted_[i].first == sorted_[i - 1].first) twice_ = sorted_[i].second;
    }
  }
  /// The first place of that number, or `nothing`.
  Index find(FileNumber number) const {
    if (numbers_.empty() || number < first_ || number > last_) return nothing;
    if (!table_.empty()) return table_[static_cast<std::size_t>(number - first_)];
    const auto place = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair<FileNumber, Index>(number, 0));
    return place != sorted_.end() && place->first == number ? place->second : nothing;
  }
  /// Calls f with the place of each of the numbers first, first + step, ... up to last; before, `visits` with a bound
  /// of their count.
  template <class F, class Visits>
  void for_range(FileNumber first, FileNumber last, FileNumber step, F f, Visits visits) const {
    if (numbers_.empty() || step < 1) return;
    if (first < first_) first += (first_ - first + step - 1) / step * step;
    last = std::min(last, last_);
    if (first > last) return;
    const auto steps = static_cast<std::size_t>((last - first) / step + 1);
    const auto place = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair<FileNumber, Index>(first, 0));
    const auto end = std::upper_bound(place, sorted_.end(), std::pair<FileNumber, Index>(last, nothing));
    const auto listed = static_cast<std::size_t>(end - place);
    if (!table_.empty() || steps < listed) {
      visits(steps);
      for (FileNumber n = first; n <= last; n += step)
        if (const Index i = find(n); i != nothing) f(i);
    } else {
      visits(listed);
      for (auto next = place; next != end; ++next)
        if ((next->first - first) % step == 0) f(next->second);
    }
  }
  /// A place whose number occurs before it, or `nothing`.
  Index twice() const { return twice_; }

 private:
  std::vector<FileNumber> numbers_;
  FileNumber first_ = 0, last_ = -1;
  std::vector<Index> table_;
  std::vector<std::pair<FileNumber, Index>> sorted_;
  Index twice_ = nothing;
};

/// How much copies of parts, sets and cards may name together: a multiple of the size of the file, so that memory and
/// time are linear in it.
class Allowance {
 public:
  explicit Allowance(const Source& source) : source_(&source) {}

  bool has(std::size_t count) const { return count <= 1'000'000 + 32 * source_->size() - taken_; }
  /// Error: more nodes and elements than are left.
  void take(std::size_t count, std::uint32_t line) {
    if (!has(count))
      source_->refuse(line, {"instances, sets and cards name nodes and elements more often than a file of ",
                             std::to_string(source_->size()), " bytes may: take out those that repeat others."});
    taken_ += count;
  }

 private:
  const Source* source_;
  std::size_t taken_ = 0;
};

/// Input of the readers by the numbers of the file; `finished` makes a deck of it.
struct RawMesh {
  /// Numbers are unique in their scope: an instance of a part, or the solids and the shells of LS-DYNA.
  static constexpr FileNumber scope = number_limit;

  struct Node {
    FileNumber number;
    Eigen::Vector3d x;
    std::uint32_t line;
  };
  enum class Shape : std::uint8_t { triangle, quadrilateral, tetrahedron, hexahedron, wedge, pyramid };
  struct Element {
    FileNumber number;
    std::array<FileNumber, 8> corners;
    std::uint32_t group, line;  ///< group: place in `groups`
    Shape shape;
    bool marks_solids = false;  ///< a surface cell: not a plate if it lies on solids
  };
  /// The numbers first, first + step, ... up to last.
  struct Sequence {
    FileNumber first, last, step;
    std::uint32_t line;
  };
  struct Set {
    FileNumber number = 0;
    std::string name = {};
    std::vector<Sequence> sequences = {};
    std::vector<std::size_t> others = {};  ///< earlier sets that it includes
    std::uint32_t line = 0;                ///< where it begins
    bool is_listed = true;                 ///< in the deck; others are only parts of sets
  };

  std::vector<Node> nodes = {};
  std::vector<Element> elements = {};
  std::vector<std::vector<std::uint32_t>> groups = {};  ///< the parts that the elements of a group belong to
  std::vector<NamedSet> parts = {};
  std::vector<Set> node_sets = {}, element_sets = {};
  std::vector<FileNumber> ignored_elements = {};  ///< of kinds that are no cells; sets may hold them
  bool repeats_nodes = false;                     ///< a node may be there again, at the same place
};

constexpr std::size_t corner_count(RawMesh::Shape shape) {
  using Shape = RawMesh::Shape;
  switch (shape) {
    case Shape::hexahedron:
      return 8;
    case Shape::wedge:
      return 6;
    case Shape::pyramid:
      return 5;
    case Shape::triangle:
      return 3;
    default:
      return 4;
  }
}

/// Eight corners that name a tetrahedron: a b c d d d d d (LS-DYNA) and a b c c d d d d (a brick folded together).
inline bool folds_to_tetrahedron(std::array<Index, 8>& c) {
  const auto alike = [&](std::size_t first, std::size_t last) {
    return std::all_of(c.begin() + static_cast<std::ptrdiff_t>(first), c.begin() + static_cast<std::ptrdiff_t>(last),
                       [&](Index node) { return node == c[first]; });
  };
  if (!alike(4, 8) || (c[3] != c[4] && c[3] != c[2])) return false;
  c[3] = c[4];
  return true;
}

/// The deck, and where in it the nodes of the file are.
struct Finished {
  Deck deck = {};
  Allowance allowance;
  Numbering file_nodes = {};
  std::vector<Index> place = {};  ///< of each node of the file; `nothing` if it was dropped

  /// The node of that number, or `nothing` if it was dropped. Error: it is not in the file.
  Index node(FileNumber number, const Source& source, std::uint32_t line) const {
    const Index i = file_nodes.find(number);
    if (i == nothing)
      source.refuse(line, {"node ", std::to_string(number % RawMesh::scope),
                           " is not in the file: define it or take it off this line."});
    return place[i];
  }
};

/// The same numbers in fewer sequences.
inline std::vector<RawMesh::Sequence> merged(std::vector<RawMesh::Sequence> ranges) {
  const auto key = [](const RawMesh::Sequence& s) { return std::tuple(s.step, s.first % s.step, s.first); };
  std::sort(ranges.begin(), ranges.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<RawMesh::Sequence> result;
  for (const RawMesh::Sequence& next : ranges) {
    const bool joins = !result.empty() && result.back().step == next.step &&
                       (next.first - result.back().first) % next.step == 0 &&
                       next.first <= result.back().last + next.step;
    if (joins)
      result.back().last = std::max(result.back().last, next.last);
    else
      result.push_back(next);
  }
  return result;
}

/// The sets by places in the mesh. Error: a number in a set that is neither in the mesh nor ignored.
inline std::vector<NamedSet> resolved(std::vector<RawMesh::Set> sets, const Numbering& numbering,
                                      const Numbering& ignored, std::span<const Index> place, const char* thing,
                                      const Source& source, Allowance& allowance) {
  std::vector<NamedSet> all;
  for (RawMesh::Set& set : sets) {
    std::vector<Index> members;
    std::vector<RawMesh::Sequence> ranges;
    const auto add = [&](Index i) {
      if (place[i] != nothing) members.push_back(place[i]);
    };
    for (const RawMesh::Sequence& numbers : set.sequences)
      if (numbers.first != numbers.last)
        ranges.push_back(numbers);
      else if (const Index i = numbering.find(numbers.first); i != nothing)
        add(i);
      else if (ignored.find(numbers.first) == nothing)
        source.refuse(numbers.line, {thing, " ", std::to_string(numbers.first % RawMesh::scope),
                                     " is not in the file: define it or take it off this set."});
    for (const auto& [first, last, step, line] : merged(std::move(ranges)))
      numbering.for_range(first, last, step, add, [&, at = line](std::size_t count) { allowance.take(count, at); });
    for (const std::size_t other : ascending(std::move(set.others))) {
      const std::vector<Index>& more = all.at(other).members;
      allowance.take(more.size(), set.line);
      members.insert(members.end(), more.begin(), more.end());
    }
    all.push_back({set.number, std::move(set.name), ascending(std::move(members))});
  }
  std::size_t next = 0;
  std::erase_if(all, [&](const NamedSet&) { return !sets[next++].is_listed; });
  return all;
}

/// Errors: a number twice; an element or set with a number that is not there; an element that is neither hexahedron,
/// tetrahedron, quadrilateral nor triangle.
inline Finished finished(RawMesh raw, const Source& source) {
  using Shape = RawMesh::Shape;
  Finished result{.allowance = Allowance(source)};
  Deck& deck = result.deck;
  std::vector<FileNumber> numbers;
  numbers.reserve(raw.nodes.size());
  for (const RawMesh::Node& node : raw.nodes) numbers.push_back(node.number);
  result.file_nodes = Numbering(std::move(numbers));
  if (raw.repeats_nodes && result.file_nodes.twice() != nothing) {
    const auto is_again = [&](std::size_t n) {
      const Index first = result.file_nodes.find(raw.nodes[n].number);
      return first != n && raw.nodes[first].x == raw.nodes[n].x;
    };
    std::vector<RawMesh::Node> once;
    for (std::size_t n = 0; n < raw.nodes.size(); ++n)
      if (!is_again(n)) once.push_back(raw.nodes[n]);
    raw.nodes = std::move(once);
    numbers.clear();
    for (const RawMesh::Node& node : raw.nodes) numbers.push_back(node.number);
    result.file_nodes = Numbering(std::move(numbers));
  }
  if (const Index n = result.file_nodes.twice(); n != nothing) {
    const RawMesh::Node& twin = raw.nodes[result.file_nodes.find(raw.nodes[n].number)];
    source.refuse(raw.nodes[n].line,
                  {"node ", std::to_string(twin.number % RawMesh::scope), " is on line ",
                   source.place_beside(twin.line, raw.nodes[n].line), " already: give each node a number of its own."});
  }

  // The elements by places of nodes in the file, and their shapes.
  struct Cell {
    std::array<Index, 8> corners;
    Shape shape;
    bool is_mark = false;
  };
  std::vector<Cell> cells;
  cells.reserve(raw.elements.size());
  for (const RawMesh::Element& element : raw.elements) {
    Cell cell{{}, element.shape};
    const std::size_t count = corner_count(element.shape);
    const auto refuse = [&](const std::string& what) {
      source.refuse(element.line, {"element ", std::to_string(element.number % RawMesh::scope), " ", what});
    };
    for (std::size_t i = 0; i < count; ++i) {
      cell.corners[i] = result.file_nodes.find(element.corners[i]);
      if (cell.corners[i] == nothing)
        refuse(joined({"names node ", std::to_string(element.corners[i] % RawMesh::scope),
                       ", which is not in the file: define it or correct the element."}));
    }
    std::array<Index, 8> sorted = cell.corners;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(sorted.begin(), end);
    const auto different = static_cast<std::size_t>(std::unique(sorted.begin(), end) - sorted.begin());
    auto& c = cell.corners;
    if (cell.shape == Shape::hexahedron && different == 4 && folds_to_tetrahedron(c))
      cell.shape = Shape::tetrahedron;
    else if (cell.shape == Shape::quadrilateral && different == 3 && c[0] != c[2] && c[1] != c[3]) {
      while (c[2] != c[3]) std::rotate(c.begin(), c.begin() + 1, c.begin() + 4);
      cell.shape = Shape::triangle;
    } else if (cell.shape == Shape::wedge && different == 6)
      c = wedge_cell<Index>({c[0], c[1], c[2], c[3], c[4], c[5]}), cell.shape = Shape::hexahedron;
    else if (cell.shape == Shape::pyramid && different == 5)
      c = pyramid_cell<Index>({c[0], c[1], c[2], c[3], c[4]}), cell.shape = Shape::hexahedron;
    else if (const auto canonical = canonical_hexahedron(c); cell.shape == Shape::hexahedron && canonical)
      c = *canonical;
    else if (cell.shape == Shape::hexahedron && (different == 6 || different == 5))
      refuse(joined({"has ", std::to_string(different),
                     " different corners, but repeats them otherwise than a wedge, a b c d e e f f, or a pyramid, "
                     "a b c d e e e e: correct it."}));
    else if (different != count)
      refuse(joined({"has ", std::to_string(different), " different corners of ", std::to_string(count),
                     ": take it out or correct it."}));
    cells.push_back(cell);
  }

  std::vector<char> used(raw.nodes.size(), 0);
  const auto mark_used = [&](bool solids) {
    for (const Cell& cell : cells)
      if ((corner_count(cell.shape) == 8 || cell.shape == Shape::tetrahedron) == solids && !cell.is_mark)
        for (std::size_t i = 0; i < corner_count(cell.shape); ++i) used[cell.corners[i]] = 1;
  };
  mark_used(true);
  std::size_t marks = 0;
  for (std::size_t e = 0; e < cells.size(); ++e) {
    const auto first = cells[e].corners.begin();
    const auto corners = static_cast<std::ptrdiff_t>(corner_count(cells[e].shape));
    cells[e].is_mark =
        raw.elements[e].marks_solids && std::all_of(first, first + corners, [&](Index n) { return used[n] != 0; });
    marks += cells[e].is_mark;
  }
  mark_used(false);

  // Nodes that a cell uses, in the order of the file.
  result.place.assign(raw.nodes.size(), nothing);
  FileNumber orphan = 0;
  std::size_t orphans = 0;
  for (std::size_t n = 0; n < raw.nodes.size(); ++n)
    if (used[n]) {
      result.place[n] = static_cast<Index>(deck.mesh.nodes.size());
      deck.mesh.nodes.push_back(raw.nodes[n].x);
      deck.node_numbers.push_back(raw.nodes[n].number % RawMesh::scope);
    } else if (orphans++ == 0) {
      orphan = raw.nodes[n].number % RawMesh::scope;
    }

  deck.parts = std::move(raw.parts);
  std::vector<Index> cell_place(cells.size(), nothing);
  const auto add = [&]<std::size_t N>(Cells<N>& list, Shape shape) {
    for (std::size_t e = 0; e < cells.size(); ++e) {
      if (cells[e].shape != shape || cells[e].is_mark) continue;
      std::array<Index, N> corners;
      for (std::size_t i = 0; i < N; ++i) corners[i] = result.place[cells[e].corners[i]];
      list.push_back(corners);
      cell_place[e] = static_cast<Index>(deck.cell_numbers.size());
      deck.cell_numbers.push_back(raw.elements[e].number % RawMesh::scope);
      const auto& parts = raw.groups[raw.elements[e].group];
      if (parts.size() > 1) result.allowance.take(parts.size(), raw.elements[e].line);
      for (const std::uint32_t part : parts) deck.parts[part].members.push_back(cell_place[e]);
    }
  };
  add(deck.mesh.hexahedra, Shape::hexahedron);
  add(deck.mesh.tetrahedra, Shape::tetrahedron);
  add(deck.mesh.quadrilaterals, Shape::quadrilateral);
  add(deck.mesh.triangles, Shape::triangle);

  numbers.clear();
  for (const RawMesh::Element& element : raw.elements) numbers.push_back(element.number);
  const Numbering file_elements(std::move(numbers));
  if (const Index e = file_elements.twice(); e != nothing) {
    const RawMesh::Element& twin = raw.elements[file_elements.find(raw.elements[e].number)];
    source.refuse(raw.elements[e].line, {"element ", std::to_string(twin.number % RawMesh::scope), " is on line ",
                                         source.place_beside(twin.line, raw.elements[e].line),
                                         " already: give each element a number of its own."});
  }
  deck.node_sets =
      resolved(std::move(raw.node_sets), result.file_nodes, {}, result.place, "node", source, result.allowance);
  deck.cell_sets = resolved(std::move(raw.element_sets), file_elements, Numbering(std::move(raw.ignored_elements)),
                            cell_place, "element", source, result.allowance);
  if (marks > 0)
    deck.warnings.push_back(
        joined({"Surface elements on solids (", std::to_string(marks), ") mark faces, and are no plates."}));
  if (orphans > 0)
    deck.warnings.push_back(joined({"Nodes without an element (", std::to_string(orphans),
                                    ", the first has the number ", std::to_string(orphan), ") were dropped."}));
  return result;
}

}  // namespace strike::detail
