// D27: a gas compressed ten times keeps p V^gamma, to 5 % in 10 steps and .01 % in 10 000.
#include <cmath>

#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/fluid.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

constexpr double heats = 1.4;

/// p V^gamma at the end over that at the start, V as it falls from 1 to 1/10 in so many steps.
template <class Volume>
double adiabat(int steps, Volume volume) {
  MaterialPoint point{Fluid{IdealGas{.density = 1.2, .gamma = heats, .initial_energy = 2.5e5}}};
  Matrix3<double> F = Matrix3<double>::Identity();
  for (int i = 1; i <= steps; ++i) {
    F(0, 0) = volume(double(i) / steps);
    point.deform(F, 1e-6);
  }
  return -point.now().stress.xx / 1e5 * std::pow(point.now().relative_volume(), heats);
}

double geometric(double t) { return std::pow(10, -t); }
double linear(double t) { return 1 - 0.9 * t; }

}  // namespace

TEST_CASE("D27: gas compressed ten times in 10 steps and in 10 000") {
  for (const auto volume : {geometric, linear}) {
    CHECK(std::abs(adiabat(10, volume) - 1) < 0.05);
    CHECK(std::abs(adiabat(10000, volume) - 1) < 1e-4);
  }
}

TEST_CASE("D27: the error is of second order in the step") {
  const double coarse = adiabat(100, geometric) - 1, fine = adiabat(200, geometric) - 1;
  CHECK(coarse / fine == Approx(4).epsilon(0.01));  // the next term is (ln 10/100)^2 of it
}
