#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The speed of waves in a material at rest, sqrt((K + 4/3 G)/density).
template <class M>
[[gnu::cold]] double wave_speed(const M& material) {
  typename M::template State<double> state{};
  if constexpr (requires { material.begin(state); }) material.begin(state);
  return std::sqrt(material.moduli(state, typename M::Kinematics::template Rate<double>{}).wave() /
                   density_of(material));
}

/// A sentence on numbers of different units: a wave speed that no system of docs/units.md gives, from rubber's to
/// diamond's, or more steps than a run of an impact takes; empty: none.
[[gnu::cold]] inline std::string unit_slip(std::size_t part, double speed, double steps) {
  const std::string advice = "; if that is not meant, look whether all numbers are of one system of units.";
  if (speed < 1e-4 || speed > 2e7)
    return joined({"Waves in part ", std::to_string(part), " have the speed ", text(speed), advice});
  if (steps > 1e6 && std::isfinite(steps))
    return joined({"It is about ", text(steps), " steps to the end of the run", advice});
  return {};
}

/// Error: constants of a material from which no wave follows.
template <class M>
[[gnu::cold]] void check_material(const M& material, std::size_t part) {
  typename M::template State<double> state{};
  if constexpr (requires { material.begin(state); }) material.begin(state);
  const double density = density_of(material),
               wave = material.moduli(state, typename M::Kinematics::template Rate<double>{}).wave();
  if (!(density > 0 && wave > 0 && std::isfinite(density) && std::isfinite(wave)))
    throw Error(joined({"strike: the material of part ", std::to_string(part), " has the density ", text(density),
                        " and at rest the wave modulus K + 4/3 G = ", text(wave),
                        "; both must be positive: correct its constants."}));
}

/// Error: an element so far from the origin that the spacing of the numbers there would strain it by more than a
/// thousandth.
template <class Elements, class N>
void check_resolution(const Elements& elements, const N& nodes, std::size_t place) {
  const auto corners = elements.cell(nodes, place);
  double spacing = 0, gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d x = nodes.x(corners[i]).template cast<double>();
    spacing = std::max(spacing, nodes.resolution(corners[i]));
    for (std::size_t j = 0; j < i; ++j)
      if (const double d = Eigen::Vector3d(x - nodes.x(corners[j]).template cast<double>()).norm(); d > 0)
        gap = std::min(gap, d);
  }
  if (spacing > 1e-3 * gap)
    throw Error(joined({"strike: ", elements.describe(nodes, place), " is only ", text(gap), " wide where numbers are ",
                        text(spacing), " apart; move the mesh to the origin or compute in double."}));
}

/// Error: an element without a positive mass.
template <class Elements, class N>
void check_mass(const Elements& elements, const N& nodes, std::size_t place, double mass) {
  if (!(mass > 0))
    throw Error(joined({"strike: ", elements.describe(nodes, place),
                        " has no positive mass; its corners are in the wrong order or coincide."}));
}

[[noreturn, gnu::cold, gnu::noinline]] inline void explain_inversion(const std::string& element, double volume) {
  if (std::isnan(volume)) throw Error(joined({element, " has the volume nan: look at the formulas of its element"}));
  throw Error(joined({element, " is inverted (volume ", text(volume),
                      "); refine the mesh there, use a smaller step factor or let the material fail"}));
}

}  // namespace strike::detail
