#pragma once
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <strike/mesh/count.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/range.hpp>

namespace strike {

/// The meshed part of a round body; the rest follows by symmetry.
enum class Sector {
  quarter,  ///< x >= 0, y >= 0
  half,     ///< y >= 0
  full
};

/// A round plate about the origin, in the plane z = 0.
struct DiscShape {
  double radius;                 ///< [length]
  Index cells = 3;               ///< quadrilaterals along each edge of a block
  Sector sector = Sector::full;  ///< quarter, half or full

  void ranges(const auto& number) const {
    number("radius", radius, range::positive);
    number("cells", cells, range::count);
  }
};

namespace detail {

/// Quadrilaterals of a quarter disc of unit radius, x >= 0 and y >= 0: a core of n x n about the axis and two outer
/// blocks of n x n around it. It is exactly symmetric about x = y, and its edges lie exactly on the axes.
inline Mesh quarter_disc(Index n) {
  // Corners of the core at (side, 0), (corner, corner), (0, side): inside and around it cells are about equally long.
  constexpr double side = 0.55, corner = 0.42;
  Mesh disc;
  const auto core = [&](Index i, Index j) -> Eigen::Vector3d {
    const double u = double(i) / n, v = double(j) / n;
    return {u * (side + v * (corner - side)), v * (side + u * (corner - side)), 0};
  };
  const auto arc = [&](Index k) -> Eigen::Vector3d {  // k-th of 2 n equal angles
    if (k == n) return {std::sqrt(0.5), std::sqrt(0.5), 0};
    const double angle = std::numbers::pi / 4 * (k < n ? k : 2 * n - k) / n;
    const double near = std::cos(angle), far = std::sin(angle);
    return k < n ? Eigen::Vector3d{near, far, 0} : Eigen::Vector3d{far, near, 0};
  };
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) disc.nodes.push_back(core(i, j));
  for (Index ring = 1; ring <= n; ++ring)
    for (Index k = 0; k <= 2 * n; ++k) {
      const double t = double(ring) / n;
      const Eigen::Vector3d edge = k <= n ? core(n, k) : core(2 * n - k, n);
      disc.nodes.push_back(ring == n ? arc(k) : (1 - t) * edge + t * arc(k));
    }

  const auto core_node = [n](Index i, Index j) { return i + (n + 1) * j; };
  const auto node = [&](Index ring, Index k) {  // ring 0 is the outer edge of the core
    if (ring == 0) return k <= n ? core_node(n, k) : core_node(2 * n - k, n);
    return (n + 1) * (n + 1) + (ring - 1) * (2 * n + 1) + k;
  };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      disc.quadrilaterals.push_back(
          {core_node(i, j), core_node(i + 1, j), core_node(i + 1, j + 1), core_node(i, j + 1)});
  for (Index ring = 0; ring < n; ++ring)
    for (Index k = 0; k < 2 * n; ++k)
      disc.quadrilaterals.push_back({node(ring, k), node(ring + 1, k), node(ring + 1, k + 1), node(ring, k + 1)});
  return disc;
}

/// Nodes of the quarters of a disc, before they are joined.
inline double disc_nodes(double cells, Sector sector) {
  const double quarters = sector == Sector::quarter ? 1 : sector == Sector::half ? 2 : 4;
  return quarters * ((cells + 1) * (cells + 1) + cells * (2 * cells + 1));
}
/// The disc of unit radius, or its half or quarter: the quarter and its exact turns by right angles, joined.
inline Mesh unit_disc(Index cells, Sector sector) {
  Mesh quarter = quarter_disc(cells), whole = quarter;
  const int turns = sector == Sector::quarter ? 0 : sector == Sector::half ? 1 : 3;
  for (int turn = 0; turn < turns; ++turn) {
    quarter = transformed(std::move(quarter), [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return {0 - x[1], x[0], x[2]};  // 0 - y, so that no -0 appears
    });
    append(whole, quarter);
  }
  return turns > 0 ? merge_coincident_nodes(std::move(whole), 1e-6 / cells) : whole;
}

}  // namespace detail

/// Quadrilaterals of a disc in the butterfly pattern ("O-grid"), facing +z: 3 cells^2 per quarter. The nodes of the rim
/// lie on the circle at equal angles, those of symmetry planes exactly in them. Area per quarter: cells R^2 sin(pi / (4
/// cells)). Errors: a number out of its range; 2^32 nodes or more.
inline Mesh disc(const DiscShape& shape) {
  detail::check_ranges(shape);
  detail::check_count("cells of a disc", detail::disc_nodes(shape.cells, shape.sector));
  return scaled(detail::unit_disc(shape.cells, shape.sector), {shape.radius, shape.radius, 1});
}

}  // namespace strike
