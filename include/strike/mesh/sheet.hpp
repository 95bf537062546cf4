#pragma once
#include <array>
#include <cmath>
#include <utility>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike {

/// Quadrilaterals of a curved sheet: `cells` along s and t of the unit square, whose points lie at place(s, t)
/// [length]. Nodes and cells are numbered along s first; the sheet faces the side of dx/ds cross dx/dt.
///   const Mesh dome = sheet({16, 16}, [](double s, double t) { return Eigen::Vector3d(s, t, std::sin(s)); });
/// Errors: no cells, 2^32 nodes or more.
template <class Place>
Mesh sheet(std::array<Index, 2> cells, Place&& place) {
  const auto [n, m] = cells;
  if (n < 1 || m < 1)
    throw Error(detail::joined({"strike: a sheet of ", std::to_string(n), " x ", std::to_string(m),
                                " cells is empty; give 1 or more along both sides."}));
  detail::check_count((n + 1.0) * (m + 1.0));
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
};

/// Quadrilaterals that fill a rectangle, facing +z. Errors: an edge that is not positive, no cells.
inline Mesh rectangle(const RectangleShape& shape) {
  const double width = shape.size[0], height = shape.size[1];
  if (!(width > 0 && height > 0) || !std::isfinite(width + height))
    throw Error(detail::joined({"strike: a rectangle of size ", detail::text(width), " x ", detail::text(height),
                                " has no area; give two positive edges in `.size`."}));
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
};

/// Quadrilaterals on a part of a cylinder, facing outward. Errors: a radius, length or arc that is not positive, no
/// cells.
inline Mesh panel(const PanelShape& shape) {
  const double from = shape.arc[0], to = shape.arc[1];
  if (!(shape.radius > 0 && shape.length > 0 && to > from) || !std::isfinite(shape.radius + shape.length + to - from))
    throw Error(detail::joined({"strike: a panel of radius ", detail::text(shape.radius), ", length ",
                                detail::text(shape.length), " and arc ", detail::text(from), " to ", detail::text(to),
                                " has no area; give positive ones, the arc ascending."}));
  return sheet(shape.cells, [&](double s, double t) {
    const double angle = shape.arc[0] + s * (shape.arc[1] - shape.arc[0]);
    return Eigen::Vector3d(shape.radius * std::sin(angle), t * shape.length, shape.radius * std::cos(angle));
  });
}

}  // namespace strike
