#pragma once
#include <type_traits>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/hex8_modes.hpp>
#include <strike/element/hex8_resistance.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/element/merged_corners.hpp>
#include <strike/element/physical_hourglass.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

/// The eight-node hexahedron with one point and the mean stress of Flanagan and Belytschko (1981), written in its own
/// modes; the usual hourglass control is by the stresses that the material has beside the mean. Policies: hourglass
/// control, rotation of the tensors, bulk viscosity, and the instant of the step at which the motion is measured.
///   Hex8{}   Hex8{ViscousHourglass{}}   Hex8{StiffnessHourglass{.coefficient = 0.01}, Jaumann{}, NoBulkViscosity{}}
template <class Hourglass = PhysicalHourglass, class Spin = HughesWinget, class Viscosity = BulkViscosity,
          class Instant = MidStep>
struct Hex8 {
  static constexpr bool has_hourglass = HourglassControl<Hourglass>, has_rotation = has_hourglass && Rotation<Spin>,
                        has_viscosity = has_rotation && ShockViscosity<Viscosity>,
                        has_instant = has_viscosity && MeasuringInstant<Instant>,
                        knows_stiffness =
                            !detail::nearly<detail::ControlStiffness, const Hourglass, const HourglassElement<double>>,
                        sound = has_instant && knows_stiffness;
  static_assert(has_hourglass,
                "strike: the first policy of Hex8 is its hourglass control: PhysicalHourglass, ViscousHourglass, "
                "StiffnessHourglass or NoHourglass.");
  static_assert(!has_hourglass || has_rotation,
                "strike: the second policy of Hex8 is the rotation of its tensors: HughesWinget or Jaumann.");
  static_assert(!has_rotation || has_viscosity,
                "strike: the third policy of Hex8 is its bulk viscosity: BulkViscosity, "
                "BulkViscosityBothWays or NoBulkViscosity.");
  static_assert(!has_viscosity || has_instant,
                "strike: the fourth policy of Hex8 is the instant at which it measures: MidStep or EndStep.");
  static_assert(!has_instant || knows_stiffness,
                "strike: stiffness of an hourglass control is template <class T> T stiffness(const "
                "HourglassElement<T>& element) const; this one has other arguments or another result.");

  [[no_unique_address]] Hourglass hourglass{};
  [[no_unique_address]] Spin rotation{};
  [[no_unique_address]] Viscosity bulk_viscosity{};
  [[no_unique_address]] Instant instant{};

  void ranges(const auto& number) const {
    number(hourglass), number(rotation), number(bulk_viscosity), number(instant);
  }

  using Kinematics = SolidKinematics;
  static constexpr int nodes = 8;
  static constexpr CellShape shape = CellShape::hexahedron;
  static constexpr bool merges_corners = true;
  static constexpr bool flows = std::is_same_v<Hourglass, ViscousHourglass>;

  /// The control with a material.
  template <class M>
  using Control = std::conditional_t<std::same_as<Hourglass, PhysicalHourglass> && !has_shear_modulus<M>(),
                                     ViscousHourglass, Hourglass>;

  template <class M, class T>
  struct State {
    T inverse_volume{};  ///< 1/V0
    [[no_unique_address]] typename Viscosity::template State<T> viscosity{};
    [[no_unique_address]] typename Control<M>::template State<T> hourglass{};
    [[no_unique_address]] typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 8>& x) const {
    begin_point(material, state.material, x);
    const T V = Hex8Gradient<T>(to_modes<T>(x)).volume;
    state.inverse_volume = 1.0 / V;
    return (0.125 * density_of(material)) * V;
  }

  /// `Velocities` are nodal, or convert to them, so that they are loaded where they are needed and not before.
  template <class M, class T, class Velocities>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Velocities& v,
                         double dt) const {
    VibrationSources<T> sources;
    return advance(state, material, x, v, dt, &sources);
  }
  /// The same, and what bounds its vibrations, for merged_rate.
  template <class M, class T, class Velocities>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Velocities& v, double dt,
                         VibrationSources<std::type_identity_t<T>>* sources) const {
    constexpr bool physical = std::same_as<Control<M>, PhysicalHourglass>;
    const Control<M>& control = control_with<M>();
    // The order of the statements overlaps long chains of dependent operations (roots, quotients) with others, and
    // leaves few numbers waiting.
    const Hex8Modes<T> m = to_modes<T>(x);
    const Hex8Gradient<T> g(m);
    const T& V = g.volume;
    const T J = V * state.inverse_volume, compression = 1.0 / J;
    const T w = T(1.0 / 512.0) * state.inverse_volume * state.inverse_volume;
    const SymmetricTensor<T> S_b = w * g.squared_b(), S = S_b + w * g.squared_a();  // B B^T/V0^2
    const T eigenvalue = largest_eigenvalue(S), shrinkage = compression * compression, edge = cbrt(V);
    const Hex8Modes<T> u = to_modes<T>(v);
    const T per_volume = compression * state.inverse_volume;  // 1/V
    const T rho = density_of(material) * compression, specific_volume = (1.0 / density_of(material)) * J;

    const Matrix3<T> L = g.gradient_of(u, per_volume);
    const Matrix3<T> L_mid = instant(L, dt);
    T hourglass_overlap = T(0.0);
    if constexpr (controlled) hourglass_overlap = overlap(S, S_b, shrinkage, m, g, per_volume);
    const Stability<T> stability{shrinkage * trace(S), shrinkage * eigenvalue, specific_volume};

    const Vector3<T> spin = T(dt) * axial_vector(L_mid);
    const auto to_end = instant.to_end(spin);
    const SolidKinematics::Rate<T> rate{to_end(symmetric_part(L_mid)), J};
    const T theta = trace(rate.rate_of_deformation);
    const T dV = volume_increment<T>(V, dt * theta);
    const Moduli<T> before = material.moduli(state.material, rate);
    const T crossing_time = stability.crossing_time(before.wave());

    const auto turn = rotation.turn(spin);
    turn_tensors(turn, state.material);
    turn_tensors(turn, state.hourglass);

    Response<T, 8> response;
    response.volume = V;
    response.hourglass_work = T(0.0);
    const Vector3<T> none{T(0.0), T(0.0), T(0.0)};
    HourglassModes<T> Q{none, none, none, none};
    T hourglass_rate = T(0.0);
    const T per_mass = (1.0 / density_of(material)) * state.inverse_volume;
    const T control_shear = solid_shear(state.material, before.shear);
    const HourglassElement<T> element{rho,           V,     edge,          per_mass,        before.wave(),
                                      control_shear, T(dt), shrinkage * S, stability.trace, stability.eigenvalue};
    // (m_k(n+1) - m_k(n))/dt - L m_k, L at the end, is a rate at the start of the step.
    if constexpr (controlled && !physical) {
      HourglassModes<T> rates = hourglass_rates(m, u, L);
      // A control that remembers has its memory turned with the element.
      if constexpr (!std::is_empty_v<typename Control<M>::template State<T>>)
        for (Vector3<T>& rate_k : rates) rate_k = turn(rate_k);
      Q = control.resistance(state.hourglass, element, rates);
      response.hourglass_work = control.work(element, Q, rates);
      hourglass_rate = control.critical_rate(element);
    }

    const T q = bulk_viscosity.pressure(before.wave(), crossing_time, theta);
    response.bulk_viscosity_work = bulk_viscosity.work(state.viscosity, q, dV);
    heat(state.material, response.bulk_viscosity_work * state.inverse_volume);

    [[maybe_unused]] const auto meter = flow_meter<physical>(material, state.material, rate, before.shear, dt);
    auto [sigma, work] = advance_point(material, state.material, rate, dt, V, dV);
    response.internal_work = work;
    if constexpr (physical) {
      const HourglassModes<T> rates = hourglass_rates(m, u, L);
      const PointFlow<T> flow = meter(state.material, sigma, before.shear);
      const auto answer = control.advance(state.hourglass, element, m, u, rates, turn(rates[3]), hourglass_overlap,
                                          flow, detail::Yield<M, T>(material, state.material, rate, before.shear));
      Q = answer.resistance, response.hourglass_work = answer.work, hourglass_rate = answer.critical_rate;
      if constexpr (requires { material.flow(state.material, V, V, V); }) {
        const SymmetricTensor<T> returned = (1.0 - answer.kept) * flow.deviator;
        sigma = sigma - returned;
        response.internal_work -= 0.5 * dt * V * double_dot(returned, rate.rate_of_deformation);
        material.flow(state.material, answer.kept, answer.plastic_increment, answer.flow_stress);
      }
    }
    sigma += SymmetricTensor<T>::isotropic(-q);

    const Moduli<T> after = material.moduli(state.material, rate);
    const T zeta = bulk_viscosity.coefficient(after.wave(), stability.crossing_time(after.wave()), theta);
    const Vibration<T> vibration = stability.vibration(material, after, zeta);
    *sources = {after, zeta, hourglass_rate};
    if constexpr (controlled)
      response.critical_rate = critical_rate(vibration, hourglass_rate, hourglass_overlap);
    else
      response.critical_rate = vibration.critical_rate();

    if constexpr (controlled)
      response.force = nodal_forces(sigma, Q, m, g, per_volume);
    else
      response.force = to_nodes(g.forces_of(sigma.matrix()));
    if constexpr (requires { material.intact(state.material); })
      zero_if_failed(material.intact(state.material) > 0.0, response);
    return response;
  }

  /// The critical rate where corners are merged, so that the mass of a node is not that of its corners, of an element
  /// at the volume V whose last step told its sources.
  template <class M, class T>
  T merged_rate(const State<M, T>& state, const M& material, const MergedGradient<T>& merged, const T& V,
                const VibrationSources<T>& sources) const {
    const Stability<T> stability{merged.trace, merged.eigenvalue,
                                 (1.0 / density_of(material)) * (V * state.inverse_volume)};
    const Vibration<T> vibration = stability.vibration(material, sources.moduli, sources.zeta);
    if constexpr (controlled)
      return critical_rate(vibration, T(merged.hourglass_factor * sources.hourglass_rate), merged.overlap);
    else
      return vibration.critical_rate();
  }

  template <class T>
  using Resistance = Hex8Resistance<T, Hourglass>;

  /// Resistance to a small motion in a step dt from here; v are the velocities of the nodes.
  template <class M, class T>
  Resistance<T> resistance(const State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                           double dt) const {
    const Hex8Modes<T> m = to_modes<T>(x);
    const Hex8Gradient<T> g(m);
    const T J = g.volume * state.inverse_volume, per_volume = 1.0 / g.volume;
    const Hex8Modes<T> u = to_modes<T>(v);
    const Matrix3<T> L = g.gradient_of(u, per_volume);
    const SolidKinematics::Rate<T> rate{symmetric_part(L), J};
    const Moduli<T> moduli = material.moduli(state.material, rate);
    const SymmetricTensor<T> S = T(1.0 / 512.0) * per_volume * per_volume * (g.squared_a() + g.squared_b());
    const Stability<T> stability{trace(S), largest_eigenvalue(S), (1.0 / density_of(material)) * J};
    const T zeta = bulk_viscosity.coefficient(moduli.wave(), stability.crossing_time(moduli.wave()),
                                              trace(rate.rate_of_deformation));
    Resistance<T> resistance =
        Resistance<T>::in_step(material, moduli, zeta, T(0.125 * density_of(material) / state.inverse_volume), dt);
    if constexpr (controlled) {
      const T rho = density_of(material) / J;
      const HourglassElement<T> element{.density = rho,
                                        .volume = g.volume,
                                        .edge = cbrt(g.volume),
                                        .per_mass = per_volume / rho,
                                        .wave_modulus = moduli.wave(),
                                        .shear_modulus = solid_shear(state.material, moduli.shear),
                                        .dt = T(dt),
                                        .gradient = S,
                                        .gradient_squared = stability.trace,
                                        .gradient_eigenvalue = stability.eigenvalue};
      T rate_alone;
      if constexpr (std::same_as<Hourglass, PhysicalHourglass>) {
        const HourglassModes<T> rates = hourglass_rates(m, u, L);
        rate_alone = ViscousHourglass::critical_rate(element, hourglass.damping(element, rates, T(0.0), T(0.0)));
        resistance.stresses = hourglass.resistance(element, m);
      } else {
        rate_alone = hourglass.critical_rate(element);
      }
      const T r = dt * rate_alone;
      constexpr bool stiff = detail::answers<detail::ControlStiffness, const Hourglass, const HourglassElement<T>>;
      const T viscous = max(r, T(r * r)), solid = stiff ? T(r * r) : viscous;
      resistance.hourglass = T(1.0 / 64.0) * rho * g.volume * select(element.shear_modulus > 0.0, solid, viscous);
    }
    resistance *= intact_share<T>(material, state.material);
    return resistance;
  }

 private:
  /// tr(P gamma gamma^T)/8 of the hourglass vectors gamma_k = Lambda_k - b.m_k; P projects onto the gradient b = B/V:
  /// |P gamma_k|^2 = m_k.S m_k - m_k.g_k/(4 V) + g_k.S^-1 g_k/(8 V)^2, S = B B^T/V^2. The argument S is S V^2/V0^2.
  template <class T>
  static T overlap(const SymmetricTensor<T>& S, const SymmetricTensor<T>& S_b, const T& shrinkage,
                   const Hex8Modes<T>& m, const Hex8Gradient<T>& g, const T& per_volume) {
    const SymmetricTensor<T> mm = outer_square(m.b1) + outer_square(m.b2) + outer_square(m.b3) + outer_square(m.d);
    const T mg = dot(m.b1, g.b1) + dot(m.b2, g.b2) + dot(m.b3, g.b3);
    return max(T(0.0),
               0.125 * shrinkage * double_dot(S, mm) - T(1.0 / 32.0) * per_volume * mg + double_dot(inverse(S), S_b));
  }

  static constexpr bool controlled = !std::same_as<Hourglass, NoHourglass>;

  template <class M>
  const Control<M>& control_with() const {
    if constexpr (std::same_as<Control<M>, Hourglass>) {
      return hourglass;
    } else {
      static constexpr ViscousHourglass viscous;
      return viscous;
    }
  }

  /// The shear modulus on which a control may count: none of a solid that has become a fluid.
  template <class State, class T>
  static T solid_shear(const State& state, const T& G) {
    if constexpr (requires { state.solid; })
      return select(state.solid > 0.0, G, T(0.0));
    else
      return (void)state, G;
  }

  /// The state before the step as a control must know it that flows with its material.
  template <bool physical, class M, class State, class T>
  static auto flow_meter(const M& material, const State& state, const SolidKinematics::Rate<T>& rate, const T& G,
                         double dt) {
    if constexpr (physical)
      return detail::FlowMeter<M, T>(material, state, rate, G, dt);
    else
      return (void)material, (void)state, (void)rate, (void)G, (void)dt, 0;
  }
};

Hex8() -> Hex8<>;
template <class H>
Hex8(H) -> Hex8<H>;
template <class H, class R>
Hex8(H, R) -> Hex8<H, R>;
template <class H, class R, class V>
Hex8(H, R, V) -> Hex8<H, R, V>;
template <class H, class R, class V, class I>
Hex8(H, R, V, I) -> Hex8<H, R, V, I>;

}  // namespace strike
