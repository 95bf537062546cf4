#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <vector>

#include <Eigen/Dense>

#include <strike/material/kinematics.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/verify/single_element.hpp>

namespace strike {

/// What a mode of an element is for the most part.
enum class ModeKind {
  rigid,      ///< a motion without strain: six, without frequency
  straining,  ///< a uniform strain; of a plate a uniform membrane strain, curvature or transverse shear
  hourglass   ///< what is left: one point measures no strain of it, so that it needs a control or more points
};

inline const char* to_string(ModeKind kind) {
  return kind == ModeKind::rigid ? "rigid" : kind == ModeKind::straining ? "straining" : "hourglass";
}

/// A free vibration of an element alone.
template <class E>
struct Eigenmode {
  ModeKind kind;
  double frequency;                 ///< w [rad/time], of K phi = w^2 M phi
  double decay;                     ///< d = phi.C phi/m [1/time], what the element's viscosity takes from it
  Nodal<double, motions<E>> shape;  ///< of length 1; rotations as lengths, the radius of gyration times the angle

  /// The largest stable step of this mode alone: w^2 dt^2/4 + d dt/2 = 1.
  double critical_step() const {
    return 1 / (0.25 * decay + 0.5 * std::sqrt(frequency * frequency + 0.25 * decay * decay));
  }
};

/// The motions that an element must know whatever its shape, a column each, in the coordinates of ElementVibration.
template <class E>
struct UniformMotions {
  static constexpr bool plate = std::same_as<typename E::Kinematics, PlateKinematics>;
  static constexpr int strains = plate ? 8 : 6;
  Eigen::MatrixXd rigid;      ///< three translations and three rotations
  Eigen::MatrixXd straining;  ///< without rotation: strains xx, yy, zz, xy, yz, zx; of a plate membrane and curvature
                              ///< xx, yy, xy, and shear xz, yz, in the plane of its vector area
  double thickness;           ///< of a plate; its curvatures are in units of 1/thickness

  /// Of nodes at the positions x with this radius of gyration; a plate has a thickness too.
  UniformMotions(const Nodal<double, E::nodes>& x, double gyration, double thickness_of_plate)
      : rigid(3 * motions<E>, 6), straining(3 * motions<E>, strains), thickness(thickness_of_plate) {
    const Eigen::Vector3d middle = x.rowwise().mean();
    const auto set = [&](auto column, const auto& velocity, const auto& turn) {
      for (int i = 0; i < motions<E>; ++i) {
        const Eigen::Vector3d d = x.col(i % E::nodes) - middle;
        column.template segment<3>(3 * i) = i < E::nodes ? velocity(d) : Eigen::Vector3d(gyration * turn(d));
      }
    };
    using V = Eigen::Vector3d;
    const auto none = [](const V&) -> V { return V::Zero(); };
    for (int k = 0; k < 3; ++k) {
      const V e = V::Unit(k);
      set(
          rigid.col(k), [&](const V&) -> V { return e; }, none);
      set(
          rigid.col(3 + k), [&](const V& d) -> V { return e.cross(d); }, [&](const V&) -> V { return e; });
    }
    if constexpr (plate) {
      const Eigen::Matrix3d e = frame(x);
      const V normal = e.col(2);
      for (int k = 0; k < 3; ++k) {
        Eigen::Matrix3d local = Eigen::Matrix3d::Zero();
        k < 2 ? local(k, k) = 1 : local(0, 1) = local(1, 0) = 1;
        const Eigen::Matrix3d D = e * local * e.transpose(), curvature = D / thickness;
        set(
            straining.col(k), [&](const V& d) -> V { return D * d; }, none);
        set(
            straining.col(3 + k), [&](const V& d) -> V { return -0.5 * d.dot(curvature * d) * normal; },
            [&](const V& d) -> V { return normal.cross(V(curvature * d)); });
      }
      for (int k = 0; k < 2; ++k) {
        const V along = e.col(k);
        set(
            straining.col(6 + k), [&](const V& d) -> V { return along.dot(d) * normal; }, none);
      }
    } else {
      constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
      for (int k = 0; k < 6; ++k) {
        Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
        D(pairs[k][0], pairs[k][1]) = D(pairs[k][1], pairs[k][0]) = 1;
        set(
            straining.col(k), [&](const V& d) -> V { return D * d; }, none);
      }
    }
  }

 private:
  /// Two directions in the plane of a ring of nodes, and its normal, that of the vector area.
  static Eigen::Matrix3d frame(const Nodal<double, E::nodes>& x) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (int i = 0; i < E::nodes; ++i)
      area += Eigen::Vector3d(x.col(i)).cross(Eigen::Vector3d(x.col((i + 1) % E::nodes)));
    Eigen::Matrix3d e;
    e.col(2) = area.normalized(), e.col(0) = e.col(2).unitOrthogonal();
    e.col(1) = Eigen::Vector3d(e.col(2)).cross(Eigen::Vector3d(e.col(0)));
    return e;
  }
};

template <class E, class M>
UniformMotions<E> uniform_motions(const SingleElement<E, M>& single) {
  double gyration = 0, thickness = 0;
  if constexpr (turns_nodes<E>()) {
    gyration = std::sqrt(single.nodal_inertia() / single.nodal_mass());
    thickness = single.material().thickness();
  }
  return {single.now().x, gyration, thickness};
}

/// The free vibrations of an element where it stands, in ascending frequency. Among shapes of one frequency, those are
/// taken that are rigid, straining or hourglass and that go along the axes.
template <class E, class M>
std::vector<Eigenmode<E>> eigenmodes(const SingleElement<E, M>& single) {
  constexpr int m = motions<E>;
  const auto vibration = single.vibration();
  const auto uniform = uniform_motions(single);
  Eigen::MatrixXd both(3 * m, uniform.rigid.cols() + uniform.straining.cols());
  both << uniform.rigid, uniform.straining;
  const Eigen::MatrixXd Q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(both).householderQ() * Eigen::MatrixXd::Identity(3 * m, both.cols());
  const Eigen::MatrixXd R = Q.leftCols(6), U = Q.rightCols(both.cols() - 6);

  // Springs between the nodes that grow from x to z, so weak that they only choose among equals.
  const auto& x = single.now().x;
  const double size = (x.colwise() - x.rowwise().mean()).norm();
  Eigen::MatrixXd choice = 2 * U * U.transpose() - 2 * R * R.transpose();
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j) {
      const Eigen::Vector3d d = (x.col(i % E::nodes) - x.col(j % E::nodes)).cwiseAbs() / size;
      const double spring = i / E::nodes == j / E::nodes ? 0.01 * Eigen::Vector3d(1, 2, 3).dot(d) : 0;
      for (int k = 0; k < 3; ++k) {
        choice(3 * i + k, 3 * i + k) += spring * (1 + 0.3 * k);
        choice(3 * i + k, 3 * j + k) -= spring * (1 + 0.3 * k);
      }
    }
  const Eigen::MatrixXd &K = vibration.stiffness, &C = vibration.damping;
  const double weak = 1e-7 * K.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K + weak * choice);

  std::vector<Eigenmode<E>> modes;
  for (int k = 0; k < 3 * m; ++k) {
    const Eigen::VectorXd phi = solver.eigenvectors().col(k);
    const double rigid = (R.transpose() * phi).squaredNorm(), straining = (U.transpose() * phi).squaredNorm();
    const double w2 = phi.dot(K * phi) / vibration.mass, zero = 1e-10 * K.norm() / vibration.mass;  // the rounding of K
    modes.push_back({rigid > 0.5       ? ModeKind::rigid
                     : straining > 0.5 ? ModeKind::straining
                                       : ModeKind::hourglass,
                     std::abs(w2) > zero ? std::sqrt(std::abs(w2)) : 0,
                     std::max(0.0, phi.dot(C * phi) / vibration.mass), Eigen::Map<const Nodal<double, m>>(phi.data())});
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const auto& a, const auto& b) { return a.frequency < b.frequency * (1 - 1e-6); });
  return modes;
}

namespace detail {

// Strains of solids by the components xx, yy, zz, xy, yz, zx; of plates membrane and curvature by xx, yy, xy and the
// shears, lengths in units of h; and what stress does work on them.
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

/// How far an element at rest is from the stiffness that its material and its shape give it under uniform strains:
///   |U^T K U - V C|/|V C|,   U the uniform strains of its nodes and C the tangent of the material.
/// Zero but for rounding, if it measures linear fields, spreads the stress as the gradient of its volume says, and has
/// an hourglass control that keeps out. In their plane the layers of a section must be isotropic.
template <class E, class M>
double uniform_strain_error(const SingleElement<E, M>& single) {
  const auto uniform = uniform_motions(single);
  const Eigen::MatrixXd exact =
      single.now().volume * detail::tangent(single.material(), uniform.thickness, 1e-6 * single.now().stable_step);
  const Eigen::MatrixXd found = uniform.straining.transpose() * single.vibration().stiffness * uniform.straining;
  return (found - exact).norm() / exact.norm();
}

}  // namespace strike
