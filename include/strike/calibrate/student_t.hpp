#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>

#include <strike/scalar/bisect.hpp>

namespace strike::calibrate {

/// The probability that Student's t of some degrees of freedom lies between -t and t (Abramowitz and Stegun 1964,
/// 26.7.3 and 26.7.4), with tan(theta) = t/sqrt(degrees_of_freedom).
inline double student_t_probability(double t, std::size_t degrees_of_freedom) {
  const auto n = static_cast<double>(degrees_of_freedom);
  const double theta = std::atan(t / std::sqrt(n)), cosine = std::cos(theta);
  const bool odd = degrees_of_freedom % 2 == 1;
  double sum = 0, term = odd ? cosine : 1;
  for (double k = odd ? 3 : 2; k <= n; k += 2) {
    sum += term;
    term *= (k - 1) / k * cosine * cosine;
  }
  const double series = std::sin(theta) * sum;
  return odd ? 2 / std::numbers::pi * (theta + series) : series;
}

/// The t below which |Student's t| of some degrees of freedom stays with a probability below 1: 2.228 for 0.95 and 10.
inline double student_t_quantile(double probability, std::size_t degrees_of_freedom) {
  double upper = 1;
  while (student_t_probability(upper, degrees_of_freedom) < probability) upper *= 2;
  const auto is_below = [&](double t) { return student_t_probability(t, degrees_of_freedom) < probability; };
  return bisect(Bracket<double>{0, upper}, is_below, 60).middle();
}

}  // namespace strike::calibrate
