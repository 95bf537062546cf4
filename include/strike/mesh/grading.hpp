#pragma once
#include <cmath>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike {

/// The `cells + 1` positions that divide [lower, upper] into cells whose lengths grow geometrically [length]; `grading`
/// is the length of the last cell over that of the first. The ends are exact. Errors: no cell, upper <= lower, grading
/// <= 0.
inline std::vector<double> graded(double lower, double upper, Index cells, double grading = 1) {
  if (cells < 1) throw Error("strike: a graded line has no cells; give 1 or more.");
  if (!(upper > lower))
    throw Error(detail::joined({"strike: a graded line from ", detail::text(lower), " to ", detail::text(upper),
                                " has no length; give an upper end above the lower one."}));
  if (!(grading > 0) || !std::isfinite(grading))
    throw Error(detail::joined({"strike: grading ", detail::text(grading),
                                " is no ratio of two cell lengths; give a positive number, last over first."}));
  // Lengths 1, q, q^2, ... with q^(cells - 1) = grading.
  const double q = cells > 1 ? std::pow(grading, 1.0 / (cells - 1)) : 1;
  std::vector<double> distance{0};
  for (Index i = 0; i < cells; ++i) distance.push_back(distance.back() + (q == 1 ? 1 : std::pow(q, i)));
  std::vector<double> position = distance;
  for (double& x : position) x = lower + (upper - lower) * (x / distance.back());
  position.back() = upper;
  return position;
}

}  // namespace strike
