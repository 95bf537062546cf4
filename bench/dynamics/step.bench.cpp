// What one whole step of the driver costs per element: copper with von Mises strength and linear hardening, viscous
// hourglass control, bulk viscosity, the rotation of Hughes and Winget at mid-step, all energies, one thread.
// per_element is the time of one element and step: 100,000 hexahedra stream from memory, 1350 stay in the cache.
#include <array>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"

namespace {

using namespace strike;

template <class T>
void steps(benchmark::State& state, std::array<Index, 3> cells) {
  const Mesh bar = bench::bar(cells);
  const Solid copper{bench::linear, bench::hardening};
  Explicit run{Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra}, bench::Squeeze{1e3}}, {}, in<T>};
  for (auto _ : state) run.step();
  state.counters["per_element"] =
      benchmark::Counter(static_cast<double>(bar.hexahedra.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class T>
void in_both_sizes(const std::string& number) {
  for (const auto& [size, cells] : {std::pair{"/100000", std::array<Index, 3>{40, 50, 50}},  //
                                    {"/1350", {5, 6, 45}}})
    benchmark::RegisterBenchmark((number + size).c_str(), steps<T>, cells);
}

const bool registered = [] {
  in_both_sizes<double>("double");
  in_both_sizes<Pack<double, 4>>("Pack<double, 4>");
  in_both_sizes<Pack<double, 8>>("Pack<double, 8>");
  in_both_sizes<Pack<double, 16>>("Pack<double, 16>");
  in_both_sizes<Pack<float, 8>>("Pack<float, 8>");
  in_both_sizes<Pack<float, 16>>("Pack<float, 16>");
  return true;
}();

}  // namespace
