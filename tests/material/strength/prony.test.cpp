#include <cmath>
#include <numbers>

#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/prony.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;

namespace {
constexpr Prony<2> interlayer{.shear_modulus = 200e6,
                              .terms = {{.share = .9, .time = 2e-3}, {.share = .08, .time = .5}}};
using State = Prony<2>::State<double>;
}  // namespace

static_assert(Strength<Prony<1>> && StrengthWithMemory<Prony<3>> && !FlowLaw<Prony<1>>);
static_assert(sizeof(StrengthState<Prony<2>, double>) == 12 * sizeof(double));

TEST_CASE("Prony: a strain that is held relaxes as G(t), exactly, in steps of any size") {
  CHECK(interlayer.relaxation(0) == 200e6);
  CHECK(interlayer.relaxation(.01) == Approx(200e6 * (.02 + .9 * std::exp(-5) + .08 * std::exp(-.02))).epsilon(1e-14));
  CHECK(interlayer.relaxation(1e3) == Approx(4e6).epsilon(1e-12));
  const double g = 1e-3;
  for (const double dt : {1e-5, 1e-3, .1, 100.0}) {
    State state;
    Tensor s = advance_deviator(interlayer, state, {}, Tensor{.xy = .5 * g}, 0.0);  // at once
    CHECK(s.xy == 200e6 * g);
    for (int i = 1; i <= 100; ++i) {
      s = advance_deviator(interlayer, state, s, {}, dt);
      CHECK(s.xy == Approx(interlayer.relaxation(i * dt) * g).epsilon(1e-12));  // a hundred roundings, of G0
    }
  }
}

TEST_CASE("Prony: a term without a share changes no bit, not even the sign of a zero") {
  const Prony<1> one{.shear_modulus = 10, .terms = {{.share = .7, .time = 1}}};
  const Prony<3> more{.shear_modulus = 10, .terms = {{0, 2}, {.7, 1}, {0, 1}}};
  Prony<1>::State<double> a;
  Prony<3>::State<double> b;
  Tensor s{.xy = -0.0}, r = s;
  for (int i = 0; i < 50; ++i) {
    const Tensor d{.xx = 1e-3 * i, .yy = -1e-3 * i, .xy = -0.0, .yz = 1e-2 * std::cos(i)};
    s = advance_deviator(one, a, s, d, .1), r = advance_deviator(more, b, r, d, .1);
    CHECK(s.yz == r.yz);
    CHECK(s.xx == r.xx);
    CHECK(std::signbit(s.xy) == std::signbit(r.xy));
  }
}

TEST_CASE("Prony: a constant rate gives rate int G dt, in one step as in a thousand") {
  // int_0^t G = G0 [(1 - sum g) t + sum g t_k (1 - exp(-t/t_k))]
  for (const double t : {1e-4, 3e-3, 2.0})
    for (const int n : {1, 1000}) {
      State state;
      Tensor s;
      const double strain = 1e-3;
      for (int i = 0; i < n; ++i) s = advance_deviator(interlayer, state, s, Tensor{.yz = .5 * strain / n}, t / n);
      const double G_t = 200e6 * (.02 * t - .9 * 2e-3 * std::expm1(-t / 2e-3) - .08 * .5 * std::expm1(-t / .5));
      CHECK(s.yz == Approx(strain / t * G_t).epsilon(1e-12));
    }
}

TEST_CASE("Prony: a swinging strain is met by the storage modulus in phase and the loss modulus ahead of it") {
  // G' = Ginf + sum G_k x^2/(1 + x^2), G'' = sum G_k x/(1 + x^2), x = w t_k
  const Prony<1> law{.shear_modulus = 10, .terms = {{.share = .7, .time = 1}}};
  for (const double w : {.2, 1.0, 5.0}) {
    const double x2 = w * w, storage = 3 + 7 * x2 / (1 + x2), loss = 7 * w / (1 + x2);
    const int n = 400;  // a period; straight pieces err by (2 pi/n)^2/12 = 2e-5
    const double dt = 2 * std::numbers::pi / (w * n), g = .01;
    const int transient = n * static_cast<int>(std::ceil(20 / (n * dt)));  // exp(-20)
    Prony<1>::State<double> state;
    Tensor s;
    double work = 0;
    for (int i = 0; i < transient + n; ++i) {
      const double before = s.xy, strain = g * (std::sin(w * dt * (i + 1)) - std::sin(w * dt * i));
      s = advance_deviator(law, state, s, Tensor{.xy = .5 * strain}, dt);
      if (i < transient) continue;
      work += .5 * (before + s.xy) * strain;
      const double phase = w * dt * (i + 1);
      CHECK(s.xy == Approx(g * (storage * std::sin(phase) + loss * std::cos(phase))).margin(1e-4 * g * storage));
    }
    CHECK(work == Approx(std::numbers::pi * loss * g * g).epsilon(1e-4));  // what a period loses
  }
}

TEST_CASE("Prony: an interlayer in a plate goes from its quick to its slow stiffness") {
  const double K = 2e9;
  const Homogeneous layer{ZeroNormalStress{Solid{LinearEos{.density = 1100, .bulk_modulus = K}, interlayer}}, .76e-3,
                          Simpson<3>{}};
  decltype(layer)::State<double> state;
  layer.begin(state);
  PlateKinematics::Rate<double> rate{};
  const double strain = 1e-6, dt = 1e-9, h = layer.thickness();
  rate.membrane.xx = strain / dt;
  const auto plane_strain = [&](double G) { return 4 * G * (3 * K + G) / (3 * K + 4 * G) * strain * h; };
  CHECK(layer.stress(state, rate, dt).force.xx == Approx(plane_strain(200e6)).epsilon(4e-6));  // dt/t_k and the strain
  rate.membrane.xx = 0;
  for (int i = 0; i < 200; ++i) layer.stress(state, rate, .1);
  CHECK(layer.stress(state, rate, .1).force.xx == Approx(plane_strain(4e6)).epsilon(1e-5));
  static_assert(sizeof(decltype(layer)::State<double>) == (3 * (6 + 12 + 2) + 2) * sizeof(double));
}
