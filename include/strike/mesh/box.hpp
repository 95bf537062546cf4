#pragma once
#include <array>
#include <vector>

#include <strike/mesh/count.hpp>
#include <strike/mesh/grading.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

namespace strike {

/// A brick with edges along the axes.
struct BoxShape {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< corner of smallest coordinates [length]
  Eigen::Vector3d size;                             ///< edges [length]
  std::array<Index, 3> cells{1, 1, 1};              ///< hexahedra along x, y, z
  std::array<double, 3> grading{1, 1, 1};           ///< length of the last cell over the first along x, y, z

  void ranges(const auto& number) const {
    number("lower", lower, range::point);
    number("size", size, range::positive);
    number("cells", cells, range::count);
    number("grading", grading, range::positive);
  }
};

/// Hexahedra that fill a box. Nodes and cells are numbered along x first, then y, then z.
/// Errors: a number out of its range; 2^32 nodes or more.
inline Mesh box(const BoxShape& shape) {
  detail::check_ranges(shape);
  const auto [nx, ny, nz] = shape.cells;
  detail::check_count("cells of a box", (nx + 1.0) * (ny + 1.0) * (nz + 1.0));
  std::array<std::vector<double>, 3> position;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    position[axis] = graded(shape.lower[a], shape.lower[a] + shape.size[a], shape.cells[axis], shape.grading[axis]);
  }

  Mesh mesh;
  for (const double z : position[2])
    for (const double y : position[1])
      for (const double x : position[0]) mesh.nodes.emplace_back(x, y, z);
  const auto node = [nx = nx, ny = ny](Index i, Index j, Index k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i)
        mesh.hexahedra.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                                  node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                  node(i, j + 1, k + 1)});
  return mesh;
}

}  // namespace strike
