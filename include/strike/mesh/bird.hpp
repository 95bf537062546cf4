#pragma once
#include <cmath>
#include <numbers>
#include <utility>

#include <strike/error.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/transform.hpp>

namespace strike {

/// The substitute body of a bird: a right cylinder, one with hemispherical ends, or an ellipsoid of revolution.
enum class BirdForm { cylinder, hemispherical_ends, ellipsoid };

/// A bird along z, its nose at z = 0.
struct BirdShape {
  double mass;     ///< of the whole bird, whatever the sector
  double density;  ///< [mass / length^3]
  BirdForm form = BirdForm::cylinder;
  double aspect = 2;                ///< length over diameter
  Index cells = 3;                  ///< hexahedra along each edge of a block
  Index layers = 16;                ///< along the straight part; an ellipsoid has none
  Sector sector = Sector::quarter;  ///< quarter, half or full
};

/// Size of the smooth body of a bird [length].
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

/// Hexahedra of a bird in the butterfly pattern; `tetrahedralized(bird(...))` splits them. The mesh has exactly the
/// mass: its flat faces cut into the smooth body, so it is longer and wider than that, by 0.4 % with three cells (a
/// ball by 0.6 %). Errors: mass, density, aspect, cells or layers not positive; hemispherical ends on a body no longer
/// than wide.
inline Mesh bird(const BirdShape& shape) {
  const auto [D, L] = size_of(shape);
  if (!(shape.mass > 0) || !(shape.density > 0) || !(shape.aspect > 0) || !std::isfinite(D))
    throw Error("strike: a bird needs a positive mass, density and aspect; correct them.");
  if (shape.cells < 1 || shape.layers < 1)
    throw Error("strike: a bird has no cells or no layers; give 1 or more in `.cells` and `.layers`.");
  if (shape.form == BirdForm::hemispherical_ends && !(shape.aspect > 1))
    throw Error(
        "strike: a bird with hemispherical ends is longer than wide; give an `.aspect` above 1, or take an ellipsoid.");
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
