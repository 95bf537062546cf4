#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/input/abaqus/file.hpp>
#include <strike/input/abaqus/model.hpp>
#include <strike/input/abaqus_cards.hpp>
#include <strike/input/raw_mesh.hpp>

// Sections, supports, loads, surfaces and contact (Abaqus Analysis User's Guide, "Prescribed conditions",
// "Interactions").
namespace strike::detail::abaqus {

using Segment = std::array<FileNumber, 4>;

/// Corners of the faces of elements, from 0, so that their normals look outward.
inline constexpr std::array<std::array<std::size_t, 4>, 6> faces_of_hexahedron{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
inline constexpr std::array<std::array<std::size_t, 4>, 4> faces_of_tetrahedron{
    {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}}};
inline constexpr std::array<std::array<std::size_t, 4>, 5> faces_of_wedge{
    {{0, 2, 1, 1}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
inline constexpr std::array<std::array<std::size_t, 4>, 5> faces_of_pyramid{
    {{0, 3, 2, 1}, {0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}}};
/// The faces of a solid; none of a plate.
constexpr std::span<const std::array<std::size_t, 4>> faces_of(RawMesh::Shape shape) {
  switch (shape) {
    case RawMesh::Shape::hexahedron:
      return faces_of_hexahedron;
    case RawMesh::Shape::tetrahedron:
      return faces_of_tetrahedron;
    case RawMesh::Shape::wedge:
      return faces_of_wedge;
    case RawMesh::Shape::pyramid:
      return faces_of_pyramid;
    default:
      return {};
  }
}

/// *BOUNDARY, *CLOAD or *INITIAL CONDITIONS of nodes.
struct NodeLine {
  std::string nodes;  ///< a number or the name of a set, perhaps of an instance
  std::uint32_t line;
};
struct PendingSupport {
  NodeLine where;
  std::array<bool, 6> held;
};
struct PendingMotion {
  NodeLine where;
  std::size_t direction;  ///< 0 to 2 along x, y, z, 3 to 5 about them
  MotionCard::Kind kind;
  double value;
  std::string amplitude;
};
struct PendingForce {
  NodeLine where;
  std::size_t direction;
  double value;
  std::string amplitude;
};
struct PendingVelocity {
  NodeLine where;
  std::size_t direction;
  double value;
};
struct PendingPressure {
  std::string where;  ///< a set of elements, or a surface
  bool is_surface;
  std::string face;
  double value;
  std::string amplitude;
  std::uint32_t line;
};
struct PendingContact {
  std::string kind, slave, master, interaction;
  std::uint32_t line;
};
struct Friction {
  double static_friction = 0, dynamic_friction = 0, decay = 0;
};

class LoadCards {
 public:
  LoadCards(File& file, Skipped& skipped, Skipped& values) : file_(file), skipped_(skipped), values_(values) {}

  bool is_adiabatic() const { return is_adiabatic_; }

  /// True if the keyword is one of these cards, or belongs to a further step.
  bool read(Model& model, AbaqusDeck& deck) {
    const std::string& word = file_.word();
    if (word == "*STEP") {
      ++steps_;
      return true;
    }
    if (word == "*ENDSTEP") return true;
    if (steps_ > 1) {
      skipped_.add(joined({file_.name().substr(0, 60), " of a further step"}), file_.keyword_line());
      return true;
    }
    if (word == "*SOLIDSECTION")
      solid_section(model);
    else if (word == "*SHELLSECTION")
      shell_section(model);
    else if (word == "*SURFACE")
      surface(model);
    else if (word == "*BOUNDARY")
      boundary();
    else if (word == "*AMPLITUDE")
      amplitude(deck);
    else if (word == "*INITIALCONDITIONS")
      initial_conditions();
    else if (word == "*CLOAD")
      forces();
    else if (word == "*DLOAD" || word == "*DSLOAD")
      distributed(word == "*DSLOAD", deck);
    else if (word == "*SURFACEINTERACTION")
      interaction_ = label(file_.required("NAME")), frictions_.try_emplace(interaction_);
    else if (word == "*FRICTION")
      friction();
    else if (word == "*CONTACTPAIR")
      contact_pairs();
    else if (word == "*CONTACT")
      interaction_.clear();
    else if (word == "*CONTACTINCLUSIONS")
      contact_inclusions();
    else if (word == "*CONTACTPROPERTYASSIGNMENT")
      contact_properties();
    else if (word == "*DYNAMIC")
      dynamic(deck);
    else if (word == "*BULKVISCOSITY")
      bulk_viscosity(deck);
    else
      return false;
    return true;
  }

  /// Faces of surfaces and loads by the numbers of the file: before the mesh is finished.
  void find_faces(Model& all, const std::map<std::string, FileNumber>& scopes, Allowance& allowance) {
    scopes_ = &scopes;
    for (std::size_t i = 0; i < all.surfaces.size(); ++i)
      if (!surface_places_.try_emplace(squeezed(all.surfaces[i].name), i).second)
        file_.refuse(all.surfaces[i].line,
                     {"the surface ", shown(all.surfaces[i].name), " is there twice: give each a name of its own."});
    for (PendingSurface& surface : all.surfaces) {
      if (surface.is_of_nodes) continue;
      for (const SurfaceLine& line : surface.lines)
        add_faces(all, allowance, line.where, line.face, line.line, surface.segments);
    }
    for (const PendingPressure& load : pressures_) {
      std::vector<Segment> segments;
      if (load.is_surface) {
        if (const auto place = surface_places_.find(squeezed(load.where)); place != surface_places_.end())
          segments = all.surfaces[place->second].segments;
        if (segments.empty())
          file_.refuse(load.line,
                       {"the surface ", shown(load.where), " has no faces, or is not in the file: define it."});
        allowance.take(segments.size(), load.line);
      } else {
        add_faces(all, allowance, load.where, load.face == "P" ? "SNEG" : "S" + load.face.substr(1), load.line,
                  segments);
      }
      faces_.push_back(std::move(segments));
    }
  }

  /// The cards, of the nodes of the finished mesh.
  void resolve(AbaqusDeck& deck, Finished& mesh, const Model& all) {
    std::map<std::string, const NamedSet*> sets;
    for (const NamedSet& set : deck.node_sets) sets.try_emplace(squeezed(set.name), &set);
    const auto nodes = [&](const NodeLine& where) {
      if (const auto set = sets.find(squeezed(where.nodes)); set != sets.end()) {
        mesh.allowance.take(1 + set->second->members.size(), where.line);
        return set->second->members;
      }
      const auto number = number_of(where.nodes);
      if (!number)
        file_.refuse(where.line, {"the set of nodes ", shown(where.nodes), " is not in the file: define it."});
      const Index node = mesh.node(*number, file_.source(), where.line);
      return node == nothing ? std::vector<Index>{} : std::vector<Index>{node};
    };
    const auto segments = [&](const std::vector<Segment>& from, std::uint32_t line) {
      std::vector<std::array<Index, 4>> result;
      mesh.allowance.take(from.size(), line);
      for (const Segment& segment : from) {
        std::array<Index, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.node(segment[i], file_.source(), line);
        if (std::find(corners.begin(), corners.end(), nothing) == corners.end())
          mesh.cut_faces.add_segment(corners, result);
      }
      return result;
    };

    std::map<std::string, const std::string*> names;
    for (const NamedSet& set : deck.cell_sets) names.try_emplace(squeezed(set.name), &set.name);
    for (const PendingSection& section : all.sections) {
      if (!all.element_sets.contains(label(section.set)))
        file_.refuse(section.line, {"the set of elements ", shown(section.set), " is not in the file: define it."});
      const auto name = names.find(squeezed(section.set));
      deck.sections.push_back({name == names.end() ? section.set : *name->second, section.material, section.section});
    }
    for (const auto& [where, held] : supports_)
      deck.supports.push_back({nodes(where), {held[0], held[1], held[2]}, {held[3], held[4], held[5]}});
    for (const auto& [where, direction, kind, value, amplitude] : motions_)
      deck.motions.push_back({nodes(where), axis(direction), direction > 2, kind, value, amplitude});
    for (const auto& [where, direction, value, amplitude] : forces_) {
      if (const auto set = sets.find(squeezed(where.nodes)); set != sets.end())
        mesh.expect_forces(0, set->second->name, file_.source(), where.line);
      else if (const auto number = number_of(where.nodes))
        mesh.expect_force(*number, file_.source(), where.line);
      deck.forces.push_back({nodes(where), value * axis(direction), amplitude});
    }
    add_velocities(deck, nodes);
    for (std::size_t i = 0; i < pressures_.size(); ++i)
      deck.pressures.push_back({segments(faces_[i], pressures_[i].line), pressures_[i].value, pressures_[i].amplitude});
    for (const PendingSurface& surface : all.surfaces) {
      SurfaceCard card{surface.name, {.segments = segments(surface.segments, surface.line)}};
      if (surface.is_of_nodes)
        for (const SurfaceLine& line : surface.lines) {
          const auto more = nodes({line.where, line.line});
          card.side.nodes.insert(card.side.nodes.end(), more.begin(), more.end());
        }
      card.side.nodes = ascending(std::move(card.side.nodes));
      deck.surfaces.push_back(std::move(card));
    }
    for (const PendingContact& contact : contacts_) add_contact(deck, mesh, contact);
    for (const auto& [amplitude, line] : used_amplitudes_)
      if (!amplitudes_.contains(label(amplitude)) && !unread_amplitudes_.contains(label(amplitude)))
        file_.refuse(line, {"the amplitude ", shown(amplitude), " is not in the file: define it with *AMPLITUDE."});
  }

 private:
  static Eigen::Vector3d axis(std::size_t direction) {
    return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(direction % 3));
  }
  static std::string squeezed(std::string_view name) {
    std::string result;
    for (const char c : name)
      if (!is_blank(c) && c != '"') result += upper(c);
    return result;
  }
  /// The number of a node or an element, "7" or "instance.7".
  std::optional<FileNumber> number_of(std::string_view text) const {
    FileNumber scope = 0;
    if (const std::size_t dot = text.rfind('.'); dot != text.npos && dot + 1 < text.size())
      if (const auto instance = scopes_->find(label(text.substr(0, dot))); instance != scopes_->end())
        scope = instance->second, text.remove_prefix(dot + 1);
    const auto number = to_integer(text);
    if (!number || *number < 1 || *number >= number_limit) return std::nullopt;
    return scope + *number;
  }
  std::string amplitude_of_load() {
    const std::string* const name = file_.find("AMPLITUDE");
    if (!name) return {};
    used_amplitudes_.try_emplace(shown_label(*name), file_.keyword_line());
    return shown_label(*name);
  }
  void ignore(std::string_view what) { values_.add(joined({what, " of ", file_.name().substr(0, 60)}), file_.line()); }
  /// Lists parameters of the keyword other than those that are read.
  void ignore_others(std::initializer_list<std::string_view> read) {
    for (const auto& [key, value] : file_.parameters())
      if (std::find(read.begin(), read.end(), key) == read.end()) ignore(key.substr(0, 40));
  }

  void solid_section(Model& model) {
    ignore_others({"ELSET", "MATERIAL"});
    model.sections.push_back({file_.required("ELSET"), file_.required("MATERIAL"), {}, file_.keyword_line()});
    model.sections.back().section.points = 0;
  }
  void shell_section(Model& model) {
    if (file_.find("COMPOSITE")) {
      skipped_.add("*SHELL SECTION, COMPOSITE", file_.keyword_line());
      return;
    }
    ignore_others({"ELSET", "MATERIAL", "OFFSET"});
    PendingSection section{file_.required("ELSET"), file_.required("MATERIAL"), {}, file_.keyword_line()};
    const std::string offset = file_.label_of("OFFSET");
    if (!offset.empty() && offset != "MIDDLESURFACE")
      section.section.reference = offset == "SPOS" ? 1 : offset == "SNEG" ? -1 : 2 * file_.number(offset, "OFFSET");
    std::string_view line;
    if (!file_.data(line)) file_.refuse({"*SHELL SECTION has no data: give the thickness on the line after it."});
    section.section.thickness = file_.number(field(line), "the thickness");
    if (!(section.section.thickness > 0)) file_.refuse({"the thickness is not positive: correct it."});
    section.section.corner_thickness.fill(section.section.thickness);
    section.section.points = file_.tag_or(field(line), 5, "the number of points");
    section.section.shear_factor = 5.0 / 6;
    model.sections.push_back(std::move(section));
  }

  void surface(Model& model) {
    const std::string type = file_.label_of("TYPE");
    if (!type.empty() && type != "ELEMENT" && type != "NODE") {
      skipped_.add(joined({"*SURFACE, TYPE=", type.substr(0, 40)}), file_.keyword_line());
      return;
    }
    if (file_.find("COMBINE")) {
      skipped_.add("*SURFACE, COMBINE", file_.keyword_line());
      return;
    }
    ignore_others({"NAME", "TYPE", "INTERNAL"});
    PendingSurface surface{file_.required("NAME"), type == "NODE", {}, {}, file_.keyword_line()};
    std::string_view line;
    while (file_.data(line)) {
      const std::string where(field(line));
      const std::string face = label(field(line));
      surface.lines.push_back({where, surface.is_of_nodes ? "" : face, file_.line()});
    }
    model.surfaces.push_back(std::move(surface));
  }
  /// Faces of elements: of one place (S1 to S6, SPOS, SNEG), or the free ones.
  void add_faces(Model& all, Allowance& allowance, const std::string& where, const std::string& face,
                 std::uint32_t line, std::vector<Segment>& to) {
    std::vector<FileNumber> numbers;
    const auto& known = all.element_places();
    if (const auto set = all.element_sets.find(label(where)); set != all.element_sets.end())
      numbers = members(all.raw.element_sets, set->second, known, allowance, line);
    else if (const auto number = number_of(where); number && known.contains(*number))
      numbers = {*number};
    else
      file_.refuse(line, {"the set of elements ", shown(where), " is not in the file: define it."});
    const bool is_plate_face = face == "SPOS" || face == "SNEG";
    const std::size_t place = face.size() == 2 && face[0] == 'S' && face[1] >= '1' && face[1] <= '6'
                                  ? static_cast<std::size_t>(face[1] - '1')
                                  : 6;
    if (!face.empty() && !is_plate_face && place == 6)
      file_.refuse(line, {"the face ", shown(face), " is none of S1 to S6, SPOS and SNEG: correct it."});
    for (const FileNumber number : numbers) {
      const RawMesh::Element& element = all.raw.elements[known.at(number)];
      const bool is_plate = element.shape == RawMesh::Shape::triangle || element.shape == RawMesh::Shape::quadrilateral;
      const auto& c = element.corners;
      if (is_plate) {
        const FileNumber last = element.shape == RawMesh::Shape::triangle ? c[2] : c[3];
        if (!face.empty() && !is_plate_face && place > 1)
          file_.refuse(line, {"element ", std::to_string(number % RawMesh::scope), " has no face ", face,
                              " as it is a shell: give SPOS or SNEG."});
        const bool turned = face == "SNEG" || place == 1;
        to.push_back(!turned ? Segment{c[0], c[1], c[2], last}
                             : (last == c[2] ? Segment{c[0], c[2], c[1], c[1]} : Segment{c[0], last, c[2], c[1]}));
        allowance.take(1, line);
        continue;
      }
      const std::size_t count = faces_of(element.shape).size();
      if (is_plate_face || (!face.empty() && place >= count))
        file_.refuse(line, {"element ", std::to_string(number % RawMesh::scope), " has no face ", face,
                            ": give one of S1 to S", std::to_string(count), "."});
      for (std::size_t f = 0; f < count; ++f)
        if (face.empty() ? is_free(all, allowance, element, f, line) : f == place) {
          to.push_back(face_of(element, f));
          allowance.take(1, line);
        }
    }
  }
  static Segment face_of(const RawMesh::Element& element, std::size_t face) {
    const auto& corners = faces_of(element.shape)[face];
    Segment segment;
    for (std::size_t i = 0; i < 4; ++i) segment[i] = element.corners[corners[i]];
    return segment;
  }
  bool is_free(const Model& all, Allowance& allowance, const RawMesh::Element& element, std::size_t face,
               std::uint32_t line) {
    const auto key = [](Segment segment) {
      std::sort(segment.begin(), segment.end());
      return segment;
    };
    if (!has_faces_) {
      has_faces_ = true;
      for (const RawMesh::Element& solid : all.raw.elements) {
        const std::size_t count = faces_of(solid.shape).size();
        allowance.take(count, line);
        for (std::size_t f = 0; f < count; ++f) all_faces_.push_back(key(face_of(solid, f)));
      }
      std::sort(all_faces_.begin(), all_faces_.end());
    }
    const auto [first, last] = std::equal_range(all_faces_.begin(), all_faces_.end(), key(face_of(element, face)));
    return last - first == 1;
  }

  void boundary() {
    static constexpr std::array<std::pair<std::string_view, std::array<bool, 6>>, 8> kinds{
        {{"XSYMM", {true, false, false, false, true, true}},
         {"YSYMM", {false, true, false, true, false, true}},
         {"ZSYMM", {false, false, true, true, true, false}},
         {"XASYMM", {false, true, true, true, false, false}},
         {"YASYMM", {true, false, true, false, true, false}},
         {"ZASYMM", {true, true, false, false, false, true}},
         {"PINNED", {true, true, true, false, false, false}},
         {"ENCASTRE", {true, true, true, true, true, true}}}};
    if (file_.find("USER") || file_.find("SUBMODEL")) {
      skipped_.add("*BOUNDARY with USER or SUBMODEL", file_.keyword_line());
      return;
    }
    ignore_others({"AMPLITUDE", "TYPE", "FIXED", "OP"});
    if (file_.label_of("OP") == "NEW" && !supports_.empty()) ignore("OP=NEW");
    const std::string type = file_.label_of("TYPE");
    if (!type.empty() && type != "DISPLACEMENT" && type != "VELOCITY" && type != "ACCELERATION")
      file_.refuse({"the type of *BOUNDARY is ", shown(type), ": give DISPLACEMENT, VELOCITY or ACCELERATION."});
    const auto kind = type == "VELOCITY"       ? MotionCard::Kind::velocity
                      : type == "ACCELERATION" ? MotionCard::Kind::acceleration
                                               : MotionCard::Kind::displacement;
    const std::string amplitude = amplitude_of_load();
    std::string_view line;
    while (file_.data(line)) {
      const NodeLine where{std::string(field(line)), file_.line()};
      const std::string_view first = field(line);
      if (!first.empty() && !to_integer(first)) {
        const std::string name = label(first);
        const auto* const known =
            std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == name; });
        if (known == kinds.end())
          file_.refuse({"the boundary condition ", shown(first),
                        " is not known: give ENCASTRE, PINNED, XSYMM, ... or "
                        "degrees of freedom."});
        supports_.push_back({where, known->second});
        continue;
      }
      const FileNumber from = file_.tag(first, "the first degree of freedom");
      const FileNumber to = file_.tag_or(field(line), from, "the last degree of freedom");
      if (from > to) file_.refuse({"the degrees of freedom end before they begin: give the smaller one first."});
      if (to > 6) {
        ignore("degrees of freedom above 6");
        if (from > 6) continue;
      }
      const double value = file_.number_or(field(line), 0, "the magnitude");
      const FileNumber last = std::min<FileNumber>(to, 6);
      if (value == 0 || file_.find("FIXED")) {
        PendingSupport support{where, {}};
        for (FileNumber i = from; i <= last; ++i) support.held[static_cast<std::size_t>(i - 1)] = true;
        supports_.push_back(support);
      } else {
        for (FileNumber i = from; i <= last; ++i)
          motions_.push_back({where, static_cast<std::size_t>(i - 1), kind, value, amplitude});
      }
    }
  }
  void amplitude(AbaqusDeck& deck) {
    const std::string definition = file_.label_of("DEFINITION"), name = file_.required("NAME");
    const auto pass = [&](std::string_view why) {
      unread_amplitudes_.insert(label(name));
      skipped_.add(joined({"*AMPLITUDE with ", why}), file_.keyword_line());
    };
    if (!definition.empty() && !definition.starts_with("TAB"))
      return pass(joined({"DEFINITION=", definition.substr(0, 40)}));
    if (file_.label_of("VALUE") == "ABSOLUTE") return pass("VALUE=ABSOLUTE");
    ignore_others({"NAME", "DEFINITION", "VALUE", "TIME", "INPUT"});
    CurveCard curve{.number = 0, .title = name, .points = {}};
    std::string_view line;
    while (file_.data(line))
      while (!trimmed(line).empty()) {
        const double time = file_.number_or(field(line), 0, "the time");
        curve.points.push_back({time, file_.number_or(field(line), 0, "the amplitude")});
        if (curve.points.size() > 1 && curve.points[curve.points.size() - 2][0] > time)
          file_.refuse({"the times of the amplitude ", shown(name), " fall: sort its points by time."});
      }
    if (curve.points.empty()) file_.refuse({"the amplitude ", shown(name), " has no points: give them after it."});
    if (!amplitudes_.insert(label(name)).second)
      file_.refuse({"the amplitude ", shown(name), " is there twice: give each a name of its own."});
    deck.curves.push_back(std::move(curve));
  }
  void initial_conditions() {
    const std::string type = file_.label_of("TYPE");
    if (type != "VELOCITY") {
      skipped_.add(joined({"*INITIAL CONDITIONS, TYPE=", type.substr(0, 40)}), file_.keyword_line());
      return;
    }
    ignore_others({"TYPE", "INPUT"});
    std::string_view line;
    while (file_.data(line)) {
      const NodeLine where{std::string(field(line)), file_.line()};
      const FileNumber direction = file_.tag(field(line), "the degree of freedom");
      const double value = file_.number_or(field(line), 0, "the velocity");
      if (direction > 3) {
        if (value != 0) ignore("degrees of freedom above 3");
        continue;
      }
      velocities_.push_back({where, static_cast<std::size_t>(direction - 1), value});
    }
  }
  /// Nodes that start with the same velocity share a card; of two values of a component the last counts.
  template <class Nodes>
  void add_velocities(AbaqusDeck& deck, const Nodes& nodes) const {
    std::map<Index, std::array<double, 3>> of_nodes;
    for (const auto& [where, direction, value] : velocities_)
      for (const Index node : nodes(where)) of_nodes[node][direction] = value;
    std::map<std::array<double, 3>, std::size_t> cards;
    for (const auto& [node, velocity] : of_nodes) {
      const auto [card, is_new] = cards.try_emplace(velocity, deck.velocities.size());
      if (is_new) deck.velocities.push_back({{}, {velocity[0], velocity[1], velocity[2]}});
      deck.velocities[card->second].nodes.push_back(node);
    }
  }
  void forces() {
    if (file_.find("FOLLOWER")) ignore("FOLLOWER");
    ignore_others({"AMPLITUDE", "OP", "FOLLOWER"});
    const std::string amplitude = amplitude_of_load();
    std::string_view line;
    while (file_.data(line)) {
      const NodeLine where{std::string(field(line)), file_.line()};
      const FileNumber direction = file_.tag(field(line), "the degree of freedom");
      const double value = file_.number_or(field(line), 0, "the force");
      if (direction > 3)
        ignore("a moment");
      else
        forces_.push_back({where, static_cast<std::size_t>(direction - 1), value, amplitude});
    }
  }
  void distributed(bool is_surface, AbaqusDeck& deck) {
    ignore_others({"AMPLITUDE", "OP"});
    const std::string amplitude = amplitude_of_load();
    std::string_view line;
    while (file_.data(line)) {
      const std::string where(field(line));
      const std::string kind = label(field(line));
      const double value = file_.number_or(field(line), 0, "the magnitude");
      const bool is_face = kind.size() == 2 && kind[0] == 'P' && kind[1] >= '1' && kind[1] <= '6';
      if (kind == "GRAV" && !is_surface) {
        Eigen::Vector3d direction;
        for (Eigen::Index i = 0; i < 3; ++i) direction[i] = file_.number_or(field(line), 0, "a component of GRAV");
        if (!(direction.norm() > 0)) file_.refuse({"GRAV has no direction: give its three components."});
        deck.gravities.push_back({where, value / direction.norm() * direction, amplitude});
      } else if (kind == "P" || (is_face && !is_surface)) {
        pressures_.push_back({where, is_surface, kind, value, amplitude, file_.line()});
      } else {
        skipped_.add(joined({file_.name(), " ", kind.substr(0, 20)}), file_.line());
      }
    }
  }

  void friction() {
    std::string_view line;
    if (interaction_.empty()) return skipped_.add("*FRICTION", file_.keyword_line());
    Friction friction;
    const bool decays = file_.find("EXPONENTIALDECAY") != nullptr;
    ignore_others({"EXPONENTIALDECAY", "SLIPTOLERANCE"});
    if (file_.data(line)) {
      friction.static_friction = friction.dynamic_friction = file_.number_or(field(line), 0, "the friction");
      if (decays) {
        friction.dynamic_friction = file_.number_or(field(line), 0, "the friction");
        friction.decay = file_.number_or(field(line), 0, "the decay");
      } else {
        for (int i = 0; i < 3; ++i)
          if (file_.number_or(field(line), 0, "the slip rate, pressure or temperature") != 0)
            ignore("slip rate, pressure or temperature");
      }
      if (file_.data(line)) ignore("further lines");
    }
    frictions_[interaction_] = friction;
  }
  void contact_pairs() {
    ignore_others({"INTERACTION", "MECHANICALCONSTRAINT"});
    const std::string interaction = file_.find("INTERACTION") ? file_.label_of("INTERACTION") : "";
    std::string_view line;
    while (file_.data(line)) {
      const std::string slave = shown_label(field(line)), master = shown_label(field(line));
      contacts_.push_back({"PAIR", slave, master, interaction, file_.line()});
    }
  }
  void contact_inclusions() {
    std::string_view line;
    const std::size_t before = contacts_.size();
    while (file_.data(line)) {
      const std::string first = shown_label(field(line)), second = shown_label(field(line));
      contacts_.push_back({"INCLUSIONS", first, second, "", file_.line()});
    }
    if (contacts_.size() == before) contacts_.push_back({"INCLUSIONS", "", "", "", file_.keyword_line()});
  }
  void contact_properties() {
    std::string_view line;
    while (file_.data(line)) {
      const std::string first = squeezed(field(line)), second = squeezed(field(line));
      properties_[{first, second}] = label(field(line));
    }
  }
  void add_contact(AbaqusDeck& deck, Finished& mesh, const PendingContact& contact) const {
    ContactCard card{.kind = contact.kind, .slave = {}, .master = {}};
    for (const auto& [name, side] :
         {std::pair(&contact.slave, &card.slave), std::pair(&contact.master, &card.master)}) {
      if (name->empty()) continue;
      const auto place = surface_places_.find(squeezed(*name));
      if (place == surface_places_.end())
        file_.refuse(contact.line, {"the surface ", shown(*name),
                                    " is not in the file, or was skipped: define it by elements or nodes."});
      const ContactSide& surface = deck.surfaces[place->second].side;
      mesh.allowance.take(surface.segments.size() + surface.nodes.size(), contact.line);
      *side = surface;
    }
    std::string interaction = contact.interaction;
    if (contact.kind == "INCLUSIONS") {
      auto property = properties_.find({squeezed(contact.slave), squeezed(contact.master)});
      if (property == properties_.end()) property = properties_.find({"", ""});
      if (property != properties_.end()) interaction = property->second;
    }
    if (!interaction.empty()) {
      const auto friction = frictions_.find(interaction);
      if (friction == frictions_.end())
        file_.refuse(contact.line, {"the interaction ", shown(interaction),
                                    " is not in the file: define it with *SURFACE INTERACTION."});
      card.static_friction = friction->second.static_friction;
      card.dynamic_friction = friction->second.dynamic_friction;
      card.decay = friction->second.decay;
    }
    deck.contacts.push_back(std::move(card));
  }

  void dynamic(AbaqusDeck& deck) {
    is_adiabatic_ = file_.find("ADIABATIC") != nullptr;
    if (!file_.find("EXPLICIT")) values_.add("*DYNAMIC without EXPLICIT (its period is taken)", file_.keyword_line());
    ignore_others({"EXPLICIT", "ADIABATIC"});
    std::string_view line;
    if (!file_.data(line)) return;
    field(line);
    deck.end_time = file_.number_or(field(line), 0, "the period of the step");
  }
  void bulk_viscosity(AbaqusDeck& deck) {
    std::string_view line;
    if (!file_.data(line)) return;
    const std::string_view linear = field(line), quadratic = field(line);
    deck.bulk_viscosity = {file_.number_or(quadratic, 1.2, "b2"), file_.number_or(linear, 0.06, "b1")};
  }

  File& file_;
  Skipped& skipped_;
  Skipped& values_;
  int steps_ = 0;
  bool is_adiabatic_ = false, has_faces_ = false;
  std::string interaction_ = {};
  std::vector<Segment> all_faces_ = {};  ///< of solids, their corners in ascending order
  std::vector<PendingSupport> supports_ = {};
  std::vector<PendingMotion> motions_ = {};
  std::vector<PendingForce> forces_ = {};
  std::vector<PendingVelocity> velocities_ = {};
  std::vector<PendingPressure> pressures_ = {};
  std::vector<std::vector<Segment>> faces_ = {};  ///< of the pressures
  std::vector<PendingContact> contacts_ = {};
  std::map<std::string, Friction> frictions_ = {};
  std::map<std::pair<std::string, std::string>, std::string> properties_ = {};  ///< interactions of pairs
  std::map<std::string, std::size_t> surface_places_ = {};
  const std::map<std::string, FileNumber>* scopes_ = nullptr;
  std::map<std::string, std::uint32_t> used_amplitudes_ = {};
  std::set<std::string> amplitudes_ = {}, unread_amplitudes_ = {};
};

}  // namespace strike::detail::abaqus
