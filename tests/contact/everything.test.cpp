// One contact for a scene: what it finds, and where plates are.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/section/layered.hpp>

#include "contact/bodies.hpp"
#include "examples/own_element/truss.hpp"
#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using testing::apart;
using testing::append_body;

namespace {

const Elastic stiff{.density = 1, .youngs_modulus = 1000, .poissons_ratio = 0.3};
const Solid soft{LinearEos{.density = 1, .bulk_modulus = 800}, ElasticStrength{400}};

/// A block falls on another, which lies on a plate.
struct Stack {
  Mesh mesh = box({.lower = {0, 0, 0}, .size = {1, 1, 0.5}, .cells = {3, 3, 2}});
  Cells<8> lower = mesh.hexahedra, upper;
  std::vector<Index> falling;

  Stack() {
    falling = append_body(mesh, box({.lower = {0.1, 0.3, 0.51}, .size = {0.7, 0.7, 0.4}, .cells = {2, 2, 1}}));
    upper.assign(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(lower.size()), mesh.hexahedra.end());
    append(mesh, rectangle({.lower = {-0.5, -0.5, -0.051}, .size = {2, 2}, .cells = {6, 6}}));
  }
  auto plate() const { return Part{Plate4{}, Homogeneous{PlaneStress{soft}, 0.1}, mesh.quadrilaterals}; }
  template <class... Contacts>
  auto run(const Contacts&... contacts) const {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, stiff, lower}, Part{Hex8{}, stiff, upper}, plate(),
                          InitialVelocity{{0, 0.1, -1}, falling}, contacts...}};
  }
};

/// Where balls, cubes of 0.02, turn that fly at plates from above (side 1) or from below (-1): the height of their
/// nodes in front, at (x - 0.01 side, y - 0.01 side) [length].
std::vector<double> turns(const Mesh& plates, const auto& parts, const std::vector<Eigen::Vector2d>& at, double side) {
  Mesh mesh = plates;
  std::vector<Index> balls, front;
  for (const Eigen::Vector2d& xy : at) {
    const Eigen::Vector3d middle(xy.x(), xy.y(), 0.31 * side), half = Eigen::Vector3d::Constant(0.01);
    const Index first = append(mesh, box({.lower = middle - half, .size = 2 * half, .cells = {1, 1, 1}}));
    for (Index i = first; i < mesh.nodes.size(); ++i) balls.push_back(i);
    front.push_back(side > 0 ? first : static_cast<Index>(mesh.nodes.size() - 1));
  }
  const Cells<8> cells(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(plates.hexahedra.size()),
                       mesh.hexahedra.end());
  std::vector<Index> held(plates.nodes.size());
  for (Index i = 0; i < held.size(); ++i) held[i] = i;
  return std::apply(
      [&](const auto&... part) {
        Explicit run{Scene{mesh.nodes, part..., Part{Hex8{}, stiff, cells}, Clamped{held},
                           InitialVelocity{{0, 0, -0.5 * side}, balls}, Contact{Everything{}}}};
        std::vector<double> turn(at.size(), 10 * side);
        run.until(0.8, [&] {
          for (std::size_t k = 0; k < at.size(); ++k)
            turn[k] = side * std::min(side * turn[k], side * run.nodes().x(front[k]).z());
        });
        return turn;
      },
      parts);
}

}  // namespace

TEST_CASE("everything touches as the pairings do that say it by hand") {
  const Stack stack;
  const Surface lower = solid_surface(stack.lower, 0), upper = solid_surface(stack.upper, 1),
                plate = plate_surface(stack.mesh.quadrilaterals, 0.1, 2);
  const auto after = [](auto run) {
    run.until(0.5);
    return run.positions();
  };
  const auto all = after(stack.run(Contact{Everything{}}));
  CHECK(all == after(stack.run(Contact{SelfContact{lower + upper + plate}})));
  CHECK(all == after(stack.run(Contact{SelfContact{plate + upper + lower}})));
  CHECK(apart(all, after(stack.run(Contact{TwoWay{lower + plate, upper}}, Contact{TwoWay{lower, plate}}))) < 1e-6);
  CHECK(apart(all, after(stack.run())) > 0.1);
}

TEST_CASE("pairs of parts can be left out of everything") {
  const Stack stack;
  const auto after = [](auto run) {
    run.until(0.5);
    return run.positions();
  };
  CHECK(after(stack.run(Contact{Everything{.except = {{{0, 1}}, {{1, 2}}, {{2, 0}}}}})) == after(stack.run()));
  const Surface lower = solid_surface(stack.lower, 0), upper = solid_surface(stack.upper, 1);
  CHECK(apart(after(stack.run(Contact{Everything{.except = {{{2, 0}}, {{1, 2}}}}})),
              after(stack.run(Contact{TwoWay{lower, upper}}))) < 1e-9);
  CHECK_THROWS_WITH(stack.run(Contact{Everything{.except = {{{0, 3}}}}}),
                    "strike: Everything excepts part 3, but the scene has 3 parts; count its parts from 0.");
}

TEST_CASE("a face that two parts share is inside") {
  // Two blocks in one piece, of two parts or of one: a third falls on their common edge.
  Mesh mesh = box({.lower = {-1, 0, 0}, .size = {2, 1, 0.5}, .cells = {4, 2, 1}});
  const Cells<8> both = mesh.hexahedra;
  const auto falling =
      append_body(mesh, box({.lower = {-0.3, 0.2, 0.51}, .size = {0.6, 0.6, 0.3}, .cells = {2, 2, 1}}));
  Cells<8> left, right, third(mesh.hexahedra.begin() + 8, mesh.hexahedra.end());
  for (const auto& cell : both) (mesh.nodes[cell[0]].x() < -0.1 ? left : right).push_back(cell);
  Explicit two{Scene{mesh.nodes, Part{Hex8{}, stiff, left}, Part{Hex8{}, stiff, right}, Part{Hex8{}, stiff, third},
                     InitialVelocity{{0, 0, -1}, falling}, Contact{Everything{}}}};
  Explicit one{Scene{mesh.nodes, Part{Hex8{}, stiff, both}, Part{Hex8{}, stiff, third},
                     InitialVelocity{{0, 0, -1}, falling}, Contact{Everything{}}}};
  CHECK(two.warnings().empty());
  two.until(0.3), one.until(0.3);
  CHECK(apart(two.positions(), one.positions()) < 1e-12);
  CHECK(one.contact<0>().impulse().norm() < 1e-12);  // on all nodes of the scene
}

TEST_CASE(
    "plates are touched at half the thickness of their part, at the mean where two meet, and where their offset puts "
    "them") {
  const Mesh plates = rectangle({.lower = {-2, -1, 0}, .size = {4, 2}, .cells = {8, 4}});
  Cells<4> thin, thick;
  for (const auto& cell : plates.quadrilaterals) (plates.nodes[cell[0]].x() < -0.1 ? thin : thick).push_back(cell);
  const std::vector<Eigen::Vector2d> at{{-1.2, 0.3}, {0, 0.3}, {1.2, 0.3}};
  for (const double side : {1.0, -1.0})
    for (const double offset : {0.0, 0.1, -0.05}) {
      const auto section = [&](double h) { return Homogeneous{PlaneStress{soft}, h, Offset{offset}}; };
      const std::tuple parts{Part{Plate4{}, section(0.1), thin}, Part{Plate4{}, section(0.2), thick}};
      const std::vector<double> found = turns(plates, parts, at, side);
      CAPTURE(side, offset);
      CHECK(found[0] == Approx(offset + side * 0.05).margin(1e-9));
      // The thickness goes from 0.15 at the seam to 0.1 over a cell of 0.5, and the corner is 0.01 beside the seam; the
      // ball has a size, so that the other corners touch too.
      CHECK(found[1] == Approx(offset + side * (0.075 - side * 0.01 / 0.5 * 0.025)).margin(5e-5));
      CHECK(found[2] == Approx(offset + side * 0.1).margin(1e-9));
    }
}

TEST_CASE("a plate on the skin of a solid is touched at its own surface") {
  const Mesh slab = box({.lower = {-1, -1, -1}, .size = {2, 2, 1}, .cells = {4, 4, 2}});
  Cells<4> skin;
  for (const Face& face : surface(slab))
    if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](Index i) { return slab.nodes[i].z() > -1e-9; }))
      skin.push_back(face.nodes);
  REQUIRE(skin.size() == 16);
  const std::tuple parts{Part{Hex8{}, stiff, slab.hexahedra},
                         Part{Plate4{}, Homogeneous{PlaneStress{soft}, 0.1}, skin}};
  for (const double height : turns(slab, parts, {{0.1, 0.1}, {0.6, -0.7}}, 1))
    CHECK(height == Approx(0.05).margin(1e-9));
}

TEST_CASE("everything goes on after an interruption, with threads and in float") {
  const Stack stack;
  const auto scene = [&] {
    return Scene{stack.mesh.nodes,
                 Part{Hex8{}, stiff, stack.lower},
                 Part{Hex8{}, stiff, stack.upper},
                 stack.plate(),
                 InitialVelocity{{0, 0.1, -1}, stack.falling},
                 Contact{Everything{}, Coulomb{0.2}}};
  };
  Explicit whole{scene()};
  Explicit threads{scene(), OpenMP{3}};
  Explicit single{scene(), in<Pack<float>>};
  whole.until(0.4), threads.until(0.4), single.until(0.4);
  CHECK(whole.positions() == threads.positions());
  CHECK(apart(whole.positions(), single.positions()) < 1e-5);

  const ScratchFolder folder("everything");
  Explicit first{scene()}, second{scene()};
  for (int n = 0; n < 25; ++n) first.step();
  write_checkpoint(folder / "half", first);
  read_checkpoint(folder / "half", second);
  second.until(0.4);
  CHECK(second.positions() == whole.positions());
}

TEST_CASE("everything meets the faces that deletions expose, of the same part and of its neighbour") {
  // A hard cube of 0.5 falls on two of 1, the upper of which, a part of its own, fails first.
  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 10}, VonMises{.shear_modulus = 4, .yield_stress = 0.2},
                      UltimateStress{0.199}};
  const Elastic hard{.density = 8, .youngs_modulus = 100, .poissons_ratio = 0.3};
  Mesh mesh = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  const auto falling = append_body(mesh, box({.lower = {0.25, 0.25, 2.01}, .size = {0.5, 0.5, 0.5}}));
  const Cells<8> lower{mesh.hexahedra[0]}, upper{mesh.hexahedra[1]}, ball{mesh.hexahedra[2]};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, brittle, upper, Erosion{}}, Part{Hex8{}, hard, lower},
                     Part{Hex8{}, hard, ball}, InitialVelocity{{0, 0, -0.4}, falling},
                     Clamped{nodes_where(mesh.nodes, on_plane(Axis::z, 0))}, Contact{Everything{}}},
               ExplicitOptions{.energy_tolerance = 0.1}};
  double lowest = 10;
  run.until(8, [&] {
    for (const Index i : falling) lowest = std::min(lowest, run.nodes().x(i).z());
  });
  CHECK(run.part<0>().deleted() == 1);
  CHECK(lowest < 1.4);
  CHECK(lowest > 0.9);  // the face of the lower cube, which bends a little
}

TEST_CASE("everything leaves parts alone that have no faces, such as trusses of a user's own") {
  const Stack stack;
  Mesh mesh = stack.mesh;
  const Index first = static_cast<Index>(mesh.nodes.size());
  mesh.nodes.push_back({0.4, 0.4, 2}), mesh.nodes.push_back({0.4, 0.4, 3});
  const Cells<2> wire{{first, first + 1}};
  const Part trusses{Truss{.area = 1}, Wire{.density = 1, .youngs_modulus = 1, .yield_stress = 1}, wire};
  const auto after = [&](const auto& contact) {
    Explicit run{Scene{mesh.nodes, trusses, Part{Hex8{}, stiff, stack.lower}, Part{Hex8{}, stiff, stack.upper},
                       stack.plate(), InitialVelocity{{0, 0.1, -1}, stack.falling}, contact}};
    run.until(0.3);
    return run.positions();
  };
  CHECK(after(Contact{Everything{.except = {{{0, 1}}}}}) == after(Contact{Everything{}}));
  const auto with_everything = [] {
    return Explicit{
        Scene{std::vector<Eigen::Vector3d>{{0, 0, 0}, {0, 0, 1}},
              Part{Truss{.area = 1}, Wire{.density = 1, .youngs_modulus = 1, .yield_stress = 1}, Cells<2>{{0, 1}}},
              Contact{Everything{}}}};
  };
  CHECK_THROWS_WITH(with_everything(),
                    "strike: Contact{Everything{}} finds no part that is made of hexahedra, tetrahedra or plates.");
}

TEST_CASE("a part that is not there cannot be left out of everything") {
  const Mesh mesh = box({.size = {1, 1, 1}});
  CHECK_THROWS_WITH(
      (Explicit{Scene{mesh.nodes, Part{Hex8{}, stiff, mesh.hexahedra}, Contact{Everything{.except = {{{1, 1}}}}}}}),
      "strike: Everything excepts part 1, but the scene has 1 part; count its parts from 0.");
}
