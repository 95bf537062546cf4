#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using testing::conforms_as_plate;

TEST_CASE("conformance: Plate4") { conforms_as_plate(Plate4{}); }
TEST_CASE("conformance: Plate4 that knows no warp and drills freely") {
  conforms_as_plate(Plate4{PlateHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}});
}
TEST_CASE("conformance: Plate4 without hourglass control, whose thickness changes") {
  conforms_as_plate(Plate4{NoPlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}, FreeDrilling{}});
}
TEST_CASE("conformance: Plate4 with rigid offsets, whose thickness changes") {
  conforms_as_plate(Plate4{PlateHourglass{}, RigidOffset{}, ThicknessChange{}});
}
TEST_CASE("conformance: Plate4 with the physical hourglass control") { conforms_as_plate(Plate4{PhysicalHourglass{}}); }
TEST_CASE("conformance: Plate4 with the physical hourglass control, flat, drilling freely, of changing thickness") {
  conforms_as_plate(Plate4{PhysicalHourglass{}, NoWarping{}, ThicknessChange{}, FreeDrilling{}});
}

TEST_CASE("conformance: Plate3") { conforms_as_plate(Plate3{}); }
TEST_CASE("conformance: Plate3 whose thickness changes and whose nodes drill freely") {
  conforms_as_plate(Plate3{ThicknessChange{}, FreeDrilling{}});
}

static_assert(Element<Plate4<>, std::decay_t<decltype(testing::metal_plate)>>);
static_assert(!Element<Plate4<>, Elastic>);
static_assert(Element<Plate3<>, std::decay_t<decltype(testing::metal_plate)>>);
static_assert(!Element<Plate3<>, Elastic>);
