#pragma once
#include <strike/mesh/count.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/range.hpp>

namespace strike {

/// A round bar along z with its foot at z = 0.
struct CylinderShape {
  double radius;                    ///< [length]
  double length;                    ///< [length]
  Index cells = 3;                  ///< hexahedra along each edge of a block
  Index layers = 50;                ///< hexahedra along z
  Sector sector = Sector::quarter;  ///< quarter, half or full
  double grading = 1;               ///< length of the last layer (z = length) over the first (z = 0)

  void ranges(const auto& number) const {
    number("radius", radius, range::positive);
    number("length", length, range::positive);
    number("cells", cells, range::count);
    number("layers", layers, range::count);
    number("grading", grading, range::positive);
  }
};

/// Hexahedra of a round bar in the butterfly pattern ("O-grid"): 3 cells^2 per quarter and layer. The nodes of the
/// mantle lie on the circle at equal angles, those of the symmetry planes exactly in them. Layer follows layer from the
/// foot. `cylinder({.radius = 3.2, .length = 32.4})` is the mesh of 1350 hexahedra of the Taylor bar of X3D. Volume per
/// quarter: cells R^2 sin(pi / (4 cells)) L. Errors: a number out of its range; 2^32 nodes or more.
inline Mesh cylinder(const CylinderShape& shape) {
  detail::check_ranges(shape);
  detail::check_count("cells of a cylinder", detail::disc_nodes(shape.cells, shape.sector) * (shape.layers + 1.0));
  const Mesh plan = scaled(detail::unit_disc(shape.cells, shape.sector), {shape.radius, shape.radius, 1});
  return extruded(plan, graded(0, shape.length, shape.layers, shape.grading));
}

}  // namespace strike
