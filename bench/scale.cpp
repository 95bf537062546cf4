// How the start and the step scale with the number of elements: hexahedra of copper with linear hardening as in
// step.bench, from what the second-level cache holds to what streams from memory, on one core and two.
//
//   OMP_PROC_BIND=true build/bench/bench/scale
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/material/solid.hpp>
#include <strike/motion/openmp.hpp>

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

const Solid copper{linear, hardening};

template <class... Policies>
auto squeezed(const Mesh& mesh, Policies... policies) {
  return Explicit{
      Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, copper, mesh.hexahedra}, Squeeze{1e3}}, {}, policies...};
}
std::size_t steps(const Mesh& mesh) { return std::max<std::size_t>(4, 1000000 / mesh.hexahedra.size()); }
template <class Run>
void advance(Run& run, std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) run.step();
}
constexpr int repeats = 9;

template <class Numbers>
Figures measure(const Mesh& mesh, Numbers numbers) {
  const double elements = static_cast<double>(mesh.hexahedra.size());
  const double before = memory();
  std::optional<decltype(squeezed(mesh, numbers))> run;
  const double start = cpu_seconds([&] { run.emplace(squeezed(mesh, numbers)); });
  const double held = memory() - before;

  std::vector<double> times;
  for (int repeat = 0; repeat < repeats; ++repeat)
    times.push_back(cpu_seconds([&] { advance(*run, steps(mesh)); }) / static_cast<double>(steps(mesh)));
  return {held / elements, 1e9 * start / elements, 1e9 * median(times) / elements};
}

/// How many times as quick two threads are as one, by the clock on the wall, in turns.
double speed_up(const Mesh& mesh) {
  auto one = squeezed(mesh);
  auto two = squeezed(mesh, OpenMP{.threads = 2});
  std::vector<double> ratios;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double alone = wall_seconds([&] { advance(one, steps(mesh)); });
    ratios.push_back(alone / wall_seconds([&] { advance(two, steps(mesh)); }));
  }
  return median(ratios);
}

}  // namespace

int main() {
  std::fputs(head({"hexahedra", "bytes, double", "float", "mixed", "start [steps]", "step [ns]: double", "float",
                   "mixed", "two threads"})
                 .c_str(),
             stdout);
  for (const Index n : {159u, 100u, 46u, 22u, 11u}) {  // the largest first: memory that was given back is not asked for
    const Mesh mesh = bar({n, n, n});
    const Figures wide = measure(mesh, in<Pack<double>>), narrow = measure(mesh, in<Pack<float>>),
                  mixed = measure(mesh, in<Pack<float>, double>);
    const auto bytes = [](const Figures& f) { return f.bytes > 0 ? formatted("%.0f", f.bytes) : ""; };
    std::fputs(row({std::to_string(mesh.hexahedra.size()), bytes(wide), bytes(narrow), bytes(mixed),
                    formatted("%.0f", wide.start / wide.step), formatted("%.1f", wide.step),
                    formatted("%.1f", narrow.step), formatted("%.1f", mixed.step), formatted("%.2f x", speed_up(mesh))})
                   .c_str(),
               stdout);
    std::fflush(stdout);
  }
}
