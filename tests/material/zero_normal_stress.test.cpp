#include <cmath>
#include <random>

#include <strike/material.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;
using Rate = PlaneStressKinematics::Rate<double>;

namespace {

constexpr double E = 72.395e9, nu = .33, Y = 303.37e6, G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
constexpr LinearEos linear{.density = 2800, .bulk_modulus = K};

/// p = -K ln J: the volume strains add up, as they do in PlaneStress.
struct LogarithmicEos {
  double density, bulk_modulus;
  template <class T>
  T A(const T& mu) const {
    return bulk_modulus * log(1.0 + mu);
  }
};
constexpr LogarithmicEos logarithmic{2800, K};

constexpr VonMises perfect{.shear_modulus = G, .yield_stress = Y};
constexpr VonMises hardening{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9};
constexpr RateVonMises rate_dependent{
    .shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9, .rate_factor = .111, .rate_exponent = .25};
constexpr JohnsonCook johnson_cook{.shear_modulus = G,
                                   .A = 265e6,
                                   .B = 426e6,
                                   .n = .34,
                                   .C = .015,
                                   .m = 1,
                                   .initial_temperature = 293,
                                   .melting_temperature = 775,
                                   .heating = 3.6e-7};

}  // namespace

namespace {
template <class M>
concept CanFail = requires(const M m, const typename M::template State<double> state) { m.intact(state); };
}  // namespace

static_assert(CanFail<ZeroNormalStress<Solid<LinearEos, VonMises, FailureStrain>>>);
static_assert(!CanFail<ZeroNormalStress<Solid<LinearEos, VonMises>>> && !CanFail<ZeroNormalStress<Elastic>>);

TEST_CASE("zero normal stress: it agrees with the closed form for every law") {
  const auto check = [](const auto& law) {
    const PlaneStress closed{Solid{linear, law}};
    const ZeroNormalStress sought{Solid{logarithmic, law}};
    typename decltype(closed)::template State<double> a;
    typename decltype(sought)::template State<double> b;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    PlaneTensor<double> trend{}, last{};
    const double dt = 1e-8;
    for (int i = 0; i < 2000; ++i) {
      if (i % 100 == 0) trend = {unit(random), unit(random), unit(random)};
      const Rate rate{(1e-4 / dt) * (trend + 0.3 * PlaneTensor<double>{unit(random), unit(random), unit(random)})};
      const auto s = closed.stress(a, rate, dt);
      const auto difference = s - sought.stress(b, rate, dt);
      CHECK(std::sqrt(double_dot(difference, difference)) < 1e-9 * Y);
      CHECK(std::abs(sought.normal_rate(b, rate, dt, s - last) - closed.normal_rate(a, rate, dt, s - last)) * dt <
            1e-11);
      CHECK(std::abs(b.stress.zz) < 1e-10 * Y);
      last = s;
    }
    if constexpr (requires { a.equivalent_plastic_strain; }) {
      CHECK(a.equivalent_plastic_strain > 0.01);
      CHECK(b.equivalent_plastic_strain == Approx(a.equivalent_plastic_strain).epsilon(1e-9));
    }
    if constexpr (requires { a.temperature_rise; })
      CHECK(b.temperature_rise == Approx(a.temperature_rise).epsilon(1e-9));
  };
  check(ElasticStrength{G});
  check(perfect);
  check(hardening);
  check(rate_dependent);
  check(johnson_cook);
}

TEST_CASE("zero normal stress: perfectly plastic and hardening aluminium along straight paths") {
  struct Path {
    double xx, yy, xy;
    VonMises law;
    double sx, sy, sxy, plastic_strain, normal_strain;
  };
  for (const auto& path : {Path{.01, 0, 0, perfect, 1.153669, .534583, 0, .00648418, -.00759464},
                           Path{.01, 0, 0, hardening, 1.177782, .542771, 0, .00638032, -.00754862},
                           Path{.01, -.005, .005, perfect, .842035, -.037590, .293208, .00752722, -.00385386}}) {
    const auto check = [&](const auto& material) {
      MaterialPoint point{material};
      Segment segment{.duration = 1, .steps = 4000};
      segment.velocity_gradient << path.xx, path.xy, 0, path.xy, path.yy, 0, 0, 0, 0;
      double across = 0;
      point.run({{segment}}, [&](const auto& now) { across += now.rate_of_deformation.zz / 4000; });
      const auto& s = point.now().stress;
      CHECK(std::abs(s.xx / Y - path.sx) < 1e-6);  // the last digit of the values
      CHECK(std::abs(s.yy / Y - path.sy) < 1e-6);
      CHECK(std::abs(s.xy / Y - path.sxy) < 1e-6);
      CHECK(std::abs(point.now().state.equivalent_plastic_strain - path.plastic_strain) < 1e-8);
      CHECK(std::abs(across - path.normal_strain) < 1e-8);
    };
    check(ZeroNormalStress{Solid{logarithmic, path.law}});
  }
}

TEST_CASE("zero normal stress: it finds the strain across that uniaxial stress in space has") {
  const Solid copper{GruneisenEos{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99, .a = .47},
                     VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
  MaterialPoint in_space{copper};
  MaterialPoint plane{ZeroNormalStress{copper}};
  const Path path = uniaxial_stress({.strain = 0.05, .rate = 1e3, .steps = 500}) +
                    uniaxial_stress({.strain = -0.1, .rate = 1e3, .steps = 500});
  const auto a = in_space.run(path);
  const auto b = plane.run(path);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(std::abs(a[i].stress.xx - b[i].stress.xx) < 1e-6 * 400e6);  // volumes differ by the cubes of strains of 1e-4
    CHECK(std::abs(a[i].strain().zz - b[i].strain().zz) < 1e-8);
    CHECK(std::abs(b[i].state.stress.zz) < 1e-10 * 400e6);
    CHECK(b[i].state.relative_volume == Approx(b[i].relative_volume()).epsilon(1e-9));
    CHECK(b[i].state.internal_energy == Approx(b[i].work).epsilon(1e-8).margin(1e-8 * 400e6));
  }
  CHECK(plane.now().state.equivalent_plastic_strain > 0.1);
}

TEST_CASE("zero normal stress: its moduli are those of the solid as it stands") {
  const ZeroNormalStress material{Solid{CubicEos{.density = 1, .C1 = K, .C2 = 2 * K, .C3 = K}, ElasticStrength{G}}};
  MaterialPoint point{material};
  CHECK(point.moduli().normal == Approx(E / (1 - nu * nu)).epsilon(1e-14));
  CHECK(point.moduli().shear == Approx(G).epsilon(1e-14));
  CHECK(material.density() == 1);
  Matrix3<double> L = Matrix3<double>::Zero();
  L.diagonal() << -1, -1, 0;
  point.run({{Segment{.duration = 0.05, .steps = 50, .velocity_gradient = L}}});
  CHECK(point.moduli().normal > 1.01 * E / (1 - nu * nu));  // compressed, and stiffer
}

TEST_CASE("zero normal stress: what has failed carries nothing and feels nothing") {
  MaterialPoint point{ZeroNormalStress{Solid{logarithmic, hardening, FailureStrain{.05}}}};
  Matrix3<double> L = Matrix3<double>::Zero();
  L.diagonal() << .1, -.02, 0;
  point.run({{Segment{.duration = 1, .velocity_gradient = L}}}, [&](const auto& now) {
    CHECK((now.state.intact == 0) == (now.state.equivalent_plastic_strain >= .05));
    if (now.state.intact == 0) CHECK(now.stress.matrix().norm() == 0);
  });
  const auto before = point.now().state;
  CHECK(before.intact == 0);
  point.step(5 * L, 1);
  CHECK(point.now().stress.matrix().norm() == 0);
  CHECK(point.now().rate_of_deformation.zz == 0);
  CHECK(point.now().state.relative_volume == before.relative_volume);
}
