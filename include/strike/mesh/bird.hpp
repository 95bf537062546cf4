#pragma once
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>

namespace strike {

/// What stands for a bird: a right cylinder, one with hemispherical ends, or an ellipsoid of revolution.
enum class BirdForm { cylinder, hemispherical_ends, ellipsoid };

/// A bird along z, its nose at z = 0.
struct BirdShape {
  double mass;     ///< of the whole bird, whatever sector is meshed
  double density;  ///< [mass / length^3]
  BirdForm form = BirdForm::cylinder;
  double aspect = 2;                ///< length over diameter
  Index cells = 3;                  ///< hexahedra along each edge of a block
  Index layers = 16;                ///< along the straight part; an ellipsoid has none
  Sector sector = Sector::quarter;  ///< quarter, half or full
};

/// Its smooth body [length].
struct BirdSize {
  double diameter, length;
};
inline BirdSize size_of(const BirdShape& shape) {
  const double a = shape.aspect, V = shape.mass / shape.density;
  const double per_cube = shape.form == BirdForm::cylinder    ? a / 4
                          : shape.form == BirdForm::ellipsoid ? a / 6
                                                              : a / 4 - 1.0 / 12;  // V/(pi D^3)
  const double D = std::cbrt(V / (std::numbers::pi * per_cube));
  return {D, a * D};
}

namespace detail {

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
    return Eigen::Vector3d(std::tan(quarter * u[0]), std::tan(quarter * u[1]), std::tan(quarter * u[2])).normalized();
  };
  Mesh ball;
  std::map<std::array<Index, 4>, Index> known;
  const auto node = [&](Index i, Index j, Index k, Index ring) {
    const auto [place, is_new] = known.insert({{i, j, k, ring}, static_cast<Index>(ball.nodes.size())});
    if (is_new) {
      const Eigen::Vector3d u = Eigen::Vector3d(i, j, k) / n;
      const double t = double(ring) / n;
      ball.nodes.push_back(ring == 0 ? core(u) : Eigen::Vector3d((1 - t) * core(u) + t * sphere(u)));
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
          std::array<Index, 8> cell;
          for (Index r = 0; r < 2; ++r)
            cell[4 * r] = on_face(a, b, ring + r), cell[4 * r + 1] = on_face(a + 1, b, ring + r),
                     cell[4 * r + 2] = on_face(a + 1, b + 1, ring + r), cell[4 * r + 3] = on_face(a, b + 1, ring + r);
          ball.hexahedra.push_back(cell);
        }
  return ball;
}

inline void append_mirrored(Mesh& mesh, const Eigen::Vector3d& normal) { append(mesh, mirrored(mesh, normal)); }

}  // namespace detail

/// Hexahedra of a bird in the butterfly pattern; `tetrahedralized(bird(...))` are its tetrahedra. The mesh has exactly
/// the mass: it is larger than the smooth body by what its flat faces cut off, with three cells 0.4 % in its lengths (a
/// ball 0.6 %). Errors: mass, density, aspect, cells or layers not positive; hemispherical ends on a body no longer
/// than wide.
inline Mesh bird(const BirdShape& shape) {
  const auto [D, L] = size_of(shape);
  if (!(shape.mass > 0) || !(shape.density > 0) || !(shape.aspect > 0) || !std::isfinite(D))
    throw Error("A bird needs a positive mass, density and aspect: correct them.");
  if (shape.cells < 1 || shape.layers < 1)
    throw Error("A bird needs at least one of `.cells` and of `.layers`: ask for 1 or more.");
  if (shape.form == BirdForm::hemispherical_ends && !(shape.aspect > 1))
    throw Error("A bird with hemispherical ends is longer than wide: give an `.aspect` above 1, or take an ellipsoid.");
  Mesh mesh;
  if (shape.form == BirdForm::cylinder) {
    mesh = cylinder(
        {.radius = D / 2, .length = L, .cells = shape.cells, .layers = shape.layers, .sector = Sector::quarter});
  } else {
    const bool straight = shape.form == BirdForm::hemispherical_ends;
    const double half = straight ? (L - D) / 2 : 0, z = straight ? D / 2 : L / 2;
    mesh = translated(scaled(detail::ball_octant(shape.cells), {D / 2, D / 2, z}), {0, 0, half});
    detail::append_mirrored(mesh, {0, 0, 1});
    if (straight) {
      const Mesh plan = scaled(detail::quarter_disc(shape.cells), {D / 2, D / 2, 1});
      append(mesh, extruded(plan, graded(-half, half, shape.layers, 1)));
    }
    mesh = translated(std::move(mesh), {0, 0, L / 2});
  }
  if (shape.sector != Sector::quarter) detail::append_mirrored(mesh, {1, 0, 0});
  if (shape.sector == Sector::full) detail::append_mirrored(mesh, {0, 1, 0});
  mesh = merge_coincident_nodes(std::move(mesh), 1e-6 * D / shape.cells);

  const double share = shape.sector == Sector::quarter ? 0.25 : shape.sector == Sector::half ? 0.5 : 1;
  const double growth = std::cbrt(share * shape.mass / shape.density / volume(mesh));
  return scaled(std::move(mesh), {growth, growth, growth});
}

}  // namespace strike
