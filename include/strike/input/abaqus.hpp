#pragma once
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/deck.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/input/source.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {
namespace detail {

/// Keyword lines `*NAME, PARAMETER=VALUE` and data lines of fields between commas (Abaqus Analysis User's Guide, "Input
/// syntax rules").
class AbaqusReader {
 public:
  explicit AbaqusReader(Source source) : source_(std::move(source)) {}

  Deck read() {
    bool any = false;
    while (skip_data()) any = true, keyword();
    if (!any) source_.refuse({"the file has no keyword: give an Abaqus input file."});
    if (model_ != &all_) source_.refuse({"a part has no end: write *END PART after it."});
    Deck deck = finished(std::move(all_.raw), source_).deck;
    deck.title = std::move(title_);
    skipped_.tell(deck.warnings, " was skipped: ");
    ignored_.tell(deck.warnings, " were ignored: ");
    return deck;
  }

 private:
  using Shape = RawMesh::Shape;
  using Parameters = std::map<std::string, std::string, std::less<>>;

  /// A part, or everything outside of parts, with its sets by name.
  struct Model {
    RawMesh raw = {};
    std::map<std::string, std::size_t> node_sets = {}, element_sets = {};
    std::uint32_t group = nothing;  ///< of the elements that are in no instance
  };

  /// The next data line, without comments. False before a keyword and at the end.
  bool data(std::string_view& line) {
    while (source_.peek() != '\0') {
      const bool comment = source_.next_begins_with("**");
      if (!comment && source_.next_begins_with("*")) return false;
      source_.next(line);
      if (!comment && !trimmed(line).empty()) return true;
    }
    return false;
  }
  bool skip_data() {
    std::string_view line;
    while (data(line)) {
    }
    return source_.peek() != '\0';
  }

  void keyword() {
    std::string_view line;
    source_.next(line);
    std::string whole(trimmed(line));
    while (!whole.empty() && whole.back() == ',' && source_.next(line)) whole += trimmed(line);
    std::string_view rest = whole;
    const std::string name = upper(trimmed(taken(rest, ',')));
    Parameters parameters;
    while (!rest.empty()) {
      std::string_view value = taken(rest, ',');
      const std::string key = upper(trimmed(taken(value, '=')));
      value = trimmed(value);
      if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
      parameters[key] = std::string(value);
    }
    if (name == "*INCLUDE")
      source_.refuse({"*INCLUDE is not followed: put the text of that file here."});
    else if (name == "*HEADING")
      heading();
    else if (name == "*NODE")
      nodes(parameters);
    else if (name == "*ELEMENT")
      elements(parameters);
    else if (name == "*NSET" && !parameters.contains("ELSET"))
      set(model_->raw.node_sets, model_->node_sets, required(parameters, "NSET", name), parameters);
    else if (name == "*ELSET")
      set(model_->raw.element_sets, model_->element_sets, required(parameters, "ELSET", name), parameters);
    else if (name == "*PART")
      begin_part(required(parameters, "NAME", name));
    else if (name == "*END PART")
      model_ = &all_;
    else if (name == "*INSTANCE")
      instance(required(parameters, "NAME", name), required(parameters, "PART", name));
    else if (name != "*ASSEMBLY" && name != "*END ASSEMBLY" && name != "*END INSTANCE")
      skipped_.add(name.substr(0, 60), source_.line());
  }
  const std::string& required(const Parameters& parameters, std::string_view key, std::string_view keyword) const {
    const auto found = parameters.find(key);
    if (found == parameters.end() || found->second.empty())
      source_.refuse({keyword, " has no ", key, ": write ", keyword, ", ", key, "=..."});
    return found->second;
  }

  void heading() {
    std::string_view line;
    while (data(line))
      if (title_.empty()) title_ = std::string(trimmed(line));
  }

  void nodes(const Parameters& parameters) {
    if (const auto system = parameters.find("SYSTEM");
        system != parameters.end() && !same_word(system->second, "R") && !system->second.empty())
      source_.refuse({"the nodes have the system ", shown(system->second), ": give Cartesian coordinates."});
    RawMesh::Set* set = nullptr;
    if (const auto name = parameters.find("NSET"); name != parameters.end())
      set = &set_of(model_->raw.node_sets, model_->node_sets, name->second);
    std::string_view line;
    while (data(line)) {
      const FileNumber number = source_.tag(taken(line, ','), "the number of a node");
      Eigen::Vector3d x = Eigen::Vector3d::Zero();
      for (Eigen::Index i = 0; i < 3; ++i) {
        const std::string_view field = trimmed(taken(line, ','));
        if (!field.empty()) x[i] = source_.number(field, "the coordinate");
      }
      model_->raw.nodes.push_back({number, x, source_.line()});
      if (set) set->sequences.push_back({number, number, 1, source_.line()});
    }
  }

  static bool begins_with_one_of(std::string_view type, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](auto b) { return type.substr(0, b.size()) == b; });
  }
  void elements(const Parameters& parameters) {
    const std::string type = upper(required(parameters, "TYPE", "*ELEMENT"));
    RawMesh::Element element{0, {}, 0, 0, Shape::hexahedron};
    if (begins_with_one_of(
            type, {"C3D10", "C3D15", "C3D2", "C3D5", "C3D6", "S8", "S9", "STRI65", "SC6", "SC8", "CPS6", "CPS8"}))
      source_.refuse(
          {"elements of type ", shown(type), " are not read: mesh in first order with C3D8, C3D4, S4 or S3."});
    if (begins_with_one_of(type, {"C3D8"}))
      element.shape = Shape::hexahedron;
    else if (begins_with_one_of(type, {"C3D4"}))
      element.shape = Shape::tetrahedron;
    else if (begins_with_one_of(type, {"S4", "CPS4"}))
      element.shape = Shape::quadrilateral;
    else if (type == "S3" || begins_with_one_of(type, {"S3R", "STRI3", "CPS3"}))
      element.shape = Shape::triangle;
    else
      return ignore(type);
    element.marks_solids = begins_with_one_of(type, {"CPS"});  // gmsh's only elements of surfaces
    RawMesh& raw = model_->raw;
    if (model_->group == nothing) {
      model_->group = static_cast<std::uint32_t>(raw.groups.size());
      raw.groups.emplace_back();
    }
    element.group = model_->group;
    RawMesh::Set* set = nullptr;
    if (const auto name = parameters.find("ELSET"); name != parameters.end())
      set = &set_of(raw.element_sets, model_->element_sets, name->second);
    std::string_view line;
    while (data(line)) {
      element.number = source_.tag(taken(line, ','), "the number of an element");
      element.line = source_.line();
      for (std::size_t i = 0; i < corner_count(element.shape); ++i) {
        if (trimmed(line).empty() && !data(line))
          source_.refuse({"element ", std::to_string(element.number), " of type ", type, " has ", std::to_string(i),
                          " corners of ", std::to_string(corner_count(element.shape)), ": give them all."});
        element.corners[i] = source_.tag(taken(line, ','), "a corner");
      }
      if (!trimmed(line).empty())
        source_.refuse({"element ", std::to_string(element.number), " has too many corners for its type ", type,
                        ": correct the line or the type."});
      raw.elements.push_back(element);
      if (set) set->sequences.push_back({element.number, element.number, 1, element.line});
    }
  }
  void ignore(const std::string& type) {
    std::string_view line;
    bool goes_on = false;
    while (data(line)) {
      const bool is_new = !goes_on;
      goes_on = trimmed(line).back() == ',';
      if (!is_new) continue;
      model_->raw.ignored_elements.push_back(source_.tag(taken(line, ','), "the number of an element"));
      ignored_.add("Elements of type " + type.substr(0, 40), source_.line());
    }
  }

  static RawMesh::Set& set_of(std::vector<RawMesh::Set>& sets, std::map<std::string, std::size_t>& places,
                              const std::string& name) {
    const auto [place, is_new] = places.try_emplace(upper(name), sets.size());
    if (is_new) sets.push_back({0, name, {}, {}});
    return sets[place->second];
  }
  void set(std::vector<RawMesh::Set>& sets, std::map<std::string, std::size_t>& places, const std::string& name,
           const Parameters& parameters) {
    FileNumber scope = 0;
    if (const auto instance = parameters.find("INSTANCE"); instance != parameters.end())
      scope = scope_of(instance->second);
    RawMesh::Set& set = set_of(sets, places, name);
    const auto self = static_cast<std::size_t>(&set - sets.data());
    std::string_view line;
    while (data(line)) {
      const std::uint32_t at = source_.line();
      if (parameters.contains("GENERATE")) {
        const FileNumber first = source_.tag(taken(line, ','), "the first of a range"),
                         last = source_.tag(taken(line, ','), "the last of a range");
        const FileNumber step = trimmed(line).empty() ? 1 : source_.tag(taken(line, ','), "the step of a range");
        if (first <= last) set.sequences.push_back({scope + first, scope + last, step, at});
        continue;
      }
      while (!line.empty()) {
        std::string_view field = trimmed(taken(line, ','));
        if (field.empty()) continue;
        FileNumber own_scope = scope;
        if (const std::size_t dot = field.rfind('.'); dot != field.npos && to_integer(field.substr(dot + 1)))
          if (const auto instance = scopes_.find(upper(field.substr(0, dot))); instance != scopes_.end())
            own_scope = instance->second, field = field.substr(dot + 1);
        if (to_integer(field)) {
          const FileNumber number = own_scope + source_.tag(field, "a number of a set");
          set.sequences.push_back({number, number, 1, at});
        } else if (const auto other = places.find(upper(field)); other != places.end() && other->second < self) {
          set.others.push_back(other->second);
        } else {
          source_.refuse({"set '", name, "' holds ", shown(field),
                          ", which is neither a number nor a set before it: define that set first."});
        }
      }
    }
  }
  FileNumber scope_of(const std::string& instance) const {
    const auto found = scopes_.find(upper(instance));
    if (found == scopes_.end())
      source_.refuse({"instance ", shown(instance), " is not in the file: define it before its sets."});
    return found->second;
  }

  void begin_part(const std::string& name) {
    if (model_ != &all_) source_.refuse({"a part begins within a part: write *END PART before it."});
    const auto [part, is_new] = parts_.try_emplace(upper(name));
    if (!is_new) source_.refuse({"part ", shown(name), " is there twice: give each a name of its own."});
    model_ = &part->second;
  }

  /// A copy of a part, translated and then rotated.
  void instance(const std::string& name, const std::string& part_name) {
    const auto part = parts_.find(upper(part_name));
    if (part == parts_.end())
      source_.refuse({"part ", shown(part_name), " is not in the file: define it before its instances."});
    const FileNumber scope = RawMesh::scope * static_cast<FileNumber>(scopes_.size() + 1);
    if (!scopes_.try_emplace(upper(name), scope).second)
      source_.refuse({"instance ", shown(name), " is there twice: give each a name of its own."});
    if (scopes_.size() > 1000000) source_.refuse({"there are more than a million instances: merge some."});

    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    std::string_view line;
    const auto vector = [&] {
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      for (Eigen::Index i = 0; i < 3; ++i)
        if (const std::string_view field = trimmed(taken(line, ',')); !field.empty())
          v[i] = source_.number(field, "a coordinate of the instance");
      return v;
    };
    if (data(line)) shift = vector();
    if (data(line)) {
      centre = vector();
      const Eigen::Vector3d axis = vector() - centre;
      const double length = axis.norm(), angle = source_.number(taken(line, ','), "the angle") * std::numbers::pi / 180;
      if (!(length > 0)) source_.refuse({"the axis of the instance has no length: give two different points."});
      const Eigen::Vector3d n = axis / length;
      for (Eigen::Index i = 0; i < 3; ++i) {  // Rodrigues' formula on the base vectors
        const Eigen::Vector3d e = Eigen::Vector3d::Unit(i);
        turn.col(i) = std::cos(angle) * e + std::sin(angle) * cross(n, e) + (1 - std::cos(angle)) * n[i] * n;
      }
    }

    const RawMesh& from = part->second.raw;
    RawMesh& to = all_.raw;
    for (RawMesh::Node node : from.nodes) {
      node.number += scope;
      node.x += shift;
      if (!turn.isIdentity(0)) node.x = centre + turn * (node.x - centre);
      to.nodes.push_back(node);
    }
    const auto group = static_cast<std::uint32_t>(to.groups.size());
    to.groups.push_back({static_cast<std::uint32_t>(to.parts.size())});
    to.parts.push_back({0, name, {}});
    for (RawMesh::Element element : from.elements) {
      element.number += scope;
      for (FileNumber& corner : element.corners) corner += scope;
      element.group = group;
      to.elements.push_back(element);
    }
    for (const FileNumber number : from.ignored_elements) to.ignored_elements.push_back(number + scope);
    const auto copy = [&](const std::vector<RawMesh::Set>& sets, std::vector<RawMesh::Set>& all, auto& places) {
      const std::size_t first = all.size();
      for (RawMesh::Set set : sets) {
        for (RawMesh::Sequence& numbers : set.sequences) numbers.first += scope, numbers.last += scope;
        for (std::size_t& other : set.others) other += first;
        set.name = joined({name, ".", set.name});
        places.try_emplace(upper(set.name), all.size());
        all.push_back(std::move(set));
      }
    };
    copy(from.node_sets, to.node_sets, all_.node_sets);
    copy(from.element_sets, to.element_sets, all_.element_sets);
  }

  Source source_;
  Model all_ = {};
  Model* model_ = &all_;
  std::map<std::string, Model> parts_ = {};
  std::map<std::string, FileNumber> scopes_ = {};
  std::string title_ = {};
  Skipped skipped_ = {}, ignored_ = {};
};

}  // namespace detail

/// The mesh of an Abaqus input file (.inp), flat or of parts and instances. Instances are parts; `*ELSET`s serve as
/// parts too; sets within a part are called "instance.set". C3D8, C3D4, S4, S3 and their kinds (C3D8R, ...) are read,
/// and gmsh's CPS4 and CPS3, which are plates unless they lie on solids; elements of other types are ignored with a
/// warning, keywords that do not describe a mesh are skipped with a warning. `name` is the file in messages. Errors:
/// `*INCLUDE`; solids or shells of higher order, wedges; text in the place of a number; a number given twice; a node,
/// set, part or instance that is not there.
inline Deck read_abaqus(std::string_view text, std::string name) {
  return detail::AbaqusReader(detail::Source(text, std::move(name))).read();
}
inline Deck read_abaqus(const std::string& path) { return read_abaqus(detail::content_of_file(path), path); }

}  // namespace strike
