#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// Mass, centre of mass, and moment of inertia about it [mass length^2] of a body.
struct Inertia {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  SymmetricTensor<double> moment = {};

  void ranges(const auto& number) const {
    number("mass", mass, range::not_negative);
    number("centre", centre, range::point);
  }
  /// Adds a point mass, or what another body has.
  void add(double m, const Eigen::Vector3d& x) { add({m, x}); }
  void add(const Inertia& other) {
    const double all = mass + other.mass;
    if (!(all > 0)) return;
    const Eigen::Vector3d apart = other.centre - centre;
    moment += other.moment + (mass * other.mass / all) * about(apart);
    centre += other.mass / all * apart;
    mass = all;
  }
  /// Moment of inertia of a unit mass at r, about the origin: r.r I - r (x) r.
  static SymmetricTensor<double> about(const Eigen::Vector3d& r) {
    return SymmetricTensor<double>::isotropic(r.squaredNorm()) - outer_square<double>(r);
  }
};

/// The inertia of a rigid body as a whole, with the masses that its nodes have from elements, as _INERTIA of LS-DYNA
/// gives it.
///   TotalInertia{{mass, centre, moment}}
struct TotalInertia : Inertia {
  explicit TotalInertia(const Inertia& whole) : Inertia(whole) {}
};

/// Inertia of the cells of a mesh, of this density and, of plates, thickness: exact for trilinear hexahedra,
/// tetrahedra, triangles and bilinear plates (Gauss points). Adds the masses of the nodes, shares of their cells with
/// the same sum and the same centre, to `nodal`. Errors: no cells; plates without a thickness; a density that is not
/// positive.
inline Inertia inertia(const Mesh& mesh, double density, double thickness, std::vector<double>& nodal);
inline Inertia inertia(const Mesh& mesh, double density, double thickness = 0) {
  std::vector<double> nodal(mesh.nodes.size(), 0.0);
  return inertia(mesh, density, thickness, nodal);
}

namespace detail {

/// xx, and the minors to the determinant, are above 0.
inline bool is_positive_definite(const SymmetricTensor<double>& A) {
  return A.xx > 0 && A.xx * A.yy - A.xy * A.xy > 0 && determinant(A) > 0;
}
/// Why no body has this inertia, and what to do; empty if one may. Mass (x - centre)(x - centre), tr(J)/2 I - J, is
/// nowhere negative: no principal moment is larger than the sum of the others. One without moment is a point. Numbers
/// of a few digits pass. `whole`: it has a mass and turns about any axis with a moment of inertia.
inline std::string fault_of(const Inertia& own, bool whole) {
  const SymmetricTensor<double>& J = own.moment;
  const double size = trace(J);
  const std::string is =
      joined({"its moment of inertia has the components ", text(J.xx), ", ", text(J.yy), ", ", text(J.zz), ", ",
              text(J.xy), ", ", text(J.yz), ", ", text(J.zx), " (xx, yy, zz, xy, yz, zx)"});
  const auto lifted = [&](double by) { return SymmetricTensor<double>::isotropic(by * size); };
  const bool is_point = J.xx == 0 && J.yy == 0 && J.zz == 0 && J.xy == 0 && J.yz == 0 && J.zx == 0;
  if (whole && !(own.mass > 0 && own.mass < 1e300))
    return joined({"its mass is ", text(own.mass), "; give its Inertia one above 0"});
  if (is_point && !whole) return "";
  if (!is_positive_definite(J + lifted(whole ? -1e-9 : 1e-5)) || !(size < 1e300))
    return joined({is, ", which is not positive; give principal moments above 0"});
  if (!is_positive_definite(lifted(0.5 + 1e-5) + (-1.0) * J))
    return joined({is,
                   ", of which a principal moment is larger than the sum of the others, as of no body; look at its "
                   "units, its centre and the signs of xy, yz and zx"});
  return "";
}
/// Why no body as a whole has this inertia if its nodes have that of elements; empty if one may. The rest would move
/// elements by a negative mass, and no step would be stable.
inline std::string fault_of(const TotalInertia& whole, const Inertia& of_nodes) {
  const double m = of_nodes.mass, M = whole.mass;
  if (m > (1 + 1e-9) * M)
    return joined({"its total mass is ", text(M), ", and its nodes alone have ", text(m),
                   " from elements; give its TotalInertia at least that, or it an Inertia beside that of its nodes"});
  const SymmetricTensor<double> rest =
      whole.moment + (-1.0) * of_nodes.moment +
      (-M * m / std::max(M - m, 1e-9 * M)) * Inertia::about(of_nodes.centre - whole.centre);
  if (m > 0 && !is_positive_definite(rest + SymmetricTensor<double>::isotropic(1e-6 * trace(whole.moment))))
    return "its total moment of inertia is below that of the masses that its nodes have from elements; give its "
           "TotalInertia a larger one, or it an Inertia beside that of its nodes";
  return "";
}

/// Points and weights of Gauss on [-1, 1], exact to the fifth power.
struct ThreePoints {
  static inline const std::array<double, 3> at{-std::sqrt(0.6), 0, std::sqrt(0.6)}, weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
};

/// Adds a piece of mass m at x, shared by the corners of its cell.
template <std::size_t n>
void add_piece(Inertia& sum, std::vector<double>& nodal, const std::array<Index, n>& cell, double m,
               const Eigen::Vector3d& x, const std::array<double, n>& shares) {
  sum.add(m, x);
  for (std::size_t k = 0; k < n; ++k) nodal[cell[k]] += m * shares[k];
}

}  // namespace detail

inline Inertia inertia(const Mesh& mesh, double density, double thickness, std::vector<double>& nodal) {
  using namespace detail;
  const auto refuse = [](const char* what, double value, const char* remedy) {
    throw Error(joined({"strike: ", what, " of a rigid body is ", text(value), "; give it ", remedy, "."}));
  };
  if (!(density > 0 && density < 1e300)) refuse("the density", density, "one above 0");
  if (!(mesh.quadrilaterals.empty() && mesh.triangles.empty()) && !(thickness > 0 && thickness < 1e300))
    refuse("the thickness of the plates", thickness, "one above 0");
  Inertia sum;
  const auto X = [&](Index i) -> const Eigen::Vector3d& { return mesh.nodes[i]; };
  constexpr std::array<std::array<double, 3>, 8> corner{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  const auto& [at, weight] = std::pair(ThreePoints::at, ThreePoints::weight);
  for (const auto& cell : mesh.hexahedra)
    for (std::size_t p = 0; p < 27; ++p) {
      const std::array<std::size_t, 3> point{p % 3, p / 3 % 3, p / 9};
      std::array<double, 8> N{};
      Eigen::Vector3d x = Eigen::Vector3d::Zero();
      std::array<Eigen::Vector3d, 3> along;
      along.fill(x);
      for (std::size_t k = 0; k < 8; ++k) {
        std::array<double, 3> f{};
        for (std::size_t c = 0; c < 3; ++c) f[c] = 0.5 * (1 + corner[k][c] * at[point[c]]);
        N[k] = f[0] * f[1] * f[2];
        x += N[k] * X(cell[k]);
        for (std::size_t c = 0; c < 3; ++c)
          along[c] += (0.5 * corner[k][c] * f[(c + 1) % 3] * f[(c + 2) % 3]) * X(cell[k]);
      }
      const double volume = cross(along[0], along[1]).dot(along[2]);
      add_piece(sum, nodal, cell, density * volume * weight[point[0]] * weight[point[1]] * weight[point[2]], x, N);
    }
  // Four points of degree two (Hammer, Marlowe and Stroud 1956).
  const double a = (5 + 3 * std::sqrt(5.0)) / 20, b = (5 - std::sqrt(5.0)) / 20;
  for (const auto& cell : mesh.tetrahedra) {
    const double volume = tetrahedron_volume(mesh.nodes, cell);
    for (std::size_t p = 0; p < 4; ++p) {
      std::array<double, 4> N{b, b, b, b};
      N[p] = a;
      Eigen::Vector3d x = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 4; ++k) x += N[k] * X(cell[k]);
      add_piece(sum, nodal, cell, 0.25 * density * volume, x, N);
    }
  }
  const auto add_plate = [&](const auto& cell, const Eigen::Vector3d& area, double weight_of, const Eigen::Vector3d& x,
                             const auto& shares) {
    const double m = density * thickness * area.norm() * weight_of;
    add_piece(sum, nodal, cell, m, x, shares);
    if (m > 0)  // a line of the length t along the normal has t^2/12 about axes across it
      sum.moment += (m * thickness * thickness / 12) * Inertia::about(area.normalized());
  };
  for (const auto& cell : mesh.quadrilaterals)
    for (std::size_t p = 0; p < 9; ++p) {
      const double r = at[p % 3], s = at[p / 3];
      std::array<double, 4> N{};
      Eigen::Vector3d x = Eigen::Vector3d::Zero(), along_r = x, along_s = x;
      for (std::size_t k = 0; k < 4; ++k) {
        const double fr = 0.5 * (1 + corner[k][0] * r), fs = 0.5 * (1 + corner[k][1] * s);
        N[k] = fr * fs;
        x += N[k] * X(cell[k]);
        along_r += 0.5 * corner[k][0] * fs * X(cell[k]), along_s += 0.5 * corner[k][1] * fr * X(cell[k]);
      }
      add_plate(cell, Eigen::Vector3d(cross(along_r, along_s)), weight[p % 3] * weight[p / 3], x, N);
    }
  for (const auto& cell : mesh.triangles)  // the middles of the edges: degree two
    for (std::size_t p = 0; p < 3; ++p) {
      std::array<double, 3> N{0.5, 0.5, 0.5};
      N[p] = 0;
      const Eigen::Vector3d x = 0.5 * (X(cell[(p + 1) % 3]) + X(cell[(p + 2) % 3]));
      add_plate(cell, area_vector(mesh.nodes, Face{{cell[0], cell[1], cell[2], cell[2]}, 0}), 1.0 / 3, x, N);
    }
  if (!(sum.mass > 0)) throw Error("strike: a rigid body has no hexahedra, tetrahedra or plates; give it cells.");
  return sum;
}

}  // namespace strike
