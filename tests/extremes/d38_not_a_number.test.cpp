// D38: a number that is NaN is named with its owner, its place and its time, at once.
#include <cmath>
#include <limits>
#include <string>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double nan_number = std::numeric_limits<double>::quiet_NaN(), later = 0.05;
const Elastic rubber{.density = 1000, .youngs_modulus = 1e6, .poissons_ratio = 0.3};
const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});

double spoilt(double time) { return time > later ? nan_number : 1; }

/// A load that tells a share of its power.
struct Wind {
  double force, share = 1;
  double now = 0;
  template <class N>
  void apply_loads(N& nodes, double time) {
    now = force * spoilt(time), nodes.add_force(3, {now, 0, 0});
  }
  template <class N>
  double power(const N& nodes) const {
    return share * now * nodes.v(3).x();
  }
};

/// A contact that spoils a velocity without a word to the ledger.
struct Spoiler {
  template <class N, class L>
  void resolve_contact(N& nodes, const Step& step, L&) const {
    if (step.time > later) nodes.set_velocity(3, {0, nan_number, 0});
  }
};
struct Launch {
  template <class N>
  void begin(N& nodes) const {
    nodes.set_velocity(2, {0, nan_number, 0});
  }
};

/// Rubber whose stress is NaN once it has moved.
struct Mistaken : Elastic {
  template <class S, class R>
  auto stress(S& state, const R& rate, double dt) const {
    auto result = Elastic::stress(state, rate, dt);
    using T = std::decay_t<decltype(state.stress.xx)>;
    state.stress.xx = select(abs(state.stress.xx) > 0.0, T(nan_number), state.stress.xx);
    return result;
  }
  template <class S>
  auto stress(const S& state) const {
    return Elastic::stress(state);
  }
};

template <class Material, class... Items>
std::string told(const Material& material, Items... items) {
  try {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}, items...},
                 ExplicitOptions{.largest_step = 0.005, .energy_tolerance = 0.5, .print_warnings = false}, in<double>};
    run.until(0.1);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST_CASE("D38: the item that gives NaN is named, with the node and the first step") {
  const auto spoils = [](const std::string& sentence, const std::string& what, const std::string& time = "0.055,") {
    CHECK_THAT(sentence, ContainsSubstring(what) && ContainsSubstring("strike: at t = " + time));
  };
  spoils(told(rubber, Wind{1}), "item 1 of the scene, Wind, gives the force (nan, 0, 0) to node 3 at (");
  spoils(told(rubber, NodalForce{{0, 0, 1}, {5}, spoilt}, Wind{1}), "item 1 of the scene, NodalForce, gives the force");
  spoils(told(rubber, RigidWall{{0, 0, -1}, {0, 0, 1}}, Pressure{surface(mesh), spoilt}),
         "item 2 of the scene, Pressure, gives the force");
  spoils(told(rubber, BodyForce{{0, 0, 1}, spoilt}), "item 1 of the scene, BodyForce, gives the force");
  spoils(told(rubber, PrescribedVelocity{Axis::x, {1}, [](double t) { return spoilt(t) - 1; }}),
         "item 1 of the scene, PrescribedVelocity, gives the velocity", "0.05,");
  spoils(told(rubber, Spoiler{}), "the position of node 3 at (0, nan, 0) is", "0.06,");
}

TEST_CASE("D38: a law that gives NaN is named with the element") {
  CHECK_THAT(told(Mistaken{rubber},
                  InitialVelocityField{[](const Eigen::Vector3d& x) { return Eigen::Vector3d(x.x(), 0, 0); }}),
             ContainsSubstring("the state of element 0 of part 0 at (") &&
                 ContainsSubstring("is nan: look at the formulas of its material, Mistaken, and of its element"));
}

TEST_CASE("D38: coordinates and velocities at the start") {
  Mesh broken = mesh;
  broken.nodes[4].x() = nan_number;
  CHECK_THROWS_WITH((Explicit{Scene{broken.nodes, Part{Hex8{}, rubber, broken.hexahedra}}, in<double>}),
                    "strike: node 4 is at (nan, 0.5, 0); give it coordinates that are finite.");
  CHECK(told(rubber, Launch{}) ==
        "strike: the velocity of node 2 at (1, 0, 0) is (0, nan, 0) at the start; correct "
        "the item that gives it.");
}

TEST_CASE("D38: a load that tells another power than its own is named where the balance is off") {
  CHECK_THAT(told(rubber, Wind{.force = 1000, .share = 0}),
             ContainsSubstring("the energy balance is off by") &&
                 ContainsSubstring("item 1 of the scene, Wind, tells the power 0 where its forces have "));
  CHECK_THAT(told(rubber, Wind{.force = 1000, .share = -1}), ContainsSubstring("correct its power(nodes)"));
}

TEST_CASE("D38: units that do not fit together are suspected in one warning") {
  const auto warnings = [](const Elastic& material, double end) {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}, {.print_warnings = false}, in<double>};
    run.until(end, StopWhen{[] { return true; }});
    return run.warnings();
  };
  CHECK(warnings(rubber, 10).empty());
  REQUIRE(warnings(rubber, 1e9).size() == 1);
  CHECK_THAT(warnings(rubber, 1e9)[0],
             ContainsSubstring("steps to the end of the run; if that is not meant, look whether all numbers"));
  Elastic slip = rubber;
  slip.density = 1e-12;
  REQUIRE(warnings(slip, 1e9).size() == 1);
  CHECK_THAT(warnings(slip, 1e-9)[0], ContainsSubstring("Waves in part 0 have the speed 1.16"));
}
