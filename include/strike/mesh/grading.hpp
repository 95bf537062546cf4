#pragma once
#include <cmath>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

namespace strike {

/// The `cells + 1` positions that divide [lower, upper] into cells whose lengths grow geometrically [length]; `grading`
/// is the length of the last cell over that of the first. The ends are exact. Errors: no cell, upper <= lower, grading
/// <= 0.
inline std::vector<double> graded(double lower, double upper, Index cells, double grading = 1) {
  const detail::RangeCheck check("graded", "");
  check("lower", lower, range::finite), check("upper", upper, range::above(lower));
  check("cells", cells, range::count), check("grading", grading, range::positive);
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
