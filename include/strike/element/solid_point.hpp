#pragma once
#include <limits>

#include <strike/element/element.hpp>

namespace strike {

/// Answer of a point of a solid element to a step.
template <class T>
struct PointResponse {
  SymmetricTensor<T> stress;  ///< Cauchy, at the end of the step
  T work;                     ///< done on the point, by the mean of its stresses before and after the step [energy]
};

/// Advances the material at a point of an element, its tensors already turned, over the step dt that changed the
/// point's volume by dV to V. The work is done on D: that of the rate, unless an element strains its material
/// otherwise than its nodes move.
template <class M, class State, class T>
PointResponse<T> advance_point(const M& material, State& state, const SolidKinematics::Rate<T>& rate, double dt,
                               const T& V, const T& dV, const SymmetricTensor<T>& D) {
  SymmetricTensor<T> before = material.stress(state);
  const SymmetricTensor<T> sigma = material.stress(state, rate, dt);
  if constexpr (requires { material.viscosity(); })  // stress that is not remembered was the same before the step
    before += sigma - material.stress(state);
  return {sigma, 0.5 * dt * double_dot(T(V - dV) * before + V * sigma, D)};
}
template <class M, class State, class T>
PointResponse<T> advance_point(const M& material, State& state, const SolidKinematics::Rate<T>& rate, double dt,
                               const T& V, const T& dV) {
  return advance_point(material, state, rate, dt, V, dV, rate.rate_of_deformation);
}

/// Sets a point of an element at rest; its place is the middle of the nodes x, for a material whose begin takes one.
template <class M, class State, class T, int n>
void begin_point(const M& material, State& state, const Nodal<T, n>& x) {
  if constexpr (requires { material.begin(state, Vector3<T>()); }) {
    Vector3<T> place = column(x, 0);
    for (std::size_t i = 1; i < n; ++i) place = place + column(x, i);
    material.begin(state, Vector3<T>((1.0 / n) * place));
  } else if constexpr (requires { material.begin(state); }) {
    material.begin(state);
  }
}

/// 1, or 0 where the material has failed.
template <class T, class M, class State>
T intact_share(const M& material, const State& state) {
  if constexpr (requires { material.intact(state); })
    return material.intact(state);
  else
    return (void)material, (void)state, T(1.0);
}

/// Gives heat per reference volume to a material with an internal energy.
template <class State, class T>
void heat(State& state, const T& energy) {
  if constexpr (requires { state.internal_energy; }) state.internal_energy += energy;
}

/// A failed element gives no force and limits no step, however distorted it is. In the step of the failure the stress
/// before has done its half of the work.
template <class Flag, class T, int n>
void zero_if_failed(const Flag& intact, Response<T, n>& response) {
  response.force = response.force.unaryExpr([&](const T& f) -> T { return select(intact, f, T(0.0)); }).eval();
  response.volume = select(intact, response.volume, T(1.0));
  response.critical_rate = select(intact, response.critical_rate, T(0.0));
  response.internal_work =
      select(abs(response.internal_work) <= std::numeric_limits<RealOf<T>>::max(), response.internal_work, T(0.0));
  response.hourglass_work = select(intact, response.hourglass_work, T(0.0));
  response.bulk_viscosity_work = select(intact, response.bulk_viscosity_work, T(0.0));
}

}  // namespace strike
