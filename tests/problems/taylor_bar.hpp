#pragma once
// Taylor's copper bar: 3.2 mm x 32.4 mm strikes a rigid wall at 227 m/s; a quarter of it, the foot held on the wall.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/cylinder.hpp>

namespace strike::taylor {

struct Data {
  double radius, length, density, youngs_modulus, yield_stress, hardening_modulus, speed, end;
};
inline constexpr Data mm_ms_kg{3.2, 32.4, 8.93e-6, 117, 0.4, 0.1, 227, 0.08};

inline auto copper(const Data& data) {
  const double E = data.youngs_modulus, nu = 0.35;
  return Solid{LinearEos{.density = data.density, .bulk_modulus = E / (3 * (1 - 2 * nu))},
               VonMises{.shear_modulus = E / (2 * (1 + nu)),
                        .yield_stress = data.yield_stress,
                        .hardening_modulus = data.hardening_modulus}};
}

template <class T, class E = Hex8<>, class... Policies>
auto bar(const Data& data, const Mesh& mesh, In<T> number, const E& element = {}, const Policies&... policies) {
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  return Explicit{Scene{mesh.nodes, Part{element, copper(data), mesh.hexahedra}, InitialVelocity{{0, 0, -data.speed}},
                        Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)}, Symmetry{Axis::z, on(Axis::z)}},
                  ExplicitOptions{}, number, policies...};
}
template <class T, class E = Hex8<>, class... Policies>
auto bar(const Data& data, Index cells, Index layers, In<T> number, const E& element = {},
         const Policies&... policies) {
  return bar(data, cylinder({.radius = data.radius, .length = data.length, .cells = cells, .layers = layers}), number,
             element, policies...);
}

template <class Run>
double length(const Run& run) {
  double top = 0;
  for (const auto& x : run.positions()) top = std::max(top, x.z());
  return top;
}
template <class Run>
double radius(const Run& run) {
  double r = 0;
  for (const auto& x : run.positions()) r = std::max(r, std::hypot(x.x(), x.y()));
  return r;
}
template <class Run>
double plastic_strain(const Run& run) {
  const auto e = run.template part<0>().field([](const auto& state) { return state.equivalent_plastic_strain; });
  return *std::max_element(e.begin(), e.end());
}

}  // namespace strike::taylor
