#pragma once
#include <array>
#include <cmath>
#include <utility>

#include <strike/mesh/count.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

namespace strike {

/// Quadrilaterals of a curved sheet: `cells` along s and t of the unit square, whose points lie at place(s, t)
/// [length]. Nodes and cells are numbered along s first; the sheet faces the side of dx/ds cross dx/dt.
///   const Mesh dome = sheet({16, 16}, [](double s, double t) { return Eigen::Vector3d(s, t, std::sin(s)); });
/// Errors: no cells.
template <class Place>
Mesh sheet(std::array<Index, 2> cells, Place&& place) {
  const auto [n, m] = cells;
  detail::RangeCheck("sheet", "")("cells", cells, range::count);
  detail::check_count("cells of a sheet", (n + 1.0) * (m + 1.0));
  Mesh mesh;
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i) mesh.nodes.emplace_back(place(double(i) / n, double(j) / m));
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + n + 1;
      mesh.quadrilaterals.push_back({a, a + 1, b + 1, b});
    }
  return mesh;
}

/// A rectangle in a plane z.
struct RectangleShape {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< corner of smallest x and y [length]
  std::array<double, 2> size;                       ///< edges along x and y [length]
  std::array<Index, 2> cells{1, 1};                 ///< quadrilaterals along x and y

  void ranges(const auto& number) const {
    number("lower", lower, range::point);
    number("size", size, range::positive);
    number("cells", cells, range::count);
  }
};

/// Quadrilaterals that fill a rectangle, facing +z. Errors: an edge that is not positive, no cells.
inline Mesh rectangle(const RectangleShape& shape) {
  detail::check_ranges(shape);
  return sheet(shape.cells, [&](double s, double t) {
    const Eigen::Vector3d& lower = shape.lower;
    return Eigen::Vector3d(lower(0) + s * shape.size[0], lower(1) + t * shape.size[1], lower(2));
  });
}

/// A part of a cylinder about the y axis; its crown, at the angle 0, lies on +z.
struct PanelShape {
  double radius;                     ///< [length]
  double length;                     ///< along y, from 0 [length]
  std::array<double, 2> arc;         ///< angles of its edges, positive towards +x [rad]
  std::array<Index, 2> cells{1, 1};  ///< quadrilaterals along the arc and along y

  void ranges(const auto& number) const {
    number("radius", radius, range::positive);
    number("length", length, range::positive);
    number("arc", arc, range::finite);
    number("arc[1]", arc[1], range::above(arc[0]));
    number("cells", cells, range::count);
  }
};

/// Quadrilaterals on a part of a cylinder, facing outward. Errors: a radius, length or arc that is not positive, no
/// cells.
inline Mesh panel(const PanelShape& shape) {
  detail::check_ranges(shape);
  return sheet(shape.cells, [&](double s, double t) {
    const double angle = shape.arc[0] + s * (shape.arc[1] - shape.arc[0]);
    return Eigen::Vector3d(shape.radius * std::sin(angle), t * shape.length, shape.radius * std::cos(angle));
  });
}

}  // namespace strike
