#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <strike/draw/chart.hpp>
#include <strike/output/file.hpp>
#include <strike/text.hpp>

#include "../support/table.hpp"
#include "problem.hpp"

namespace trade {

using bench::formatted, bench::head, bench::row;

/// A run of a case on a mesh. If it was given up, the error is infinite and `failure` says why.
struct Run {
  Outcome outcome;
  std::string failure;
  bool on_front = false;  ///< no other run is both quicker and more accurate

  double nanoseconds() const { return 1e9 * outcome.seconds / static_cast<double>(outcome.steps * outcome.elements); }
};

/// A problem and its runs, runs[i][k] of case i on mesh k.
struct Study {
  Problem problem;
  std::vector<std::vector<Run>> runs;
};

/// Marks the Pareto front and returns it, the quickest run first.
inline std::vector<const Run*> mark_front(Study& study) {
  std::vector<Run*> all;
  for (auto& policy : study.runs)
    for (Run& run : policy)
      if (run.failure.empty()) all.push_back(&run);
  std::sort(all.begin(), all.end(), [](const Run* a, const Run* b) { return a->outcome.seconds < b->outcome.seconds; });
  std::vector<const Run*> front;
  for (Run* run : all)
    if (front.empty() || run->outcome.error < front.back()->outcome.error) run->on_front = true, front.push_back(run);
  return front;
}

/// Error [%] in CPU time [s], "0.42 in 0.63", bold on the front.
inline std::string cell(const Run& run) {
  if (!run.failure.empty()) return "given up";
  const std::string text =
      detail::joined({formatted("%.2g", 100 * run.outcome.error), " in ", formatted("%.2g", run.outcome.seconds)});
  return run.on_front ? detail::joined({"**", text, "**"}) : text;
}

/// Policies down, meshes across.
inline std::string markdown(const Study& study) {
  std::vector<std::string> titles{"policy"};
  for (std::size_t k = 0; k < study.runs.front().size(); ++k) {
    std::size_t elements = 0;  // of a run that was given up none
    for (const auto& policy : study.runs) elements = std::max(elements, policy[k].outcome.elements);
    titles.push_back(detail::joined({study.problem.meshes[k], ": ", std::to_string(elements)}));
  }
  titles.insert(titles.end(), {"steps", "ns"});
  std::string text = detail::joined({"### ", study.problem.title, "\n\nError: ", study.problem.error,
                                     ". Meshes with their number of ", study.problem.elements, ".\n\n", head(titles)});
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    std::vector<std::string> cells{study.problem.cases[i].policy};
    for (const Run& run : study.runs[i]) cells.push_back(cell(run));
    if (const Run& finest = study.runs[i].back(); finest.failure.empty())
      cells.insert(cells.end(), {std::to_string(finest.outcome.steps), formatted("%.0f", finest.nanoseconds())});
    else
      cells.insert(cells.end(), 2, "");
    text += row(cells);
  }
  return text;
}

/// A line for each run.
inline std::string csv(const std::vector<Study>& studies) {
  std::string text = "problem,policy,mesh,elements,error,CPU time [s],steps,ns per element and step,on front,failure\n";
  for (const Study& study : studies)
    for (std::size_t i = 0; i < study.runs.size(); ++i)
      for (std::size_t k = 0; k < study.runs[i].size(); ++k) {
        const Run& run = study.runs[i][k];
        const Outcome& o = run.outcome;
        text += detail::joined({study.problem.name,
                                ",",
                                detail::csv_escaped(study.problem.cases[i].policy),
                                ",",
                                study.problem.meshes[k],
                                ",",
                                std::to_string(o.elements),
                                ",",
                                detail::shortest(o.error),
                                ",",
                                detail::shortest(o.seconds),
                                ",",
                                std::to_string(o.steps),
                                ",",
                                detail::shortest(run.nanoseconds()),
                                ",",
                                run.on_front ? "1" : "0",
                                ",",
                                detail::csv_escaped(run.failure),
                                "\n"});
      }
  return text;
}

/// The policies of which a picture has room: the first, which is the usual, and those nearest to the front, by how many
/// times slower or less accurate than a run on it theirs are on the average. The best come last, for they lie on top.
inline std::vector<std::size_t> drawn(const Study& study, const std::vector<const Run*>& front) {
  constexpr std::size_t colours = 6;  // a seventh is that of the front
  const auto distance = [&](std::size_t policy) {
    double sum = 0;
    for (const Run& run : study.runs[policy]) {
      double least = std::numeric_limits<double>::infinity();
      for (const Run* best : front)
        least = std::min(least, std::max({1.0, run.outcome.seconds / best->outcome.seconds,
                                          run.outcome.error / best->outcome.error}));
      sum += std::log(least);
    }
    return sum;
  };
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 1; i < study.runs.size(); ++i) others.emplace_back(distance(i), i);
  std::ranges::sort(others);
  others.resize(std::min(others.size(), colours - 1));
  others.emplace_back(0, 0);
  std::vector<std::size_t> policies;
  for (const auto& [far, policy] : others) policies.push_back(policy);
  std::ranges::reverse(policies);
  return policies;
}

/// Error over CPU time, a curve from coarse to fine for each of the best policies, and the front behind them.
inline void draw(const Study& study, const std::vector<const Run*>& front, const std::string& path) {
  Chart chart{{.title = study.problem.title,
               .caption = detail::joined({"Error: ", study.problem.error,
                                          ". Each curve goes from coarse to fine; the best policies of the table."}),
               .x = {.label = "CPU time", .unit = "s", .scale = Scale::logarithmic},
               .y = {.label = "error", .unit = "%", .scale = Scale::logarithmic},
               .height = 560}};
  const auto add = [&](const std::string& name, const auto& runs, const Style& style) {
    std::vector<double> seconds, errors;
    for (const Run* run : runs) seconds.push_back(run->outcome.seconds), errors.push_back(100 * run->outcome.error);
    chart.curve(name, seconds, errors, style);
  };
  add("Pareto front", front, {.colour = 6, .width = 8});
  constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond, Marker::cross};
  int colour = 0;
  for (const std::size_t policy : drawn(study, front)) {
    std::vector<const Run*> runs;
    for (const Run& run : study.runs[policy]) runs.push_back(&run);
    add(study.problem.cases[policy].policy, runs,
        {.line = Line::dotted, .marker = markers[colour % 5], .colour = colour, .width = 1});
    ++colour;
  }
  if (study.problem.uncertainty > 0)
    chart.reference(100 * study.problem.uncertainty, "as well as the reference is known");
  chart.write(path);
}

}  // namespace trade
