#include <array>
#include <cmath>

#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/solid.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
const Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9}, ElasticStrength{.shear_modulus = 43.3e9}};
const Fluid water{CubicEos{.density = 1000, .C1 = 2.19e9}};

template <class M>
double wave_speed(const M& material) {
  const typename M::template State<double> state{};
  return std::sqrt(material.moduli(state, {}).wave() / density_of(material));
}
template <class M>
double impedance(const M& material) {
  return density_of(material) * wave_speed(material);
}

}  // namespace

// Steel strikes copper, which lies against water: three parts of different elements and materials that share the nodes
// between them. Each has elements of the length c dt, so that the waves are exact at every node, those that pass or
// return from the interfaces too: with the impedance Z = rho c, a wave s passes as s 2 Z2/(Z1 + Z2).
TEST_CASE("waves through three parts of different elements and materials") {
  const Index N = 20;
  const double dt = 1e-6, v = 0.01, width = 0.01;  // strains below 1e-5
  const std::array h{wave_speed(steel) * dt, wave_speed(copper) * dt, wave_speed(water) * dt};
  const Mesh mesh = transformed(column(3 * N, 3 * N, width), [&](const Eigen::Vector3d& x) {
    const double k = std::round(x[0]);
    const auto within = [&](double begin) { return std::min(std::max(k - begin, 0.0), double(N)); };
    return Eigen::Vector3d(h[0] * within(0) + h[1] * within(N) + h[2] * within(2 * N), x[1], x[2]);
  });
  const auto cells = [&](Index part) {
    const auto begin = mesh.hexahedra.begin() + part * N;
    return Cells<8>(begin, begin + N);
  };
  const double Z1 = impedance(steel), Z2 = impedance(copper), Z3 = impedance(water);
  const double interface = N * h[0];
  const std::vector<Index> all = all_nodes(mesh.nodes);
  const auto moving = nodes_where(mesh.nodes, [&](const auto& x) { return x[0] < interface - 1e-9; });
  Explicit run{Scene{mesh.nodes, Part{Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}}, steel, cells(0)},
                     Part{Hex8{StiffnessHourglass{}, Jaumann{}, NoBulkViscosity{}}, copper, cells(1)},
                     Part{Hex8{ViscousHourglass{}, HughesWinget{}, NoBulkViscosity{}}, water, cells(2)},
                     InitialVelocity{{v, 0, 0}, moving},
                     InitialVelocity{{v * Z1 / (Z1 + Z2), 0, 0}, section(mesh, interface)},  // by momentum
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}},
               ExplicitOptions{.step_factor = 10, .largest_step = dt}, in<double>};

  const double s = v * Z1 * Z2 / (Z1 + Z2), passed = s * 2 * Z3 / (Z2 + Z3);
  while (run.steps() < 30) run.step();
  std::vector<double> stress = run.part<0>().field([](const auto& state) { return -state.stress.xx; });
  for (const double q : run.item<1>().field([](const auto& state) { return -state.stress.xx; })) stress.push_back(q);
  for (const double q : run.item<2>().field([](const auto& state) { return state.pressure; })) stress.push_back(q);
  for (Index e = 0; e < 3 * N; ++e) {
    INFO("element " << e);
    const double expected = e < 10 ? 0 : e < 30 ? s : e < 50 ? passed : 0;
    CHECK(std::abs(stress[e] - expected) < 1e-4 * s);
  }
  CHECK(run.momentum().x() == Approx((N * h[0] * Z1 / wave_speed(steel)) * v * width * width).epsilon(1e-12));
  CHECK(std::abs(run.energy().error()) < 1e-4);
}
