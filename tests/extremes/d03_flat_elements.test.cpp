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
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, {0, 0, rate * nodes.x(i).z()});
  }
};

const Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
                   VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
constexpr double thickness = 1e-3;

/// A free brick 1 : 1 : 1e-3 that is compressed at tr D = rate when it begins: all its energy is in its highest mode.
template <class E>
auto flat_brick(const E& element, double rate, double step_factor) {
  const Mesh mesh = box({.lower = {0, 0, -thickness / 2}, .size = {1, 1, thickness}});
  return Explicit{Scene{mesh.nodes, Part{element, copper, mesh.hexahedra}, Crush{rate}},
                  ExplicitOptions{.step_factor = step_factor}, in<double>};
}

/// A bulk viscosity of the length V^(1/3), 100 times that of the step.
struct OfTheWrongLength : BulkViscosity {
  template <class T>
  T pressure(const T& wave_modulus, const T& tau, const T& rate) const {
    return BulkViscosity::pressure(wave_modulus, T(100.0 * tau), rate);
  }
};

template <class E>
void rests(const E& element) {
  const double c = std::sqrt((130e9 + 4. / 3 * 43.3e9) / 8930);
  for (const double step_factor : {0.1, 0.9}) {
    auto run = flat_brick(element, -1e3, step_factor);
    const double first = run.energy().initial;
    double before = first;
    while (run.time() < 200 * thickness / c) {
      run.step();
      CHECK(run.dt() >= 0.5 * step_factor * thickness / c);
      const double left = run.energy().kinetic + run.energy().internal + run.energy().hourglass;
      if (step_factor < 0.5) CHECK(left <= before + 1e-3 * first);  // resistance lags half a step
      before = left;
    }
    CHECK(before < 0.05 * first);
    CHECK(std::abs(run.energy().error()) < 0.01);
  }
}

}  // namespace

TEST_CASE("D3: a flat element is damped by the length of its own step: its energy falls, its step does not") {
  rests(Hex8{});
  rests(Hex8Full{});
}

TEST_CASE("D3: with the length V^(1/3) in the bulk viscosity the same element blows up, and the driver says so") {
  auto run = flat_brick(Hex8{ViscousHourglass{}, HughesWinget{}, OfTheWrongLength{}}, -1e3, 0.9);
  CHECK_THROWS_WITH(run.until(200 * thickness / 5e3), Catch::Matchers::ContainsSubstring("use a smaller step factor"));
}
