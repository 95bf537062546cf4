// What a step of a section costs per plate: the resultants and the moduli that the time step asks for. By rule, by
// layer, by shear policy. The growth of the thickness is not asked for, and so costs nothing.
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/material.hpp>
#include <strike/section.hpp>

namespace {

using namespace strike;

constexpr std::size_t plates = 1024;
constexpr double dt = 1e-7;

template <class T, class M>
void price(benchmark::State& bench, const M& section) {
  using State = typename M::template State<T>;
  std::vector<State> states(plates / lanes<T>);
  std::vector<PlateKinematics::Rate<T>> rates(states.size());
  for (auto& state : states)
    if constexpr (requires { section.begin(state); }) section.begin(state);
  for (std::size_t b = 0; b < rates.size(); ++b) {
    const T rate = T(1e5 * (0.5 + double(b) / plates));
    rates[b] = {{rate, 0.3 * rate, 0.1 * rate}, {1e3 * rate, -1e3 * rate, 2e2 * rate}, {rate, rate}};
  }
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < states.size(); ++b) {
      const PlateKinematics::Stress<T> s = section.stress(states[b], rates[b], dt);
      sum += s.force.xx + s.force.yy + s.force.xy + s.moment.xx + s.moment.yy + s.moment.xy + s.shear(0) + s.shear(1) +
             section.moduli(states[b], rates[b]).wave();
      rates[b].membrane = T(-1.0) * rates[b].membrane, rates[b].curvature = T(-1.0) * rates[b].curvature;
    }
    benchmark::DoNotOptimize(sum);
  }
  bench.counters["per_plate"] =
      benchmark::Counter(plates, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class M>
void prices(const std::string& name, const M& section) {
  const auto add = [&](const std::string& number, auto run) {
    benchmark::RegisterBenchmark((name + "/" + number).c_str(), [=](benchmark::State& bench) { run(bench, section); });
  };
  add("double", price<double, M>);
  add("Pack<double, 8>", price<Pack<double, 8>, M>);
  add("Pack<float, 16>", price<Pack<float, 16>, M>);
}

const bool registered = [] {
  const PlaneStress glass{Elastic{.density = 2500, .youngs_modulus = 70e9, .poissons_ratio = .22}};
  const PlaneStress soft{Elastic{.density = 1070, .youngs_modulus = 70e6, .poissons_ratio = .45}};
  const PlaneStress aluminium{
      Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9}, VonMises{.shear_modulus = 27e9, .yield_stress = 300e6}}};
  const Layer face{glass, 3e-3}, core{soft, .76e-3};
  prices("elastic Simpson<3>", Homogeneous{glass, 3e-3, Simpson<3>{}});
  prices("elastic Simpson<5>", Homogeneous{glass, 3e-3});
  prices("elastic Gauss<10>", Homogeneous{glass, 3e-3, Gauss<10>{}});
  prices("elastic 3 layers", Layered{face, core, face});
  prices("elastic 3 layers InstantaneousShear", Layered{face, core, face, InstantaneousShear{}});
  prices("elastic 5 layers", Layered{face, core, face, core, face});
  prices("elastic 5 Plies", Layered{Plies{face, 5}});
  prices("VonMises Simpson<3>", Homogeneous{aluminium, 3e-3, Simpson<3>{}});
  prices("VonMises Simpson<5>", Homogeneous{aluminium, 3e-3});
  prices("VonMises Simpson<9>", Homogeneous{aluminium, 3e-3, Simpson<9>{}});
  return true;
}();

}  // namespace
