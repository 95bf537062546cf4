// Volumetric locking of tetrahedra, by the Taylor bar.
#include <strike/element/tet4.hpp>

#include "problems/taylor_tetrahedra.hpp"
#include "support/catch.hpp"

using namespace strike;

// An independent code: 4.6 mm with their own pressure and 7.10 with that of their nodes, on 3 x 36 (Bonet and Burton
// 1998: 5.2 and 7.0); other codes' hexahedra 7.03 to 7.13. The bench verification has 3 x 36 and 3 x 50.
TEST_CASE("D6: a Taylor bar of tetrahedra locks with their own pressure, and spreads as others with that of nodes") {
  const auto radius = [](const auto& element) {
    auto run = taylor::bar_of_tetrahedra(element, 2, 24);
    run.until(taylor::mm_ms_kg.end);
    CHECK(std::abs(run.energy().error()) < 1e-3);
    return taylor::radius(run);
  };
  const double own = radius(Tet4{ElementPressure{}}), blend = radius(Tet4{NodalPressure{0.9}}),
               nodal = radius(Tet4{NodalPressure{1.0}});
  CHECK(own < 5.5);
  CHECK(nodal == Approx(7.1).margin(0.1));
  CHECK((own < blend && blend < 0.9 * nodal));  // a tenth of their own pressure is enough to lock: for fluids only
}
