// D29: simple shear to gamma = 10 of a hypoelastic solid with Jaumann's rate: it oscillates, exactly as it should.
#include <cmath>

#include <strike/material/elastic.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {
constexpr Elastic solid{.density = 1, .youngs_modulus = 2.6, .poissons_ratio = .3};  // G = 1
}

TEST_CASE("D29: tau = sin 10 = -.544021 G, s11 = 1 - cos 10 = 1.839072 G in steps of dg = 9e-4") {
  MaterialPoint point{solid};
  point.run(simple_shear({.strain = 10, .steps = 11112}), [](const auto&) {});
  CHECK(std::abs(point.now().stress.xy - -.544021) < 1e-6);
  CHECK(std::abs(point.now().stress.xx - 1.839072) < 1e-6);
  CHECK(std::abs(point.now().stress.yy + 1.839072) < 1e-6);
  CHECK(std::abs(point.now().stress.zz) < 1e-12);
}

TEST_CASE("D29: at gamma = 1, .841471 and .459698, and tau passes zero at pi") {
  MaterialPoint point{solid};
  point.run(simple_shear({.strain = 1, .steps = 1100}), [](const auto&) {});
  CHECK(std::abs(point.now().stress.xy - .841471) < 1e-6);
  CHECK(std::abs(point.now().stress.xx - .459698) < 1e-6);
  point.run(simple_shear({.strain = 2.141592653589793, .steps = 2400}), [](const auto&) {});
  CHECK(std::abs(point.now().stress.xy) < 1e-6);
}

TEST_CASE("D29: the first-order rotation grows by exp(g dg/2) and needs its price in steps") {
  const double dg = 1e-4;
  MaterialPoint point{solid, Jaumann{}};
  point.run(simple_shear({.strain = 10, .steps = 100000}), [](const auto&) {});
  CHECK(point.now().stress.xy == Approx(std::sin(10)).epsilon(0).margin(std::exp(10 * dg / 2) - 1));
  CHECK(point.now().stress.xx == Approx(1 - std::cos(10)).epsilon(0).margin(std::exp(10 * dg / 2) - 1));
}
