#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <strike/strike.hpp>

#include "conformance/element.hpp"
#include "dynamics/assembled.hpp"
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
  for (const auto& block : run.template part<0>().blocks())
    least = std::min(least, 1 / static_cast<double>(reduce_max(block.state.followed.now)));
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

TEST_CASE("so many steps of Lanczos's iteration as the probability of failure asks for, and not one more") {
  for (const double deviation : {0.01, 0.1})
    for (const std::size_t n : {1000u, 1000000u}) {
      const auto failure = [&](double k) {
        return 1.648 * std::sqrt(static_cast<double>(n)) * std::exp(-std::sqrt(deviation) * (2 * k - 1));
      };
      const auto steps = static_cast<double>(strike::detail::lanczos_steps(n, deviation, 1e-9));
      CHECK(failure(steps) <= 1e-9);
      CHECK(failure(steps - 1) > 1e-9);
    }
  CHECK(strike::detail::lanczos_steps(24, 0.001, 1e-9) == 24);  // there are no more directions
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
    for (int k = 0; k < 24; ++k) {
      Nodal<double, 8> p = Nodal<double, 8>::Zero();
      p(k) = 1;
      const Nodal<double, 8> f = resistance(x, p);
      CHECK((f.reshaped() - expected.col(k)).norm() <= 1e-5 * expected.norm());  // of the steps of the derivatives
    }
  };
  const Nodal<double, 8> still = Nodal<double, 8>::Zero();
  for (int trial = 0; trial < 3; ++trial) {
    check(Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8{ViscousHourglass{0.2}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8{StiffnessHourglass{0.1}, HughesWinget{}, NoBulkViscosity{}}, still);
    check(Hex8{PhysicalHourglass{}, HughesWinget{}, NoBulkViscosity{}}, still);
  }
}

TEST_CASE("a cube in one-dimensional strain, nu = 0, allows h/c as its elements do, and at nu = 0.35 more than they") {
  const Mesh mesh = cube(8);
  for (const double nu : {0.0, 0.35}) {
    const Elastic law{1, 1, nu};
    const double c = std::sqrt(law.bulk_modulus() + 4. / 3 * law.shear_modulus());
    Explicit run{
        Scene{mesh.nodes, Part{Hex8{ViscousHourglass{1e-3}, HughesWinget{}, NoBulkViscosity{}}, law, mesh.hexahedra}},
        ExplicitOptions{}, GlobalStep{.deviation = 0.01}};
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
  check(Hex8{StiffnessHourglass{0.01}}, 1, 16);
  check(Hex8{PhysicalHourglass{}}, 1, 16);
  check(Hex8{ViscousHourglass{0.02}, HughesWinget{}, NoBulkViscosity{}}, 1, 16);
}

TEST_CASE("the step of the whole mesh is never above the exact limit: distorted cubes that strike a wall") {
  const Solid gruneisen{GruneisenEos{.density = 1, .sound_speed = 1, .S1 = 1.5, .gamma = 2},
                        ElasticStrength{.shear_modulus = 0.3}};
  const auto check = [&](const auto& element, const auto& law) {
    for (const double grading : {1.0, 6.0})
      for (const double speed : {1e-3, 0.03}) {
        const Mesh mesh = cube(4, grading, 0.15);
        Explicit run{Scene{mesh.nodes, Part{element, law, mesh.hexahedra}, InitialVelocity{{0, 0, -speed}},
                           RigidWall{{0, 0, -0.1}, {0, 0, 1}}},
                     ExplicitOptions{}, in<double>, GlobalStep{}};
        const Seen seen = watch(run, 100, 60, 20);
        INFO("grading " << grading << ", speed " << speed);
        CHECK(seen.eigenvalue <= 1);  // seen: up to 0.93
      }
  };
  for (const double nu : {0.0, 0.3, 0.499}) check(Hex8{}, Elastic{1, 1, nu});
  check(Hex8{StiffnessHourglass{0.05}}, testing::metal);
  check(Hex8{PhysicalHourglass{}}, testing::metal);
  check(Hex8{ViscousHourglass{0.3}, Jaumann{}, BulkViscosity{}, EndStep{}}, gruneisen);
}

TEST_CASE("Taylor bar with the bound of the whole mesh: the same bar in fewer steps, and its energy in balance") {
  auto usual = taylor::bar(taylor::mm_ms_kg, 3, 50, in<Pack<double>>);
  usual.until(taylor::mm_ms_kg.end);
  const auto check = [&](auto number) {
    auto run = taylor::bar(taylor::mm_ms_kg, 3, 50, number, Hex8{}, GlobalStep{});
    double drift = 0;
    run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
    CHECK(taylor::length(run) == Approx(taylor::length(usual)).epsilon(1e-3));
    CHECK(taylor::radius(run) == Approx(taylor::radius(usual)).epsilon(1e-3));
    CHECK(taylor::plastic_strain(run) == Approx(taylor::plastic_strain(usual)).epsilon(3e-3));
    CHECK(drift < 2e-3);
    CHECK(static_cast<double>(run.steps()) < 0.85 * static_cast<double>(usual.steps()));  // seen: 0.81
    CHECK(run.step_bound().estimates() < 100);
  };
  check(in<Pack<double>>);
  check(in<Pack<float>>);
}

TEST_CASE("the bound of the whole mesh does not mind parts, nor elements that fail") {
  const Mesh mesh = cube(6, 3);
  Cells<8> lower, upper;
  for (const auto& cell : mesh.hexahedra) (centroid(mesh.nodes, cell).z() < 0.3 ? lower : upper).push_back(cell);
  const Elastic law{1, 1, 0.3};
  Explicit one{Scene{mesh.nodes, Part{Hex8{}, law, mesh.hexahedra}}, ExplicitOptions{}, GlobalStep{.deviation = 0.01}};
  Explicit two{Scene{mesh.nodes, Part{Hex8{}, law, lower}, Part{Hex8{}, law, upper}}, ExplicitOptions{},
               GlobalStep{.deviation = 0.01}};
  CHECK(two.stable_step().dt == Approx(one.stable_step().dt).epsilon(0.02));
  CHECK(one.stable_step().dt > 1.2 * least_own_step(one));

  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 1}, ElasticStrength{.shear_modulus = 0.4},
                      UltimateStress{0.02}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, brittle, mesh.hexahedra}, InitialVelocity{{0, 0, -0.05}},
                     RigidWall{{0, 0, 0}, {0, 0, 1}}},
               ExplicitOptions{}, GlobalStep{}};
  run.until(2);
  const auto intact = run.part<0>().field([](const auto& state) { return state.intact; });
  CHECK(*std::min_element(intact.begin(), intact.end()) == 0);
  CHECK(std::isfinite(run.energy().kinetic));
}
