// What one whole step of the driver costs per element, copper with von Mises strength and linear hardening, all
// energies, one thread: hexahedra with viscous hourglass control, bulk viscosity and the rotation of Hughes and Winget
// at mid-step; tetrahedra with a blend of pressures; plates of one layer with Simpson's five points, hourglass control,
// the warping of Belytschko, Wong and Chiang, and drilling. per_element is the time of one element and step: 100,000
// elements stream from memory, 1350 stay in the cache.
#include <array>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/section/layered.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"
#include "../support/stretched_sheet.hpp"

namespace {

using namespace strike;

const Solid copper{bench::linear, bench::hardening};

template <class Run>
void steps(benchmark::State& state, Run run, std::size_t elements) {
  for (int i = 0; i < 8; ++i) run.step();  // until they yield
  for (auto _ : state) run.step();
  state.counters["per_element"] = benchmark::Counter(
      static_cast<double>(elements), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class T>
void hexahedra(benchmark::State& state, std::array<Index, 3> cells) {
  const Mesh bar = bench::bar(cells);
  steps(state,
        Explicit{Scene{bar.nodes, Part{Hex8{ViscousHourglass{}}, copper, bar.hexahedra}, bench::Squeeze{}}, {}, in<T>},
        bar.hexahedra.size());
}

template <class T, class Pressure>
void tetrahedra(benchmark::State& state, std::array<Index, 3> cells) {
  const Mesh bar = tetrahedralized(bench::bar(cells));
  steps(state, Explicit{Scene{bar.nodes, Part{Tet4{Pressure{}}, copper, bar.tetrahedra}, bench::Squeeze{}}, {}, in<T>},
        bar.tetrahedra.size());
}

template <class T>
void plates(benchmark::State& state, std::array<Index, 2> cells) {
  const Mesh sheet = bench::sheet(cells);
  const Homogeneous section{PlaneStress{copper}, bench::sheet_thickness};
  steps(state, Explicit{Scene{sheet.nodes, Part{Plate4{}, section, sheet.quadrilaterals}, bench::Stretch{}}, {}, in<T>},
        sheet.quadrilaterals.size());
}

template <class T>
void in_both_sizes(const std::string& number) {
  const auto add = [&](const char* elements, auto run, auto cells) {
    benchmark::RegisterBenchmark((number + elements).c_str(), run, cells);
  };
  add("/100000 hexahedra", hexahedra<T>, std::array<Index, 3>{40, 50, 50});
  add("/1350 hexahedra", hexahedra<T>, std::array<Index, 3>{5, 6, 45});
  add("/100000 tetrahedra", tetrahedra<T, NodalPressure>, std::array<Index, 3>{25, 26, 26});
  add("/100000 tetrahedra, own pressure", tetrahedra<T, ElementPressure>, std::array<Index, 3>{25, 26, 26});
  add("/100000 plates", plates<T>, std::array<Index, 2>{400, 250});
  add("/1350 plates", plates<T>, std::array<Index, 2>{45, 30});
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
