// The price of parts that are chosen when the run starts: a step of 10,000 hexahedra in a scene that names its part,
// and in one that holds a list of AnyPart. Run both many times, one after the other, and compare the least times:
// --benchmark_repetitions=20 --benchmark_enable_random_interleaving=true
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/elastic.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"

namespace {

using namespace strike;

using Copper = decltype(Solid{bench::linear, bench::hardening});
using Hexahedron = Hex8<ViscousHourglass>;
using Any = AnyPart<PartOf<Tet4<>, Elastic>, PartOf<Hexahedron, Elastic>, PartOf<Hexahedron, Copper>>;

const Mesh bar = bench::bar({10, 10, 100});
const Part part{Hexahedron{}, Copper{bench::linear, bench::hardening}, bar.hexahedra};

template <class Run>
void steps(benchmark::State& state, Run run) {
  for (auto _ : state) run.step();
}

BENCHMARK_CAPTURE(steps, named, Explicit{Scene{bar.nodes, part, bench::Squeeze{}}});
BENCHMARK_CAPTURE(steps, chosen, Explicit{Scene{bar.nodes, std::vector<Any>{part}, bench::Squeeze{}}});

}  // namespace
