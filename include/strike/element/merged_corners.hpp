#pragma once
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include <strike/element/hex8_modes.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Hexahedra in lanes of which some have corners in the same node: wedges a b c c d e f f and pyramids a b c d e e e e.
///
/// With the incidence P of corners and nodes their forces are P^T f, and the mean gradient, the hourglass modes and the
/// volume of the trilinear map are exact as they stand: B and gamma of a node are the sums over its corners. Only the
/// masses M of the nodes are others than those of corners, rho V/8 each. They are the row sums of the collapsed shape
/// functions in a prism of constant section, rho V/6, and in a pyramid over a parallelogram, rho V 3/16 at the base and
/// rho V/4 at the apex, as rho V/8 are in a parallelepiped; so that there the centre of mass is right.
template <class T>
struct MergedCorners {
  T wedge = T(0.0), pyramid = T(0.0);  ///< 1 in the lanes of wedges, of pyramids; otherwise 0

  /// Of an operator K on the corners, that on the nodes in units of the mass is M^(-1/2) P^T K P M^(-1/2). This is
  /// f -> (rho V/8)^(1/2) M^(-1/2) P^T f of rows f over the corners: sums over the corners of a node stand at its first
  /// corner, and 0 at the others.
  template <int rows>
  Eigen::Matrix<T, rows, 8> to_nodes(const Eigen::Matrix<T, rows, 8>& f) const {
    const auto is_wedge = wedge > 0.0, is_pyramid = pyramid > 0.0;
    const T side = select(is_wedge, T(std::sqrt(6.0 / 8.0)), select(is_pyramid, T(std::sqrt(2.0 / 3.0)), T(1.0))),
            top = select(is_pyramid, T(std::sqrt(0.5)), side);
    const T only_base = 1.0 - pyramid, not_wedge = 1.0 - wedge;
    Eigen::Matrix<T, rows, 8> sums;
    for (int k = 0; k < rows; ++k) {
      sums(k, 0) = side * f(k, 0), sums(k, 1) = side * f(k, 1);
      sums(k, 2) = side * (f(k, 2) + wedge * f(k, 3)), sums(k, 3) = side * not_wedge * f(k, 3);
      sums(k, 4) = top * (f(k, 4) + pyramid * (f(k, 5) + f(k, 6) + f(k, 7)));
      sums(k, 5) = top * only_base * f(k, 5), sums(k, 6) = top * only_base * (f(k, 6) + wedge * f(k, 7));
      sums(k, 7) = top * only_base * not_wedge * f(k, 7);
    }
    return sums;
  }

  /// The most by which an hourglass control alone is quicker with the masses of the nodes than with those of corners:
  /// the largest eigenvalue of the products of Lambda_k P M^(-1/2) over those of Lambda_k is 9/8 in a wedge and 2/3 in
  /// a pyramid, whatever their shape. A rate of decay grows by that, a frequency by its root.
  T hourglass_factor() const {
    return select(wedge > 0.0, T(9.0 / 8.0), select(pyramid > 0.0, T(std::sqrt(2.0 / 3.0)), T(1.0)));
  }
};

/// Of an element after a step: moduli, the coefficient of its bulk viscosity [stress time], and the critical rate of
/// its hourglass control alone [1/time].
template <class T>
struct VibrationSources {
  Moduli<T> moduli;
  T zeta, hourglass_rate;
};

/// The bounds of an element's vibrations by the masses of its nodes.
template <class T>
struct MergedGradient {
  T trace, eigenvalue;  ///< of S = B M^-1 B^T rho/(8 V) [1/length^2], in place of Stability's
  T overlap;            ///< |P gamma|^2/8 over the hourglass factor, P the projection onto B M^(-1/2)
  T hourglass_factor;

  MergedGradient(const MergedCorners<T>& merged, const Nodal<T, 8>& x) : hourglass_factor(merged.hourglass_factor()) {
    const Hex8Modes<T> m = to_modes<T>(x);
    const Hex8Gradient<T> g(m);
    const Vector3<T> none = Vector3<T>::Zero(), modes[4]{m.b1, m.b2, m.b3, m.d};
    const T w = T(1.0 / 64.0) / g.volume;
    const Nodal<T, 8> b = strike::to_nodes<T>({w * g.a1, w * g.a2, w * g.a3, w * g.b1, w * g.b2, w * g.b3, none});
    Eigen::Matrix<T, 4, 8> gamma;  // Lambda_k - b.m_k
    for (int i = 0; i < 8; ++i) {
      const int xi = (i ^ i >> 1) & 1 ? 1 : -1, eta = i & 2 ? 1 : -1, zeta = i & 4 ? 1 : -1;
      const double Lambda[4]{double(eta * zeta), double(zeta * xi), double(xi * eta), double(xi * eta * zeta)};
      for (int k = 0; k < 4; ++k) gamma(k, i) = T(Lambda[k]) - dot(modes[k], column(b, static_cast<std::size_t>(i)));
    }
    const Nodal<T, 8> b_n = merged.to_nodes(b);
    const Eigen::Matrix<T, 4, 8> gamma_n = merged.to_nodes(gamma);
    SymmetricTensor<T> S{};
    for (std::size_t i = 0; i < 8; ++i) S += outer_square(column(b_n, i));
    trace = strike::trace(S), eigenvalue = largest_eigenvalue(S);

    const SymmetricTensor<T> inverse_S = inverse(S);
    overlap = T(0.0);
    for (int k = 0; k < 4; ++k) {
      Vector3<T> shared = none;  // gamma_k . b
      for (int i = 0; i < 8; ++i) shared = shared + gamma_n(k, i) * column(b_n, static_cast<std::size_t>(i));
      overlap += double_dot(inverse_S, outer_square(shared));
    }
    const T share = select(merged.pyramid > 0.0, T(1.5), select(merged.wedge > 0.0, T(8.0 / 9.0), T(1.0)));
    overlap = max(T(0.0), T(0.125 * share * overlap));
  }
};

}  // namespace strike
