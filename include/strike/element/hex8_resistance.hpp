#pragma once
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <strike/element/hex8_modes.hpp>
#include <strike/element/hex8_points.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/element/physical_hourglass.hpp>
#include <strike/element/solid_resistance.hpp>

namespace strike {

/// Resistance of a hexahedron with one point to a small motion p of its nodes in a step dt: the forces
/// (K dt^2/4 + C dt/2) p of its stiffness K and its damping C, in the letters of Hex8. A stable step keeps their
/// largest eigenvalue over the mass at or below 1.
template <class T, class Control = NoHourglass>
struct Hex8Resistance {
  static constexpr bool physical = std::same_as<Control, PhysicalHourglass>;
  struct Nothing {};

  T mass{};  ///< of each node
  SolidResistance<T> mean{};
  T hourglass{};  ///< Q_k = hourglass q_k
  [[no_unique_address]] std::conditional_t<physical, PhysicalHourglass::Resistance<T>, Nothing> stresses{};

  /// Resistance with these moduli, of which lambda counts as Stability takes it, not below 0, and a bulk viscosity of
  /// the coefficient zeta [stress time].
  template <class M>
  static Hex8Resistance in_step(const M& material, const Moduli<T>& moduli, const T& zeta, const T& mass, double dt) {
    const Moduli<T> bound{max(moduli.bulk, T(2.0 / 3.0) * moduli.shear), moduli.shear};
    return {mass, SolidResistance<T>::in_step(material, bound, zeta, dt)};
  }
  Hex8Resistance& operator*=(const T& share) {
    mean *= share, hourglass *= share;
    if constexpr (physical) stresses *= share;
    return *this;
  }

  Nodal<T, 8> operator()(const Nodal<T, 8>& x, const Nodal<T, 8>& p) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(p);
    const Hex8Gradient<T> g(m);
    const T per_volume = 1.0 / g.volume;
    const Matrix3<T> L = g.gradient_of(u, per_volume);
    const HourglassModes<T> q = hourglass_rates(m, u, L);
    HourglassModes<T> Q{hourglass * q[0], hourglass * q[1], hourglass * q[2], hourglass * q[3]};
    if constexpr (physical) {
      const SymmetricTensor<T> S = T(1.0 / 512.0) * per_volume * per_volume * (g.squared_a() + g.squared_b());
      const HourglassModes<T> of_stresses = stresses(m, g.volume, S, q);
      for (std::size_t k = 0; k < 4; ++k) Q[k] = Q[k] + of_stresses[k];
    }
    return nodal_forces(mean.stress(L), Q, m, g, per_volume);
  }
};

/// The same of a hexahedron with eight points: against the mean change of volume, and the change of shape at each
/// point.
template <class T>
struct Hex8FullResistance {
  T mass{};  ///< of each node
  SolidResistance<T> point{};

  template <class M>
  static Hex8FullResistance in_step(const M& material, const Moduli<T>& moduli, const T& zeta, const T& mass,
                                    double dt) {
    return {mass, SolidResistance<T>::in_step(material, moduli, zeta, dt)};
  }
  Hex8FullResistance& operator*=(const T& share) {
    point *= share;
    return *this;
  }

  Nodal<T, 8> operator()(const Nodal<T, 8>& x, const Nodal<T, 8>& p) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(p);
    const Hex8Gradient<T> g(m);
    const Vector3<T> zero = Vector3<T>::Zero();
    Hex8Modes<T> F{zero, zero, zero, zero, zero, zero, zero};
    for (std::size_t i = 0; i < 8; ++i) {
      const Hex8Point at(i);
      const Hex8Map<T> map(at.derivatives(m));
      const Matrix3<T> L = map.gradient(at.derivatives(u), T(1.0 / map.volume));
      const SymmetricTensor<T> S = T(2.0 * point.shear) * deviator(symmetric_part(L));
      at.add_forces<T>(S.matrix().lazyProduct(map.cofactors), F);
    }
    const T theta = g.gradient_of(u, T(1.0 / g.volume)).trace();
    g.add_forces_of(T((point.lambda + T(2.0 / 3.0) * point.shear) * theta), F);
    return to_nodes(F);
  }
};

}  // namespace strike
