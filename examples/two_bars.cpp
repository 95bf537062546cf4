// Two equal steel bars meet at 10 m/s: a wave runs through each and back, and they part with velocities exchanged.
//
//   bash examples/run two_bars
//   bash examples/run two_bars law=penalty fraction=0.1
//   bash examples/run two_bars cells=1000
#include "support/two_bars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

using Bars = examples::TwoBars;
const double stress = Bars::stress, duration = Bars::duration, speed = Bars::speed, area = Bars::width * Bars::width;

/// Records of a run.
struct Record {
  History history{
      "history.csv",
      {{"time", "ms"}, {"contact stress", "MPa"}, {"velocity of bar 1", "m/s"}, {"velocity of bar 2", "m/s"}}};
  std::vector<double> times{}, stresses{}, first{}, second{};
  double begin = 0, end = 0,  // of half the stress
      impulse = 0, largest_error = 0;

  template <class Run, class Touch>
  void watch(const Bars& bars, const Run& run, const Touch& contact) {
    const double force = std::abs(contact.force().x());
    if (force > stress * area / 2) (begin == 0 ? begin : end) = run.time();
    impulse = std::abs(contact.impulse().x());
    largest_error = std::max(largest_error, std::abs(run.energy().error()));
    times.push_back(1e3 * run.time()), stresses.push_back(1e-6 * force / area);
    first.push_back(bars.left_velocity(run)), second.push_back(bars.right_velocity(run));
    history.row(times.back(), stresses.back(), first.back(), second.back());
  }
};

void report(const Record& record, double momentum) {
  Results results;
  results.add({"mean stress", 1e-6 * record.impulse / (area * duration), "MPa", 1e-6 * stress, 1e-6 * 0.01 * stress,
               "rho c v/2"});
  results.add({"duration", 1e3 * (record.end - record.begin), "ms", 1e3 * duration, 1e3 * 0.02 * duration, "2 L/c"});
  results.add({"velocity of bar 1 after", record.first.back(), "m/s", -speed / 2, 0.02 * speed, "exchanged"});
  results.add({"velocity of bar 2 after", record.second.back(), "m/s", speed / 2, 0.02 * speed, "exchanged"});
  results.add({"momentum", momentum / (Bars::steel.density * area * Bars::length * speed), "1", 0, 1e-12, "balance"});
  results.add({"energy error", record.largest_error, "1", 0, 5e-3, "balance"});
  std::printf("\nTwo equal bars\n\n");
  results.print();
  results.write("results.csv");

  Chart chart{{.title = "Two equal bars",
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "contact stress", .unit = "MPa"}}};
  chart.curve("simulated", record.times, record.stresses);
  const double t0 = 1e3 * record.begin, t1 = t0 + 1e3 * duration, s = 1e-6 * stress;
  chart.curve("plane waves", std::vector{0., t0, t0, t1, t1, record.times.back()}, std::vector{0., 0., s, s, 0., 0.});
  chart.write("stress.svg");
  std::printf("\nWritten: results.csv, history.csv, stress.svg\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const unsigned cells = options.count("cells", 200);
    const std::string law = options.choice("law", {"kinematic", "penalty"});
    const double fraction = options.number("fraction", 0.2);
    options.check();

    const Bars bars(cells, 1e-5);
    const auto meet = [&](const auto& normal_law) {
      Explicit run{Scene{bars.mesh.nodes, Part{Hex8{}, Bars::steel, bars.mesh.hexahedra},
                         InitialVelocityField{bars.approach()},
                         Contact{TwoWay{bars.left_end(), bars.right_end()}, normal_law}}};
      Record record;
      run.until(1.5 * duration, [&] { record.watch(bars, run, run.template item<2>()); });
      report(record, run.momentum().x());
    };
    if (law == "kinematic")
      meet(Kinematic{});
    else
      meet(Penalty{.fraction = fraction});
  });
}
