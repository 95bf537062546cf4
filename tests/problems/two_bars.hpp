#pragma once
// Two equal steel bars along x that meet, of hexahedra much wider than long, whose stable step is h/c: the linear wave
// in one direction.
#include <cmath>
#include <utility>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"

namespace strike::two_bars {

inline constexpr double L = 1, E = 200e9, rho = 7850;  // [m, Pa, kg/m3]
inline const double c = std::sqrt(E / rho);

struct Bars {
  Index cells;
  double h = L / cells, width = 300 * h;
  Mesh left = translated(column(cells, L, width), {-L, 0, 0}), mesh = left;
  Index first_right = append(mesh, column(cells, L, width));

  explicit Bars(Index number) : cells(number) {}

  std::vector<Face> end(bool right) const {
    std::vector<Face> faces;
    for (const Face& face : surface(mesh)) {
      bool at_end = true;
      for (const Index i : face.nodes) at_end &= std::abs(mesh.nodes[i].x()) < 1e-9 * L && (i >= first_right) == right;
      if (at_end) faces.push_back(face);
    }
    return faces;
  }
  /// The bars with their velocities, disturbed by `noise` times a wild function of the place.
  template <class... Things>
  auto run(double v_left, double v_right, double noise, const ExplicitOptions& options, Things... things) const {
    const auto field = [=](const Eigen::Vector3d& x) {
      return Eigen::Vector3d((x.x() < 0 ? v_left : v_right) + noise * std::sin(1e4 * x.x() + 1), 0, 0);
    };
    return Explicit{
        Scene{mesh.nodes,
              Part{Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}}, Elastic{.density = rho, .youngs_modulus = E},
                   mesh.hexahedra},
              std::move(things)..., InitialVelocityField{field}, InitialVelocity{{v_left, 0, 0}, end_nodes(false)},
              InitialVelocity{{v_right, 0, 0}, end_nodes(true)}},
        options, in<double>};
  }
  std::vector<Index> end_nodes(bool right) const { return surface_nodes(end(right)); }
};

}  // namespace strike::two_bars
