#pragma once
#include <concepts>
#include <limits>
#include <type_traits>

#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// A strength: how a solid resists a change of shape. The pressure is that of its equation of state.
///
/// Requirements
/// 1. `shear_modulus` [stress]: the stiffest that it answers with, unless it has `stiffness`.
/// 2. One of these formulas, a template over the number T:
///    a. a flow law of isotropic plasticity (von Mises), `flow_stress(e)`, `flow_stress(e, rate)`, or
///       `flow_stress(e, rate, temperature)` with the members `initial_temperature` and `heating`, the rise of the
///       temperature per plastic work [temperature volume/energy]; e is the equivalent plastic strain;
///    b. `deviatoric_stress(s, d)`: the new deviator from the old one, already turned, and the increment d of the
///       deviatoric strain;
///    c. `deviatoric_stress(state, s, d, J, dt)` with a `State<T>` of its own; J = V/V0.
/// Optional
/// 3. `plastic_increment(q, e, dt)` of a flow law: its increment of plastic strain in closed form, or a better way to
///    it; q is the equivalent of the trial stress.
///    Or `flow_curve(e, dt)`, with a temperature T `flow_curve(e, T, dt)`: its flow stress as a series in the increment
///    (strike/material/strength/flow_curve.hpp), which takes less time than dual numbers.
/// 4. `stiffness(state, J)`: a bound of the tangent's shear modulus, where it may exceed `shear_modulus`.
/// 5. `State::spatial_tensors()`: a tuple of references to what the element turns.
/// 6. `warning()`: a text for the user, empty if there is nothing to say.
/// 7. `ranges(number)`: what its numbers may be (strike/range.hpp).
/// 8. Of a strength with memory whose state has an `equivalent_plastic_strain`: `yield_radius(state)`, the flow stress
///    by which PhysicalHourglass yields.
/// Laws: the flow stress is not negative and does not fall with the rate; the stress does no negative plastic work.
/// Models: VonMises, RateVonMises, PowerHardening, TabulatedHardening, TabulatedRates, CowperSymonds, JohnsonCook,
/// ZerilliArmstrong, Sensitive (a); ElasticStrength (b); KinematicHardening, Prony, MooneyRivlin (c).
template <class S, class T = double>
concept RateIndependentFlow = requires(const S law, const T x) {
  { law.shear_modulus } -> std::convertible_to<double>;
  { law.flow_stress(x) } -> std::convertible_to<T>;
};
template <class S, class T = double>
concept RateDependentFlow = requires(const S law, const T x) {
  { law.shear_modulus } -> std::convertible_to<double>;
  { law.flow_stress(x, x) } -> std::convertible_to<T>;
};
template <class S, class T = double>
concept ThermalFlow = requires(const S law, const T x) {
  { law.shear_modulus } -> std::convertible_to<double>;
  { law.flow_stress(x, x, x) } -> std::convertible_to<T>;
  { law.heating } -> std::convertible_to<double>;
  { law.initial_temperature } -> std::convertible_to<double>;
};
template <class S, class T = double>
concept FlowLaw = RateIndependentFlow<S, T> || RateDependentFlow<S, T> || ThermalFlow<S, T>;
template <class S, class T = double>
concept StrengthWithMemory =
    requires(const S strength, typename S::template State<T> state, const SymmetricTensor<T> s, const T J) {
      { strength.shear_modulus } -> std::convertible_to<double>;
      { strength.deviatoric_stress(state, s, s, J, 1.0) } -> std::same_as<SymmetricTensor<T>>;
    };
template <class S, class T = double>
concept Strength = FlowLaw<S, T> || StrengthWithMemory<S, T> || requires(const S strength, const SymmetricTensor<T> s) {
  { strength.shear_modulus } -> std::convertible_to<double>;
  { strength.deviatoric_stress(s, s) } -> std::same_as<SymmetricTensor<T>>;
};

/// Hooke's law for the deviator, without plasticity.
struct ElasticStrength {
  double shear_modulus;  ///< G [stress]

  void ranges(const auto& number) const { number("shear_modulus", shear_modulus, range::not_negative); }

  template <class T>
  SymmetricTensor<T> deviatoric_stress(const SymmetricTensor<T>& s, const SymmetricTensor<T>& d) const {
    return s + T(2.0 * shear_modulus) * d;
  }
};

namespace detail {

struct NoPlasticity {
  template <class T>
  struct State {};
};
struct Plasticity {
  template <class T>
  struct State {
    T equivalent_plastic_strain{};
  };
};
struct ThermalPlasticity {
  template <class T>
  struct State {
    T equivalent_plastic_strain{};
    T temperature_rise{};  ///< [temperature]
  };
};
template <class S>
struct OwnMemory {
  template <class T>
  using State = typename S::template State<T>;
};
template <class S>
constexpr auto strength_memory() {
  if constexpr (ThermalFlow<S>)
    return ThermalPlasticity{};
  else if constexpr (FlowLaw<S>)
    return Plasticity{};
  else if constexpr (StrengthWithMemory<S>)
    return OwnMemory<S>{};
  else
    return NoPlasticity{};
}

/// A strength with memory that tells the radius of its yield surface.
template <class S>
concept HasYieldRadius = requires(const S law, const typename S::template State<double> state) {
  { law.yield_radius(state) } -> std::convertible_to<double>;
};

/// The root of a falling f in (0, 1) from the guess x, by Newton's steps in ln x inside a bracket: with power laws and
/// logarithms the root ranges over many decades. `active` marks the lanes that count, each of which keeps its root when
/// it has found it; f takes and gives Dual<T, 1>; `tolerance` is in the units of f. The last step is always Newton's:
/// it gives a dual root the derivatives of the implicit function.
template <class T, class F, class M>
T falling_root(F f, T x, const M& active, const T& tolerance) {
  T lower = T(0.0), upper = T(1.0), root = x;
  M open = active;
  for (int i = 0; i < 100 && any(open); ++i) {
    x = constant(x);
    const Dual<T, 1> y = f(Dual<T, 1>::variable(x, 0));
    const T newton = x * exp(T(-y.value() / (x * y.derivative(0))));
    const auto found = abs(y.value()) <= tolerance;
    root = select(open && found, newton, root);
    open = open && !found;
    lower = select(y.value() >= 0.0, x, lower);
    upper = select(y.value() >= 0.0, upper, x);
    x = select(newton > lower && newton < upper, newton, 0.5 * (lower + upper));
  }
  return select(open, x, root);
}

/// The flow stress of a flow law of any kind, at the temperature of the state.
template <FlowLaw S, class U, class State>
U flow_stress(const S& law, const State& state, const U& strain, const U& rate) {
  if constexpr (ThermalFlow<S>)
    return law.flow_stress(strain, rate, U(law.initial_temperature + state.temperature_rise));
  else if constexpr (RateDependentFlow<S>)
    return (void)state, law.flow_stress(strain, rate);
  else
    return (void)state, (void)rate, law.flow_stress(strain);
}

/// A law whose increments are found along its flow curve, for it has no closed form.
template <class S, class T>
concept FoundByCurve = FlowLaw<S> && HasFlowCurve<S, T> &&
                       !(RateIndependentFlow<S> && requires(const S law, T q) { law.plastic_increment(q, q, 1.0); });
template <class T, FlowLaw S, class State>
auto flow_curve(const S& law, const State& state, double dt) {
  const T& e = state.equivalent_plastic_strain;
  if constexpr (ThermalFlow<S>)
    return law.flow_curve(e, T(law.initial_temperature + state.temperature_rise), dt);
  else
    return law.flow_curve(e, dt);
}
/// q is the trial stress, `change` what it has changed by since the step began.
template <FlowLaw S, class State, class T>
T increment_by_curve(const S& law, const State& state, const T& q, const T& change, double dt) {
  if (!(dt > 0)) {
    if constexpr (requires { law.plastic_increment(q, q, dt); })
      return law.plastic_increment(q, state.equivalent_plastic_strain, dt);
    else
      return T(0.0);
  }
  return find_increment(flow_curve<T>(law, state, dt), q, 3.0 * law.shear_modulus, change);
}

}  // namespace detail

/// The memory of a strength besides the stress.
template <Strength S, class T>
using StrengthState = typename decltype(detail::strength_memory<S>())::template State<T>;

/// The equivalent plastic strain that brings the trial equivalent stress q back to the yield surface, implicit in the
/// strain and the rate: q - 3 G dl = flow_stress(e + dl, dl/dt).
template <FlowLaw S, class T>
T plastic_increment(const S& law, const StrengthState<S, T>& state, const T& q, double dt) {
  const T& e = state.equivalent_plastic_strain;
  if constexpr (detail::FoundByCurve<S, T>) {
    return detail::increment_by_curve(law, state, q, q, dt);
  } else if constexpr (requires { law.plastic_increment(q, e, dt); }) {
    return law.plastic_increment(q, e, dt);
  } else {
    const T excess = q - detail::flow_stress<S, T>(law, state, e, T(0.0));
    const auto yields = excess > 0.0;
    if (!(dt > 0) || !any(yields)) return T(0.0);
    const double G3 = 3.0 * law.shear_modulus;
    const T most = q / G3;  // all of the trial stress
    using D = Dual<T, 1>;
    const auto residual = [&](const D& x) -> D {
      return q - q * x - detail::flow_stress<S, D>(law, state, e + most * x, most / dt * x);
    };
    const T rounding = T(32.0 * std::numeric_limits<RealOf<T>>::epsilon()) * q;
    return select(yields,
                  most * detail::falling_root<T>(residual, select(yields, T(excess / q), T(0.5)), yields, rounding),
                  T(0.0));
  }
}

/// The deviator of the stress at the end of a step: elastic trial, then the radial return of Wilkins (1964) and Krieg
/// and Key (1976). s is the old deviator, already turned; d the deviatoric strain increment.
template <Strength S, class State, class T>
SymmetricTensor<T> advance_deviator(const S& law, State& state, const SymmetricTensor<T>& s,
                                    const SymmetricTensor<T>& d, double dt,
                                    [[maybe_unused]] const std::type_identity_t<T>& J = T(1.0)) {
  if constexpr (FlowLaw<S>) {
    const SymmetricTensor<T> trial = s + T(2.0 * law.shear_modulus) * d;
    const T q_squared = max(T(detail::least_square<T>), 1.5 * double_dot(trial, trial));
    const T per_q = rsqrt(q_squared), q = q_squared * per_q;
    T dl;
    if constexpr (detail::FoundByCurve<S, T>) {
      const T before = max(T(detail::least_square<T>), 1.5 * double_dot(s, s));
      dl = detail::increment_by_curve(law, state, q, T(q - before * rsqrt(before)), dt);
    } else {
      dl = plastic_increment<S, T>(law, state, q, dt);
    }
    const T relaxed = 3.0 * law.shear_modulus * dl;
    state.equivalent_plastic_strain += dl;
    if constexpr (ThermalFlow<S>) state.temperature_rise += law.heating * (q - relaxed) * dl;
    return (1.0 - relaxed * per_q) * trial;
  } else if constexpr (StrengthWithMemory<S>) {
    return law.deviatoric_stress(state, s, d, J, dt);
  } else {
    return (void)state, (void)dt, law.deviatoric_stress(s, d);
  }
}

}  // namespace strike
