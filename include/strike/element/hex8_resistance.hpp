#pragma once
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <strike/element/hex8_modes.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/element/physical_hourglass.hpp>

namespace strike {

/// Resistance of a hexahedron with one point to a small motion p of its nodes in a step dt: the forces
/// (K dt^2/4 + C dt/2) p of its stiffness K and its damping C, in the letters of Hex8. A stable step keeps their
/// largest eigenvalue over the mass at or below 1.
template <class T, class Control = NoHourglass>
struct Hex8Resistance {
  static constexpr bool physical = std::same_as<Control, PhysicalHourglass>;
  struct Nothing {};

  T mass{};                          ///< of each node
  T lambda{}, shear{}, hourglass{};  ///< stress = lambda tr(grad p) I + 2 shear sym(grad p); Q_k = hourglass q_k
  [[no_unique_address]] std::conditional_t<physical, PhysicalHourglass::Resistance<T>, Nothing> stresses{};

  /// Resistance with these moduli and a bulk viscosity of the coefficient zeta [stress time], which Stability bounds.
  template <class M>
  static Hex8Resistance in_step(const M& material, const Moduli<T>& moduli, const T& zeta, const T& mass, double dt) {
    const T lambda = max(T(0.0), moduli.bulk - T(2.0 / 3.0) * moduli.shear);
    const double k = 0.25 * dt * dt, c = 0.5 * dt;
    Hex8Resistance resistance{mass, k * lambda + c * zeta, k * moduli.shear};
    if constexpr (requires { material.viscosity(); }) resistance.shear += c * material.viscosity();
    return resistance;
  }
  Hex8Resistance& operator*=(const T& share) {
    lambda *= share, shear *= share, hourglass *= share;
    if constexpr (physical) stresses *= share;
    return *this;
  }

  Nodal<T, 8> operator()(const Nodal<T, 8>& x, const Nodal<T, 8>& p) const {
    const Hex8Modes<T> m = to_modes<T>(x), u = to_modes<T>(p);
    const Hex8Gradient<T> g(m);
    const T per_volume = 1.0 / g.volume;
    const Matrix3<T> L = g.gradient_of(u, per_volume);
    const HourglassModes<T> q{minus_times(u.b1, L, m.b1), minus_times(u.b2, L, m.b2), minus_times(u.b3, L, m.b3),
                              minus_times(u.d, L, m.d)};
    HourglassModes<T> Q{hourglass * q[0], hourglass * q[1], hourglass * q[2], hourglass * q[3]};
    if constexpr (physical) {
      const SymmetricTensor<T> S = T(1.0 / 512.0) * per_volume * per_volume * (g.squared_a() + g.squared_b());
      const HourglassModes<T> of_stresses = stresses(m, g.volume, S, q);
      for (std::size_t k = 0; k < 4; ++k) Q[k] = Q[k] + of_stresses[k];
    }
    const SymmetricTensor<T> sigma =
        SymmetricTensor<T>::isotropic(lambda * L.trace()) + T(2.0 * shear) * symmetric_part(L);
    return nodal_forces(sigma, Q, m, g, per_volume);
  }
};

}  // namespace strike
