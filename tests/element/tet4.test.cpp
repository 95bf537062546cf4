#include <cmath>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/fluid.hpp>

#include "conformance/element.hpp"
#include "problems/free_tetrahedra.hpp"

using namespace strike;
using namespace strike::verify;
using testing::conforms;
using testing::FiniteRotations;

TEST_CASE("conformance: Tet4 with its own pressure") {
  conforms(Tet4{ElementPressure{}}, FiniteRotations::exact, unit_tetrahedron());
}
TEST_CASE("conformance: Tet4 of Jaumann without bulk viscosity, measured at the end of the step") {
  conforms(Tet4{ElementPressure{}, Jaumann{}, NoBulkViscosity{}, EndStep{}}, FiniteRotations::strain,
           unit_tetrahedron());
}
// The rate of its volume is that of a finite step, which no step of 1e-15 has to any digit: linear fields are below.
TEST_CASE("conformance: Tet4 that is alone with the pressure of its nodes") {
  for (const double share : {0.9, 1.0}) {
    const Tet4 element{NodalPressure{share}};
    const testing::Shapes<4> shapes(1, unit_tetrahedron());
    testing::gradient_is_that_of_the_volume(element, shapes);
    testing::rigid_motions_give_no_force(element, Elastic{1, 1, 0.3}, shapes, FiniteRotations::exact);
    testing::forces_and_moments_sum_to_zero(element, testing::metal, shapes);
    testing::creates_no_energy(element, testing::ConstantStress{}, shapes);
    testing::books_its_work(element, testing::metal, shapes);
    testing::lanes_agree<Pack<double, 8>>(element, testing::metal, shapes);
    testing::lanes_agree<Pack<float, 16>>(element, testing::metal, shapes);
    testing::stable_step_is_safe(element, shapes);
    testing::failed_elements_are_silent(element, testing::brittle, shapes);
  }
}

TEST_CASE("Tet4: in a linear field all elements of a mesh have one stress, and inner nodes no force") {
  const Mesh mesh = free_tetrahedra::block(3, 0.2);
  Eigen::Matrix3d L;
  L << 0.2, 0.1, -0.3, 0.4, 0.3, 0.1, -0.2, 0.5, 0.1;  // no compression: bulk viscosity depends on the size
  const auto one_stress = [&](const auto& element) {
    Explicit run{
        Scene{mesh.nodes, Part{element, Elastic{1, 1, 0.3}, mesh.tetrahedra}, free_tetrahedra::HomogeneousVelocity{L}},
        {},
        in<double>};
    run.step();
    const auto one = run.template part<0>().blocks()[0].state.material.stress;
    for (const auto& block : run.template part<0>().blocks())
      CHECK((block.state.material.stress - one).matrix().norm() <= 1e-12 * one.matrix().norm());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (const auto& x = mesh.nodes[i]; x.minCoeff() > 0.2 && x.maxCoeff() < 0.8)
        CHECK(run.nodes().f(i).norm() <= 1e-13 * one.matrix().norm());
  };
  one_stress(Tet4{ElementPressure{}});
  one_stress(Tet4{NodalPressure{1}});
  one_stress(Tet4{});
}

TEST_CASE("Tet4: forces and moments of a mesh sum to zero, and the energy balances, with the pressure of its nodes") {
  const Mesh mesh = free_tetrahedra::block(3, 0.2);
  for (const double share : {0.5, 1.0}) {
    Explicit run{Scene{mesh.nodes, Part{Tet4{NodalPressure{share}}, testing::metal, mesh.tetrahedra},
                       free_tetrahedra::RandomVelocity{0.05}}};
    for (int i = 0; i < 200; ++i) {
      run.step();
      Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
      double scale = 0;
      for (std::size_t k = 0; k < run.nodes().size(); ++k) {
        force += run.nodes().f(k), moment += run.nodes().x(k).cross(run.nodes().f(k));
        scale += run.nodes().f(k).norm();
      }
      REQUIRE(force.norm() <= 1e-14 * scale);
      REQUIRE(moment.norm() <= 1e-14 * scale);
      REQUIRE(std::abs(run.energy().error()) < 2e-3);
    }
  }
}

TEST_CASE("Tet4: alone it is the same whatever its pressure is a mean of") {
  testing::Shapes<4> shapes(3, unit_tetrahedron());
  for (int trial = 0; trial < 10; ++trial) {
    const Nodal<double, 4> x = shapes();
    SingleElement own{Tet4{ElementPressure{}}, testing::metal, x};
    SingleElement nodal{Tet4{NodalPressure{1}}, testing::metal, x};
    for (int i = 0; i < 5; ++i) {
      const Nodal<double, 4> v = shapes.nodal();
      const auto& a = own.step(v, 0.01);
      const auto& b = nodal.step(v, 0.01);
      CHECK((a.force - b.force).norm() <= 1e-12 * a.x.squaredNorm());  // of the modulus
      CHECK(a.internal == Approx(b.internal).epsilon(1e-9).margin(1e-15));
    }
  }
}

TEST_CASE("Tet4: the step knows a Newtonian viscosity") {
  const Fluid honey{LinearEos{.density = 1, .bulk_modulus = 1}, Newtonian{5}};
  testing::Shapes<4> shapes(13, unit_tetrahedron());
  for (int trial = 0; trial < 20; ++trial) {
    const SingleElement single{Tet4{}, honey, shapes()};
    const double ratio = single.now().stable_step / single.vibration().critical_step();
    CHECK(ratio <= 1 + 1e-9);
    CHECK(ratio >= 0.6);
  }
}

TEST_CASE("Tet4: absent physics has no state") {
  using M = Elastic;
  static_assert(sizeof(Tet4<ElementPressure, HughesWinget, NoBulkViscosity>::State<M, double>) ==
                (1 + 6) * sizeof(double));
  static_assert(sizeof(Tet4<ElementPressure>::State<M, double>) == (1 + 1 + 6) * sizeof(double));
  static_assert(sizeof(Tet4<>::State<M, double>) == (1 + 1 + 1 + 6) * sizeof(double));
  static_assert(sizeof(Tet4<ElementPressure>) == 2 * sizeof(double));  // C0, C1
  static_assert(Element<Tet4<>> && Element<Tet4<ElementPressure>>);
  SUCCEED();
}
