#include <cmath>
#include <random>
#include <type_traits>

#include <strike/material.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;
using Rate = PlaneStressKinematics::Rate<double>;

namespace {

// The aluminium of the straight paths below.
constexpr double E = 72.395e9, nu = .33, Y = 303.37e6, G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
constexpr LinearEos linear{.density = 2800, .bulk_modulus = K};

auto aluminium(double H) {
  return PlaneStress{Solid{linear, VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}}};
}

/// Linear hardening without its own way to the increment.
struct LinearHardening {
  double shear_modulus, Y, H;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + H * e;
  }
};

/// Velocity gradient of a strain in the plane, in unit time.
Matrix3<double> gradient(double xx, double yy, double gamma) {
  Matrix3<double> L = Matrix3<double>::Zero();
  L(0, 0) = xx, L(1, 1) = yy, L(0, 1) = gamma;
  return L;
}

struct Strained {
  double sx, sy, sxy, plastic_strain, normal_strain;  // stresses over Y
};
template <class M>
Strained strained(const M& material, double xx, double yy, double gamma) {
  MaterialPoint point{material};
  double across = 0;
  point.run({{Segment{.duration = 1, .steps = 4000, .velocity_gradient = gradient(xx, yy, gamma)}}},
            [&](const auto& now) { across += now.rate_of_deformation.zz / 4000; });
  const auto& s = point.now().stress;
  return {s.xx / Y, s.yy / Y, s.xy / Y, point.now().state.equivalent_plastic_strain, across};
}

}  // namespace

TEST_CASE("plane stress: elastic, it is Hooke's law with E/(1 - nu^2)") {
  const Elastic elastic{.density = 2800, .youngs_modulus = E, .poissons_ratio = nu};
  const auto check = [](const auto& material) {
    MaterialPoint point{material};
    const double xx = 1e-3, yy = -4e-4, gamma = 6e-4;
    const auto& now = point.step(gradient(xx, yy, gamma), 1);
    const double normal = E / (1 - nu * nu);
    CHECK(now.stress.xx == Approx(normal * (xx + nu * yy)).epsilon(1e-14));
    CHECK(now.stress.yy == Approx(normal * (yy + nu * xx)).epsilon(1e-14));
    CHECK(now.stress.xy == Approx(G * gamma).epsilon(1e-14));
    CHECK(now.rate_of_deformation.zz == Approx(-nu / (1 - nu) * (xx + yy)).epsilon(1e-14));
    CHECK(point.moduli().normal == Approx(normal).epsilon(1e-14));
    CHECK(point.moduli().shear == Approx(G).epsilon(1e-14));
    CHECK(material.density() == 2800);
  };
  check(PlaneStress{elastic});
  check(PlaneStress{Solid{linear, ElasticStrength{G}}});
  check(aluminium(0));
}

TEST_CASE("plane stress: the tension test of a hardening metal, and it contracts alike in width and thickness") {
  // sigma = Y + H e_p with e_p = strain - sigma/E
  const double H = 1e9;
  for (const double strain : {1e-3, 0.1, -0.1}) {
    MaterialPoint point{aluminium(H)};
    point.run(uniaxial_stress({.strain = strain, .steps = 100}), [&](const auto& now) {
      const double e = std::abs(now.strain().xx), yield = (Y + H * e) / (1 + H / E);
      CHECK(std::abs(now.stress.xx) == Approx(std::min(E * e, yield)).epsilon(1e-6));  // ln of steps of 1e-3, squared
      CHECK(std::abs(now.stress.yy) < 1e-13 * K);
      CHECK(now.rate_of_deformation.zz == Approx(now.rate_of_deformation.yy).epsilon(1e-9));
    });
  }
}

TEST_CASE("plane stress: perfectly plastic and hardening aluminium along straight paths") {
  struct Reference {
    double xx, yy, gamma, H;
    Strained end;
  };
  for (const auto& path : {Reference{.01, 0, 0, 0, {1.153669, .534583, 0, .00648418, -.00759464}},
                           Reference{.01, 0, 0, 1e9, {1.177782, .542771, 0, .00638032, -.00754862}},
                           Reference{.01, -.005, .01, 0, {.842035, -.037590, .293208, .00752722, -.00385386}}}) {
    const auto check = [&](const auto& material) {
      const Strained now = strained(material, path.xx, path.yy, path.gamma);
      CHECK(std::abs(now.sx - path.end.sx) < 1e-6);  // the last digit of the values
      CHECK(std::abs(now.sy - path.end.sy) < 1e-6);
      CHECK(std::abs(now.sxy - path.end.sxy) < 1e-6);
      CHECK(std::abs(now.plastic_strain - path.end.plastic_strain) < 1e-8);
      CHECK(std::abs(now.normal_strain - path.end.normal_strain) < 1e-8);
    };
    check(aluminium(path.H));
    check(PlaneStress{Solid{linear, LinearHardening{G, Y, path.H}}});
  }
}

TEST_CASE("plane stress: a law's own way to the increment and the general one agree") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double H : {0.0, 1e9, 50e9}) {
    const auto own = aluminium(H);
    const PlaneStress general{Solid{linear, LinearHardening{G, Y, H}}};
    decltype(own)::State<double> a;
    decltype(general)::State<double> b;
    for (int i = 0; i < 200; ++i) {
      const double size = 0.1 * std::pow(unit(random), 4);
      const Rate rate{{size * unit(random), size * unit(random), size * unit(random)}};
      const auto difference = own.stress(a, rate, 1.0) - general.stress(b, rate, 1.0);
      const double trial = 2 * G * 0.1, rounding = 2.3e-16;
      CHECK(std::sqrt(double_dot(difference, difference)) < 200 * rounding * trial);
      CHECK(a.equivalent_plastic_strain == Approx(b.equivalent_plastic_strain).epsilon(1e-12));
    }
  }
}

TEST_CASE("plane stress: dual numbers give the tangent of a step, as differences do") {
  using D = Dual<double, 1>;
  const auto check = [](const auto& law) {
    const PlaneStress material{Solid{linear, law}};
    using M = std::decay_t<decltype(material)>;
    const double dt = 1e-6, h = 1e-8;
    for (const double yy : {-5e-3, 0.0, 2e-3, 1e-2}) {
      const auto after = [&](const auto& xx) {
        using T = std::decay_t<decltype(xx)>;
        typename M::template State<T> state;
        return material.stress(state, {{(1 / dt) * xx, T(yy / dt), T(3e-3 / dt)}}, dt).yy;
      };
      const double difference = (after(1e-2 + h) - after(1e-2 - h)) / (2 * h);
      CHECK(std::abs(after(D::variable(1e-2, 0)).derivative(0) - difference) <
            1e-7 * E);  // rounding gives 1e-2 epsilon/h of E
    }
  };
  check(VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9});
  check(LinearHardening{G, Y, 1e9});
  check(RateVonMises{G, Y, 1e9, .1, .25});
}

TEST_CASE(
    "plane stress: it flows along the normal of the ellipse, so that the work is elastic energy and plastic work") {
  // radially, where the implicit step is exact
  const JohnsonCook law{.shear_modulus = G,
                        .A = Y,
                        .B = 300e6,
                        .n = .4,
                        .C = .02,
                        .initial_temperature = 300,
                        .melting_temperature = 900,
                        .heating = 4e-7};
  MaterialPoint point{PlaneStress{Solid{linear, law}}};
  double plastic_work = 0, work = 0;
  auto last = point.now();
  point.run({{Segment{.duration = 1e-3, .steps = 1000, .velocity_gradient = gradient(0, 0, 200)}}},
            [&](const auto& now) {
              const double q = equivalent_stress(deviator(now.stress)),
                           dl = now.state.equivalent_plastic_strain - last.state.equivalent_plastic_strain;
              plastic_work += q * dl;
              work += 0.5 * double_dot(now.stress + last.stress, now.rate_of_deformation) * 1e-6;
              if (dl > 0)
                CHECK(q == Approx(law.flow_stress(now.state.equivalent_plastic_strain, dl / 1e-6,
                                                  300 + last.state.temperature_rise))
                               .epsilon(1e-12));
              last = now;
            });
  CHECK(last.state.temperature_rise == Approx(law.heating * plastic_work).epsilon(1e-12));
  const double tau = last.stress.xy;
  CHECK(work == Approx(plastic_work + tau * tau / (2 * G)).epsilon(1e-3));  // the trapezoid against the end of the step
}

TEST_CASE("plane stress: what has failed carries nothing and feels nothing") {
  const VonMises strength{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9};
  const auto check = [](const auto& material, const auto& fails) {
    MaterialPoint point{material};
    point.run({{Segment{.duration = 1, .velocity_gradient = gradient(.1, -.05, .02)}}}, [&](const auto& now) {
      CHECK((material.intact(now.state) == 0) == fails(now));
      if (fails(now)) CHECK(now.stress.matrix().norm() == 0);
    });
    CHECK(material.intact(point.now().state) == 0);
    const auto before = point.now();
    point.step(gradient(.3, .3, .3), 1);
    CHECK(point.now().stress.matrix().norm() == 0);
    CHECK(point.now().rate_of_deformation.zz == 0);
    CHECK(point.now().state.equivalent_plastic_strain == before.state.equivalent_plastic_strain);
  };
  check(PlaneStress{Solid{linear, strength, FailureStrain{.05}}},
        [](const auto& now) { return now.state.equivalent_plastic_strain >= .05; });
  bool reached = false;
  check(PlaneStress{Solid{linear, strength, UltimateStress{Y + .05 * 1e9}}},
        [&](const auto& now) { return reached = reached || now.state.equivalent_plastic_strain >= .05; });
}

TEST_CASE("plane stress: what the solid has to say is said") {
  CHECK(aluminium(0).warning().empty());
  CHECK(aluminium(-1e9).warning() == VonMises{G, Y, -1e9}.warning());
}
