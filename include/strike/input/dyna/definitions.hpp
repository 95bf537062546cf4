#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <strike/input/dyna/draft.hpp>

// Curves, tables and coordinate systems.
namespace strike::detail::dyna {

inline void curve(File& file, Draft& draft) {
  std::string title = file.title();
  Card head = file.card();
  CurveCard curve{draft.own_number("curve or table", Id::curve, head, file), std::move(title), {}};
  curve.phase = head.integer("SIDR");
  const double scale_a = head.number("SFA", 1), scale_o = head.number("SFO", 1);
  const double offset_a = head.number("OFFA"), offset_o = head.number("OFFO");
  const FileNumber kind = head.integer("DATTYP");
  if (kind != 0 && kind != 1) file.ignore(1, joined({"DATTYP ", std::to_string(kind)}));
  file.for_each_card([&](Card card) {
    const double a = card.number("an abscissa", 0, 20), o = card.number("an ordinate", 0, 20);
    curve.points.push_back({scale_a * (a + offset_a), scale_o * (o + offset_o)});
    const std::size_t last = curve.points.size() - 1;
    if (kind == 0 && scale_a > 0 && last > 0 && curve.points[last][0] < curve.points[last - 1][0])
      file.refuse({"the abscissa ", text(a), " of curve ", std::to_string(curve.number),
                   " is below the one before it: give the points in ascending order."});
    if (!std::isfinite(curve.points.back()[0]) || !std::isfinite(curve.points.back()[1]))
      file.refuse({"a point of curve ", std::to_string(curve.number), " is not finite: give smaller numbers."});
  });
  if (OpenTable& table = draft.open_table; table.left > 0) {
    draft.deck.tables[table.table].curves.push_back(curve.number);
    --table.left;
  }
  draft.deck.curves.push_back(std::move(curve));
}
inline void expect_closed_table(const Draft& draft, const File& file) {
  if (const OpenTable& table = draft.open_table; table.left > 0)
    file.source().refuse(table.line, {"table ", std::to_string(draft.deck.tables[table.table].number), " has ",
                                      std::to_string(draft.deck.tables[table.table].values.size()), " values and ",
                                      std::to_string(draft.deck.tables[table.table].curves.size()),
                                      " curves after it: write a *DEFINE_CURVE for each, or *DEFINE_TABLE_2D."});
}
/// Values with the curves after the table, or with the number of a curve each.
inline void table(File& file, Draft& draft) {
  expect_closed_table(draft, file);
  std::string title = file.title();
  Card head = file.card();
  TableCard table{draft.own_number("curve or table", Id::curve, head, file), std::move(title), {}, {}};
  const std::uint32_t line = file.line();
  const double scale = head.number("SFA", 1), offset = head.number("OFFA");
  bool names_curves = file.base() == "*DEFINE_TABLE_2D";
  file.for_each_card([&](Card card) {
    table.values.push_back(scale * (card.number("a value of the table", 0, 20) + offset));
    const FileNumber curve = card.tag("LCID", Id::curve, 20);
    names_curves |= curve != 0;
    if (!names_curves) return;
    if (curve == 0) file.refuse({"a value of table ", std::to_string(table.number), " names no curve: give each one."});
    table.curves.push_back(curve);
  });
  if (names_curves && table.curves.size() != table.values.size())
    file.refuse({"table ", std::to_string(table.number), " has ", std::to_string(table.values.size()), " values and ",
                 std::to_string(table.curves.size()), " curves: give each value one."});
  if (!names_curves) draft.open_table = {draft.deck.tables.size(), table.values.size(), line};
  draft.deck.tables.push_back(std::move(table));
}

/// Axes of which one lies along a vector and the next in the plane of both. Error: there is no such plane.
inline Eigen::Matrix3d axes_of(const Eigen::Vector3d& along, const Eigen::Vector3d& in_plane, int first,
                               const Source& source, std::uint32_t line) {
  const Eigen::Vector3d normal = along.normalized().cross(in_plane.normalized());
  if (!(along.norm() > 0) || !(in_plane.norm() > 0) || !(normal.norm() > 1e-8) || !normal.allFinite())
    source.refuse(line, {"the axes of a coordinate system lie in a line: give a point off its first axis."});
  Eigen::Matrix3d axes;
  axes.col(first) = along.normalized();
  axes.col((first + 2) % 3) = normal.normalized();
  axes.col((first + 1) % 3) = axes.col((first + 2) % 3).cross(axes.col(first));
  return axes;
}
inline void coordinate_system(File& file, Draft& draft) {
  std::string title = file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("coordinate system", Id::define, card, file);
  const Eigen::Vector3d origin = card.vector("XO to ZO"), on_axis = card.vector("XL to ZL");
  file.ignore(card.number("CIDL"), "CIDL");
  const Eigen::Vector3d in_plane = file.card().vector("XP to ZP");
  draft.deck.coordinate_systems.push_back(
      {number, std::move(title), origin, axes_of(on_axis - origin, in_plane - origin, 0, file.source(), file.line())});
}
inline void coordinate_vectors(File& file, Draft& draft) {
  std::string title = file.title();
  file.for_each_card([&](Card card) {
    const FileNumber number = draft.own_number("coordinate system", Id::define, card, file);
    const Eigen::Vector3d along = card.vector("XX to ZX"), in_plane = card.vector("XV to ZV");
    file.ignore(card.number("NID"), "NID");
    draft.deck.coordinate_systems.push_back(
        {number, title, Eigen::Vector3d::Zero(), axes_of(along, in_plane, 0, file.source(), file.line())});
  });
}
inline void coordinate_nodes(File& file, Draft& draft) {
  std::string title = file.title();
  file.for_each_card([&](Card card) {
    const FileNumber number = draft.own_number("coordinate system", Id::define, card, file);
    PendingSystem pending{draft.deck.coordinate_systems.size(), {}, 0, file.line()};
    for (FileNumber& node : pending.nodes) node = card.own_tag("a node", "coordinate system", Id::node);
    file.ignore(card.number("FLAG"), "FLAG (axes that turn)");
    const std::string first = upper(card.text());
    if (first != "" && first != "X" && first != "Y" && first != "Z")
      file.refuse({"DIR ", shown(first), " is no axis: give X, Y or Z."});
    pending.first = first == "Y" ? 1 : first == "Z" ? 2 : 0;
    draft.systems.push_back(pending);
    draft.deck.coordinate_systems.push_back({number, title, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()});
  });
}

inline void vectors(File& file, Draft& draft) {
  file.title();
  const bool by_nodes = file.base() == "*DEFINE_VECTOR_NODES";
  file.for_each_card([&](Card card) {
    const FileNumber number = draft.own_number("vector", Id::define, card, file);
    PendingVector& vector = draft.vectors[number];
    vector.line = file.line();
    if (by_nodes) {
      vector.tail = card.own_tag("the tail of a vector", "vector", Id::node);
      vector.head = card.own_tag("the head of a vector", "vector", Id::node);
    } else {
      const Eigen::Vector3d tail = card.vector("XT to ZT");
      vector.vector = card.vector("XH to ZH") - tail;
      vector.system = card.tag("CID", Id::define);
    }
  });
}

/// Points that are given by nodes, once all nodes are where they belong.
inline void place_by_nodes(Draft& draft, const File& file) {
  if (draft.systems.empty() && draft.centres.empty() && draft.vectors.empty() && draft.blasts.empty()) return;
  std::vector<FileNumber> numbers;
  for (const RawMesh::Node& node : draft.raw.nodes) numbers.push_back(node.number);
  const Numbering all(std::move(numbers));
  const auto position = [&](FileNumber node, std::uint32_t line) -> const Eigen::Vector3d& {
    const Index place = all.find(node);
    if (place == nothing)
      file.source().refuse(line,
                           {"node ", std::to_string(node), " is not in the file: define it or correct the card."});
    return draft.raw.nodes[place].x;
  };
  for (const PendingSystem& pending : draft.systems) {
    CoordinateCard& system = draft.deck.coordinate_systems[pending.system];
    system.origin = position(pending.nodes[0], pending.line);
    system.axes =
        axes_of(position(pending.nodes[1], pending.line) - system.origin,
                position(pending.nodes[2], pending.line) - system.origin, pending.first, file.source(), pending.line);
  }
  for (auto& [number, vector] : draft.vectors)
    if (vector.tail != 0) vector.vector = position(vector.head, vector.line) - position(vector.tail, vector.line);
  for (PendingBlast& blast : draft.blasts)
    if (blast.node != 0) blast.card.centre = position(blast.node, blast.line);
  for (const PendingInertia& pending : draft.centres)
    draft.inertia(pending).centre = position(pending.number, pending.line);
}

inline constexpr Meaning of_curves{"`deck.curve(number)`, scaled and shifted", "`CardHistory` of loads and motions",
                                   "DATTYP other than 0 and 1; of loads SIDR 1, before the run"};
inline constexpr Meaning of_tables{"`deck.table(number)`", "materials", "nothing"};
inline constexpr Meaning of_systems{"`coordinate_systems`, of points", "axes of other cards", "CIDL"};
inline constexpr Meaning of_vector_systems{"`coordinate_systems`, of vectors", "axes of other cards", "NID"};
inline constexpr Meaning of_node_systems{"`coordinate_systems`, of nodes at the start", "axes of other cards",
                                         "FLAG: the axes do not turn"};
inline constexpr Meaning of_vectors{"directions (VID) of `motions`", "the same", "nothing"};
inline constexpr auto definition_keywords = std::to_array<Keyword>({
    {"*DEFINE_CURVE", curve, Invariant::moved, &of_curves},
    {"*DEFINE_TABLE", table, Invariant::moved, &of_tables},
    {"*DEFINE_TABLE_2D", table, Invariant::moved, &of_tables},
    {"*DEFINE_COORDINATE_SYSTEM", coordinate_system, Invariant::none, &of_systems},
    {"*DEFINE_COORDINATE_VECTOR", coordinate_vectors, Invariant::none, &of_vector_systems},
    {"*DEFINE_COORDINATE_NODES", coordinate_nodes, Invariant::everywhere, &of_node_systems},
    {"*DEFINE_VECTOR", vectors, Invariant::none, &of_vectors},
    {"*DEFINE_VECTOR_NODES", vectors, Invariant::everywhere, &of_vectors},
});

}  // namespace strike::detail::dyna
