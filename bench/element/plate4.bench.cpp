// The price per element of plates of four and of three nodes with each of their policies, in each scalar: nodal values
// in registers' reach, without gather and scatter (bench/dynamics/step has the whole step, bench/material/section the
// section alone).
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>

#include "../support/materials.hpp"

namespace {

using namespace strike;

constexpr std::size_t elements = 1024;
constexpr double dt = 1e-7;

/// Plates of a millimetre, each distorted and warped in its own way, whose nodes move at some 10 m/s.
template <class T, int n>
struct Plates {
  std::vector<Nodal<T, n>> x{elements / lanes<T>};
  std::vector<Nodal<T, 2 * n>> v{elements / lanes<T>};

  Plates() {
    unsigned random = 1;
    const auto number = [&] { return static_cast<double>((random = random * 1664525u + 1013904223u) >> 8) / 0x1p24; };
    for (std::size_t e = 0; e < elements; ++e)
      for (int i = 0; i < 6 * n; ++i) {
        constexpr int corner[3] = {n == 4 ? 0b0110 : 0b010, n == 4 ? 0b1100 : 0b100, 0};
        const auto put = [&](auto& a, double value) {
          set_lane(a[e / lanes<T>](i), e % lanes<T>, static_cast<RealOf<T>>(value));
        };
        if (i < 3 * n) put(x, 1e-3 * (((corner[i % 3] >> (i / 3)) & 1) + 0.2 * number()));
        put(v, (i < 3 * n ? 20 : 2e4) * (number() - 0.5));
      }
  }
};

/// From nodal positions and velocities to nodal forces, energies and the stable step.
template <class T, class E, class S>
void advance(benchmark::State& bench, const E& element, const S& section) {
  const Plates<T, E::nodes> plates;
  std::vector<typename E::template State<S, T>> states(plates.x.size());
  for (std::size_t b = 0; b < plates.x.size(); ++b) element.begin(states[b], section, plates.x[b]);
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < plates.x.size(); ++b) {
      const auto response = element.advance(states[b], section, plates.x[b], plates.v[b], dt);
      sum += response.force.sum() + response.internal_work + response.hourglass_work + response.critical_rate;
    }
    benchmark::DoNotOptimize(sum);
  }
  bench.counters["per_element"] =
      benchmark::Counter(elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class T>
void in(const std::string& number) {
  const auto add = [&](const std::string& name, const auto& element, const auto& section) {
    benchmark::RegisterBenchmark((name + "/" + number).c_str(),
                                 [=](auto& bench) { advance<T>(bench, element, section); });
  };
  constexpr double h = 3e-4;
  const PlaneStress copper{Solid{bench::linear, bench::hardening}};
  const Homogeneous usual{copper, h};
  constexpr PlateHourglass hourglass;
  constexpr BelytschkoWongChiang warping;
  add("Plate4", Plate4{}, usual);
  add("Plate3", Plate3{}, usual);
  add("Plate3, elastic", Plate3{}, Homogeneous{PlaneStress{bench::elastic}, h});
  add("Plate3, FreeDrilling", Plate3{ConstantThickness{}, FreeDrilling{}}, usual);
  add("Plate4, elastic", Plate4{}, Homogeneous{PlaneStress{bench::elastic}, h});
  add("Plate4, Simpson<3>", Plate4{}, Homogeneous{copper, h, Simpson<3>{}});
  add("Plate4, two layers", Plate4{}, Layered{Layer{copper, h / 2}, Layer{copper, h / 2}});
  add("Plate4, no hourglass control", Plate4{NoPlateHourglass{}}, usual);
  add("Plate4, NoWarping", Plate4{hourglass, NoWarping{}}, usual);
  add("Plate4, RigidOffset", Plate4{hourglass, RigidOffset{}}, usual);
  add("Plate4, ThicknessChange", Plate4{hourglass, warping, ThicknessChange{}}, usual);
  add("Plate4, FreeDrilling", Plate4{hourglass, warping, ConstantThickness{}, FreeDrilling{}}, usual);
}

const bool registered = [] {
  in<double>("double");
  in<Pack<double, 4>>("Pack<double, 4>");
  in<Pack<double, 8>>("Pack<double, 8>");
  in<Pack<double, 16>>("Pack<double, 16>");
  in<Pack<float, 16>>("Pack<float, 16>");
  return true;
}();

}  // namespace
