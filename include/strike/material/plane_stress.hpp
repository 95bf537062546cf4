#pragma once
#include <concepts>
#include <limits>
#include <string>

#include <strike/material/elastic.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>

namespace strike {

namespace detail {

/// The solids whose elasticity is linear and isotropic, as a Solid.
template <class S>
struct LinearSolid {
  static constexpr bool is = false;
  using Parts = Solid<LinearEos, ElasticStrength>;
};
template <>
struct LinearSolid<Elastic> {
  static constexpr bool is = true;
  using Parts = Solid<LinearEos, ElasticStrength>;
  static Parts parts(const Elastic& elastic) {
    return {{elastic.density(), elastic.bulk_modulus()}, {elastic.shear_modulus()}};
  }
};
template <class Law, class Failure>
requires(FlowLaw<Law> || std::same_as<Law, ElasticStrength>) struct LinearSolid<Solid<LinearEos, Law, Failure>> {
  static constexpr bool is = true;
  using Parts = Solid<LinearEos, Law, Failure>;
  static const Parts& parts(const Parts& solid) { return solid; }
};

/// What is left of a plane trial stress, of its shear and of its mean, after the plastic increment.
template <class T>
struct PlaneReturn {
  T shear, mean, plastic_increment;
};

/// The return of PlaneStress: m and d are the shares of the mean and of the shear in the square of the trial q.
template <FlowLaw S, class State, class T>
PlaneReturn<T> plane_return(const S& law, const State& state, const T& m, const T& d, double kappa, double dt) {
  using D = Dual<T, 1>;
  using Real = RealOf<T>;
  constexpr double epsilon = std::numeric_limits<Real>::epsilon();
  constexpr double least = sizeof(Real) == 4 ? 5e-26 : 8e-206;  // the derivative of its root is a number too
  const double G3 = 3.0 * law.shear_modulus;
  const T& e = state.equivalent_plastic_strain;
  if constexpr (RateIndependentFlow<S> && requires { law.plastic_increment(m, e, dt); }) {
    // p [kappa + (1 - kappa) t(Q(p))] = 1 with t = 1 - 3 G dl/Q, for 1 <= p <= 1/kappa. With linear hardening f is
    // convex and falls, so that Newton's steps go up to the root and never past it.
    T p = T(1.0), lower = T(1.0), upper = T(1.0 / kappa);
    PlaneReturn<T> left{T(1.0), T(1.0), T(0.0)};
    for (int i = 0; i < 50; ++i) {
      const D P = D::variable(p, 0), Q2 = max(D(least), d + m * P * P), per_Q = rsqrt(Q2);
      const D dl = law.plastic_increment(D(Q2 * per_Q), D(e), dt);
      if (i == 0 && !any(dl.value() > 0.0)) break;
      const D t = 1.0 - G3 * dl * per_Q, f = (1.0 - kappa * P) - (1.0 - kappa) * P * t;
      lower = select(f.value() >= 0.0, p, lower);
      upper = select(f.value() >= 0.0, upper, p);
      const T newton = p - f.value() / f.derivative(0);
      const T next = select(newton >= lower && newton <= upper, newton, 0.5 * (lower + upper));
      const T step = next - p;
      p = next;
      const T t_next = t.value() + t.derivative(0) * step;
      left = {t_next, t_next * next, dl.value() + dl.derivative(0) * step};
      if (!any(step * step > epsilon)) break;
    }
    return left;
  } else {
    const T Q2 = max(T(least), d + m), Q = Q2 * rsqrt(Q2);
    const T excess = Q - flow_stress<S, T>(law, state, e, T(0.0));
    const auto yields = excess > 0.0;
    if (!(dt > 0) || !any(yields)) return {T(1.0), T(1.0), T(0.0)};
    // In x = 1 - t = 3 G dl/Q.
    const auto trial = [&](const auto& x) {
      using U = std::decay_t<decltype(x)>;
      const U p = 1.0 / (1.0 - (1.0 - kappa) * x);
      return U(sqrt(max(U(least), d + m * p * p)));
    };
    const auto residual = [&](const D& x) -> D {
      const D Q_x = trial(x), dl = (1.0 / G3) * Q_x * x;
      return Q_x - Q_x * x - flow_stress<S, D>(law, state, e + dl, (1.0 / dt) * dl);
    };
    T x = falling_root<T>(residual, select(yields, T(excess / Q), T(0.5)), yields, T(32.0 * epsilon) * Q);
    x = select(yields, x, T(0.0));
    return {1.0 - x, (1.0 - x) / (1.0 - (1.0 - kappa) * x), (1.0 / G3) * trial(x) * x};
  }
}

}  // namespace detail

/// Plane stress of a linear-elastic solid in closed form: Hooke's law with E/(1 - nu^2), and the return to von Mises'
/// ellipse of Simo and Taylor (1986) in the basis in which both are diagonal, s = sxx + syy, r = sxx - syy, sxy:
///   q^2 = s^2/4 + 3/4 r^2 + 3 sxy^2
///   s = s_trial/(1 + kappa z),  r = r_trial/(1 + z),  z = 3 G dl/q,  kappa = E/(6 G (1 - nu)) = 3 K/(3 K + 4 G)
/// With t = 1/(1 + z) and p = (1 + z)/(1 + kappa z) this is r = t r_trial, s = t p s_trial, q = t Q with
///   Q^2 = s_trial^2/4 p^2 + 3/4 r_trial^2 + 3 sxy_trial^2,    q = Q - 3 G dl,    1/p = kappa + (1 - kappa) t
/// so that for a given p the increment is that of the radial return of a solid whose trial stress is Q.
///   PlaneStress aluminium{Solid{LinearEos{...}, VonMises{...}}};
/// Volume changes by elasticity alone, and in so far as it is small: for other equations of state see ZeroNormalStress.
template <class S>
struct PlaneStress {
  static constexpr bool is_linear = detail::LinearSolid<S>::is, sound = is_linear;
  static_assert(is_linear || detail::is_reported<S>(),
                "strike: PlaneStress is for Elastic and for a Solid of LinearEos and a flow law or ElasticStrength: "
                "write ZeroNormalStress for any other solid.");

  S solid;

  using Kinematics = PlaneStressKinematics;
  using Parts = typename detail::LinearSolid<S>::Parts;
  using Law = decltype(Parts::strength);
  using Failure = decltype(Parts::failure);

  template <class T>
  struct State : StrengthState<Law, T>, Failure::template State<T> {
    PlaneTensor<T> stress{};
  };

  double density() const { return solid.density(); }

  /// What the user should know, if anything.
  std::string notice() const requires requires(S s) { s.notice(); }
  { return solid.notice(); }

  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    const Parts& parts = detail::LinearSolid<S>::parts(solid);
    const double G = parts.strength.shear_modulus, kappa = mean_factor(parts);
    const PlaneTensor<T> d = T(dt) * felt(state, rate.rate_of_deformation);
    const PlaneTensor<T>& old = state.stress;
    T s = trace(old) + (6.0 * G * kappa) * trace(d), r = old.xx - old.yy + (2.0 * G) * (d.xx - d.yy);
    T xy = old.xy + (2.0 * G) * d.xy;
    [[maybe_unused]] T dl = T(0.0);
    if constexpr (FlowLaw<Law>) {
      const T m = 0.25 * s * s, shear = 0.75 * r * r + 3.0 * xy * xy;
      const auto left = detail::plane_return(parts.strength, state, m, shear, kappa, dt);
      s = left.mean * s, r = left.shear * r, xy = left.shear * xy;
      dl = left.plastic_increment;
      state.equivalent_plastic_strain += dl;
    }
    state.stress = {0.5 * (s + r), 0.5 * (s - r), xy};
    if constexpr (ThermalFlow<Law>)
      state.temperature_rise += parts.strength.heating * equivalent_stress(state.stress) * dl;
    if constexpr (requires { state.intact; }) {
      state.intact = select(parts.failure.fails(equivalent_stress(state.stress), state), T(0.0), state.intact);
      state.stress = select(state.intact > 0.0, state.stress, PlaneTensor<T>{});
    }
    return state.stress;
  }

  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }

  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>&) const {
    const Parts& parts = detail::LinearSolid<S>::parts(solid);
    const double G = parts.strength.shear_modulus;
    return {T(G * (1 + 3 * mean_factor(parts))), T(G)};
  }

  /// d_zz of the step: tr(stress)/(3 K) is the volume strain, whatever has flowed.
  template <class T>
  T normal_rate(const State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt,
                const PlaneTensor<T>& change) const {
    const double K3 = 3 * detail::LinearSolid<S>::parts(solid).eos.bulk_modulus;
    return (1 / (K3 * dt)) * trace(change) - trace(felt(state, rate.rate_of_deformation));
  }

  template <class T>
  requires requires(State<T> state) { state.intact; }
  T intact(const State<T>& state) const { return state.intact; }

 private:
  /// kappa.
  static double mean_factor(const Parts& parts) {
    const double K3 = 3 * parts.eos.bulk_modulus;
    return K3 / (K3 + 4 * parts.strength.shear_modulus);
  }

  /// What has failed feels no motion, however wild.
  template <class T>
  static PlaneTensor<T> felt(const State<T>& state, const PlaneTensor<T>& D) {
    if constexpr (requires { state.intact; })
      return select(state.intact > 0.0, D, PlaneTensor<T>{});
    else
      return (void)state, D;
  }
};

template <class S>
PlaneStress(S) -> PlaneStress<S>;

}  // namespace strike
