#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/sets.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/mesh/select.hpp>

namespace strike::detail::dyna {

[[noreturn, gnu::cold]] inline void refuse_missing(const File& file, const Choice& choice, const char* kind,
                                                   const char* keyword) {
  const std::string skipped = file.skipped(keyword);
  file.source().refuse(choice.line, {kind, " ", std::to_string(choice.number),
                                     skipped.empty() ? " is not in the file" : " is not among those read (", skipped,
                                     skipped.empty() ? "" : " was skipped)", ": define it or correct the card."});
}

/// Nodes and parts that cards name, in a deck that is complete but for them.
class Lookup {
 public:
  Lookup(Finished& mesh, const DynaDeck& deck, const Draft& draft, const File& file)
      : mesh_(mesh), deck_(deck), draft_(draft), file_(file) {
    for (const NamedSet& set : deck.node_sets) add(set);
    for (const NamedSet& set : deck.part_sets) part_sets_.try_emplace(set.number, &set);
    for (const SegmentSet& set : deck.segment_sets) segment_sets_.try_emplace(set.number, &set);
    for (const CoordinateCard& system : deck.coordinate_systems) systems_.try_emplace(system.number, &system);
    for (const CurveCard& curve : deck.curves) curves_.try_emplace(curve.number, &curve);
  }
  void add(const NamedSet& node_set) { node_sets_.try_emplace(node_set.number, &node_set); }

  /// The chosen nodes by their numbers in the mesh, in ascending order.
  std::vector<Index> nodes(std::span<const Choice> choices) const {
    std::vector<Index> added, removed;
    std::set<std::tuple<Named, FileNumber, bool>> seen;
    for (const Choice& choice : choices) {
      if (choice.named != Named::node && !seen.emplace(choice.named, choice.number, choice.removes).second) continue;
      std::vector<Index>& nodes = choice.removes ? removed : added;
      const auto add = [&](const std::vector<Index>& more) {
        mesh_.allowance.take(more.size(), choice.line);
        nodes.insert(nodes.end(), more.begin(), more.end());
      };
      switch (choice.named) {
        case Named::all:
          add(all_nodes(deck_.mesh.nodes));
          break;
        case Named::node:
          if (const Index n = mesh_.node(choice.number, file_.source(), choice.line); n != nothing) nodes.push_back(n);
          break;
        case Named::set:
          add(found(node_sets_, choice, "the set of nodes", "*SET_NODE")->members);
          break;
        case Named::box:
          add(nodes_in_box(choice));
          break;
        default:
          for (const Index part : parts(choice)) {
            const std::vector<Index>& cells = deck_.parts[part].members;
            mesh_.allowance.take(8 * cells.size(), choice.line);
            add(deck_.cells(cells).nodes());
          }
      }
    }
    added = ascending(std::move(added));
    if (removed.empty()) return added;
    removed = ascending(std::move(removed));
    std::vector<Index> left;
    std::set_difference(added.begin(), added.end(), removed.begin(), removed.end(), std::back_inserter(left));
    return left;
  }
  const std::vector<std::array<Index, 4>>& segments(const Choice& choice) const {
    const auto& segments = found(segment_sets_, choice, "the set of segments", "*SET_SEGMENT")->segments;
    mesh_.allowance.take(4 * segments.size(), choice.line);
    return segments;
  }
  /// Segments of a card by their places in the mesh; those on nodes that were dropped are told.
  std::vector<std::array<Index, 4>> segments(const std::vector<PendingSegments::Segment>& given, File& file) const {
    std::vector<std::array<Index, 4>> all;
    for (const auto& [corners, line] : given) {
      std::array<Index, 4> segment;
      for (std::size_t i = 0; i < 4; ++i) segment[i] = mesh_.node(corners[i], file_.source(), line);
      if (std::find(segment.begin(), segment.end(), nothing) == segment.end())
        mesh_.cut_faces.add_segment(segment, all);
      else
        file.ignore_on_line(line, "A segment on nodes without an element");
    }
    return all;
  }
  /// Adds the faces of a set of segments, a shell or a set of shells.
  void add_faces(const Choice& choice, std::vector<std::array<Index, 4>>& faces) const {
    if (choice.named == Named::segment_set) {
      const auto& more = segments(choice);
      faces.insert(faces.end(), more.begin(), more.end());
      return;
    }
    for (const Index cell : cells_of(choice)) {
      const std::size_t plate = cell - solids(), quadrilaterals = deck_.mesh.quadrilaterals.size();
      if (plate < quadrilaterals) {
        faces.push_back(deck_.mesh.quadrilaterals[plate]);
      } else {
        const auto& [a, b, c] = deck_.mesh.triangles[plate - quadrilaterals];
        faces.push_back({a, b, c, c});
      }
    }
  }
  /// Number of the solids, which stand before the shells.
  std::size_t solids() const { return deck_.mesh.hexahedra.size() + deck_.mesh.tetrahedra.size(); }
  /// The places in the mesh of a shell or a solid, or of a set of them.
  std::vector<Index> cells_of(const Choice& choice) const {
    const bool solid = choice.named == Named::solid || choice.named == Named::solid_set;
    if (choice.named == Named::shell_set || choice.named == Named::solid_set) {
      const auto place = draft_.set_places.find({solid ? solid_sets.name : shell_sets.name, choice.number});
      if (place == draft_.set_places.end())
        refuse_missing(file_, choice, solid ? "the set of solids" : "the set of shells",
                       solid ? "*SET_SOLID" : "*SET_SHELL");
      const std::vector<Index>& members = deck_.cell_sets[place->second].members;
      mesh_.allowance.take(4 * members.size(), choice.line);
      return members;
    }
    const auto plates = static_cast<std::ptrdiff_t>(solids());
    const auto begin = deck_.cell_numbers.begin();
    if (solid && !solids_) solids_ = Numbering({begin, begin + plates});
    if (!solid && !shells_) shells_ = Numbering({begin + plates, deck_.cell_numbers.end()});
    const Index place = (solid ? solids_ : shells_)->find(choice.number);
    if (place == nothing)
      refuse_missing(file_, choice, solid ? "solid" : "shell", solid ? "*ELEMENT_SOLID" : "*ELEMENT_SHELL");
    const std::size_t first = solid ? place : static_cast<std::size_t>(plates) + place,
                      end = solid ? static_cast<std::size_t>(plates) : deck_.cell_numbers.size();
    std::vector<Index> pieces;  // of a cell of second order, otherwise itself
    for (std::size_t cell = first; cell < end && deck_.cell_numbers[cell] == choice.number; ++cell)
      pieces.push_back(static_cast<Index>(cell));
    return pieces;
  }
  /// Error: forces on mid nodes that were dropped.
  void expect_forces(std::span<const Choice> choices) const {
    for (const Choice& choice : choices)
      if (choice.named == Named::node)
        mesh_.expect_force(choice.number, file_.source(), choice.line);
      else if (const auto set = node_sets_.find(choice.number); choice.named == Named::set && set != node_sets_.end())
        mesh_.expect_forces(choice.number, set->second->name, file_.source(), choice.line);
  }
  /// A curve.
  const CurveCard& curve(const Choice& choice) const {
    const CurveCard& curve = *found(curves_, choice, "curve", "*DEFINE_");
    mesh_.allowance.take(curve.points.size(), choice.line);
    return curve;
  }
  /// The unit vector of *DEFINE_VECTOR. Error: it has no length.
  Eigen::Vector3d direction(const Choice& choice) const {
    const auto place = draft_.vectors.find(choice.number);
    if (place == draft_.vectors.end()) refuse_missing(file_, choice, "vector", "*DEFINE_VECTOR");
    const auto& [vector, system, tail, head, line] = place->second;
    const double length = vector.stableNorm();
    if (!(length > 0) || !std::isfinite(length))
      file_.source().refuse(
          line, {"vector ", std::to_string(choice.number), " has no direction: give it a head that is not its tail."});
    const Eigen::Vector3d unit = vector / length;
    if (system == 0) return unit;
    return axes({Named::all, system, line}) * unit;
  }
  /// Error: neither a part nor a rigid body of nodes has that number.
  void expect_body(const Choice& choice) const {
    if (!draft_.defined.contains({"rigid body", choice.number})) found(draft_.parts, choice, "part", "*PART");
  }
  /// The axes of a coordinate system.
  const Eigen::Matrix3d& axes(const Choice& choice) const {
    return found(systems_, choice, "coordinate system", "*DEFINE_COORDINATE")->axes;
  }
  /// The places of a part, or of the parts of a set.
  std::vector<Index> parts(const Choice& choice) const {
    if (choice.named == Named::part) return {found(draft_.parts, choice, "part", "*PART")};
    const std::vector<Index>& members = found(part_sets_, choice, "the set of parts", "*SET_PART")->members;
    mesh_.allowance.take(members.size(), choice.line);
    return members;
  }

 private:
  std::vector<Index> nodes_in_box(const Choice& choice) const {
    const auto box = draft_.boxes.find(choice.number);
    if (box == draft_.boxes.end()) refuse_missing(file_, choice, "box", "*DEFINE_BOX");
    mesh_.allowance.take(deck_.mesh.nodes.size(), choice.line);
    std::vector<Index> inside;
    for (Index n = 0; n < deck_.mesh.nodes.size(); ++n)
      if (const auto& x = deck_.mesh.nodes[n].array();
          (x >= box->second.least.array()).all() && (x <= box->second.most.array()).all())
        inside.push_back(n);
    return inside;
  }
  template <class Value>
  Value found(const std::map<FileNumber, Value>& things, const Choice& choice, const char* kind,
              const char* keyword) const {
    const auto thing = things.find(choice.number);
    if (thing == things.end()) refuse_missing(file_, choice, kind, keyword);
    return thing->second;
  }

  Finished& mesh_;
  const DynaDeck& deck_;
  const Draft& draft_;
  const File& file_;
  std::map<FileNumber, const NamedSet*> node_sets_ = {}, part_sets_ = {};
  std::map<FileNumber, const SegmentSet*> segment_sets_ = {};
  std::map<FileNumber, const CoordinateCard*> systems_ = {};
  std::map<FileNumber, const CurveCard*> curves_ = {};
  mutable std::optional<Numbering> shells_ = {}, solids_ = {};  ///< made when the first is asked for
};

}  // namespace strike::detail::dyna
