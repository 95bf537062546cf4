#pragma once
#include <cstddef>

#include <strike/range.hpp>
#include <strike/scalar/math.hpp>
#include <strike/tensor/plane.hpp>

namespace strike {

/// An indicator of delamination from the interlaminar shear stresses, (tau_xz^2 + tau_yz^2)/S^2: 1 where they reach the
/// strength S of the interface (the shear terms of Brewer and Lagace 1988). The stress across, sigma_z, is not known to
/// a plate, so that impact right under a body, free edges and notches are not judged. It shows where layers may part
/// and changes nothing.
///   part.field(Delamination{.shear_strength = 60})        the largest of all interfaces
///   part.field(k, Delamination{.shear_strength = 60})     between layers k and k + 1
struct Delamination {
  double shear_strength;  ///< S [stress]

  void ranges(const auto& number) const { number("shear_strength", shear_strength, range::positive); }

  /// Of the interface over layer k of a section; of the top layer 0.
  template <class Section, class State>
  auto operator()(const Section& section, const State& state, std::size_t k) const {
    const auto tau = section.shear_stress(state, k, 1.0);
    const double c = k + 1 < section.layers() ? 1 / (shear_strength * shear_strength) : 0;
    return c * (tau(0) * tau(0) + tau(1) * tau(1));
  }
  /// Of all its interfaces.
  template <class Section, class State>
  auto operator()(const Section& section, const State& state) const {
    auto largest = (*this)(section, state, 0);
    for (std::size_t k = 1; k + 1 < section.layers(); ++k) largest = max(largest, (*this)(section, state, k));
    return largest;
  }
};

}  // namespace strike
