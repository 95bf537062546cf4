#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include <Eigen/Core>

#include <strike/element/cell_shape.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Sine below which three edges count as coplanar, or two as collinear.
inline constexpr double flat = 1e-9;

/// The three edges that leave a corner: their triple product over the product of their lengths is the scaled Jacobian,
/// 1 at the corner of a brick, 0 if they are coplanar, negative if the cell is inside out there.
template <class T>
struct CornerJacobian {
  T product, squares;  ///< of the edges; of their squared lengths

  CornerJacobian(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c)
      : product(dot(cross(a, b), c)), squares(dot(a, a) * dot(b, b) * dot(c, c)) {}
  T scaled() const { return squares > 0 ? product / sqrt(squares) : T(0); }
  /// Positive if the scaled Jacobian is larger than `least`.
  T margin(double least) const { return product * abs(product) - (least * least) * squares; }
};

/// Positions of the corners of a cell, or of one in each lane.
template <std::size_t N, class T = double>
using CellCorners = std::array<Vector3<T>, N>;
template <std::size_t N>
CellCorners<N> corners_of(std::span<const Eigen::Vector3d> nodes, const std::array<Index, N>& cell) {
  CellCorners<N> x;
  for (std::size_t i = 0; i < N; ++i) x[i] = nodes[cell[i]];
  return x;
}

/// Corners of the faces at the start and at the end of each axis of a hexahedron.
inline constexpr std::array<std::array<unsigned, 8>, 3> opposite_faces{
    {{0, 3, 7, 4, 1, 2, 6, 5}, {0, 4, 5, 1, 3, 7, 6, 2}, {0, 1, 2, 3, 4, 5, 6, 7}}};

/// The angle by which the face of a hexahedron at the end of an axis is turned about it against that at its start, by
/// its sine and cosine times a common factor: none of a sheared brick, a right angle if the corners of one face are
/// counted from another corner, which no scaled Jacobian shows.
template <class T>
struct Twist {
  T sine, cosine;

  Twist(const CellCorners<8, T>& x, std::size_t axis) {
    const auto edge = [&](std::size_t from, std::size_t to) {
      return Vector3<T>(x[opposite_faces[axis][to]] - x[opposite_faces[axis][from]]);
    };
    const Vector3<T> a = edge(0, 2), b = edge(1, 3), A = edge(4, 6), B = edge(5, 7),  // diagonals of the faces
        along = edge(0, 4) + edge(1, 5) + edge(2, 6) + edge(3, 7);
    const T square = dot(along, along);
    const auto across = [&](const Vector3<T>& u, const Vector3<T>& w) {
      return T(square * dot(u, w) - dot(u, along) * dot(w, along));
    };
    sine = sqrt(square) * dot(Vector3<T>(cross(a, A) + cross(b, B)), along);
    cosine = across(a, A) + across(b, B);
  }
  double degrees() const { return 180 / std::numbers::pi * std::atan2(sine, cosine); }
  /// Positive below 60 degrees: between the twist of a sound cell and the right angle of wrong numbers.
  T margin() const { return std::numbers::sqrt3 * cosine - abs(sine); }
};

/// True if no two corners are the same node.
template <std::size_t N>
bool all_differ(const std::array<Index, N>& cell) {
  bool differ = true;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < i; ++j) differ = differ && cell[i] != cell[j];
  return differ;
}

/// Laws of a shape: the nodes that a cell names, f(CornerJacobian) of its corners, and sentences on a cell that breaks
/// one.
template <CellShape shape>
struct CellLaws;

template <>
struct CellLaws<CellShape::hexahedron> {
  static constexpr const char
      *name = "hexahedron",
      *fault = "flat or inside out",
      *order = "order its corners 0-3 around the bottom and 4-7 above them, right-handed.",
      *corners =
          "give it 8 different corners, or make it a wedge a b c c d e f f or a pyramid a b c d e e e "
          "e.";

  /// A wedge and a pyramid may be numbered from any of their corners.
  static bool names_right(const std::array<Index, 8>& cell) {
    return all_differ(cell) || DegenerateHexahedron(cell).kind != HexahedronKind::other;
  }
  /// Of a wedge and a pyramid the corners with three edges, as wedge_cell and pyramid_cell number them.
  template <class T>
  static void each_corner(const std::array<Index, 8>& cell, const CellCorners<8, T>& x_given, const auto& f) {
    const DegenerateHexahedron degenerate(cell);
    const CellCorners<8, T> x = in_order(x_given, degenerate.order);
    const auto edges = [&](unsigned i, unsigned a, unsigned b, unsigned c) {
      f(CornerJacobian<T>(x[a] - x[i], x[b] - x[i], x[c] - x[i]));
    };
    if (degenerate.kind == HexahedronKind::wedge) {
      edges(0, 1, 2, 4), edges(1, 2, 0, 5), edges(2, 0, 1, 6);
      edges(4, 6, 5, 0), edges(5, 4, 6, 1), edges(6, 5, 4, 2);
      return;
    }
    if (degenerate.kind == HexahedronKind::pyramid) {
      edges(0, 1, 3, 4), edges(1, 2, 0, 4), edges(2, 3, 1, 4), edges(3, 0, 2, 4);
      return;
    }
    // The neighbours of each corner, so that their edges are right-handed.
    constexpr std::array<std::array<unsigned, 3>, 8> neighbours{
        {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
    for (unsigned i = 0; i < 8; ++i) edges(i, neighbours[i][0], neighbours[i][1], neighbours[i][2]);
  }
  /// f(axis, Twist) of the axes about which the cell has two faces: of a wedge the one from triangle to triangle.
  template <class T>
  static void each_twist(const std::array<Index, 8>& cell, const CellCorners<8, T>& x, const auto& f) {
    const DegenerateHexahedron degenerate(cell);
    const bool is_wedge = degenerate.kind == HexahedronKind::wedge;
    if (degenerate.kind == HexahedronKind::pyramid) return;
    for (std::size_t axis = is_wedge ? 2 : 0; axis < 3; ++axis) f(axis, Twist<T>(in_order(x, degenerate.order), axis));
  }
  static double volume(const CellCorners<8>& x) { return hexahedron_volume(x, {0, 1, 2, 3, 4, 5, 6, 7}); }
};

template <>
struct CellLaws<CellShape::tetrahedron> {
  static constexpr const char *name = "tetrahedron", *fault = "flat or inside out",
                              *order = "order its corners so that 3 lies above the counter-clockwise 0-1-2.",
                              *corners = "give it 4 different corners.";

  static bool names_right(const std::array<Index, 4>& cell) { return all_differ(cell); }
  static void each_corner(const std::array<Index, 4>&, const CellCorners<4>& x, const auto& f) {
    f(CornerJacobian<double>(x[1] - x[0], x[2] - x[0], x[3] - x[0]));  // the others have the same sign
  }
  static double volume(const CellCorners<4>& x) { return tetrahedron_volume(x, {0, 1, 2, 3}); }
};

template <>
struct CellLaws<CellShape::quadrilateral> {
  static constexpr const char *name = "quadrilateral", *fault = "crossed, concave or flat",
                              *order = "list its corners in order around a convex shape.",
                              *corners = "give it 4 different corners, or 3 of which one stands twice in a row.";

  /// A triangle names one of its corners twice in a row.
  static bool names_right(const std::array<Index, 4>& cell) {
    int alike = 0;
    for (std::size_t i = 0; i < 4; ++i) alike += cell[i] == cell[(i + 1) % 4];
    return alike <= 1 && cell[0] != cell[2] && cell[1] != cell[3];
  }
  /// The triple product with the normal stands for the Jacobian.
  static void each_corner(const std::array<Index, 4>& cell, const CellCorners<4>& x, const auto& f) {
    const Eigen::Vector3d area = cross<double>(x[2] - x[0], x[3] - x[1]);
    for (std::size_t i = 0; i < 4; ++i) {
      std::size_t next = (i + 1) % 4, last = (i + 3) % 4;
      if (cell[next] == cell[i]) next = (i + 2) % 4;
      if (cell[last] == cell[i]) last = (i + 2) % 4;
      f(CornerJacobian<double>(x[next] - x[i], x[last] - x[i], area));
    }
  }
};

template <>
struct CellLaws<CellShape::triangle> {
  static constexpr const char *name = "triangle", *fault = "flat", *order = "give it corners that are not in one line.",
                              *corners = "give it 3 different corners.";

  static bool names_right(const std::array<Index, 3>& cell) { return all_differ(cell); }
  /// As of a quadrilateral.
  static void each_corner(const std::array<Index, 3>&, const CellCorners<3>& x, const auto& f) {
    const Eigen::Vector3d area = cross<double>(x[1] - x[0], x[2] - x[0]);
    for (std::size_t i = 0; i < 3; ++i) f(CornerJacobian<double>(x[(i + 1) % 3] - x[i], x[(i + 2) % 3] - x[i], area));
  }
};

/// 1 if all corners of a cell have a scaled Jacobian larger than `least` and it is not twisted, otherwise 0.
template <CellShape shape, class T, std::size_t N>
T is_well_shaped(const std::array<Index, N>& cell, const CellCorners<N, T>& x, double least = flat) {
  T well = T(1.0);
  const auto demand = [&](const T& margin) { well = select(margin > 0.0, well, T(0.0)); };  // NaN is no margin
  CellLaws<shape>::each_corner(cell, x, [&](const auto& corner) { demand(corner.margin(least)); });
  if constexpr (shape == CellShape::hexahedron)
    CellLaws<shape>::each_twist(cell, x, [&](std::size_t, const Twist<T>& twist) { demand(twist.margin()); });
  return well;
}
/// A cell breaks none of the laws of its shape.
template <CellShape shape, std::size_t N>
bool is_sound(const std::array<Index, N>& cell, const CellCorners<N>& x) {
  return CellLaws<shape>::names_right(cell) && is_well_shaped<shape, double>(cell, x) > 0;
}

/// The law that a cell breaks, as the end of a sentence on it.
template <CellShape shape, std::size_t N>
[[gnu::cold]] std::string fault_of(const std::array<Index, N>& cell, const CellCorners<N>& x) {
  using Laws = CellLaws<shape>;
  if (!Laws::names_right(cell)) {
    std::size_t i = 1;
    while (std::find(cell.begin(), cell.begin() + i, cell[i]) == cell.begin() + i) ++i;
    return joined({"names node ", std::to_string(cell[i]), " twice; ", Laws::corners});
  }
  double least = std::numeric_limits<double>::infinity();  // scaled Jacobian
  std::size_t corners = 0, corner = 0;
  bool wrong = false;
  Laws::each_corner(cell, x, [&](const auto& at) {
    if (at.scaled() < least) least = at.scaled(), corner = corners;
    wrong = wrong || !(at.margin(flat) > 0);
    ++corners;
  });
  if (wrong) {
    std::string where, volume;
    if constexpr (shape != CellShape::tetrahedron) where = " at corner " + std::to_string(corner);
    if constexpr (requires { Laws::volume(x); }) volume = joined({" (volume ", text(Laws::volume(x)), ")"});
    return joined({"is ", Laws::fault, where, volume, "; ", Laws::order});
  }
  std::string twisted;
  if constexpr (shape == CellShape::hexahedron)
    Laws::each_twist(cell, x, [&](std::size_t axis, const Twist<double>& twist) {
      if (twist.margin() > 0 || !twisted.empty()) return;
      std::array<std::string, 2> faces;
      const CornerOrder order = DegenerateHexahedron(cell).order;
      for (std::size_t i = 0; i < 8; ++i) faces[i / 4] += " " + std::to_string(order[opposite_faces[axis][i]]);
      twisted = joined({"is twisted: corners", faces[1], " are turned against", faces[0], " by ",
                        text(std::round(twist.degrees())), " degrees; ", Laws::order});
    });
  return twisted;
}

}  // namespace strike::detail
