#include <strike/element/bulk_viscosity.hpp>
#include <strike/scalar/dual.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("bulk viscosity is rho l |tr D| (C0^2 l |tr D| + C1 c) in compression, and none in expansion") {
  const double rho = 2, c = 3, l = 0.5, C0 = 1.5, C1 = 0.06;
  const BulkViscosity viscosity{.quadratic = C0, .linear = C1};
  for (const double rate : {1e-6, 0.1, 1.0, 30.0}) {
    CHECK(viscosity.pressure(rho * c * c, l / c, -rate) == Approx(rho * l * rate * (C0 * C0 * l * rate + C1 * c)));
    CHECK(viscosity.pressure(rho * c * c, l / c, rate) == 0);
  }
  CHECK(viscosity.pressure(rho * c * c, l / c, 0.0) == 0);
}

TEST_CASE("bulk viscosity both ways is the same in compression, and in expansion rho l tr D C1 c against it") {
  const double rho = 2, c = 3, l = 0.5, C1 = 0.06;
  const BulkViscosityBothWays both{.linear = C1};
  for (const double rate : {1e-6, 0.1, 1.0, 30.0}) {
    CHECK(both.pressure(rho * c * c, l / c, -rate) == BulkViscosity{}.pressure(rho * c * c, l / c, -rate));
    CHECK(both.pressure(rho * c * c, l / c, rate) == Approx(-rho * l * rate * C1 * c));
    CHECK(both.coefficient(18.0, 0.2, rate) == BulkViscosity{}.coefficient(18.0, 0.2, rate));
  }
  BulkViscosityBothWays::State<double> state;
  CHECK(both.work(state, -2.0, 0.1) == Approx(0.5 * 2 * 0.1));  // expansion dissipates
}

TEST_CASE("the coefficient that the stable step knows is the slope of the pressure") {
  using D = Dual<double, 1>;
  const BulkViscosity viscosity;
  for (const double rate : {-1e-3, -0.1, -5.0})
    CHECK(viscosity.coefficient(18.0, 0.2, rate) ==
          Approx(-viscosity.pressure(D(18.0), D(0.2), D::variable(rate, 0)).derivative(0)));
  CHECK(viscosity.coefficient(18.0, 0.2, 1.0) == Approx(0.06 * 18 * 0.2));  // the next step may be compression
}

TEST_CASE("what it dissipates is booked by the mean of the pressures before and after a step") {
  const BulkViscosity viscosity;
  BulkViscosity::State<double> state;
  CHECK(viscosity.work(state, 2.0, -0.1) == Approx(0.5 * 2 * 0.1));
  CHECK(viscosity.work(state, 4.0, -0.1) == Approx(0.5 * (2 + 4) * 0.1));
  CHECK(viscosity.work(state, 0.0, 0.1) == Approx(-0.5 * 4 * 0.1));
  NoBulkViscosity::State<double> none;
  CHECK(NoBulkViscosity{}.work(none, 1.0, -1.0) == 0);
  CHECK(NoBulkViscosity{}.pressure(1.0, 1.0, -1.0) == 0);
}
