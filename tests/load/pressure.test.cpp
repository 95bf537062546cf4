#include <vector>

#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/pressure.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

const Elastic rubber{.density = 1, .youngs_modulus = 100};

/// Deletes elements whose middle, of coordinates that they keep, is beyond x = 0.5 once they have moved by z = 0.01.
struct BeyondHalf {
  double height;
  template <class State, class E, class M, class T, bool has_geometry>
  auto keeps(const State&, const ElementCondition<E, M, T, has_geometry>& element) const {
    T x = T(0.0), z = T(0.0);
    for (int i = 0; i < E::nodes; ++i)
      x += T(1.0 / E::nodes) * element.position(0, i), z += T(1.0 / E::nodes) * element.position(2, i);
    return T(x - 0.5) < select(z > height, T(0.0), T(1e9));
  }
};

}  // namespace

TEST_CASE("pressure ends with its faces: nodes of plates that are gone fly on at their velocity") {
  const Mesh mesh = rectangle({.size = {1, 1}, .cells = {4, 4}});
  Explicit run{
      Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{rubber}, 0.1}, mesh.quadrilaterals, BeyondHalf{0.01}},
            Pressure{quadrilateral_surface(mesh.quadrilaterals), [](double) { return -1.0; }}},
      ExplicitOptions{.largest_step = 1e-3}};
  run.until(0.1);
  REQUIRE(run.part<0>().deleted() == 8);
  // Free plates rise with the acceleration p/(rho h) = 10, until z = 0.01 or, where some are left, further; a step adds
  // 0.01.
  const Index far = 14, near = 10;
  const double v = run.nodes().v(far).z(), work = run.energy().external;
  CHECK(v == Approx(std::sqrt(2 * 10 * 0.01)).epsilon(0.05));
  CHECK(run.nodes().v(near).z() == Approx(10 * 0.1).epsilon(0.1));
  run.until(0.15);
  CHECK(run.nodes().v(far).z() == v);
  CHECK(run.energy().external > work);
  CHECK(std::abs(run.energy().error()) < 0.01);
}

TEST_CASE("pressure on a face of solids ends with the solid, and goes on where others keep theirs") {
  const Mesh mesh = box({.size = {1, 1, 0.25}, .cells = {4, 4, 1}});
  std::vector<Face> under;
  for (const Face& face : surface(mesh))
    if (area_vector(mesh.nodes, face).z() < -0.01) under.push_back(face);
  REQUIRE(under.size() == 16);
  Explicit run{
      Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra, BeyondHalf{0.135}}, Pressure{under, Constant{1}}}};
  run.until(0.5);
  REQUIRE(run.part<0>().deleted() == 8);
  const auto v = run.nodes().v(4);
  run.until(0.6);
  CHECK(run.nodes().v(4) == v);
  CHECK(std::abs(run.energy().error()) < 0.01);
}

TEST_CASE("without deletions pressure is what it was, and faces of no element never end") {
  Pressure pressure{{{.nodes = {0, 1, 2, 2}, .cell = 0}}, Constant{6}};
  Nodes<double> nodes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
  const std::vector<PartFaces> parts{{.cells = 1, .faces = {{{0, 2, 1, 1}, 0}}, .erodes = true}};
  Pressure same = pressure;
  pressure.begin(nodes), same.begin(nodes, parts);
  pressure.apply_loads(nodes, 0);
  CHECK(nodes.f(0) == Eigen::Vector3d(0, 0, -1));
  same.remove(0, {false});  // the triangle from its other side, by another repeated corner
  same.apply_loads(nodes, 0);
  CHECK(nodes.f(0) == Eigen::Vector3d(0, 0, -1));
  CHECK(same.power(nodes) == 0);
  pressure.remove(0, {false});
  pressure.apply_loads(nodes, 0);
  CHECK(nodes.f(0) == Eigen::Vector3d(0, 0, -2));
}
