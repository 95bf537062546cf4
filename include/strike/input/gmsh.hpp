#pragma once
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

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
        skipped_.add(line, source_.line());
      to_end_of(name);
    }
    if (version_ == 0) source_.refuse({"the file is empty: save it from gmsh as .msh of version 2.2 or 4.1."});
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
  double number(std::string_view meaning) { return source_.number(word(meaning), meaning); }
  FileNumber tag(std::string_view meaning, FileNumber least = 1) { return source_.tag(word(meaning), meaning, least); }

  void to_end_of(std::string_view name) {
    do {
      rest_ = trimmed(rest_);
      if (rest_.size() == name.size() + 4 && rest_.substr(0, 4) == "$End" && rest_.substr(4) == name) return;
    } while (source_.next(rest_));
    source_.refuse({"the section $", name, " has no end: save the file from gmsh again."});
  }

  void format() {
    const std::string_view version = word("the version");
    const FileNumber binary = integer("the file type");
    if (version != "2.2" && version != "4.1")
      source_.refuse({"version ", shown(version), " is not read: save as 2.2 or 4.1 (gmsh -format msh41)."});
    if (binary != 0) source_.refuse({"the file is binary: save it as ASCII (Mesh.Binary = 0)."});
    version_ = version == "4.1" ? 4 : 2;
  }

  void physical_names() {
    for (FileNumber left = integer("the count of names"); left > 0; --left) {
      const FileNumber dimension = integer("the dimension of a group"), number = integer("the number of a group");
      taken(rest_, '"');
      names_[{dimension, number}] = std::string(trimmed(taken(rest_, '"')));
    }
  }

  /// The physical groups of each entity.
  void entities() {
    std::array<FileNumber, 4> counts;
    for (FileNumber& count : counts) count = integer("the count of entities");
    for (const FileNumber dimension : {0, 1, 2, 3})
      for (FileNumber left = counts[static_cast<std::size_t>(dimension)]; left > 0; --left) {
        const FileNumber entity = integer("the number of an entity");
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) number("a bound of an entity");
        for (FileNumber groups = integer("the count of groups"); groups > 0; --groups)
          physicals_[{dimension, entity}].push_back(
              std::abs(tag("the number of a group", -number_limit)));  // negative: turned over
        if (dimension > 0)
          for (FileNumber bounds = integer("the count of bounds"); bounds > 0; --bounds) integer("a bounding entity");
      }
  }

  void nodes() {
    FileNumber blocks = integer("the count of blocks");
    for (int i = 0; i < 3; ++i) integer("a count or number of nodes");
    for (; blocks > 0; --blocks) {
      const FileNumber dimension = integer("the dimension of a block");
      integer("the entity of a block");
      const FileNumber parameters =
          integer("whether the nodes are parametric,") != 0 ? std::clamp<FileNumber>(dimension, 0, 3) : 0;
      const std::size_t first = raw_.nodes.size();
      for (FileNumber left = integer("the count of nodes"); left > 0; --left)
        raw_.nodes.push_back({tag("the number of a node"), Eigen::Vector3d::Zero(), source_.line()});
      for (std::size_t n = first; n < raw_.nodes.size(); ++n) {
        raw_.nodes[n].x = position();
        for (FileNumber i = 0; i < parameters; ++i) number("a parameter");
      }
    }
  }
  void nodes_of_2() {
    for (FileNumber left = integer("the count of nodes"); left > 0; --left) {
      const FileNumber number = tag("the number of a node");
      raw_.nodes.push_back({number, position(), source_.line()});
    }
  }
  Eigen::Vector3d position() {
    const double x = number("the coordinate"), y = number("the coordinate"), z = number("the coordinate");
    return {x, y, z};
  }

  void elements() {
    FileNumber blocks = integer("the count of blocks");
    for (int i = 0; i < 3; ++i) integer("a count or number of elements");
    for (; blocks > 0; --blocks) {
      integer("the dimension of a block");
      const FileNumber entity = integer("the entity of a block"), type = integer("the type of elements");
      for (FileNumber left = integer("the count of elements"); left > 0; --left) {
        const FileNumber number = tag("the number of an element");
        element(number, type, entity, 0);
      }
    }
  }
  void elements_of_2() {
    for (FileNumber left = integer("the count of elements"); left > 0; --left) {
      const FileNumber number = tag("the number of an element"), type = integer("the type of the element");
      FileNumber physical = 0, entity = 0;
      const FileNumber tags = integer("the count of tags");
      for (FileNumber i = 0; i < tags; ++i) {
        const FileNumber value = integer("a tag");
        if (i == 0) physical = value;
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
    constexpr std::array<Kind, 6> kinds{{{15, 0, 1}, {1, 1, 2}, {2, 2, 3}, {3, 2, 4}, {4, 3, 4}, {5, 3, 8}}};
    const auto* const kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.type == type; });
    if (kind == kinds.end())
      source_.refuse({"element ", std::to_string(number), " is of type ", std::to_string(type),
                      type == 6   ? " (a wedge)"
                      : type == 7 ? " (a pyramid)"
                                  : "",
                      ", which is not read: mesh in order 1 with hexahedra, tetrahedra, quadrilaterals or triangles."});
    RawMesh::Element element{number, {}, 0, source_.line(), Shape::hexahedron};
    for (std::size_t i = 0; i < kind->corners; ++i) element.corners[i] = tag("a corner");
    const Group& group = group_of(kind->dimension, entity, physical);
    for (const std::size_t set : group.node_sets)
      for (std::size_t i = 0; i < kind->corners; ++i)
        raw_.node_sets[set].sequences.push_back({element.corners[i], element.corners[i], 1, element.line});
    if (kind->dimension < 2) {
      ignored_.add(kind->dimension == 0 ? "Points" : "Lines", element.line);
      return;
    }
    element.group = group.number;
    element.marks_solids = kind->dimension == 2;
    element.shape = type == 2   ? Shape::triangle
                    : type == 3 ? Shape::quadrilateral
                    : type == 4 ? Shape::tetrahedron
                                : Shape::hexahedron;
    raw_.elements.push_back(element);
  }

  struct Group {
    std::uint32_t number;
    std::vector<std::size_t> node_sets = {};
  };
  /// The group of elements of an entity: its parts, and unless it is a volume the sets of its nodes.
  const Group& group_of(FileNumber dimension, FileNumber entity, FileNumber physical) {
    const std::array<FileNumber, 3> key{dimension, entity, physical};
    if (last_group_ && last_key_ == key) return *last_group_;
    const auto [place, is_new] = groups_.try_emplace(key, Group{static_cast<std::uint32_t>(raw_.groups.size())});
    Group& group = place->second;
    last_key_ = key, last_group_ = &group;
    if (!is_new) return group;
    raw_.groups.emplace_back();
    const auto join = [&](FileNumber number, const std::string& name) {
      const auto [part, first] =
          parts_.try_emplace({dimension, number, name}, std::pair(raw_.parts.size(), raw_.node_sets.size()));
      if (first) {
        raw_.parts.push_back({number, name, {}});
        if (dimension < 3) raw_.node_sets.push_back({number, name, {}, {}});
      }
      raw_.groups.back().push_back(static_cast<std::uint32_t>(part->second.first));
      if (dimension < 3) group.node_sets.push_back(part->second.second);
    };
    const auto join_physical = [&](FileNumber number) {
      const auto name = names_.find({dimension, number});
      join(number, name != names_.end() ? name->second : std::string());
    };
    const auto physicals = physicals_.find({dimension, entity});
    if (physical != 0)
      join_physical(physical);
    else if (physicals != physicals_.end())
      for (const FileNumber number : physicals->second) join_physical(number);
    else
      join(entity, joined({std::array{"point ", "line ", "surface ", "volume "}[static_cast<std::size_t>(dimension)],
                           std::to_string(entity)}));
    return group;
  }

  std::map<Entity, std::string> names_ = {};
  std::map<Entity, std::vector<FileNumber>> physicals_ = {};
  std::map<std::array<FileNumber, 3>, Group> groups_ = {};
  std::map<std::tuple<FileNumber, FileNumber, std::string>, std::pair<std::size_t, std::size_t>> parts_ = {};
  std::array<FileNumber, 3> last_key_ = {};
  const Group* last_group_ = nullptr;
  Source source_;
  std::string_view rest_ = {};
  RawMesh raw_ = {};
  Skipped skipped_ = {}, ignored_ = {};
  int version_ = 0;
};

}  // namespace detail

/// The mesh of a gmsh file (.msh), ASCII of version 2.2 or 4.1. Physical groups of volumes and surfaces are parts;
/// groups of surfaces, lines and points are also sets of nodes. Surface elements on solids, lines and points are only
/// sets of nodes. `name` is the file in messages. Errors: binary or another version; elements of higher order, wedges
/// and pyramids; text in the place of a number; a number given twice; a node that is not there; an incomplete file.
inline Deck read_gmsh(std::string_view text, std::string name) {
  return detail::GmshReader(detail::Source(text, std::move(name))).read();
}
inline Deck read_gmsh(const std::string& path) { return read_gmsh(detail::content_of_file(path), path); }

}  // namespace strike
