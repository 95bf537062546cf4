#pragma once
#include <concepts>
#include <type_traits>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/element/tet4_gradient.hpp>
#include <strike/element/tet4_resistance.hpp>
#include <strike/range.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

// Volume from which the pressure of a tetrahedron follows. A mesh has more tetrahedra than its nodes can give volumes
// to: without a mean over neighbours it locks where volume can hardly change.

/// The tetrahedron's own volume: standard tetrahedra. A Taylor bar of them spreads by little more than half of what it
/// should.
struct ElementPressure {};

/// A share of the mean over the nodes, J = share mean(J_a) + (1 - share) V/V0, where the volume of a node is that of
/// all tetrahedra at it, J_a = sum V/sum V0 (Bonet and Burton 1998: share 1, for metals). Materials without strength
/// need some of the tetrahedron's own.
struct NodalPressure {
  double share = 0.9;  ///< from 0 to 1

  void ranges(const auto& number) const { number("share", share, range::share); }
};

/// The four-node tetrahedron of constant strain. Policies: the volume of its pressure, rotation of the tensors, bulk
/// viscosity, and the instant of the step at which the motion is measured.
///   Tet4{}   Tet4{NodalPressure{1.0}}   Tet4{ElementPressure{}, Jaumann{}, NoBulkViscosity{}}
template <class Pressure = NodalPressure, class Spin = HughesWinget, class Viscosity = BulkViscosity,
          class Instant = MidStep>
struct Tet4 {
  static constexpr bool averages_volume = std::same_as<Pressure, NodalPressure>,
                        has_pressure = TetrahedralPressure<Pressure>, has_rotation = has_pressure && Rotation<Spin>,
                        has_viscosity = has_rotation && ShockViscosity<Viscosity>,
                        sound = has_viscosity && MeasuringInstant<Instant>;
  static_assert(has_pressure,
                "strike: the first policy of Tet4 is where its pressure comes from: NodalPressure or ElementPressure.");
  static_assert(!has_pressure || has_rotation,
                "strike: the second policy of Tet4 is the rotation of its tensors: HughesWinget or Jaumann.");
  static_assert(!has_rotation || has_viscosity,
                "strike: the third policy of Tet4 is its bulk viscosity: BulkViscosity, "
                "BulkViscosityBothWays or NoBulkViscosity.");
  static_assert(!has_viscosity || sound,
                "strike: the fourth policy of Tet4 is the instant at which it measures: MidStep or EndStep.");

  [[no_unique_address]] Pressure pressure{};
  [[no_unique_address]] Spin rotation{};
  [[no_unique_address]] Viscosity bulk_viscosity{};
  [[no_unique_address]] Instant instant{};

  void ranges(const auto& number) const { number(pressure), number(rotation), number(bulk_viscosity), number(instant); }

  using Kinematics = SolidKinematics;
  static constexpr int nodes = 4;
  static constexpr CellShape shape = CellShape::tetrahedron;

  template <class T>
  struct GivenVolume {
    T relative_volume{1.0};  ///< J given to the material
  };
  template <class T>
  struct OwnVolume {};

  template <class M, class T>
  struct State : std::conditional_t<averages_volume, GivenVolume<T>, OwnVolume<T>> {
    T inverse_volume{};  ///< 1/V0
    [[no_unique_address]] typename Viscosity::template State<T> viscosity{};
    [[no_unique_address]] typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 4>& x) const {
    begin_point(material, state.material, x);
    const T V = volume(x);
    state.inverse_volume = 1.0 / V;
    return (0.25 * density_of(material)) * V;
  }

  template <class T>
  T volume(const Nodal<T, 4>& x) const {
    return Tet4Gradient<T>(x).volume;
  }

  /// An element without neighbours: its nodes have its own volume.
  template <class M, class T>
  Response<T, 4> advance(State<M, T>& state, const M& material, const Nodal<T, 4>& x, const Nodal<T, 4>& v,
                         double dt) const {
    return advance(state, material, x, v, T(volume(x) * state.inverse_volume), dt);
  }

  /// `nodal_volume`: the mean of J_a over its nodes.
  template <class M, class T>
  Response<T, 4> advance(State<M, T>& state, const M& material, const Nodal<T, 4>& x, const Nodal<T, 4>& v,
                         const T& nodal_volume, double dt) const {
    const Tet4Gradient<T> g(x);
    const T& V = g.volume;
    const T J = V * state.inverse_volume, compression = 1.0 / J;
    const T per_volume = compression * state.inverse_volume;  // 1/V
    // Half of S, for the masses are rho V/4 and Stability has them rho V/8.
    const SymmetricTensor<T> S = T(1.0 / 72.0) * per_volume * per_volume * g.squared();
    const Stability<T> stability{trace(S), largest_eigenvalue(S), (1.0 / density_of(material)) * J};

    const Matrix3<T> L_mid = instant(g.gradient_of(v, per_volume), dt);
    const Vector3<T> spin = T(dt) * axial_vector(L_mid);
    const SymmetricTensor<T> D = instant.to_end(spin)(symmetric_part(L_mid));
    const T theta = trace(D);
    const T dV = volume_increment<T>(V, dt * theta);
    const SolidKinematics::Rate<T> rate = material_rate(state, D, theta, J, nodal_volume, dt);
    const Moduli<T> before = material.moduli(state.material, rate);
    turn_tensors(rotation.turn(spin), state.material);

    Response<T, 4> response;
    response.volume = V;
    response.hourglass_work = T(0.0);
    const T q = bulk_viscosity.pressure(before.wave(), stability.crossing_time(before.wave()), theta);
    response.bulk_viscosity_work = bulk_viscosity.work(state.viscosity, q, dV);
    heat(state.material, response.bulk_viscosity_work * state.inverse_volume);

    const auto [sigma, work] = advance_point(material, state.material, rate, dt, V, dV, D);
    response.internal_work = work;
    response.force = g.forces_of(sigma - SymmetricTensor<T>::isotropic(q));

    const Moduli<T> after = material.moduli(state.material, rate);
    const T zeta = bulk_viscosity.coefficient(after.wave(), stability.crossing_time(after.wave()), theta);
    response.critical_rate = stability.vibration(material, after, zeta).critical_rate();
    if constexpr (requires { material.intact(state.material); })
      zero_if_failed(material.intact(state.material) > 0.0, response);
    return response;
  }

  template <class T>
  using Resistance = Tet4Resistance<T, averages_volume>;

  /// Resistance to a small motion in a step dt from here; v are the velocities of the nodes.
  template <class M, class T>
  Resistance<T> resistance(const State<M, T>& state, const M& material, const Nodal<T, 4>& x, const Nodal<T, 4>& v,
                           double dt) const {
    const Tet4Gradient<T> g(x);
    const T J = g.volume * state.inverse_volume, per_volume = 1.0 / g.volume;
    SolidKinematics::Rate<T> rate{symmetric_part(g.gradient_of(v, per_volume)), J};
    const T theta = trace(rate.rate_of_deformation);
    if constexpr (averages_volume) rate.relative_volume = state.relative_volume;
    const Moduli<T> moduli = material.moduli(state.material, rate);
    const T L1 = largest_eigenvalue(SymmetricTensor<T>(T(1.0 / 72.0) * per_volume * per_volume * g.squared()));
    const Stability<T> stability{T(0.0), L1, (1.0 / density_of(material)) * J};
    const T zeta = bulk_viscosity.coefficient(moduli.wave(), stability.crossing_time(moduli.wave()), theta);
    Resistance<T> resistance{T(0.25 * density_of(material) / state.inverse_volume),
                             SolidResistance<T>::in_step(material, moduli, zeta, dt)};
    if constexpr (averages_volume) {
      const T k = T(0.25 * dt * dt * pressure.share) * moduli.bulk;
      resistance.root_bulk = sqrt(k), resistance.own.lambda -= k;
    }
    resistance *= intact_share<T>(material, state.material);
    return resistance;
  }

 private:
  /// The rate of the material: the change of shape of the element, and that of the volume given to it.
  template <class S, class T>
  SolidKinematics::Rate<T> material_rate(S& state, const SymmetricTensor<T>& D, const T& theta, const T& J,
                                         const T& nodal_volume, double dt) const {
    if constexpr (averages_volume) {
      const T before = state.relative_volume;
      state.relative_volume = pressure.share * nodal_volume + (1.0 - pressure.share) * J;
      if (!(dt > 0)) return {D, state.relative_volume};
      const T given = (2.0 / dt) * ((state.relative_volume - before) / (state.relative_volume + before));
      return {D + SymmetricTensor<T>::isotropic((1.0 / 3.0) * (given - theta)), state.relative_volume};
    } else {
      return (void)state, (void)theta, (void)nodal_volume, (void)dt, SolidKinematics::Rate<T>{D, J};
    }
  }
};

Tet4() -> Tet4<>;
template <class P>
Tet4(P) -> Tet4<P>;
template <class P, class R>
Tet4(P, R) -> Tet4<P, R>;
template <class P, class R, class V>
Tet4(P, R, V) -> Tet4<P, R, V>;
template <class P, class R, class V, class I>
Tet4(P, R, V, I) -> Tet4<P, R, V, I>;

}  // namespace strike
