#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/surface.hpp>
#include <strike/verify/single_element.hpp>

namespace strike::verify {

/// A few elements of n nodes around inner ones.
template <int n>
struct PatchMesh {
  Eigen::Matrix3Xd nodes;  ///< a column each
  std::vector<std::array<int, n>> cells;
  int first_inner;  ///< nodes from here on lie inside
};

/// Seven hexahedra: the core `inner`, by default a distorted one, and one on each face, out to the unit cube.
inline PatchMesh<8> hexahedra_patch(const Nodal<double, 8>& inner) {
  PatchMesh<8> patch{Eigen::Matrix3Xd(3, 16),
                     {{8, 9, 10, 11, 12, 13, 14, 15},  // the core
                      {0, 1, 2, 3, 8, 9, 10, 11},
                      {12, 13, 14, 15, 4, 5, 6, 7},  // below, above
                      {0, 1, 9, 8, 4, 5, 13, 12},
                      {11, 10, 2, 3, 15, 14, 6, 7},  // front, back
                      {0, 8, 11, 3, 4, 12, 15, 7},
                      {9, 1, 2, 10, 13, 5, 6, 14}},  // left, right
                     8};
  patch.nodes << unit_cube(), inner;
  return patch;
}
/// The inner corners of the patch of MacNeal and Harder (1985).
inline PatchMesh<8> hexahedra_patch() {
  Nodal<double, 8> inner;
  inner << 0.249, 0.826, 0.850, 0.273, 0.320, 0.677, 0.788, 0.165,  //
      0.342, 0.288, 0.649, 0.750, 0.186, 0.305, 0.693, 0.745,       //
      0.192, 0.288, 0.263, 0.230, 0.643, 0.683, 0.644, 0.702;
  return hexahedra_patch(inner);
}

/// Twelve tetrahedra: two on each face of the unit cube, with the one inner node.
inline PatchMesh<4> tetrahedra_patch(const Eigen::Vector3d& inner = {0.4, 0.55, 0.35}) {
  PatchMesh<4> patch{Eigen::Matrix3Xd(3, 9), {}, 8};
  patch.nodes << unit_cube(), inner;
  for (const auto& face : detail::hexahedron_faces) {
    const auto corner = [&](std::size_t i) { return static_cast<int>(face[i]); };
    patch.cells.push_back({corner(0), corner(2), corner(1), 8});
    patch.cells.push_back({corner(0), corner(3), corner(2), 8});
  }
  return patch;
}

/// Five quadrilaterals: the core `inner` and one at each side, out to the unit square.
inline PatchMesh<4> quadrilaterals_patch(const Nodal<double, 4>& inner) {
  PatchMesh<4> patch{Eigen::Matrix3Xd(3, 8), {{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}, 4};
  patch.nodes << unit_square(), inner;
  return patch;
}
/// The inner corners of the patch of MacNeal and Harder (1985), stretched to the square.
inline PatchMesh<4> quadrilaterals_patch() {
  Nodal<double, 4> inner;
  inner << 0.04 / 0.24, 0.18 / 0.24, 0.16 / 0.24, 0.08 / 0.24,  //
      0.02 / 0.12, 0.03 / 0.12, 0.08 / 0.12, 0.08 / 0.12,       //
      0, 0, 0, 0;
  return quadrilaterals_patch(inner);
}

/// Ten triangles: the same quadrilaterals, each cut along its first diagonal.
inline PatchMesh<3> triangles_patch() {
  const PatchMesh<4> whole = quadrilaterals_patch();
  PatchMesh<3> patch{whole.nodes, {}, whole.first_inner};
  for (const auto& [a, b, c, d] : whole.cells) patch.cells.push_back({a, b, c}), patch.cells.push_back({a, c, d});
  return patch;
}

/// The patch that belongs to an element, as unit_corners do.
template <class E>
PatchMesh<E::nodes> unit_patch() {
  unit_corners<E>();
  if constexpr (E::nodes == 8)
    return hexahedra_patch();
  else if constexpr (E::nodes == 3)
    return triangles_patch();
  else if constexpr (turns_nodes<E>())
    return quadrilaterals_patch();
  else
    return tetrahedra_patch();
}

/// Response of a patch to a motion.
template <class E>
struct PatchResponse {
  int first_inner;
  std::vector<ElementRecord<E>> elements;
  Eigen::Matrix3Xd force, moment;  ///< on the nodes; moments if they turn

  /// The largest force on an inner node, of the largest on any: 0 in equilibrium.
  double unbalanced_force() const { return unbalanced(force); }
  double unbalanced_moment() const { return unbalanced(moment); }
  double volume() const {
    double sum = 0;
    for (const auto& element : elements) sum += element.volume;
    return sum;
  }
  /// The largest difference of measure(stress) of an element from that of the first element, relative.
  template <class Measure>
  double spread(Measure measure) const {
    double largest = 0;
    const auto first = measure(elements.front().stress);
    for (const auto& element : elements)
      largest = std::max(largest, (measure(element.stress) - first).norm() / first.norm());
    return largest;
  }

 private:
  double unbalanced(const Eigen::Matrix3Xd& nodal) const {
    return nodal.rightCols(nodal.cols() - first_inner).colwise().norm().maxCoeff() / nodal.colwise().norm().maxCoeff();
  }
};

/// Moves the nodes of a patch at the velocities v for dt, and if they turn with angular velocities in further columns.
template <class E, class M>
PatchResponse<E> move_patch(const E& element, const M& material, const PatchMesh<E::nodes>& patch,
                            const Eigen::Matrix3Xd& v, double dt) {
  constexpr int n = E::nodes;
  const Eigen::Index count = patch.nodes.cols();
  PatchResponse<E> response{patch.first_inner, {}, Eigen::Matrix3Xd::Zero(3, count), Eigen::Matrix3Xd::Zero(3, count)};
  for (const auto& cell : patch.cells) {
    Nodal<double, n> x;
    Nodal<double, motions<E>> v_cell;
    for (int i = 0; i < n; ++i) {
      const int node = cell[static_cast<std::size_t>(i)];
      x.col(i) = patch.nodes.col(node), v_cell.col(i) = v.col(node);
      if constexpr (turns_nodes<E>()) v_cell.col(n + i) = v.col(count + node);
    }
    SingleElement<E, M> single{element, material, x};
    response.elements.push_back(single.step(v_cell, dt));
    for (int i = 0; i < n; ++i) {
      const int node = cell[static_cast<std::size_t>(i)];
      response.force.col(node) += single.now().force.col(i);
      if constexpr (turns_nodes<E>()) response.moment.col(node) += single.now().force.col(n + i);
    }
  }
  return response;
}

/// Errors of a patch under a linear motion of its nodes, which should give a uniform stress.
struct PatchResult {
  const char* motion;
  double stress;  ///< the largest difference between elements, of the stress
  double force;   ///< on an inner node, of the largest on any; of a bent plate the moment

  double error() const { return std::max(stress, force); }
};

/// The patch tests. Solids are stretched and sheared: one motion with all six strains, 1e-3 in a stable step, without
/// compression, since bulk viscosity depends on the size. Plates, which lie in a plane, are strained in it, bent into a
/// deflection that leaves no transverse shear, and sheared; the invariants of their resultants are compared, since
/// these are in the frames of the elements.
template <class E, class M>
std::vector<PatchResult> patch_tests(const E& element, const M& material,
                                     const PatchMesh<E::nodes>& patch = unit_patch<E>()) {
  const Eigen::Matrix3Xd& X = patch.nodes;
  Eigen::Matrix3d L;
  L << 0.6, 0.3, -0.2, 0.1, 0.4, 0.5, -0.3, 0.2, 0.7;
  if constexpr (!turns_nodes<E>()) {
    Nodal<double, E::nodes> x;
    for (int i = 0; i < E::nodes; ++i) x.col(i) = X.col(patch.cells[0][static_cast<std::size_t>(i)]);
    const double dt = SingleElement{element, material, x}.now().stable_step;
    const auto response = move_patch(element, material, patch, (1e-3 / dt) * L * X, dt);
    return {
        {"stretch and shear", response.spread([](const auto& s) { return s.matrix(); }), response.unbalanced_force()}};
  } else {
    const auto invariants = [](const PlaneTensor<double>& a) -> Eigen::Vector2d {
      return {trace(a), std::sqrt(double_dot(a, a))};
    };
    const Eigen::Index n = X.cols();
    const double dt = 1e-14 * (X.colwise() - X.rowwise().mean()).norm();  // so short that its end is its middle
    const auto respond = [&](const Eigen::Matrix3Xd& v, const Eigen::Matrix3Xd& w) {
      Eigen::Matrix3Xd both(3, 2 * n);
      both << v, w;
      return move_patch(element, material, patch, both, dt);
    };
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    L.row(2).setZero(), L.col(2).setZero();
    const auto stretched = respond(L * X, axial_vector<double>(L).replicate(1, n));
    const Eigen::Matrix3d curvature = symmetric_part(L).matrix();
    Eigen::Matrix3Xd sinks(3, n), turns(3, n);
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector3d x = X.col(i), slope = curvature * x;
      sinks.col(i) = -0.5 * x.dot(slope) * normal, turns.col(i) = normal.cross(slope);
    }
    const auto bent = respond(sinks, turns);
    const auto sheared = respond(normal * Eigen::RowVector3d(0.6, 0.3, 0) * X, Eigen::Matrix3Xd::Zero(3, n));
    return {
        {"membrane", stretched.spread([&](const auto& s) { return invariants(s.force); }),
         stretched.unbalanced_force()},
        {"bending", bent.spread([&](const auto& s) { return invariants(s.moment); }), bent.unbalanced_moment()},
        {"transverse shear", sheared.spread([](const auto& s) { return Eigen::Matrix<double, 1, 1>(s.shear.norm()); }),
         sheared.unbalanced_force()}};
  }
}

}  // namespace strike::verify
