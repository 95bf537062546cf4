#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include <strike/material/elastic.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>

namespace strike {

namespace detail {

template <class Failure>
inline constexpr bool leaves_fluid = requires(typename Failure::template State<double> state) { state.solid; };

/// A solid of linear isotropic elasticity, seen as a Solid.
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
    return {{density_of(elastic), elastic.bulk_modulus()}, {elastic.shear_modulus()}};
  }
};
template <class Law, class Failure>
  requires((FlowLaw<Law> || std::same_as<Law, ElasticStrength>) && !leaves_fluid<Failure>)
struct LinearSolid<Solid<LinearEos, Law, Failure>> {
  static constexpr bool is = true;
  using Parts = Solid<LinearEos, Law, Failure>;
  static const Parts& parts(const Parts& solid) { return solid; }
};

/// Return of a point to the yield surface: m and d, the parts of the mean and of the shear in the square of the trial
/// q; the factors of both after the return; and the plastic increment.
template <class T>
struct PlaneReturn {
  T m, d;
  T mean{1.0}, shear{1.0}, plastic_increment{0.0};
};

/// The returns at the n points of a layer by a law's own plastic increment, interleaved, because each is a long chain
/// of dependent operations.
///
/// f = 1 - p [kappa + (1 - kappa) t(Q(p))] = 0 with t = 1 - 3 G dl/Q, for 1 <= p <= 1/kappa, by Householder's steps of
/// fourth order, n [1 - A2 n + (2 A2^2 - A3) n^2] with Newton's n, A2 = f''/(2 f'), A3 = f'''/(6 f'). Hardening is
/// nearly linear in a step, dl'' = 0; then t is linear in 1/Q, and with the share of the mean b = m p^2/Q^2
///   Q' = Q b/p,  Q'' = Q b (1 - b)/p^2,  t' = y b/p,  t'' = y b (1 - 3 b)/p^2,  y = 1 - t - 3 G dl'.
template <FlowLaw S, class State, class T, std::size_t n>
void plane_return_by_increment(const S& law, std::span<const State, n> states, std::array<PlaneReturn<T>, n>& returns,
                               double kappa, double dt) {
  using D = Dual<T, 1>;
  constexpr double epsilon = std::numeric_limits<RealOf<T>>::epsilon();
  const double G3 = 3.0 * law.shear_modulus;
  struct Iterate {
    T p, lower, upper, Q, per_Q;
    D dl;
  };
  std::array<Iterate, n> iterates;
  for (Iterate& at : iterates) at.p = at.lower = T(1.0), at.upper = T(1.0 / kappa);
  bool yields = true;
  for (int i = 0; yields && i < 50; ++i) {
    yields = i > 0;
    for (std::size_t k = 0; k < n; ++k) {
      Iterate& at = iterates[k];
      const T Q2 = max(T(least_square<T>), returns[k].d + returns[k].m * at.p * at.p);
      at.per_Q = rsqrt(Q2), at.Q = Q2 * at.per_Q;
      at.dl = law.plastic_increment(D::variable(at.Q, 0), D(states[k].equivalent_plastic_strain), dt);
      yields |= any(at.dl.value() > 0.0);
    }
    if (!yields) break;
    yields = false;
    for (std::size_t k = 0; k < n; ++k) {
      auto& [m, d, mean, shear, plastic_increment] = returns[k];
      auto& [p, lower, upper, Q, per_Q, dl] = iterates[k];
      const T curvature = m * per_Q * per_Q, slope = curvature * p, b = slope * p;  // Q'/Q = slope
      const T t = 1.0 - G3 * dl.value() * per_Q, y = 1.0 - t - G3 * dl.derivative(0);
      const T f = (1.0 - kappa * p) - (1.0 - kappa) * p * t, per_df = -1.0 / (kappa + (1.0 - kappa) * (t + b * y));
      const T newton = -f * per_df, h = (1.0 - kappa) * (1.0 - b) * y * per_df;  // A2 = -3/2 h slope
      T next = p + newton * (1.0 + newton * h * (1.5 * slope + 0.5 * newton * curvature * (1.0 + b * (9.0 * h - 5.0))));
      if (i > 2) {  // softening: bisect outside the bracket
        lower = select(f >= 0.0, p, lower);
        upper = select(f >= 0.0, upper, p);
        next = select(next >= lower && next <= upper, next, 0.5 * (lower + upper));
      }
      const T step = next - p, bend = 0.5 * step * curvature;
      shear = t + step * y * (slope + bend * ((1.0 - 3.0 * b) - step * slope * (3.0 - 5.0 * b)));
      mean = shear * next;
      plastic_increment =
          dl.value() + dl.derivative(0) * (Q * step * (slope + bend * (1.0 - b) * (1.0 - step * slope)));
      const auto open = step * step * step * step > 16.0 * epsilon;
      p = select(open, next, p);  // a lane that is done repeats its last step, so that it depends on no other
      yields |= any(open);
    }
  }
}

/// The returns at the n points of a layer by the root x = 1 - t = 3 G dl/Q of the flow stress.
template <FlowLaw S, class State, class T, std::size_t n>
void plane_return_by_root(const S& law, std::span<const State, n> states, std::array<PlaneReturn<T>, n>& returns,
                          double kappa, double dt) {
  using D = Dual<T, 1>;
  constexpr double epsilon = std::numeric_limits<RealOf<T>>::epsilon();
  constexpr double least = least_square<T>;
  const double G3 = 3.0 * law.shear_modulus;
  for (std::size_t k = 0; k < n; ++k) {
    auto& [m_, d_, mean, shear, plastic_increment] = returns[k];
    const T &m = m_, &d = d_, &e = states[k].equivalent_plastic_strain;
    const T Q2 = max(T(least), d + m), Q = Q2 * rsqrt(Q2);
    const T excess = Q - flow_stress<S, T>(law, states[k], e, T(0.0));
    const auto yields = excess > 0.0;
    if (!(dt > 0) || !any(yields)) continue;
    const auto trial = [&](const auto& x) {
      using U = std::decay_t<decltype(x)>;
      const U p = 1.0 / (1.0 - (1.0 - kappa) * x);
      return U(sqrt(max(U(least), d + m * p * p)));
    };
    const auto residual = [&](const D& x) -> D {
      const D Q_x = trial(x), dl = (1.0 / G3) * Q_x * x;
      return Q_x - Q_x * x - flow_stress<S, D>(law, states[k], e + dl, (1.0 / dt) * dl);
    };
    T x = falling_root<T>(residual, select(yields, T(excess / Q), T(0.5)), yields, T(32.0 * epsilon) * Q);
    x = select(yields, x, T(0.0));
    shear = 1.0 - x, mean = (1.0 - x) / (1.0 - (1.0 - kappa) * x), plastic_increment = (1.0 / G3) * trial(x) * x;
  }
}

/// The returns at the n points of a layer along the flow curves sigma(dl) of the law. On the surface z = D/sigma with
/// D = 3 G dl, so that a = sigma + kappa D and b = sigma + D are sigma (1 + kappa z) and sigma (1 + z), and
///   g = (m/a^2 + d/b^2)^(-1/2) = 1
/// which rises with dl, and is (sigma + D)/Q in pure shear. A guess is the root of the line in D from the stress before
/// the step, whose q^2 is given.
template <FlowLaw Law, class State, class T, std::size_t n>
void plane_return_by_curve(const Law& law, std::span<const State, n> states, std::array<PlaneReturn<T>, n>& returns,
                           const std::array<T, n>& squares_before, double kappa, double dt) {
  if (!(dt > 0)) return;
  using Curve = decltype(flow_curve<T>(law, states[0], dt));
  const double G3 = 3.0 * law.shear_modulus;
  auto curves = [&]<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<Curve, n>{flow_curve<T>(law, states[k], dt)...};
  }(std::make_index_sequence<n>{});
  std::array<Search<T>, n> searches;
  std::array<T, n> m, d, per_stress;  // of Q
  bool any_yields = false;
  for (std::size_t k = 0; k < n; ++k) {
    const T Q2 = max(T(least_square<T>), returns[k].d + returns[k].m), per_Q = rsqrt(Q2), Q = Q2 * per_Q;
    m[k] = returns[k].m * per_Q * per_Q, d[k] = returns[k].d * per_Q * per_Q, per_stress[k] = per_Q;
    const T at_rest = curves[k].at_rest(), excess = Q - at_rest, most = Q * (1.0 / (G3 * kappa));
    const T before = max(T(least_square<T>), squares_before[k]), change = Q - before * rsqrt(before);
    const T guess = select(change > 1e-3 * excess, min(change, excess), excess) / (G3 * (kappa * m[k] + d[k]));
    const auto yields = excess > 0.0;
    searches[k] = {yields, select(yields, min(guess, 0.5 * most), 0.5 * most), per_Q * at_rest, most};
    any_yields |= any(yields);
  }
  if (!any_yields) return;
  const auto measure = [&](std::size_t k, const LogSeries<T>& stress, const T& dl) {
    const LogSeries<T> sigma = per_stress[k] * stress, D = LogSeries<T>::proportional(G3 * per_stress[k] * dl);
    const LogSeries<T> a = sigma + T(kappa) * D, b = sigma + D;
    const T per_ab = 1.0 / (a.c0 * b.c0), per_a = b.c0 * per_ab, per_b = a.c0 * per_ab;
    return inverse_root((m[k] * per_a * per_a) * inverse_square(per_a * a) +
                        (d[k] * per_b * per_b) * inverse_square(per_b * b));
  };
  const Increments<T, n> found = find_increments<n, T>(curves, searches, measure);
  for (std::size_t k = 0; k < n; ++k) {
    const T &sigma = found.stress[k], D = G3 * found.dl[k], a = sigma + kappa * D, b = sigma + D,
            per_ab = sigma / (a * b);
    returns[k].mean = select(searches[k].yields, b * per_ab, T(1.0));
    returns[k].shear = select(searches[k].yields, a * per_ab, T(1.0));
    returns[k].plastic_increment = found.dl[k];
  }
}

template <FlowLaw S, class State, class T, std::size_t n>
void plane_return(const S& law, std::span<const State, n> states, std::array<PlaneReturn<T>, n>& returns,
                  [[maybe_unused]] const std::array<T, n>& squares_before, double kappa, double dt) {
  if constexpr (FoundByCurve<S, T>)
    plane_return_by_curve<S, State, T, n>(law, states, returns, squares_before, kappa, dt);
  else if constexpr (RateIndependentFlow<S> && requires(T q) { law.plastic_increment(q, q, dt); })
    plane_return_by_increment<S, State, T, n>(law, states, returns, kappa, dt);
  else
    plane_return_by_root<S, State, T, n>(law, states, returns, kappa, dt);
}

}  // namespace detail

/// Plane stress of a linear-elastic solid in closed form: Hooke's law with E/(1 - nu^2), and the return to von Mises'
/// ellipse of Simo and Taylor (1986) in the basis in which both are diagonal, s = sxx + syy, r = sxx - syy, sxy:
///   q^2 = s^2/4 + 3/4 r^2 + 3 sxy^2
///   s = s_trial/(1 + kappa z),  r = r_trial/(1 + z),  z = 3 G dl/q,  kappa = E/(6 G (1 - nu)) = 3 K/(3 K + 4 G)
/// With t = 1/(1 + z) and p = (1 + z)/(1 + kappa z) this is r = t r_trial, s = t p s_trial, q = t Q with
///   Q^2 = s_trial^2/4 p^2 + 3/4 r_trial^2 + 3 sxy_trial^2,    q = Q - 3 G dl,    1/p = kappa + (1 - kappa) t
/// so that for a given p the increment is that of a radial return from the trial stress Q.
///   PlaneStress aluminium{Solid{LinearEos{...}, VonMises{...}}};
/// Volume strains are elastic and small; for other equations of state see ZeroNormalStress.
template <class S>
struct PlaneStress {
  static constexpr bool is_linear = detail::LinearSolid<S>::is, sound = is_linear;
  static_assert(is_linear || detail::is_reported<S>(),
                "strike: PlaneStress is for Elastic and for a Solid of LinearEos and a flow law or ElasticStrength: "
                "write ZeroNormalStress for any other solid.");

  S solid;

  void ranges(const auto& number) const { number(solid); }

  using Kinematics = PlaneStressKinematics;
  using Parts = typename detail::LinearSolid<S>::Parts;
  using Law = decltype(Parts::strength);
  using Failure = decltype(Parts::failure);

  template <class T>
  struct State : StrengthState<Law, T>, Failure::template State<T> {
    PlaneTensor<T> stress{};
  };

  double density() const { return density_of(solid); }

  /// A text for the user, empty if there is nothing to say.
  std::string warning() const
    requires requires(S s) { s.warning(); }
  {
    return solid.warning();
  }

  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    advance<T, 1>(std::span<State<T>, 1>(&state, 1), std::span<const PlaneStressKinematics::Rate<T>, 1>(&rate, 1), dt);
    return state.stress;
  }
  /// The stresses of n points at once, which takes less time.
  template <class T, std::size_t n>
  std::array<PlaneTensor<T>, n> stresses(std::array<State<T>, n>& points,
                                         const std::array<PlaneStressKinematics::Rate<T>, n>& rates, double dt) const {
    advance<T, n>(points, rates, dt);
    std::array<PlaneTensor<T>, n> stresses;
    for (std::size_t k = 0; k < n; ++k) stresses[k] = points[k].stress;
    return stresses;
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

  /// d_zz of the step [1/time]: tr(stress)/(3 K) is the volume strain, with or without plastic flow.
  template <class T>
  T normal_rate(const State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt,
                const PlaneTensor<T>& change) const {
    const double K3 = 3 * detail::LinearSolid<S>::parts(solid).eos.bulk_modulus;
    return (1 / (K3 * dt)) * trace(change) - trace(detail::rate_if_intact(*this, state, rate).rate_of_deformation);
  }

  /// The stress at which it flows, at this rate of plastic strain [1/time].
  template <class T>
    requires FlowLaw<Law>
  T flow_stress(const State<T>& state, const T& rate) const {
    const Parts& parts = detail::LinearSolid<S>::parts(solid);
    return detail::flow_stress<Law, T>(parts.strength, state, state.equivalent_plastic_strain, rate);
  }
  static constexpr bool flow_is_rate_independent = RateIndependentFlow<Law>;

  /// Plastic flow beyond that of the mean stress, of which an element knows, as of a Solid; all of the stress returns.
  template <class T>
    requires FlowLaw<Law>
  void flow(State<T>& state, const T& kept, const T& increment, [[maybe_unused]] const T& flow_stress) const {
    state.stress = kept * state.stress;
    state.equivalent_plastic_strain += increment;
    if constexpr (ThermalFlow<Law>)
      state.temperature_rise += detail::LinearSolid<S>::parts(solid).strength.heating * flow_stress * increment;
  }

  template <class T>
    requires detail::has_intact<State<T>>
  T intact(const State<T>& state) const {
    return state.intact;
  }

 private:
  template <class T>
  static constexpr bool can_fail = detail::has_intact<State<T>>;

  template <class T, std::size_t n>
  void advance(std::span<State<T>, n> points, std::span<const PlaneStressKinematics::Rate<T>, n> rates,
               double dt) const {
    const Parts& parts = detail::LinearSolid<S>::parts(solid);
    const double G = parts.strength.shear_modulus, kappa = mean_factor(parts);
    [[maybe_unused]] std::array<detail::PlaneReturn<T>, n> returns;
    [[maybe_unused]] std::array<T, n> strains_old, squares_before;
    for (std::size_t k = 0; k < n; ++k) {
      PlaneTensor<T>& stress = points[k].stress;
      if constexpr (can_fail<T>) strains_old[k] = detail::plastic_strain<T>(points[k]);
      if constexpr (detail::FoundByCurve<Law, T>)
        squares_before[k] = 1.5 * double_dot(stress, stress) - 0.5 * (trace(stress) * trace(stress));
      const PlaneTensor<T> d = T(dt) * detail::rate_if_intact(*this, points[k], rates[k]).rate_of_deformation;
      const T s = trace(stress) + (6.0 * G * kappa) * trace(d), r = stress.xx - stress.yy + (2.0 * G) * (d.xx - d.yy);
      stress = {0.5 * (s + r), 0.5 * (s - r), stress.xy + (2.0 * G) * d.xy};
      if constexpr (FlowLaw<Law>) returns[k] = {.m = 0.25 * s * s, .d = 0.75 * r * r + 3.0 * stress.xy * stress.xy};
    }
    if constexpr (FlowLaw<Law>) {
      detail::plane_return<Law, State<T>, T, n>(parts.strength, points, returns, squares_before, kappa, dt);
      for (std::size_t k = 0; k < n; ++k) {
        State<T>& state = points[k];
        const detail::PlaneReturn<T>& left = returns[k];
        const T s = left.mean * trace(state.stress), r = left.shear * (state.stress.xx - state.stress.yy);
        state.stress = {0.5 * (s + r), 0.5 * (s - r), left.shear * state.stress.xy};
        state.equivalent_plastic_strain += left.plastic_increment;
        if constexpr (ThermalFlow<Law>)
          state.temperature_rise += parts.strength.heating * equivalent_stress(state.stress) * left.plastic_increment;
      }
    }
    if constexpr (can_fail<T>)
      for (std::size_t k = 0; k < n; ++k) {
        State<T>& state = points[k];
        const auto fails =
            detail::fails_now<Failure, T>(parts.failure, state, equivalent_stress(state.stress), strains_old[k], dt);
        state.intact = select(fails, T(0.0), state.intact);
        state.stress = select(state.intact > 0.0, state.stress, PlaneTensor<T>{});
      }
  }

  /// kappa.
  static double mean_factor(const Parts& parts) {
    const double K3 = 3 * parts.eos.bulk_modulus;
    return K3 / (K3 + 4 * parts.strength.shear_modulus);
  }
};

template <class S>
PlaneStress(S) -> PlaneStress<S>;

}  // namespace strike
