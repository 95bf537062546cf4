// Scenes that have the same bits on any number of processes and threads as on one, with every kind of element, item and
// policy among them.
#include <cmath>
#include <cstdio>
#include <vector>

#include "mpi/same_bits.hpp"

using namespace strike;

namespace {

const MpiSession session;

// Millimetres, milliseconds, kilograms; so kN, GPa and J.
const LinearEos of_copper{.density = 8.93e-6, .bulk_modulus = 130};
const VonMises hardening{.shear_modulus = 43, .yield_stress = .4, .hardening_modulus = .1};
const Solid copper{of_copper, hardening};
const Elastic rubber{.density = 1e-6, .youngs_modulus = .01, .poissons_ratio = .3};

std::vector<Index> upper_half(const Mesh& mesh, double z) {
  return nodes_where(mesh.nodes, [=](const Eigen::Vector3d& x) { return x.z() > z; });
}

/// After another step each process knows some nodes alone.
template <class Run>
void check_shared(Run& run) {
  const auto& nodes = run.nodes();
  run.step();
  bool knows_all = true;
  try {
    for (std::size_t i = 0; i < nodes.size(); ++i) (void)nodes.x(i);
  } catch (const Error& error) {
    knows_all = false;
    CHECK(std::string(error.what()).find("is on another process") != std::string::npos);
  }
  CHECK(testing::everywhere(knows_all == (session.size() == 1)));
}

}  // namespace

TEST_CASE("a bar that strikes a wall, with its supports and loads") {
  const Mesh bar = box({.size = {3, 3, 9}, .cells = {8, 8, 24}});
  const auto scene = [&] {
    return Scene{bar.nodes,
                 Part{Hex8{}, copper, bar.hexahedra},
                 InitialVelocity{{0, 0, -227}},
                 RigidWall{{0, 0, 0}, {0, 0, 1}, .2},
                 Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},
                 PrescribedVelocity{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0)), Constant{3}},
                 NodalForce{{1, 0, 0}, upper_half(bar, 8.9)},
                 BodyForce{{0, 0, -1}}};
  };
  const auto [run, alone] = testing::runs_alike(scene, 100);
  const auto strain = [](const auto& state) { return state.equivalent_plastic_strain; };
  CHECK(run.template part<0>().field(strain) == alone.template part<0>().field(strain));
  CHECK(run.template part<0>().cells(run.nodes()) == bar.hexahedra);
  CHECK(alone.imbalance() == 1);
  CHECK(run.imbalance() >= 1);
  CHECK(run.imbalance() <= static_cast<double>(session.size()));
  Explicit serial{scene(), {.step_factor = .8, .print_warnings = false}};
  for (int n = 0; n < 100; ++n) serial.step();
  CHECK(serial.positions() == run.positions());
  CHECK(serial.energy().held() == run.energy().held());
  CHECK(serial.template part<0>().field(strain) == run.template part<0>().field(strain));
}

TEST_CASE("processes share the nodes where every item names its own") {
  const Mesh block = box({.size = {4, 2, 2}, .cells = {28, 12, 12}});
  Mesh mesh = block;
  const Index lid = append(mesh, translated(box({.size = {1, 1, .2}, .cells = {5, 5, 1}}), {2.1, .4, 2.01}));
  const Cells<8> of_lid(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(block.hexahedra.size()),
                        mesh.hexahedra.end());
  const Index rib = append(mesh, translated(box({.size = {.5, 1, .4}, .cells = {2, 4, 2}}), {.2, .3, 2}));
  const Cells<8> of_rib(mesh.hexahedra.end() - 16, mesh.hexahedra.end());
  std::vector<Index> flying, foot;
  for (Index i = lid; i < rib; ++i) flying.push_back(i);
  for (Index i = rib; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i].z() < 2.01) foot.push_back(i);
  Cells<4> skin;
  std::vector<Face> pressed;
  for (const auto& cell : block.hexahedra) {
    if (mesh.nodes[cell[0]].y() == 0) skin.push_back({cell[0], cell[1], cell[5], cell[4]});
    if (mesh.nodes[cell[1]].x() == 4) pressed.push_back(Face{{cell[1], cell[2], cell[6], cell[5]}, 0});
  }
  const auto bodies = [&](const auto&... more) {
    return Scene{mesh.nodes,
                 Part{Hex8{}, copper, block.hexahedra},
                 Part{Plate4{}, Homogeneous{PlaneStress{copper}, .05}, skin},
                 Part{Hex8{ViscousHourglass{}}, copper, of_rib},
                 RigidBody{Mesh{mesh.nodes, of_lid}, 8e-6},
                 InitialVelocity{{1, 5, -100}, flying},
                 more...};
  };
  const std::vector<Index> side = nodes_where(block.nodes, on_plane(Axis::x, 0));
  const auto loaded = [&] {
    return bodies(Contact{TwoWay{Surface{surface(Mesh{mesh.nodes, of_lid})}, Surface{surface(block)}}, Coulomb{.2}},
                  Support{side, {unit(Axis::x)}, {unit(Axis::y)}}, Pressure{pressed, Constant{.01}},
                  Tied{foot, Surface{surface(block)}, .05}, NodalForce{{0, 0, -.1}, {40, 41}},
                  PrescribedVelocity{Axis::z, nodes_where(block.nodes, on_plane(Axis::z, 0)), Constant{.5}},
                  RigidWall{{0, 0, -.1}, {0, 0, 1}, foot},
                  BodyForce{{0, 3, -50}, [](double time) { return 1 + 9 * time; }});
  };
  auto [run, alone] = testing::runs_alike(loaded, 60);
  CHECK(run.energy().friction > 0);
  check_shared(run), alone.step();
  CHECK(testing::everywhere(run.positions() == alone.positions() && run.velocities() == alone.velocities()));
  testing::runs_alike(loaded, 40, in<Pack<float>, double>);
}

TEST_CASE("processes share the nodes of tetrahedra and of elements that erode") {
  const Mesh core = box({.size = {2, 2, 4}, .cells = {8, 8, 16}});
  Mesh mesh = tetrahedralized(core);
  append(mesh, translated(box({.size = {2, 2, 1}, .cells = {8, 8, 4}}), {0, 0, 4}));
  mesh = merge_coincident_nodes(mesh, 1e-6);
  const auto scene = [&](const auto&... removal) {
    return [&mesh, removal...] {
      return Scene{mesh.nodes,
                   Part{Tet4{}, Solid{of_copper, hardening, FailureStrain{.4}}, mesh.tetrahedra, removal...},
                   Part{Hex8{}, copper, mesh.hexahedra, Erosion{.strain = .15}},
                   InitialVelocity{{20, 0, -400}},
                   RigidWall{{0, 0, 0}, {0, 0, 1}, nodes_where(mesh.nodes, on_plane(Axis::z, 0)), .2},
                   Support{nodes_where(mesh.nodes, on_plane(Axis::z, 5)), {unit(Axis::z)}}};
    };
  };
  auto [run, alone] = testing::runs_alike(scene(Erosion{.strain = .3}), 80);
  CHECK(run.template part<0>().deleted() > 0);
  CHECK(run.template part<1>().deleted() > 0);
  check_shared(run), alone.step();
  CHECK(testing::everywhere(run.positions() == alone.positions()));
  auto copy = run, other = alone;
  for (int n = 0; n < 20; ++n) copy.step(), other.step();
  CHECK(testing::everywhere(copy.velocities() == other.velocities()));
  CHECK(testing::everywhere(testing::bytes_of(copy).kept == testing::bytes_of(other).kept));
  auto [whole, alone_too] = testing::runs_alike(scene(), 40, in<Pack<float>, double>);
  check_shared(whole);
}

TEST_CASE("plates beside their nodes, some of which may touch a wall") {
  const Mesh plate = sheet({40, 40}, [](double s, double t) { return Eigen::Vector3d(4 * s, 4 * t, 0); });
  const auto near = nodes_where(plate.nodes, [](const Eigen::Vector3d& x) { return std::abs(x.x() - x.y()) < .2; });
  const auto scene = [&] {
    return Scene{plate.nodes, Part{Plate4{}, Homogeneous{PlaneStress{copper}, .05, Offset{.02}}, plate.quadrilaterals},
                 InitialVelocity{{1, 0, -20}}, RigidWall{{2, 2, -.015}, {.05, -.1, 1}, near, .1}};
  };
  auto [run, alone] = testing::runs_alike(scene, 100);
  CHECK(run.energy().friction > 0);
  check_shared(run);
}

TEST_CASE("more processes than patches, derivatives, and a copy of a run") {
  const Mesh pair = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  using D = Dual<Pack<double, 4>, 1>;
  const auto scene = [&] {
    return Scene{pair.nodes, Part{Hex8{}, copper, pair.hexahedra, Erosion{.strain = .02}},
                 Part{Plate4{}, Layered{Layer{PlaneStress{copper}, .05}, Layer{PlaneStress{copper}, .1}},
                      Cells<4>{{0, 1, 3, 2}}},
                 Support{{0, 1, 2, 3}, {unit(Axis::z)}}, InitialVelocity{{0, 0, -100}, upper_half(pair, 1.5)}};
  };
  const auto [run, alone] = testing::runs_alike(scene, 60);
  CHECK(run.template part<0>().deleted() > 0);
  const auto stress = [](const auto& state) { return state.stress.xx; };
  CHECK(run.template part<1>().field(1, stress) == alone.template part<1>().field(1, stress));
  CHECK_THROWS_WITH(run.template part<1>().field(2, stress), Catch::Matchers::ContainsSubstring("has no layer 2"));
  auto copy = run, other = alone;
  for (int n = 0; n < 10; ++n) copy.step(), other.step();
  CHECK(testing::everywhere(copy.positions() == other.positions()));
  const auto differentiated = [&] {
    return Scene{pair.nodes, Part{Hex8{}, rubber, pair.hexahedra}, Support{{0, 1, 2, 3}, {unit(Axis::z)}},
                 InitialVelocity{{0, 0, -1}, upper_half(pair, 1.5)}};
  };
  testing::runs_alike(differentiated, 10, in<D>);
}

TEST_CASE("cells of several kinds that share nodes, in mixed precision, with a step of the mesh as a whole") {
  const Mesh core = box({.size = {2, 2, 2}, .cells = {8, 8, 8}});
  Mesh mesh = core;
  append(mesh, tetrahedralized(translated(core, {0, 0, 2})));
  mesh = merge_coincident_nodes(mesh, 1e-6);
  Cells<4> skin;
  for (const auto& cell : core.hexahedra)  // its sides at x = 0
    if (core.nodes[cell[0]].x() == 0) skin.push_back({cell[0], cell[3], cell[7], cell[4]});
  const auto scene = [&] {
    return Scene{mesh.nodes,
                 Part{Hex8{}, copper, mesh.hexahedra},
                 Part{Tet4{}, copper, mesh.tetrahedra},
                 Part{Plate4{}, Homogeneous{PlaneStress{copper}, .05}, skin},
                 Support{nodes_where(mesh.nodes, on_plane(Axis::z, 0)), {unit(Axis::z)}, {unit(Axis::x)}},
                 Pressure{surface(core), Constant{.01}},
                 InitialVelocity{{0, 1, -20}, upper_half(mesh, 2)}};
  };
  const auto [run, alone] = testing::runs_alike(scene, 60, in<Pack<float>, double>, GlobalStep{});
  CHECK(run.step_bound().estimates() == alone.step_bound().estimates());
  CHECK(run.step_bound().products() > 3);
}

TEST_CASE("bodies that erode, touch and rub, with a rigid one and a tie") {
  Mesh mesh = box({.size = {4, 4, 1}, .cells = {16, 16, 4}});
  const Cells<8> plate = mesh.hexahedra;
  append(mesh, translated(rotated(box({.size = {1, 1, 1}, .cells = {5, 5, 5}}), {1, .2, 0}, .2), {1.5, 1.5, 1.15}));
  const Cells<8> striker(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(plate.size()), mesh.hexahedra.end());
  const Mesh brick = translated(box({.size = {.5, .5, .5}, .cells = {3, 3, 3}}), {3, 3, 1.02});
  const Index first = append(mesh, brick);
  const Cells<8> rigid(mesh.hexahedra.end() - 27, mesh.hexahedra.end());
  const Index rib = append(mesh, translated(box({.size = {2, .4, .4}, .cells = {7, 2, 2}}), {.3, .2, 1}));
  const Cells<8> of_rib(mesh.hexahedra.end() - 28, mesh.hexahedra.end());
  std::vector<Index> foot;
  for (Index i = rib; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i].z() < 1.01) foot.push_back(i);
  std::vector<Index> flying;
  for (Index i = static_cast<Index>(17 * 17 * 5); i < first; ++i) flying.push_back(i);
  const auto scene = [&] {
    return Scene{mesh.nodes,
                 Part{Hex8{}, copper, plate, Erosion{.strain = .05}},
                 Part{Hex8{}, copper, striker, Erosion{.strain = .3}},
                 Part{MassScaled{Hex8{}, 2e-5}, copper, of_rib},
                 RigidBody{Mesh{mesh.nodes, rigid}, 8e-6},
                 Contact{Everything{}, Coulomb{.2}},
                 Tied{foot, Surface{surface(Mesh{mesh.nodes, plate})}, .01},
                 InitialVelocity{{30, 0, -250}, flying}};
  };
  const auto [run, alone] = testing::runs_alike(scene, 150);
  CHECK(run.template part<0>().deleted() > 0);
  CHECK(run.template part<2>().added_mass() == alone.template part<2>().added_mass());
}

TEST_CASE("what erodes on a block whose inside nobody names, with plates about it") {
  const Mesh block = box({.size = {4, 4, 3}, .cells = {16, 16, 12}});
  Mesh mesh = block;
  Cells<4> coat;
  for (const auto& cell : block.hexahedra)  // its top
    if (block.nodes[cell[4]].z() == 3) coat.push_back({cell[4], cell[5], cell[6], cell[7]});
  const Index first =
      append(mesh, translated(rotated(tetrahedralized(box({.size = {1, 1, 1}, .cells = {4, 4, 4}})), {1, .2, 0}, .2),
                              {1.5, 1.5, 3.25}));
  std::vector<Index> flying;
  for (Index i = first; i < mesh.nodes.size(); ++i) flying.push_back(i);
  const auto scene = [&] {
    return Scene{mesh.nodes,
                 Part{Hex8{}, copper, block.hexahedra},
                 Part{Plate4{}, Homogeneous{PlaneStress{copper}, .05, Offset{.025}}, coat},
                 Part{Tet4{}, copper, mesh.tetrahedra, Erosion{.strain = .1}},
                 Contact{Everything{}, Coulomb{.2}},
                 InitialVelocity{{30, 0, -250}, flying}};
  };
  auto [run, alone] = testing::runs_alike(scene, 150);
  CHECK(run.template part<2>().deleted() > 0);
  CHECK(run.energy().friction > 0);
  check_shared(run);
}

TEST_CASE("bodies that meet so fast that what is about to touch bounds the step") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {8, 8, 8}});
  const Cells<8> lower = mesh.hexahedra;
  const Index first = append(mesh, translated(box({.size = {.9, .8, .7}, .cells = {9, 8, 8}}), {.13, .08, 1.003}));
  const Cells<8> upper(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(lower.size()), mesh.hexahedra.end());
  std::vector<Index> flying;
  for (Index i = first; i < mesh.nodes.size(); ++i) {
    flying.push_back(i);
    mesh.nodes[i].z() += .05 * mesh.nodes[i].x() + .03 * mesh.nodes[i].y();
  }
  testing::runs_alike(
      [&] {
        return Scene{
            mesh.nodes, Part{Hex8{}, copper, mesh.hexahedra}, InitialVelocity{{200, -100, -5000}, flying},
            Contact{TwoWay{Surface{surface(Mesh{mesh.nodes, lower})}, Surface{surface(Mesh{mesh.nodes, upper})}},
                    Coulomb{.1}}};
      },
      150);
}

TEST_CASE("particles, and what eroded elements become") {
  const Mesh brick = box({.size = {2, 2, 2}, .cells = {7, 7, 7}});
  Mesh mesh = brick;
  const Mesh drop = translated(particles(BoxShape{.size = {2, 2, 2}, .cells = {6, 6, 6}}), {0, 0, 2.3});
  append(mesh, drop);
  const Fluid water{LinearEos{.density = 1e-6, .bulk_modulus = 2}};
  const auto scene = [&] {
    return Scene{mesh.nodes,
                 Part{Hex8{}, copper, mesh.hexahedra, Erosion{.strain = .1}},
                 Part{Particle{}, copper, particles_at_nodes(mesh.nodes, mesh.hexahedra), Debris{.of = 0}},
                 Part{Particle{}, water, mesh.particles},
                 RigidWall{{0, 0, 0}, {0, 0, 1}},
                 InitialVelocity{{0, 0, -200}}};
  };
  const auto [run, alone] = testing::runs_alike(scene, 80);
  CHECK(run.template part<0>().deleted() > 0);
}

TEST_CASE("parts chosen late, some of them slow, and a relaxation") {
  const Mesh block = box({.size = {4, 1, 1}, .cells = {32, 8, 8}});
  Cells<8> soft, hard;
  for (const auto& cell : block.hexahedra) (block.nodes[cell[0]].x() < 2 ? soft : hard).push_back(cell);
  Elastic stiff = rubber;
  stiff.youngs_modulus *= 100;
  const auto parts = [&] {
    return std::vector<AnyPart<decltype(Part{Hex8{}, rubber, soft}), decltype(Part{Hex8{}, copper, soft})>>{
        Part{Hex8{}, rubber, soft}, Part{Hex8{}, stiff, hard}};
  };
  const auto scene = [&] {
    return Scene{block.nodes, parts(), Support{nodes_where(block.nodes, on_plane(Axis::x, 0)), {unit(Axis::x)}},
                 BodyForce{{0, 0, -1e3}}};
  };
  const auto [slow, alone] = testing::runs_alike(scene, 60, Subcycling{});
  CHECK(slow.cycle().multiple() > 1);
  testing::runs_alike(scene, 60, DynamicRelaxation{});
}
