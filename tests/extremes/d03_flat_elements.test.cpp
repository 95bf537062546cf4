#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// The nodes begin as if the plane z = 0 were approached at a constant rate.
struct Crush {
  double rate;  // of the volume [1/s]

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.v(i).z() = rate * nodes.x(i).z();
  }
};

template <class E>
void crushes_quietly(const E& element, double thickness, double rate) {
  const Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
                     VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
  const Mesh brick = box({.lower = {0, 0, -thickness / 2}, .size = {1, 1, thickness}});
  Explicit run{Scene{brick.nodes, Part{element, copper, brick.hexahedra}, Crush{rate}}, {}, in<double>};
  const double c = std::sqrt((130e9 + 4. / 3 * 43.3e9) / 8930);

  double before = run.energy().initial;
  for (int step = 0; step < 500; ++step) {
    run.step();
    CHECK(run.dt() >= 0.3 * thickness / c);
    const double left = run.energy().kinetic + run.energy().internal + run.energy().hourglass;
    CHECK(left <= before * (1 + 1e-4));
    before = left;
  }
  CHECK(std::abs(run.energy().error()) < 1e-3);
  CHECK(run.energy().bulk_viscosity > 0);
  CHECK(run.energy().bulk_viscosity < 0.5 * run.energy().initial);  // damped, not smothered
}

}  // namespace

TEST_CASE(
    "D3: a flat element is damped by the length of its own step: the energy falls monotonically, the step does not") {
  for (const double thickness : {1.0, 1e-3}) {
    const double c_by_l = 4e3 / thickness;
    for (const double rate : {-1e3, -0.01 * c_by_l}) {
      CAPTURE(thickness, rate);
      crushes_quietly(Hex8{}, thickness, rate);
      crushes_quietly(Hex8Full{}, thickness, rate);
    }
  }
}
