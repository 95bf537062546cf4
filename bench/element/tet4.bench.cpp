// What the tetrahedron costs per element with each of its policies, in each scalar: nodal values in registers' reach,
// without gather and scatter (bench/dynamics/step has the whole step).
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/element/tet4.hpp>

#include "../support/materials.hpp"

namespace {

using namespace strike;

constexpr std::size_t elements = 1024;
constexpr double dt = 1e-7;

const Solid copper{bench::linear, bench::hardening};
using Copper = std::remove_const_t<decltype(copper)>;

/// Corners of cubes of a millimetre, each distorted in its own way, whose nodes move at some 10 m/s.
template <class T>
struct Corners {
  std::vector<Nodal<T, 4>> x{elements / lanes<T>}, v{elements / lanes<T>};

  Corners() {
    unsigned random = 1;
    const auto number = [&] { return static_cast<double>((random = random * 1664525u + 1013904223u) >> 8) / 0x1p24; };
    for (std::size_t e = 0; e < elements; ++e)
      for (int i = 0; i < 12; ++i) {
        const auto put = [&](Nodal<T, 4>& a, double value) {
          set_lane(a(i), e % lanes<T>, static_cast<RealOf<T>>(value));
        };
        put(x[e / lanes<T>], 1e-3 * ((i == 3 || i == 7 || i == 11) + 0.2 * number()));
        put(v[e / lanes<T>], 20 * number() - 10);
      }
  }
};

template <class T, class E>
void advance(benchmark::State& bench, const E& element) {
  const Corners<T> corners;
  std::vector<typename E::template State<Copper, T>> states(corners.x.size());
  for (std::size_t b = 0; b < states.size(); ++b) element.begin(states[b], copper, corners.x[b]);
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < states.size(); ++b) {
      const auto response = element.advance(states[b], copper, corners.x[b], corners.v[b], dt);
      sum += response.force.sum() + response.internal_work + response.bulk_viscosity_work + response.critical_rate;
    }
    benchmark::DoNotOptimize(sum);
  }
  bench.counters["per_element"] =
      benchmark::Counter(elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class T>
void in(const std::string& number) {
  const auto add = [&](const std::string& name, auto run) {
    benchmark::RegisterBenchmark((name + "/" + number).c_str(), run);
  };
  add("Tet4, blend of pressures", [](auto& bench) { advance<T>(bench, Tet4{}); });
  add("Tet4, own pressure", [](auto& bench) { advance<T>(bench, Tet4{ElementPressure{}}); });
  add("Tet4, own pressure, Jaumann", [](auto& bench) { advance<T>(bench, Tet4{ElementPressure{}, Jaumann{}}); });
  add("Tet4, own pressure, no bulk viscosity", [](auto& bench) {
    advance<T>(bench, Tet4{ElementPressure{}, HughesWinget{}, NoBulkViscosity{}});
  });
}

const bool registered = [] {
  in<double>("double");
  in<Pack<double, 4>>("Pack<double, 4>");
  in<Pack<double, 8>>("Pack<double, 8>");
  in<Pack<float, 16>>("Pack<float, 16>");
  return true;
}();

}  // namespace
