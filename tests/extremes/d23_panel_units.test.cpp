#include <array>
#include <cmath>
#include <numbers>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// Meters, seconds and kilograms per unit.
struct System {
  double length, time, mass;
};

/// Half of the explosively loaded panel for 40 microseconds: displacement of the crown over the radius, energies over
/// the initial one, plastic strain, and the number of steps.
std::array<double, 6> panel_in(const System& unit) {
  const double stress = unit.mass / (unit.length * unit.time * unit.time);
  const double radius = 74.6125e-3 / unit.length, length = 319.024e-3 / unit.length, h = 3.175e-3 / unit.length;
  const double speed = 143.51 / (unit.length / unit.time), E = 72.395e9 / stress, nu = 0.33;
  const double arc = std::numbers::pi / 3;
  const PlaneStress aluminium{Solid{
      LinearEos{.density = 2671.1 / (unit.mass / std::pow(unit.length, 3)), .bulk_modulus = E / (3 * (1 - 2 * nu))},
      VonMises{.shear_modulus = E / (2 * (1 + nu)), .yield_stress = 303.37e6 / stress}}};
  const Mesh mesh = panel({.radius = radius, .length = length, .arc = {0, arc}, .cells = {8, 16}});
  const auto blast = [=](const Eigen::Vector3d& x) {
    const bool loaded = std::atan2(x.x(), x.z()) < 0.51 * arc && std::abs(x.y() / length - 0.5) < 0.41;
    return Eigen::Vector3d(loaded ? Eigen::Vector3d(-speed / radius * Eigen::Vector3d(x.x(), 0, x.z()))
                                  : Eigen::Vector3d::Zero());
  };
  const std::vector<Index> side =
      nodes_where(mesh.nodes, [&](const auto& x) { return std::atan2(x.x(), x.z()) > arc - 1e-6; });
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, Homogeneous{aluminium, h, Simpson<3>{}}, mesh.quadrilaterals},
                     InitialVelocityField{blast}, Symmetry{Axis::x, nodes_where(mesh.nodes, on_plane(Axis::x, 0))},
                     Clamped{side}, Pinned{nodes_where(mesh.nodes, on_plane(Axis::y, 0))},
                     Pinned{nodes_where(mesh.nodes, on_plane(Axis::y, length))}}};
  run.until(40e-6 / unit.time);
  double plastic = 0;
  for (const double e : run.part<0>().field([](const auto& point) { return point.equivalent_plastic_strain; }))
    plastic += e;
  const Energy& energy = run.energy();
  const Index crown = nearest_node(mesh.nodes, {0, length / 2, radius});
  return {1 - run.nodes().x(crown).z() / radius,
          energy.kinetic / energy.initial,
          energy.internal / energy.initial,
          energy.hourglass / energy.initial,
          plastic,
          static_cast<double>(run.steps())};
}

}  // namespace

TEST_CASE("D23: the panel gives the same dimensionless answer in inches and pounds of force as in SI units") {
  const auto si = panel_in({1, 1, 1}), inches = panel_in({0.0254, 1, 4.4482216152605 / 0.0254});
  for (std::size_t i = 0; i < si.size(); ++i) CHECK(inches[i] == Approx(si[i]).epsilon(1e-6));
  CHECK(si[0] > 0.05);  // 143.5 m/s times 40 us over R is 0.077, and the panel resists
}
