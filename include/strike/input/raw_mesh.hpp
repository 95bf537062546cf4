#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
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
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/second_order.hpp>

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

/// Makes room for so many more, and at least for twice as many: however often it is called, little is copied.
template <class T>
void make_room(std::vector<T>& all, std::size_t more) {
  if (all.capacity() - all.size() < more) all.reserve(std::max(all.size() + more, 2 * all.capacity()));
}

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
    SecondOrderKind second = SecondOrderKind::none;
    std::uint32_t mids = 0;  ///< of a cell of second order: the place of the first in `mid_nodes`
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
  std::vector<FileNumber> mid_nodes = {};         ///< in the order of `mid_nodes(kind)`; 0 for one that is not given
  SecondOrder second_order = SecondOrder::refused;

  std::span<const FileNumber> mids_of(const Element& element) const {
    return std::span(mid_nodes).subspan(element.mids, strike::detail::mid_nodes(element.second).size());
  }
  /// Gives an element mid nodes that are numbered `shift` higher than those.
  void set_mids(Element& element, std::span<const FileNumber> mids, FileNumber shift = 0) {
    const std::vector<FileNumber> copy(mids.begin(), mids.end());
    element.mids = static_cast<std::uint32_t>(mid_nodes.size());
    for (const FileNumber mid : copy) mid_nodes.push_back(mid == 0 ? 0 : mid + shift);
  }
};

/// The advice of sentences on cells of second order.
inline constexpr const char* cut_them =
    "cut them with {.second_order = SecondOrder::in_pieces} or SecondOrder::to_corners, or mesh in first order";

/// A kind of cells of second order in warnings: "tetrahedra of 10 nodes".
inline std::string name_of(SecondOrderKind kind) {
  using Kind = SecondOrderKind;
  const auto corners = [&]() -> std::pair<const char*, std::size_t> {
    switch (kind) {
      case Kind::triangle6:
        return {"triangles", 3};
      case Kind::quadrilateral8:
      case Kind::quadrilateral9:
        return {"quadrilaterals", 4};
      case Kind::tetrahedron10:
        return {"tetrahedra", 4};
      case Kind::hexahedron20:
      case Kind::hexahedron27:
        return {"hexahedra", 8};
      case Kind::wedge15:
      case Kind::wedge18:
        return {"wedges", 6};
      default:
        return {"pyramids", 5};
    }
  }();
  return joined({corners.first, " of ", std::to_string(corners.second + mid_nodes(kind).size()), " nodes"});
}

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

/// Faces of cells that were cut in pieces, by their corners.
class CutFaces {
 public:
  void add(SecondOrderKind kind, std::span<const Index> corners, std::span<const Index> mids) {
    const auto parents = mid_nodes(kind);
    for (std::size_t m = 0; m < parents.size(); ++m) {
      if (parents[m].count > 4) continue;
      std::array<Index, 4> key;
      key.fill(nothing);
      for (std::size_t i = 0; i < parents[m].count; ++i) key[i] = corners[parents[m].corners[i]];
      std::sort(key.begin(), key.end());
      mids_.emplace_back(key, mids[m]);
    }
    is_sorted_ = false;
  }
  /// Adds a segment, a b c c if it is a triangle, or its pieces if it is a face that was cut.
  void add_segment(const std::array<Index, 4>& s, std::vector<std::array<Index, 4>>& to) {
    if (!is_sorted_) std::sort(mids_.begin(), mids_.end()), is_sorted_ = true;
    if (s[2] == s[3]) {
      const std::array<Index, 6> n{s[0], s[1], s[2], mid({s[0], s[1]}), mid({s[1], s[2]}), mid({s[2], s[0]})};
      if (std::find(n.begin(), n.end(), nothing) != n.end()) return to.push_back(s);
      for (const auto& [a, b, c] : pieces_of_triangle) to.push_back({n[a], n[b], n[c], n[c]});
      return;
    }
    const std::array<Index, 9> n{s[0],
                                 s[1],
                                 s[2],
                                 s[3],
                                 mid({s[0], s[1]}),
                                 mid({s[1], s[2]}),
                                 mid({s[2], s[3]}),
                                 mid({s[3], s[0]}),
                                 mid({s[0], s[1], s[2], s[3]})};
    if (std::find(n.begin(), n.end(), nothing) != n.end()) return to.push_back(s);
    for (const auto& [a, b, c, d] : pieces_of_quadrilateral) to.push_back({n[a], n[b], n[c], n[d]});
  }

 private:
  Index mid(std::initializer_list<Index> corners) const {
    std::array<Index, 4> key;
    key.fill(nothing);
    std::copy(corners.begin(), corners.end(), key.begin());
    std::sort(key.begin(), key.end());
    const auto found = std::lower_bound(mids_.begin(), mids_.end(), std::pair(key, Index(0)));
    return found != mids_.end() && found->first == key ? found->second : nothing;
  }

  std::vector<std::pair<std::array<Index, 4>, Index>> mids_ = {};
  bool is_sorted_ = true;
};

/// The deck, and where in it the nodes of the file are.
struct Finished {
  Deck deck = {};
  Allowance allowance;
  Numbering file_nodes = {};
  std::vector<Index> place = {};   ///< of each node of the file; `nothing` if it was dropped
  std::vector<char> is_lost = {};  ///< mid nodes that were dropped, by their place in the file; empty without any
  std::map<std::pair<FileNumber, std::string>, std::size_t> lost_of_sets = {};  ///< mid nodes that sets have lost
  CutFaces cut_faces = {};

  /// The node of that number, or `nothing` if it was dropped. Error: it is not in the file.
  Index node(FileNumber number, const Source& source, std::uint32_t line) const {
    const Index i = file_nodes.find(number);
    if (i == nothing)
      source.refuse(line, {"node ", std::to_string(number % RawMesh::scope),
                           " is not in the file: define it or take it off this line."});
    return place[i];
  }
  /// Error: a force on a mid node that was dropped.
  void expect_force(FileNumber number, const Source& source, std::uint32_t line) const {
    const Index i = is_lost.empty() ? nothing : file_nodes.find(number);
    if (i != nothing && is_lost[i])
      source.refuse(line, {"a force on node ", std::to_string(number % RawMesh::scope),
                           " would be lost, a mid node that was dropped: put it on corners."});
  }
  /// Error: forces on a set that has lost mid nodes.
  void expect_forces(FileNumber number, const std::string& name, const Source& source, std::uint32_t line) const {
    if (const auto lost = lost_of_sets.find({number, name}); lost != lost_of_sets.end())
      source.refuse(line, {"forces on ", std::to_string(lost->second), " nodes of the set ",
                           name.empty() ? std::to_string(number) : shown(name),
                           " would be lost, mid nodes that were dropped: put them on corners."});
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

/// The sets by places in the mesh; `add_places(i, members)` adds those of the thing at place i in the file. Error: a
/// number in a set that is neither in the mesh nor ignored.
template <class AddPlaces>
std::vector<NamedSet> resolved(std::vector<RawMesh::Set> sets, const Numbering& numbering, const Numbering& ignored,
                               const AddPlaces& add_places, const char* thing, const Source& source,
                               Allowance& allowance) {
  std::vector<NamedSet> all;
  for (RawMesh::Set& set : sets) {
    std::vector<Index> members;
    std::vector<RawMesh::Sequence> ranges;
    const auto add = [&](Index i) { add_places(i, members); };
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

/// A cell by places of nodes in the file.
struct FiledCell {
  std::array<Index, 8> corners;
  Index element;  ///< its place in the file
  RawMesh::Shape shape;
  bool is_mark = false;
};

/// Cells of second order become cells of first order.
class SecondOrderCutter {
 public:
  SecondOrderCutter(const RawMesh& raw, const Numbering& nodes, const Source& source)
      : raw_(raw), nodes_(nodes), source_(source) {
    const bool any = std::any_of(raw.elements.begin(), raw.elements.end(),
                                 [](const auto& element) { return element.second != SecondOrderKind::none; });
    if (any) is_mid_.assign(raw.nodes.size(), 0);
  }

  /// Appends the pieces of an element, and tells whether it has some; without them its corners are left to the caller.
  bool cut(Index place, const std::array<Index, 8>& corners, std::vector<FiledCell>& cells, CutFaces& faces) {
    const RawMesh::Element& element = raw_.elements[place];
    const std::size_t count = corner_count(element.shape);
    std::vector<Index>& n = all_;
    n.assign(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count));
    for (const FileNumber number : raw_.mids_of(element)) {
      n.push_back(number == 0 ? nothing : nodes_.find(number));
      if (number != 0 && n.back() == nothing)
        refuse(element, {"names node ", std::to_string(number % RawMesh::scope),
                         ", which is not in the file: define it or correct the element."});
      if (number != 0) is_mid_[n.back()] = 1;
    }
    const bool cuts = raw_.second_order == SecondOrder::in_pieces && has_pieces(element.second);
    ++counts_[{element.second, cuts}];
    if (!cuts) {
      by_corners_.push_back(place);
      return false;
    }
    std::vector<Index> sorted = n;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() == nothing || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      refuse(element, {"repeats a node or lacks one, and cannot be cut in pieces: take cells by their corners with "
                       "{.second_order = SecondOrder::to_corners}, or correct it."});
    expect_order(element, n);
    faces.add(element.second, std::span(n).first(count), std::span(n).subspan(count));
    const auto add = [&]<std::size_t N>(const std::array<std::uint8_t, N>& piece) {
      FiledCell cell{{}, place, element.shape};
      std::array<Index, N> chosen;
      for (std::size_t i = 0; i < N; ++i) chosen[i] = n[piece[i]];
      if constexpr (N == 6)
        cell.corners = wedge_cell<Index>(chosen), cell.shape = RawMesh::Shape::hexahedron;
      else
        std::copy(chosen.begin(), chosen.end(), cell.corners.begin());
      cells.push_back(cell);
    };
    const std::size_t first = cells.size();
    const auto add_all = [&](const auto& pieces) {
      for (const auto& piece : pieces) add(piece);
    };
    switch (element.second) {
      case SecondOrderKind::triangle6:
        add_all(pieces_of_triangle);
        return true;
      case SecondOrderKind::quadrilateral9:
        add_all(pieces_of_quadrilateral);
        return true;
      case SecondOrderKind::tetrahedron10:
        add_all(pieces_of_tetrahedron([&](std::size_t i) -> const Eigen::Vector3d& { return x(n[i]); }));
        break;
      case SecondOrderKind::hexahedron27:
        add_all(pieces_of_hexahedron());
        break;
      default:
        add_all(pieces_of_wedge);
    }
    expect_volumes(element, std::span(cells).subspan(first), corners);
    return true;
  }

  /// Error: a mid node of an element that is taken by its corners is a corner of another cell, where it would hang.
  void expect_no_hanging(const std::vector<FiledCell>& cells, std::span<const char> used) const {
    if (by_corners_.empty()) return;
    std::vector<char> is_mark(raw_.elements.size(), 0);
    for (const FiledCell& cell : cells)
      if (cell.is_mark) is_mark[cell.element] = 1;
    for (const Index place : by_corners_)
      if (!is_mark[place])
        for (const FileNumber number : raw_.mids_of(raw_.elements[place]))
          if (number != 0 && used[nodes_.find(number)])
            refuse(raw_.elements[place],
                   {"is taken by its corners, and its mid node ", std::to_string(number % RawMesh::scope),
                    " is a corner of other cells, where it would hang: ",
                    raw_.second_order == SecondOrder::in_pieces
                        ? "take all cells by their corners with {.second_order = SecondOrder::to_corners}, or mesh in "
                          "first order."
                        : "mesh in one order."});
  }
  bool is_mid(std::size_t node) const { return !is_mid_.empty() && is_mid_[node]; }
  void tell(std::vector<std::string>& warnings, std::size_t lost) const {
    if (counts_.empty()) return;
    std::string kinds;
    for (const auto& [kind, count] : counts_)
      kinds += joined({kinds.empty() ? "" : ", ", name_of(kind.first), " (", std::to_string(count),
                       kind.second ? ") in pieces" : ") to their corners"});
    warnings.push_back(joined({"Cells of second order were cut to first: ", kinds, "; mid nodes that no cell uses (",
                               std::to_string(lost), ") were dropped."}));
  }

 private:
  const Eigen::Vector3d& x(Index node) const { return raw_.nodes[node].x; }
  [[noreturn, gnu::cold]] void refuse(const RawMesh::Element& element,
                                      std::initializer_list<std::string_view> what) const {
    source_.refuse(element.line,
                   {"element ", std::to_string(element.number % RawMesh::scope), " ", std::string_view(joined(what))});
  }
  /// Error: a mid node stands exactly where another one should.
  void expect_order(const RawMesh::Element& element, const std::vector<Index>& n) const {
    const auto mids = mid_nodes(element.second);
    const std::size_t count = n.size() - mids.size();
    double size = 0;
    for (std::size_t i = 1; i < count; ++i) size = std::max(size, (x(n[i]) - x(n[0])).norm());
    std::array<Eigen::Vector3d, 19> middles;
    for (std::size_t m = 0; m < mids.size(); ++m) {
      middles[m].setZero();
      for (std::size_t i = 0; i < mids[m].count; ++i) middles[m] += x(n[mids[m].corners[i]]);
      middles[m] /= static_cast<double>(mids[m].count);
    }
    for (std::size_t m = 0; m < mids.size(); ++m) {
      const auto distance = [&](std::size_t other) { return (x(n[count + m]) - middles[other]).norm(); };
      if (distance(m) <= 1e-3 * size) continue;
      for (std::size_t other = 0; other < mids.size(); ++other)
        if (distance(other) <= 1e-6 * size)
          refuse(element, {"has its mid node ", std::to_string(raw_.nodes[n[count + m]].number % RawMesh::scope),
                           " in the place of another one: order its mid nodes as the format has them."});
    }
  }
  /// Error: a piece is flat or inside out although the corners of its element are not.
  void expect_volumes(const RawMesh::Element& element, std::span<const FiledCell> pieces,
                      const std::array<Index, 8>& corners) const {
    const auto volume = [&](RawMesh::Shape shape, const std::array<Index, 8>& c) {
      std::array<Eigen::Vector3d, 8> at;
      const std::size_t count = shape == RawMesh::Shape::tetrahedron ? 4 : 8;
      for (std::size_t i = 0; i < count; ++i) at[i] = x(c[i]);
      return count == 4 ? tetrahedron_volume(at, {0, 1, 2, 3}) : hexahedron_volume(at, {0, 1, 2, 3, 4, 5, 6, 7});
    };
    const bool is_wedge = element.shape == RawMesh::Shape::wedge;
    const std::array<Index, 8> whole =
        is_wedge ? wedge_cell<Index>({corners[0], corners[1], corners[2], corners[3], corners[4], corners[5]})
                 : corners;
    if (!(volume(is_wedge ? RawMesh::Shape::hexahedron : element.shape, whole) > 0)) return;
    for (const FiledCell& piece : pieces)
      if (!(volume(piece.shape, piece.corners) > 0))
        refuse(element, {"has a piece that is flat or inside out, as its mid nodes lie too far from its edges: move "
                         "them, or take cells by their corners with {.second_order = SecondOrder::to_corners}."});
  }

  const RawMesh& raw_;
  const Numbering& nodes_;
  const Source& source_;
  std::vector<char> is_mid_ = {};
  std::vector<Index> all_ = {}, by_corners_ = {};
  std::map<std::pair<SecondOrderKind, bool>, std::size_t> counts_ = {};
};

/// Errors: a number twice; an element or set with a number that is not there; an element that is neither hexahedron,
/// tetrahedron, quadrilateral nor triangle.
inline Finished finished(RawMesh raw, const Source& source) {
  using Shape = RawMesh::Shape;
  Finished result{.allowance = Allowance(source)};
  Deck& deck = result.deck;
  const auto numbering = [](const auto& nodes_or_elements) {
    std::vector<FileNumber> numbers;
    numbers.reserve(nodes_or_elements.size());
    for (const auto& each : nodes_or_elements) numbers.push_back(each.number);
    return Numbering(std::move(numbers));
  };
  result.file_nodes = numbering(raw.nodes);
  if (raw.repeats_nodes && result.file_nodes.twice() != nothing) {
    const auto is_again = [&](std::size_t n) {
      const Index first = result.file_nodes.find(raw.nodes[n].number);
      return first != n && raw.nodes[first].x == raw.nodes[n].x;
    };
    std::vector<RawMesh::Node> once;
    for (std::size_t n = 0; n < raw.nodes.size(); ++n)
      if (!is_again(n)) once.push_back(raw.nodes[n]);
    raw.nodes = std::move(once);
    result.file_nodes = numbering(raw.nodes);
  }
  if (const Index n = result.file_nodes.twice(); n != nothing) {
    const RawMesh::Node& twin = raw.nodes[result.file_nodes.find(raw.nodes[n].number)];
    source.refuse(raw.nodes[n].line,
                  {"node ", std::to_string(twin.number % RawMesh::scope), " is on line ",
                   source.place_beside(twin.line, raw.nodes[n].line), " already: give each node a number of its own."});
  }

  // The elements by places of nodes in the file, and their shapes.
  std::vector<FiledCell> cells;
  cells.reserve(raw.elements.size());
  SecondOrderCutter cutter(raw, result.file_nodes, source);
  for (Index place = 0; place < raw.elements.size(); ++place) {
    const RawMesh::Element& element = raw.elements[place];
    FiledCell cell{{}, place, element.shape};
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
    if (element.second != SecondOrderKind::none && cutter.cut(place, cell.corners, cells, result.cut_faces)) continue;
    auto& c = cell.corners;
    std::size_t different = 0;
    for (std::size_t i = 0; i < count; ++i) different += std::find(&c[0], &c[i], c[i]) == &c[i];
    if (cell.shape == Shape::hexahedron && different == 4 && folds_to_tetrahedron(c))
      cell.shape = Shape::tetrahedron;
    else if (cell.shape == Shape::quadrilateral && different == 3 && c[0] != c[2] && c[1] != c[3]) {
      while (c[2] != c[3]) std::rotate(c.begin(), c.begin() + 1, c.begin() + 4);
      cell.shape = Shape::triangle;
    } else if (cell.shape == Shape::wedge && different == 6)
      c = wedge_cell<Index>({c[0], c[1], c[2], c[3], c[4], c[5]}), cell.shape = Shape::hexahedron;
    else if (cell.shape == Shape::pyramid && different == 5)
      c = pyramid_cell<Index>({c[0], c[1], c[2], c[3], c[4]}), cell.shape = Shape::hexahedron;
    else if (cell.shape == Shape::hexahedron && (different == 6 || different == 5)) {
      const auto canonical = canonical_hexahedron(c);
      if (!canonical)
        refuse(joined({"has ", std::to_string(different),
                       " different corners, but repeats them otherwise than a wedge, a b c d e e f f, or a pyramid, "
                       "a b c d e e e e: correct it."}));
      c = *canonical;
    } else if (different != count)
      refuse(joined({"has ", std::to_string(different), " different corners of ", std::to_string(count),
                     ": take it out or correct it."}));
    cells.push_back(cell);
  }

  std::vector<char> used(raw.nodes.size(), 0);
  const auto mark_used = [&](bool solids) {
    for (const FiledCell& cell : cells)
      if ((corner_count(cell.shape) == 8 || cell.shape == Shape::tetrahedron) == solids && !cell.is_mark)
        for (std::size_t i = 0; i < corner_count(cell.shape); ++i) used[cell.corners[i]] = 1;
  };
  mark_used(true);
  std::size_t marks = 0;
  for (std::size_t e = 0, last = 0; e < cells.size(); e = last) {  // all pieces of an element, or none, are marks
    while (last < cells.size() && cells[last].element == cells[e].element) ++last;
    const auto lies_on_solids = [&](const FiledCell& cell) {
      const auto first = cell.corners.begin();
      return std::all_of(first, first + static_cast<std::ptrdiff_t>(corner_count(cell.shape)),
                         [&](Index n) { return used[n] != 0; });
    };
    const auto pieces = std::span(cells).subspan(e, last - e);
    if (!raw.elements[cells[e].element].marks_solids || !std::all_of(pieces.begin(), pieces.end(), lies_on_solids))
      continue;
    for (FiledCell& piece : pieces) piece.is_mark = true;
    ++marks;
  }
  mark_used(false);
  cutter.expect_no_hanging(cells, used);

  // Nodes that a cell uses, in the order of the file.
  result.place.assign(raw.nodes.size(), nothing);
  FileNumber orphan = 0;
  std::size_t orphans = 0, lost = 0;
  const auto used_nodes = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  deck.mesh.nodes.reserve(used_nodes), deck.node_numbers.reserve(used_nodes);
  for (std::size_t n = 0; n < raw.nodes.size(); ++n)
    if (used[n]) {
      result.place[n] = static_cast<Index>(deck.mesh.nodes.size());
      deck.mesh.nodes.push_back(raw.nodes[n].x);
      deck.node_numbers.push_back(raw.nodes[n].number % RawMesh::scope);
    } else if (cutter.is_mid(n)) {
      if (lost++ == 0) result.is_lost.assign(raw.nodes.size(), 0);
      result.is_lost[n] = 1;
    } else if (orphans++ == 0) {
      orphan = raw.nodes[n].number % RawMesh::scope;
    }

  deck.parts = std::move(raw.parts);
  struct Pieces {
    Index first = nothing, count = 0;
  };
  std::vector<Pieces> cell_places(raw.elements.size());
  deck.cell_numbers.reserve(cells.size());
  const auto add = [&]<std::size_t N>(Cells<N>& list, Shape shape) {
    const auto belongs = [&](const FiledCell& cell) { return cell.shape == shape && !cell.is_mark; };
    list.reserve(static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), belongs)));
    for (std::size_t e = 0; e < cells.size(); ++e) {
      if (!belongs(cells[e])) continue;
      std::array<Index, N> corners;
      for (std::size_t i = 0; i < N; ++i) corners[i] = result.place[cells[e].corners[i]];
      list.push_back(corners);
      const auto place = static_cast<Index>(deck.cell_numbers.size());
      const RawMesh::Element& element = raw.elements[cells[e].element];
      Pieces& pieces = cell_places[cells[e].element];
      if (pieces.count++ == 0) pieces.first = place;
      deck.cell_numbers.push_back(element.number % RawMesh::scope);
      const auto& parts = raw.groups[element.group];
      if (parts.size() > 1) result.allowance.take(parts.size(), element.line);
      for (const std::uint32_t part : parts) deck.parts[part].members.push_back(place);
    }
  };
  add(deck.mesh.hexahedra, Shape::hexahedron);
  add(deck.mesh.tetrahedra, Shape::tetrahedron);
  add(deck.mesh.quadrilaterals, Shape::quadrilateral);
  add(deck.mesh.triangles, Shape::triangle);

  const Numbering file_elements = numbering(raw.elements);
  if (const Index e = file_elements.twice(); e != nothing) {
    const RawMesh::Element& twin = raw.elements[file_elements.find(raw.elements[e].number)];
    source.refuse(raw.elements[e].line, {"element ", std::to_string(twin.number % RawMesh::scope), " is on line ",
                                         source.place_beside(twin.line, raw.elements[e].line),
                                         " already: give each element a number of its own."});
  }
  const auto kept = static_cast<Index>(deck.mesh.nodes.size());
  const auto add_node = [&](Index n, std::vector<Index>& members) {
    if (result.place[n] != nothing)
      members.push_back(result.place[n]);
    else if (cutter.is_mid(n))
      members.push_back(kept + n);  // until it is counted as lost
  };
  deck.node_sets =
      resolved(std::move(raw.node_sets), result.file_nodes, {}, add_node, "node", source, result.allowance);
  for (NamedSet& set : deck.node_sets) {
    const auto first = std::lower_bound(set.members.begin(), set.members.end(), kept);
    if (first == set.members.end()) continue;
    result.lost_of_sets[{set.number, set.name}] += static_cast<std::size_t>(set.members.end() - first);
    set.members.erase(first, set.members.end());
  }
  const auto add_cells = [&](Index e, std::vector<Index>& members) {
    for (Index i = 0; i < cell_places[e].count; ++i) members.push_back(cell_places[e].first + i);
  };
  deck.cell_sets = resolved(std::move(raw.element_sets), file_elements, Numbering(std::move(raw.ignored_elements)),
                            add_cells, "element", source, result.allowance);
  cutter.tell(deck.warnings, lost);
  if (marks > 0)
    deck.warnings.push_back(
        joined({"Surface elements on solids (", std::to_string(marks), ") mark faces, and are no plates."}));
  if (orphans > 0)
    deck.warnings.push_back(joined({"Nodes without an element (", std::to_string(orphans),
                                    ", the first has the number ", std::to_string(orphan), ") were dropped."}));
  return result;
}

}  // namespace strike::detail
