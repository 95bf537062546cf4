#pragma once
// Wrong numbers (conformance/numbers.hpp) in materials, sections, elements and their pieces, which run in one element
// or at one point:
//   TEST_CASE("conformance: wrong numbers of my law") { testing::refuses_wrong_numbers(my_law); }
#include <array>
#include <cmath>
#include <cstddef>

#include <strike/element.hpp>
#include <strike/material.hpp>
#include <strike/section.hpp>
#include <strike/verify/single_element.hpp>

#include "conformance/material.hpp"
#include "conformance/numbers.hpp"

namespace strike::testing {

namespace detail {

/// Two closed cycles of strain: finite stresses, and but for a small part no energy comes back.
template <class M>
bool cycles(const M& material) {
  constexpr double amplitude = 1e-3;
  constexpr auto components = component<Tensor<M>>;
  constexpr std::array A{1., .5, -.3, .2, -.7, .8}, B{-.4, .9, .2, -.8, .6, -.1};
  constexpr int cycle[6][2] = {{1, 0}, {0, 1}, {-1, -1}, {0, 1}, {-1, 0}, {1, -1}};
  Point<M, double> point(material);
  double work = 0, turnover = 0;
  for (const auto& [a, b] : cycle) {
    Tensor<M> strain{};
    for (std::size_t c = 0; c < components.size(); ++c) strain.*components[c] = amplitude / 10 * (a * A[c] + b * B[c]);
    for (int i = 0; i < 10; ++i) {
      const Tensor<M> before = point.stress;
      point.step(strain, 1e-6);
      const double done = 0.5 * point.J * double_dot(before + point.stress, strain);
      work += done, turnover += std::abs(done);
      if (!std::isfinite(norm(point.stress))) return false;
    }
  }
  constexpr bool burns = requires { material.burn; };
  return burns || work >= -4 * amplitude * turnover;
}

/// An element that is strained, bent out of shape and brought back.
template <class E, class M>
bool cycles(const E& element, const M& material) {
  verify::SingleElement single{element, material, verify::unit_corners<E>()};
  const double dt = 0.1 * single.now().stable_step;
  if (!(dt > 0 && std::isfinite(dt))) return false;
  Nodal<double, motions<E>> v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = std::sin(1 + 2.3 * static_cast<double>(i * i));
  double turnover = 0;
  for (int i = 0; i < 40; ++i) {
    const double before = single.now().external;
    const auto& now = single.step((i < 10 || i >= 30 ? 1 : -1) * (1e-4 / dt) * v, dt);
    turnover += std::abs(now.external - before);
    if (!now.force.allFinite() || !std::isfinite(now.internal + now.hourglass + now.bulk_viscosity)) return false;
  }
  return single.now().internal + single.now().hourglass + single.now().bulk_viscosity >= -1e-2 * turnover;
}

inline const Elastic soft_metal{.density = 2700, .youngs_modulus = 70e9, .poissons_ratio = .3};

/// Runs what a model is made for, which a Part, say, has checked.
template <class Model>
bool works(const Model& model) {
  check_ranges(model);
  constexpr LinearEos eos{.density = 2700, .bulk_modulus = 71e9};
  if constexpr (requires { Model::nodes; }) {
    if constexpr (turns_nodes<Model>())
      return cycles(model, Homogeneous{PlaneStress{soft_metal}, 0.1});
    else
      return cycles(model, soft_metal);
  } else if constexpr (SolidMaterial<Model>) {
    return cycles(model);
  } else if constexpr (PlaneMaterial<Model>) {
    return cycles(model);
  } else if constexpr (PlateSection<Model>) {
    return cycles(Plate4{}, model);
  } else if constexpr (EquationOfState<Model>) {
    return cycles(Hex8{}, Fluid{model}) && works(Solid{model, ElasticStrength{1e9}});
  } else if constexpr (Strength<Model>) {
    return works(Solid{eos, model});
  } else {
    return works(Solid{eos, VonMises{.shear_modulus = 27e9, .yield_stress = 1e6}, model});
  }
}

}  // namespace detail

/// The sentence by which a model is refused; empty if it is not.
template <class Model>
std::string refusal(const Model& model) {
  try {
    detail::check_ranges(model);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

template <class Model>
void refuses_wrong_numbers(const Model& model, WrongNumbers& tried) {
  refuses_wrong_numbers(model, tried, [](const Model& changed) { return detail::works(changed); });
}
template <class Model>
void refuses_wrong_numbers(const Model& model) {
  WrongNumbers tried;
  refuses_wrong_numbers(model, tried);
}

}  // namespace strike::testing
