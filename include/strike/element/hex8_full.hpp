#pragma once
#include <array>
#include <cstddef>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/hex8_points.hpp>
#include <strike/element/hex8_resistance.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/tensor/rotation.hpp>

namespace strike {

/// The eight-node hexahedron with 2 x 2 x 2 points, selectively reduced so that it does not lock (Hughes 1980): the
/// change of volume is the mean over the element, the change of shape that of each point. It has no hourglass modes to
/// control: a reference for the price of Hex8's control. Policies: rotation of the tensors, bulk viscosity, and the
/// instant of the step at which the motion is measured.
///   Hex8Full{}   Hex8Full{Jaumann{}, NoBulkViscosity{}}
template <class Spin = HughesWinget, class Viscosity = BulkViscosity, class Instant = MidStep>
struct Hex8Full {
  static constexpr bool has_rotation = Rotation<Spin>, has_viscosity = has_rotation && ShockViscosity<Viscosity>,
                        sound = has_viscosity && MeasuringInstant<Instant>;
  static_assert(has_rotation,
                "strike: the first policy of Hex8Full is the rotation of its tensors: HughesWinget or Jaumann.");
  static_assert(!has_rotation || has_viscosity,
                "strike: the second policy of Hex8Full is its bulk viscosity: BulkViscosity, "
                "BulkViscosityBothWays or NoBulkViscosity.");
  static_assert(!has_viscosity || sound,
                "strike: the third policy of Hex8Full is the instant at which it measures: MidStep or EndStep.");

  [[no_unique_address]] Spin rotation{};
  [[no_unique_address]] Viscosity bulk_viscosity{};
  [[no_unique_address]] Instant instant{};

  void ranges(const auto& number) const { number(rotation), number(bulk_viscosity), number(instant); }

  using Kinematics = SolidKinematics;
  static constexpr int nodes = 8;
  static constexpr CellShape shape = CellShape::hexahedron;
  static constexpr std::size_t points = 8;

  template <class M, class T>
  struct State {
    T inverse_volume{};  ///< 1/V0
    [[no_unique_address]] typename Viscosity::template State<T> viscosity{};
    std::array<typename M::template State<T>, points> material{};

    template <class F>
    void each_point(F f) const {
      for (const auto& point : material) f(point);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 8>& x) const {
    for (auto& point : state.material) begin_point(material, point, x);
    const T V = Hex8Gradient<T>(to_modes<T>(x)).volume;
    state.inverse_volume = 1.0 / V;
    return (0.125 * density_of(material)) * V;
  }

  template <class M, class T>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                         double dt) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(v);
    const Hex8Gradient<T> g(m);
    const T& V = g.volume;
    const T J = V * state.inverse_volume, compression = 1.0 / J;
    const T per_volume = compression * state.inverse_volume;  // 1/V
    const T theta = instant(g.gradient_of(u, per_volume), dt).trace();
    const T dV = volume_increment<T>(V, dt * theta);

    Hex8Laplacian<T> laplacian;
    Moduli<T> before{T(0.0), T(0.0)}, after = before;
    T least_volume = V, intact_volume = T(0.0);
    const auto measure = [&](std::size_t i, Measure<T>& measured) {
      auto& [map, rate, spin, dV_g] = measured;
      const Hex8Point point(i);
      map = Hex8Map<T>(point.derivatives(m));
      const T intact = intact_share<T>(material, state.material[i]);
      const T inverse = select(intact > 0.0, 1.0 / map.volume, T(0.0));
      const Matrix3<T> L = instant(map.gradient(point.derivatives(u), inverse), dt);
      spin = T(dt) * axial_vector(L);
      const SymmetricTensor<T> D = instant.to_end(spin)(symmetric_part(L));
      rate = {D + SymmetricTensor<T>::isotropic((1.0 / 3.0) * (theta - trace(D))), J};
      dV_g = volume_increment<T>(map.volume, dt * trace(D));

      laplacian.add(point, map, inverse);
      before = larger(before, material.moduli(state.material[i], rate));
      least_volume = select(intact > 0.0 && !(map.volume > least_volume), map.volume, least_volume);
      intact_volume += select(intact > 0.0, map.volume, T(0.0));
    };

    Response<T, 8> response;
    response.internal_work = response.hourglass_work = T(0.0);
    // f_I = sum of the points' V_g s_g grad N_I, and the mean pressure on the mean gradient.
    const Vector3<T> zero = Vector3<T>::Zero();
    Hex8Modes<T> F{zero, zero, zero, zero, zero, zero, zero};
    T tension = T(0.0), intact = T(0.0);
    const auto advance = [&](std::size_t i, const Measure<T>& measured) {
      const auto& [map, rate, spin, dV_g] = measured;
      auto& point_state = state.material[i];
      turn_tensors(rotation.turn(spin), point_state);
      const auto [sigma, work] = advance_point(material, point_state, rate, dt, map.volume, dV_g);
      response.internal_work += work;
      tension += (1.0 / 3.0) * map.volume * trace(sigma);
      Hex8Point(i).add_forces<T>(deviator(sigma).matrix().lazyProduct(map.cofactors), F);
      after = larger(after, material.moduli(point_state, rate));
      intact = max(intact, intact_share<T>(material, point_state));
    };

    // In a material with an internal energy the points advance after the heat, which follows from all their measures.
    constexpr bool heated = requires { state.material[0].internal_energy; };
    std::array<Measure<T>, heated ? points : 0> measures;
    for (std::size_t i = 0; i < points; ++i)
      if constexpr (heated) {
        measure(i, measures[i]);
      } else {
        Measure<T> measured;
        measure(i, measured);
        advance(i, measured);
      }

    const Stability<T> stability = this->stability(material, g, laplacian, per_volume, J);
    T q = bulk_viscosity.pressure(before.wave(), stability.crossing_time(before.wave()), theta);
    if constexpr (requires { material.intact(state.material[0]); })
      q = select(intact_volume > 0.0, q * (intact_volume * per_volume), T(0.0));
    response.bulk_viscosity_work = bulk_viscosity.work(state.viscosity, q, dV);
    if constexpr (heated)
      for (std::size_t i = 0; i < points; ++i) {
        heat(state.material[i], response.bulk_viscosity_work * state.inverse_volume);
        advance(i, measures[i]);
      }

    g.add_forces_of(T(tension * per_volume - q), F);
    response.force = to_nodes(F);

    response.volume = select(least_volume > 0.0, V, least_volume);
    const Moduli<T> moduli = larger(before, after);
    const T zeta = bulk_viscosity.coefficient(moduli.wave(), stability.crossing_time(moduli.wave()), theta);
    response.critical_rate = stability.vibration(material, moduli, zeta).critical_rate();
    if constexpr (requires { material.intact(state.material[0]); }) zero_if_failed(intact > 0.0, response);
    return response;
  }

  template <class T>
  using Resistance = Hex8FullResistance<T>;

  /// Resistance to a small motion in a step dt from here, with the stiffest of its points everywhere; v are the
  /// velocities of the nodes.
  template <class M, class T>
  Resistance<T> resistance(const State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                           double dt) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(v);
    const Hex8Gradient<T> g(m);
    const T J = g.volume * state.inverse_volume, per_volume = 1.0 / g.volume;
    const T theta = g.gradient_of(u, per_volume).trace();
    Moduli<T> moduli{T(0.0), T(0.0)};
    Hex8Laplacian<T> laplacian;
    T intact = T(0.0);
    for (std::size_t i = 0; i < points; ++i) {
      const Hex8Point point(i);
      const Hex8Map<T> map(point.derivatives(m));
      const T share = intact_share<T>(material, state.material[i]);
      const T inverse = select(share > 0.0, 1.0 / map.volume, T(0.0));
      const SymmetricTensor<T> D = symmetric_part(map.gradient(point.derivatives(u), inverse));
      const SolidKinematics::Rate<T> rate{D + SymmetricTensor<T>::isotropic((1.0 / 3.0) * (theta - trace(D))), J};
      moduli = larger(moduli, material.moduli(state.material[i], rate));
      laplacian.add(point, map, inverse);
      intact = max(intact, share);
    }
    const Stability<T> stability = this->stability(material, g, laplacian, per_volume, J);
    const T zeta = bulk_viscosity.coefficient(moduli.wave(), stability.crossing_time(moduli.wave()), theta);
    Resistance<T> resistance =
        Resistance<T>::in_step(material, moduli, zeta, T(0.125 * density_of(material) / state.inverse_volume), dt);
    resistance *= intact;
    return resistance;
  }

 private:
  /// The measure of a step at a point.
  template <class T>
  struct Measure {
    Hex8Map<T> map;
    SolidKinematics::Rate<T> rate;
    Vector3<T> spin;
    T dV;
  };

  template <class M, class T>
  static Stability<T> stability(const M& material, const Hex8Gradient<T>& g, const Hex8Laplacian<T>& laplacian,
                                const T& per_volume, const T& J) {
    const T S = T(1.0 / 512.0) * per_volume * per_volume * trace(g.squared_a() + g.squared_b());
    return {S, per_volume * laplacian.largest_eigenvalue(), (1.0 / density_of(material)) * J};
  }
  template <class T>
  static Moduli<T> larger(const Moduli<T>& a, const Moduli<T>& b) {
    return {max(a.bulk, b.bulk), max(a.shear, b.shear)};
  }
};

Hex8Full() -> Hex8Full<>;
template <class R>
Hex8Full(R) -> Hex8Full<R>;
template <class R, class V>
Hex8Full(R, V) -> Hex8Full<R, V>;
template <class R, class V, class I>
Hex8Full(R, V, I) -> Hex8Full<R, V, I>;

}  // namespace strike
