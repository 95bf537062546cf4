// Changes of a scene that must leave the answer of a contact as it is.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/orientation.hpp>
#include <strike/contact/target.hpp>
#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/section/layered.hpp>

#include "contact/bodies.hpp"
#include "support/catch.hpp"

using namespace strike;
using testing::apart;
using testing::append_body;

namespace {

const Elastic stiff{.density = 1, .youngs_modulus = 1000, .poissons_ratio = 0.3};
const Solid weak{LinearEos{.density = 1, .bulk_modulus = 800}, VonMises{.shear_modulus = 400, .yield_stress = 0.5},
                 FailureStrain{0.01}};
constexpr double thickness = 0.1;

const Mesh block = box({.lower = {0.3, 0.3, 0}, .size = {1.4, 1.4, 1.4}, .cells = {2, 2, 2}});

/// A run in which a block rests under its weight on a part, nodes of which are torn at the time `when`: the positions
/// of the block at the time 30, and how many elements have been deleted.
struct Rest {
  std::vector<Eigen::Vector3d> positions;
  std::size_t deleted;
};
struct Torn {
  std::vector<Index> held, moved;
  double when;
};
template <class Support, class Law>
Rest rest(Mesh mesh, const Support& support, const Surface& surface, const Torn& torn, double height, const Law& law) {
  const auto first = static_cast<std::ptrdiff_t>(mesh.hexahedra.size());
  const std::vector<Index> resting = append_body(mesh, translated(block, {0, 0, height}));
  const Cells<8> body(mesh.hexahedra.begin() + first, mesh.hexahedra.end());
  const double when = torn.when;
  Explicit run{Scene{mesh.nodes, support, Part{Hex8{}, stiff, body}, Clamped{torn.held},
                     PrescribedVelocity{Axis::x, torn.moved, [=](double t) { return t > when ? 0.02 : 0.0; }},
                     NodalForce{{0, 0, -1e-3}, resting}, Contact{NodeToSurface{resting, surface}, law}},
               ExplicitOptions{.largest_step = 5e-3, .energy_tolerance = 10, .print_warnings = false}};
  run.until(30);
  const auto x = run.positions();
  return {{x.end() - static_cast<std::ptrdiff_t>(resting.size()), x.end()}, run.template part<0>().deleted()};
}

/// On a slab; at x = 20 stands another piece of its part, which is torn.
template <class Law>
Rest on_a_slab(const Law& law, double when) {
  Mesh mesh = box({.lower = {0, 0, -1}, .size = {2, 2, 1}, .cells = {2, 2, 1}});
  append(mesh, box({.lower = {20, 0, -1}, .size = {1, 1, 1}, .cells = {1, 1, 1}}));
  const auto held = nodes_where(mesh.nodes, [](const auto& x) { return x.x() < 20.5 && (x.z() < -0.5 || x.x() > 10); });
  return rest(mesh, Part{Hex8{}, weak, mesh.hexahedra, Erosion{}}, solid_surface(mesh.hexahedra, 0),
              {held, nodes_where(mesh.nodes, on_plane(Axis::x, 21)), when}, 0, law);
}
/// On a plate, whose far end is torn. Its cells come first and are numbered from behind, so that what is left is turned
/// over when they are gone.
template <class Law>
Rest on_a_plate(const Law& law, double when) {
  Mesh mesh = rectangle({.size = {4, 2}, .cells = {4, 2}});
  auto& cells = mesh.quadrilaterals;
  std::stable_partition(cells.begin(), cells.end(), [&](const auto& c) { return mesh.nodes[c[1]].x() > 3.5; });
  for (auto* c : {&cells[0], &cells[1]}) *c = {(*c)[0], (*c)[3], (*c)[2], (*c)[1]};
  const auto held = nodes_where(mesh.nodes, [](const auto& x) { return x.x() < 3.5; });
  return rest(mesh, Part{Plate4{}, Homogeneous{PlaneStress{weak}, thickness}, cells, Erosion{}},
              plate_surface(cells, thickness, 0), {held, nodes_where(mesh.nodes, on_plane(Axis::x, 4)), when},
              0.5 * thickness, law);
}

template <class Law>
void rests_while_others_go(const Law& law) {
  const auto same = [&](const Rest& alone, const Rest& beside, std::size_t gone) {
    CHECK(alone.deleted == 0);
    CHECK(beside.deleted == gone);
    CHECK(apart(alone.positions, beside.positions) < 1e-12);  // the same steps, so that only rounding is left
  };
  same(on_a_slab(law, 1e9), on_a_slab(law, 10), 1);
  same(on_a_plate(law, 1e9), on_a_plate(law, 10), 2);
}

}  // namespace

TEST_CASE("what touches goes on touching when an element far away is deleted") {
  rests_while_others_go(Kinematic{});
  rests_while_others_go(Penalty{.fraction = 0.1});
}

TEST_CASE("a plate is touched from both sides, whatever the order of the corners of any of its cells") {
  // A block slides from cell to cell, pressed on the plate from one side or the other.
  const auto slide = [](auto law, double side, unsigned flips) {
    Mesh mesh = rectangle({.size = {8, 3}, .cells = {8, 3}});
    for (std::size_t e = 0; e < mesh.quadrilaterals.size(); ++e) {
      auto& c = mesh.quadrilaterals[e];
      if (flips >> e & 1) c = {c[0], c[3], c[2], c[1]};
    }
    const auto plate = all_nodes(mesh.nodes);
    const double lower = side > 0 ? 0.5 * thickness : -0.5 * thickness - 1.4;
    const std::vector<Index> sliding = append_body(mesh, translated(block, {0.4, 0.171, lower}));
    Explicit run{
        Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{stiff}, thickness}, mesh.quadrilaterals},
              Part{Hex8{}, stiff, mesh.hexahedra}, Clamped{plate}, InitialVelocity{{1, 0.05, 0}, sliding},
              BodyForce{{0, 0, -0.2 * side}},
              Contact{NodeToSurface{sliding, Surface{quadrilateral_surface(mesh.quadrilaterals), thickness}}, law}}};
    run.until(4.5);
    return run.positions();
  };
  const auto the_same = [&](auto law) {
    for (const double side : {1.0, -1.0}) {
      const auto expected = slide(law, side, 0);
      CHECK(std::abs(expected.back().z() - side * (0.5 * thickness + 0.7)) < 0.75);  // it has not passed
      // Rounding alone differs, which contacts that open and close let grow.
      for (const unsigned flips : {1u, 0xa5a5a5u, 0xf0f0f0u, 0xffffffu})
        CHECK(apart(slide(law, side, flips), expected) < 1e-6);
    }
  };
  the_same(Kinematic{});
  the_same(Penalty{});
}

TEST_CASE("plates of two bodies touch by SelfContact as by TwoWay, however near they begin") {
  const auto fall = [](double gap, auto law, bool by_itself, std::string& warning) {
    Mesh mesh = rectangle({.size = {4, 4}, .cells = {8, 8}});
    const auto below = all_nodes(mesh.nodes);
    const std::size_t lower = mesh.quadrilaterals.size();
    const auto falling =
        append_body(mesh, rectangle({.lower = {0.2, 0.2, gap * thickness}, .size = {3.4, 3.4}, .cells = {7, 7}}));
    const auto middle = mesh.quadrilaterals.begin() + static_cast<std::ptrdiff_t>(lower);
    const auto skin = [](auto begin, auto end) {
      return Surface{quadrilateral_surface(Cells<4>(begin, end)), thickness};
    };
    const auto run = [&](auto pairing) {
      Explicit scene{Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{stiff}, thickness}, mesh.quadrilaterals},
                           Clamped{below}, InitialVelocity{{0, 0, -0.2}, falling}, Contact{std::move(pairing), law}},
                     ExplicitOptions{.print_warnings = false}};
      warning = scene.template item<3>().warning();
      scene.until(1);
      return scene.positions();
    };
    if (by_itself) return run(SelfContact{skin(mesh.quadrilaterals.begin(), mesh.quadrilaterals.end())});
    return run(TwoWay{skin(mesh.quadrilaterals.begin(), middle), skin(middle, mesh.quadrilaterals.end())});
  };
  const auto the_same = [&](auto law) {
    for (const double gap : {0.9, 1.0, 1.005, 1.02, 1.5}) {
      CAPTURE(gap);
      std::string self_warning, warning;
      const auto self = fall(gap, law, true, self_warning), expected = fall(gap, law, false, warning);
      CHECK(apart(self, expected) < 1e-9);
      CHECK(expected.back().z() > 0.5 * gap * thickness);  // it has not passed
      CHECK(self_warning == warning);
      CHECK(warning.empty() == (gap >= 1));
    }
  };
  the_same(Kinematic{});
  the_same(Penalty{});
}

TEST_CASE("plates that hang together within a thickness are neighbours, those beyond a fold are not") {
  // A hairpin: two legs of 10 plates, 0.9 thicknesses apart, joined by a bend.
  Mesh mesh;
  const double h = 0.1;
  for (int k = 0; k <= 23; ++k)
    for (const double y : {0.0, 0.3}) {
      const double along = k <= 10 ? 3 - 0.3 * k : k >= 13 ? 0.3 * (k - 13) : -0.3, z = k <= 11 ? 0 : 0.9 * h;
      mesh.nodes.push_back({along, y, z});
    }
  std::vector<detail::FaceCorners> faces;
  for (Index k = 0; k < 23; ++k) faces.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
  const detail::Target target(faces, mesh.nodes.size(), std::vector<double>(faces.size(), h));
  detail::Neighbourhood neighbourhood;
  neighbourhood.find(target, mesh.nodes);
  CHECK(neighbourhood.has(0, 0));    // its own
  CHECK(!neighbourhood.has(0, 1));   // of the same leg, farther than a thickness
  CHECK(!neighbourhood.has(0, 22));  // of the other leg, straight above
  CHECK(neighbourhood.has(22, 11));  // the bend
  CHECK(neighbourhood.has(22, 12));  // beyond the bend, 0.9 thicknesses away along it
}

TEST_CASE("faces of plates are turned to one side within each piece, and no further than the edges of two") {
  using detail::FaceCorners;
  // Two quadrilaterals and a triangle in a row, the second numbered from behind; alone, a piece that keeps its side.
  std::vector<FaceCorners> faces{{0, 1, 2, 3}, {2, 4, 5, 1}, {4, 6, 5, 5}, {10, 13, 12, 11}};
  std::vector<FaceCorners> turned = faces;
  turned[1] = detail::turned_over(faces[1]);
  CHECK(faces[1] != turned[1]);
  auto result = turned;
  detail::face_one_side(result);
  // Neighbours run along a shared edge in opposite directions.
  const auto runs = [](const FaceCorners& face, Index from, Index to) {
    const unsigned corners = face[2] == face[3] ? 3 : 4;
    for (unsigned i = 0; i < corners; ++i)
      if (face[i] == from && face[(i + 1) % corners] == to) return true;
    return false;
  };
  CHECK(runs(result[0], 1, 2));
  CHECK(runs(result[1], 2, 1));
  CHECK(runs(result[1], 4, 5) != runs(result[2], 4, 5));
  CHECK(result[3] == faces[3]);
  // A T: three faces at one edge stay as they are.
  const std::vector<FaceCorners> tee{{0, 1, 2, 3}, {1, 2, 4, 5}, {1, 2, 6, 7}};
  auto same = tee;
  detail::face_one_side(same);
  CHECK(same == tee);
}

namespace {

/// Speeds up nodes in one step, after the contacts before it.
struct Kick {
  std::vector<Index> nodes;
  double speed;
  void resolve_contact(auto& all, const Step& step, Ledger& ledger) const {
    if (step.number != 30) return;
    for (const Index i : nodes) {
      const double before = all.v(i).z(), impulse = all.mass(i) * (-speed - before);
      ledger.external.book_impulse(impulse * before, -impulse * speed);
      all.set_velocity(i, {0, 0, -speed});
    }
  }
};

}  // namespace

TEST_CASE("what another item speeds up in a step does not pass through a surface that rested") {
  Mesh mesh = rectangle({.lower = {0, 0, 0}, .size = {4, 4}, .cells = {4, 4}});
  const auto held = nodes_where(mesh.nodes, [](const auto&) { return true; });
  const std::vector<Index> cube =
      append_body(mesh, box({.lower = {1.6, 1.6, 0.11}, .size = {0.5, 0.5, 2}, .cells = {1, 1, 1}}));
  const Surface plate{quadrilateral_surface(mesh.quadrilaterals), thickness};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, stiff, mesh.hexahedra},
                     Part{Plate4{}, Homogeneous{PlaneStress{weak}, thickness}, mesh.quadrilaterals}, Clamped{held},
                     InitialVelocity{{0, 0, -0.01}, cube}, Contact{NodeToSurface{cube, plate}}, Kick{cube, 60}},
               ExplicitOptions{.largest_step = 5e-3, .energy_tolerance = 1}};
  for (int n = 0; n < 30; ++n) run.step();
  CHECK(run.nodes().x(cube[0]).z() < 0);  // it has gone through in the step of the kick
  run.step();
  CHECK(run.nodes().x(cube[0]).z() == Approx(0.5 * thickness));
}
