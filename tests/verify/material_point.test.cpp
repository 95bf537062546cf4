#include <cmath>
#include <complex>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>

#include <strike/material.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double G = 80e9, K = 160e9, E = 9 * K * G / (3 * K + G), nu = (3 * K - 2 * G) / (2 * (3 * K + G)), Y = 400e6,
                 H = 2e9;
const Solid steel{LinearEos{.density = 7850, .bulk_modulus = K},
                  VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}};
const Solid rubber{LinearEos{.density = 1000, .bulk_modulus = K}, ElasticStrength{.shear_modulus = G}};
constexpr Elastic elastic{.density = 1000, .youngs_modulus = E, .poissons_ratio = nu};

}  // namespace

TEST_CASE("material point: uniaxial stress gives Young's modulus and Poisson's ratio") {
  MaterialPoint point{elastic};
  const auto history = point.run(uniaxial_stress({.strain = 1e-3, .rate = 10, .steps = 10}));
  REQUIRE(history.size() == 11);
  for (const auto& r : history) {
    const double strain = r.strain().xx;
    CHECK(r.time == Approx(strain / 10).epsilon(1e-6));
    CHECK(r.stress.xx == Approx(E * strain).epsilon(1e-8));  // ln of the stretch: steps of 1e-4, squared
    CHECK(r.strain().yy == Approx(-nu * strain).epsilon(1e-8));
    CHECK(r.strain().zz == Approx(-nu * strain).epsilon(1e-8));
    CHECK(std::abs(r.stress.yy) < 1e-13 * K);
    CHECK(std::abs(r.stress.zz) < 1e-13 * K);
  }
  const auto moduli = point.moduli();
  CHECK(moduli.bulk == Approx(K).epsilon(1e-14));
  CHECK(moduli.shear == Approx(G).epsilon(1e-14));
}

TEST_CASE("material point: the tension test of a hardening metal, by strain and by stress") {
  // sigma = Y + H e_p with e_p = strain - sigma/E
  const auto curve = [](double strain) { return (Y + H * strain) / (1 + H / E); };
  MaterialPoint by_strain{steel};
  for (const auto& r : by_strain.run(uniaxial_stress({.strain = 0.1, .steps = 1000})))
    if (r.strain().xx > 1.01 * Y / E) {
      CHECK(r.stress.xx == Approx(curve(r.strain().xx)).epsilon(1e-6));
      const double volume = r.stress.xx / (3 * K);  // p is linear in 1/J, not in ln J
      CHECK(std::abs(r.state.equivalent_plastic_strain - (r.strain().xx - r.stress.xx / E)) < volume * volume / 2);
    }

  MaterialPoint by_stress{steel};
  const double target = curve(0.1);
  by_stress.run({{Segment{.duration = 1, .steps = 50, .stress = {.xx = target, .yy = 0, .zz = 0}}}});
  CHECK(by_stress.now().stress.xx == Approx(target).epsilon(1e-12));
  CHECK(by_stress.now().strain().xx == Approx(0.1).epsilon(1e-5));  // steps of 2e-3, squared
}

TEST_CASE("material point: through yielding in one large step under mixed control") {
  for (const double strain : {1e-4, 1e-2, 0.3, -0.3}) {
    MaterialPoint point{steel};
    point.run(uniaxial_stress({.strain = strain, .steps = 1}));
    CHECK(std::abs(point.now().stress.yy) < 1e-13 * K);
    CHECK(std::abs(point.now().stress.zz) < 1e-13 * K);
    CHECK(std::abs(point.now().stress.xx) <= Approx((Y + H * std::abs(strain))));
  }
}

TEST_CASE("material point: shear stress prescribed beside a prescribed spin") {
  MaterialPoint point{steel};
  Matrix3<double> L = Matrix3<double>::Zero();
  L(0, 1) = 0.1, L(1, 0) = -0.1;
  point.run({{Segment{.duration = 1,
                      .steps = 100,
                      .velocity_gradient = L,
                      .stress = {.xx = 0, .yy = 0, .zz = 0, .xy = 1e8, .yz = 0, .zx = 0}}}});
  const auto& now = point.now();
  CHECK(now.stress.xy == Approx(1e8).epsilon(1e-12));
  CHECK(std::abs(now.stress.xx) < 1e-13 * K);
  CHECK(now.relative_volume() == Approx(1).epsilon(1e-6));
}

TEST_CASE("material point: the volume is that of the deformation gradient, which simple shear keeps") {
  MaterialPoint point{elastic};
  point.run(simple_shear({.strain = 3, .steps = 300}));
  Matrix3<double> F = Matrix3<double>::Identity();
  F(0, 1) = 3;
  CHECK((point.now().deformation_gradient - F).norm() < 1e-13);  // a nilpotent L: no error of the steps
  CHECK(point.now().relative_volume() == Approx(1).epsilon(1e-13));
  point.run(back(simple_shear({.strain = 3, .steps = 300})));
  CHECK((point.now().deformation_gradient - Matrix3<double>::Identity()).norm() < 1e-13);

  MaterialPoint squeezed{rubber};
  squeezed.run(hydrostatic({.strain = std::log(0.5), .steps = 1000}));
  CHECK(squeezed.now().relative_volume() == Approx(0.5).epsilon(1e-7));  // ln 2 / 3000 a step, squared, over 12
  CHECK(squeezed.now().stress.xx == Approx(-K).epsilon(1e-6));
  CHECK(squeezed.now().stress.xy == 0);
}

TEST_CASE("material point: deform() reaches any deformation gradient in one step") {
  MaterialPoint point{elastic};
  Matrix3<double> F;
  F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, 0.0, -0.2, 1.2;
  CHECK((point.deform(F, 1e-3).deformation_gradient - F).norm() < 1e-14);
  F(0, 0) += 0.1;
  CHECK((point.deform(F, 1e-3).deformation_gradient - F).norm() < 1e-14);
  CHECK(point.now().time == 2e-3);
}

TEST_CASE("material point: a rigid rotation turns the stress and does no work, in steps as large as 1 radian") {
  MaterialPoint point{elastic};
  point.run(uniaxial_strain({.strain = 0.01, .steps = 1}));
  const auto before = point.now();
  const double angle = 1;
  const Matrix3<double> Q = Eigen::AngleAxisd(angle, Vector3<double>(1, 2, 2) / 3).toRotationMatrix();
  point.deform(Q * before.deformation_gradient, 1e-3);
  CHECK((point.now().stress.matrix() - Q * before.stress.matrix() * Q.transpose()).norm() < 1e-14 * E);
  CHECK(std::abs(point.now().work - before.work) < 1e-14 * E);
  CHECK((point.now().strain().matrix() - Q * before.strain().matrix() * Q.transpose()).norm() < 1e-14);
}

TEST_CASE("material point: simple shear of a hypoelastic solid, tau = G sin g, s11 = G (1 - cos g)") {
  const double shear = elastic.shear_modulus();
  for (const double g : {0.5, 1.0, std::numbers::pi}) {
    const std::size_t steps = 1200 * std::size_t(std::ceil(g));  // dg < 1e-3
    MaterialPoint exact{elastic, HughesWinget{}};
    exact.run(simple_shear({.strain = g, .steps = steps}), [](const auto&) {});
    CHECK(std::abs(exact.now().stress.xy / shear - std::sin(g)) < 1e-6);
    CHECK(std::abs(exact.now().stress.xx / shear - (1 - std::cos(g))) < 1e-6);
    CHECK(std::abs(exact.now().stress.yy / shear + (1 - std::cos(g))) < 1e-6);
  }
}

TEST_CASE("material point: the first-order rotation follows its own recurrence in simple shear") {
  // z = (s11 - s22)/2 + i tau runs as z <- (1 - i a) z + i G a (1 - i a/2), a = dg: it grows by sqrt(1 + a^2) a step
  const double shear = elastic.shear_modulus(), g = 1;
  const std::size_t steps = 100;
  const double a = g / double(steps);
  std::complex<double> z = 0;
  const std::complex<double> i(0, 1);
  for (std::size_t n = 0; n < steps; ++n) z = (1. - i * a) * z + i * shear * a * (1. - i * a / 2.);
  MaterialPoint point{elastic, Jaumann{}};
  point.run(simple_shear({.strain = g, .steps = steps}));
  CHECK(point.now().stress.xy == Approx(z.imag()).epsilon(1e-12));
  CHECK(point.now().stress.xx == Approx(z.real()).epsilon(1e-12));
  CHECK(std::abs(point.now().stress.xy / shear - std::sin(g)) < g * a);  // the price of the policy: g a/2
}

TEST_CASE("material point: cycles come back, jumps follow one another") {
  const Path quarter = uniaxial_stress({.strain = 0.02, .rate = 2, .steps = 7});
  const Path path = cyclic(quarter, 3);
  REQUIRE(path.segments.size() == 12);
  MaterialPoint point{steel};
  const auto history = point.run(path);
  REQUIRE(history.size() == 1 + 12 * 7);
  for (int cycle = 0; cycle <= 3; ++cycle) CHECK(std::abs(history[std::size_t(cycle) * 28].strain().xx) < 1e-14);
  CHECK(history[7].strain().xx == Approx(0.02).epsilon(1e-6));
  CHECK(history[21].strain().xx == Approx(-0.02).epsilon(1e-6));
  CHECK(history.back().time == Approx(12 * 0.01).epsilon(1e-12));

  const Path jumps = rate_jumps(simple_shear, {.strain = 0.1, .steps = 5}, {1., 100.});
  REQUIRE(jumps.segments.size() == 2);
  CHECK(jumps.segments[0].duration == Approx(0.1));
  CHECK(jumps.segments[1].duration == Approx(0.001));
  CHECK(jumps.segments[1].velocity_gradient(0, 1) == 100);
  CHECK((quarter + hold(3)).segments.back().duration == 3);
}

TEST_CASE("material point: work is the strain energy in a closed form") {
  MaterialPoint point{rubber};
  const double g = 0.1;
  point.run(uniaxial_strain({.strain = g, .steps = 2000}));
  // p = K (1/J - 1), s = (4/3) G ln J along x: integral of J (s - p) d(ln J)
  const double J = std::exp(g), pressure_work = K * (g - (J - 1)), shear_work = 4 * G / 3 * (J * (g - 1) + 1);
  CHECK(point.now().work == Approx(shear_work - pressure_work).epsilon(1e-6));
}

TEST_CASE("material point: a stress beyond the material is one sentence, and the point stays where it was") {
  Solid soft = steel;
  soft.strength.hardening_modulus = 0;
  MaterialPoint point{soft};
  point.run(uniaxial_stress({.strain = 1e-3}));
  const auto before = point.now();
  const Path pull{{Segment{.duration = 1, .steps = 10, .stress = {.xx = 2 * Y, .yy = 0, .zz = 0}}}};
  CHECK_THROWS_WITH(point.run(pull),
                    ContainsSubstring("prescribed stress xx") && ContainsSubstring("beyond the material, which gives"));
  CHECK(point.now().stress.xx <= Y * (1 + 1e-10));
  CHECK(point.now().time > before.time);  // the steps before stand
}

TEST_CASE("material point: steps and ramps that cannot be are refused") {
  MaterialPoint point{elastic};
  const Matrix3<double> L = -3 * Matrix3<double>::Identity();
  CHECK_THROWS_WITH(point.step(L, 1), ContainsSubstring("relative volume becomes"));
  CHECK(point.now().time == 0);
  CHECK_THROWS_WITH(uniaxial_strain({.strain = 0.1, .rate = 0}),
                    ContainsSubstring("the rate of Ramp is 0; it must be positive"));
  CHECK_THROWS_WITH(uniaxial_strain({.strain = 0}), ContainsSubstring("has no duration"));
  CHECK_THROWS_WITH(point.run(hold(0)), ContainsSubstring("the duration of Segment is 0; it must be positive"));
  CHECK_THROWS_WITH(point.run(hold(1, 0)), ContainsSubstring("the steps of Segment is 0"));
}

TEST_CASE("material point: an inviscid fluid in tension without lateral stress, whose tangent is singular") {
  MaterialPoint point{Fluid{LinearEos{.density = 1000, .bulk_modulus = 2e9}}};
  point.run(uniaxial_stress({.strain = 0.1, .steps = 10}));
  CHECK(std::abs(point.now().stress.xx) < 1e-4);
  CHECK(point.now().relative_volume() == Approx(1).epsilon(1e-12));
}

TEST_CASE("material point: an axis of time, a curve and a file") {
  MaterialPoint point{steel};
  const auto history = point.run(uniaxial_stress({.strain = 0.01, .rate = 1e3, .steps = 4}));
  const std::vector<double> sigma = values(history, [](const auto& r) { return r.stress.xx; });
  REQUIRE(sigma.size() == 5);
  CHECK(sigma.back() == history.back().stress.xx);

  const std::string path = "material_point_test.csv";
  write(path, history);
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  CHECK_THAT(line, ContainsSubstring("time,strain xx,") && ContainsSubstring("work,equivalent plastic strain"));
  int rows = 0;
  while (std::getline(file, line)) ++rows;
  CHECK(rows == 5);
  std::remove(path.c_str());
}
