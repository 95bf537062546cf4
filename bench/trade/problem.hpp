#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>

#include "../support/clock.hpp"

namespace trade {

using namespace strike;
using bench::cpu_seconds;

/// What a run found and what it took.
struct Outcome {
  double error;    ///< relative, against the reference of its problem
  double seconds;  ///< of CPU, without the set-up
  std::size_t steps, elements;
};

/// How a policy runs a problem beside the element and the numbers: how the driver is told, how far from the origin.
struct Options {
  ExplicitOptions driver = {};
  double distance = 0;  ///< [length], where the problem heeds it
};
/// The same on one of the meshes.
struct Setting {
  std::size_t mesh;
  ExplicitOptions options;
  double distance;
};

/// A policy on a problem.
struct Case {
  std::string policy;
  std::function<Outcome(std::size_t mesh)> run;
};

/// A scene whose answer is known, and the policies that are tried on it.
struct Problem {
  std::string name, title;
  std::string error;                ///< what is compared with which reference
  double uncertainty = 0;           ///< of the reference
  std::vector<std::string> meshes;  ///< from coarse to fine
  std::string elements = "hexahedra";
  std::vector<Case> cases = {};
};

/// Collects the policies of a problem, whose scene is `Outcome run(element, numbers, setting)`.
template <class Run>
class Cases {
 public:
  Cases(Problem& problem, Run run) : problem_(problem), run_(run) {}

  template <class Element, class Numbers = In<Pack<double>>>
  void add(std::string policy, const Element& element, Numbers numbers = {}, Options options = {}) {
    problem_.cases.push_back({std::move(policy), [run = run_, element, numbers, options](std::size_t mesh) -> Outcome {
                                return run(element, numbers, Setting{mesh, options.driver, options.distance});
                              }});
  }

 private:
  Problem& problem_;
  Run run_;
};

/// A problem with groups of policies, see policies.hpp.
template <class Run, class... Groups>
Problem problem(Problem about, Run run, Groups... groups) {
  Cases<Run> cases(about, run);
  (groups(cases), ...);
  return about;
}

// The problems, each with its file.
Problem taylor();
Problem beam();
Problem waves();
Problem spin();
Problem panel();
Problem twist();
Problem pane();
Problem bars();
Problem bird();
std::vector<Problem> soft_birds();
std::vector<Problem> bending();
std::vector<Problem> plates_at_rest();

}  // namespace trade
