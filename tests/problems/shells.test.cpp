#include "problems/shells.hpp"

#include "support/catch.hpp"

using namespace strike;
using namespace strike::shells;

// Shells at rest within 2 % of their references; finer meshes stand in docs/verification.md.

TEST_CASE("Scordelis and Lo's roof sinks as the reference") {
  const double coarse = scordelis_lo(8, Plate4{}).displacement, fine = scordelis_lo(16, Plate4{}).displacement;
  CHECK(fine == Approx(1).margin(0.02));
  CHECK(std::abs(fine - 1) < std::abs(coarse - 1));
}

TEST_CASE("the pinched cylinder gives way as the reference") {
  const double coarse = pinched_cylinder(16, Plate4{}).displacement, fine = pinched_cylinder(32, Plate4{}).displacement;
  CHECK(fine == Approx(1).margin(0.02));
  CHECK(std::abs(fine - 1) < std::abs(coarse - 1));
}

TEST_CASE("the twisted beam bends as the reference, but not without an account of its warp") {
  CHECK(twisted_beam(4, TipLoad::in_plane, Plate4{}).displacement == Approx(1).margin(0.02));
  CHECK(twisted_beam(4, TipLoad::across, Plate4{}).displacement == Approx(1).margin(0.02));
  const Plate4 flat{PlateHourglass{}, NoWarping{}};
  CHECK(std::abs(twisted_beam(4, TipLoad::in_plane, flat).displacement - 1) > 0.05);
  // Belytschko, Lin and Tsay's own, whose nodes are free to drill
  const Plate4 plain{PlateHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}};
  CHECK(twisted_beam(2, TipLoad::in_plane, plain).displacement > 10);
}

TEST_CASE("forces on a roof at rest balance: what it stores is half of what its weight does") {
  const Rest rest = scordelis_lo(8, Plate4{});
  CHECK(std::abs(rest.balance) < 2e-3);  // each of some fifty stops counts a half step's kick as the whole
  CHECK(rest.hourglass < 0.02);
}
