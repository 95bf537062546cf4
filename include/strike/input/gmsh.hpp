#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/input/deck.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/input/source.hpp>

namespace strike {
namespace detail {

/// MSH 2, 4.0 and 4.1 (Gmsh reference manual, "MSH file format" and "Legacy formats").
class GmshReader {
 public:
  GmshReader(Source source, SecondOrder second_order) : source_(std::move(source)) { raw_.second_order = second_order; }

  Deck read() {
    std::string_view line;
    while (source_.next(line)) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (line[0] != '$') source_.refuse({shown(line), " stands in no section: begin one with $Name before it."});
      const std::string_view name = line.substr(1);
      rest_ = {};
      bool was_read = true;
      has_elements_ |= name == "Elements";
      if (version_ == 0 && name != "MeshFormat" && name != "Comments")
        source_.refuse({"the file does not begin with $MeshFormat: save it from gmsh as .msh of version 2.2 or 4.1."});
      if (name == "MeshFormat")
        format();
      else if (name == "PhysicalNames")
        physical_names();
      else if (name == "Entities" && version_ >= 40)
        entities(false);
      else if (name == "PartitionedEntities" && version_ >= 40)
        entities(true);
      else if (name == "Nodes")
        version_ == 41 ? nodes() : version_ == 40 ? nodes_of_40() : nodes_of_2(false);
      else if (name == "ParametricNodes" && version_ == 2 && !is_binary_)
        nodes_of_2(true);
      else if (name == "Elements")
        version_ >= 40 ? elements() : is_binary_ ? binary_elements_of_2() : elements_of_2();
      else
        skipped_.add(line.substr(0, 60), source_.line()), was_read = false;
      to_end_of(name, was_read);
    }
    if (version_ == 0) source_.refuse({"the file is empty: save it from gmsh as .msh of version 2.2 or 4.1."});
    if (!has_elements_) source_.refuse({"the file has no section $Elements: save it from gmsh again."});
    if (version_ == 2) join_copies();
    give_sets_their_nodes();
    Deck deck = finished(std::move(raw_), source_).deck;
    std::erase_if(deck.parts, [](const NamedSet& part) { return part.members.empty(); });
    skipped_.tell(deck.warnings, " was skipped: ");
    ignored_.tell(deck.warnings, " were ignored: ");
    return deck;
  }

 private:
  using Shape = RawMesh::Shape;
  using Entity = std::pair<FileNumber, FileNumber>;  ///< dimension and number, of an entity or a physical group

  /// The next word of the section.
  std::string_view word(std::string_view meaning) {
    while ((rest_ = trimmed(rest_)).empty())
      if (!source_.next(rest_))
        source_.refuse({"the file ends where ", meaning, " should stand: save it from gmsh again."});
    std::size_t end = 0;
    while (end < rest_.size() && !is_blank(rest_[end])) ++end;
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }
  /// The next number of a binary section, of the machine that wrote it.
  template <class T>
  T binary(std::string_view meaning) {
    std::array<char, sizeof(T)> bytes{};
    const std::string_view read = source_.bytes(sizeof(T));
    if (read.size() < sizeof(T))
      source_.refuse({"the file ends where ", meaning, " should stand: save it from gmsh again."});
    std::copy(read.begin(), read.end(), bytes.begin());
    if (is_swapped_) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }
  /// A number that is a size_t in binary sections.
  FileNumber size(std::string_view meaning) {
    if (is_binary_)
      return size_bytes_ == 4 ? FileNumber(binary<std::uint32_t>(meaning)) : binary<std::int64_t>(meaning);
    return text_integer(meaning);
  }
  /// A number that is an int in binary sections.
  FileNumber integer(std::string_view meaning) {
    return is_binary_ ? binary<std::int32_t>(meaning) : text_integer(meaning);
  }
  FileNumber text_integer(std::string_view meaning) {
    if (const auto plain = taken_number<FileNumber>(rest_, ' ')) return *plain;
    return source_.integer(word(meaning), meaning);
  }
  FileNumber checked_count(FileNumber n, std::string_view meaning) const {
    if (n < 0) source_.refuse({meaning, " ", std::to_string(n), " is negative: save the file from gmsh again."});
    return n;
  }
  FileNumber count(std::string_view meaning) { return checked_count(size(meaning), meaning); }
  /// A count that is text in binary files too.
  FileNumber text_count(std::string_view meaning) { return checked_count(text_integer(meaning), meaning); }
  double number(std::string_view meaning) {
    if (!is_binary_) {
      if (const auto plain = taken_number<double>(rest_, ' ')) return *plain;
      return source_.number(word(meaning), meaning);
    }
    const double value = binary<double>(meaning);
    if (!std::isfinite(value)) source_.refuse({meaning, " is not finite: save the file from gmsh again."});
    return value;
  }
  /// The number of a node or an element.
  FileNumber tag(std::string_view meaning) {
    return source_.expect_tag(version_ == 2 ? integer(meaning) : size(meaning), meaning);
  }
  /// The number of a group or another tag, which may be negative.
  FileNumber signed_tag(std::string_view meaning) {
    return source_.expect_tag(integer(meaning), meaning, 1 - number_limit);
  }
  /// Before bytes: the line of the count before them holds no more.
  void begin_bytes() {
    if (!trimmed(rest_).empty())
      source_.refuse({shown(rest_), " stands before the bytes of the section: save the file from gmsh again."});
    rest_ = {};
  }

  /// Error: a section that was read holds more than it counts.
  void to_end_of(std::string_view name, bool was_read) {
    do {
      rest_ = trimmed(rest_);
      const bool follows_bytes = is_binary_ && !was_read;
      if ((rest_.size() == name.size() + 4 || follows_bytes) && rest_.ends_with(name) &&
          rest_.substr(0, rest_.size() - name.size()).ends_with("$End"))
        return;
      if (was_read && !rest_.empty())
        source_.refuse({"section $", name, " holds ", shown(rest_), " after as much as its counts say: correct them."});
    } while (source_.next(rest_));
    source_.refuse({"the section $", name, " has no end: save the file from gmsh again."});
  }

  void format() {
    const std::string_view version = word("the version");
    const FileNumber type = source_.integer(word("the file type"), "the file type");
    const auto is_one_of = [&](auto... names) { return ((version == names) || ...); };
    if (version_ != 0) source_.refuse({"the format is there twice: save the file from gmsh again."});
    version_ = is_one_of("2", "2.0", "2.1", "2.2") ? 2 : is_one_of("4", "4.0") ? 40 : version == "4.1" ? 41 : 0;
    if (version_ == 0)
      source_.refuse({"version ", shown(version), " is not read: save as 2.2 or 4.1 (gmsh -format msh41)."});
    if (type != 0 && type != 1)
      source_.refuse({"the file type ", std::to_string(type), " is neither 0, ASCII, nor 1, binary: correct it."});
    size_bytes_ = source_.integer(word("the size of numbers"), "the size of numbers");
    if (type == 0) return source_.expect_text();
    if (version_ == 40) source_.refuse({"version 4.0 is read in ASCII alone: save as 4.1 (gmsh -format msh41)."});
    if (size_bytes_ != 8 && (size_bytes_ != 4 || version_ == 2))
      source_.refuse(
          {"the size of numbers ", std::to_string(size_bytes_), " is not 8: save the file from gmsh again."});
    begin_bytes();
    is_binary_ = true;
    if (const auto one = binary<std::uint32_t>("the 1 of the byte order"); one != 1) {
      if (one != 0x01000000) source_.refuse({"the 1 of the byte order is no 1: save the file from gmsh again."});
      is_swapped_ = true;
    }
  }

  void physical_names() {
    for (FileNumber left = text_count("the count of names"); left > 0; --left) {
      const auto integer = [&](std::string_view meaning) { return source_.integer(word(meaning), meaning); };
      FileNumber dimension = -1, number = integer("the dimension of a group");
      if (!trimmed(rest_).starts_with('"'))  // version 2.0 has none
        dimension = std::exchange(number, integer("the number of a group"));
      taken(rest_, '"');
      const std::size_t end = rest_.find('"');
      if (end == rest_.npos)
        source_.refuse({"group ", std::to_string(number), " has no name between quotes: give it one."});
      const std::string name(trimmed(taken(rest_, '"')));
      for (FileNumber any = 0; any < 4; ++any)
        if (dimension == any || dimension == -1) names_[{any, number}] = name;
    }
  }

  /// The physical groups of each entity, and the entity that one of a partitioned mesh is a piece of.
  void entities(bool of_partitions) {
    if (of_partitions) {
      size("the count of partitions");
      for (FileNumber ghosts = count("the count of ghost entities"); ghosts > 0; --ghosts)
        integer("a ghost entity"), integer("the partition of a ghost entity");
    }
    std::array<FileNumber, 4> counts;
    for (FileNumber& of_dimension : counts) of_dimension = count("the count of entities");
    for (const FileNumber dimension : {0, 1, 2, 3})
      for (FileNumber left = counts[static_cast<std::size_t>(dimension)]; left > 0; --left) {
        const FileNumber entity = integer("the number of an entity");
        if (of_partitions) {
          const FileNumber dimension_of_whole = integer("the dimension of a whole entity"),
                           whole = integer("the number of a whole entity");
          if (dimension_of_whole == dimension) wholes_[{dimension, entity}] = whole;
          for (FileNumber parts = count("the count of partitions"); parts > 0; --parts) integer("a partition");
        }
        for (int i = 0; i < (dimension == 0 && version_ == 41 ? 3 : 6); ++i) number("a bound of an entity");
        for (FileNumber groups = count("the count of groups"); groups > 0; --groups)
          physicals_[{dimension, entity}].push_back(
              std::abs(signed_tag("the number of a group")));  // negative: turned over
        if (dimension > 0)
          for (FileNumber bounds = count("the count of bounds"); bounds > 0; --bounds) integer("a bounding entity");
      }
  }

  /// Makes room for as many as are announced and the file can hold, in which each takes 8 bytes at least.
  template <class T>
  void make_room_for(FileNumber announced, std::vector<T>& all) const {
    make_room(all, std::min(static_cast<std::size_t>(announced), source_.bytes_left() / 8));
  }
  void expect(FileNumber announced, FileNumber read, std::string_view things) const {
    if (announced != read)
      source_.refuse({"the section announces ", std::to_string(announced), " ", things, " and has ",
                      std::to_string(read), ": save the file from gmsh again."});
  }
  void nodes() {
    FileNumber blocks = count("the count of blocks");
    const FileNumber announced = count("the count of nodes");
    make_room_for(announced, raw_.nodes);
    const std::size_t before = raw_.nodes.size();
    for (int i = 0; i < 2; ++i) size("a number of a node");
    for (; blocks > 0; --blocks) {
      const FileNumber dimension = integer("the dimension of a block");
      integer("the entity of a block");
      const FileNumber parameters =
          integer("whether the nodes are parametric,") != 0 ? std::clamp<FileNumber>(dimension, 0, 3) : 0;
      const std::size_t first = raw_.nodes.size();
      for (FileNumber left = count("the count of nodes"); left > 0; --left)
        raw_.nodes.push_back({tag("the number of a node"), Eigen::Vector3d::Zero(), source_.line()});
      for (std::size_t n = first; n < raw_.nodes.size(); ++n) {
        raw_.nodes[n].x = position();
        for (FileNumber i = 0; i < parameters; ++i) number("a parameter");
      }
    }
    expect(announced, static_cast<FileNumber>(raw_.nodes.size() - before), "nodes");
  }
  void nodes_of_40() {
    FileNumber blocks = count("the count of blocks");
    const FileNumber announced = count("the count of nodes");
    make_room_for(announced, raw_.nodes);
    const std::size_t before = raw_.nodes.size();
    for (; blocks > 0; --blocks) {
      integer("the entity of a block");
      const FileNumber dimension = integer("the dimension of a block");
      const FileNumber parameters =
          integer("whether the nodes are parametric,") != 0 && (dimension == 1 || dimension == 2) ? dimension : 0;
      for (FileNumber left = count("the count of nodes"); left > 0; --left) {
        const FileNumber number_of_node = tag("the number of a node");
        raw_.nodes.push_back({number_of_node, position(), source_.line()});
        for (FileNumber i = 0; i < parameters; ++i) number("a parameter");
      }
    }
    expect(announced, static_cast<FileNumber>(raw_.nodes.size() - before), "nodes");
  }
  void nodes_of_2(bool parametric) {
    FileNumber left = text_count("the count of nodes");
    make_room_for(left, raw_.nodes);
    if (is_binary_) begin_bytes();
    for (; left > 0; --left) {
      const FileNumber number = tag("the number of a node");
      raw_.nodes.push_back({number, position(), source_.line()});
      if (parametric) rest_ = {};  // its entity and parameters
    }
  }
  Eigen::Vector3d position() {
    const double x = number("the coordinate"), y = number("the coordinate"), z = number("the coordinate");
    return {x, y, z};
  }

  void elements() {
    FileNumber blocks = count("the count of blocks"), read = 0;
    const FileNumber announced = count("the count of elements");
    make_room_for(announced, raw_.elements);
    if (version_ == 41)
      for (int i = 0; i < 2; ++i) size("a number of an element");
    for (; blocks > 0; --blocks) {
      FileNumber dimension = integer("the dimension of a block"), entity = integer("the entity of a block");
      if (version_ == 40) std::swap(dimension, entity);
      const FileNumber type = integer("the type of elements");
      for (FileNumber left = count("the count of elements"); left > 0; --left, ++read) {
        const FileNumber number = tag("the number of an element");
        element(number, type, entity, 0);
      }
    }
    expect(announced, read, "elements");
  }
  void elements_of_2() {
    FileNumber left = text_count("the count of elements");
    make_room_for(left, raw_.elements);
    for (; left > 0; --left) {
      const FileNumber number = tag("the number of an element"), type = integer("the type of the element");
      tagged_element(number, type, count("the count of tags"));
    }
  }
  /// Blocks of elements of one type, with as many tags.
  void binary_elements_of_2() {
    FileNumber left = text_count("the count of elements");
    make_room_for(left, raw_.elements);
    begin_bytes();
    while (left > 0) {
      const FileNumber type = integer("the type of elements"),
                       in_block = checked_count(integer("the count of elements"), "the count of elements"),
                       tags = checked_count(integer("the count of tags"), "the count of tags");
      if (in_block > left)
        source_.refuse({"a block announces ", std::to_string(in_block), " elements, and the section has ",
                        std::to_string(left), " left: save the file from gmsh again."});
      for (FileNumber next = in_block; next > 0; --next) tagged_element(tag("the number of an element"), type, tags);
      left -= in_block;
    }
  }
  /// The first tag is the physical group, the second the entity; partitions follow.
  void tagged_element(FileNumber number, FileNumber type, FileNumber tags) {
    FileNumber physical = 0, entity = 0;
    for (FileNumber i = 0; i < tags; ++i) {
      const FileNumber value = signed_tag("a tag");
      if (i == 0) physical = std::abs(value);  // negative: turned over
      if (i == 1) entity = value;
    }
    element(number, type, entity, physical);
  }

  /// An element whose corners come next; `physical` is 0 if it has none of its own.
  void element(FileNumber number, FileNumber type, FileNumber entity, FileNumber physical) {
    using Second = SecondOrderKind;
    struct Kind {
      FileNumber type, dimension;
      Shape shape = Shape::hexahedron;
      Second second = Second::none;
      std::size_t nodes = 1;  ///< of points and lines
    };
    constexpr std::array<Kind, 19> kinds{{{15, 0},
                                          {1, 1, {}, {}, 2},
                                          {2, 2, Shape::triangle},
                                          {3, 2, Shape::quadrilateral},
                                          {4, 3, Shape::tetrahedron},
                                          {5, 3, Shape::hexahedron},
                                          {6, 3, Shape::wedge},
                                          {7, 3, Shape::pyramid},
                                          {8, 1, {}, {}, 3},
                                          {9, 2, Shape::triangle, Second::triangle6},
                                          {10, 2, Shape::quadrilateral, Second::quadrilateral9},
                                          {11, 3, Shape::tetrahedron, Second::tetrahedron10},
                                          {12, 3, Shape::hexahedron, Second::hexahedron27},
                                          {13, 3, Shape::wedge, Second::wedge18},
                                          {14, 3, Shape::pyramid, Second::pyramid14},
                                          {16, 2, Shape::quadrilateral, Second::quadrilateral8},
                                          {17, 3, Shape::hexahedron, Second::hexahedron20},
                                          {18, 3, Shape::wedge, Second::wedge15},
                                          {19, 3, Shape::pyramid, Second::pyramid13}}};
    const auto* const kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.type == type; });
    if (kind == kinds.end())
      source_.refuse({"element ", std::to_string(number), " is of type ", std::to_string(type),
                      ", which is not read: mesh in order 1 with hexahedra, tetrahedra, quadrilaterals or triangles."});
    if (raw_.second_order == SecondOrder::refused && (kind->second != Second::none || type == 8))
      source_.refuse({"element ", std::to_string(number), " is of type ", std::to_string(type),
                      ", of second order: ", cut_them, "."});
    RawMesh::Element element{number, {}, 0, source_.line(), kind->shape};
    const std::size_t corners = kind->dimension < 2 ? kind->nodes : corner_count(kind->shape);
    for (std::size_t i = 0; i < corners; ++i) element.corners[i] = tag("a corner");
    std::array<FileNumber, 19> mids;
    const std::span<const std::uint8_t> order = order_of_mids(kind->second);
    for (const std::uint8_t place : order) mids[place] = tag("a mid node");
    Group& group = group_of(kind->dimension, entity, physical);
    const auto name = [&](FileNumber node) { group.nodes.sequences.push_back({node, node, 1, element.line}); };
    if (kind->dimension < 3) {
      std::for_each_n(element.corners.begin(), corners, name);
      std::for_each_n(mids.begin(), order.size(), name);
    }
    if (kind->dimension < 2) {
      ignored_.add(kind->dimension == 0 ? "Points" : "Lines", element.line);
      return;
    }
    element.group = group.number;
    element.marks_solids = kind->dimension == 2;
    element.second = kind->second;
    if (!order.empty()) raw_.set_mids(element, std::span(mids).first(order.size()));
    raw_.elements.push_back(element);
  }
  /// Of each mid node in gmsh's order, its place in that of `mid_nodes` (Gmsh reference manual, "Node ordering").
  static std::span<const std::uint8_t> order_of_mids(SecondOrderKind kind) {
    using Kind = SecondOrderKind;
    static constexpr std::array<std::uint8_t, 5> face{0, 1, 2, 3, 4};
    static constexpr std::array<std::uint8_t, 6> tetrahedron{0, 1, 2, 3, 5, 4};
    static constexpr std::array<std::uint8_t, 19> hexahedron{0, 3, 8,  1,  9,  2,  10, 11, 4, 7,
                                                             5, 6, 12, 14, 17, 15, 16, 13, 18};
    static constexpr std::array<std::uint8_t, 12> wedge{0, 2, 6, 1, 7, 8, 3, 5, 4, 9, 11, 10};
    static constexpr std::array<std::uint8_t, 9> pyramid{0, 3, 4, 1, 5, 2, 6, 7, 8};
    const std::size_t count = mid_nodes(kind).size();
    switch (kind) {
      case Kind::none:
        return {};
      case Kind::triangle6:
      case Kind::quadrilateral8:
      case Kind::quadrilateral9:
        return std::span(face).first(count);
      case Kind::tetrahedron10:
        return tetrahedron;
      case Kind::hexahedron20:
      case Kind::hexahedron27:
        return std::span(hexahedron).first(count);
      case Kind::wedge15:
      case Kind::wedge18:
        return std::span(wedge).first(count);
      default:
        return std::span(pyramid).first(count);
    }
  }

  struct Group {
    std::uint32_t number;
    RawMesh::Set nodes = {.is_listed = false};  ///< unless it is a volume
    std::vector<std::size_t> node_sets = {};
  };
  /// The group of elements of an entity: its parts, and unless it is a volume the sets of its nodes.
  Group& group_of(FileNumber dimension, FileNumber entity, FileNumber physical) {
    const std::array<FileNumber, 3> key{dimension, entity, physical};
    if (last_group_ && last_key_ == key) return *last_group_;
    const auto [place, is_new] = groups_.try_emplace(key, Group{static_cast<std::uint32_t>(raw_.groups.size())});
    Group& group = place->second;
    last_key_ = key, last_group_ = &group;
    if (!is_new) return group;
    group.nodes.line = source_.line();
    raw_.groups.emplace_back();
    const auto dimension_at = static_cast<std::size_t>(dimension);
    const auto join = [&](auto& parts, FileNumber number) {
      const auto [part, first] =
          parts[dimension_at].try_emplace(number, std::pair(raw_.parts.size(), raw_.node_sets.size()));
      if (first) {
        NamedSet named;
        if (&parts == &physical_parts_)
          named = {number, names_[{dimension, number}], {}};
        else
          named.name = std::array{"point ", "line ", "surface ", "volume "}[dimension_at] + std::to_string(number);
        if (dimension < 3) raw_.node_sets.push_back({.number = named.number, .name = named.name});
        raw_.parts.push_back(std::move(named));
      }
      raw_.groups.back().push_back(static_cast<std::uint32_t>(part->second.first));
      if (dimension < 3) group.node_sets.push_back(part->second.second);
    };
    const auto whole = wholes_.find({dimension, entity});
    const FileNumber named = whole == wholes_.end() ? entity : whole->second;
    std::vector<FileNumber> physicals;
    for (const FileNumber piece : {entity, named})
      if (const auto known = physicals_.find({dimension, piece}); known != physicals_.end())
        physicals.insert(physicals.end(), known->second.begin(), known->second.end());
    if (physical != 0) physicals = {physical};
    for (const FileNumber number : ascending(std::move(physicals))) join(physical_parts_, number);
    if (raw_.groups.back().empty()) join(entity_parts_, named);
    return group;
  }
  /// Version 2 writes an element of an entity in several physical groups once for each: the copies become one.
  void join_copies() {
    std::vector<char> in_several(raw_.groups.size(), 0);
    for (auto next = groups_.begin(), group = next; next != groups_.end(); group = next)
      if (++next != groups_.end() && next->first[0] == group->first[0] && next->first[1] == group->first[1])
        in_several[group->second.number] = in_several[next->second.number] = 1;
    std::vector<std::size_t> elements;
    for (std::size_t e = 0; e < raw_.elements.size(); ++e)
      if (in_several[raw_.elements[e].group]) elements.push_back(e);
    const auto same = [&](std::size_t a, std::size_t b) {
      return raw_.elements[a].shape == raw_.elements[b].shape && raw_.elements[a].corners == raw_.elements[b].corners;
    };
    std::stable_sort(elements.begin(), elements.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(raw_.elements[a].shape, raw_.elements[a].corners) <
             std::tie(raw_.elements[b].shape, raw_.elements[b].corners);
    });
    std::map<std::vector<std::uint32_t>, std::uint32_t> joined_groups;
    std::vector<char> is_copy(raw_.elements.size(), 0);
    for (std::size_t first = 0, last = 0; first < elements.size(); first = last) {
      std::vector<std::uint32_t> parts;
      for (; last < elements.size() && same(elements[first], elements[last]); ++last) {
        const auto& more = raw_.groups[raw_.elements[elements[last]].group];
        parts.insert(parts.end(), more.begin(), more.end());
        is_copy[elements[last]] = last > first;
      }
      if (last == first + 1) continue;
      const auto [group, is_new] =
          joined_groups.try_emplace(ascending(std::move(parts)), static_cast<std::uint32_t>(raw_.groups.size()));
      if (is_new) raw_.groups.push_back(group->first);
      raw_.elements[elements[first]].group = group->second;
    }
    std::size_t next = 0;
    std::erase_if(raw_.elements, [&](const RawMesh::Element&) { return is_copy[next++] != 0; });
  }
  /// The sets that groups are in include their nodes.
  void give_sets_their_nodes() {
    std::vector<RawMesh::Set> all;
    for (auto& [key, group] : groups_) {
      for (const std::size_t set : group.node_sets) raw_.node_sets[set].others.push_back(all.size());
      for (const std::size_t set : group.node_sets) raw_.node_sets[set].line = group.nodes.line;
      if (!group.node_sets.empty()) all.push_back(std::move(group.nodes));
    }
    std::move(raw_.node_sets.begin(), raw_.node_sets.end(), std::back_inserter(all));
    raw_.node_sets = std::move(all);
  }

  std::map<Entity, std::string> names_ = {};
  std::map<Entity, std::vector<FileNumber>> physicals_ = {};
  std::map<Entity, FileNumber> wholes_ = {};  ///< of the entities of a partitioned mesh: the entity that was cut
  std::map<std::array<FileNumber, 3>, Group> groups_ = {};
  /// By dimension and number: places among the parts and the sets of nodes.
  using Parts = std::array<std::map<FileNumber, std::pair<std::size_t, std::size_t>>, 4>;
  Parts physical_parts_ = {}, entity_parts_ = {};
  std::array<FileNumber, 3> last_key_ = {};
  Group* last_group_ = nullptr;
  Source source_;
  std::string_view rest_ = {};
  RawMesh raw_ = {};
  Skipped skipped_ = {}, ignored_ = {};
  int version_ = 0;  ///< 2, 40 or 41
  bool is_binary_ = false, is_swapped_ = false, has_elements_ = false;
  FileNumber size_bytes_ = 8;  ///< of a size_t in the file
};

}  // namespace detail

/// The mesh of a gmsh file (.msh) of version 2, 2.1, 2.2, 4.0 or 4.1 in ASCII, or 2 and 4.1 in binary of either byte
/// order. Physical groups of volumes and surfaces are parts, of a partitioned mesh too; groups of surfaces, lines and
/// points are also sets of nodes. Surface elements on solids, lines and points are only sets of nodes. `name` is the
/// file in messages, whose lines are those between the bytes too. Of the options `second_order` alone has a meaning
/// here. Errors: another version; elements of second order, unless the options cut them; those of higher order; text in
/// the place of a number; a number given twice; a node that is not there; an incomplete file.
inline Deck read_gmsh(std::string_view text, const std::string& name, const ReadOptions& options = {}) {
  return detail::within_memory(
      name, [&] { return detail::GmshReader(detail::Source::binary(text, name), options.second_order).read(); });
}
inline Deck read_gmsh(const std::string& path, const ReadOptions& options = {}) {
  return read_gmsh(detail::content_of_file(path, true), path, options);
}

}  // namespace strike
