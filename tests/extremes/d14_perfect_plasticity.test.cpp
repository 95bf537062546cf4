// D14: hardening of zero and below.
#include <cmath>

#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {
Solid<LinearEos, VonMises> steel(double H) {
  return {LinearEos{.density = 7850, .bulk_modulus = 200e9 / 1.2},
          VonMises{.shear_modulus = 200e9 / 2.6, .yield_stress = 400e6, .hardening_modulus = H}};
}
}  // namespace

TEST_CASE("D14: perfect plasticity stays on its surface to 1e-12 along uniaxial strain, shear and back") {
  MaterialPoint point{steel(0)};
  const Path path = uniaxial_strain({.strain = -0.1, .steps = 200}) + simple_shear({.strain = 1, .steps = 200}) +
                    uniaxial_strain({.strain = 0.2, .steps = 200});
  int plastic = 0;
  double last = 0;
  point.run(path, [&](const auto& now) {
    if (now.state.equivalent_plastic_strain > last) {
      CHECK(equivalent_stress(deviator(now.stress)) == Approx(400e6).epsilon(1e-12));
      ++plastic;
    }
    last = now.state.equivalent_plastic_strain;
  });
  CHECK(plastic > 590);
}

TEST_CASE("D14: perfect plasticity in plane stress stays on its ellipse to 1e-12") {
  const auto check = [](const auto& material) {
    MaterialPoint point{material};
    int plastic = 0;
    double last = 0;
    point.run(uniaxial_strain({.strain = -0.1, .steps = 200}) + simple_shear({.strain = 1, .steps = 200}) +
                  uniaxial_strain({.strain = 0.2, .steps = 200}),
              [&](const auto& now) {
                if (now.state.equivalent_plastic_strain > last) {
                  CHECK(equivalent_stress(deviator(now.stress)) == Approx(400e6).epsilon(1e-12));
                  ++plastic;
                }
                last = now.state.equivalent_plastic_strain;
              });
    CHECK(plastic > 590);
  };
  check(PlaneStress{steel(0)});
  check(ZeroNormalStress{steel(0)});
}

TEST_CASE("D14: softening follows its line down to nothing and stays there") {
  MaterialPoint point{steel(-1e9)};
  point.run(simple_shear({.strain = 1, .steps = 1000}), [](const auto& now) {
    const double e = now.state.equivalent_plastic_strain;
    if (e > 0)
      CHECK(equivalent_stress(deviator(now.stress)) == Approx(std::max(0.0, 400e6 - 1e9 * e)).margin(1e-12 * 400e6));
  });
  CHECK(point.now().state.equivalent_plastic_strain > 0.4);
  CHECK(equivalent_stress(deviator(point.now().stress)) < 1e-12 * 400e6);
}

TEST_CASE("D14: softening in plane stress, down to nothing, in small steps and in one") {
  for (const double H : {-1e9, -20e9, -150e9})
    for (const std::size_t steps : {1u, 7u, 1000u}) {
      MaterialPoint point{PlaneStress{steel(H)}};
      Segment segment{.duration = 1, .steps = steps};
      segment.velocity_gradient << 0.6, 0.3, 0, 0, -0.1, 0, 0, 0, 0;
      point.run({{segment}}, [&](const auto& now) {
        const double e = now.state.equivalent_plastic_strain;
        if (e > 0)
          CHECK(equivalent_stress(deviator(now.stress)) ==
                Approx(std::max(0.0, 400e6 + H * e)).margin(1e-12 * 200e9 * (1 / double(steps) + 1e-3)));
      });
      CHECK(equivalent_stress(deviator(point.now().stress)) < 1e-12 * 200e9);
    }
}
