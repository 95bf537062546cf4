#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <strike/dynamics/method.hpp>
#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>
#include <strike/verify/material_point.hpp>

namespace strike::calibrate {

/// Conditions of a measured stress-strain curve.
struct UniaxialTest {
  double rate = 1;                  ///< of strain [1/time]
  double largest_increment = 1e-3;  ///< of strain in a step of the material point

  void ranges(const auto& number) const {
    number("rate", rate, range::positive);
    number("largest_increment", largest_increment, range::positive);
  }
};

/// The Cauchy stresses [stress] of a material in tension, or compression, without stress across, at successive
/// logarithmic strains: to compare with a measured curve.
///   const auto stress = uniaxial_stresses(copper, strains, {.rate = 1e-3}, in<Dual<double, 2>>);
/// Errors: strains that do not move away from 0 in one direction.
template <class M, class T = double>
std::vector<T> uniaxial_stresses(const M& material, std::span<const double> strains, const UniaxialTest& test,
                                 In<T> number = {}) {
  detail::check_ranges(test);
  verify::MaterialPoint point{material, number};
  std::vector<T> stresses;
  double before = 0;
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const double change = strains[i] - before;
    if (!(change * strains[0] > 0) || !std::isfinite(change))
      throw Error(
          detail::joined({"strike: strain ", std::to_string(i), " of a uniaxial test is ", detail::text(strains[i]),
                          " after ", detail::text(before), "; give strains that go one way from 0."}));
    const auto steps = static_cast<std::size_t>(std::ceil(std::abs(change) / test.largest_increment));
    point.run(verify::uniaxial_stress({.strain = change, .rate = test.rate, .steps = steps}), [](const auto&) {});
    stresses.push_back(point.now().stress.xx);
    before = strains[i];
  }
  return stresses;
}

}  // namespace strike::calibrate
