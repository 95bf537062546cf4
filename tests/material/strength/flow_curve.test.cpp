#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>
#include <strike/material/strength/flow_curve.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/tabulated_rates.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/strength/zerilli_armstrong.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double G = 80e9;

/// A law of a user's own, without a curve.
struct Voce {
  double shear_modulus, Y, Q, b;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + Q * (1.0 - exp(-b * e));
  }
};

static_assert(detail::HasFlowCurve<RateVonMises> && detail::HasFlowCurve<JohnsonCook>);
static_assert(detail::HasFlowCurve<CowperSymonds<TabulatedHardening>> && detail::HasFlowCurve<PowerHardening>);
static_assert(!detail::HasFlowCurve<CowperSymonds<Voce>>);
static_assert(!detail::FoundByCurve<VonMises, double> && !detail::FoundByCurve<TabulatedHardening, double>);

const TabulatedHardening table{G, {{0, 400e6}, {1e-5, 401e6}, {1e-3, 420e6}, {0.05, 450e6}, {0.2, 440e6}, {1, 550e6}}};

/// Calls f(law) for laws of all kinds and exponents, those of the papers first.
template <class F>
void each_law(F f) {
  f(RateVonMises{G, 300e6, 0, std::pow(40.4, -0.2), 0.2});
  f(RateVonMises{G, 300e6, 1e9, 0.7, 0.05});
  f(RateVonMises{G, 300e6, 1e9, 1e-6, 1});
  f(RateVonMises{G, 300e6, 1e9, 1e-9, 1.5});
  JohnsonCook copper{.shear_modulus = G, .A = 90e6, .B = 292e6, .n = 0.31, .C = 0.025};
  copper.m = 1.09, copper.melting_temperature = 1356, copper.heating = 1e-7;
  f(copper);
  f(JohnsonCook{.shear_modulus = G, .A = 1e6, .B = 292e6, .n = 1, .C = 0.025});
  f(ZerilliArmstrong{.shear_modulus = G, .C0 = 46.5e6, .C2 = 890e6, .C3 = 0.0028, .C4 = 0.000115});
  ZerilliArmstrong iron{.shear_modulus = G, .C0 = 65e6, .C1 = 1033e6, .C3 = 0.00698, .C4 = 0.000415};
  iron.C5 = 266e6, iron.n = 0.289;
  f(iron);
  for (const double e0 : {1e-6, 0.02}) {
    const PowerHardening power{G, 500e6, 0.1, e0};
    f(power);
    f(CowperSymonds{power, 6500, 4});
  }
  f(CowperSymonds{table, 40.4, 5});
  f(CowperSymonds{VonMises{G, 300e6, -1e9}, 40.4, 5});  // softens
  const std::vector<TabulatedRates::Test> tests{{1e-3, {{0, 300e6}, {1e-3, 420e6}, {0.2, 400e6}}},
                                                {10, {{0, 310e6}, {1e-3, 430e6}, {0.01, 450e6}}},
                                                {1e5, {{0, 500e6}, {1, 900e6}}}};
  for (const auto between : {TabulatedRates::Between::rates, TabulatedRates::Between::logarithms})
    f(TabulatedRates{G, tests, between});
}

/// The state of a point that is 200 degrees warmer than at first.
template <class Law, class T>
StrengthState<Law, T> state_at(const T& e) {
  StrengthState<Law, T> state{};
  state.equivalent_plastic_strain = e;
  if constexpr (ThermalFlow<Law>) state.temperature_rise = T(200.0);
  return state;
}

/// The increment by bisection in long double.
template <class Law>
long double bisected(const Law& law, double e, long double q, double dt) {
  using L = long double;
  const auto state = state_at<Law, L>(L(e));
  const L G3 = 3 * L(law.shear_modulus);
  L lower = 0, upper = q / G3;
  for (int i = 0; i < 1200; ++i) {
    const L middle = lower > 0 && upper > 2 * lower ? std::sqrt(lower * upper)
                     : lower > 0                    ? (lower + upper) / 2
                                                    : upper / 1e9L;
    if (middle < 1e-307L || middle == lower || middle == upper) break;
    const L sigma = detail::flow_stress<Law, L>(law, state, L(e) + middle, middle / L(dt));
    (q - G3 * middle > sigma ? lower : upper) = middle;
  }
  return upper;
}

/// Trial stresses from a rounding above yield to a hundred times of it, at all strains and times of a step, from
/// guesses that are absent, too small by a thousand, nearly right, and too large. The increment is exact to what 32
/// roundings of the trial stress are over the slope of the residual, which is at least 3 G less what softens.
template <class T, class Law>
void check_increments(const Law& law) {
  constexpr double epsilon = std::numeric_limits<RealOf<T>>::epsilon();
  double worst = 0;
  for (const double strain : {0.0, 1e-8, 1e-3, 0.01, 0.25})
    for (const double dt : {1e-12, 1e-7, 1e-3, 1e5})
      for (int k = sizeof(RealOf<T>) == 8 ? -15 : -6; k <= 2; ++k) {
        const auto state = state_at<Law, T>(T(strain));
        const double e = double(lane(state.equivalent_plastic_strain, 0));
        const long double at_rest = detail::flow_stress<Law, long double>(law, state_at<Law, long double>(e), e, 0);
        const T q = T(double(at_rest) * (1 + 1.7 * std::pow(10, k)));
        const long double exact = bisected(law, e, double(lane(q, 0)), dt);
        const double unit = epsilon * double(lane(q, 0)) / (3 * G);
        const auto check = [&](const T& dl) {
          const double error = std::abs(double((long double)(lane(dl, 0)) - exact)) / unit;
          worst = error < 1e300 ? std::max(worst, error) : 1e300;
        };
        check(plastic_increment<Law, T>(law, state, q, dt));
        for (const double factor : {1e-3, 0.98, 1.02, 30.0})
          check(detail::increment_by_curve(law, state, q, T(double(exact) * factor * 3 * G), dt));
      }
  CHECK(worst < 32);
}

/// The same bits; NaN would not be equal.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// f takes the number of the lane that differs from the others, by much.
template <class F>
void check_lanes(F f) {
  const Pack<double, 8> together = f([](std::size_t i) { return i; });
  for (std::size_t alone = 0; alone < 8; ++alone) {
    const Pack<double, 8> others = f([&](std::size_t i) { return i == alone ? i : (i + 3) % 8; });
    CHECK(same(together[alone], others[alone]));
    const Pack<double, 8> equal = f([&](std::size_t) { return alone; });
    CHECK(same(together[alone], equal[alone]));
  }
}

}  // namespace

TEST_CASE("flow curve: the series of each law is that of its flow stress to the fourth power of the step") {
  each_law([](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    using L = long double;
    for (const double e : {0.0, 0.007, 0.3})
      for (const double dl : {3e-7, 4e-4})
        for (const double u : {-0.05, 0.02, 0.05}) {
          const double dt = 1e-7;
          const auto state = state_at<Law, double>(e);
          auto curve = detail::flow_curve<double>(law, state, dt);
          curve.start_at(dl);
          const auto series = curve.series(dl);
          const auto exact = [&](double change) {
            const L next = L(dl) * std::exp(L(change));
            return double(detail::flow_stress<Law, L>(law, state_at<Law, L>(L(e)), e + next, next / L(dt)));
          };
          if constexpr (detail::HasKinks<decltype(curve), double>)
            if (!curve.is_smooth(dl, u)) continue;
          // rest: k^4/24 u^4 of exponentials e^(k u), k <= 2.5
          CHECK(std::abs(series(u) - exact(u)) < (2 * u * u * u * u + 1e-14) * exact(u));
          curve.move_to(dl * std::exp(u), u);
          CHECK(curve.series(dl * std::exp(u)).c0 == Approx(exact(u)).epsilon(1e-14));
          CHECK(curve.at_rest() ==
                Approx(double(detail::flow_stress<Law, L>(law, state_at<Law, L>(L(e)), e, 0))).epsilon(2e-14));
        }
  });
}

TEST_CASE("flow curve: Householder's step passes no root of an exponential, from either side") {
  for (const double k : {0.05, 0.2, 1.0, 3.0})
    for (const double distance : {-3.0, -1.0, -0.1, 1e-3, 0.5, 1.0, 3.0}) {  // in k u
      const double a = std::exp(-distance),
                   step = detail::householder_step(LogSeries<double>::exponential(a, k), true) * k;
      CAPTURE(k, distance, step);
      CHECK(step * distance > 0);
      CHECK(std::abs(step) <= std::abs(distance) * (1 + 1e-12));
      if (std::abs(distance) <= 1) CHECK(std::abs(step - distance) < 0.01 * std::pow(distance, 4) + 1e-15);
    }
}

TEST_CASE(
    "flow curve: each law's increment is that of bisection in long double, over decades of rate, strain, stress") {
  each_law([](const auto& law) {
    check_increments<double>(law);
    check_increments<Pack<double, 8>>(law);
    check_increments<Pack<float, 16>>(law);
  });
}

TEST_CASE("flow curve: a lane's increment is the same to the bit beside any others") {
  using P = Pack<double, 8>;
  const auto check = [](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    check_lanes([&](auto lane_of) {
      const auto state = state_at<Law, P>(P::generate([&](std::size_t i) { return 0.03 * double(lane_of(i) % 3); }));
      const P q = P::generate([&](std::size_t i) { return 60e6 * std::pow(2.0, double(lane_of(i))); });
      return plastic_increment<Law, P>(law, state, q, 1e-6);
    });
  };
  each_law(check);
  check(Voce{G, 100e6, 200e6, 10});
}

TEST_CASE("flow curve: in plane stress too, at every point of a layer") {
  using P = Pack<double, 8>;
  const auto check = [](const auto& law) {
    const PlaneStress material{Solid{LinearEos{.density = 7850, .bulk_modulus = 160e9}, law}};
    using State = typename decltype(material)::template State<P>;
    for (const std::size_t point : {0u, 2u})
      check_lanes([&](auto lane_of) {
        std::array<State, 3> states{};
        std::array<PlaneStressKinematics::Rate<P>, 3> rates;
        for (std::size_t k = 0; k < 3; ++k)
          rates[k] = {{P::generate([&](std::size_t i) { return 1e-4 * std::pow(3.0, double(lane_of(i))); }),
                       P::generate([&](std::size_t i) { return 1e-4 * double(lane_of(i)) * double(k); }), P(2e-4)}};
        for (int i = 0; i < 3; ++i) (void)material.template stresses<P, 3>(states, rates, 1.0);
        return states[point].stress.xx;
      });
  };
  each_law(check);
  check(VonMises{G, 300e6, 1e9});
  check(table);
  check(Voce{G, 100e6, 200e6, 10});
}

TEST_CASE("flow curve: dual numbers have the derivatives of the implicit function, by the stress and the strain") {
  // q - 3 G dl = sigma(e + dl, dl/dt): d dl/dq = 1/(3 G + sigma_e + sigma_r/dt), d dl/de = -sigma_e d dl/dq
  each_law([](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    using D = Dual<double, 2>;
    const double dt = 1e-7;
    for (const double e : {1e-3, 0.1})
      for (const double excess : {1e-3, 0.1, 1.0, 10.0}) {
        const auto state = state_at<Law, D>(D::variable(e, 1));
        const double at_rest = detail::flow_stress<Law, double>(law, state_at<Law, double>(e), e, 0.0);
        const D q = D::variable(at_rest * (1 + excess), 0), dl = plastic_increment<Law, D>(law, state, q, dt);
        const double found = plastic_increment<Law, double>(law, state_at<Law, double>(e), q.value(), dt);
        CHECK(dl.value() == Approx(found).epsilon(1e-8).margin(32 * 2.3e-16 * q.value() / (3 * G)));
        const D sigma = detail::flow_stress<Law, D>(law, state_at<Law, D>(D(e)), D::variable(e + dl.value(), 0),
                                                    D::variable(dl.value() / dt, 1));
        const double by_q = 1 / (3 * G + sigma.derivative(0) + sigma.derivative(1) / dt);
        // the rate, and with it the slope, is known to the roundings of q over 3 G dl
        const double known = 1e-10 + 64 * 2.3e-16 * q.value() / (3 * G * dl.value());
        if (known > 1e-3) continue;
        CAPTURE(e, excess, dl.value(), known);
        CHECK(dl.derivative(0) == Approx(by_q).epsilon(known));
        CHECK(dl.derivative(1) == Approx(-sigma.derivative(0) * by_q).epsilon(known).margin(1e-14));
      }
  });
}

TEST_CASE("flow curve: second derivatives are the differences of the first") {
  using D1 = Dual<double, 1>;
  using D2 = Dual<D1, 1>;
  const JohnsonCook law{.shear_modulus = G, .A = 90e6, .B = 292e6, .n = 0.31, .C = 0.025};
  const double q = 200e6, dt = 1e-7, h = 1e-4 * q;
  const auto slope = [&](double stress) {
    return plastic_increment<JohnsonCook, D1>(law, state_at<JohnsonCook, D1>(D1(0.01)), D1::variable(stress, 0), dt)
        .derivative(0);
  };
  const D2 x = D2::variable(D1::variable(q, 0), 0);
  const D2 dl = plastic_increment<JohnsonCook, D2>(law, state_at<JohnsonCook, D2>(D2(D1(0.01))), x, dt);
  CHECK(dl.derivative(0).value() == Approx(slope(q)).epsilon(1e-9));
  // central difference, h^2/6 of the relative third derivative: (1e-4 q/excess)^2
  CHECK(dl.derivative(0).derivative(0) == Approx((slope(q + h) - slope(q - h)) / (2 * h)).epsilon(1e-6));
}
