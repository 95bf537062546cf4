// Wrong numbers of loads, supports, contacts, parts, policies, options and observers. Items run in one scene that has
// all of them, each in the place of the one of its type: one type of run, which costs the compiler most.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <tuple>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics/dynamic_relaxation.hpp>
#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/every.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/dynamics/subcycling.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/mass_scaled.hpp>
#include <strike/element/particle.hpp>
#include <strike/load.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/output/progress.hpp>

#include "conformance/numbers.hpp"
#include "support/sanitized.hpp"

using namespace strike;

namespace {

using Numbers = std::vector<double>;

const Mesh block = box({.size = {1, 1, 1}, .cells = {1, 1, 2}});
/// A block with a smaller one on it and one beside it, and the frame of an obstacle.
Frame frame;
const Mesh blocks = [] {
  const Mesh small = box({.size = {.5, .5, .5}});
  Mesh mesh = block;
  append(mesh, translated(small, {.25, .25, 1}));
  append(mesh, translated(small, {1, .25, .25}));
  frame = add_frame(mesh.nodes, {9, 0, 0}, 1);
  return mesh;
}();
const std::vector<Index> foot{0, 1, 2, 3}, head{8, 9, 10, 11}, above{12, 13, 14, 15}, beside{20, 22, 24, 26};
const Eigen::Vector3d up{0, 0, 1}, far{0, 0, -10};
const Elastic rubber{.density = 1000, .youngs_modulus = 1e6, .poissons_ratio = .3};
const RigidBody carrier{frame.nodes, Inertia{1, {9, 0, 0}, {1, 1, 1}}};
const Surface faces{surface(block)};

auto scene() {
  return Scene{
      blocks.nodes,
      Part{MassScaled{Hex8{}, 1e-4}, rubber, blocks.hexahedra, Erosion{.strain = 3, .volume = .1, .step = 1e-9}},
      BodyForce{{0, 0, 1}},
      NodalForce{{1, 2, 3}, above},
      Pressure{surface(block), Constant{2}},
      AirBlast{surface(block), Charge{.mass = 1, .centre = {0, 0, 9}, .start = -1}},
      PrescribedVelocity{Axis::x, {4}, Constant{.01}},
      PrescribedDisplacement{{0, 1, 0}, {6}, Constant{.01}},
      Support{foot, {unit(Axis::z)}, {unit(Axis::x)}},
      Symmetry{{0, 2, 0}, {8}},
      InitialVelocity{{0, 0, .01}, Spin{{.01, .02, .03}, {1, 2, 3}}, above},
      RigidWall{far, up, .3},
      Contact{NodeToRigid{above, RigidPlane{far, up}}, Coulomb{.3}},
      Contact{NodeToRigid{above, RigidSphere{far, 1}}},
      Contact{NodeToRigid{above, RigidCylinder{far, {0, 1, 0}, 1}}},
      carrier,
      Contact{NodeToRigid{above, Carried{RigidSphere{far, 1}, frame}}},
      Contact{NodeToRigid{above, RigidSurface{{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{{0, 2, 1, 1}, 0}}}}},
      Contact{NodeToSurface{above, faces}, Penalty{}, Coulomb{.3}},
      Contact{SelfContact{faces}},
      Tied{beside, faces, .1, TieStrength{1e9, 1e9}}};
}

/// Jumps of velocities, on elements as large as the bodies, cost up to a fifth of their energy in the first step.
constexpr ExplicitOptions coarse{.energy_tolerance = .3};
/// The run takes some steps to finite results. That energy from nowhere ends it, the driver sees to.
template <class Run>
bool goes_on(Run run) {
  for (int i = 0; i < testing::repeated(20); ++i) run.step();
  double sum = run.energy().imbalance();
  for (const Eigen::Vector3d& x : run.positions()) sum += x.sum();
  return std::isfinite(sum);
}
/// With an item in the place of the one of its type.
template <class Item>
bool runs_with(const Item& item) {
  auto changed = scene();
  std::get<Item>(changed.items) = item;
  return goes_on(Explicit{changed, coarse, in<double>});
}

/// A block of two parts that need different steps.
template <class... Policies>
auto run_of(const ExplicitOptions& options, const Policies&... policies) {
  const Elastic steel{.density = 8000, .youngs_modulus = 2e11, .poissons_ratio = .3};
  return Explicit{Scene{block.nodes, Part{Hex8{}, rubber, Cells<8>{block.hexahedra[0]}},
                        Part{Hex8{}, steel, Cells<8>{block.hexahedra[1]}}, InitialVelocity{up, head}},
                  options, in<double>, policies...};
}

}  // namespace

TEST_CASE("conformance: wrong numbers of loads and supports are refused") {
  testing::WrongNumbers tried;
  CHECK(goes_on(Explicit{scene(), coarse, in<double>}));
  const auto refuses = [&](const auto& item) {
    testing::refuses_wrong_numbers(item, tried, [](const auto& changed) { return runs_with(changed); });
  };
  refuses(BodyForce{{1, 2, 3}, Constant{.5}});
  refuses(NodalForce{{1, 2, 3}, above, Constant{.5}});
  refuses(Pressure{surface(block), Constant{2}});
  refuses(
      AirBlast{surface(block), Charge{.mass = 1, .centre = {1, 2, 9}, .start = -1, .units = BlastUnits{}, .end = 1}});
  refuses(PrescribedVelocity{{1, 2, 0}, {4}, Constant{.01}});
  refuses(PrescribedDisplacement{{0, 1, 0}, {6}, Constant{.01}});
  refuses(Support{foot, {unit(Axis::z)}, {unit(Axis::x)}});
  refuses(Symmetry{{0, 2, 0}, {8}});
  refuses(InitialVelocity{{1e-3, 2e-3, 3e-3}, Spin{{.01, .02, .03}, {1, 2, 3}}, above});
  const auto refuses_body = [&](const auto& body) {
    testing::refuses_wrong_numbers(body, tried, [](const auto& changed) {
      return goes_on(
          Explicit{Scene{blocks.nodes, Part{Hex8{}, rubber, blocks.hexahedra}, carrier, changed}, coarse, in<double>});
    });
  };
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Index i : above) middle += .25 * blocks.nodes[i];
  refuses_body(RigidBody{above, Inertia{.mass = 1e-3, .centre = middle}});
  refuses_body(RigidBody{above, TotalInertia{{1000, middle, {300, 300, 300}}}});
  refuses_body(RigidBody{above, Inertia{}, HeldBody{{unit(Axis::x)}, {{0, 2, 0}}}});
  refuses_body(RigidBody{above, Inertia{}, PinnedBody{{1, 2, 3}}});
  refuses_body(RigidBody{above, Inertia{}, BodyVelocity{{1, 2, 0}, Constant{.01}}, BodySpin{Axis::z, Constant{.01}}});
  refuses_body(
      RigidBody{above, Inertia{}, BodyDisplacement{{1, 2, 0}, Constant{.01}}, BodyAngle{Axis::z, Constant{.01}}});
  testing::refuses_wrong_arguments("Curve", {{"time", 1}, {"value", 2}, {"time", 3}, {"value", 4}}, tried,
                                   [](const Numbers& x) {
                                     return std::isfinite(Curve{{{x[0], x[1]}, {x[2], x[3]}}}(2));
                                   });
  tried.print("loads and supports");
}

TEST_CASE("conformance: wrong numbers of particles are refused") {
  testing::WrongNumbers tried;
  const Mesh balls = particles(BoxShape{.size = {3, 3, 3}, .cells = {3, 3, 3}});
  testing::refuses_wrong_numbers(Particle{Smoothing{}, Mirrors{Mirror{{1, 0, 0}}}}, tried, [&](const auto& particle) {
    return goes_on(Explicit{Scene{balls.nodes, Part{particle, rubber, balls.particles}, InitialVelocity{up, {1, 2}}},
                            coarse, in<double>});
  });
  const Particles debris = particles_at_nodes(block.nodes, block.hexahedra);
  const Debris born{.of = 0, .erosion = {.volume = .1, .step = 1e-9}};
  testing::refuses_wrong_numbers(born, tried, [&](Debris changed) {
    changed.of = 0;  // a part that is not there is refused when the run begins
    return goes_on(Explicit{Scene{block.nodes, Part{Hex8{}, rubber, block.hexahedra, Erosion{.strain = 3}},
                                  Part{Particle{}, rubber, debris, changed}, InitialVelocity{up, head}},
                            coarse, in<double>});
  });
  tried.print("particles");
}

TEST_CASE("conformance: wrong numbers of contacts are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& piece, const auto& contact) {
    testing::refuses_wrong_numbers(piece, tried, [&](const auto& changed) { return runs_with(contact(changed)); });
  };
  const NodeToSurface pairing{above, faces};
  refuses(pairing, [](const auto& to) { return Contact{to, Penalty{}, Coulomb{.3}}; });
  refuses(Penalty{.fraction = .4, .stiffness = 100}, [&](const Penalty& law) {
    return Contact{pairing, law, Coulomb{.3}};
  });
  refuses(Coulomb{.3}, [&](const Coulomb& friction) { return Contact{pairing, Penalty{}, friction}; });
  refuses(Coulomb{.3}, [](const Coulomb& friction) {
    return Contact{NodeToRigid{above, RigidPlane{far, up}}, friction};
  });
  refuses(Kinematic{}, [](const Kinematic& law) {
    return Contact{NodeToRigid{above, RigidPlane{far, up}}, law, Coulomb{.3}};
  });
  refuses(Kinematic{}, [](const Kinematic& law) { return Contact{SelfContact{faces}, law}; });
  const auto frictionless = [](const auto& to) { return Contact{to}; };
  refuses(NodeToRigid{above, RigidPlane{far, up}, .1}, [](const auto& to) { return Contact{to, Coulomb{.3}}; });
  refuses(NodeToRigid{above, RigidSphere{{0, 0, -3}, 1}, .1}, frictionless);
  refuses(NodeToRigid{above, RigidCylinder{{0, 0, -3}, {0, 1, 0}, 1, 2}, .1}, frictionless);
  refuses(NodeToRigid{above, Carried{RigidSphere{{0, 0, -3}, 1}, frame}, .1}, frictionless);
  refuses(NodeToRigid{above, RigidSurface{{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{{0, 2, 1, 1}, 0}}}, .1}, frictionless);
  refuses(TieStrength{1e9, 1e9}, [](const TieStrength& strength) { return Tied{beside, faces, strength}; });

  const auto refuses_in = [&](const char* of, const std::vector<testing::Argument>& arguments, const auto& use) {
    testing::refuses_wrong_arguments(of, arguments, tried, use);
  };
  refuses_in("Tied", {{"tolerance", .1}}, [](const Numbers& x) { return runs_with(Tied{beside, faces, x[0]}); });
  const auto touches_itself = [](const Surface& changed) {
    return Contact{TwoWay{changed, faces}}.overlaps().empty() && runs_with(Contact{SelfContact{changed}});
  };
  refuses_in("Surface", {{"thickness", .01}}, [&](const Numbers& x) {
    return touches_itself(Surface{surface(block), x[0]}) &&
           touches_itself(Surface{Surface::Piece{.faces = surface(block), .thickness = x[0]}});
  });
  refuses_in("RigidWall", {{"point", -9}, {"normal", 2}, {"friction", .3}}, [](const Numbers& x) {
    const Eigen::Vector3d point(0, 0, x[0]), normal(0, 0, x[1]);
    return runs_with(RigidWall{point, normal, above, x[2]}) && runs_with(RigidWall{point, normal, x[2]});
  });
  tried.print("contacts");
}

TEST_CASE("conformance: wrong numbers of parts, policies, options and observers are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& model, const auto& use) { testing::refuses_wrong_numbers(model, tried, use); };
  refuses(std::get<0>(scene().items), [](const auto& part) { return runs_with(part); });
  refuses(
      ExplicitOptions{
          .step_factor = .5, .step_growth = 1.1, .largest_step = 1e-5, .smallest_step = 1e-9, .energy_tolerance = .1},
      [](const ExplicitOptions& options) { return goes_on(run_of(options, OpenMP{1}, Subcycling{})); });
  refuses(ExplicitOptions{},
          [](const ExplicitOptions& options) { return goes_on(run_of(options, OpenMP{1}, Subcycling{})); });
  refuses(OpenMP{.threads = 1}, [](const OpenMP& threads) { return goes_on(run_of({}, threads, Subcycling{})); });
  refuses(Subcycling{}, [](const Subcycling& cycle) { return goes_on(run_of({}, OpenMP{1}, cycle)); });
  refuses(GlobalStep{}, [](const GlobalStep& bound) { return goes_on(run_of({}, bound, DynamicRelaxation{})); });
  refuses(DynamicRelaxation{},
          [](const DynamicRelaxation& damping) { return goes_on(run_of({}, GlobalStep{}, damping)); });

  const std::string file = (std::filesystem::temp_directory_path() / "wrong_numbers.checkpoint").string();
  const auto observes = [&](double end, double interval, const CheckpointOptions& options,
                            const ProgressOptions& progress) {
    auto run = run_of({.print_warnings = false}, OpenMP{1}, Subcycling{});
    int seen = 0;
    run.until(end, StopWhen{[&] { return run.steps() >= 20; }}, Every{interval, [&] { ++seen; }},
              Checkpoint{file, options}, Progress{progress});
    return seen > 0 && run.steps() <= 20;
  };
  refuses(CheckpointOptions{.interval = 1},
          [&](const CheckpointOptions& options) { return observes(1, 1, options, {}); });
  refuses(ProgressOptions{.end = 1}, [&](const ProgressOptions& options) { return observes(1, 1, {}, options); });
  testing::refuses_wrong_arguments("Every", {{"interval", 1}}, tried,
                                   [&](const Numbers& x) { return observes(1, x[0], {}, {}); });
  testing::refuses_wrong_arguments("until", {{"end", 1}}, tried,
                                   [&](const Numbers& x) { return observes(x[0], 1, {}, {}); });
  std::remove(file.c_str());
  tried.print("parts, policies, options and observers");
}
