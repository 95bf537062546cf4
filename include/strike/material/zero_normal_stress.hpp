#pragma once
#include <limits>
#include <string>
#include <type_traits>

#include <strike/material/elastic.hpp>
#include <strike/material/material.hpp>

namespace strike {

namespace detail {
template <class S>
constexpr bool is_solid_material() {
  if constexpr (is_reported<S>())
    return false;
  else
    return SolidMaterial<S>;
}
}  // namespace detail

/// Plane stress of any solid material, whatever its equation of state: iterates the strain across in each step until
/// the stress across is zero to the rounding of the modulus (as X3D, Brockman and Held 1991). A step costs 2 to 6 steps
/// of the solid; PlaneStress is the closed form where there is one. The solid must be able to carry tension, which a
/// gas is not.
///   ZeroNormalStress{Solid{GruneisenEos{...}, VonMises{...}}};
template <class S>
struct ZeroNormalStress {
  static_assert(instantiates(static_cast<detail::Report<S>*>(nullptr)));
  static constexpr bool is_solid = detail::is_solid_material<S>(), sound = is_solid;
  static_assert(is_solid || detail::is_reported<S>(),
                "strike: ZeroNormalStress takes a material of solid elements, such as a Solid or Elastic.");

  S solid;

  void ranges(const auto& number) const { number(solid); }

  using Kinematics = PlaneStressKinematics;
  using Inner = std::conditional_t<is_solid, S, Elastic>;

  template <class T>
  struct State : Inner::template State<T> {
    T relative_volume{1.0};  ///< V/V0
    T normal_rate{};         ///< d_zz of the last step [1/time]

    void spatial_tensors() = delete;  // the frame goes with the plate
  };

  double density() const { return density_of(solid); }

  /// The state at rest.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    if constexpr (requires { solid.begin(inner(state)); }) solid.begin(inner(state));
  }

  /// A text for the user, empty if there is nothing to say.
  std::string warning() const
    requires requires(S s) { s.warning(); }
  {
    return solid.warning();
  }

  /// The root a = d_zz dt of the rising f(a) = sigma_zz, by secants inside a bracket, each from the state before the
  /// step. The first guess is the elastic one, exact without plastic flow.
  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    constexpr double rounding = 8.0 * std::numeric_limits<RealOf<T>>::epsilon();
    const State<T> before = state;
    const PlaneTensor<T> D = detail::rate_if_intact(*this, before, rate).rate_of_deformation;
    SymmetricTensor<T> sigma{};
    const auto trial = [&](const T& a) -> T {
      const T theta = dt * trace(D) + a;
      state = before;
      state.relative_volume = before.relative_volume * ((1.0 + 0.5 * theta) / (1.0 - 0.5 * theta));
      state.normal_rate = (dt > 0 ? 1.0 / dt : 0.0) * a;
      sigma = solid.stress(inner(state), {{D.xx, D.yy, state.normal_rate, D.xy, T(0.0), T(0.0)}, state.relative_volume},
                           dt);
      return sigma.zz;
    };
    const Moduli<T> elastic = solid.moduli(inner(before), {{}, before.relative_volume});
    const T wave = elastic.wave(), in_plane = dt * trace(D);
    T lower = -1.0 - in_plane, upper = 1.0 - in_plane, slope = wave;
    T a = (-1.0 / wave) * (solid.stress(inner(before)).zz + (wave - 2.0 * elastic.shear) * in_plane), f = trial(a);
    for (int i = 0; i < 50; ++i) {
      const auto open = abs(f) > rounding * wave;
      if (!any(open)) break;
      lower = select(f <= 0.0, a, lower);
      upper = select(f >= 0.0, a, upper);
      const T secant = a - f / slope;
      const T next = select(secant > lower && secant < upper, secant, 0.5 * (lower + upper));
      const T a_old = a, f_old = f;
      a = select(open, next, a);
      f = trial(a);
      slope = select(open, (f - f_old) / (a - a_old), slope);
    }
    return plane(sigma);
  }

  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return plane<T>(solid.stress(inner(state)));
  }

  template <class T>
  PlaneModuli<T> moduli(const State<T>& state, const PlaneStressKinematics::Rate<T>&) const {
    const auto [K, G] = solid.moduli(inner(state), {{}, state.relative_volume});
    return {4.0 * G * (3.0 * K + G) / (3.0 * K + 4.0 * G), G};
  }

  /// d_zz of the last step [1/time].
  template <class T>
  T normal_rate(const State<T>& state, const PlaneStressKinematics::Rate<T>&, double, const PlaneTensor<T>&) const {
    return state.normal_rate;
  }

  double viscosity() const
    requires requires(S s) { s.viscosity(); }
  {
    return solid.viscosity();
  }

  /// As of the solid.
  template <class T>
    requires requires(const S s, const typename Inner::template State<T> state, T x) { s.flow_stress(state, x); }
  T flow_stress(const State<T>& state, const T& rate) const {
    return solid.flow_stress(inner(state), rate);
  }
  static constexpr bool flow_is_rate_independent = requires { requires S::flow_is_rate_independent; };
  template <class T>
    requires requires(const S s, typename Inner::template State<T> state, T x) { s.flow(state, x, x, x); }
  void flow(State<T>& state, const T& kept, const T& increment, const T& flow_stress) const {
    solid.flow(inner(state), kept, increment, flow_stress);
  }

  template <class T>
    requires requires(const S s, const typename Inner::template State<T> state) { s.intact(state); }
  T intact(const State<T>& state) const {
    return solid.intact(inner(state));
  }

 private:
  template <class T>
  using Inside = typename Inner::template State<T>;
  template <class T>
  static Inside<T>& inner(State<T>& state) {
    return state;
  }
  template <class T>
  static const Inside<T>& inner(const State<T>& state) {
    return state;
  }
  template <class T>
  static PlaneTensor<T> plane(const SymmetricTensor<T>& a) {
    return {a.xx, a.yy, a.xy};
  }
};

template <class S>
ZeroNormalStress(S) -> ZeroNormalStress<S>;

}  // namespace strike
