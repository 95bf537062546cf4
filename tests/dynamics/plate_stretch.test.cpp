// Plates that stretch and do not thin are told, once.
#include <string>

#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr Elastic soft{.density = 1, .youngs_modulus = 1, .poissons_ratio = 0.3};

/// A sheet of 2 x 2 plates whose end at x = 2 moves so far.
template <class E, class Law, class... More>
auto pulled(const E& element, const Law& law, double end, const More&... more) {
  const Mesh sheet = rectangle({.size = {2.0, 2.0}, .cells = {2, 2}});
  const auto at = [&](double x) { return nodes_where(sheet.nodes, on_plane(Axis::x, x)); };
  Explicit run{Scene{sheet.nodes, Part{element, Homogeneous{PlaneStress{law}, 0.1}, sheet.quadrilaterals, more...},
                     Clamped{at(0)}, PrescribedVelocity{Axis::x, at(2), [](double) { return 0.01; }}},
               ExplicitOptions{.print_warnings = false}};
  run.until(end / 0.01);
  return run.warnings();
}

}  // namespace

TEST_CASE("plates that stretch by more than 5 % at constant thickness are told with the largest of them") {
  CHECK(pulled(Plate4{}, soft, 0.05).empty());
  const auto warnings = pulled(Plate4{}, soft, 0.3);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], ContainsSubstring("Plates of part 0 have stretched to up to 1.1") &&
                              ContainsSubstring("ThicknessChange{}"));
  CHECK(pulled(MassScaled{Plate4{}, 0.1}, soft, 0.3).size() == 1);
  CHECK(pulled(Plate4{PlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}}, soft, 0.3).empty());
}

TEST_CASE("plates that have failed or are deleted stretch no more") {
  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 0.8}, VonMises{.shear_modulus = 0.4, .yield_stress = 1},
                      UltimateStress{0.01}};
  CHECK(pulled(Plate4{}, brittle, 0.3).empty());
  CHECK(pulled(Plate4{}, brittle, 0.3, Erosion{}).size() == 1);  // that they are deleted
}
