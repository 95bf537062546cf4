#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <vector>

#include <Eigen/Dense>

#include <strike/element/stable_step.hpp>
#include <strike/material/kinematics.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/verify/single_element.hpp>

namespace strike::verify {

/// Kind of a mode of an element, by its largest part.
enum class ModeKind {
  rigid,      ///< a motion without strain: six, without frequency
  straining,  ///< a uniform strain; of a plate a uniform membrane strain, curvature or transverse shear
  hourglass   ///< the rest: strains that one point does not measure, so that they need a control or more points
};

inline const char* to_string(ModeKind kind) {
  return kind == ModeKind::rigid ? "rigid" : kind == ModeKind::straining ? "straining" : "hourglass";
}

/// A free vibration of an element alone.
struct Eigenmode {
  ModeKind kind;
  double frequency;        ///< w [rad/time], of K phi = w^2 M phi
  double decay;            ///< d = phi.C phi/m [1/time], damping by the element's viscosity
  Eigen::Matrix3Xd shape;  ///< `motions` columns, of length 1 in all; rotations as in ElementVibration

  /// The largest stable step of this mode alone: w^2 dt^2/4 + d dt/2 = 1.
  double critical_step() const { return 1 / Vibration<double>{frequency * frequency, decay}.critical_rate(); }
};

/// Motions that every shape must represent, a column each, in the coordinates of ElementVibration.
struct UniformMotions {
  Eigen::MatrixXd rigid;      ///< three translations and three rotations
  Eigen::MatrixXd straining;  ///< without rotation: strains xx, yy, zz, xy, yz, zx; of a plate membrane and curvature
                              ///< xx, yy, xy, and shear xz, yz, in the plane of its vector area
  double thickness;           ///< of a plate; its curvatures are in units of 1/thickness
};

namespace detail {
using namespace strike::detail;

/// Columns of motions v = a + L d - e3 d.k d/2, w = b + W d of nodes at the places d. (A template, so that only
/// programs that use it compile it.)
template <class T>
class MotionColumns {
 public:
  using V = Eigen::Matrix<T, 3, 1>;
  using A = Eigen::Matrix<T, 3, 3>;
  struct Coefficients {
    V a = V::Zero(), b = V::Zero(), e3 = V::Zero();
    A L = A::Zero(), W = A::Zero(), k = A::Zero();
  };

  /// Nodes with a radius of gyration turn.
  MotionColumns(const Eigen::Matrix3Xd& x, double gyration)
      : d_(x.colwise() - x.rowwise().mean()), gyration_(gyration) {}

  Eigen::VectorXd operator()(const Coefficients& m) const {
    const Eigen::Index n = d_.cols();
    Eigen::VectorXd column(gyration_ > 0 ? 6 * n : 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const V d = d_.col(i), v = m.a + m.L * d - V(T(0.5) * d.dot(V(m.k * d)) * m.e3);
      column.template segment<3>(3 * i) = v;
      if (gyration_ > 0) column.template segment<3>(3 * (n + i)) = gyration_ * V(m.b + m.W * d);
    }
    return column;
  }

  UniformMotions uniform(double thickness) const {
    const bool plate = gyration_ > 0;
    const Eigen::Index rows = (plate ? 6 : 3) * d_.cols();
    UniformMotions all{Eigen::MatrixXd(rows, 6), Eigen::MatrixXd(rows, plate ? 8 : 6), thickness};
    for (int k = 0; k < 3; ++k) {
      all.rigid.col(k) = (*this)({.a = V::Unit(k)});
      all.rigid.col(3 + k) = (*this)({.b = V::Unit(k), .L = cross_matrix(V::Unit(k))});
    }
    if (!plate) {
      for (int k = 0; k < 6; ++k) all.straining.col(k) = (*this)({.L = unit_strain(k % 3, k < 3 ? k : (k + 1) % 3)});
      return all;
    }
    V area = V::Zero();
    for (Eigen::Index i = 0; i < d_.cols(); ++i) area += V(d_.col(i)).cross(V(d_.col((i + 1) % d_.cols())));
    const V e3 = area.normalized(), e1 = e3.unitOrthogonal(), e2 = e3.cross(e1);
    A e;
    e << e1, e2, e3;
    for (int k = 0; k < 3; ++k) {
      const A D = e * unit_strain(k % 2, k > 0 ? 1 : 0) * e.transpose(), curvature = D / thickness;
      all.straining.col(k) = (*this)({.L = D});
      all.straining.col(3 + k) = (*this)({.e3 = e3, .W = cross_matrix(e3) * curvature, .k = curvature});
    }
    all.straining.col(6) = (*this)({.L = e3 * e1.transpose()});
    all.straining.col(7) = (*this)({.L = e3 * e2.transpose()});
    return all;
  }

 private:
  static A cross_matrix(const V& a) {
    A W;
    W << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return W;
  }
  static A unit_strain(int i, int j) {
    A D = A::Zero();
    D(i, j) = D(j, i) = 1;
    return D;
  }

  Eigen::Matrix3Xd d_;
  double gyration_;
};

/// The columns made orthogonal to each other and to those of the orthonormal `others`, and of length 1 (Gram and
/// Schmidt, twice).
template <class T>
Eigen::MatrixX<T> orthonormal(Eigen::MatrixX<T> columns, const Eigen::MatrixX<T>& others) {
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    for (int twice = 0; twice < 2; ++twice) {
      for (Eigen::Index i = 0; i < others.cols(); ++i)
        columns.col(k) -= others.col(i).dot(columns.col(k)) * others.col(i);
      for (Eigen::Index i = 0; i < k; ++i) columns.col(k) -= columns.col(i).dot(columns.col(k)) * columns.col(i);
    }
    columns.col(k).normalize();
  }
  return columns;
}

/// The modes of nodes at x that move, and turn if there are as many motions more.
template <class T>
std::vector<Eigenmode> eigenmodes(const ElementVibration<T>& vibration, const UniformMotions& uniform,
                                  const Eigen::Matrix3Xd& x) {
  using Matrix = Eigen::MatrixX<T>;
  const Matrix &K = vibration.stiffness, &C = vibration.damping;
  const Eigen::Index n = x.cols(), m = K.rows() / 3;
  const Matrix R = orthonormal<T>(uniform.rigid, Matrix(3 * m, 0)), U = orthonormal<T>(uniform.straining, R);

  // Springs between the nodes that grow from x to z, too weak to change more than the choice among equal frequencies.
  const double size = (x.colwise() - x.rowwise().mean()).norm();
  Matrix choice = 2 * (U * U.transpose() - R * R.transpose());
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = i % n == i ? 0 : n; j < (i % n == i ? n : m); ++j) {
      const Eigen::Vector3d d = (x.col(i % n) - x.col(j % n)).cwiseAbs() / size;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double spring = 0.01 * (d.x() + 2 * d.y() + 3 * d.z()) * (1 + 0.3 * static_cast<double>(k));
        choice(3 * i + k, 3 * i + k) += spring, choice(3 * i + k, 3 * j + k) -= spring;
      }
    }
  const Matrix chosen = K + (1e-7 * K.norm()) * choice;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(chosen);

  std::vector<Eigenmode> modes;
  for (Eigen::Index k = 0; k < 3 * m; ++k) {
    const Eigen::VectorX<T> phi = solver.eigenvectors().col(k), K_phi = K * phi, C_phi = C * phi;
    const double rigid = Eigen::VectorX<T>(R.transpose() * phi).squaredNorm(),
                 straining = Eigen::VectorX<T>(U.transpose() * phi).squaredNorm();
    const double w2 = phi.dot(K_phi) / vibration.mass, zero = 1e-10 * K.norm() / vibration.mass;  // the rounding of K
    modes.push_back({rigid > 0.5       ? ModeKind::rigid
                     : straining > 0.5 ? ModeKind::straining
                                       : ModeKind::hourglass,
                     std::abs(w2) > zero ? std::sqrt(std::abs(w2)) : 0, std::max(0.0, phi.dot(C_phi) / vibration.mass),
                     Eigen::Map<const Eigen::Matrix3Xd>(phi.data(), 3, m)});
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const auto& a, const auto& b) { return a.frequency < b.frequency * (1 - 1e-6); });
  return modes;
}

template <class T>
T uniform_strain_error(const Eigen::MatrixX<T>& K, const Eigen::MatrixX<T>& U, const Eigen::MatrixX<T>& exact) {
  const Eigen::MatrixX<T> found = U.transpose() * K * U;
  return (found - exact).norm() / exact.norm();
}

}  // namespace detail

template <class E, class M>
UniformMotions uniform_motions(const SingleElement<E, M>& single) {
  double gyration = 0, thickness = 0;
  if constexpr (turns_nodes<E>()) {
    gyration = std::sqrt(single.nodal_inertia() / single.nodal_mass());
    thickness = single.material().thickness();
  }
  return detail::MotionColumns<double>(single.now().x, gyration).uniform(thickness);
}

/// The free vibrations of an element where it stands, in ascending frequency. Modes of equal frequency are chosen
/// rigid, straining or hourglass, and along the axes.
template <class E, class M>
std::vector<Eigenmode> eigenmodes(const SingleElement<E, M>& single) {
  return detail::eigenmodes<double>(single.vibration(), uniform_motions(single), single.now().x);
}

namespace detail {

// Strains of solids by the components xx, yy, zz, xy, yz, zx; of plates membrane and curvature by xx, yy, xy and the
// shears, lengths in units of h; and the stresses conjugate to them.
template <class T>
SolidKinematics::Rate<T> rate_of(SolidKinematics, const std::array<T, 6>& e, double, double dt) {
  return {{e[0], e[1], e[2], e[3], e[4], e[5]}, 1.0 + dt * (e[0] + e[1] + e[2])};
}
template <class T>
PlateKinematics::Rate<T> rate_of(PlateKinematics, const std::array<T, 8>& e, double h, double) {
  return {{e[0], e[1], e[2]}, {(1 / h) * e[3], (1 / h) * e[4], (1 / h) * e[5]}, {e[6], e[7]}};
}
template <class T>
std::array<T, 6> conjugate(const SymmetricTensor<T>& s, double) {
  return {s.xx, s.yy, s.zz, 2.0 * s.xy, 2.0 * s.yz, 2.0 * s.zx};
}
template <class T>
std::array<T, 8> conjugate(const PlateKinematics::Stress<T>& s, double h) {
  const auto& [N, M, Q, normal_rate] = s;
  return {N.xx, N.yy, 2.0 * N.xy, (1 / h) * M.xx, (1 / h) * M.yy, (2 / h) * M.xy, Q(0), Q(1)};
}

/// The elastic tangent of a material at rest: the power of the stress of unit strain k on unit strain j, per volume; of
/// a section, per area. Viscosities fall out between two lengths of the step, as in SingleElement.
template <class M>
Eigen::MatrixXd tangent(const M& material, double h, double dt) {
  using D = Dual<double, 3>;
  constexpr std::size_t n = std::tuple_size_v<decltype(conjugate(material.stress(typename M::template State<D>{}), h))>;
  const auto slope = [&](double step) {
    Eigen::MatrixXd A(n, n);
    for (std::size_t k = 0; k < n; ++k) {
      std::array<D, n> strain;
      strain.fill(D(0.0));
      strain[k] = D::variable(0.0, 0);
      typename M::template State<D> state{};
      if constexpr (requires { material.begin(state); }) material.begin(state);
      const auto stress =
          conjugate(material.stress(state, rate_of(typename M::Kinematics{}, strain, h, step), step), h);
      for (std::size_t j = 0; j < n; ++j)
        A(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = stress[j].derivative(0);
    }
    return A;
  };
  return (slope(2 * dt) - slope(dt)) / dt;
}

}  // namespace detail

/// Error of the stiffness of an element at rest under uniform strains, relative to that of its material and shape:
///   |U^T K U - V C|/|V C|,   U the uniform strains of its nodes and C the tangent of the material.
/// Zero but for rounding if the element measures linear fields, spreads the stress by the gradient of its volume, and
/// has an hourglass control without stiffness in them. In their plane the layers of a section must be isotropic.
template <class E, class M>
double uniform_strain_error(const SingleElement<E, M>& single) {
  const auto uniform = uniform_motions(single);
  const Eigen::MatrixXd C = detail::tangent(single.material(), uniform.thickness, 1e-6 * single.now().stable_step);
  return detail::uniform_strain_error<double>(single.vibration().stiffness, uniform.straining, single.now().volume * C);
}

}  // namespace strike::verify
