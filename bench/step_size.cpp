// How many steps the stable step of the mesh as a whole saves, and what it costs: Taylor's bar, blocks of even and
// of graded cells, and the scenes of the prices, with the bound of the elements and with that of the mesh.
//
//   build/bench/bench/step_size
//   build/bench/bench/step_size repeats=5
//
// Written into out/step_size: step_size.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include <strike/dynamics/global_step.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/output/file.hpp>
#include <strike/section/layered.hpp>

#include "problems/taylor_bar.hpp"
#include "support/options.hpp"

// Of the benches, for examples have a folder of that name too.
#include "../bench/support/materials.hpp"
#include "../bench/support/squeezed_bar.hpp"
#include "../bench/support/stretched_sheet.hpp"

namespace {

using namespace strike;

/// What a run took and found.
struct Outcome {
  std::size_t steps = 0, asked = 0, products = 0;
  double seconds = 0;  // of CPU, with the set-up, in which the mesh is first asked
  double answer = 0;
  double drift = 0;  // largest error of the energy balance
};

template <class Make, class Answer>
Outcome outcome(const Make& make, double end, const Answer& answer) {
  Outcome o;
  const std::clock_t begin = std::clock();
  auto run = make();
  run.until(end, [&] { o.drift = std::max(o.drift, std::abs(run.energy().error())); });
  o.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  o.steps = run.steps();
  o.answer = answer(run);
  if constexpr (requires { run.step_bound().estimates(); })
    o.asked = run.step_bound().estimates(), o.products = run.step_bound().products();
  return o;
}

struct Problem {
  std::string name;
  std::function<Outcome(ElementStep)> elements;
  std::function<Outcome(GlobalStep)> mesh;
};
template <class Run>
Problem problem(std::string name, Run run) {
  return {std::move(name), run, run};
}

/// Taylor's bar (tests/problems/taylor_bar.hpp).
template <class E = Hex8<ViscousHourglass>>
Problem taylor_bar(Index cells, Index layers, const char* of = "") {
  return problem(detail::joined({"Taylor bar, ", std::to_string(cells), " x ", std::to_string(layers), of}),
                 [=](const auto& bound) {
                   return outcome(
                       [&] { return taylor::bar(taylor::mm_ms_kg, cells, layers, in<Pack<double>>, E{}, bound); },
                       taylor::mm_ms_kg.end, [](const auto& run) { return taylor::length(run); });
                 });
}

/// A block of steel that strikes a rigid wall with its face z = 0, its cells growing away from there. Metres, seconds,
/// kilograms.
Problem block(std::string name, double speed, const std::array<double, 3>& grading) {
  return problem(std::move(name), [=](const auto& bound) {
    constexpr double size = 0.1;
    const Mesh mesh = box({.size = {size, size, size}, .cells = {16, 16, 16}, .grading = grading});
    const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 167e9},
                      VonMises{.shear_modulus = 77e9, .yield_stress = 400e6, .hardening_modulus = 1e9}};
    return outcome(
        [&] {
          return Explicit{
              Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, steel, mesh.hexahedra}, InitialVelocity{{0, 0, -speed}},
                    Symmetry{Axis::z, nodes_where(mesh.nodes, on_plane(Axis::z, 0))}},
              ExplicitOptions{}, bound};
        },
        100e-6, [](const auto& run) { return 1e3 * taylor::length(run); });
  });
}

/// A scene of the prices over the time of so many steps with the bound of the elements; the answer is the largest
/// coordinate.
template <class Scene>
Problem price_scene(std::string name, const Scene& scene, std::size_t steps) {
  Explicit usual{scene};
  while (usual.steps() < steps) usual.step();
  return problem(std::move(name), [=, end = usual.time()](const auto& bound) {
    return outcome(
        [&] {
          return Explicit{scene, ExplicitOptions{.print_warnings = false}, bound};
        },
        end,
        [](const auto& run) {
          double largest = 0;
          for (std::size_t i = 0; i < run.nodes().size(); ++i) largest = std::max(largest, run.nodes().x(i).maxCoeff());
          return 1e3 * largest;
        });
  });
}

template <class Bound>
Outcome quickest(const std::function<Outcome(Bound)>& run, std::size_t repeats) {
  Outcome best = run(Bound{});
  for (std::size_t i = 1; i < repeats; ++i)
    if (const Outcome again = run(Bound{}); again.seconds < best.seconds) best = again;
  return best;
}

std::string number(const char* format, double x) {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
std::string row(const Problem& problem, const Outcome& e, const Outcome& m) {
  const auto ratio = [](auto a, auto b) { return number("%.2f", static_cast<double>(a) / static_cast<double>(b)); };
  return detail::joined({"| ",  problem.name,
                         " | ", std::to_string(e.steps),
                         " | ", std::to_string(m.steps),
                         " | ", ratio(m.steps, e.steps),
                         " | ", number("%.3g", e.seconds),
                         " | ", number("%.3g", m.seconds),
                         " | ", ratio(m.seconds, e.seconds),
                         " | ", std::to_string(m.asked),
                         " | ", std::to_string(m.products),
                         " | ", number("%.4g", e.answer),
                         ", ",  number("%.4g", m.answer),
                         " | ", number("%.1e", e.drift),
                         ", ",  number("%.1e", m.drift),
                         " |\n"});
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::size_t repeats = options.count("repeats", 3);
    options.check();
    const Solid copper{bench::linear, bench::hardening};
    const Mesh bar = bench::bar({40, 50, 50}), split = tetrahedralized(bench::bar({25, 26, 26})),
               sheet = bench::sheet({400, 250});
    std::string table =
        "| problem | steps: own | mesh | ratio | CPU [s]: own | mesh | ratio | asked | products | answer [mm] | "
        "energy "
        "error |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|---|---|\n";
    std::printf("%s", table.c_str());
    for (const Problem& p :
         {taylor_bar(2, 33), taylor_bar(3, 50), taylor_bar(4, 67), taylor_bar(6, 100),
          taylor_bar<Hex8Full<>>(3, 50, ", Hex8Full"), block("even block, 10 m/s", 10, {1, 1, 1}),
          block("even block, 100 m/s", 100, {1, 1, 1}), block("graded, 1 to 10, 10 m/s", 10, {10, 10, 10}),
          block("graded, 1 to 10, 100 m/s", 100, {10, 10, 10}), block("flat, 1 to 10, 100 m/s", 100, {1, 1, 10}),
          price_scene("100 000 hexahedra", Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra}, bench::Squeeze{}},
                      250),
          price_scene(
              "100 000 plates",
              Scene{sheet.nodes,
                    Part{Plate4{}, Homogeneous{PlaneStress{copper}, bench::sheet_thickness}, sheet.quadrilaterals},
                    bench::Stretch{}},
              178),
          price_scene("the same, PhysicalHourglass",
                      Scene{sheet.nodes,
                            Part{Plate4{PhysicalHourglass{}}, Homogeneous{PlaneStress{copper}, bench::sheet_thickness},
                                 sheet.quadrilaterals},
                            bench::Stretch{}},
                      178),
          price_scene("101 400 tetrahedra",
                      Scene{split.nodes, Part{Tet4{}, copper, split.tetrahedra}, bench::Squeeze{}}, 171)}) {
      const std::string line = row(p, quickest(p.elements, repeats), quickest(p.mesh, repeats));
      std::printf("%s", line.c_str());
      std::fflush(stdout);
      table += line;
    }
    detail::replace_file("out/step_size/step_size.md", table);
    std::printf("\nWritten: out/step_size/step_size.md\n");
  });
}
