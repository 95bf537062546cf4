#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/abaqus/file.hpp>
#include <strike/input/abaqus/generate.hpp>
#include <strike/input/abaqus/load_cards.hpp>
#include <strike/input/abaqus/material_cards.hpp>
#include <strike/input/abaqus/model.hpp>
#include <strike/input/abaqus_cards.hpp>
#include <strike/input/deck.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/input/source.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {
namespace detail {

/// The mesh of the keywords that describe one (Abaqus Analysis User's Guide, "Input syntax rules", "Assembly
/// definition").
class AbaqusReader {
 public:
  AbaqusReader(Source source, const ReadOptions& options)
      : file_(std::move(source)), copies_(file_.source()), leave_out_elements_(options.leave_out_elements) {
    all_.raw.second_order = options.second_order;
  }

  AbaqusDeck read() {
    bool any = false;
    while (file_.next_keyword()) any = true, keyword();
    if (!any) file_.refuse({"the file has no keyword: give an Abaqus input file."});
    end_of_instance_before("the end of the file");
    if (model_ != &all_) file_.refuse({"a part has no end: write *END PART after it."});
    if (scopes_.empty() && all_.raw.elements.empty()) place_all_parts();
    resolve_names(all_, file_, copies_);
    expect_all_elements();
    all_.raw.repeats_nodes = true;
    loads_.find_faces(all_, scopes_, copies_);
    Finished mesh = finished(std::move(all_.raw), file_.source());
    AbaqusDeck deck = std::move(cards_);
    static_cast<Deck&>(deck) = std::move(mesh.deck);
    materials_.resolve(deck, loads_.is_adiabatic());
    loads_.resolve(deck, mesh, all_);
    deck.title = std::move(title_);
    for (const auto& [key, part] : parts_)
      if (!part.is_placed && !part.raw.elements.empty())
        told_.push_back(joined({"Part ", shown(part.name), " (elements: ", std::to_string(part.raw.elements.size()),
                                ") has no instance and was dropped: line ", place(part.line), "."}));
    deck.warnings.insert(deck.warnings.end(), told_.begin(), told_.end());
    skipped_.tell(deck.warnings, " was skipped: ", &file_.source());
    ignored_.tell(deck.warnings, " were ignored: ", &file_.source());
    values_.tell(deck.warnings, " had no effect: ", &file_.source());
    return deck;
  }

 private:
  using File = abaqus::File;
  using Model = abaqus::Model;
  using Shape = RawMesh::Shape;

  /// A copy of a part, and what the instance defines itself, translated and then turned.
  struct Instance {
    std::string name;
    Model* part;
    FileNumber scope;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Model own = {};
  };

  std::string place(std::uint32_t line) const { return file_.source().place(line); }

  void keyword() {
    using Names = std::initializer_list<std::string_view>;
    const std::string& word = file_.word();
    const auto is_one_of = [&](Names names) { return std::find(names.begin(), names.end(), word) != names.end(); };
    if (is_one_of({"*NMAP", "*IMPORT", "*SYMMETRICMODELGENERATION", "*SUBSTRUCTUREGENERATE"}))
      file_.refuse({file_.name(),
                    " changes or makes nodes or elements and is not read: write them out with *NODE and "
                    "*ELEMENT."});
    if (is_one_of({"*MANIFEST", "*RESTART", "*MODELCHANGE"}) && (word != "*RESTART" || file_.find("READ")))
      file_.refuse({file_.name(), " makes another deck of this one and is not read: write the deck as it should be."});
    if (is_one_of({"*NODE", "*ELEMENT", "*NSET", "*ELSET", "*PART", "*INSTANCE"}))
      for (const auto& [key, value] : file_.parameters())
        if (std::find(mesh_parameters.begin(), mesh_parameters.end(), key) == mesh_parameters.end())
          values_.add(joined({key.substr(0, 40), " of ", file_.name()}), file_.line());

    abaqus::Generator generate(*model_, file_, copies_);
    if (word == "*HEADING")
      heading();
    else if (word == "*NODE")
      nodes();
    else if (word == "*SYSTEM")
      system();
    else if (word == "*ELEMENT")
      elements();
    else if (word == "*NGEN")
      generate.nodes_between(frame_);
    else if (word == "*NFILL")
      generate.nodes_filled();
    else if (word == "*NCOPY")
      generate.nodes_copied(frame_);
    else if (word == "*ELGEN")
      generate.elements_repeated();
    else if (word == "*ELCOPY")
      generate.elements_copied();
    else if (word == "*NSET")
      set(true, file_.required("NSET"));
    else if (word == "*ELSET")
      set(false, file_.required("ELSET"));
    else if (word == "*PART")
      begin_part(file_.required("NAME"));
    else if (word == "*ENDPART")
      end_part();
    else if (word == "*INSTANCE")
      begin_instance(file_.required("NAME"));
    else if (word == "*ENDINSTANCE")
      end_instance();
    else if (word == "*ENDASSEMBLY")
      end_of_instance_before(file_.name());
    else if (word != "*ASSEMBLY" && word != "*PREPRINT" && !materials_.read(skipped_) && !loads_.read(*model_, cards_))
      skipped_.add(file_.name().substr(0, 60), file_.line());
  }
  static constexpr std::array<std::string_view, 11> mesh_parameters{
      "ELSET", "GENERATE", "INPUT", "INSTANCE", "INTERNAL", "NAME", "NSET", "PART", "SYSTEM", "TYPE", "UNSORTED"};

  void heading() {
    std::string_view line;
    while (file_.raw_data(line))
      if (title_.empty()) title_ = std::string(trimmed(line));
  }

  void nodes() {
    const char system = abaqus::system_of(file_);
    RawMesh::Set* set = nullptr;
    if (const std::string* const name = file_.find("NSET"))
      set = &abaqus::set_of(model_->raw.node_sets, model_->node_sets, abaqus::shown_label(*name), file_.line());
    const std::size_t lines = file_.source().lines_before('*');
    make_room(model_->raw.nodes, lines);
    if (set) make_room(set->sequences, lines);
    std::string_view line;
    while (file_.data(line)) {
      const FileNumber number = file_.next_tag(line, "the number of a node");
      Eigen::Vector3d x;
      for (double& coordinate : x) coordinate = file_.next_number(line, "the coordinate");
      if (system != 'R') x = abaqus::cartesian(x, system);
      model_->raw.nodes.push_back({number, frame_.placed(x), file_.line()});
      if (set) set->sequences.push_back({number, number, 1, file_.line()});
    }
  }

  /// The system of the nodes that follow: its origin, a point of its x axis, and one of its x y plane.
  void system() {
    frame_ = {};
    std::string_view line;
    if (!file_.data(line)) return;
    const auto vector = [&] { return abaqus::vector(line, file_, "a coordinate of the system"); };
    frame_.origin = vector();
    const bool has_axis = !trimmed(line).empty();
    Eigen::Vector3d x = vector();
    const bool has_plane = file_.data(line);
    if (!has_axis || (x.isZero(0) && !has_plane)) {
      if (has_plane) file_.refuse({"the system has a point of its plane and none of its axis: give both."});
      return;
    }
    x -= frame_.origin;
    Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    if (has_plane)
      z = cross(x, Eigen::Vector3d(vector() - frame_.origin));
    else
      x[2] = 0;
    if (!(x.norm() > 0) || !(z.norm() > 0))
      file_.refuse({"the points of the system lie on each other or on a line: give three that do not."});
    frame_.axes.col(0) = x / x.norm();
    frame_.axes.col(2) = z / z.norm();
    frame_.axes.col(1) = cross<double>(frame_.axes.col(2), frame_.axes.col(0));
    frame_.turns = true;
  }

  static bool begins_with_one_of(std::string_view type, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](auto b) { return type.substr(0, b.size()) == b; });
  }
  void elements() {
    const std::string type = upper(file_.required("TYPE"));
    RawMesh::Element element{0, {}, 0, 0, Shape::hexahedron};
    if (begins_with_one_of(type, {"SC6", "SC8"}))
      file_.refuse({"elements of type ", shown(type), " are not read: mesh with C3D8, C3D6, C3D5, C3D4, S4 or S3."});
    second_order_type(type, element);
    if (element.second != SecondOrderKind::none) {
      if (all_.raw.second_order == SecondOrder::refused)
        file_.refuse({"elements of type ", shown(type), " are of second order: ", cut_them, "."});
    } else if (begins_with_one_of(type, {"C3D8"}))
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
    if (const std::string* const name = file_.find("ELSET"))
      set = &abaqus::set_of(raw.element_sets, model_->element_sets, abaqus::shown_label(*name), file_.line());
    const std::size_t lines = file_.source().lines_before('*');
    make_room(raw.elements, lines);
    if (set) make_room(set->sequences, lines);
    std::string_view line;
    while (file_.data(line)) {
      element.number = file_.next_tag(line, "the number of an element");
      element.line = file_.line();
      const std::size_t corners = corner_count(element.shape);
      const auto next = [&](std::size_t i, std::string_view meaning, std::size_t count) {
        if (is_blank(line) && !file_.data(line))
          file_.refuse({"element ", std::to_string(element.number), " of type ", type, " has ", std::to_string(i), " ",
                        meaning.substr(2), "s of ", std::to_string(count), ": give them all."});
        return file_.next_tag(line, meaning);
      };
      for (std::size_t i = 0; i < corners; ++i) element.corners[i] = next(i, "a corner", corners);
      if (element.second != SecondOrderKind::none) {
        std::array<FileNumber, 19> mids;
        const std::span<const std::uint8_t> order = order_of_mids(element.second);
        for (std::size_t i = 0; i < order.size(); ++i) mids[order[i]] = next(i, "a mid node", order.size());
        raw.set_mids(element, std::span(mids).first(order.size()));
      }
      if (!is_blank(line))
        file_.refuse({"element ", std::to_string(element.number), " has too many corners for its type ", type,
                      ": correct the line or the type."});
      raw.elements.push_back(element);
      if (set) set->sequences.push_back({element.number, element.number, 1, element.line});
    }
  }
  /// The shape of a type of second order.
  static void second_order_type(std::string_view type, RawMesh::Element& element) {
    using Kind = SecondOrderKind;
    struct Type {
      std::string_view beginning;
      Shape shape;
      Kind kind;
    };
    constexpr std::array<Type, 11> types{{{"C3D10", Shape::tetrahedron, Kind::tetrahedron10},
                                          {"C3D13", Shape::pyramid, Kind::pyramid13},
                                          {"C3D15V", Shape::wedge, Kind::wedge18},
                                          {"C3D15", Shape::wedge, Kind::wedge15},
                                          {"C3D20", Shape::hexahedron, Kind::hexahedron20},
                                          {"C3D27", Shape::hexahedron, Kind::hexahedron27},
                                          {"S8", Shape::quadrilateral, Kind::quadrilateral8},
                                          {"S9", Shape::quadrilateral, Kind::quadrilateral9},
                                          {"STRI65", Shape::triangle, Kind::triangle6},
                                          {"CPS6", Shape::triangle, Kind::triangle6},
                                          {"CPS8", Shape::quadrilateral, Kind::quadrilateral8}}};
    for (const auto& [beginning, shape, kind] : types)
      if (type.starts_with(beginning)) {
        element.shape = shape, element.second = kind;
        return;
      }
  }
  /// Of each mid node in the order of Abaqus, its place in that of `mid_nodes`: the centre of a hexahedron stands
  /// before the middles of its faces (Abaqus Analysis User's Guide, "Three-dimensional solid element library").
  static std::span<const std::uint8_t> order_of_mids(SecondOrderKind kind) {
    static constexpr std::array<std::uint8_t, 19> as_they_are{0,  1,  2,  3,  4,  5,  6,  7,  8, 9,
                                                              10, 11, 12, 13, 14, 15, 16, 17, 18};
    static constexpr std::array<std::uint8_t, 19> of_27{0,  1,  2,  3,  4,  5,  6,  7,  8, 9,
                                                        10, 11, 18, 12, 13, 14, 15, 16, 17};
    return std::span(kind == SecondOrderKind::hexahedron27 ? of_27 : as_they_are).first(mid_nodes(kind).size());
  }
  /// Elements of a type that is not read; gmsh writes trusses for lines of the geometry.
  void ignore(const std::string& type) {
    std::string_view line;
    bool goes_on = false;
    std::size_t count = 0;
    const std::uint32_t at = file_.line();
    while (file_.data(line)) {
      const bool is_new = !goes_on;
      goes_on = trimmed(line).back() == ',';
      if (!is_new) continue;
      ++count;
      model_->raw.ignored_elements.push_back(file_.tag(taken(line, ','), "the number of an element"));
      ignored_.add(joined({"Elements of type ", type.substr(0, 40)}), file_.line());
    }
    const bool is_line_of_gmsh = file_.is_of_gmsh() && (type == "T3D2" || type == "T3D3");
    if (count > 0 && !is_line_of_gmsh) model_->left_out.push_back({type.substr(0, 40), count, at});
    if (const std::string* const name = file_.find("ELSET");
        name && !model_->element_sets.contains(abaqus::label(*name)))
      abaqus::set_of(model_->raw.element_sets, model_->element_sets, abaqus::shown_label(*name), at).is_listed =
          false;  // others may name it
  }
  void expect_all_elements() const {
    if (leave_out_elements_ || all_.left_out.empty()) return;
    const abaqus::LeftOut& first = all_.left_out.front();
    std::size_t count = 0;
    for (const abaqus::LeftOut& left : all_.left_out)
      if (left.type == first.type) count += left.count;
    file_.refuse(first.line, {"elements of type ", first.type, " (", std::to_string(count),
                              ") are of a kind that is not read: take them out of the deck, or leave them out with "
                              "{.leave_out_elements = true}."});
  }

  void set(bool of_nodes, const std::string& name) {
    using abaqus::field;
    auto& sets = of_nodes ? model_->raw.node_sets : model_->raw.element_sets;
    auto& places = of_nodes ? model_->node_sets : model_->element_sets;
    FileNumber scope = 0;
    std::string prefix;
    if (const std::string* const instance = file_.find("INSTANCE"))
      scope = scope_of(*instance), prefix = joined({abaqus::label(*instance), "."});
    abaqus::set_of(sets, places, name, file_.line());
    if (of_nodes && file_.find("UNSORTED")) model_->unsorted.insert(abaqus::label(name));
    std::size_t& self = places.find(abaqus::label(name))->second;
    if (of_nodes && file_.find("ELSET")) {
      model_->nodes_of_elements.push_back(
          {abaqus::label(name), prefix, file_.label_of("ELSET"), file_.required("ELSET"), file_.line()});
      return;
    }
    std::string_view line;
    while (file_.data(line)) {
      const std::uint32_t at = file_.line();
      if (file_.find("GENERATE")) {
        const FileNumber first = file_.tag(field(line), "the first of a range"),
                         last = file_.tag(field(line), "the last of a range");
        const std::string_view step = field(line);
        if (first > last)
          file_.refuse({"the range from ", std::to_string(first), " to ", std::to_string(last),
                        " is empty: give the smaller number first."});
        if (!trimmed(line).empty()) file_.refuse({"a range has more than three numbers: give each its own line."});
        sets[self].sequences.push_back(
            {scope + first, scope + last, step.empty() ? 1 : file_.tag(step, "the step of a range"), at});
        continue;
      }
      while (!line.empty()) {
        std::string_view item = field(line);
        if (item.empty()) continue;
        FileNumber own_scope = scope;
        if (const std::size_t dot = item.rfind('.'); dot != item.npos && to_integer(item.substr(dot + 1)))
          if (const auto instance = scopes_.find(abaqus::label(item.substr(0, dot))); instance != scopes_.end())
            own_scope = instance->second, item = item.substr(dot + 1);
        if (to_integer(item)) {
          const FileNumber number = own_scope + file_.tag(item, "a number of a set");
          sets[self].sequences.push_back({number, number, 1, at});
          continue;
        }
        const auto other = places.find(prefix + abaqus::label(item));
        if (other == places.end()) {
          model_->late.push_back({of_nodes, self, prefix, abaqus::label(item), abaqus::shown_label(item), at});
          continue;
        }
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
    const auto found = scopes_.find(abaqus::label(instance));
    if (found == scopes_.end())
      file_.refuse({"instance ", shown(instance), " is not in the file: define it before its sets."});
    return found->second;
  }

  void begin_part(const std::string& name) {
    if (model_ != &all_) file_.refuse({"a part begins within a part: write *END PART before it."});
    end_of_instance_before("a part");
    const auto [part, is_new] = parts_.try_emplace(abaqus::label(name));
    if (!is_new) file_.refuse({"part ", shown(name), " is there twice: give each a name of its own."});
    model_ = &part->second;
    model_->name = name, model_->line = file_.keyword_line();
    frame_ = {};
  }
  void end_part() {
    if (model_ == &all_ || instance_) file_.refuse({"no part ends here: write *PART before it."});
    resolve_names(*model_, file_, copies_);
    model_ = &all_, frame_ = {};
  }

  FileNumber new_scope(const std::string& name) {
    const FileNumber scope = RawMesh::scope * static_cast<FileNumber>(scopes_.size() + 1);
    if (!scopes_.try_emplace(abaqus::label(name), scope).second)
      file_.refuse({"instance ", shown(name), " is there twice: give each a name of its own."});
    if (scopes_.size() > 1000000) file_.refuse({"there are more than a million instances: merge some."});
    return scope;
  }
  void begin_instance(const std::string& name) {
    if (file_.find("INSTANCE"))
      file_.refuse({"an instance of an earlier analysis is not read: give its part with PART=..."});
    const std::string part_name = file_.required("PART");
    end_of_instance_before("the next one");
    if (model_ != &all_) file_.refuse({"an instance begins within a part: write *END PART before it."});
    const auto part = parts_.find(abaqus::label(part_name));
    if (part == parts_.end())
      file_.refuse({"part ", shown(part_name), " is not in the file: define it before its instances."});
    instance_ = Instance{.name = name, .part = &part->second, .scope = new_scope(name)};
    std::string_view line;
    const auto vector = [&] { return abaqus::vector(line, file_, "a coordinate of the instance"); };
    if (file_.data(line)) instance_->shift = vector();
    if (file_.data(line)) {
      instance_->centre = vector();
      const Eigen::Vector3d axis = vector() - instance_->centre;
      const double length = axis.norm(), angle = file_.number(taken(line, ','), "the angle") * std::numbers::pi / 180;
      if (!(length > 0)) file_.refuse({"the axis of the instance has no length: give two different points."});
      instance_->turn = abaqus::rotation(axis / length, angle);
    }
    model_ = &instance_->own;
    frame_ = {};
  }
  void end_of_instance_before(std::string_view next) const {
    if (instance_)
      file_.refuse({"instance ", shown(instance_->name), " has no end: write *END INSTANCE before ", next, "."});
  }
  void end_instance() {
    if (!instance_) file_.refuse({"no instance ends here: write *INSTANCE before it."});
    resolve_names(instance_->own, file_, copies_);
    place_instance();
    model_ = &all_;
    frame_ = {};
  }
  void place_instance() {
    const auto part = static_cast<std::uint32_t>(all_.raw.parts.size());
    all_.raw.parts.push_back({0, instance_->name, {}});
    all_.raw.groups.push_back({part});
    instance_->part->is_placed = true;
    place(*instance_->part), place(instance_->own);
    instance_.reset();
  }
  /// Parts of a file without any instance, and without a mesh outside of parts.
  void place_all_parts() {
    for (auto& [key, part] : parts_) {
      if (part.raw.elements.empty()) continue;
      instance_ = Instance{.name = part.name, .part = &part, .scope = new_scope(part.name)};
      place_instance();
      told_.push_back(joined(
          {"Part ", shown(part.name), " has no instance and was placed as it is: line ", place(part.line), "."}));
    }
  }
  /// Copies a mesh to the last part.
  void place(const Model& model) {
    const RawMesh& from = model.raw;
    const std::string& name = instance_->name;
    const FileNumber scope = instance_->scope;
    const bool turns = !instance_->turn.isIdentity(0);
    RawMesh& to = all_.raw;
    std::size_t count = from.nodes.size() + from.elements.size() + from.ignored_elements.size() + from.mid_nodes.size();
    for (const auto* sets : {&from.node_sets, &from.element_sets})
      for (const RawMesh::Set& set : *sets)
        count += 4 + set.sequences.size() + set.others.size() + (name.size() + set.name.size()) / 16;
    count += 8 * (model.sections.size() + model.surfaces.size());
    for (const abaqus::PendingSurface& surface : model.surfaces) count += 4 * surface.lines.size();
    copies_.take(count, file_.line());
    const auto scoped = [&](const std::string& of_part) { return joined({name, ".", of_part}); };
    for (abaqus::PendingSection section : model.sections) {
      section.set = scoped(section.set);
      all_.sections.push_back(std::move(section));
    }
    for (abaqus::PendingSurface surface : model.surfaces) {
      surface.name = scoped(surface.name);
      for (abaqus::SurfaceLine& line : surface.lines) line.where = scoped(line.where);
      all_.surfaces.push_back(std::move(surface));
    }
    all_.left_out.insert(all_.left_out.end(), model.left_out.begin(), model.left_out.end());
    for (RawMesh::Node node : from.nodes) {
      node.number += scope;
      node.x += instance_->shift;
      if (turns) node.x = instance_->centre + instance_->turn * (node.x - instance_->centre);
      to.nodes.push_back(node);
    }
    for (RawMesh::Element element : from.elements) {
      element.number += scope;
      for (FileNumber& corner : element.corners) corner += scope;
      if (element.second != SecondOrderKind::none) to.set_mids(element, from.mids_of(element), scope);
      element.group = static_cast<std::uint32_t>(to.groups.size() - 1);
      to.elements.push_back(element);
    }
    for (const FileNumber number : from.ignored_elements) to.ignored_elements.push_back(number + scope);
    const auto copy = [&](const std::vector<RawMesh::Set>& sets, const abaqus::SetPlaces& places,
                          std::vector<RawMesh::Set>& all, abaqus::SetPlaces& all_places) {
      const std::size_t first = all.size();
      for (const auto& [key, set] : places)
        all_places.try_emplace(joined({abaqus::label(name), ".", key}), first + set);
      for (RawMesh::Set set : sets) {
        for (RawMesh::Sequence& numbers : set.sequences) numbers.first += scope, numbers.last += scope;
        for (std::size_t& other : set.others) other += first;
        set.name = joined({name, ".", set.name});
        all.push_back(std::move(set));
      }
    };
    copy(from.node_sets, model.node_sets, to.node_sets, all_.node_sets);
    copy(from.element_sets, model.element_sets, to.element_sets, all_.element_sets);
  }

  File file_;
  Model all_ = {};
  Model* model_ = &all_;
  std::map<std::string, Model> parts_ = {};
  std::map<std::string, FileNumber> scopes_ = {};
  std::optional<Instance> instance_ = {};
  abaqus::Frame frame_ = {};
  Allowance copies_;
  bool leave_out_elements_;
  std::string title_ = {};
  std::vector<std::string> told_ = {};
  Skipped skipped_ = {}, ignored_ = {}, values_ = {};
  AbaqusDeck cards_ = {};
  abaqus::MaterialCards materials_{file_};
  abaqus::LoadCards loads_{file_, skipped_, values_};
};

}  // namespace detail

/// The mesh and the cards of an Abaqus input file (.inp), flat or of parts and instances. Instances are parts;
/// `*ELSET`s serve as parts too; sets within a part are called "instance.set". C3D8, C3D6, C3D5, C3D4, S4, S3
/// and their kinds (C3D8R, ...) are read, and gmsh's CPS4 and CPS3, which are plates unless they lie on solids;
/// keywords that are not read are skipped with a warning. `name` is the file in messages. Included files are read below
/// the folder of the deck. Errors: a file that is not there, or elsewhere; keywords that change the mesh and are not
/// read (`*NMAP`, ...); elements of other types, unless `leave_out_elements`; solids or shells of second order,
/// unless `second_order` cuts them; text in the place of a number; a number given twice; a node, set, part or instance
/// that is not there.
inline AbaqusDeck read_abaqus(std::string_view text, const std::string& name, const ReadOptions& options = {}) {
  return detail::within_memory(
      name, [&] { return detail::AbaqusReader(detail::Source(text, name, options), options).read(); });
}
inline AbaqusDeck read_abaqus(const std::string& path, ReadOptions options = {}) {
  if (options.folder.empty()) options.folder = detail::folder_of(path);
  return read_abaqus(detail::content_of_file(path), path, options);
}

}  // namespace strike
