#include <cmath>
#include <string>
#include <type_traits>

#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/report.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/scalar/pack.hpp>

#include "support/catch.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;

namespace {

/// Saturating hardening, a law of a user's own: one formula.
struct Voce {
  double shear_modulus, Y, Q, b;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + Q * (1.0 - exp(-b * e));
  }
};

/// The formulas of two laws of ours without their own way to the increment.
struct LinearHardening {
  double shear_modulus, Y, H;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + H * e;
  }
};
struct RatePower {
  double shear_modulus, Y, H, C, n;
  template <class T>
  T flow_stress(const T& e, const T& rate) const {
    return (Y + H * e) * (1.0 + C * pow(rate, T(n)));
  }
};

/// Falls to a tenth and stays there.
struct Drop {
  double shear_modulus, Y, width;
  template <class T>
  T flow_stress(const T& e) const {
    return Y * (0.1 + 0.9 * exp(-e * e / (width * width)));
  }
};

struct WithoutModulus {
  double flow_stress(double) const { return 1; }
};
struct Wrong {
  double shear_modulus;
  std::string flow_stress(double) const { return "much"; }
};

/// Classes that are nearly a strength.
struct InDouble {
  double shear_modulus;
  double flow_stress(double e) const { return 1 + e; }
};
struct FourArguments {
  double shear_modulus;
  template <class T>
  T flow_stress(const T& e, const T&, const T&, const T&) const {
    return e;
  }
};
struct WithoutState {
  double shear_modulus;
  template <class T>
  SymmetricTensor<T> deviatoric_stress(const SymmetricTensor<T>& s, const SymmetricTensor<T>&, const T&) const {
    return s;
  }
};
struct WithoutStep : Voce {
  template <class T>
  T plastic_increment(const T& q, const T&) const {
    return q;
  }
};
struct StiffnessOfState : Voce {
  template <class S>
  double stiffness(const S&) const {
    return shear_modulus;
  }
};
struct WarnsByNumber : Voce {
  int warning() const { return 1; }
};

constexpr double G = 43e9;

/// The root of the residual by bisection.
template <class F>
double bisection(F residual, double upper) {
  double lower = 0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (lower + upper);
    (residual(middle) > 0 ? lower : upper) = middle;
  }
  return lower;
}

}  // namespace

static_assert(FlowLaw<Voce> && RateIndependentFlow<Voce> && Strength<Voce>);
static_assert(RateDependentFlow<RatePower> && !RateIndependentFlow<RatePower>);
static_assert(!FlowLaw<ElasticStrength> && Strength<ElasticStrength>);
static_assert(Strength<Voce, Pack<double>> && Strength<ElasticStrength, Pack<float>>);
static_assert(!Strength<int> && !Strength<WithoutModulus> && !Strength<Wrong> && !Strength<Tensor>);

using detail::StrengthFlaw;
static_assert(detail::strength_flaw<Voce>() == StrengthFlaw::none &&
              detail::strength_flaw<int>() == StrengthFlaw::absent);
static_assert(detail::strength_flaw<WithoutModulus>() == StrengthFlaw::absent);
static_assert(detail::strength_flaw<Wrong>() == StrengthFlaw::flow);
static_assert(detail::strength_flaw<FourArguments>() == StrengthFlaw::flow);
static_assert(detail::strength_flaw<WithoutState>() == StrengthFlaw::deviator);
static_assert(detail::strength_flaw<InDouble>() == StrengthFlaw::in_double);
static_assert(detail::strength_flaw<WithoutStep>() == StrengthFlaw::increment);
static_assert(detail::strength_flaw<StiffnessOfState>() == StrengthFlaw::stiffness);
static_assert(detail::strength_flaw<WarnsByNumber>() == StrengthFlaw::warning);

// Only what the law asks for is remembered.
static_assert(std::is_empty_v<StrengthState<ElasticStrength, double>>);
static_assert(sizeof(StrengthState<Voce, double>) == sizeof(double));
static_assert(sizeof(StrengthState<JohnsonCook, double>) == 2 * sizeof(double));

TEST_CASE("strength: elastic strength is Hooke's law for the deviator") {
  struct {
  } nothing;
  const Tensor s{.xx = 1, .yy = -1, .xy = 3}, d{.xx = .1, .zz = -.1, .yz = .2};
  const Tensor next = advance_deviator(ElasticStrength{.shear_modulus = 5}, nothing, s, d, 1.0);
  CHECK((next - (s + 10. * d)).matrix().norm() == 0);
}

TEST_CASE("strength: a law of one's own returns to its surface, as bisection says") {
  const Voce voce{G, 100e6, 200e6, 10};
  for (const double e : {0.0, 1e-3, 0.3})
    for (const double excess : {1e-10, 1e-4, 0.1, 1.0, 50.0}) {
      StrengthState<Voce, double> state{e};
      const double q = voce.flow_stress(e) * (1 + excess);
      const auto residual = [&](double dl) { return q - 3 * G * dl - voce.flow_stress(e + dl); };
      const double dl = plastic_increment<Voce, double>(voce, state, q, 1e-6);
      CHECK(std::abs(residual(dl)) < 1e-14 * q);
      CHECK(std::abs(dl - bisection(residual, q / (3 * G))) < 1e-14 * q / (3 * G));
    }
  StrengthState<Voce, double> state{0.2};
  CHECK(plastic_increment<Voce, double>(voce, state, voce.flow_stress(0.2), 1e-6) == 0);
  CHECK(plastic_increment<Voce, double>(voce, state, 0.0, 1e-6) == 0);
}

TEST_CASE("strength: the general way to the increment agrees with the laws' own") {
  const VonMises closed{.shear_modulus = G, .yield_stress = 400e6, .hardening_modulus = 1e9};
  const LinearHardening open{G, 400e6, 1e9};
  const RateVonMises closed_rate{
      .shear_modulus = G, .yield_stress = 300e6, .hardening_modulus = 1e9, .rate_factor = .477, .rate_exponent = .2};
  const RatePower open_rate{G, 300e6, 1e9, .477, .2};
  for (const double q : {401e6, 500e6, 5e9, 1e12}) {
    StrengthState<LinearHardening, double> state{0.01};
    CHECK(plastic_increment<LinearHardening, double>(open, state, q, 1e-7) ==
          Approx(closed.plastic_increment(q, 0.01, 1e-7)).epsilon(1e-12));
    for (const double dt : {1e-12, 1e-7, 1.0}) {
      StrengthState<RatePower, double> rate_state{0.01};
      CHECK(std::abs(plastic_increment<RatePower, double>(open_rate, rate_state, q, dt) -
                     closed_rate.plastic_increment(q, 0.01, dt)) < 1e-14 * q / (3 * G));
    }
  }
}

TEST_CASE("strength: a law that softens abruptly is still solved") {
  const Drop drop{G, 300e6, 0.003};
  for (const double excess : {1e-6, 0.01, 1.0, 10.0}) {
    StrengthState<Drop, double> state;
    const double q = 300e6 * (1 + excess), dl = plastic_increment<Drop, double>(drop, state, q, 1e-6);
    CHECK(std::abs(q - 3 * G * dl - drop.flow_stress(dl)) < 1e-14 * q);
  }
}

TEST_CASE("strength: elastic, yielding and far lanes side by side, in double and float") {
  const Voce voce{G, 100e6, 200e6, 10};
  const auto check = [&](auto pack, double rounding) {
    using P = decltype(pack);
    StrengthState<Voce, P> state;
    state.equivalent_plastic_strain = P::generate([](std::size_t i) { return 0.1 * double(i % 3); });
    const P q = P::generate([](std::size_t i) { return 60e6 * std::pow(2.0, double(i)); });
    const P dl = plastic_increment<Voce, P>(voce, state, q, 1e-6);
    for (std::size_t i = 0; i < lanes<P>; ++i) {
      StrengthState<Voce, double> alone{double(state.equivalent_plastic_strain[i])};
      CHECK(std::abs(dl[i] - plastic_increment<Voce, double>(voce, alone, double(q[i]), 1e-6)) <=
            64 * rounding * double(q[i]) / (3 * G));
    }
  };
  check(Pack<double, 8>{}, 2.3e-16);
  check(Pack<float, 16>{}, 1.2e-7);
}
