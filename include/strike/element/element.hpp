#pragma once
#include <concepts>
#include <tuple>
#include <type_traits>

#include <strike/material/elastic.hpp>
#include <strike/material/material.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

/// Vectors at the n nodes of an element, a column each.
template <class T, int n>
using Nodal = Eigen::Matrix<T, 3, n>;

/// Whether an element turns its nodes, which then have angular velocities and feel moments.
template <class E>
constexpr bool turns_nodes() {
  if constexpr (requires { E::turns_nodes; })
    return E::turns_nodes;
  else
    return false;
}
/// How many vectors tell the motion of an element: the velocities of its nodes, and if these turn their angular
/// velocities behind them. As many tell its forces, and moments.
template <class E>
inline constexpr int motions = turns_nodes<E>() ? 2 * E::nodes : E::nodes;

/// What an element gives to each of its nodes that turn.
template <class T>
struct NodalInertia {
  T mass, inertia;  ///< inertia: moment of inertia about any axis [mass length^2]
};

/// What an element answers to a step; n is the number of its `motions`.
template <class T, int n>
struct Response {
  Nodal<T, n> force;      ///< on the element's nodes that deform it, B sigma: the mesh feels its negative
  T volume;               ///< or area, at the end of the step; not positive: the element is inverted
  T critical_rate;        ///< one over the largest step that this element alone allows next
  T internal_work;        ///< done on the material in the step
  T hourglass_work;       ///< done against the hourglass control
  T bulk_viscosity_work;  ///< dissipated by the bulk viscosity
};

/// An element: it measures the motion of its nodes, turns what its material remembers, asks the material, and gives
/// forces.
///
/// A model has
/// - `Kinematics`, which must be the material's, and the number of its `nodes`;
/// - `State<M, T>`: what it remembers, with `each_point(f)` over the states of its material points;
/// - `begin(state, material, x)`: sets the state at rest at the positions x and returns the mass of each of its nodes,
/// or their NodalInertia if it says that it `turns_nodes`;
/// - `advance(state, material, x, v, dt)`: advances the state over the step dt that ended at the positions x, through
/// which
///   the nodes moved at the velocities v, `motions` columns, and returns the Response.
/// Laws (see tests/conformance): the gradient operator is dV/dx; it reproduces linear fields on any distorted shape; a
/// rigid motion gives no force; forces and their moments sum to zero; hourglass control does no work on linear fields
/// and creates no energy.
template <class E, class M = Elastic>
concept Element = std::same_as<typename E::Kinematics, typename M::Kinematics> &&
                  requires(const E e, typename E::template State<M, double> state, const M m,
                           const Nodal<double, E::nodes> x, const Nodal<double, motions<E>> v) {
                    {
                      e.begin(state, m, x)
                    } -> std::convertible_to<std::conditional_t<turns_nodes<E>(), NodalInertia<double>, double>>;
                    { e.advance(state, m, x, v, 1.0) } -> std::same_as<Response<double, motions<E>>>;
                  };

/// Turns every spatial tensor that the state declares.
template <class Turn, class State>
void turn_tensors(const Turn& turn, State& state) {
  if constexpr (requires { state.spatial_tensors(); })
    std::apply([&](auto&... tensor) { ((tensor = turn(tensor)), ...); }, state.spatial_tensors());
}

// Where in a step the motion is measured: the velocity gradient there, and `to_end(w)`, which carries what is measured
// there to the end of the step; w is the axial vector of the step's spin, skew(L) dt.

/// At the end of the step: cheaper, and a rotation by theta per step strains by 1 - cos(theta).
struct EndStep {
  template <class T>
  Matrix3<T> operator()(const Matrix3<T>& L, double) const {
    return L;
  }
  template <class T>
  auto to_end(const Vector3<T>&) const {
    return [](const auto& tensor) { return tensor; };
  }
};

/// In the middle of the step, from the gradient at its end, L_mid = L (I - dt/2 L)^-1: exact in a homogeneous motion,
/// and a rotation strains nothing. Half the spin is still to come, by which the rate of deformation is turned: without
/// that the stress would answer askew by theta/2, and modes of one frequency w would feed each other, each growing by
/// exp(w dt theta/2) a step.
struct MidStep {
  template <class T>
  Matrix3<T> operator()(const Matrix3<T>& L, double dt) const {
    const T h = -0.5 * dt;
    const Vector3<T> p{1.0 + h * L(0, 0), h * L(1, 0), h * L(2, 0)}, q{h * L(0, 1), 1.0 + h * L(1, 1), h * L(2, 1)},
        r{h * L(0, 2), h * L(1, 2), 1.0 + h * L(2, 2)};
    const Vector3<T> qr = cross(q, r), rp = cross(r, p), pq = cross(p, q);
    const auto column = [&](int j) { return times<T>(L, {qr(j), rp(j), pq(j)}); };
    return T(1.0 / dot(p, qr)) * columns(column(0), column(1), column(2));
  }
  template <class T>
  auto to_end(const Vector3<T>& w) const {
    return Jaumann{}.turn(Vector3<T>(T(0.5) * w));  // first order is enough: where a motion is rigid nothing is turned
  }
};

}  // namespace strike
