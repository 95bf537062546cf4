// What the hexahedron costs per element, piece by piece and with each of its policies, in each scalar: nodal values in
// registers' reach, without gather and scatter (bench/dynamics/step has the whole step).
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

namespace {

using namespace strike;

constexpr std::size_t elements = 1024;
constexpr double dt = 1e-7;

const Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
                   VonMises{.shear_modulus = 43.3e9, .yield_stress = 40e6, .hardening_modulus = 100e6}};
using Copper = std::remove_const_t<decltype(copper)>;

/// Bricks of a millimetre, each distorted in its own way, whose nodes move at some 10 m/s.
template <class T>
struct Bricks {
  std::vector<Nodal<T, 8>> x{elements / lanes<T>}, v{elements / lanes<T>};

  Bricks() {
    unsigned random = 1;
    const auto number = [&] { return static_cast<double>((random = random * 1664525u + 1013904223u) >> 8) / 0x1p24; };
    for (std::size_t e = 0; e < elements; ++e)
      for (int i = 0; i < 24; ++i) {
        constexpr int corner[3] = {0b01100110, 0b11001100, 0b11110000};
        const double at = (corner[i % 3] >> (i / 3)) & 1;
        const auto put = [&](Nodal<T, 8>& a, double value) {
          set_lane(a(i), e % lanes<T>, static_cast<RealOf<T>>(value));
        };
        put(x[e / lanes<T>], 1e-3 * (at + 0.2 * number()));
        put(v[e / lanes<T>], 20 * number() - 10);
      }
  }
};

void per_element(benchmark::State& bench) {
  bench.counters["per_element"] =
      benchmark::Counter(elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The modes of positions and velocities, the gradient operator, and the velocity gradient.
template <class T>
void gradient(benchmark::State& bench) {
  const Bricks<T> bricks;
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < bricks.x.size(); ++b) {
      const Hex8Gradient<T> g(to_modes<T>(bricks.x[b]));
      sum += g.gradient_of(to_modes<T>(bricks.v[b]), T(1.0 / g.volume)).sum();
    }
    benchmark::DoNotOptimize(sum);
  }
  per_element(bench);
}

/// Resistance, work and critical rate of an hourglass control.
template <class T, class Hourglass>
void hourglass(benchmark::State& bench, const Hourglass& control) {
  const Bricks<T> bricks;
  std::vector<typename Hourglass::template State<T>> states(bricks.x.size());
  const HourglassElement<T> element{T(8930.0), T(1e-9), T(1e-3), T(1.1e5), T(190e9),
                                    T(43.3e9), T(dt),   {},      T(1.5e6), T(5e5)};
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < bricks.v.size(); ++b) {
      const HourglassModes<T> rates{bricks.v[b].col(0), bricks.v[b].col(1), bricks.v[b].col(2), bricks.v[b].col(3)};
      const HourglassModes<T> Q = control.resistance(states[b], element, rates);
      sum += Q[0](0) + Q[1](1) + Q[2](2) + Q[3](0) + control.work(element, Q, rates) + control.critical_rate(element);
    }
    benchmark::DoNotOptimize(sum);
  }
  per_element(bench);
}

/// The whole element: from nodal positions and velocities to nodal forces, energies and the stable step.
template <class T, class E>
void advance(benchmark::State& bench, const E& element) {
  const Bricks<T> bricks;
  std::vector<typename E::template State<Copper, T>> states(bricks.x.size());
  for (std::size_t b = 0; b < bricks.x.size(); ++b) element.begin(states[b], copper, bricks.x[b]);
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < bricks.x.size(); ++b) {
      const auto response = element.advance(states[b], copper, bricks.x[b], bricks.v[b], dt);
      sum += response.force.sum() + response.internal_work + response.hourglass_work + response.bulk_viscosity_work +
             response.critical_rate;
    }
    benchmark::DoNotOptimize(sum);
  }
  per_element(bench);
}

template <class T>
void in(const std::string& number) {
  const auto add = [&](const std::string& name, auto run) {
    benchmark::RegisterBenchmark((name + "/" + number).c_str(), run);
  };
  add("gradient", gradient<T>);
  add("viscous hourglass", [](auto& bench) { hourglass<T>(bench, ViscousHourglass{}); });
  add("stiffness hourglass", [](auto& bench) { hourglass<T>(bench, StiffnessHourglass{}); });
  add("Hex8", [](auto& bench) { advance<T>(bench, Hex8{ViscousHourglass{}}); });
  add("Hex8, physical hourglass", [](auto& bench) { advance<T>(bench, Hex8{PhysicalHourglass{}}); });
  add("Hex8, stiffness hourglass", [](auto& bench) { advance<T>(bench, Hex8{StiffnessHourglass{}}); });
  add("Hex8, no hourglass control", [](auto& bench) { advance<T>(bench, Hex8{NoHourglass{}}); });
  add("Hex8, Jaumann", [](auto& bench) { advance<T>(bench, Hex8{ViscousHourglass{}, Jaumann{}}); });
  add("Hex8, no bulk viscosity", [](auto& bench) {
    advance<T>(bench, Hex8{ViscousHourglass{}, HughesWinget{}, NoBulkViscosity{}});
  });
  add("Hex8, end of step", [](auto& bench) {
    advance<T>(bench, Hex8{ViscousHourglass{}, HughesWinget{}, BulkViscosity{}, EndStep{}});
  });
  add("Hex8Full", [](auto& bench) { advance<T>(bench, Hex8Full{}); });
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
