// The element of docs/write_an_element.md.
#include <cmath>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>

#include "conformance/element.hpp"
#include "examples/own_element/truss.hpp"

using namespace strike;
using namespace strike::verify;

static_assert(Element<Truss, Wire> && Material<Wire> && !Element<Truss>);

namespace {

const Truss truss{.area = 1};

Nodal<double, 2> ends() {
  Nodal<double, 2> x;
  x << 0, 1,  //
      0, 0,   //
      0, 0;
  return x;
}

}  // namespace

TEST_CASE("conformance: an element with a pair of measure and stress of its own") {
  const testing::Shapes<2> shapes(1, ends());
  const Wire metal{.density = 1, .youngs_modulus = 1, .yield_stress = 4e-3};
  testing::rigid_motions_give_no_force(truss, metal, shapes, testing::FiniteRotations::exact);
  testing::forces_and_moments_sum_to_zero(truss, metal, shapes);
  testing::creates_no_energy(truss, Wire{.density = 1, .youngs_modulus = 1, .yield_stress = 0}, shapes);
  testing::books_its_work(truss, metal, shapes);
  testing::lanes_agree<Pack<double, 8>>(truss, metal, shapes);

  testing::Shapes<2> some = shapes;
  for (int i = 0; i < 10; ++i) {
    SingleElement single{truss, metal, some()};
    CHECK(single.vibration().critical_step() == Approx(single.now().stable_step).epsilon(1e-9));  // l/c
  }
}

TEST_CASE("a wave in a chain of one's own elements, at the step h/c, is exact at every node") {
  constexpr Index n = 20;
  std::vector<Eigen::Vector3d> nodes{{0, 0, 0}};
  Cells<2> bars;
  for (Index i = 0; i < n; ++i) nodes.emplace_back(0.5 * (i + 1), 0, 0), bars.push_back({i, i + 1});
  const double c = 2, v = 1e-6;  // E = 4: rho c v is the stress behind the front
  Explicit run{Scene{nodes, Part{truss, Wire{.density = 1, .youngs_modulus = 4, .yield_stress = 1}, bars},
                     InitialVelocity{{v, 0, 0}}, Pinned{{0}}},
               {.step_factor = 1}};
  for (Index step = 1; step <= n; ++step) {
    run.step();
    const std::vector<double> stress = run.part<0>().field([](const auto& state) { return state.stress; });
    for (Index e = 0; e < n; ++e) CHECK(std::abs(stress[e] / (c * v) - (e < step ? 1 : 0)) <= n * v);  // strains of v/c
  }
}
