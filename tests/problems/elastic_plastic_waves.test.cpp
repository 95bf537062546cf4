#include <cmath>
#include <numeric>
#include <utility>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// A column in uniaxial strain that strikes a wall at v: an elastic precursor and, slower, a plastic wave.
struct Impact {
  double youngs_modulus, poissons_ratio, density, yield_stress, hardening_modulus, v;

  double K() const { return youngs_modulus / (3 * (1 - 2 * poissons_ratio)); }
  double G() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }

  /// The linear theory: HEL + rho c_P (v - v_HEL).
  double linear_stress() const {
    const double Y = yield_stress, H = hardening_modulus, rho = density;
    const double HEL = Y * (K() / (2 * G()) + 2.0 / 3), elastic = std::sqrt((K() + 4 * G() / 3) / rho);
    const double plastic = std::sqrt((K() + 4 * G() / 3 * H / (3 * G() + H)) / rho);
    return HEL + rho * plastic * (v - HEL / (rho * elastic));
  }

  /// Axial stress, positive in compression, at the relative volume J: p = K (1/J - 1), logarithmic strain e = -ln J,
  /// and from 2 G e - 3 G ep = Y + H ep the plastic strain.
  double stress(double J) const {
    const double e = -std::log(J), trial = 2 * G() * e;
    const double ep = std::max(0.0, trial - yield_stress) / (3 * G() + hardening_modulus);
    return K() * (1 / J - 1) + 2.0 / 3 * (trial - 3 * G() * ep);
  }
  struct State {
    double J, stress, v;
  };
  /// Two shocks, mass and momentum kept across each: (v - v0)^2 = (s - s0) (J0 - J)/rho, U = (v - v0)/(J0 - J).
  State behind(const State& front, double speed) const {
    double stiff = 0.1, soft = front.J;  // the wanted J lies between, for the speed falls with J
    for (int i = 0; i < 200; ++i) {
      const double J = 0.5 * (stiff + soft);
      const double dv = std::sqrt((stress(J) - front.stress) * (front.J - J) / density);
      (front.v + dv > speed ? stiff : soft) = J;
    }
    return {soft, stress(soft), speed};
  }
  State elastic_limit() const {
    const double J = std::exp(-yield_stress / (2 * G()));
    return {J, stress(J), std::sqrt(stress(J) * (1 - J) / density)};
  }
};

// The plateau within 0.5 % and the speed of the plastic front within 1 %, which one front of five elements in 60 may be
// off by; between the two fronts stands the elastic limit.
void check_waves(const Impact& impact) {
  const Index N = 200;
  const double h = 1e-3, L = N * h;
  const Mesh mesh = column(N, L, h);
  const std::vector<Index> all = all_nodes(mesh.nodes);
  const Solid material{LinearEos{.density = impact.density, .bulk_modulus = impact.K()},
                       VonMises{.shear_modulus = impact.G(),
                                .yield_stress = impact.yield_stress,
                                .hardening_modulus = impact.hardening_modulus}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}, InitialVelocity{{-impact.v, 0, 0}},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}, RigidWall{{0, 0, 0}, {1, 0, 0}}}};
  const auto stress = [&] { return run.part<0>().field([](const auto& state) { return -state.stress.xx; }); };

  const Impact::State elastic = impact.elastic_limit(), plastic = impact.behind(elastic, impact.v);
  const double U = (plastic.v - elastic.v) / (elastic.J - plastic.J);  // per reference length
  const double precursor = elastic.v / (1 - elastic.J);
  const double halfway = 0.5 * (elastic.stress + plastic.stress);
  double at_60 = 0, at_120 = 0;
  while (at_120 == 0) {
    run.step();
    const std::vector<double> s = stress();
    if (at_60 == 0 && s[60] > halfway) at_60 = run.time();
    if (at_120 == 0 && s[120] > halfway) at_120 = run.time();
    REQUIRE(run.time() < L / U);
  }
  const std::vector<double> s = stress();
  CHECK(std::accumulate(s.begin() + 40, s.begin() + 90, 0.0) / 50 == Approx(plastic.stress).epsilon(5e-3));
  CHECK(60 * h / (at_120 - at_60) == Approx(U).epsilon(0.01));
  const auto between = static_cast<std::size_t>(0.5 * (120 + precursor * at_120 / h));
  REQUIRE(between + 10 < N);
  CHECK(s[between] == Approx(elastic.stress).epsilon(0.01));
  CHECK(std::abs(run.energy().error()) < 5e-4);
}

constexpr Impact steel(double v) { return {200e9, 0.3, 7850, 400e6, 0, v}; }
constexpr Impact copper(double v) { return {117e9, 0.35, 8930, 400e6, 100e6, v}; }

}  // namespace

TEST_CASE("elastic-plastic waves in steel") {
  check_waves(steel(50));
  check_waves(steel(227));
}

TEST_CASE("elastic-plastic waves in copper that hardens") {
  check_waves(copper(50));
  check_waves(copper(227));
}

// The small-strain values (Wood 1952) are the limit of the jump conditions: off by the strain behind the front.
TEST_CASE("jump conditions of elastic-plastic waves against the linear theory") {
  for (const auto& [impact, linear] : {std::pair{steel(50), 1.957787e9},
                                       {steel(227), 8.360035e9},
                                       {copper(50), 1.849323e9},
                                       {copper(227), 7.881094e9}}) {
    CHECK(impact.linear_stress() == Approx(linear).epsilon(1e-6));
    const Impact::State behind = impact.behind(impact.elastic_limit(), impact.v);
    CHECK(behind.stress == Approx(linear).epsilon(1 - behind.J));
  }
}

// Two releases that meet pull with rho c v/2. It rings by 7 % beyond that with bulk viscosity in compression alone.
TEST_CASE("tension behind two releases does not overshoot with bulk viscosity both ways") {
  const Index layers = 100;
  const double h = 1e-3, v = 1, rho = 2700, c = 6000;
  const Mesh mesh = column(3 * layers, 3 * layers * h, h);
  const auto peak = [&](auto viscosity) {
    Explicit run{Scene{
        mesh.nodes,
        Part{Hex8{ViscousHourglass{}, HughesWinget{}, viscosity},
             Elastic{.density = rho, .youngs_modulus = rho * c * c, .poissons_ratio = 0}, mesh.hexahedra},
        InitialVelocity{{v, 0, 0}, nodes_where(mesh.nodes, [&](const auto& x) { return x[0] < (layers - 0.5) * h; })},
        Symmetry{Axis::y, all_nodes(mesh.nodes)}, Symmetry{Axis::z, all_nodes(mesh.nodes)}}};
    double largest = 0;
    run.until(3.75 * layers * h / c, [&] {
      for (const double s : run.template part<0>().field([](const auto& state) { return state.stress.xx; }))
        largest = std::max(largest, s);
    });
    CHECK(std::abs(run.energy().error()) < 1e-4);
    return largest / (0.5 * rho * c * v);
  };
  CHECK(peak(BulkViscosityBothWays{}) == Approx(1).margin(0.01));
  CHECK(peak(BulkViscosity{}) > 1.05);
}
