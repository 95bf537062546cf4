#pragma once
// The exact limit of the step of a whole mesh, from the exact derivatives of its forces.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <strike/element/plate4_resistance.hpp>
#include <strike/element/tet4_gradient.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/verify/single_element.hpp>

#include "support/eigen.hpp"

namespace strike::testing {

using namespace strike::verify;

/// A material that answers by its elastic moduli, whatever it has yielded.
template <class M, class Kinematics = typename M::Kinematics>
struct Unyielding : M {
  template <class T>
  SymmetricTensor<T> stress(typename M::template State<T>& state, const SolidKinematics::Rate<T>& rate,
                            double dt) const {
    const Moduli<T> moduli = M::moduli(state, rate);
    const SymmetricTensor<T>& D = rate.rate_of_deformation;
    state.stress += SymmetricTensor<T>::isotropic((moduli.bulk - 2.0 / 3.0 * moduli.shear) * dt * trace(D)) +
                    T(2.0 * dt * moduli.shear) * D;
    return state.stress;
  }
  template <class T>
  SymmetricTensor<T> stress(const typename M::template State<T>& state) const {
    return state.stress;
  }
};
template <class M>
struct Unyielding<M, PlateKinematics> : M {
  template <class T>
  PlateKinematics::Stress<T> stress(typename M::template State<T>& state, const PlateKinematics::Rate<T>& rate,
                                    double dt) const {
    const auto moduli = M::moduli(state, rate);
    PlateKinematics::Stress<T> stress = M::stress(std::as_const(state), rate.relative_thickness);
    const auto add = [&](PlaneTensor<T>& to, const PlaneModuli<T>& k, const PlaneTensor<T>& e) {
      to += PlaneTensor<T>::isotropic((k.normal - 2.0 * k.shear) * dt * trace(e)) + T(2.0 * dt * k.shear) * e;
    };
    add(stress.force, moduli.extension, rate.membrane), add(stress.force, moduli.coupling, rate.curvature);
    add(stress.moment, moduli.coupling, rate.membrane), add(stress.moment, moduli.bending, rate.curvature);
    stress.shear += T(dt * moduli.transverse_shear) * rate.shear;
    stress.normal_rate = T(0.0);
    return stress;
  }
  /// The same with the linear stresses of PhysicalHourglass.
  template <class T, class Linear>
  PlateKinematics::Stress<T> stress(typename M::template State<T>& state, Linear& linear,
                                    const PlateKinematics::Rate<T>& rate, const LinearRate<T>& linear_rate, double dt,
                                    LinearResultants<T>& resultants) const {
    M::stress(state, linear, PlateKinematics::Rate<T>{}, LinearRate<T>{}, 0.0, resultants);
    const auto moduli = strike::detail::linear_moduli<M>(M::moduli(state, rate));
    const auto &e = linear_rate.membrane, &k = linear_rate.curvature;
    resultants.force = resultants.force + T(dt) * moduli.force(e, k);
    resultants.moment = resultants.moment + T(dt) * moduli.moment(e, k);
    return stress(state, rate, dt);
  }
  template <class T>
  PlateKinematics::Stress<T> stress(const typename M::template State<T>& state, const T& relative_thickness) const {
    return M::stress(state, relative_thickness);
  }
  template <class T>
  PlateKinematics::Stress<T> stress(const typename M::template State<T>& state) const {
    return M::stress(state);
  }
};

/// dJ_a/dx_j of the relative volume J_a = sum V/sum V0 of a part of tetrahedra at each node, a row each.
template <class Part, class Nodes>
Eigen::MatrixXd change_of_nodal_volume(const Part& part, const Nodes& nodes) {
  const auto size = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(size, 3 * size);
  Eigen::VectorXd reference = Eigen::VectorXd::Zero(size);
  for (const auto& block : part.blocks()) {
    Nodal<double, 4> x;
    std::array<Eigen::Index, 4> cell;
    for (std::size_t i = 0; i < 4; ++i) {
      cell[i] = static_cast<Eigen::Index>(nodes.number(block.nodes[i][0]));
      x.col(static_cast<int>(i)) = nodes.x(nodes.number(block.nodes[i][0]));
    }
    const Tet4Gradient<double> g(x);
    const Eigen::Vector3d gradient[] = {g.g0(), g.g1, g.g2, g.g3};
    for (const Eigen::Index a : cell) {
      for (std::size_t j = 0; j < 4; ++j) change.block<1, 3>(a, 3 * cell[j]) += gradient[j].transpose() / 6;
      reference(a) += 1 / block.state.inverse_volume;
    }
  }
  for (Eigen::Index a = 0; a < size; ++a)
    if (reference(a) > 0) change.row(a) /= reference(a);
  return change;
}

/// The free vibrations of the mesh of a run in `in<double>` about where it stands, over the square roots of the masses:
/// of all parts, whose materials answer elastically. Rotations stand behind all displacements.
template <class Run>
auto vibration(Run& run) {
  const auto& nodes = run.nodes();
  using Nodes = std::decay_t<decltype(nodes)>;
  const auto size = static_cast<Eigen::Index>((Nodes::nodes_turn ? 6 : 3) * nodes.size());
  ElementVibration<> mesh{
      .stiffness = Eigen::MatrixXd::Zero(size, size), .damping = Eigen::MatrixXd::Zero(size, size), .mass = 1};
  const auto root_of_mass = [&](Eigen::Index row) {
    const auto k = static_cast<std::size_t>(row) / 3;
    if constexpr (Nodes::nodes_turn)
      if (k >= nodes.size()) return std::sqrt(nodes.inertia(k - nodes.size()));
    return std::sqrt(nodes.mass(k));
  };
  /// Adds the symmetric part of columns: forces over dt and 2 dt have the derivatives dt K + C and 2 dt K + C.
  const auto add = [&](Eigen::Index row, Eigen::Index column, double first, double second, double dt) {
    const double scale = 0.5 / (root_of_mass(row) * root_of_mass(column));
    mesh.stiffness(row, column) += scale * (second - first) / dt;
    mesh.stiffness(column, row) += scale * (second - first) / dt;
    mesh.damping(row, column) += scale * (2 * first - second);
    mesh.damping(column, row) += scale * (2 * first - second);
  };

  run.each_part([&](const auto& part) {
    const auto& element = part.element();
    using Part = std::decay_t<decltype(part)>;
    using E = std::decay_t<decltype(element)>;
    using M = Unyielding<std::decay_t<decltype(part.material())>>;
    constexpr int n = E::nodes, m = motions<E>;
    using D = Dual<double, 4>;
    const M law{part.material()};
    const double dt = 1e-6 * run.stable_step().dt;
    Eigen::MatrixXd volumes;
    if constexpr (Part::averages_volume) volumes = change_of_nodal_volume(part, nodes);
    for (const auto& block : part.blocks()) {
      typename E::template State<M, D> begin;
      std::ranges::copy(numbers_of<double>(block.state), numbers_of<D>(begin).begin());
      Nodal<double, n> X;
      Nodal<double, m> V;
      std::array<Eigen::Index, static_cast<std::size_t>(m)> rows;
      for (int i = 0; i < n; ++i) {
        const std::size_t node = nodes.number(block.nodes[static_cast<std::size_t>(i)][0]);
        X.col(i) = nodes.x(node), V.col(i) = nodes.v(node);
        rows[static_cast<std::size_t>(i)] = static_cast<Eigen::Index>(3 * node);
        if constexpr (m > n) {
          V.col(n + i) = nodes.w(node);
          rows[static_cast<std::size_t>(n + i)] = static_cast<Eigen::Index>(3 * (nodes.size() + node));
        }
      }
      for (int j = 0; j < m; ++j) {
        const auto force = [&](double over) -> Nodal<D, m> {
          auto state = begin;
          Nodal<D, n> x = X.template cast<D>();
          Nodal<D, m> v = V.template cast<D>();
          for (int c = 0; c < 3; ++c) {
            const D change = D::variable(0, static_cast<std::size_t>(c));
            if (j < n) x(c, j) += over * change;
            v(c, j) += change;
          }
          if constexpr (Part::averages_volume) {
            const double share = element.pressure.share, J = element.volume(X) * block.state.inverse_volume;
            const D nodal = (block.state.relative_volume - (1 - share) * J) / share + over * D::variable(0, 3);
            return element.advance(state, law, x, v, nodal, over).force;
          } else {
            return element.advance(state, law, x, v, over).force;
          }
        };
        const auto one = force(dt), two = force(2 * dt);
        for (int i = 0; i < m; ++i)
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
              add(rows[static_cast<std::size_t>(i)] + a, rows[static_cast<std::size_t>(j)] + b,
                  one(a, i).derivative(static_cast<std::size_t>(b)), two(a, i).derivative(static_cast<std::size_t>(b)),
                  dt);
        if constexpr (Part::averages_volume)
          if (j == 0) {
            Eigen::VectorXd mean = Eigen::VectorXd::Zero(volumes.cols());
            for (int i = 0; i < n; ++i) mean += volumes.row(rows[static_cast<std::size_t>(i)] / 3).transpose() / n;
            for (Eigen::Index column = 0; column < mean.size(); ++column)
              if (mean(column) != 0)
                for (int i = 0; i < n; ++i)
                  for (int a = 0; a < 3; ++a)
                    add(rows[static_cast<std::size_t>(i)] + a, column, mean(column) * one(a, i).derivative(3),
                        mean(column) * two(a, i).derivative(3), dt);
          }
      }
    }
  });
  return mesh;
}

/// The largest eigenvalue of K dt^2/4 + C dt/2 over the masses: stable up to 1.
template <class Mesh>
double eigenvalue(const Mesh& mesh, double dt) {
  const Eigen::MatrixXd both = 0.25 * dt * dt * mesh.stiffness + 0.5 * dt * mesh.damping;
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(both, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace strike::testing
