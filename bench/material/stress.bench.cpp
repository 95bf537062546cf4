// What a step of each material costs per point, in each scalar: the stress, then the moduli that the time step asks
// for. Every point flows in every step. `tiny` is the same motion at rates below the least normal number, which must
// cost at most three times as much (D24); `flushed` the same where the processor takes such numbers for zero.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/material.hpp>
#include <strike/scalar/flush_denormals.hpp>

namespace {

using namespace strike;

constexpr std::size_t points = 1024;
constexpr double dt = 1e-7;

enum class Motion { usual, tiny, flushed };

/// A shear that swings, so that points yield, unload and yield again; each a little out of step with the next.
template <class T, class M>
void price(benchmark::State& bench, const M& material, Motion motion) {
  using Real = RealOf<T>;
  using State = typename M::template State<T>;
  const double tiny = 100 * static_cast<double>(std::numeric_limits<Real>::denorm_min());
  const double rate = motion == Motion::usual ? 2e-3 / dt : tiny;

  std::vector<State> states(points / lanes<T>);
  std::vector<typename M::Kinematics::template Rate<T>> rates(states.size());
  for (auto& state : states)
    if constexpr (requires { material.begin(state); }) material.begin(state);
  for (std::size_t i = 0; i < points; ++i) {
    auto& rate_i = rates[i / lanes<T>];
    auto& D = rate_i.rate_of_deformation;
    const double phase = double(i) / points;
    set_lane(D.xx, i % lanes<T>, static_cast<Real>(rate * (0.5 - phase)));
    set_lane(D.yy, i % lanes<T>, static_cast<Real>(-rate * (0.4 - phase)));
    set_lane(D.xy, i % lanes<T>, static_cast<Real>(rate * phase));
    if constexpr (requires { rate_i.relative_volume; })
      set_lane(rate_i.relative_volume, i % lanes<T>, static_cast<Real>(0.99));
  }
  std::optional<FlushDenormals> flush;
  if (motion == Motion::flushed) flush.emplace();
  for (auto _ : bench) {
    T sum = T(0.0);
    for (std::size_t b = 0; b < states.size(); ++b) {
      sum += material.stress(states[b], rates[b], dt).xx + material.moduli(states[b], rates[b]).wave();
      rates[b].rate_of_deformation = T(-1.0) * rates[b].rate_of_deformation;
    }
    benchmark::DoNotOptimize(sum);
  }
  bench.counters["per_point"] =
      benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class M>
void prices(const std::string& name, const M& material) {
  const auto add = [&](const std::string& number, auto run, Motion motion) {
    benchmark::RegisterBenchmark((name + "/" + number).c_str(),
                                 [=](benchmark::State& bench) { run(bench, material, motion); });
  };
  add("double", price<double, M>, Motion::usual);
  add("Pack<double, 4>", price<Pack<double, 4>, M>, Motion::usual);
  add("Pack<double, 8>", price<Pack<double, 8>, M>, Motion::usual);
  add("Pack<double, 16>", price<Pack<double, 16>, M>, Motion::usual);
  add("Pack<float, 8>", price<Pack<float, 8>, M>, Motion::usual);
  add("Pack<float, 16>", price<Pack<float, 16>, M>, Motion::usual);
  add("tiny/Pack<double, 8>", price<Pack<double, 8>, M>, Motion::tiny);
  add("flushed/Pack<double, 8>", price<Pack<double, 8>, M>, Motion::flushed);
}

/// A law without its own way to the plastic increment.
struct Voce {
  double shear_modulus, yield_stress, saturation, slope;
  template <class T>
  T flow_stress(const T& e) const {
    return yield_stress + saturation * (1.0 - exp(-slope * e));
  }
};

const bool registered = [] {
  const LinearEos linear{.density = 8930, .bulk_modulus = 130e9};
  const PolynomialEos polynomial{.density = 8930, .C1 = 130e9, .C2 = 120e9, .C3 = 100e9, .C4 = 2, .C5 = 2};
  const GruneisenEos gruneisen{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99};
  const VonMises von_mises{.shear_modulus = 43.3e9, .yield_stress = 40e6, .hardening_modulus = 100e6};

  const Elastic elastic{.density = 8930, .youngs_modulus = 117e9, .poissons_ratio = .35};
  const RateVonMises rate_von_mises{.shear_modulus = 43.3e9,
                                    .yield_stress = 40e6,
                                    .hardening_modulus = 100e6,
                                    .rate_factor = .111,
                                    .rate_exponent = .25};
  const Voce voce{43.3e9, 40e6, 200e6, 10};
  const JohnsonCook johnson_cook{.shear_modulus = 43.3e9,
                                 .A = 90e6,
                                 .B = 292e6,
                                 .n = .31,
                                 .C = .025,
                                 .m = 1.09,
                                 .initial_temperature = 294,
                                 .melting_temperature = 1356,
                                 .heating = 2.6e-7};

  const PowerHardening power{.shear_modulus = 43.3e9, .coefficient = 600e6, .exponent = .2, .initial_strain = .01};
  const TabulatedHardening table{43.3e9, {{0, 40e6}, {.01, 60e6}, {.05, 90e6}, {.2, 130e6}, {.5, 180e6}, {2, 240e6}}};
  const ZerilliArmstrong zerilli_armstrong{
      .shear_modulus = 43.3e9, .C0 = 65e6, .C2 = 890e6, .C3 = .0028, .C4 = .000115, .heating = 2.6e-7};
  const Prony<1> prony{.shear_modulus = 43.3e9, .terms = {{.share = .9, .time = 1e-6}}};

  prices("Elastic", elastic);
  prices("LinearEos VonMises", Solid{linear, von_mises});
  prices("LinearEos RateVonMises", Solid{linear, rate_von_mises});
  prices("LinearEos Voce", Solid{linear, voce});
  prices("LinearEos JohnsonCook", Solid{linear, johnson_cook});
  prices("LinearEos PowerHardening", Solid{linear, power});
  prices("LinearEos TabulatedHardening", Solid{linear, table});
  prices("LinearEos CowperSymonds", Solid{linear, CowperSymonds{table, 6500, 4}});
  prices("LinearEos ZerilliArmstrong", Solid{linear, zerilli_armstrong});
  prices("LinearEos KinematicHardening",
         Solid{linear, KinematicHardening{.shear_modulus = 43.3e9, .yield_stress = 40e6, .hardening_modulus = 100e6}});
  prices("LinearEos Prony", Solid{linear, prony});
  prices("LinearEos MooneyRivlin", Solid{linear, MooneyRivlin{.C10 = 20e9, .C01 = 1.65e9}});
  prices("LinearEos VonMises JohnsonCookFailure", Solid{linear, von_mises, JohnsonCookFailure{.D1 = 1e12}});
  prices("LinearEos VonMises PrincipalStress", Solid{linear, von_mises, PrincipalStress{.strength = 1e12}});
  prices("LinearEos VonMises UltimateStress", Solid{linear, von_mises, UltimateStress{.ultimate_stress = 1e12}});
  prices("PolynomialEos VonMises", Solid{polynomial, von_mises});
  prices("GruneisenEos VonMises", Solid{gruneisen, von_mises});

  const VonMises strong{.shear_modulus = 43.3e9, .yield_stress = 40e9};
  prices("PlaneStress Elastic", PlaneStress{elastic});
  prices("PlaneStress VonMises, elastic", PlaneStress{Solid{linear, strong}});
  prices("PlaneStress VonMises", PlaneStress{Solid{linear, von_mises}});
  prices("PlaneStress TabulatedHardening", PlaneStress{Solid{linear, table}});
  prices("PlaneStress RateVonMises", PlaneStress{Solid{linear, rate_von_mises}});
  prices("PlaneStress Voce", PlaneStress{Solid{linear, voce}});
  prices("PlaneStress JohnsonCook", PlaneStress{Solid{linear, johnson_cook}});
  prices("ZeroNormalStress Elastic", ZeroNormalStress{elastic});
  prices("ZeroNormalStress LinearEos VonMises", ZeroNormalStress{Solid{linear, von_mises}});
  prices("ZeroNormalStress GruneisenEos JohnsonCook", ZeroNormalStress{Solid{gruneisen, johnson_cook}});

  prices("CubicEos", Fluid{CubicEos{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9}});
  prices("Jwl", Fluid{Jwl{.density = 1630,
                          .A_products = 371.2e9,
                          .B_products = 3.231e9,
                          .R1 = 4.15,
                          .R2 = .95,
                          .omega = .3,
                          .initial_energy = 7e9}});
  prices("IdealGas Newtonian",
         Fluid{IdealGas{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5}, Newtonian{.viscosity = 1e-5}});
  return true;
}();

}  // namespace
