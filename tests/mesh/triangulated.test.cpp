#include <cmath>

#include <strike/mesh.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A sheet of quadrilaterals of many shapes, none of them concave.
Mesh wavy() {
  return sheet({5, 4}, [](double s, double t) {
    return Eigen::Vector3d(s + 0.05 * std::sin(9 * t), 0.7 * t + 0.04 * std::sin(7 * s), 0);
  });
}
Eigen::Vector3d vector_area(const Mesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Face& face : surface(mesh)) sum += area_vector(mesh.nodes, face);
  return sum;
}
double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& cell : mesh.triangles) sum += triangle_area(mesh.nodes, cell);
  return sum;
}

}  // namespace

TEST_CASE("triangulated: two triangles to a quadrilateral, by its shorter diagonal, on the same area and side") {
  const Mesh whole = wavy(), cut = triangulated(whole);
  CHECK(cut.quadrilaterals.empty());
  REQUIRE(cut.triangles.size() == 2 * whole.quadrilaterals.size());
  check(cut);
  CHECK((vector_area(cut) - vector_area(whole)).norm() <= 1e-15);
  CHECK(area(cut) == Approx(vector_area(whole).z()).epsilon(1e-14));
  for (std::size_t e = 0; e < whole.quadrilaterals.size(); ++e) {
    const auto& [a, b, c, d] = whole.quadrilaterals[e];
    const double first = (whole.nodes[a] - whole.nodes[c]).norm(), second = (whole.nodes[b] - whole.nodes[d]).norm();
    const auto& last = cut.triangles[2 * e + 1];
    CHECK(last == (first <= second * (1 + 1e-10) ? std::array{a, c, d} : std::array{b, c, d}));
  }
  Mesh three{.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .quadrilaterals = {{0, 1, 2, 2}}};
  CHECK(triangulated(three).triangles == Cells<3>{{0, 1, 2}});
  three.quadrilaterals = {{1, 1, 2, 0}};
  CHECK(triangulated(three).triangles.size() == 1);
}

TEST_CASE("triangles of a mesh are mirrored, appended, renumbered, merged and looked for with the rest") {
  const Mesh cut = triangulated(wavy());
  const Mesh image = mirrored(cut, unit(Axis::x));
  CHECK((vector_area(image) - vector_area(cut)).norm() <= 1e-15);  // it faces the side that it faced

  Mesh both = cut;
  const Index offset = append(both, translated(cut, {1, 0, 0}));
  REQUIRE(both.triangles.size() == 2 * cut.triangles.size());
  CHECK(both.triangles.back()[2] == cut.triangles.back()[2] + offset);
  check(both);
  both = merge_coincident_nodes(both, 1e-9);  // the wave is the same at both edges of the sheet but for 0.04 sin 7 s
  CHECK(area(both) == Approx(2 * area(cut)));

  Mesh left = cut;
  left.triangles.resize(1);
  CHECK(orphan_nodes(left).size() == cut.nodes.size() - 3);
  CHECK_THROWS_WITH(check(left), ContainsSubstring("belongs to no cell"));
  left = remove_orphan_nodes(left);
  CHECK(left.nodes.size() == 3);
  check(left);
}

TEST_CASE("check names a triangle without area, and one that names a node twice or one that is not there") {
  const auto refused = [](const std::array<Index, 3>& cell, const char* sentence) {
    const Mesh mesh{.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 3}, {1, 2, 3}, cell}};
    CHECK_THROWS_WITH(check(mesh), ContainsSubstring("strike: triangle 2 ") && ContainsSubstring(sentence));
  };
  refused({0, 1, 2}, "is flat at corner 0; give it corners that are not in one line.");
  refused({0, 1, 1}, "names node 1 twice; give it 3 different corners.");
  refused({0, 1, 4}, "names node 4, but the mesh has 4 nodes");
}

TEST_CASE("triangles of a plan are swept to wedges, with the volume of their area") {
  const Mesh plan = triangulated(wavy()), body = extruded(plan, std::array{0.0, 0.5, 2.0});
  CHECK(body.hexahedra.size() == 2 * plan.triangles.size());
  check(body);
  CHECK(volume(body) == Approx(2 * area(plan)).epsilon(1e-14));
}

TEST_CASE("inertia of triangles: that of the plates that they halve, and of a triangle alone the closed form") {
  const Mesh whole = wavy();
  std::vector<double> nodal(whole.nodes.size(), 0.0);
  const Inertia expected = inertia(whole, 7, 0.3), found = inertia(triangulated(whole), 7, 0.3, nodal);
  CHECK(found.mass == Approx(expected.mass).epsilon(1e-14));
  CHECK((found.centre - expected.centre).norm() <= 1e-15);
  CHECK((found.moment - expected.moment).matrix().norm() <= 1e-14 * expected.moment.matrix().norm());
  double sum = 0;
  for (const double m : nodal) sum += m;
  CHECK(sum == Approx(found.mass).epsilon(1e-14));

  // A right triangle with legs 1 along the axes has m/18 about each through its centre, and m/36 as their product; its
  // thickness adds t^2/12 m to both.
  const Mesh one{.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  const Inertia right = inertia(one, 2, 0.6);
  CHECK(right.mass == Approx(0.6));
  CHECK(right.moment.xx == Approx(0.6 * (1.0 / 18 + 0.03)));
  CHECK(right.moment.zz == Approx(0.6 / 9));
  CHECK(right.moment.xy == Approx(0.6 / 36));
  CHECK_THROWS_WITH(inertia(one, 2), ContainsSubstring("the thickness of the plates"));
}

TEST_CASE("particles fill closed surfaces of triangles as those of quadrilaterals") {
  Mesh skin = box({.size = {1, 2, 1}, .cells = {2, 4, 2}});
  for (const Face& face : surface(skin)) skin.quadrilaterals.push_back(face.nodes);
  skin.hexahedra.clear();
  const Mesh expected = particles(skin, 0.25), found = particles(triangulated(skin), 0.25);
  CHECK(found.particles.cells == expected.particles.cells);
  CHECK(volume(found) == Approx(2));
}
