// How near the whole step comes to what one core of this machine can do (Williams, Waterman and Patterson 2009): the
// limits, measured; what a step computes, counted by running it in numbers that count; what it moves, from the sizes of
// what it stores; and the time that it takes.
//
//   build/bench/bench/roofline
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>

#include "support/clock.hpp"
#include "support/counted.hpp"
#include "support/machine.hpp"
#include "support/materials.hpp"
#include "support/squeezed_bar.hpp"
#include "support/stretched_sheet.hpp"
#include "support/table.hpp"
#include <unistd.h>

namespace {

using namespace strike;
using namespace bench;

/// Hexahedra are squeezed, plates stretched and bent.
template <class E>
const auto& cells(const Mesh& mesh) {
  if constexpr (turns_nodes<E>())
    return mesh.quadrilaterals;
  else
    return mesh.hexahedra;
}
template <class Numbers, class E, class M>
auto deforming(const Mesh& mesh, const E& element, const M& material, Numbers numbers) {
  using Deformation = std::conditional_t<turns_nodes<E>(), Stretch, Squeeze>;
  return Explicit{Scene{mesh.nodes, Part{element, material, cells<E>(mesh)}, Deformation{}}, {}, numbers};
}
constexpr int first_step = 8, steps = 15;  // measured are those in which every element yields

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
  [[gnu::noinline]] Response<T, motions<E>> advance(typename E::template State<M, T>& state, const M& material,
                                                    const Nodal<T, E::nodes>& x, const Nodal<T, motions<E>>& v,
                                                    double dt) const {
    return E::advance(state, material, x, v, dt);
  }
};

/// What the formulas of an element ask for in a step, the mean over a small mesh. What stands in two formulas counts
/// twice, though the compiler may do it once.
struct Counts {
  double flops, quotients, roots, functions, selections;
};
template <class E, class M>
Counts counts(const E& element, const M& material) {
  const Mesh mesh = turns_nodes<E>() ? sheet({40, 36}) : bar({10, 12, 12});
  auto run = deforming(mesh, Apart<E>{element}, material, in<Counted>);
  begin(run);
  Counted::done = {};
  measured_steps(run);
  const auto each = [&](std::size_t n) { return double(n) / double(steps * cells<E>(mesh).size()); };
  const Operations& done = Counted::done;
  return {each(done.flops()), each(done.quotients), each(done.roots), each(done.functions), each(done.selections)};
}

/// How many nodes, and ghosts of nodes that patches share, there are to one element.
struct Share {
  double nodes, ghosts;
};

/// How many pairs of motion and force a node has: velocity and force, and where it turns angular velocity and moment.
template <class E>
constexpr int pairs = turns_nodes<E>() ? 2 : 1;

/// The flops that are no formulas of the element: its forces go to its nodes by 3 subtractions each; for each of three
/// components of a node the kick has seven (4 of them the kinetic energy's) and the drift two; of a ghost the force is
/// added.
template <class E>
double flops_around(const Share& share) {
  return 3 * motions<E> + 3 * (7 * pairs<E> + 2) * share.nodes + 3 * pairs<E> * share.ghosts;
}

/// The bytes that one element and its share of the nodes stream in a step. The nodes pass by three times:
///   kick    reads v, f, m, writes v
///   drift   reads x, v, writes x
///   deform  reads x, v, writes f; the elements at a node meet it in the cache
/// and if elements work on a copy of other precision, they write its x, v, f, which stay in the cache until they are
/// done. The ghosts pass by twice, with their indices:
///   load          reads x, v of the node, writes x, v, f
///   store_ghosts  reads f and that of the node, which it writes
/// and the elements once: their block is read and of it the state written. Of nodes that turn the angular velocity goes
/// with v, the moment with f, the inertia with m.
template <class E, class Part, class T, class Real>
double bytes(const Share& share) {
  constexpr std::size_t vector = sizeof(Padded<Real>), mass = sizeof(Real), element_vector = sizeof(Padded<RealOf<T>>);
  constexpr std::size_t copied = (1 + 2 * pairs<E>)*element_vector,
                        copy = sizeof(RealOf<T>) != sizeof(Real) ? copied : 0;
  constexpr std::size_t kick = pairs<E> * (3 * vector + mass), drift = 3 * vector, deform = (1 + 2 * pairs<E>)*vector;
  constexpr std::size_t load = (1 + pairs<E>)*vector + copied, store = pairs<E> * (element_vector + 2 * vector);
  constexpr std::size_t block = sizeof(typename Part::Block) + sizeof(typename Part::State);
  return double(block) / double(Part::width) + double(kick + drift + deform + copy) * share.nodes +
         double(load + store + 4 * sizeof(Index)) * share.ghosts;
}

/// The bytes that they occupy.
template <class E, class Part, class T, class Real>
double footprint(const Share& share) {
  constexpr std::size_t vectors = 1 + 2 * pairs<E>, ghost = vectors * sizeof(Padded<RealOf<T>>),
                        copy = sizeof(RealOf<T>) != sizeof(Real) ? ghost : 0,
                        node = vectors * sizeof(Padded<Real>) + pairs<E> * sizeof(Real) + copy;
  return double(sizeof(typename Part::Block)) / double(Part::width) + double(node) * share.nodes +
         double(ghost) * share.ghosts;
}

/// The time of one element and step [ns], over some 20,000 elements at least.
template <class Start>
double nanoseconds(Start start, double elements) {
  const int runs = static_cast<int>(std::ceil(2e4 / elements));
  double seconds = 0;
  for (int i = 0; i < runs; ++i) {
    auto run = start();
    begin(run);
    seconds += cpu_seconds([&] { measured_steps(run); });
  }
  return 1e9 * seconds / (runs * steps * elements);
}

/// Of one pair of element and material, in one number, on one mesh.
struct Line {
  std::string name, number;
  Counts count;
  double flops, bytes;     ///< of the whole step
  double peak, bandwidth;  ///< of arithmetic in this number, and of a triad over as many bytes
  std::function<double()> measure;
  std::vector<double> nanoseconds{};

  std::string text() const {
    const double ns = median(nanoseconds), by_flops = 1e9 * flops / peak, by_bytes = 1e9 * bytes / bandwidth;
    const double limit = std::max(by_flops, by_bytes);
    return row({name, number, formatted("%.0f", flops), formatted("%.1f", count.quotients),
                formatted("%.1f", count.roots), formatted("%.1f", count.functions), formatted("%.0f", count.selections),
                formatted("%.0f", bytes), formatted("%.1f", ns), formatted("%.1f", flops / ns),
                formatted("%.1f", bytes / ns), formatted("%.0f", 1e-9 * bandwidth), formatted("%.1f", limit),
                by_flops > by_bytes ? "flops" : "bytes", formatted("%.0f %%", 100 * limit / ns)});
  }
};

/// Products and sums on one core [flop/s].
struct Peaks {
  double in_double = peak<double>(), in_float = peak<float>();
};

/// Pairs of element and material on a mesh, which take turns, so that all meet the same moods of the machine.
class Table {
 public:
  Table(Mesh mesh, std::string title, const Peaks& peaks)
      : mesh_(std::move(mesh)), title_(std::move(title)), peaks_(peaks) {}

  template <class E, class M, class T, class Real>
  void add(const std::string& name, const E& element, const M& material, const Counts& count, In<T, Real> numbers) {
    using Part = RunningPart<E, M, T, Nodes<Real, RealOf<T>, turns_nodes<E>()>>;
    constexpr bool in_double = sizeof(RealOf<T>) == sizeof(double), mixed = sizeof(RealOf<T>) != sizeof(Real);
    const auto start = [=, this] { return deforming(mesh_, element, material, numbers); };
    const double elements = double(cells<E>(mesh_).size()), nodes = double(mesh_.nodes.size());
    const Share share{nodes / elements, (double(start().nodes().places()) - nodes) / elements};
    lines_.push_back({.name = name,
                      .number = mixed       ? "mixed"
                                : in_double ? "double"
                                            : "float",
                      .count = count,
                      .flops = count.flops + flops_around<E>(share),
                      .bytes = bytes<E, Part, T, Real>(share),
                      .peak = in_double ? peaks_.in_double : peaks_.in_float,
                      .bandwidth = triad(elements * footprint<E, Part, T, Real>(share)),
                      .measure = [=] { return nanoseconds(start, elements); }});
  }

  void measure() {
    for (int round = 0; round < 7; ++round)
      for (Line& line : lines_) line.nanoseconds.push_back(line.measure());
  }

  void print() const {
    std::printf("\n%s\n\n%s", title_.c_str(),
                head({"element, material", "number", "flops", "quotients", "roots", "functions", "selections", "bytes",
                      "ns", "GFLOP/s", "GB/s", "of GB/s", "limit [ns]", "set by", "reached"})
                    .c_str());
    for (const Line& line : lines_) std::printf("%s", line.text().c_str());
  }

 private:
  Mesh mesh_;
  std::string title_;
  Peaks peaks_;
  std::vector<Line> lines_;
};

template <class T>
void print_arithmetic(const char* number, double peak) {
  std::printf("%-7s %4.0f GFLOP/s, a quotient in %.2f ns, a root in %.2f ns\n", number, 1e-9 * peak,
              1e9 / quotients<T>(), 1e9 / roots<T>());
}

/// Where the machine does not tell the size of a cache, a usual one [bytes].
double cache(int level, double usual) { return std::max(usual, double(sysconf(level))); }

}  // namespace

int main() {
  const Peaks peaks;
  print_arithmetic<double>("double", peaks.in_double);
  print_arithmetic<float>("float", peaks.in_float);
  const double L2 = cache(_SC_LEVEL2_CACHE_SIZE, 1 << 20), L3 = cache(_SC_LEVEL3_CACHE_SIZE, 16 << 20);
  std::printf("triad   %4.0f GB/s from L2, %.0f from L3, %.0f from memory\n", 1e-9 * triad(0.5 * L2),
              1e-9 * triad(std::min(20 * L2, 0.5 * L3)), 1e-9 * triad(4 * L3));

  // The small ones stay in L2.
  Table hexahedra[] = {{bar({40, 50, 50}), "100000 hexahedra", peaks}, {bar({5, 6, 45}), "1350 hexahedra", peaks}};
  Table plates[] = {{sheet({400, 250}), "100000 plates", peaks}, {sheet({45, 30}), "1350 plates", peaks}};
  const auto add = [&](const std::string& name, const auto& element, const auto& material, auto... numbers) {
    const Counts count = counts(element, material);
    for (Table& table : turns_nodes<std::decay_t<decltype(element)>>() ? plates : hexahedra)
      (table.add(name, element, material, count, numbers), ...);
  };
  constexpr auto in_double = in<Pack<double>>;
  constexpr auto in_float = in<Pack<float>>;
  constexpr auto mixed = in<Pack<float>, double>;
  add("Hex8, elastic", Hex8{ViscousHourglass{}}, elastic, in_double);
  add("Hex8, linear, von Mises", Hex8{ViscousHourglass{}}, Solid{linear, hardening}, in_double, in_float, mixed);
  add("Hex8, Gruneisen, von Mises", Hex8{ViscousHourglass{}}, Solid{gruneisen, hardening}, in_double);
  add("Hex8, linear, Johnson-Cook", Hex8{ViscousHourglass{}}, Solid{linear, johnson_cook}, in_double, in_float);
  add("Hex8, fluid, cubic", Hex8{ViscousHourglass{}}, water, in_double);
  add("Hex8Full, linear, von Mises", Hex8Full{}, Solid{linear, hardening}, in_double, in_float);
  const Homogeneous elastic_sheet{PlaneStress{elastic}, sheet_thickness};
  const Homogeneous copper_sheet{PlaneStress{Solid{linear, hardening}}, sheet_thickness};
  add("Plate4, elastic", Plate4{}, elastic_sheet, in_double);
  add("Plate4, von Mises", Plate4{}, copper_sheet, in_double, in_float, mixed);
  for (Table* tables : {hexahedra, plates})
    for (int i = 0; i < 2; ++i) tables[i].measure(), tables[i].print();
}
