// How near the whole step comes to what one core of this machine can do (Williams, Waterman and Patterson 2009): the
// limits, measured; what a step computes, counted by running it in numbers that count; what it moves, from the sizes of
// what it stores; and the time that it takes.
//
//   build/bench/bench/roofline
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "support/clock.hpp"
#include "support/counted.hpp"
#include "support/machine.hpp"
#include "support/materials.hpp"
#include "support/squeezed_bar.hpp"
#include "support/table.hpp"
#include <unistd.h>

namespace {

using namespace strike;
using namespace bench;

template <class Numbers, class E, class M>
auto squeezed(const Mesh& mesh, const E& element, const M& material, Numbers numbers) {
  return Explicit{Scene{mesh.nodes, Part{element, material, mesh.hexahedra}, Squeeze{}}, {}, numbers};
}
constexpr int first_step = 5, steps = 15;  // measured are those in which every element yields

template <class Run>
void begin(Run& run) {
  for (int i = 0; i < first_step; ++i) run.step();
}
template <class Run>
void measured_steps(Run& run) {
  for (int i = 0; i < steps; ++i) run.step();
}

/// An element whose formulas are compiled apart from the loop over the elements, which takes a tenth of the time.
template <class E>
struct Apart : E {
  template <class M, class T>
  [[gnu::noinline]] Response<T, 8> advance(typename E::template State<M, T>& state, const M& material,
                                           const Nodal<T, 8>& x, const Nodal<T, 8>& v, double dt) const {
    return E::advance(state, material, x, v, dt);
  }
};

/// What the formulas of an element ask for in a step, the mean over a small bar. What stands in two formulas counts
/// twice, though the compiler may do it once.
struct Counts {
  double flops, quotients, roots, functions, selections;
};
template <class E, class M>
Counts counts(const E& element, const M& material) {
  const Mesh mesh = bar({10, 12, 12});
  auto run = squeezed(mesh, Apart<E>{element}, material, in<Counted>);
  begin(run);
  Counted::done = {};
  measured_steps(run);
  const auto each = [&](std::size_t n) { return double(n) / double(steps * mesh.hexahedra.size()); };
  const Operations& done = Counted::done;
  return {each(done.flops()), each(done.quotients), each(done.roots), each(done.functions), each(done.selections)};
}

/// How many nodes, and ghosts of nodes that patches share, there are to one element.
struct Share {
  double nodes, ghosts;
};

/// The flops that are no formulas of the element: its forces go to 8 nodes by 3 subtractions each; for each of three
/// components of a node the kick has seven (4 of them the kinetic energy's) and the drift two; of a ghost the force is
/// added.
double flops_around(const Share& share) { return 8 * 3 + 3 * (7 + 2) * share.nodes + 3 * share.ghosts; }

/// The bytes that one element and its share of the nodes stream in a step. The nodes pass by three times:
///   kick    reads v, f, m, writes v
///   drift   reads x, v, writes x, f
///   deform  reads x, v, f, writes f; the eight elements at a node meet it in the cache
/// the ghosts twice, with their indices:
///   refresh        reads x, v of the node, writes x, v, f
///   gather_forces  reads f and that of the node, which it writes
/// and the elements once: their block is read and of it the state written.
template <class Part, class Real>
double bytes(const Share& share) {
  constexpr std::size_t vector = sizeof(Padded<Real>), mass = sizeof(Real);
  constexpr std::size_t node = (3 * vector + mass) + 4 * vector + 4 * vector;
  constexpr std::size_t ghost = (5 * vector + sizeof(Index)) + (3 * vector + 3 * sizeof(Index));
  constexpr std::size_t block = sizeof(typename Part::Block) + sizeof(typename Part::State);
  return double(block) / double(Part::width) + double(node) * share.nodes + double(ghost) * share.ghosts;
}

/// The bytes that they occupy.
template <class Part, class Real>
double footprint(const Share& share) {
  constexpr std::size_t ghost = 3 * sizeof(Padded<Real>);
  return double(sizeof(typename Part::Block)) / double(Part::width) + double(ghost + sizeof(Real)) * share.nodes +
         double(ghost) * share.ghosts;
}

/// The time of one element and step [ns].
template <class Start>
double nanoseconds(Start start, double elements) {
  std::vector<double> seconds;
  const int samples = elements > 1e4 ? 5 : 50;
  for (int sample = 0; sample < samples; ++sample) {
    auto run = start();
    begin(run);
    seconds.push_back(cpu_seconds([&] { measured_steps(run); }));
  }
  return 1e9 * median(seconds) / (steps * elements);
}

/// The limits of this machine and, for each mesh, the pairs of element and material beside them.
class Roofline {
 public:
  explicit Roofline(std::vector<Mesh> meshes) : meshes_(std::move(meshes)), rows_(meshes_.size()) {}

  template <class E, class M, class... Numbers>
  void add(const std::string& name, const E& element, const M& material, Numbers... numbers) {
    const Counts count = counts(element, material);
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      ((rows_[i] += line(name, element, material, numbers, count, meshes_[i])), ...);
  }

  void print() const {
    std::printf("One core in double: %.0f GFLOP/s, a quotient in %.2f ns, a root in %.2f ns\n", 1e-9 * peak_double_,
                1e9 / quotients<double>(), 1e9 / roots<double>());
    std::printf("         in float:  %.0f GFLOP/s, a quotient in %.2f ns, a root in %.2f ns\n", 1e-9 * peak_float_,
                1e9 / quotients<float>(), 1e9 / roots<float>());
    const auto L2 = double(sysconf(_SC_LEVEL2_CACHE_SIZE)), L3 = double(sysconf(_SC_LEVEL3_CACHE_SIZE));
    std::printf("Triad: %.0f GB/s from L2, %.0f from L3, %.0f from memory\n", 1e-9 * triad(0.5 * L2),
                1e-9 * triad(std::min(20 * L2, 0.5 * L3)), 1e-9 * triad(4 * L3));
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      std::printf("\n%zu hexahedra\n\n%s%s", meshes_[i].hexahedra.size(),
                  head({"element, material", "number", "flops", "quotients", "roots", "functions", "selections",
                        "bytes", "ns", "GFLOP/s", "GB/s", "of GB/s", "limit [ns]", "set by", "reached"})
                      .c_str(),
                  rows_[i].c_str());
  }

 private:
  template <class E, class M, class T, class Real>
  std::string line(const std::string& name, const E& element, const M& material, In<T, Real> numbers,
                   const Counts& count, const Mesh& mesh) const {
    using Part = RunningPart<E, M, T, Real>;
    constexpr bool in_double = sizeof(RealOf<T>) == sizeof(double), mixed = sizeof(RealOf<T>) != sizeof(Real);
    const auto start = [&] { return squeezed(mesh, element, material, numbers); };
    const double elements = double(mesh.hexahedra.size()), nodes = double(mesh.nodes.size());
    const Share share{nodes / elements, (double(start().nodes().places()) - nodes) / elements};
    const double flops = count.flops + flops_around(share), moved = bytes<Part, Real>(share);
    const double bandwidth = triad(elements * footprint<Part, Real>(share));
    const double ns = nanoseconds(start, elements);
    const double by_flops = 1e9 * flops / (in_double ? peak_double_ : peak_float_), by_bytes = 1e9 * moved / bandwidth;
    const double limit = std::max(by_flops, by_bytes);
    return row({name,
                mixed       ? "mixed"
                : in_double ? "double"
                            : "float",
                formatted("%.0f", flops), formatted("%.1f", count.quotients), formatted("%.1f", count.roots),
                formatted("%.1f", count.functions), formatted("%.0f", count.selections), formatted("%.0f", moved),
                formatted("%.1f", ns), formatted("%.1f", flops / ns), formatted("%.1f", moved / ns),
                formatted("%.0f", 1e-9 * bandwidth), formatted("%.1f", limit), by_flops > by_bytes ? "flops" : "bytes",
                formatted("%.0f %%", 100 * limit / ns)});
  }

  std::vector<Mesh> meshes_;
  std::vector<std::string> rows_;
  double peak_double_ = peak<double>(), peak_float_ = peak<float>();
};

}  // namespace

int main() {
  Roofline roofline({bar({40, 50, 50}), bar({5, 6, 45})});  // from memory and from L2
  constexpr auto in_double = in<Pack<double>>;
  constexpr auto in_float = in<Pack<float>>;
  constexpr auto mixed = in<Pack<float>, double>;
  roofline.add("Hex8, elastic", Hex8{}, elastic, in_double);
  roofline.add("Hex8, linear, von Mises", Hex8{}, Solid{linear, hardening}, in_double, in_float, mixed);
  roofline.add("Hex8, Gruneisen, von Mises", Hex8{}, Solid{gruneisen, hardening}, in_double);
  roofline.add("Hex8, linear, Johnson-Cook", Hex8{}, Solid{linear, johnson_cook}, in_double, in_float);
  roofline.add("Hex8, fluid, cubic", Hex8{}, water, in_double);
  roofline.add("Hex8Full, linear, von Mises", Hex8Full{}, Solid{linear, hardening}, in_double, in_float);
  roofline.print();
}
