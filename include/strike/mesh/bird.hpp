#pragma once
#include <cmath>
#include <numbers>
#include <utility>

#include <strike/error.hpp>
#include <strike/mesh/count.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

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

  void ranges(const auto& number) const {
    number("mass", mass, range::positive);
    number("density", density, range::positive);
    number("aspect", aspect, form == BirdForm::hemispherical_ends ? range::above(1) : range::positive,
           "a body with hemispherical ends is longer than wide, others have any shape");
    number("cells", cells, range::count);
    number("layers", layers, range::count);
  }
};

namespace detail {
/// V/(pi D^3) of the smooth body of an aspect L/D.
inline double volume_per_cube(BirdForm form, double aspect) {
  return form == BirdForm::cylinder ? aspect / 4 : form == BirdForm::ellipsoid ? aspect / 6 : aspect / 4 - 1.0 / 12;
}
}  // namespace detail

/// Size of the smooth body of a bird [length].
struct BirdSize {
  double diameter, length;
};
inline BirdSize size_of(const BirdShape& shape) {
  detail::check_ranges(shape);
  const double a = shape.aspect, V = shape.mass / shape.density;
  const double D = std::cbrt(V / (std::numbers::pi * detail::volume_per_cube(shape.form, a)));
  if (!(D > 0) || !std::isfinite(D))
    throw Error(detail::joined({"strike: a bird of mass ", detail::text(shape.mass), " and density ",
                                detail::text(shape.density), " has no size that is a number; correct them."}));
  return {D, a * D};
}

/// Hexahedra of a bird in the butterfly pattern; `tetrahedralized(bird(...))` splits them. The mesh has exactly the
/// mass: its flat faces cut into the smooth body, so it is longer and wider than that, by 0.4 % with three cells (a
/// ball by 0.6 %). Errors: mass, density, aspect, cells or layers not positive; hemispherical ends on a body no longer
/// than wide.
inline Mesh bird(const BirdShape& shape) {
  const auto [D, L] = size_of(shape);
  detail::check_count(
      "cells and layers of a bird",
      detail::ball_nodes(shape.cells) + detail::disc_nodes(shape.cells, Sector::full) * (shape.layers + 1.0));
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
