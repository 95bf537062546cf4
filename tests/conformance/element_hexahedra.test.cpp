#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "conformance/element.hpp"

using namespace strike;
using testing::conforms;

TEST_CASE("conformance: Hex8") { conforms(Hex8{}); }
TEST_CASE("conformance: Hex8 with viscous hourglass control") { conforms(Hex8{ViscousHourglass{}}); }
TEST_CASE("conformance: Hex8 with stiffness hourglass control, of Jaumann") {
  conforms(Hex8{StiffnessHourglass{}, Jaumann{}});
}
TEST_CASE("conformance: Hex8 without hourglass control or bulk viscosity, measured at the end of the step") {
  conforms(Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}, EndStep{}}, testing::FiniteRotations::strain);
}
TEST_CASE("conformance: Hex8Full") { conforms(Hex8Full{}); }

static_assert(Element<Hex8<>> && Element<Hex8Full<>>);
