#pragma once
#include <concepts>
#include <type_traits>

#include <strike/each_of.hpp>
#include <strike/element/cell_shape.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/material.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

/// Vectors at the n nodes of an element, a column each.
template <class T, int n>
using Nodal = Eigen::Matrix<T, 3, n>;

/// The element turns its nodes, which then have angular velocities and take moments.
template <class E>
constexpr bool turns_nodes() {
  if constexpr (requires { E::turns_nodes; })
    return E::turns_nodes;
  else
    return false;
}
/// Elements of a part see their neighbours, and the part knows how.
template <class E>
constexpr bool sees_neighbours() {
  if constexpr (requires { E::sees_neighbours; })
    return E::sees_neighbours;
  else
    return false;
}
/// The element gives way to a constant load for ever, for a part of its resistance is viscous.
template <class E>
constexpr bool flows() {
  if constexpr (requires { E::flows; })
    return E::flows;
  else
    return false;
}
/// The element is a surface: a plate or a membrane.
template <class E>
inline constexpr bool is_flat = turns_nodes<E>() || std::same_as<typename E::Kinematics, PlaneStressKinematics>;
/// The element knows hexahedra of which corners are in the same node.
template <class E>
constexpr bool merges_corners() {
  if constexpr (requires { E::merges_corners; })
    return E::merges_corners;
  else
    return false;
}
/// Number of the vectors that tell the motion of an element: the velocities of its nodes, and if these turn their
/// angular velocities behind them. As many tell its forces, and moments.
template <class E>
inline constexpr int motions = turns_nodes<E>() ? 2 * E::nodes : E::nodes;

/// Share of an element in each of its nodes that turn.
template <class T>
struct NodalInertia {
  T mass, inertia;  ///< inertia: moment of inertia about any axis [mass length^2]
};

/// Answer of an element to a step; n is the number of its `motions`.
template <class T, int n>
struct Response {
  Nodal<T, n> force;      ///< by which the nodes deform the element, B sigma: on the mesh acts its negative
  T volume;               ///< or area, at the end of the step; not positive: the element is inverted
  T critical_rate;        ///< one over the largest step that this element alone allows next [1/time]
  T internal_work;        ///< done on the material in the step [energy]
  T hourglass_work;       ///< done against the hourglass control [energy]
  T bulk_viscosity_work;  ///< dissipated by the bulk viscosity [energy]
};

namespace detail {
/// Archetype of a function that visits points.
struct PointVisitor {
  void operator()(const auto&) const {}
};
}  // namespace detail

/// An element: measures the motion of its nodes, turns the tensors of its material, calls it, and gives forces.
///
/// Requirements
/// 1. `Kinematics`: its pair of measure and stress, which must be the material's.
/// 2. `nodes`: their number.
/// 3. `State<M, T>`: its memory, an aggregate of numbers T, with `each_point(f)`, which calls f with the state of each
///    of its material points.
/// 4. `begin(state, material, x)`: sets the state at rest at the positions x and returns the mass of each node, or its
///    NodalInertia if the element turns its nodes.
/// 5. `advance(state, material, x, v, dt)`: advances the state over the step dt that ended at the positions x, through
///    which the nodes moved at the velocities v, `motions` columns, and returns the Response.
/// begin and advance are templates over the number T.
/// Optional
/// 6. `turns_nodes`: true where nodes have angular velocities.
/// 7. `State::each_point(k, f)`: the points of layer k.
/// 8. `averages_volume`: true where the driver averages volumes over nodes; then also `volume(x)`, `advance(state,
///    material, x, v, nodal_volume, dt)` and `State::relative_volume` (strike/element/tet4.hpp).
/// 9. `resistance(state, material, x, v, dt)`: of a small motion, for GlobalStep (strike/element/hex8_resistance.hpp).
/// 10. `flows`: true where it gives way to a constant load for ever, of which a relaxation warns.
/// 11. `ranges(number)`: what its numbers may be (strike/range.hpp); its policies may have it too.
/// 12. `shape`: a static constexpr CellShape; a run refuses cells at its start that break the laws of check(mesh).
/// 13. `merges_corners`: true where hexahedra may be wedges and pyramids; then also advance with a pointer to its
///     VibrationSources behind dt, and `merged_rate` (strike/element/hex8.hpp). begin returns the mass of each of eight
///     corners all the same.
/// Laws (tests/conformance): the gradient operator is dV/dx; it reproduces linear fields on any distorted shape; a
/// rigid motion gives no force; forces and their moments sum to zero; hourglass control does no work on linear fields
/// and creates no energy; in a step without time, dt = 0, no work is done. Models: Hex8, Hex8Full, Tet4, Plate4,
/// Plate3, MassScaled. Their policies: strike/element/policies.hpp.
template <class E, class M = Elastic>
concept Element = std::same_as<typename E::Kinematics, typename M::Kinematics> &&
                  requires(const E e, typename E::template State<M, double> state, const M m,
                           const Nodal<double, E::nodes> x, const Nodal<double, motions<E>> v) {
                    state.each_point(detail::PointVisitor{});
                    {
                      e.begin(state, m, x)
                    } -> std::convertible_to<std::conditional_t<turns_nodes<E>(), NodalInertia<double>, double>>;
                    { e.advance(state, m, x, v, 1.0) } -> std::same_as<Response<double, motions<E>>>;
                  };

/// Turns every spatial tensor that the state declares.
template <class Rotator, class State>
void turn_tensors(const Rotator& rotate, State& state) {
  if constexpr (requires { state.spatial_tensors(); })
    detail::each_of(state.spatial_tensors(), [&](auto& tensor) { tensor = rotate(tensor); });
}

/// The end of the step: cheaper, and a rotation by theta per step strains by 1 - cos(theta).
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

/// The middle of the step, from the gradient at its end, L_mid = L (I - dt/2 L)^-1: exact in a homogeneous motion, and
/// a rotation strains nothing. The rate of deformation is turned by the other half of the spin: without that the stress
/// would be off by the angle theta/2, and modes of one frequency w would feed each other, each growing by
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
    return Jaumann{}.turn(Vector3<T>(T(0.5) * w));  // first order suffices: in a rigid motion there is no rate to turn
  }
};

}  // namespace strike
