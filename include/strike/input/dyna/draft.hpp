#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/input/dyna/file.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/input/raw_mesh.hpp>

namespace strike::detail::dyna {

/// A constraint from 0 to 7: the axes x, y and z that are held.
inline std::array<bool, 3> held_by(FileNumber code, std::string_view what, const File& file) {
  constexpr std::array<std::array<bool, 3>, 8> codes{{{false, false, false},
                                                      {true, false, false},
                                                      {false, true, false},
                                                      {false, false, true},
                                                      {true, true, false},
                                                      {false, true, true},
                                                      {true, false, true},
                                                      {true, true, true}}};
  if (code < 0 || code > 7)
    file.refuse({"the constraint ", std::to_string(code), " of ", what, " is none: give 0 to 7."});
  return codes[static_cast<std::size_t>(code)];
}
/// CMO, CON1 and CON2 into what a body has `held` and `held_turns`. CMO 1: axes of space by their codes; CMO -1: CON2
/// has a digit 1 for each axis of the coordinate system CON1 that is held, x y z, and about which, whose number is
/// returned; 0: that of space.
template <class Body>
FileNumber held_by_body(Card& card, Body& body, std::string_view what, const File& file) {
  const double frame = card.number("CMO");
  if (frame == 1) {
    body.held = held_by(card.integer("CON1"), what, file);
    body.held_turns = held_by(card.integer("CON2"), what, file);
    return 0;
  }
  if (frame == 0) return 0;
  if (frame != -1) file.refuse({"CMO is neither 1, 0 nor -1: correct it."});
  const FileNumber system = card.tag("CON1", Id::define), code = card.integer("CON2");
  FileNumber left = code;
  for (auto* const degrees : {&body.held_turns, &body.held})
    for (std::size_t i = 3; i-- > 0; left /= 10) {
      if (left < 0 || left % 10 > 1)
        file.refuse({"CON2 ", std::to_string(code), " is none: give six digits of 0 or 1, such as 111000."});
      (*degrees)[i] = left % 10 == 1;
    }
  if (left != 0) file.refuse({"CON2 ", std::to_string(code), " is none: give six digits of 0 or 1, such as 111000."});
  return system;
}

/// Nodes that a card names, found when the whole file has been read.
enum class Named { all, node, set, part, part_set, box, segment_set, shell, shell_set, solid, solid_set };
struct Choice {
  Named named;
  FileNumber number;
  std::uint32_t line;
  bool removes = false;  ///< takes the nodes out of the set again
};

/// A card and the choice of its nodes.
template <class Card>
struct Pending {
  Card card;
  std::vector<Choice> choices;
  FileNumber system = 0;  ///< CID
  std::uint32_t line = 0;
};

struct PendingSegments {
  struct Segment {
    std::array<FileNumber, 4> corners;
    std::uint32_t line;
  };
  FileNumber number;
  std::string name;
  std::vector<Segment> segments;
};

/// A pressure on segments by their corners, and on sets of segments, shells and sets of shells.
struct PendingPressure {
  PressureLoadCard card;
  std::vector<PendingSegments::Segment> segments;
  std::vector<Choice> choices;
  std::uint32_t line;
};
/// A charge, at a node if it has one.
struct PendingBlast {
  BlastCard card;
  FileNumber node;
  std::uint32_t line;
};
/// Faces that a charge loads: those of *LOAD_BLAST if its number is 0.
struct PendingBlastFaces {
  FileNumber blast;
  std::vector<PendingSegments::Segment> segments;
  std::vector<Choice> choices;
  std::uint32_t line;
};
/// A motion along a vector (VID).
struct PendingMotion {
  PrescribedMotionCard card;
  std::vector<Choice> choices;
  FileNumber vector;
  std::uint32_t line;
};
/// *DEFINE_VECTOR, by its components or from one node to another.
struct PendingVector {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  FileNumber system = 0, tail = 0, head = 0;
  std::uint32_t line = 0;
};

/// The side of a contact: SSID with SSTYP, or MSID with MSTYP.
struct Side {
  FileNumber number, kind;
};
struct PendingContact {
  ContactCard card;
  Side slave, master;
  std::uint32_t line;
};

/// A set that names others, or nodes by their parts.
struct PendingSet {
  FileNumber number;
  std::string name;
  std::uint32_t line;
  std::vector<Choice> choices;
};

/// Axes that are given by three nodes: the first is the origin.
struct PendingSystem {
  std::size_t system;  ///< its place in the deck
  std::array<FileNumber, 3> nodes;
  int first;  ///< the axis from the first node to the second
  std::uint32_t line;
};
/// The coordinate system of a rigid material.
struct PendingRigid {
  std::size_t material;  ///< its place in the deck
  FileNumber system;
  std::uint32_t line;
};
/// The centre of an inertia that is given by a node, or its axes by a coordinate system.
struct PendingInertia {
  std::size_t place;  ///< in the deck, or that of its rigid body in the draft
  FileNumber number;  ///< of the node or the system
  std::uint32_t line;
  bool of_body;
};
struct PendingShell {
  FileNumber number;
  ShellCard card;
};
/// A table whose curves stand after it.
struct OpenTable {
  std::size_t table = 0;  ///< its place in the deck
  std::size_t left = 0;   ///< curves to come
  std::uint32_t line = 0;
};

/// A material of a curve, or of points of its own, whose curves may stand after it.
struct PendingHardening {
  std::size_t material;  ///< its place in the deck
  std::uint32_t line;
  LinearEos eos;
  double shear_modulus;
  FileNumber curve, rate_curve;  ///< LCSS and LCSR, 0 for none
  bool has_logarithms;           ///< LOG_INTERPOLATION
  std::vector<TabulatedHardening::Point> points;
  std::optional<RateConstants> rate;
  std::optional<FailureStrain> failure;
};

/// A table of an equation of state, whose curves may stand after it.
struct PendingEos {
  std::size_t place;  ///< in the deck
  std::uint32_t line;
  FileNumber curve_C = 0, curve_T = 0;  ///< LCC and LCT, 0 for none
  double gamma = 0, initial_energy = 0;
  std::vector<TabulatedEos::Point> points = {};
};

/// *DEFINE_BOX, along the axes.
struct Box {
  Eigen::Vector3d least = Eigen::Vector3d::Zero(), most = Eigen::Vector3d::Zero();
};

/// Nodes from `first` to below `last` in the file, and what moves them: a place in the motions of the file, plus 1.
struct MovedNodes {
  std::uint32_t motion;
  std::size_t first, last;
  std::uint32_t held;  ///< a line that holds one of them by TC or RC; 0 if there is none
};

/// *DEFINE_TRANSFORMATION: x becomes A x + b.
struct Transformation {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

/// The input, keyword by keyword; `resolved` makes a deck of it.
struct Draft {
  DynaDeck deck = {};
  RawMesh raw = {};
  std::map<FileNumber, std::uint32_t> parts = {};  ///< their places in the deck
  std::vector<RawMesh::Set> part_sets = {};
  std::map<std::pair<std::string_view, FileNumber>, std::size_t> set_places = {};  ///< by kind and number
  std::vector<PendingSet> general_sets = {}, part_sums = {}, solid_sums = {}, shell_sums = {};
  std::vector<PendingSegments> segment_sets = {};
  std::map<FileNumber, Box> boxes = {};
  std::map<FileNumber, Transformation> transformations = {};
  std::vector<MovedNodes> moved = {};
  std::vector<PendingSystem> systems = {};
  std::vector<PendingInertia> centres = {}, inertia_systems = {};
  std::vector<PendingShell> shells = {};
  std::vector<PendingHardening> hardenings = {};
  std::vector<PendingEos> tabulated_eos = {};
  std::vector<PendingRigid> rigid_systems = {};
  OpenTable open_table = {};
  std::map<std::pair<std::string_view, FileNumber>, std::uint32_t> defined = {};  ///< lines of cards by kind, number
  std::vector<Pending<SupportCard>> node_supports = {};                           ///< one for each way of being held
  std::map<std::tuple<std::array<bool, 3>, std::array<bool, 3>, FileNumber>, std::size_t> support_ways = {};
  std::vector<Pending<SupportCard>> set_supports = {};
  std::vector<Pending<VelocityCard>> velocities = {};
  std::vector<Pending<WallCard>> walls = {};
  std::vector<Pending<ObstacleCard>> obstacles = {};
  std::vector<Pending<BodyLoadCard>> body_loads = {};
  std::vector<Choice> body_load_parts = {};
  std::vector<Pending<NodalLoadCard>> nodal_loads = {};
  std::vector<PendingPressure> pressures = {};
  std::vector<Pending<RigidBodyCard>> rigid_bodies = {};
  std::vector<Pending<RigidMergeCard>> rigid_merges = {};
  std::vector<Pending<ExtraNodesCard>> extra_nodes = {};
  std::vector<PendingMotion> motions = {};
  std::vector<PendingBlast> blasts = {};
  std::vector<PendingBlastFaces> blast_faces = {};
  std::map<FileNumber, PendingVector> vectors = {};
  std::vector<PendingContact> contacts = {};
  std::vector<Choice> history_nodes = {}, history_cells = {};
  double plots = 0;  ///< NPLTC

  /// The place of a part; its elements are the group of that number.
  std::uint32_t part(FileNumber number) {
    const auto [place, is_new] = parts.try_emplace(number, static_cast<std::uint32_t>(raw.parts.size()));
    if (is_new) {
      raw.groups.push_back({place->second});
      raw.parts.push_back({number, {}, {}});
    }
    return place->second;
  }
  /// The number that a card defines. Errors: it has none; another card of its kind has it.
  FileNumber own_number(std::string_view kind, Id id, Card& card, const File& file) {
    const FileNumber number = card.own_tag(joined({"the number of a ", kind}), kind, id);
    const auto [known, is_new] = defined.try_emplace({kind, number}, file.line());
    if (!is_new)
      file.refuse({kind, " ", std::to_string(number), " is on line ",
                   file.source().place_beside(known->second, file.line()), " already: give each a number of its own."});
    return number;
  }
  InertiaCard& inertia(const PendingInertia& pending) {
    return pending.of_body ? rigid_bodies[pending.place].card.inertia.value() : deck.inertias[pending.place];
  }
  void support_node(const SupportCard& way, const Choice& node, FileNumber system = 0) {
    const auto [known, is_new] = support_ways.try_emplace({way.held, way.held_turns, system}, node_supports.size());
    if (is_new) node_supports.push_back({way, {}, system});
    node_supports[known->second].choices.push_back(node);
  }
};

/// True of cards that mean the same in other units, and of those that do in a scene that is moved.
enum class Invariant { none, moved, everywhere };

/// A keyword and the reader of its cards.
struct Keyword {
  std::string_view name;  ///< without _TITLE and _ID
  void (*read)(File&, Draft&);
  Invariant invariant = Invariant::moved;
  const Meaning* meaning = nullptr;
};
/// The options of a keyword, from a list of those that may stand in it; false if it has others.
template <std::size_t N>
bool has_options(std::string_view options, const std::array<std::string_view, N>& known, std::array<bool, N>& has) {
  has = {};
  while (!options.empty()) {
    const auto option = std::find_if(known.begin(), known.end(), [&](std::string_view name) {
      return options.starts_with(name) && (options.size() == name.size() || options[name.size()] == '_');
    });
    if (option == known.end()) return false;
    has[static_cast<std::size_t>(option - known.begin())] = true;
    options.remove_prefix(option->size());
  }
  return true;
}

/// Keywords of one beginning: followed by one of the endings, or by any of the options in any order, or none.
struct Family {
  std::string_view beginning;
  std::span<const std::string_view> endings, options;
  const Keyword* (*find)(std::string_view name);  ///< null for other keywords
};

}  // namespace strike::detail::dyna
