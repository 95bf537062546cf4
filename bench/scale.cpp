// How the start and the step scale with the number of elements: hexahedra of copper with linear hardening as in
// step.bench, from what the second-level cache holds to what streams from memory, on one core.
//
//   build/bench/bench/scale
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <optional>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/material/solid.hpp>

#include "support/clock.hpp"
#include "support/materials.hpp"
#include "support/squeezed_bar.hpp"
#include "support/table.hpp"
#include <unistd.h>

namespace {

using namespace strike;
using namespace bench;

/// What the process holds [bytes], as Linux tells.
double memory() {
  double all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Of an element.
struct Figures {
  double bytes;        ///< that the run holds, its nodes with it
  double start, step;  ///< [ns of CPU]
};

template <class Numbers>
Figures measure(const std::array<Index, 3>& cells, Numbers numbers) {
  const double elements = double(cells[0]) * cells[1] * cells[2];
  const Mesh mesh = bar(cells);
  const Solid copper{linear, hardening};
  const auto begin = [&] {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, copper, mesh.hexahedra}, Squeeze{1e3}}, {}, numbers};
  };
  const double before = memory();
  std::optional<decltype(begin())> run;
  const double start = cpu_seconds([&] { run.emplace(begin()); });
  const double held = memory() - before;

  const int steps = std::max(4, static_cast<int>(1e6 / elements));
  std::vector<double> times;
  for (int repeat = 0; repeat < 9; ++repeat)
    times.push_back(cpu_seconds([&] {
      for (int i = 0; i < steps; ++i) run->step();
    }));
  return {held / elements, 1e9 * start / elements, 1e9 * median(times) / steps / elements};
}

}  // namespace

int main() {
  std::fputs(head({"hexahedra", "bytes an element, double", "float", "mixed", "start [steps]", "step [ns], double",
                   "float", "mixed"})
                 .c_str(),
             stdout);
  for (const Index n : {159u, 100u, 46u, 22u, 10u}) {  // the largest first: memory that was given back is not asked for
    const std::array<Index, 3> cells{n, n, n};
    const Figures wide = measure(cells, in<Pack<double>>), narrow = measure(cells, in<Pack<float>>),
                  mixed = measure(cells, in<Pack<float>, double>);
    std::fputs(
        row({formatted("%.0f", double(n) * n * n), formatted("%.0f", wide.bytes), formatted("%.0f", narrow.bytes),
             formatted("%.0f", mixed.bytes), formatted("%.0f", wide.start / wide.step), formatted("%.1f", wide.step),
             formatted("%.1f", narrow.step), formatted("%.1f", mixed.step)})
            .c_str(),
        stdout);
    std::fflush(stdout);
  }
}
