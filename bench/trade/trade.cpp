// Accuracy against price: every problem is run in every policy on meshes from coarse to fine, and what came out is set
// beside the CPU time that it took. A new problem is a file beside this one; a new policy is a line in policies.hpp,
// one of plates in plates.hpp.
//
//   build/bench/bench/trade                          everything on three meshes
//   build/bench/bench/trade meshes=4                 on the finest too
//   build/bench/bench/trade problem=taylor
//
// Written into out/trade: trade.csv, trade.md, and a picture for each problem.
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>

#include "report.hpp"
#include "support/options.hpp"

namespace {

using namespace trade;

/// The quickest of some runs: others on the machine only ever add to the time.
Run run(const Case& policy, std::size_t mesh) {
  try {
    Outcome best = policy.run(mesh);
    double whole = best.seconds;
    for (int repeat = 0; repeat < 20 && whole < 0.5; ++repeat) {
      const Outcome again = policy.run(mesh);
      whole += again.seconds;
      if (again.seconds < best.seconds) best = again;
    }
    return {best, ""};
  } catch (const Error& error) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {{.error = infinite, .seconds = infinite, .steps = 0, .elements = 0}, error.what()};
  }
}

Study study(Problem problem, std::size_t meshes) {
  Study study{std::move(problem), {}};
  std::printf("\n%s\n", study.problem.title.c_str());
  meshes = std::min(meshes, study.problem.meshes.size());
  for (const Case& policy : study.problem.cases) {
    std::printf("  %-28s", policy.policy.c_str());
    std::vector<Run>& runs = study.runs.emplace_back();
    for (std::size_t k = 0; k < meshes; ++k) {
      runs.push_back(run(policy, k));
      std::printf("%26s", cell(runs.back()).c_str());
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return study;
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    std::vector<std::string> names{"all"};
    std::vector<Problem> problems{taylor(), beam(), waves(), spin(), panel(), twist(), pane(), bars(), bird()};
    std::ranges::move(soft_birds(), std::back_inserter(problems));
    std::ranges::move(bending(), std::back_inserter(problems));
    std::ranges::move(plates_at_rest(), std::back_inserter(problems));
    for (const Problem& problem : problems) names.push_back(problem.name);
    const std::string chosen = options.choice("problem", names);
    const std::size_t meshes = options.count("meshes", 3);
    options.check();

    std::vector<Study> studies;
    std::string tables;
    for (Problem& problem : problems)
      if (chosen == "all" || chosen == problem.name) {
        Study& done = studies.emplace_back(study(std::move(problem), meshes));
        const auto front = mark_front(done);
        draw(done, front, detail::joined({"out/trade/", done.problem.name, ".svg"}));
        tables += (tables.empty() ? "" : "\n") + markdown(done);
      }
    detail::replace_file("out/trade/trade.csv", csv(studies));
    detail::replace_file("out/trade/trade.md", tables);
    std::printf("\nWritten into out/trade: trade.csv, trade.md and a picture of each problem\n");
  });
}
