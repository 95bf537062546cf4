#pragma once
#include <cmath>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/text.hpp>

namespace strike {

/// A round bar along z with its foot at z = 0.
struct CylinderShape {
  double radius;                    ///< [length]
  double length;                    ///< [length]
  Index cells = 3;                  ///< hexahedra along each edge of a block
  Index layers = 50;                ///< hexahedra along z
  Sector sector = Sector::quarter;  ///< quarter, half or full
  double grading = 1;               ///< length of the last layer (z = length) over the first (z = 0)
};

/// Hexahedra of a round bar in the butterfly pattern ("O-grid"): 3 cells^2 per quarter and layer. The nodes of the
/// mantle lie on the circle at equal angles, those of the symmetry planes exactly in them. Layer follows layer from the
/// foot. `cylinder({.radius = 3.2, .length = 32.4})` is the mesh of 1350 hexahedra of the Taylor bar of X3D. Volume per
/// quarter: cells R^2 sin(pi / (4 cells)) L. Errors: radius, length, cells, layers or grading not positive.
inline Mesh cylinder(const CylinderShape& shape) {
  if (!(shape.radius > 0) || !(shape.length > 0) || !std::isfinite(shape.radius * shape.length))
    throw Error(detail::joined({"strike: a cylinder of radius ", detail::text(shape.radius), " and length ",
                                detail::text(shape.length), " has no volume; give positive lengths."}));
  if (shape.cells < 1 || shape.layers < 1)
    throw Error("strike: a cylinder has no cells or no layers; give 1 or more in `.cells` and `.layers`.");
  const Mesh plan = scaled(detail::unit_disc(shape.cells, shape.sector), {shape.radius, shape.radius, 1});
  return extruded(plan, graded(0, shape.length, shape.layers, shape.grading));
}

}  // namespace strike
