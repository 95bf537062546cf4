#pragma once
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"

namespace prices {

using namespace strike;

/// A run on its way.
struct Trial {
  std::function<void()> step;
  double bytes;  ///< of an element: what its block stores, its nodes' numbers included
};

/// Steps are timed by the processor, which others on the machine do not disturb, or by the clock on the wall, where
/// threads work side by side.
enum class TimedBy { processor, wall };

/// A choice that differs from the usual in one thing.
struct Feature {
  std::string name;
  std::function<Trial()> start;
  int steps = 8;  ///< in each turn
  TimedBy timed_by = TimedBy::processor;
};

struct Group {
  std::string title;
  std::vector<Feature> features;
};

/// Hexahedra of a millimetre, 100,000 of them.
inline const Mesh mesh = bench::bar({40, 50, 50});
inline const Solid copper{bench::linear, bench::hardening};

/// The squeezed bar and `things` beside it.
template <class E, class M, class... Things>
auto scene(const E& element, const M& material, const Things&... things) {
  return Scene{mesh.nodes, Part{element, material, mesh.hexahedra}, things..., bench::Squeeze{}};
}

/// A run of it, shared by the functions that a Trial consists of.
template <class Scene, class... Policies>
auto started(const Scene& scene, const ExplicitOptions& options = {}, const Policies&... policies) {
  using Run = decltype(Explicit{scene, options, policies...});
  return std::make_shared<Run>(scene, options, policies...);
}

/// What one element of a run stores.
template <class Run>
double bytes(const Run& run) {
  using Part = std::decay_t<decltype(run.template thing<0>())>;
  return static_cast<double>(sizeof(typename Part::Block)) / static_cast<double>(Part::width);
}

// Features by what differs: all of the run, the material, the element, what stands in the scene, or the policies.
template <class Start>
Feature feature(std::string name, Start start) {
  return {std::move(name), [start]() -> Trial {
            const auto run = start();
            return {[run] { run->step(); }, bytes(*run)};
          }};
}

inline Feature usual(std::string name) {
  return feature(std::move(name), [] { return started(scene(Hex8{}, copper)); });
}
template <class M>
Feature of_material(std::string name, const M& material) {
  return feature(std::move(name), [=] { return started(scene(Hex8{}, material)); });
}
template <class E>
Feature of_element(std::string name, const E& element) {
  return feature(std::move(name), [=] { return started(scene(element, copper)); });
}
template <class... Things>
Feature with(std::string name, const Things&... things) {
  return feature(std::move(name), [=] { return started(scene(Hex8{}, copper, things...)); });
}
template <class... Policies>
Feature by(std::string name, const Policies&... policies) {
  return feature(std::move(name), [=] { return started(scene(Hex8{}, copper), {}, policies...); });
}

// The groups, some to a file.
Group strengths();
Group failures();
Group equations_of_state();
Group elements();
Group numbers();
Group conditions();
Group outputs();
Group ledger();

}  // namespace prices
