#include <strike/dynamics/every.hpp>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("Taylor bar, 1350 hexahedra: X3D's table and the history of an independent code") {
  struct Row {
    double time, length, radius, kinetic;  // us, mm, mm, share of the kinetic energy once the foot has stopped
  };
  // An independent Flanagan-Belytschko code on the same mesh, with V^(1/3) as the length in its bulk viscosity.
  const std::vector<Row> history{{0, 32.400, 3.200, 1.000}, {10, 30.143, 5.015, .811}, {20, 28.084, 6.018, .617},
                                 {30, 26.229, 6.657, .426}, {40, 24.620, 7.001, .262}, {50, 23.291, 7.092, .140},
                                 {60, 22.292, 7.089, .057}, {70, 21.679, 7.089, .011}, {80, 21.523, 7.088, .0005}};
  auto run = taylor::bar(taylor::mm_ms_kg, 3, 50, in<Pack<double>>);
  double drift = 0;
  std::size_t row = 0;
  run.until(taylor::mm_ms_kg.end,
            Every{0.01,
                  [&] {
                    REQUIRE(row < history.size());
                    INFO("at " << history[row].time << " us");
                    CHECK(taylor::length(run) == Approx(history[row].length).epsilon(1e-3));
                    CHECK(taylor::radius(run) == Approx(history[row].radius).epsilon(2e-3));
                    const Energy& e = run.energy();
                    CHECK(e.kinetic / (e.initial - e.contact) == Approx(history[row].kinetic).margin(2e-3));
                    ++row;
                  }},
            [&] { drift = std::max(drift, std::abs(run.energy().error())); });
  CHECK(row == history.size());

  // Between X3D and DYNA3D (Brockman and Held 1991): 21.47, 7.081 and 7.034, 2.95.
  CHECK(taylor::length(run) == Approx(21.47).margin(0.08));
  CHECK(taylor::radius(run) == Approx(7.08).margin(0.08));
  CHECK(taylor::plastic_strain(run) == Approx(2.92).margin(0.12));
  // The independent code with the length of the time step in its bulk viscosity, as here.
  CHECK(taylor::length(run) == Approx(21.517).epsilon(1e-3));
  CHECK(taylor::radius(run) == Approx(7.081).epsilon(1e-3));
  CHECK(taylor::plastic_strain(run) == Approx(2.877).epsilon(1e-3));

  CHECK(drift < 1e-3);
  CHECK(run.energy().hourglass < 0.02 * run.energy().initial);
  CHECK(run.energy().contact == Approx(run.energy().initial / (2 * 50)).epsilon(1e-3));  // the foot of 50 layers stops
  CHECK(run.energy().initial == Approx(239.8 / 4).epsilon(0.02));  // pi R^2 L rho v^2/2 [J], less the polygon's gaps
}
