#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/verify/laminate.hpp>

#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using namespace strike::verify;
using namespace strike::testing;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("laminate: exact deflections of the strips, to their seven digits") {
  for (const SandwichRow& row : sandwiches) {
    CAPTURE(row.strip.name, row.softness);
    const Laminate laminate = row.strip.laminate(row.softness);
    const double w = laminate.deflection(row.strip.p());
    CHECK(w == Approx(row.deflection).epsilon(1e-6));
    const double p = row.strip.p(), bending = laminate.transverse_shear().bending;
    CHECK(w * p * p * p * p * bending == Approx(row.by_kirchhoff).epsilon(5e-4));  // as printed
  }
}

TEST_CASE("laminate: exact frequencies of the strips") {
  struct Row {
    const Sandwich& strip;
    double softness, frequency, fsdt;
  };
  for (const auto& [strip, softness, f, fsdt] : {Row{glass, 1, 190.8552, 1.000},
                                                 {glass, 1e2, 187.8205, .9999},
                                                 {glass, 1e3, 167.6537, .9925},
                                                 {glass, 1e4, 112.3316, .8346},
                                                 {glass, 1e5, 84.5152, .397},
                                                 {thick, 1, 7931.00, .9993},
                                                 {thick, 1e2, 5211.81, .968},
                                                 {thick, 1e3, 2874.59, .700},
                                                 {thick, 1e4, 2272.51, .289}}) {
    CAPTURE(strip.name, softness);
    const double exact = strip.laminate(softness).angular_frequency(strip.p()) / (2 * pi);
    CHECK(exact == Approx(f).epsilon(1.1e-6));
    const auto section = strip.section(softness);
    const MindlinPlate plate{section.transverse_shear().bending, section.shear_stiffness(), section.density(),
                             section.rotary_inertia()};
    CHECK(plate.angular_frequency(strip.p()) / (2 * pi * exact) == Approx(fsdt).margin(6e-4));
  }
}

TEST_CASE("laminate: square plates under uniform pressure") {
  struct Row {
    Laminate laminate;
    double D, K, exact, fsdt, kirchhoff;
  };
  for (const Row& row : {Row{glass.laminate(1e2), 1.89100311e6, 6389.9654, 18.42570, 18.4385, 17.4008},
                         {glass.laminate(1e3), 1.89097421e6, 657.65673, 26.56519, 27.4830, 17.4011},
                         {glass.laminate(1e4), 1.89097132e6, 65.958293, 63.72019, 117.925, 17.4011},
                         {Laminate({{12.7, 2400, .38}}), 4.78817906e5, 9202.8986, 69.33859, 69.4419, 68.7212}}) {
    const TransverseShear<double> shear = row.laminate.transverse_shear();
    CHECK(shear.bending == Approx(row.D).epsilon(1e-8));
    CHECK(shear.stiffness == Approx(row.K).epsilon(1e-8));
    const auto centre = [](auto w) { return rectangle_deflection(300, 300, w); };
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(centre([&](double p) { return row.laminate.deflection(p); }) ==
          Approx(row.exact).epsilon(2e-5));  // the series of the reference ends earlier
    CHECK(centre([&](double p) { return MindlinPlate{row.D, row.K}.deflection(p); }) == Approx(row.fsdt).epsilon(1e-5));
    CHECK(centre([&](double p) {
            return MindlinPlate{row.D, inf}.deflection(p);
          }) == Approx(row.kirchhoff).epsilon(1e-5));
  }
}

TEST_CASE("laminate: no layer matters by how it is cut, and stresses obey equilibrium and the faces") {
  const Laminate whole({{10, 70000, .3}}), cut(std::vector<ElasticLayer>(100, {0.1, 70000, .3}));
  for (const double length : {1000., 100., 10.}) {
    const double p = pi / length;
    CHECK(cut.deflection(p) == Approx(whole.deflection(p)).epsilon(1e-8));
  }
  for (const double softness : {1., 1e3, 1e6}) {
    const double p = glass.p();
    const auto profile = glass.laminate(softness).profile(p, 100);
    const LaminateWave &bottom = profile.front(), &top = profile.back();
    CHECK(bottom.S == 0);
    CHECK(bottom.T == 0);
    CHECK(top.S == Approx(1).epsilon(1e-7));
    CHECK(top.T == Approx(0).margin(1e-7 / (p * 6.76)));
    double shear_force = 0, work = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
      const auto &a = profile[i - 1], &b = profile[i];
      if (a.layer != b.layer) {
        CHECK(a.T == b.T);
        continue;
      }
      shear_force += (b.z - a.z) * (a.T + b.T) / 2;
      work += (b.z - a.z) * ((b.T - a.T) / (b.z - a.z) + p * (a.X + b.X) / 2);  // tau_xz,z + sigma_x,x = 0
    }
    CHECK(std::abs(shear_force) == Approx(1 / p).epsilon(2e-4));  // trapezoids over 100 parts
    CHECK(work == Approx(0).margin(1e-3 / p));
  }
}

TEST_CASE("laminate: layers that cannot be are refused") {
  CHECK_THROWS_WITH(Laminate({{1, 70000, .3}, {0, 70000, .3}}),
                    Catch::Matchers::ContainsSubstring(
                        "the thickness of ElasticLayer, in layer 1 of a Laminate, is 0; it must be positive"));
  CHECK_THROWS_WITH(Laminate({}), Catch::Matchers::ContainsSubstring("has no layer"));
}
