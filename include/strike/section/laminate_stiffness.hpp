#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include <strike/material/plane_stiffness.hpp>
#include <strike/section/integrals.hpp>
#include <strike/section/transverse_shear.hpp>

// The stiffness of a laminate whose layers may have fibres: classical lamination theory, bounds, and transverse shear.
namespace strike {

/// Classical lamination theory (Jones 1975, chapter 4): N = A eps + B kappa, M = B eps + D kappa of the strains
/// (xx, yy, gamma_xy) and the curvatures (xx, yy, 2 xy) of the surface of the nodes.
struct LaminateStiffness {
  PlaneStiffness A = PlaneStiffness::Zero(), B = PlaneStiffness::Zero(), D = PlaneStiffness::Zero();

  /// Adds a layer with its middle at z.
  void add(double h, double z, const PlaneStiffness& Q) {
    A += h * Q, B += (h * z) * Q, D += (h * (z * z + h * h / 12)) * Q;
  }
};

namespace detail {

/// A layer as elastic, in the axes of its laminate.
struct LaminaStiffness {
  double thickness;      ///< [length]
  PlaneStiffness plane;  ///< Q [stress]
  Matrix2 shear;         ///< of (gamma_xz, gamma_yz) [stress]
};

inline Matrix2 inverse(const Matrix2& A) {
  Matrix2 adjugate;
  adjugate << A(1, 1), -A(0, 1), -A(1, 0), A(0, 0);
  return adjugate / (A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0));
}
/// The larger eigenvalue of a symmetric matrix.
inline double largest_eigenvalue(const Matrix2& A) {
  return strike::largest_eigenvalue<double>(A(0, 0), A(1, 1), A(0, 1) * A(1, 0));
}

/// int f^T S f dz of a layer.
inline Matrix2 shear_energy(const LaminaStiffness& layer, const ShearFlow<Matrix2>& f) {
  const Matrix2 S = inverse(layer.shear), both = f.bottom + f.top;
  const auto product = [&](const Matrix2& a, const Matrix2& b) -> Matrix2 {
    return 0.5 * (a.transpose() * S * b + b.transpose() * S * a);
  };
  return layer.thickness *
         ((1.0 / 3.0) * (product(f.bottom, f.bottom) + product(f.bottom, f.top) + product(f.top, f.top)) +
          (2.0 / 3.0) * product(f.bulge, both) + (8.0 / 15.0) * product(f.bulge, f.bulge));
}

/// K of a laminate, and f, tau = f Q, the transverse shear stress of every layer from bottom to top.
///
/// A plate that bends into a cylinder along n, of any lay-up, is strained by sym(a + z n, n) but for a factor; with C =
/// n.Q.n of a layer, a 2 x 2 matrix, its equilibrium gives
///   int C (z n + a) dz = 0,   tau_n(z) = int_z^top C (z' n + a) dz',   Q_n = int tau_n dz
/// where Q_n need not be along n. f(z) is the linear map that fits all directions n best,
///   f = (oint tau_n Q_n^T dn) (oint Q_n Q_n^T dn)^-1,   K^-1 = int f^T G^-1 f dz
/// (the energy as Whitney 1973 and Rohwer 1988, who bend along the axes alone). So int f dz = 1 and f = 0 on both
/// faces; K is positive definite, for f v is not zero everywhere, whatever v is; it turns with the laminate. Of
/// isotropic layers, and of equal layers whatever they are, tau_n = f Q_n exactly. Of others it is a mean: between the
/// bending along and across fibres the distribution changes. Unsymmetric lay-ups are taken like all, with the membrane
/// force that bending would cause at zero across n (int C (...) dz = 0), which supports of a plate may contradict. A
/// layer without thickness counts for nothing, and none counts as softer than 1e-12 of the mean.
inline LaminateShear laminate_shear(const std::vector<LaminaStiffness>& layers,
                                    std::vector<ShearFlow<Matrix2>>& flows) {
  using Vector = Eigen::Vector2d;
  LaminateShear shear;
  double thickness = 0;
  for (const LaminaStiffness& layer : layers)
    shear.layer_sum += layer.thickness * layer.shear, thickness += layer.thickness;

  const auto zero = Matrix2::Zero();
  flows.assign(layers.size(), ShearFlow<Matrix2>{zero, zero, zero});
  std::vector<ShearFlow<Vector>> tau(layers.size());
  Matrix2 squares = Matrix2::Zero();
  constexpr int directions = 720;
  for (int i = 0; i < directions; ++i) {
    const double angle = std::numbers::pi * i / directions;
    const Vector n(std::cos(angle), std::sin(angle));
    Eigen::Matrix<double, 3, 2> strain;
    strain << n(0), 0, 0, n(1), n(1), n(0);
    const auto acoustic = [&](const LaminaStiffness& layer) -> Matrix2 {
      return strain.transpose() * layer.plane * strain;
    };
    Matrix2 extension = Matrix2::Zero(), coupling = Matrix2::Zero();
    double z = -0.5 * thickness;
    for (const LaminaStiffness& layer : layers) {
      const Matrix2 Ch = layer.thickness * acoustic(layer);
      extension += Ch, coupling += (z + 0.5 * layer.thickness) * Ch, z += layer.thickness;
    }
    const Vector a = -(inverse(extension) * (coupling * n));
    Vector at = Vector::Zero(), Q_n = Vector::Zero();
    z = -0.5 * thickness;
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const double h = layers[k].thickness;
      const Matrix2 Ch = h * acoustic(layers[k]);
      const Vector top = at - Ch * ((z + 0.5 * h) * n + a), bulge = (0.125 * h) * (Ch * n);
      tau[k] = {at, top, bulge};
      Q_n += h * (0.5 * (at + top) + (2.0 / 3.0) * bulge);
      at = top, z += h;
    }
    for (std::size_t k = 0; k < layers.size(); ++k) {
      flows[k].bottom += tau[k].bottom * Q_n.transpose();
      flows[k].top += tau[k].top * Q_n.transpose();
      flows[k].bulge += tau[k].bulge * Q_n.transpose();
    }
    squares += Q_n * Q_n.transpose();
  }

  const auto multiply = [&](const Matrix2& by) {
    for (ShearFlow<Matrix2>& f : flows) f = {Matrix2(f.bottom * by), Matrix2(f.top * by), Matrix2(f.bulge * by)};
  };
  multiply(inverse(squares));
  Matrix2 integral = Matrix2::Zero();  // 1 but for rounding, which very stiff fibres magnify
  for (std::size_t k = 0; k < layers.size(); ++k)
    integral += layers[k].thickness * (0.5 * (flows[k].bottom + flows[k].top) + (2.0 / 3.0) * flows[k].bulge);
  multiply(inverse(integral));

  Matrix2 flexibility = Matrix2::Zero();
  const double least = 1e-12 * largest_eigenvalue(shear.layer_sum) / thickness;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    LaminaStiffness layer = layers[k];
    if (-largest_eigenvalue(-layer.shear) < least) layer.shear += least * Matrix2::Identity();
    flexibility += shear_energy(layer, flows[k]);
  }
  shear.stiffness = inverse(flexibility);
  return shear;
}

/// Isotropic bounds of the tangent of a laminate. About the height z at which the trace of the coupling vanishes, with
/// the bounds a of A and d of D, and r = |a^-1/2 B d^-1/2|,
///   eps.A eps + 2 eps.B kappa + kappa.D kappa <= (1 + r) (eps.a eps + kappa.d kappa)
inline void bound_moduli(const LaminateStiffness& of, SectionIntegrals& integrals) {
  const double z = trace_of(of.B) / trace_of(of.A);
  const PlaneStiffness B = of.B - z * of.A, D = of.D - 2 * z * of.B + (z * z) * of.A;
  PlaneModuli<double> a = isotropic_bound(of.A), d = isotropic_bound(D);

  // Square roots on equal strains, 2 (normal - shear), and on deviators, 2 shear.
  const auto per_root = [](const PlaneModuli<double>& m) {
    const double equal = 1 / std::sqrt(2 * (m.normal - m.shear)), other = 1 / std::sqrt(2 * m.shear);
    PlaneStiffness root;
    root << 0.5 * (equal + other), 0.5 * (equal - other), 0, 0.5 * (equal - other), 0.5 * (equal + other), 0, 0, 0,
        other;
    return root;
  };
  const PlaneStiffness R = per_root(a) * orthonormal(B) * per_root(d), RR = R.transpose() * R;
  const double square =
      largest_principal(SymmetricTensor<double>{RR(0, 0), RR(1, 1), RR(2, 2), RR(0, 1), RR(1, 2), RR(2, 0)});
  const double rounding = 1e-12, r = square > rounding * rounding ? std::sqrt(square) : 0;
  for (PlaneModuli<double>* m : {&a, &d}) m->normal *= 1 + r, m->shear *= 1 + r;
  integrals.extension = a;
  integrals.coupling = {z * a.normal, z * a.shear};
  integrals.bending = {d.normal + z * z * a.normal, d.shear + z * z * a.shear};
}

}  // namespace detail

}  // namespace strike
