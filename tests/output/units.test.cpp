#include <strike/output/units.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
struct Copper {
  Units units;
  double E, rho, sigma_y, velocity;  // as a deck in these units gives them
};
}  // namespace

TEST_CASE("units: the Taylor bar in five systems is one bar") {
  // Copper of the standard problem; the table gives seven digits.
  for (const Copper& copper :
       {Copper{units::si, 1.17e11, 8930, 4e8, 227}, Copper{units::mm_ms_kg, 117, 8.93e-6, 0.4, 227},
        Copper{units::mm_s_t, 117000, 8.93e-9, 400, 227000}, Copper{units::cm_us_g, 1.17, 8.93, 0.004, 0.0227},
        Copper{units::in_s_lbf, 1.696941e7, 8.356028e-4, 58015.1, 8937.008}}) {
    CAPTURE(copper.units.name);
    CHECK(copper.E * copper.units.pascal() == Approx(1.17e11).epsilon(5e-7));
    CHECK(copper.rho * copper.units.kilogram_per_cubic_metre() == Approx(8930).epsilon(5e-7));
    CHECK(copper.sigma_y * copper.units.pascal() == Approx(4e8).epsilon(1e-6));
    CHECK(copper.velocity * copper.units.metre / copper.units.second == Approx(227).epsilon(5e-7));
  }
}

TEST_CASE("units: names of derived units are sizes of derived units") {
  CHECK(units::mm_ms_kg.newton() == Approx(1e3));                             // kN
  CHECK(units::mm_ms_kg.joule() == Approx(1));                                // J
  CHECK(units::mm_s_t.newton() == Approx(1));                                 // N
  CHECK(units::mm_s_t.joule() == Approx(1e-3));                               // mJ
  CHECK(units::cm_us_g.pascal() == Approx(1e11));                             // Mbar
  CHECK(units::cm_us_g.joule() == Approx(1e5));                               // Mbar cm3
  CHECK(units::in_s_lbf.newton() == Approx(4.4482216152605).epsilon(1e-14));  // lbf, exact by definition
  CHECK(units::in_s_lbf.pascal() == Approx(6894.757293168).epsilon(1e-12));   // psi
}
