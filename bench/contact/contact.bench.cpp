// What contact costs: per contact node, a search and a step; of two blocks of hexahedra of which one lies on the other,
// or hovers above it, the contact alone and the whole step.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/strike.hpp>

#include "../support/materials.hpp"

namespace {

using namespace strike;

/// A block of n x n x n/10 cells on another of 0.9 n, which does not fit it; `apart` in cells.
struct Blocks {
  Mesh mesh, lower;
  std::vector<Index> nodes;
  std::vector<Face> faces;

  Blocks(Index n, double apart) {
    const double h = 1e-3, size = h * n, gap = apart * h;
    const Index m = n * 9 / 10, layers = std::max<Index>(n / 10, 1);
    mesh = lower = box({.lower = {0, 0, -h * layers}, .size = {size, size, h * layers}, .cells = {m, m, layers}});
    const Index first =
        append(mesh, box({.lower = {0, 0, gap}, .size = {size, size, h * layers}, .cells = {n, n, layers}}));
    for (Index i = first; i < first + (n + 1) * (n + 1); ++i) nodes.push_back(i);
    faces = surface(lower);
  }
  template <class... Policies>
  auto run(const Policies&... policies) const {
    std::vector<Index> upper;
    for (Index i = static_cast<Index>(lower.nodes.size()); i < mesh.nodes.size(); ++i) upper.push_back(i);
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, Solid{bench::linear, bench::hardening}, mesh.hexahedra},
              Contact{NodeToSurface{nodes, Surface{faces}}, policies...}, InitialVelocity{{0.5, 0.3, -2}, upper}}};
  }
};

void per_node(benchmark::State& bench, double nodes) {
  bench.counters["per_contact_node"] =
      benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class... Policies>
void step(benchmark::State& bench, Index n, double apart, const Policies&... policies) {
  const Blocks blocks(n, apart);
  auto run = blocks.run(policies...);
  for (int i = 0; i < 5; ++i) run.step();
  for (auto _ : bench) run.step();
  per_node(bench, static_cast<double>(blocks.nodes.size()));
  bench.counters["pairs"] = static_cast<double>(run.template item<1>().pairs().size());
}

/// The contact alone, of blocks that stay where they are.
template <class... Policies>
void touch(benchmark::State& bench, Index n, double apart, const Policies&... policies) {
  const Blocks blocks(n, apart);
  auto run = blocks.run(policies...);
  for (int i = 0; i < 5; ++i) run.step();
  Ledger ledger;
  const Step now{10, 0, run.dt(), run.dt()};
  for (auto _ : bench) run.template item<1>().resolve_contact(run.nodes(), now, ledger);
  per_node(bench, static_cast<double>(blocks.nodes.size()));
  bench.counters["pairs"] = static_cast<double>(run.template item<1>().pairs().size());
}

void search(benchmark::State& bench, Index n) {
  const Blocks blocks(n, 0.01);
  std::vector<std::array<Index, 4>> faces;
  for (const Face& face : blocks.faces) faces.push_back(face.nodes);
  detail::BucketSearch search;
  for (auto _ : bench) benchmark::DoNotOptimize(search.sort(blocks.nodes, faces, blocks.mesh.nodes, 0.25e-3));
  per_node(bench, static_cast<double>(blocks.nodes.size()));
}

const bool registered = [] {
  const auto add = [](const std::string& name, auto f) {
    benchmark::RegisterBenchmark(name.c_str(), f)->Unit(benchmark::kMillisecond);
  };
  for (const Index n : {50u, 71u, 100u, 141u}) {
    const std::string of = detail::joined({"/", std::to_string((n + 1) * (n + 1)), " nodes"});
    add("search" + of, [=](auto& b) { search(b, n); });
    add("touch, kinematic" + of, [=](auto& b) { touch(b, n, 0); });
  }
  for (const double apart : {0.0, 0.3, 5.0}) {
    const std::string of = apart > 0 ? detail::joined({"/", detail::text(apart), " apart"}) : "/in touch";
    add("touch, kinematic" + of, [=](auto& b) { touch(b, 100, apart); });
    add("touch, penalty" + of, [=](auto& b) { touch(b, 100, apart, Penalty{}); });
    add("touch, kinematic, friction" + of, [=](auto& b) { touch(b, 100, apart, Coulomb{0.3}); });
    add("whole step, kinematic" + of, [=](auto& b) { step(b, 100, apart); });
    add("whole step, penalty" + of, [=](auto& b) { step(b, 100, apart, Penalty{}); });
  }
  return true;
}();

}  // namespace
