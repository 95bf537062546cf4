#pragma once
// The exact limit of the step of a whole mesh, from the exact derivatives of its forces.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <strike/scalar/dual.hpp>
#include <strike/verify/single_element.hpp>

#include "support/eigen.hpp"

namespace strike::testing {

using namespace strike::verify;

/// A solid that answers by its elastic moduli, whatever it has yielded.
template <class M>
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

/// The free vibrations of the mesh of a run in `in<double>` about where it stands, over the square roots of the masses:
/// of its first part, whose material answers elastically.
template <class Run>
auto vibration(Run& run) {
  auto& part = run.template part<0>();
  const auto& nodes = run.nodes();
  const auto& element = part.element();
  using E = std::decay_t<decltype(element)>;
  using M = Unyielding<std::decay_t<decltype(part.material())>>;
  using D = Dual<double, 3>;
  const M law{part.material()};
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  ElementVibration<> mesh{
      .stiffness = Eigen::MatrixXd::Zero(size, size), .damping = Eigen::MatrixXd::Zero(size, size), .mass = 1};

  for (const auto& block : part.blocks()) {
    typename E::template State<M, D> begin;
    std::ranges::copy(numbers_of<double>(block.state), numbers_of<D>(begin).begin());
    Nodal<double, E::nodes> X, V;
    std::array<std::size_t, E::nodes> cell;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      cell[i] = nodes.number(block.nodes[i][0]);
      X.col(static_cast<int>(i)) = nodes.x(cell[i]), V.col(static_cast<int>(i)) = nodes.v(cell[i]);
    }
    const double dt = 1e-6 * run.stable_step().dt;
    for (std::size_t j = 0; j < cell.size(); ++j) {
      const auto force = [&](double over) -> Nodal<D, E::nodes> {
        auto state = begin;
        Nodal<D, E::nodes> x = X.template cast<D>(), v = V.template cast<D>();
        for (int c = 0; c < 3; ++c) {
          const D change = D::variable(0, static_cast<std::size_t>(c));
          x(c, static_cast<int>(j)) += over * change, v(c, static_cast<int>(j)) += change;
        }
        return element.advance(state, law, x, v, over).force;
      };
      const auto one = force(dt), two = force(2 * dt);  // their derivatives: dt K + C, 2 dt K + C
      for (std::size_t i = 0; i < cell.size(); ++i)
        for (int a = 0; a < 3; ++a)
          for (std::size_t b = 0; b < 3; ++b) {
            const double first = one(a, static_cast<int>(i)).derivative(b),
                         second = two(a, static_cast<int>(i)).derivative(b);
            const auto row = static_cast<Eigen::Index>(3 * cell[i]) + a,
                       column = static_cast<Eigen::Index>(3 * cell[j] + b);
            const double scale = 0.5 / std::sqrt(nodes.mass(cell[i]) * nodes.mass(cell[j]));  // half: symmetric part
            mesh.stiffness(row, column) += scale * (second - first) / dt;
            mesh.stiffness(column, row) += scale * (second - first) / dt;
            mesh.damping(row, column) += scale * (2 * first - second);
            mesh.damping(column, row) += scale * (2 * first - second);
          }
    }
  }
  return mesh;
}

/// The largest eigenvalue of K dt^2/4 + C dt/2 over the masses: stable up to 1.
template <class Mesh>
double eigenvalue(const Mesh& mesh, double dt) {
  const Eigen::MatrixXd both = 0.25 * dt * dt * mesh.stiffness + 0.5 * dt * mesh.damping;
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(both, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace strike::testing
