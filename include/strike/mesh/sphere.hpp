#pragma once
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <strike/mesh/count.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// A ball about the origin.
struct SphereShape {
  double radius;                 ///< [length]
  Index cells = 3;               ///< hexahedra along each edge of a block
  Sector sector = Sector::full;  ///< quarter, half or full, cut by the planes x = 0 and y = 0

  void ranges(const auto& number) const {
    number("radius", radius, range::positive);
    number("cells", cells, range::count);
  }
};

namespace detail {

/// Nodes of the octants of a ball, before they are joined.
inline double ball_nodes(double cells) { return 8 * (cells + 1) * (cells + 1) * (4 * cells + 1); }
/// Hexahedra of the octant of the unit ball where no coordinate is negative: a core of n^3 and three outer blocks of
/// n^3 on its faces. In the plane z = 0 it is the quarter disc of as many cells.
inline Mesh ball_octant(Index n) {
  constexpr double side = 0.55, edge = 0.42, corner = 0.36;  // of the core, on an axis, between two and between three
  const auto core = [](const Eigen::Vector3d& u) {
    const auto along = [&](int i) {
      const double v = u[(i + 1) % 3], w = u[(i + 2) % 3];
      return u[i] * (side + (edge - side) * (v + w) + (corner - 2 * edge + side) * v * w);
    };
    return Eigen::Vector3d(along(0), along(1), along(2));
  };
  const auto sphere = [](const Eigen::Vector3d& u) {  // at equal angles
    constexpr double quarter = std::numbers::pi / 4;
    return direction({std::tan(quarter * u[0]), std::tan(quarter * u[1]), std::tan(quarter * u[2])});
  };
  Mesh ball;
  std::map<std::array<Index, 4>, Index> known;
  const auto node = [&](Index i, Index j, Index k, Index ring) {
    const auto [place, is_new] = known.insert({{i, j, k, ring}, static_cast<Index>(ball.nodes.size())});
    if (is_new) {
      const Eigen::Vector3d u = Eigen::Vector3d(i, j, k) / double(n);
      const double t = double(ring) / n;
      ball.nodes.push_back(ring == 0 ? core(u) : (1 - t) * core(u) + t * sphere(u));
    }
    return place->second;
  };
  for (Index k = 0; k < n; ++k)
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i)
        ball.hexahedra.push_back({node(i, j, k, 0), node(i + 1, j, k, 0), node(i + 1, j + 1, k, 0),
                                  node(i, j + 1, k, 0), node(i, j, k + 1, 0), node(i + 1, j, k + 1, 0),
                                  node(i + 1, j + 1, k + 1, 0), node(i, j + 1, k + 1, 0)});
  for (int face = 0; face < 3; ++face)
    for (Index ring = 0; ring < n; ++ring)
      for (Index a = 0; a < n; ++a)
        for (Index b = 0; b < n; ++b) {
          const auto on_face = [&](Index p, Index q, Index r) {
            return face == 0 ? node(n, p, q, r) : face == 1 ? node(q, n, p, r) : node(p, q, n, r);
          };
          ball.hexahedra.push_back({on_face(a, b, ring), on_face(a + 1, b, ring), on_face(a + 1, b + 1, ring),
                                    on_face(a, b + 1, ring), on_face(a, b, ring + 1), on_face(a + 1, b, ring + 1),
                                    on_face(a + 1, b + 1, ring + 1), on_face(a, b + 1, ring + 1)});
        }
  return ball;
}

/// Adds the mirror image in the plane through the origin with the given normal, without joining nodes.
inline void append_mirrored(Mesh& mesh, const Eigen::Vector3d& normal) { append(mesh, mirrored(mesh, normal)); }

}  // namespace detail

/// Hexahedra of a ball: in each octant a core of cells^3 and three outer blocks of cells^3 on it, 32 cells^3 in all.
/// The nodes of the surface lie on the sphere, those of the planes x = 0, y = 0 and z = 0 exactly in them. The flat
/// faces cut off 0.27/cells^2 of the volume. The upper half of the ball, or with Sector::quarter an octant:
///   const auto above = [](const auto& x) { return x[2] > 0; };
///   ball.hexahedra = cells_of(ball.hexahedra, cells_where(ball.nodes, ball.hexahedra, above));
///   ball = remove_orphan_nodes(ball);
/// Errors: a number out of its range; 2^32 nodes or more.
inline Mesh sphere(const SphereShape& shape) {
  detail::check_ranges(shape);
  detail::check_count("cells of a sphere", detail::ball_nodes(shape.cells));
  Mesh mesh = detail::ball_octant(shape.cells);
  detail::append_mirrored(mesh, {0, 0, 1});
  if (shape.sector != Sector::quarter) detail::append_mirrored(mesh, {1, 0, 0});
  if (shape.sector == Sector::full) detail::append_mirrored(mesh, {0, 1, 0});
  mesh = merge_coincident_nodes(std::move(mesh), 1e-6 / shape.cells);
  return scaled(std::move(mesh), {shape.radius, shape.radius, shape.radius});
}

}  // namespace strike
