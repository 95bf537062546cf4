#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <optional>
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
  explicit AbaqusReader(Source source) : source_(std::move(source)), copies_(source_) {}

  Deck read() {
    bool any = false;
    while (skip_data()) any = true, keyword();
    if (!any) source_.refuse({"the file has no keyword: give an Abaqus input file."});
    end_of_instance_before("the end of the file");
    if (model_ != &all_) source_.refuse({"a part has no end: write *END PART after it."});
    Deck deck = finished(std::move(all_.raw), source_).deck;
    deck.title = std::move(title_);
    for (const auto& [key, part] : parts_) {
      if (part.is_placed || part.raw.elements.empty()) continue;
      if (deck.cell_numbers.empty())
        source_.refuse(part.line, {"part ", shown(part.name), " has no instance, and nothing else is in the mesh: ",
                                   "write *INSTANCE, PART=", part.name, "."});
      deck.warnings.push_back(
          joined({"Part ", shown(part.name), " (elements: ", std::to_string(part.raw.elements.size()),
                  ") has no instance and was dropped: line ", std::to_string(part.line), "."}));
    }
    skipped_.tell(deck.warnings, " was skipped: ");
    ignored_.tell(deck.warnings, " were ignored: ");
    values_.tell(deck.warnings, " had no effect: ");
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
    std::string name = {};
    std::uint32_t line = 0;
    bool is_placed = false;
  };
  /// A copy of a part, and what the instance defines itself, translated and then turned.
  struct Instance {
    std::string name;
    const Model* part;
    FileNumber scope;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Model own = {};
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
      const std::string key = whole_parameter(upper(trimmed(taken(value, '='))));
      value = trimmed(value);
      if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
      parameters[key] = std::string(value);
    }
    std::string word;  // *END PART may be written *ENDPART
    for (const char c : name)
      if (!is_blank(c)) word += c;
    read(word, name, parameters);
  }
  static constexpr std::array<std::string_view, 11> known_parameters{
      "ELSET", "GENERATE", "INPUT", "INSTANCE", "INTERNAL", "NAME", "NSET", "PART", "SYSTEM", "TYPE", "UNSORTED"};
  /// Abaqus takes the first letters of a parameter for it.
  static std::string whole_parameter(std::string key) {
    for (const std::string_view whole : known_parameters)
      if (key.size() > 2 && whole.starts_with(key)) return std::string(whole);
    return key;
  }
  void read(const std::string& word, const std::string& name, const Parameters& parameters) {
    using Names = std::initializer_list<std::string_view>;
    const auto is_one_of = [&](Names names) { return std::find(names.begin(), names.end(), word) != names.end(); };
    if (word == "*INCLUDE") source_.refuse({"*INCLUDE is not followed: put the text of that file here."});
    if (is_one_of({"*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN", "*ELCOPY", "*IMPORT"}))
      source_.refuse({name, " makes nodes or elements and is not read: write them out with *NODE and *ELEMENT."});
    if (const auto input = parameters.find("INPUT");
        input != parameters.end() && is_one_of({"*NODE", "*ELEMENT", "*NSET", "*ELSET", "*SYSTEM", "*HEADING"}))
      source_.refuse({"INPUT=", input->second, " of ", name, " is not followed: put the lines of that file here."});

    if (is_one_of({"*NODE", "*ELEMENT", "*NSET", "*ELSET", "*PART", "*INSTANCE"}))
      for (const auto& [key, value] : parameters)
        if (std::find(known_parameters.begin(), known_parameters.end(), key) == known_parameters.end())
          values_.add(joined({key.substr(0, 40), " of ", name}), source_.line());

    if (word == "*HEADING")
      heading();
    else if (word == "*NODE")
      nodes(parameters);
    else if (word == "*SYSTEM")
      system();
    else if (word == "*ELEMENT")
      elements(parameters);
    else if (word == "*NSET" && parameters.contains("ELSET"))
      skipped_.add("*NSET with ELSET", source_.line());
    else if (word == "*NSET")
      set(model_->raw.node_sets, model_->node_sets, required(parameters, "NSET", name), parameters);
    else if (word == "*ELSET")
      set(model_->raw.element_sets, model_->element_sets, required(parameters, "ELSET", name), parameters);
    else if (word == "*PART")
      begin_part(required(parameters, "NAME", name));
    else if (word == "*ENDPART")
      model_ = &all_, system_.setZero();
    else if (word == "*INSTANCE")
      begin_instance(required(parameters, "NAME", name), parameters);
    else if (word == "*ENDINSTANCE")
      end_instance();
    else if (word == "*ENDASSEMBLY")
      end_of_instance_before(name);
    else if (word != "*ASSEMBLY")
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
      model_->raw.nodes.push_back({number, x + system_, source_.line()});
      if (set) set->sequences.push_back({number, number, 1, source_.line()});
    }
  }

  /// The origin of the nodes that follow.
  void system() {
    system_.setZero();
    std::string_view line;
    if (!data(line)) return;
    system_ = vector(line, "a coordinate of the system");
    if (vector(line, "a coordinate of the system").norm() > 0 || data(line))
      source_.refuse({"the system is turned, which is not read: give the nodes in global coordinates."});
  }
  Eigen::Vector3d vector(std::string_view& line, std::string_view meaning) {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i)
      if (const std::string_view field = trimmed(taken(line, ',')); !field.empty())
        v[i] = source_.number(field, meaning);
    return v;
  }

  static bool begins_with_one_of(std::string_view type, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](auto b) { return type.substr(0, b.size()) == b; });
  }
  void elements(const Parameters& parameters) {
    const std::string type = upper(required(parameters, "TYPE", "*ELEMENT"));
    RawMesh::Element element{0, {}, 0, 0, Shape::hexahedron};
    if (begins_with_one_of(type, {"C3D10", "C3D15", "C3D2", "S8", "S9", "STRI65", "SC6", "SC8", "CPS6", "CPS8"}))
      source_.refuse({"elements of type ", shown(type),
                      " are not read: mesh in first order with C3D8, C3D6, C3D5, C3D4, S4 or S3."});
    if (begins_with_one_of(type, {"C3D8"}))
      element.shape = Shape::hexahedron;
    else if (begins_with_one_of(type, {"C3D6"}))
      element.shape = Shape::wedge;
    else if (begins_with_one_of(type, {"C3D5"}))
      element.shape = Shape::pyramid;
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

  RawMesh::Set& set_of(std::vector<RawMesh::Set>& sets, std::map<std::string, std::size_t>& places,
                       const std::string& name) {
    const auto [place, is_new] = places.try_emplace(upper(name), sets.size());
    if (is_new) sets.push_back({.name = name, .line = source_.line()});
    return sets[place->second];
  }
  void set(std::vector<RawMesh::Set>& sets, std::map<std::string, std::size_t>& places, const std::string& name,
           const Parameters& parameters) {
    FileNumber scope = 0;
    std::string prefix;
    if (const auto instance = parameters.find("INSTANCE"); instance != parameters.end())
      scope = scope_of(instance->second), prefix = joined({upper(instance->second), "."});
    set_of(sets, places, name);
    std::size_t& self = places.find(upper(name))->second;
    std::string_view line;
    while (data(line)) {
      const std::uint32_t at = source_.line();
      if (parameters.contains("GENERATE")) {
        const FileNumber first = source_.tag(taken(line, ','), "the first of a range"),
                         last = source_.tag(taken(line, ','), "the last of a range");
        const std::string_view step = trimmed(taken(line, ','));
        if (first > last)
          source_.refuse({"the range from ", std::to_string(first), " to ", std::to_string(last),
                          " is empty: give the smaller number first."});
        if (!trimmed(line).empty()) source_.refuse({"a range has more than three numbers: give each its own line."});
        sets[self].sequences.push_back(
            {scope + first, scope + last, step.empty() ? 1 : source_.tag(step, "the step of a range"), at});
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
          sets[self].sequences.push_back({number, number, 1, at});
          continue;
        }
        const auto other = places.find(prefix + upper(field));
        if (other == places.end())
          source_.refuse({"set '", name, "' holds ", shown(field),
                          ", which is neither a number nor a set before it: define that set first."});
        if (other->second == self) continue;
        if (other->second > self) {  // that set may hold this one as it was
          sets[self].is_listed = false;
          sets.push_back({.name = sets[self].name, .others = {self}, .line = at});
          self = sets.size() - 1;
        }
        sets[self].others.push_back(other->second);
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
    end_of_instance_before("a part");
    const auto [part, is_new] = parts_.try_emplace(upper(name));
    if (!is_new) source_.refuse({"part ", shown(name), " is there twice: give each a name of its own."});
    model_ = &part->second;
    model_->name = name, model_->line = source_.line();
    system_.setZero();
  }

  void begin_instance(const std::string& name, const Parameters& parameters) {
    if (parameters.contains("INSTANCE"))
      source_.refuse({"an instance of an earlier analysis is not read: give its part with PART=..."});
    const std::string& part_name = required(parameters, "PART", "*INSTANCE");
    end_of_instance_before("the next one");
    if (model_ != &all_) source_.refuse({"an instance begins within a part: write *END PART before it."});
    const auto part = parts_.find(upper(part_name));
    if (part == parts_.end())
      source_.refuse({"part ", shown(part_name), " is not in the file: define it before its instances."});
    part->second.is_placed = true;
    const FileNumber scope = RawMesh::scope * static_cast<FileNumber>(scopes_.size() + 1);
    if (!scopes_.try_emplace(upper(name), scope).second)
      source_.refuse({"instance ", shown(name), " is there twice: give each a name of its own."});
    if (scopes_.size() > 1000000) source_.refuse({"there are more than a million instances: merge some."});

    instance_ = Instance{.name = name, .part = &part->second, .scope = scope};
    std::string_view line;
    if (data(line)) instance_->shift = vector(line, "a coordinate of the instance");
    if (data(line)) {
      instance_->centre = vector(line, "a coordinate of the instance");
      const Eigen::Vector3d axis = vector(line, "a coordinate of the instance") - instance_->centre;
      const double length = axis.norm(), angle = source_.number(taken(line, ','), "the angle") * std::numbers::pi / 180;
      if (!(length > 0)) source_.refuse({"the axis of the instance has no length: give two different points."});
      const Eigen::Vector3d n = axis / length;
      for (Eigen::Index i = 0; i < 3; ++i) {  // Rodrigues' formula on the base vectors
        const Eigen::Vector3d e = Eigen::Vector3d::Unit(i);
        instance_->turn.col(i) = std::cos(angle) * e + std::sin(angle) * cross(n, e) + (1 - std::cos(angle)) * n[i] * n;
      }
    }
    model_ = &instance_->own;
    system_.setZero();
  }
  void end_of_instance_before(std::string_view next) const {
    if (instance_)
      source_.refuse({"instance ", shown(instance_->name), " has no end: write *END INSTANCE before ", next, "."});
  }
  void end_instance() {
    if (!instance_) source_.refuse({"no instance ends here: write *INSTANCE before it."});
    const auto part = static_cast<std::uint32_t>(all_.raw.parts.size());
    all_.raw.parts.push_back({0, instance_->name, {}});
    all_.raw.groups.push_back({part});
    place(instance_->part->raw), place(instance_->own.raw);
    instance_.reset();
    model_ = &all_;
    system_.setZero();
  }
  /// Copies a mesh to the last part.
  void place(const RawMesh& from) {
    const std::string& name = instance_->name;
    const FileNumber scope = instance_->scope;
    const bool turns = !instance_->turn.isIdentity(0);
    RawMesh& to = all_.raw;
    std::size_t count = from.nodes.size() + from.elements.size() + from.ignored_elements.size();
    for (const auto* sets : {&from.node_sets, &from.element_sets})
      for (const RawMesh::Set& set : *sets)
        count += 4 + set.sequences.size() + set.others.size() + (name.size() + set.name.size()) / 16;
    copies_.take(count, source_.line());
    for (RawMesh::Node node : from.nodes) {
      node.number += scope;
      node.x += instance_->shift;
      if (turns) node.x = instance_->centre + instance_->turn * (node.x - instance_->centre);
      to.nodes.push_back(node);
    }
    for (RawMesh::Element element : from.elements) {
      element.number += scope;
      for (FileNumber& corner : element.corners) corner += scope;
      element.group = static_cast<std::uint32_t>(to.groups.size() - 1);
      to.elements.push_back(element);
    }
    for (const FileNumber number : from.ignored_elements) to.ignored_elements.push_back(number + scope);
    const auto copy = [&](const std::vector<RawMesh::Set>& sets, std::vector<RawMesh::Set>& all, auto& places) {
      const std::size_t first = all.size();
      for (RawMesh::Set set : sets) {
        for (RawMesh::Sequence& numbers : set.sequences) numbers.first += scope, numbers.last += scope;
        for (std::size_t& other : set.others) other += first;
        set.name = joined({name, ".", set.name});
        if (set.is_listed) places.try_emplace(upper(set.name), all.size());
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
  std::optional<Instance> instance_ = {};
  Eigen::Vector3d system_ = Eigen::Vector3d::Zero();
  Allowance copies_;
  std::string title_ = {};
  Skipped skipped_ = {}, ignored_ = {}, values_ = {};
};

}  // namespace detail

/// The mesh of an Abaqus input file (.inp), flat or of parts and instances. Instances are parts; `*ELSET`s serve as
/// parts too; sets within a part are called "instance.set". C3D8, C3D4, S4, S3 and their kinds (C3D8R, ...) are read,
/// and gmsh's CPS4 and CPS3, which are plates unless they lie on solids; elements of other types are ignored with a
/// warning, keywords that do not describe a mesh are skipped with a warning. `name` is the file in messages. Errors:
/// `*INCLUDE` and INPUT=; keywords that make nodes or elements (`*NGEN`, `*ELGEN`, ...); solids or shells of higher
/// order; text in the place of a number; a number given twice; a node, set, part or instance that is not there.
inline Deck read_abaqus(std::string_view text, const std::string& name) {
  return detail::within_memory(name, [&] { return detail::AbaqusReader(detail::Source(text, name)).read(); });
}
inline Deck read_abaqus(const std::string& path) { return read_abaqus(detail::content_of_file(path), path); }

}  // namespace strike
