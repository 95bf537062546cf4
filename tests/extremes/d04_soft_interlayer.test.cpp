// D4: cores 1 to 1e6 times softer than their faces.
#include <numbers>

#include <strike/section/layered.hpp>

#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using namespace strike::verify;
using namespace strike::testing;

TEST_CASE("D4: the shear force of a soft interlayer is K gamma to 1e-10, and it bends as exact elasticity when cured") {
  for (const double softness : {1e2, 1e3, 1e4, 1e5, 1e6}) {
    CAPTURE(softness);
    const auto section = glass.section(softness, EffectiveShear{.length = glass.length});
    decltype(section)::State<double> state{};
    const auto s = section.stress(state, {{}, {}, {1e-6, 0}}, 1);
    CHECK(s.shear(0) == Approx(section.shear_stiffness() * 1e-6).epsilon(1e-10));

    const double p = glass.p();
    const MindlinPlate plate{section.transverse_shear().bending, section.shear_stiffness()};
    CHECK(plate.deflection(p) / glass.laminate(softness).deflection(p) == Approx(1).margin(0.01));
  }
}

TEST_CASE("D4: a section tells when its error exceeds 5 % over a half wave, such as four elements") {
  const auto tells = [](double softness, double size) { return !glass.section(softness).warning(4 * size).empty(); };
  CHECK_FALSE(tells(1e2, 75));
  CHECK_FALSE(tells(1e3, 75));  // 1.5 %
  CHECK(tells(1e4, 75));        // 44 %
  CHECK(tells(1e3, 30));        // the same lay-up on finer meshes
  CHECK_FALSE(tells(1, 10));
  CHECK(Homogeneous{PlaneStress{Elastic{1, 70000, .22}}, 6.0}.warning(1).empty());

  CHECK(glass.section(1e4).warning().empty());  // no length is known
  const std::string warning = glass.section(1e4, EnergyShear{.length = 300}).warning();
  CHECK_THAT(warning, Catch::Matchers::ContainsSubstring(
                          "over a half wave of 300 its shear stiffness K = 65.9583 deflects 43.58"));
  CHECK_THAT(warning, Catch::Matchers::ContainsSubstring("EffectiveShear{.length = 300}"));
  CHECK(glass.section(1e4, EffectiveShear{.length = 300}).warning(300).empty());
  CHECK(!glass.section(1e4, InstantaneousShear{.length = 300}).warning().empty());
}
