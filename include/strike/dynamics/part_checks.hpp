#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/element/cell_shape.hpp>
#include <strike/element/element.hpp>
#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/mesh/check_cell.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>
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

/// The energy that a mass of a material holds at rest, such as that of a gas under pressure.
template <class M, class Number>
Number stored_energy(const M& material, const Number& mass) {
  typename M::template State<double> state{};
  if constexpr (requires { state.internal_energy; }) {
    if constexpr (requires { material.begin(state); }) material.begin(state);
    return mass * (state.internal_energy / density_of(material));
  } else {
    return (void)material, (void)mass, Number(0.0);
  }
}
/// The sentences of a material of which a mass is in so many elements; of a section over half waves of four elements.
template <class M>
[[gnu::cold]] std::string warning_of(const M& material, [[maybe_unused]] double mass,
                                     [[maybe_unused]] std::size_t elements) {
  if constexpr (requires { material.warning(0.0); })
    return material.warning(4 * std::sqrt(mass / density_of(material) / static_cast<double>(elements)));
  else if constexpr (requires { material.warning(); })
    return material.warning();
  else
    return (void)material, std::string{};
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
template <class Elements, class N, std::size_t n>
void check_resolution(const Elements& elements, const N& nodes, std::size_t place, const CellCorners<n>& x) {
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
  double square = std::numeric_limits<double>::infinity();  // of the least distance between two corners
  for (std::size_t i = 0; i < n; ++i) {
    farthest = farthest.cwiseMax(x[i].cwiseAbs());
    for (std::size_t j = 0; j < i; ++j) {
      const double d = (x[i] - x[j]).squaredNorm();
      square = d > 0 ? std::min(square, d) : square;
    }
  }
  const double spacing = nodes.resolution(farthest);
  if (const double gap = std::sqrt(square); spacing > 1e-3 * gap)
    throw Error(joined({"strike: ", elements.describe(nodes, place), " is only ", text(gap), " wide where numbers are ",
                        text(spacing), " apart; move the mesh to the origin or compute in double."}));
}

/// The hexahedra of all lanes, at x, are far from what check_cell refuses, but for their names. False does not mean
/// that it refuses one, which it decides in double. (Lanes cost a fifth of that.)
template <class E, class T>
bool are_well_shaped(const Nodal<T, E::nodes>& x) {
  bool well_shaped = false;
  if constexpr (HasCellShape<E>) {
    if constexpr (E::shape == CellShape::hexahedron) {
      CellCorners<8, T> corners;
      T farthest2 = T(0.0), square = T(std::numeric_limits<float>::max());  // as in check_resolution
      for (std::size_t i = 0; i < 8; ++i) {
        corners[i] = column(x, i);
        farthest2 = max(farthest2, T(dot<T>(corners[i], corners[i])));
        for (std::size_t j = 0; j < i; ++j) {
          const Vector3<T> apart = corners[i] - corners[j];
          square = min(square, T(dot<T>(apart, apart)));
        }
      }
      constexpr double share = 2e3 * double(std::numeric_limits<RealOf<T>>::epsilon());
      const T resolved = square - (share * share) * farthest2;
      const T well = is_well_shaped<E::shape, T>(std::array<Index, 8>{}, corners, 0.01);  // beyond rounding in float
      well_shaped = true;
      for (std::size_t l = 0; l < lanes<T>; ++l)
        well_shaped = well_shaped && lane(well, l) > 0 && lane(resolved, l) > 0;
    }
  }
  return well_shaped;
}

/// The positions of the corners of a cell, in double.
template <class N, std::size_t n>
CellCorners<n> corners_at(const N& nodes, const std::array<Index, n>& cell) {
  CellCorners<n> x;
  for (std::size_t i = 0; i < n; ++i) x[i] = nodes.x(cell[i]).template cast<double>();
  return x;
}

/// Errors: as of check_resolution; a cell breaks a law of its element's shape. Of these `well_shaped` cells can break
/// that on names alone.
template <class Elements, class N, std::size_t n>
void check_cell(const Elements& elements, const N& nodes, std::size_t place, const std::array<Index, n>& cell,
                bool well_shaped) {
  using Element = std::remove_cvref_t<decltype(elements.element)>;
  if constexpr (HasCellShape<Element>) {
    static_assert(corner_count(Element::shape) == n,
                  "strike: the shape of this element has another number of corners than the element has nodes.");
    if constexpr (n == 8 && !merges_corners<Element>())
      if (const std::size_t corners = count_different(cell); corners == 6 || corners == 5)
        throw Error(joined({"strike: ", elements.describe(nodes, place), " is a ", corners == 6 ? "wedge" : "pyramid",
                            ", which its element does not take; use Hex8, or split it by tetrahedralized(mesh)."}));
    if (well_shaped && CellLaws<Element::shape>::names_right(cell)) return;
  }
  const CellCorners<n> x = corners_at(nodes, cell);
  check_resolution(elements, nodes, place, x);
  if constexpr (HasCellShape<Element>)
    if (!is_sound<Element::shape>(cell, x))
      throw Error(joined({"strike: ", elements.describe(nodes, place), " ", fault_of<Element::shape>(cell, x)}));
}

/// Error: an element without a positive mass.
template <class Elements, class N>
void check_mass(const Elements& elements, const N& nodes, std::size_t place, double mass) {
  if (!(mass > 0))
    throw Error(joined({"strike: ", elements.describe(nodes, place),
                        " has no positive mass; its corners are in the wrong order or coincide."}));
}

/// Error: a plate that is normal to the direction of its section's fibres, in lane l of a state.
template <class Elements, class N, class State>
void check_direction(const Elements& elements, const N& nodes, std::size_t place, const State& state, std::size_t l) {
  if constexpr (requires { elements.material.is_aligned(state.material, l); })
    if (!elements.material.is_aligned(state.material, l))
      throw Error(joined({"strike: ", elements.describe(nodes, place),
                          " is normal to the FibreDirection of its section, so that its fibres have no direction; "
                          "choose another, or give such plates a part of their own."}));
}

/// Errors: a particle without a volume, or with one that is not positive; a strain by which those that have none are to
/// be deleted.
template <class Elements>
[[gnu::cold]] void check_particles(const Elements& elements, const std::vector<double>& volumes) {
  const std::string part = std::to_string(elements.number);
  if (volumes.size() != elements.size)
    throw Error(joined({"strike: part ", part, " has ", std::to_string(elements.size), " particles, but ",
                        std::to_string(volumes.size()), " volumes; give one for each."}));
  for (std::size_t e = 0; e < volumes.size(); ++e)
    if (!(volumes[e] > 0 && std::isfinite(volumes[e])))
      throw Error(joined({"strike: particle ", std::to_string(e), " of part ", part, " has the volume ",
                          text(volumes[e]), "; it must be positive and finite."}));
  const auto check_strain = [&](const auto& law) {
    if constexpr (requires { law.strain; } && !Elements::measures_strain)
      if (std::isfinite(law.strain))
        throw Error(joined({"strike: the particles of part ", part,
                            " have no plastic strain by which Erosion{.strain = ", text(law.strain),
                            "} could delete them; limit them by .volume or .step."}));
  };
  if constexpr (Elements::is_born)
    check_strain(elements.removal.erosion);
  else
    check_strain(elements.removal);
}

[[noreturn, gnu::cold, gnu::noinline]] inline void explain_inversion(const std::string& element, double volume) {
  if (std::isnan(volume)) throw Error(joined({element, " has the volume nan: look at the formulas of its element"}));
  throw Error(joined({element, " is inverted (volume ", text(volume),
                      "); refine the mesh there, use a smaller step factor or let the material fail"}));
}

}  // namespace strike::detail
