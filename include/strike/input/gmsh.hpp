#pragma once
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
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

/// MSH 2.2 and 4.1 in ASCII (Gmsh reference manual, "MSH file format").
class GmshReader {
 public:
  explicit GmshReader(Source source) : source_(std::move(source)) {}

  Deck read() {
    std::string_view line;
    while (source_.next(line)) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (line[0] != '$') source_.refuse({shown(line), " stands in no section: begin one with $Name before it."});
      const std::string_view name = line.substr(1);
      rest_ = {};
      bool was_read = true;
      if (version_ == 0 && name != "MeshFormat" && name != "Comments")
        source_.refuse({"the file does not begin with $MeshFormat: save it from gmsh as .msh of version 2.2 or 4.1."});
      if (name == "MeshFormat")
        format();
      else if (name == "PhysicalNames")
        physical_names();
      else if (name == "Entities" && version_ == 4)
        entities();
      else if (name == "Nodes")
        version_ == 4 ? nodes() : nodes_of_2();
      else if (name == "Elements")
        version_ == 4 ? elements() : elements_of_2();
      else
        skipped_.add(line.substr(0, 60), source_.line()), was_read = false;
      to_end_of(name, was_read);
    }
    if (version_ == 0) source_.refuse({"the file is empty: save it from gmsh as .msh of version 2.2 or 4.1."});
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
  FileNumber integer(std::string_view meaning) { return source_.integer(word(meaning), meaning); }
  FileNumber count(std::string_view meaning) {
    const FileNumber n = integer(joined({"the count of ", meaning}));
    if (n < 0)
      source_.refuse(
          {"the count of ", meaning, " ", std::to_string(n), " is negative: save the file from gmsh again."});
    return n;
  }
  double number(std::string_view meaning) { return source_.number(word(meaning), meaning); }
  FileNumber tag(std::string_view meaning, FileNumber least = 1) { return source_.tag(word(meaning), meaning, least); }

  /// Error: a section that was read holds more than it counts.
  void to_end_of(std::string_view name, bool was_read) {
    do {
      rest_ = trimmed(rest_);
      if (rest_.size() == name.size() + 4 && rest_.substr(0, 4) == "$End" && rest_.substr(4) == name) return;
      if (was_read && !rest_.empty())
        source_.refuse({"section $", name, " holds ", shown(rest_), " after as much as its counts say: correct them."});
    } while (source_.next(rest_));
    source_.refuse({"the section $", name, " has no end: save the file from gmsh again."});
  }

  void format() {
    const std::string_view version = word("the version");
    const FileNumber binary = integer("the file type");
    if (version != "2.1" && version != "2.2" && version != "4.1")
      source_.refuse({"version ", shown(version), " is not read: save as 2.2 or 4.1 (gmsh -format msh41)."});
    if (binary != 0) source_.refuse({"the file is binary: save it as ASCII (Mesh.Binary = 0)."});
    if (version_ != 0) source_.refuse({"the format is there twice: save the file from gmsh again."});
    version_ = version == "4.1" ? 4 : 2;
    integer("the size of numbers");
  }

  void physical_names() {
    for (FileNumber left = count("names"); left > 0; --left) {
      const FileNumber dimension = integer("the dimension of a group"), number = integer("the number of a group");
      taken(rest_, '"');
      const std::size_t end = rest_.find('"');
      if (end == rest_.npos)
        source_.refuse({"group ", std::to_string(number), " has no name between quotes: give it one."});
      names_[{dimension, number}] = std::string(trimmed(taken(rest_, '"')));
    }
  }

  /// The physical groups of each entity.
  void entities() {
    std::array<FileNumber, 4> counts;
    for (FileNumber& of_dimension : counts) of_dimension = count("entities");
    for (const FileNumber dimension : {0, 1, 2, 3})
      for (FileNumber left = counts[static_cast<std::size_t>(dimension)]; left > 0; --left) {
        const FileNumber entity = integer("the number of an entity");
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) number("a bound of an entity");
        for (FileNumber groups = count("groups"); groups > 0; --groups)
          physicals_[{dimension, entity}].push_back(
              std::abs(tag("the number of a group", -number_limit)));  // negative: turned over
        if (dimension > 0)
          for (FileNumber bounds = count("bounds"); bounds > 0; --bounds) integer("a bounding entity");
      }
  }

  void expect(FileNumber announced, FileNumber read, std::string_view things) const {
    if (announced != read)
      source_.refuse({"the section announces ", std::to_string(announced), " ", things, " and has ",
                      std::to_string(read), ": save the file from gmsh again."});
  }
  void nodes() {
    FileNumber blocks = count("blocks");
    const FileNumber announced = count("nodes");
    const std::size_t before = raw_.nodes.size();
    for (int i = 0; i < 2; ++i) integer("a number of a node");
    for (; blocks > 0; --blocks) {
      const FileNumber dimension = integer("the dimension of a block");
      integer("the entity of a block");
      const FileNumber parameters =
          integer("whether the nodes are parametric,") != 0 ? std::clamp<FileNumber>(dimension, 0, 3) : 0;
      const std::size_t first = raw_.nodes.size();
      for (FileNumber left = count("nodes"); left > 0; --left)
        raw_.nodes.push_back({tag("the number of a node"), Eigen::Vector3d::Zero(), source_.line()});
      for (std::size_t n = first; n < raw_.nodes.size(); ++n) {
        raw_.nodes[n].x = position();
        for (FileNumber i = 0; i < parameters; ++i) number("a parameter");
      }
    }
    expect(announced, static_cast<FileNumber>(raw_.nodes.size() - before), "nodes");
  }
  void nodes_of_2() {
    for (FileNumber left = count("nodes"); left > 0; --left) {
      const FileNumber number = tag("the number of a node");
      raw_.nodes.push_back({number, position(), source_.line()});
    }
  }
  Eigen::Vector3d position() {
    const double x = number("the coordinate"), y = number("the coordinate"), z = number("the coordinate");
    return {x, y, z};
  }

  void elements() {
    FileNumber blocks = count("blocks"), read = 0;
    const FileNumber announced = count("elements");
    for (int i = 0; i < 2; ++i) integer("a number of an element");
    for (; blocks > 0; --blocks) {
      integer("the dimension of a block");
      const FileNumber entity = integer("the entity of a block"), type = integer("the type of elements");
      for (FileNumber left = count("elements"); left > 0; --left, ++read) {
        const FileNumber number = tag("the number of an element");
        element(number, type, entity, 0);
      }
    }
    expect(announced, read, "elements");
  }
  void elements_of_2() {
    for (FileNumber left = count("elements"); left > 0; --left) {
      const FileNumber number = tag("the number of an element"), type = integer("the type of the element");
      FileNumber physical = 0, entity = 0;
      const FileNumber tags = count("tags");
      for (FileNumber i = 0; i < tags; ++i) {
        const FileNumber value = tag("a tag", -number_limit);
        if (i == 0) physical = std::abs(value);  // negative: turned over
        if (i == 1) entity = value;
      }
      element(number, type, entity, physical);
    }
  }

  /// An element whose corners come next; `physical` is 0 if it has none of its own.
  void element(FileNumber number, FileNumber type, FileNumber entity, FileNumber physical) {
    struct Kind {
      FileNumber type, dimension;
      std::size_t corners;
    };
    constexpr std::array<Kind, 8> kinds{
        {{15, 0, 1}, {1, 1, 2}, {2, 2, 3}, {3, 2, 4}, {4, 3, 4}, {5, 3, 8}, {6, 3, 6}, {7, 3, 5}}};
    const auto* const kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.type == type; });
    if (kind == kinds.end())
      source_.refuse({"element ", std::to_string(number), " is of type ", std::to_string(type),
                      ", which is not read: mesh in order 1 with hexahedra, tetrahedra, quadrilaterals or triangles."});
    RawMesh::Element element{number, {}, 0, source_.line(), Shape::hexahedron};
    for (std::size_t i = 0; i < kind->corners; ++i) element.corners[i] = tag("a corner");
    Group& group = group_of(kind->dimension, entity, physical);
    if (kind->dimension < 3)
      for (std::size_t i = 0; i < kind->corners; ++i)
        group.nodes.sequences.push_back({element.corners[i], element.corners[i], 1, element.line});
    if (kind->dimension < 2) {
      ignored_.add(kind->dimension == 0 ? "Points" : "Lines", element.line);
      return;
    }
    element.group = group.number;
    element.marks_solids = kind->dimension == 2;
    element.shape = type == 2   ? Shape::triangle
                    : type == 3 ? Shape::quadrilateral
                    : type == 4 ? Shape::tetrahedron
                    : type == 6 ? Shape::wedge
                    : type == 7 ? Shape::pyramid
                                : Shape::hexahedron;
    raw_.elements.push_back(element);
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
    const auto physicals = physicals_.find({dimension, entity});
    if (physical != 0)
      join(physical_parts_, physical);
    else if (physicals != physicals_.end())
      for (const FileNumber number : ascending(physicals->second)) join(physical_parts_, number);
    else
      join(entity_parts_, entity);
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
  int version_ = 0;
};

}  // namespace detail

/// The mesh of a gmsh file (.msh), ASCII of version 2.1, 2.2 or 4.1. Physical groups of volumes and surfaces are parts;
/// groups of surfaces, lines and points are also sets of nodes. Surface elements on solids, lines and points are only
/// sets of nodes. `name` is the file in messages. Errors: binary or another version; elements of higher order;
/// text in the place of a number; a number given twice; a node that is not there; an incomplete file.
inline Deck read_gmsh(std::string_view text, const std::string& name) {
  return detail::within_memory(name, [&] { return detail::GmshReader(detail::Source(text, name)).read(); });
}
inline Deck read_gmsh(const std::string& path) { return read_gmsh(detail::content_of_file(path), path); }

}  // namespace strike
