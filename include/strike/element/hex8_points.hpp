#pragma once
#include <cstddef>
#include <limits>

#include <strike/element/hex8_modes.hpp>

namespace strike {

/// One of the 2 x 2 x 2 Gauss points of the hexahedron; its weight is 1.
struct Hex8Point {
  double xi, eta, zeta;

  explicit Hex8Point(std::size_t i)
      : xi(i & 1 ? position : -position), eta(i & 2 ? position : -position), zeta(i & 4 ? position : -position) {}

  /// The derivatives along xi, eta and zeta of the field of modes m: (a1 + b2 zeta + b3 eta + d eta zeta)/8, and
  /// cyclic.
  template <class T>
  Matrix3<T> derivatives(const Hex8Modes<T>& m) const {
    Matrix3<T> A;
    for (int i = 0; i < 3; ++i) {
      A(i, 0) = 0.125 * (m.a1(i) + zeta * m.b2(i) + eta * m.b3(i) + (eta * zeta) * m.d(i));
      A(i, 1) = 0.125 * (m.a2(i) + xi * m.b3(i) + zeta * m.b1(i) + (zeta * xi) * m.d(i));
      A(i, 2) = 0.125 * (m.a3(i) + eta * m.b1(i) + xi * m.b2(i) + (xi * eta) * m.d(i));
    }
    return A;
  }
  /// The transpose: adds to F the forces on the modes that do the work of the vectors t on these derivatives.
  template <class T>
  void add_forces(const Matrix3<T>& t, Hex8Modes<T>& F) const {
    for (int i = 0; i < 3; ++i) {
      const T t1 = 0.125 * t(i, 0), t2 = 0.125 * t(i, 1), t3 = 0.125 * t(i, 2);
      F.a1(i) += t1, F.a2(i) += t2, F.a3(i) += t3;
      F.b1(i) += zeta * t2 + eta * t3;
      F.b2(i) += xi * t3 + zeta * t1;
      F.b3(i) += eta * t1 + xi * t2;
      F.d(i) += (eta * zeta) * t1 + (zeta * xi) * t2 + (xi * eta) * t3;
    }
  }

 private:
  static constexpr double position = 0.57735026918962576;  // 1/sqrt(3)
};

/// The trilinear map at a point, from its derivatives A = dx/d(xi, eta, zeta).
template <class T>
struct Hex8Map {
  Matrix3<T> cofactors;  ///< of A, in columns c_j: grad xi_j = c_j/det A
  T volume;              ///< det A, the point's share of the volume

  Hex8Map() = default;
  explicit Hex8Map(const Matrix3<T>& A) {
    const Vector3<T> x = A.col(0), y = A.col(1), z = A.col(2);
    cofactors.col(0) = cross(y, z), cofactors.col(1) = cross(z, x), cofactors.col(2) = cross(x, y);
    volume = x.dot(cofactors.col(0));
  }

  /// The gradient of a field from its derivatives U along xi, eta, zeta; `per_volume` is 1/det A.
  Matrix3<T> gradient(const Matrix3<T>& U, const T& per_volume) const {
    const Matrix3<T> W = per_volume * U;
    Matrix3<T> L;
    for (int j = 0; j < 3; ++j) L.col(j) = times<T>(W, {cofactors(j, 0), cofactors(j, 1), cofactors(j, 2)});
    return L;
  }
};

/// H_IJ = sum of the points' V_g grad N_I . grad N_J, in the modes: H_kl = sum of p_k.M p_l/8, with the derivatives p_k
/// of the mode k along xi, eta, zeta and M_ij = V_g grad xi_i . grad xi_j. It bounds the stiffness against a change of
/// shape.
template <class T>
class Hex8Laplacian {
 public:
  /// `per_volume` = 1/V_g.
  void add(const Hex8Point& point, const Hex8Map<T>& map, const T& per_volume) {
    const T w = 0.125 * per_volume;
    const Vector3<T> x = map.cofactors.col(0), y = map.cofactors.col(1), z = map.cofactors.col(2);
    const SymmetricTensor<T> M{w * x.dot(x), w * y.dot(y), w * z.dot(z), w * x.dot(y), w * y.dot(z), w * z.dot(x)};

    const T xi = T(point.xi), eta = T(point.eta), zeta = T(point.zeta);
    const auto p1 = [&](const Vector3<T>& a) -> T { return zeta * a(1) + eta * a(2); };
    const auto p2 = [&](const Vector3<T>& a) -> T { return xi * a(2) + zeta * a(0); };
    const auto p3 = [&](const Vector3<T>& a) -> T { return eta * a(0) + xi * a(1); };
    const auto pd = [&](const Vector3<T>& a) -> T {
      return T(point.eta * point.zeta) * a(0) + T(point.zeta * point.xi) * a(1) + T(point.xi * point.eta) * a(2);
    };
    const auto times = [&](const auto& p) -> Vector3<T> {
      return {p({M.xx, M.xy, M.zx}), p({M.xy, M.yy, M.yz}), p({M.zx, M.yz, M.zz})};
    };
    const Vector3<T> M1 = times(p1), M2 = times(p2), M3 = times(p3), Md = times(pd);
    aa_ += M;
    ab_.col(0) += M1, ab_.col(1) += M2, ab_.col(2) += M3;
    ad_ += Md;
    bb_ += {p1(M1), p2(M2), p3(M3), p1(M2), p2(M3), p3(M1)};
    bd_ += Vector3<T>(p1(Md), p2(Md), p3(Md));
    dd_ += pd(Md);
  }

  /// The largest eigenvalue, from above: that of the matrix of the norms of the blocks a, b and d.
  T largest_eigenvalue() const {
    const auto norm = [](const auto& A) -> T {  // 0 of a brick, where a root has no slope
      return sqrt(max(T(std::numeric_limits<RealOf<T>>::min()), A.squaredNorm()));
    };
    return strike::largest_eigenvalue(SymmetricTensor<T>{
        strike::largest_eigenvalue(aa_), strike::largest_eigenvalue(bb_), dd_, norm(ab_), norm(bd_), norm(ad_)});
  }

 private:
  SymmetricTensor<T> aa_{}, bb_{};
  Matrix3<T> ab_ = Matrix3<T>::Zero();
  Vector3<T> ad_ = Vector3<T>::Zero(), bd_ = Vector3<T>::Zero();
  T dd_{};
};

}  // namespace strike
