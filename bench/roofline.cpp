// How near the whole step comes to what one core of this machine can do (Williams, Waterman and Patterson 2009): the
// limits, measured; what a step computes, counted by running it in numbers that count; what it moves, from the sizes of
// what it stores; and the time that it takes.
//
//   build/bench/bench/roofline
#include <cstdio>
#include <string>

#include <unistd.h>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "support/clock.hpp"
#include "support/counted.hpp"
#include "support/machine.hpp"
#include "support/materials.hpp"
#include "support/squeezed_bar.hpp"
#include "support/table.hpp"

namespace {

using namespace strike;
using namespace bench;

template <class T, class E, class M>
auto squeezed(const Mesh& mesh, const E& element, const M& material) {
  return Explicit{Scene{mesh.nodes, Part{element, material, mesh.hexahedra}, Squeeze{}}, {}, in<T>};
}

/// Operations of the formulas of one element in one step, the mean over a small bar.
struct Counts {
  double flops, quotients, roots, functions, selections;
};
template <class E, class M>
Counts counts(const E& element, const M& material) {
  const Mesh mesh = bar({6, 6, 6});
  auto run = squeezed<Counted>(mesh, element, material);
  constexpr int first = 5, steps = 5;
  for (int i = 0; i < first; ++i) run.step();
  Counted::done = {};
  for (int i = 0; i < steps; ++i) run.step();
  const auto each = [&](std::size_t n) { return static_cast<double>(n) / double(steps * mesh.hexahedra.size()); };
  const Operations& done = Counted::done;
  return {each(done.flops()), each(done.quotients), each(done.roots), each(done.functions), each(done.selections)};
}

/// The flops that are no formulas of the element: its forces go to 8 nodes by 3 subtractions each; for each of three
/// components of a node the kick has seven (4 of them the kinetic energy's) and the drift two.
double flops_around(double nodes_per_element) { return 8 * 3 + 3 * (7 + 2) * nodes_per_element; }

/// The bytes that one element and its share of the nodes stream in a step. The nodes pass by three times:
///   kick    reads v, f, m, writes v
///   drift   reads x, v, writes x, f
///   deform  reads x, v, f, writes f; the eight elements at a node meet it in the cache
/// and the elements once: their block is read and of it the state written.
template <class Part, class Real>
double bytes(double nodes_per_element) {
  constexpr std::size_t vector = sizeof(Padded<Real>), mass = sizeof(Real);
  constexpr std::size_t node = (3 * vector + mass) + 4 * vector + 4 * vector;
  constexpr std::size_t block = sizeof(typename Part::Block) + sizeof(typename Part::State);
  return double(block) / double(Part::width) + double(node) * nodes_per_element;
}

/// The bytes that they occupy.
template <class Part, class Real>
double footprint(double nodes_per_element) {
  return double(sizeof(typename Part::Block)) / double(Part::width) +
         double(3 * sizeof(Padded<Real>) + sizeof(Real)) * nodes_per_element;
}

/// The time of one element and step [ns].
template <class Run>
double nanoseconds(Run& run, double elements) {
  const int steps = static_cast<int>(1 + 4e5 / elements);
  for (int i = 0; i < 3; ++i) run.step();
  std::vector<double> seconds;
  for (int sample = 0; sample < 9; ++sample)
    seconds.push_back(cpu_seconds([&] {
      for (int i = 0; i < steps; ++i) run.step();
    }));
  return 1e9 * median(seconds) / (steps * elements);
}

struct Limits {
  double peak_double = peak<double>(), peak_float = peak<float>();

  template <class T>
  double of() const {
    return sizeof(RealOf<T>) == sizeof(double) ? peak_double : peak_float;
  }
};

template <class T, class E, class M>
void report(const std::string& name, const Limits& limits, const Mesh& mesh, const E& element, const M& material) {
  auto run = squeezed<T>(mesh, element, material);
  using Run = decltype(run);
  using Part = std::decay_t<decltype(run.template thing<0>())>;
  const double elements = double(mesh.hexahedra.size()), nodes_per_element = double(mesh.nodes.size()) / elements;
  const Counts count = counts(element, material);
  const double flops = count.flops + flops_around(nodes_per_element);
  const double moved = bytes<Part, typename Run::Real>(nodes_per_element);
  const double bandwidth = triad(elements * footprint<Part, typename Run::Real>(nodes_per_element));
  const double ns = nanoseconds(run, elements);
  const double by_flops = 1e9 * flops / limits.of<T>(), by_bytes = 1e9 * moved / bandwidth;
  const double limit = std::max(by_flops, by_bytes);
  std::printf("%s", row({name, formatted("%.0f", flops), formatted("%.1f", count.quotients),
                         formatted("%.1f", count.roots), formatted("%.1f", count.functions),
                         formatted("%.0f", count.selections), formatted("%.0f", moved), formatted("%.1f", ns),
                         formatted("%.1f", flops / ns), formatted("%.1f", moved / ns),
                         formatted("%.0f", 1e-9 * bandwidth), formatted("%.1f", limit),
                         by_flops > by_bytes ? "flops" : "bytes", formatted("%.0f %%", 100 * limit / ns)})
                        .c_str());
  std::fflush(stdout);
}

void report_all(const Limits& limits, const Mesh& mesh) {
  std::printf("\n%zu hexahedra\n\n%s", mesh.hexahedra.size(),
              head({"element, material, number", "flops", "quotients", "roots", "functions", "selections", "bytes",
                    "ns", "GFLOP/s", "GB/s", "of at most GB/s", "limit [ns]", "set by", "reached"})
                  .c_str());
  using D = Pack<double>;
  using F = Pack<float>;
  const auto in_double = [&](const std::string& name, const auto& element, const auto& material) {
    report<D>(name + ", double", limits, mesh, element, material);
  };
  const auto in_both = [&](const std::string& name, const auto& element, const auto& material) {
    in_double(name, element, material);
    report<F>(name + ", float", limits, mesh, element, material);
  };
  in_double("Hex8, elastic", Hex8{}, elastic);
  in_both("Hex8, linear, von Mises", Hex8{}, Solid{linear, hardening});
  in_double("Hex8, Gruneisen, von Mises", Hex8{}, Solid{gruneisen, hardening});
  in_both("Hex8, linear, Johnson-Cook", Hex8{}, Solid{linear, johnson_cook});
  in_double("Hex8, fluid, cubic", Hex8{}, water);
  in_both("Hex8Full, linear, von Mises", Hex8Full{}, Solid{linear, hardening});
}

}  // namespace

int main() {
  const Limits limits;
  const auto L2 = static_cast<double>(sysconf(_SC_LEVEL2_CACHE_SIZE)),
             L3 = static_cast<double>(sysconf(_SC_LEVEL3_CACHE_SIZE));
  std::printf("One core: %.0f GFLOP/s in double, %.0f in float; a quotient takes %.2f ns in double, %.2f in float\n",
              1e-9 * limits.peak_double, 1e-9 * limits.peak_float, 1e9 / quotients<double>(), 1e9 / quotients<float>());
  std::printf("Triad: %.0f GB/s from L2, %.0f from L3, %.0f from memory\n", 1e-9 * triad(0.5 * L2),
              1e-9 * triad(20 * L2 < L3 ? 20 * L2 : 0.5 * L3), 1e-9 * triad(4 * L3));

  report_all(limits, bar({40, 50, 50}));
  report_all(limits, bar({5, 6, 45}));
}
