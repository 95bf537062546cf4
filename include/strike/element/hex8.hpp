#pragma once
#include <limits>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/hex8_modes.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

/// The eight-node hexahedron with one point, the mean stress and hourglass control of Flanagan and Belytschko (1981),
/// written in its own modes. Policies: hourglass control, rotation of the stress, bulk viscosity, and where in the step
/// the motion is measured.
///   Hex8{}   Hex8{StiffnessHourglass{.coefficient = 0.01}}   Hex8{ViscousHourglass{}, Jaumann{}, NoBulkViscosity{}}
template <class Hourglass = ViscousHourglass, Rotation Spin = HughesWinget, class Viscosity = BulkViscosity,
          class Instant = MidStep>
struct Hex8 {
  [[no_unique_address]] Hourglass hourglass{};
  [[no_unique_address]] Spin rotation{};
  [[no_unique_address]] Viscosity bulk_viscosity{};
  [[no_unique_address]] Instant instant{};

  using Kinematics = SolidKinematics;
  static constexpr int nodes = 8;

  template <class M, class T>
  struct State {
    T mass{};
    [[no_unique_address]] typename Hourglass::template State<T> hourglass{};
    typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 8>& x) const {
    if constexpr (requires { material.begin(state.material); }) material.begin(state.material);
    state.mass = material.density() * Hex8Gradient<T>(to_modes<T>(x)).volume;
    return 0.125 * state.mass;
  }

  template <class M, class T>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                         double dt) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(v);
    const Hex8Gradient<T> g(m);
    const T V = g.volume, rho = state.mass / V;
    const SymmetricTensor<T> BB = g.squared();
    const SymmetricTensor<T> BB_VV = T(1.0 / (V * V)) * BB;
    const Slenderness<T> slenderness(BB_VV);

    const Matrix3<T> L = g.gradient_of(u);
    const Matrix3<T> L_mid = instant(L, dt);
    const SolidKinematics::Rate<T> rate{symmetric_part(L_mid), material.density() / rho};
    const T theta = trace(rate.rate_of_deformation);
    const T dV = volume_increment<T>(V, dt * theta);

    const auto turn = rotation.turn(Vector3<T>(T(dt) * axial_vector(L_mid)));
    turn_tensors(turn, state.material);
    turn_tensors(turn, state.hourglass);

    Response<T, 8> response;
    response.volume = V;

    T q = T(0.0);
    if constexpr (viscous) {
      const Moduli<T> moduli = material.moduli(state.material, rate);
      const T c = sqrt((moduli.bulk + (4.0 / 3.0) * moduli.shear) / rho);
      q = intact(material, state) * bulk_viscosity.pressure(rho, slenderness.length(), c, theta);
      if constexpr (requires { state.material.internal_energy; })
        state.material.internal_energy += -q * dV * material.density() / state.mass;
    }
    response.bulk_viscosity_work = -q * dt * theta * (V - 0.5 * dV);

    const SymmetricTensor<T> before = material.stress(state.material);
    SymmetricTensor<T> sigma = material.stress(state.material, rate, dt);
    response.internal_work = 0.5 * dt * double_dot(T(V - dV) * before + V * sigma, rate.rate_of_deformation);
    sigma += SymmetricTensor<T>::isotropic(-q);

    const Moduli<T> moduli = material.moduli(state.material, rate);
    const T c = sqrt((moduli.bulk + (4.0 / 3.0) * moduli.shear) / rho);
    const T frequency_squared = slenderness.frequency_squared(moduli, rho);
    T decay = T(0.0);
    if constexpr (viscous)
      decay += 2.0 * sqrt(frequency_squared) * bulk_viscosity.damping(slenderness.length(), c, theta);
    if constexpr (requires { material.viscosity(); }) decay += slenderness.decay(T(material.viscosity()), rho);
    response.stable_step = critical_step(frequency_squared, decay);

    Hex8Modes<T> F;
    Matrix3<T> S = sigma.matrix();
    if constexpr (controlled) {
      const HourglassElement<T> element{state.mass, V, c, moduli.shear, trace(BB), T(dt)};
      const auto rate_of = [&](const Vector3<T>& u_k, const Vector3<T>& m_k) -> Vector3<T> {
        return u_k - L.col(0) * m_k(0) - L.col(1) * m_k(1) - L.col(2) * m_k(2);
      };
      const HourglassModes<T> rates{rate_of(u.b1, m.b1), rate_of(u.b2, m.b2), rate_of(u.b3, m.b3), rate_of(u.d, m.d)};
      HourglassModes<T> Q = hourglass.resistance(state.hourglass, element, rates);
      if constexpr (requires { material.intact(state.material); })
        for (auto& Q_k : Q) Q_k *= material.intact(state.material);
      response.hourglass_work = hourglass.work(element, Q, rates);

      // gamma_k = Lambda_k - B.m_k/V, so that |gamma_k|^2 = 8 - m_k.g_k/(4 V) + m_k.(B B^T/V^2) m_k
      const T quarter = 0.25 / V;
      const T gamma_squared =
          8.0 + max(max(quadratic_form(BB_VV, m.b1) - quarter * m.b1.dot(g.b1),
                        quadratic_form(BB_VV, m.b2) - quarter * m.b2.dot(g.b2)),
                    max(quadratic_form(BB_VV, m.b3) - quarter * m.b3.dot(g.b3), quadratic_form(BB_VV, m.d)));
      response.stable_step = min(response.stable_step, hourglass_step(element, gamma_squared));

      const T w = -1.0 / V;
      for (int j = 0; j < 3; ++j) S.col(j) += w * (Q[0] * m.b1(j) + Q[1] * m.b2(j) + Q[2] * m.b3(j) + Q[3] * m.d(j));
      F.b1 = Q[0], F.b2 = Q[1], F.b3 = Q[2], F.d = Q[3];
    } else {
      response.hourglass_work = T(0.0);
      F.b1 = F.b2 = F.b3 = F.d = Vector3<T>::Zero();
    }
    if constexpr (requires { material.intact(state.material); })
      response.stable_step =
          select(material.intact(state.material) > 0.0, response.stable_step, T(std::numeric_limits<RealOf<T>>::max()));

    S *= T(1.0 / 64.0);
    const auto force = [&](const Vector3<T>& g_k) -> Vector3<T> {
      return S.col(0) * g_k(0) + S.col(1) * g_k(1) + S.col(2) * g_k(2);
    };
    F.a1 = force(g.a1), F.a2 = force(g.a2), F.a3 = force(g.a3);
    F.b1 += force(g.b1), F.b2 += force(g.b2), F.b3 += force(g.b3);
    response.force = to_nodes(F);
    return response;
  }

 private:
  static constexpr bool viscous = !std::same_as<Viscosity, NoBulkViscosity>;
  static constexpr bool controlled = !std::same_as<Hourglass, NoHourglass>;

  template <class M, class T>
  static T intact(const M& material, const State<M, T>& state) {
    if constexpr (requires { material.intact(state.material); })
      return material.intact(state.material);
    else
      return T(1.0);
  }

  template <class T>
  T hourglass_step(const HourglassElement<T>& element, const T& gamma_squared) const {
    if constexpr (requires { hourglass.decay(element, gamma_squared); })
      return 2.0 / hourglass.decay(element, gamma_squared);
    else
      return 2.0 / sqrt(hourglass.frequency_squared(element, gamma_squared));
  }
};

Hex8()->Hex8<>;
template <class H>
Hex8(H) -> Hex8<H>;
template <class H, class R>
Hex8(H, R) -> Hex8<H, R>;
template <class H, class R, class V>
Hex8(H, R, V) -> Hex8<H, R, V>;
template <class H, class R, class V, class I>
Hex8(H, R, V, I) -> Hex8<H, R, V, I>;

}  // namespace strike
