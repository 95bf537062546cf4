#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <strike/strike.hpp>

#include "conformance/plate.hpp"
#include "dynamics/assembled.hpp"
#include "problems/plate_cells.hpp"
#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

/// The unit cube in n^3 hexahedra, the last `grading` times as long as the first, their inner corners moved at random.
Mesh cube(Index n, double grading = 1, double distortion = 0) {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {n, n, n}, .grading = {grading, 1, grading}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Eigen::Vector3d& x : mesh.nodes)
    x += distortion / (n * grading) * Eigen::Vector3d(unit(random), unit(random), unit(random));
  return mesh;
}

template <class Run>
double least_own_step(Run& run) {
  double least = std::numeric_limits<double>::infinity();
  run.each_part([&](const auto& part) {
    for (const auto& block : part.blocks())
      least = std::min(least, 1 / static_cast<double>(reduce_max(block.state.followed.now)));
  });
  return least;
}

/// What was seen while a run was held against the exact limit of its mesh.
struct Seen {
  double eigenvalue = 0;  // the largest of K dt^2/4 + C dt/2 over the masses, at the step that was allowed
  double gain = 0;        // the largest ratio of that step to the least of an element
};

template <class Run>
Seen watch(Run& run, double end, std::size_t steps, std::size_t every) {
  Seen seen;
  const auto look = [&] {
    const double dt = run.stable_step().dt;
    seen.gain = std::max(seen.gain, dt / least_own_step(run));
    const double eigenvalue = testing::eigenvalue(testing::vibration(run), dt);
    REQUIRE(eigenvalue > 0.3);
    seen.eigenvalue = std::max(seen.eigenvalue, eigenvalue);
  };
  look();
  run.until(end, StopWhen{[&] { return run.steps() >= steps; }}, [&] {
    if (run.steps() % every == 0) look();
  });
  return seen;
}

/// A body that flies at a wall, in one kind of scene and of numbers for all, so that each part is compiled once.
template <class Body>
auto flight(const Mesh& mesh, const Body& body, const Eigen::Vector3d& velocity, const RigidWall& wall,
            const GlobalStep& bound = {}) {
  return Explicit{Scene{mesh.nodes, body, InitialVelocity{velocity}, wall}, ExplicitOptions{}, in<double>, bound};
}
const RigidWall below{{0, 0, -0.1}, {0, 0, 1}};

/// Stiff and thin on soft and thick.
const Layered two_layers{Layer{PlaneStress{Elastic{1, 1, 0.3}}, 0.05, Gauss<3>{}},
                         Layer{PlaneStress{Elastic{0.5, 0.01, 0.3}}, 0.1, Gauss<3>{}}};

/// A sheet of n^2 quadrilaterals and side 1, its nodes moved at random.
Mesh sheet(Index n, double distortion, double warp, unsigned seed) {
  Mesh mesh = rectangle({.size = {1, 1}, .cells = {n, n}});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Eigen::Vector3d& x : mesh.nodes)
    x += Eigen::Vector3d(distortion * unit(random), distortion * unit(random), warp * unit(random)) / n;
  return mesh;
}

/// A body of hexahedra, on it one of tetrahedra and round both a shell, all at common nodes.
struct Mixed {
  std::vector<Eigen::Vector3d> nodes;
  Cells<8> hexahedra;
  Cells<4> tetrahedra, shell;

  explicit Mixed(double distortion) {
    const Mesh mesh = cube(3, 1, distortion);
    nodes = mesh.nodes;
    Mesh upper{.nodes = mesh.nodes};
    for (const auto& cell : mesh.hexahedra)
      (centroid(mesh.nodes, cell).z() < 0.6 ? hexahedra : upper.hexahedra).push_back(cell);
    tetrahedra = tetrahedralized(upper).tetrahedra;
    for (const auto& cell : hexahedra)
      if (centroid(nodes, cell).z() < 0.3) shell.push_back({cell[0], cell[1], cell[2], cell[3]});
  }
};

/// The forces that resist each component of the motion alone are the columns of a matrix.
template <class Resistance, int n>
void check_columns(const Resistance& resistance, const Nodal<double, n>& x, const Eigen::MatrixXd& expected,
                   double tolerance) {
  for (int k = 0; k < 3 * n; ++k) {
    Nodal<double, n> p = Nodal<double, n>::Zero();
    p(k) = 1;
    const Nodal<double, n> f = resistance(x, p);
    CHECK((f.reshaped() - expected.col(k)).norm() <= tolerance * expected.norm());
  }
}

}  // namespace

TEST_CASE("the largest eigenvalue of the chain of n springs, 2 + 2 cos(pi/(n + 1)), from above") {
  for (const std::size_t n : {1u, 2u, 5u, 100u}) {
    const double found =
        strike::detail::largest_eigenvalue(std::vector<double>(n, 2.0), std::vector<double>(n - 1, -1.0));
    const double exact = 2 + 2 * std::cos(std::numbers::pi / static_cast<double>(n + 1));
    CHECK(found >= exact * (1 - 1e-15));
    CHECK(found <= exact * (1 + 2e-12));
  }
}

TEST_CASE("the largest eigenvalue exceeds its bound no more often than said, and the bound is near it in a few steps") {
  const auto bound = [](const std::vector<double>& eigenvalues, std::size_t steps, double failure, std::uint64_t seed) {
    strike::detail::Lanczos<Pack<double, 4>, 1> lanczos;
    const auto n = eigenvalues.size() / 3;
    double mu = 0;
    lanczos.iterate(
        seed, n, {std::vector<double>(n, 1)}, Serial{},
        [&](auto& q, auto& product) {
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t c = 0; c < 3; ++c) product[0][i].set(c, -eigenvalues[3 * i + c] * q[0][i][c]);
        },
        [&](const auto& diagonal, const auto& beside) {
          mu = strike::detail::eigenvalue_bound(diagonal, beside, 3 * n, failure);
          return diagonal.size() == steps;
        });
    return mu;
  };
  std::vector<double> one_above(300), lattice(300);  // 1 and all others spread below 0.8; the band of a chain
  for (std::size_t i = 0; i < 300; ++i) {
    one_above[i] = i == 0 ? 1 : 0.8 * static_cast<double>(i) / 300;
    lattice[i] = std::pow(std::sin(0.5 * std::numbers::pi * static_cast<double>(i + 1) / 300), 2);
  }
  int failures = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) failures += bound(one_above, 5, 0.1, seed) < 1;
  CHECK(failures <= 130);  // of 100 expected at most, with a standard deviation of 10
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CHECK(bound(lattice, 30, 1e-6, seed) >= 1);
    CHECK(bound(lattice, 30, 1e-6, seed) <= 1.1);
  }
}

TEST_CASE("random numbers have the moments of the normal distribution") {
  double sums[5]{};
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = strike::detail::random_normal(static_cast<std::uint64_t>(i));
    for (int k = 1; k < 5; ++k) sums[k] += std::pow(x, k) / n;
  }
  CHECK(sums[1] == Approx(0).margin(5 / std::sqrt(n)));  // 5 standard deviations of each
  CHECK(sums[2] == Approx(1).margin(5 * std::sqrt(2. / n)));
  CHECK(sums[3] == Approx(0).margin(5 * std::sqrt(15. / n)));
  CHECK(sums[4] == Approx(3).margin(5 * std::sqrt(96. / n)));
}

TEST_CASE("the resistance of a hexahedron is its stiffness and its damping, of any shape") {
  const double dt = 0.02;
  testing::Shapes<8> shapes(5);
  const auto check = [&](const auto& element, const Nodal<double, 8>& v) {
    using E = std::decay_t<decltype(element)>;
    const Elastic law{1, 1, 0.3};
    const Nodal<double, 8> x = shapes();
    const SingleElement single{element, law, x};
    typename E::template State<Elastic, double> state;
    element.begin(state, law, x);
    const auto resistance = element.resistance(state, law, x, v, dt);
    const auto vibration = single.vibration(v);
    const Eigen::MatrixXd expected = 0.25 * dt * dt * vibration.stiffness + 0.5 * dt * vibration.damping;
    check_columns(resistance, x, expected, 1e-5);  // of the steps of the derivatives
  };
  const Nodal<double, 8> still = Nodal<double, 8>::Zero();
  for (int trial = 0; trial < 3; ++trial) {
    check(Hex8{ViscousHourglass{0.2}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8{StiffnessHourglass{0.1}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8{PhysicalHourglass{}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8Full{HughesWinget{}, NoBulkViscosity{}}, still);
  }
}

TEST_CASE("the resistance of a tetrahedron is its stiffness and its damping, of any shape") {
  const double dt = 0.02;
  testing::Shapes<4> shapes(5, unit_tetrahedron());
  const auto check = [&](const auto& element) {
    using E = std::decay_t<decltype(element)>;
    const Elastic law{1, 1, 0.3};
    const Nodal<double, 4> x = shapes();
    const SingleElement single{element, law, x};
    typename E::template State<Elastic, double> state;
    element.begin(state, law, x);
    const auto resistance = element.resistance(state, law, x, Nodal<double, 4>::Zero().eval(), dt);
    const Eigen::MatrixXd expected = 0.25 * dt * dt * single.vibration().stiffness;
    check_columns(resistance, x, expected, 1e-9);
    CHECK(resistance.mass == Approx(single.nodal_mass()).epsilon(1e-13));
  };
  for (int trial = 0; trial < 3; ++trial) {
    check(Tet4{ElementPressure{}, HughesWinget{}, NoBulkViscosity{}});
    check(Tet4{NodalPressure{0.9}, HughesWinget{}, NoBulkViscosity{}});
  }
}

TEST_CASE("the resistance of a plate is its stiffness, of any shape, warped too, and of any section") {
  const double dt = 0.02;
  unsigned seed = 7;
  // The resistance less the stiffness, both over that of the largest motion; rotations are angles times the gyration.
  const auto difference = [&](const auto& element, const auto& section) {
    using E = std::decay_t<decltype(element)>;
    constexpr int n = E::nodes;
    const Nodal<double, n> x = testing::PlateShapes<n>(seed++)();
    const SingleElement single{element, section, x};
    typename E::template State<std::decay_t<decltype(section)>, double> state;
    element.begin(state, section, x);
    const auto resistance = element.resistance(state, section, x, Nodal<double, 2 * n>::Zero().eval(), dt);
    CHECK(resistance.mass == Approx(single.nodal_mass()).epsilon(1e-13));
    CHECK(resistance.inertia == Approx(single.nodal_inertia()).epsilon(1e-13));
    const Eigen::MatrixXd expected = 0.25 * dt * dt * single.vibration().stiffness;
    const double gyration = std::sqrt(single.nodal_inertia() / single.nodal_mass());
    Eigen::MatrixXd found(6 * n, 6 * n);
    for (int k = 0; k < 6 * n; ++k) {
      Nodal<double, 2 * n> p = Nodal<double, 2 * n>::Zero();
      p(k) = k < 3 * n ? 1 : 1 / gyration;
      Nodal<double, 2 * n> f = resistance(x, p);
      f.template rightCols<n>() /= gyration;
      found.col(k) = f.reshaped();
    }
    return Eigen::MatrixXd((found - expected) / expected.norm());
  };
  const auto check = [&](const auto& element, const auto& section) {
    CHECK(difference(element, section).colwise().norm().maxCoeff() <= 1e-9);
  };
  const Layered unlike{Layer{PlaneStress{Elastic{1, 1, 0}}, 0.05, Gauss<2>{}},
                       Layer{PlaneStress{Elastic{1, 0.3, 0.45}}, 0.1, Gauss<2>{}}};
  for (int trial = 0; trial < 3; ++trial) {
    check(Plate4{}, two_layers);
    check(Plate4{PlateHourglass{}, RigidOffset{}, ThicknessChange{}}, testing::elastic_plate);
    check(Plate4{NoPlateHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}}, testing::elastic_plate);
    check(Plate4{PhysicalHourglass{}}, two_layers);
    check(Plate4{PhysicalHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}}, testing::elastic_plate);
    check(Plate4{PhysicalHourglass{}, RigidOffset{}, ThicknessChange{}}, two_layers);
    check(Plate3{}, two_layers);
    check(Plate3{ThicknessChange{}, FreeDrilling{}}, testing::elastic_plate);
    // Where Poisson's ratios differ it is more, and never less.
    const Eigen::MatrixXd more = difference(Plate4{PhysicalHourglass{}}, unlike);
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(more).eigenvalues().minCoeff() >= -1e-9);
    CHECK(more.norm() > 1e-6);
  }
}

TEST_CASE("a cube in one-dimensional strain, nu = 0, allows h/c as its elements do, and at nu = 0.35 more than they") {
  const Mesh mesh = cube(8);
  for (const double nu : {0.0, 0.35}) {
    const Elastic law{1, 1, nu};
    const double c = std::sqrt(law.bulk_modulus() + 4. / 3 * law.shear_modulus());
    Explicit run{
        Scene{mesh.nodes, Part{Hex8{ViscousHourglass{1e-3}, HughesWinget{}, NoBulkViscosity{}}, law, mesh.hexahedra}},
        ExplicitOptions{}, in<double>, GlobalStep{.price = 0.01}};
    const double nyquist = 1 / (8 * c), own = least_own_step(run);
    CHECK(run.stable_step().dt <= nyquist * (1 + 1e-9));
    if (nu == 0) {
      CHECK(own == Approx(nyquist).epsilon(1e-3));
      CHECK(run.stable_step().dt >= own);
    } else {
      CHECK(own == Approx(nyquist * c / std::sqrt(3 * law.bulk_modulus())).epsilon(1e-3));  // 0.69
      CHECK(run.stable_step().dt >= 0.95 * nyquist);  // seen: 0.958, for the free corners are lighter
    }
  }
}

TEST_CASE("the step of the whole mesh is never above the exact limit: Taylor bars") {
  const auto check = [&](const auto& element, Index cells, Index layers) {
    auto run = taylor::bar(taylor::mm_ms_kg, cells, layers, in<double>, element, GlobalStep{});
    const Seen seen = watch(run, taylor::mm_ms_kg.end, 10000, 60);
    CHECK(seen.eigenvalue <= 1);  // seen: up to 0.95
    CHECK(seen.gain >= 1.1);
  };
  check(Hex8{}, 1, 16);
  check(Hex8{}, 2, 12);
  check(Hex8{ViscousHourglass{0.02}}, 1, 16);
}

TEST_CASE("the step of the whole mesh is never above the exact limit: distorted cubes that strike a wall") {
  const Solid gruneisen{GruneisenEos{.density = 1, .sound_speed = 1, .S1 = 1.5, .gamma = 2},
                        ElasticStrength{.shear_modulus = 0.3}};
  const auto check = [&](const auto& element, const auto& law) {
    for (const double grading : {1.0, 6.0})
      for (const double speed : {1e-3, 0.03}) {
        const Mesh mesh = cube(4, grading, 0.15);
        auto run = flight(mesh, Part{element, law, mesh.hexahedra}, {0, 0, -speed}, below);
        const Seen seen = watch(run, 100, 60, 20);
        INFO("grading " << grading << ", speed " << speed);
        CHECK(seen.eigenvalue <= 1);  // seen: up to 0.93
      }
  };
  for (const double nu : {0.0, 0.3, 0.499}) check(Hex8{}, Elastic{1, 1, nu});
  check(Hex8{StiffnessHourglass{0.05}}, testing::metal);
  check(Hex8Full{}, Elastic{1, 1, 0.3});
  check(Hex8{ViscousHourglass{0.3}, Jaumann{}, BulkViscosity{}, EndStep{}}, gruneisen);
}

TEST_CASE("the step of the whole mesh is never above the exact limit: tetrahedra that strike a wall") {
  const auto check = [&](const auto& element, const auto& law) {
    for (const double speed : {1e-3, 0.03}) {
      const Mesh mesh = tetrahedralized(cube(3, 1, 0.15));
      auto run = flight(mesh, Part{element, law, mesh.tetrahedra}, {0, 0, -speed}, below);
      const Seen seen = watch(run, 100, 60, 20);
      INFO("speed " << speed);
      CHECK(seen.eigenvalue <= 1);
      CHECK(seen.gain >= 1.3);
    }
  };
  check(Tet4{}, Elastic{1, 1, 0.3});
  check(Tet4{}, Elastic{1, 1, 0.499});
  check(Tet4{ElementPressure{}}, testing::metal);
}

TEST_CASE("the step of the whole mesh is never above the exact limit: plates that strike a wall") {
  const auto check = [&](const auto& element, const auto& section, double warp) {
    for (const double speed : {1e-3, 0.03}) {
      using E = std::decay_t<decltype(element)>;
      const Mesh mesh = testing::for_element<E>(sheet(5, 0.15, warp, 3));
      auto run = flight(mesh, Part{element, section, testing::plate_cells<E>(mesh)}, {0, -speed, -speed},
                        RigidWall{{0, -0.2, -0.06}, {0, 0.5, 1}});
      const Seen seen = watch(run, 100, 60, 20);
      INFO("speed " << speed);
      CHECK(seen.eigenvalue <= 1);
      CHECK(seen.gain >= 1.05);
    }
  };
  check(Plate4{}, testing::elastic_plate, 0);
  check(Plate4{}, testing::elastic_plate, 0.1);
  check(Plate4{}, two_layers, 0.05);
  check(Plate4{PhysicalHourglass{}}, two_layers, 0.05);
  check(Plate3{}, two_layers, 0.05);
  check(Plate4{PlateHourglass{}, RigidOffset{}, ThicknessChange{}},
        Homogeneous{PlaneStress{testing::metal}, 0.01, Gauss<3>{}}, 0.1);
}

TEST_CASE("the bound of a mesh of all elements: near the exact limit, wherever its parts stand in the scene") {
  const auto step = [&](const Eigen::Matrix3d& turn, bool first) {
    Mixed mesh(0.1);
    for (Eigen::Vector3d& x : mesh.nodes) x = turn * x;
    const Elastic law{1, 1, 0.3};
    const Part bricks{Hex8{StiffnessHourglass{0.05}, HughesWinget{}, NoBulkViscosity{}}, law, mesh.hexahedra};
    const Part tetrahedra{Tet4{NodalPressure{}, HughesWinget{}, NoBulkViscosity{}}, law, mesh.tetrahedra};
    const Part shell{Plate4{}, Homogeneous{PlaneStress{law}, 0.05}, mesh.shell};
    const auto look = [](auto run) {
      const double dt = run.stable_step().dt;
      const auto vibration = testing::vibration(run);
      CHECK(testing::eigenvalue(vibration, dt) <= 1);
      CHECK(testing::eigenvalue(vibration, dt / 0.9) >= 1);
      CHECK(dt >= 1.3 * least_own_step(run));
      return dt;
    };
    if (first) return look(Explicit{Scene{mesh.nodes, shell, bricks, tetrahedra}, {}, in<double>, GlobalStep{}});
    return look(Explicit{Scene{mesh.nodes, tetrahedra, bricks, shell}, {}, in<double>, GlobalStep{}});
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const double dt = step(Eigen::Matrix3d::Identity(), true);
  CHECK(step(turn, true) == Approx(dt).epsilon(0.05));  // other random directions
  CHECK(step(turn, false) == Approx(dt).epsilon(0.05));
}

TEST_CASE("plates whose mass is scaled have the bound of the mesh too") {
  const Mesh mesh = sheet(4, 0.1, 0, 3);
  Explicit run{Scene{mesh.nodes, Part{MassScaled{Plate4{}, 0.3}, testing::elastic_plate, mesh.quadrilaterals}},
               {},
               in<double>,
               GlobalStep{}};
  const double dt = run.stable_step().dt;
  const auto vibration = testing::vibration(run);
  CHECK(dt > 1.05 * 0.3);
  CHECK(testing::eigenvalue(vibration, dt) <= 1);
  CHECK(testing::eigenvalue(vibration, dt / 0.9) >= 1);
}

TEST_CASE("Taylor bar with the bound of the whole mesh: the same bar in fewer steps, and its energy in balance") {
  const Hex8 element{ViscousHourglass{}};
  auto usual = taylor::bar(taylor::mm_ms_kg, 2, 32, in<double>, element);
  usual.until(taylor::mm_ms_kg.end);
  const auto check = [&](auto number) {
    auto run = taylor::bar(taylor::mm_ms_kg, 2, 32, number, element, GlobalStep{});
    double drift = 0;
    run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
    CHECK(taylor::length(run) == Approx(taylor::length(usual)).epsilon(1e-3));
    CHECK(taylor::radius(run) == Approx(taylor::radius(usual)).epsilon(1e-3));
    CHECK(taylor::plastic_strain(run) == Approx(taylor::plastic_strain(usual)).epsilon(3e-3));
    CHECK(drift < 2e-3);
    CHECK(static_cast<double>(run.steps()) < 0.85 * static_cast<double>(usual.steps()));  // seen: 0.81
    CHECK(run.step_bound().estimates() < 100);
  };
  check(in<double>);
  check(in<Pack<float>>);
}

TEST_CASE("the bound of the whole mesh does not mind parts, nor elements that fail") {
  const Mesh mesh = cube(6, 3);
  Cells<8> lower, upper;
  for (const auto& cell : mesh.hexahedra) (centroid(mesh.nodes, cell).z() < 0.3 ? lower : upper).push_back(cell);
  const Elastic law{1, 1, 0.3};
  auto one = flight(mesh, Part{Hex8{}, law, mesh.hexahedra}, {0, 0, 0}, below, GlobalStep{.price = 0.01});
  Explicit two{Scene{mesh.nodes, Part{Hex8{}, law, lower}, Part{Hex8{}, law, upper}}, ExplicitOptions{}, in<double>,
               GlobalStep{.price = 0.01}};
  CHECK(two.stable_step().dt == Approx(one.stable_step().dt).epsilon(0.02));
  CHECK(one.stable_step().dt > 1.2 * least_own_step(one));

  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 1}, ElasticStrength{.shear_modulus = 0.4},
                      UltimateStress{0.02}};
  auto run = flight(mesh, Part{Hex8{}, brittle, mesh.hexahedra}, {0, 0, -0.05}, RigidWall{{0, 0, 0}, {0, 0, 1}});
  run.until(2);
  const auto intact = run.part<0>().field([](const auto& state) { return state.intact; });
  CHECK(*std::min_element(intact.begin(), intact.end()) == 0);
  CHECK(std::isfinite(run.energy().kinetic));
}
