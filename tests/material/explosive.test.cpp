#include <algorithm>
#include <cmath>

#include <strike/element/hex8.hpp>
#include <strike/material/eos/jwl.hpp>
#include <strike/material/explosive.hpp>

#include "conformance/material.hpp"
#include "support/catch.hpp"
#include "support/tnt.hpp"

using namespace strike;

namespace {

constexpr Jwl products = tnt::products;
constexpr double D = tnt::detonation_velocity, p_CJ = tnt::pressure_CJ, width = .01;

}  // namespace

static_assert(SolidMaterial<Explosive<Jwl, DetonationPoint>>);
static_assert(Ignition<DetonationPoint> && Ignition<DetonationPlane> && Ignition<DetonationPoints> && !Ignition<Burn> &&
              !Ignition<double>);

TEST_CASE("explosive: it burns when the front comes by, over the width of the front, and stays burnt") {
  const Explosive tnt{products, DetonationPoint{{1, 2, 3}, 1e-5}, {D, width}};
  Explosive<Jwl, DetonationPoint>::State<double> state;
  tnt.begin(state, Vector3<double>{1, 5, 7});
  CHECK(state.time_since_lit == Approx(-1e-5 - 5 / D).epsilon(1e-14));
  const double dt = .1 * width / D, full = products.A(0.0) + products.B(0.0) * 7e9;
  double time = 0;
  const auto step = [&](double J) { return -tnt.stress(state, {{}, J}, dt).xx; };
  for (; time + dt < 1e-5 + 5 / D; time += dt) CHECK(step(1) == 0);
  for (; state.burnt < 1; time += dt) {
    const double p = step(1);
    CHECK(p == Approx(std::min(1.0, (time + dt - 1e-5 - 5 / D) * D / width) * full).margin(1e-9 * full));
  }
  CHECK(time - 1e-5 - 5 / D == Approx(width / D).epsilon(.11));
  CHECK(step(1) == Approx(full).epsilon(1e-14));
  CHECK(state.internal_energy == 7e9);

  const DetonationPlane plane{{1, 0, 0}, {2, 0, 0}};
  CHECK(plane.distance(Vector3<double>{-3, 5, 7}) == 4);
}

TEST_CASE("explosive: of several starts the front that comes first counts, without any all is lit at 0") {
  const DetonationPoint near{{1, 0, 0}, 3e-4}, far{{-2, 0, 0}, 1e-4};
  const auto arrival = [](const DetonationPoints& points, const Vector3<double>& x) {
    const Explosive tnt{products, points, {D, width}};
    Explosive<Jwl, DetonationPoints>::State<double> state;
    tnt.begin(state, x);
    return -state.time_since_lit;
  };
  // The fronts meet where 3e-4 + (1 - x)/D = 1e-4 + (2 + x)/D.
  const double meet = (2e-4 * D - 1) / 2;
  REQUIRE((meet > -2 && meet < 1));
  for (const auto& points : {DetonationPoints{{near, far}}, DetonationPoints{{far, near}}}) {
    CHECK(points.time == 1e-4);
    for (const double x : {-2.0, -1.0, 0.0, meet, 0.9, 1.0})
      CHECK(arrival(points, {x, 0, 0}) ==
            Approx(x < meet ? 1e-4 + (2 + x) / D : std::min(3e-4 + (1 - x) / D, 1e-4 + (2 + x) / D)).epsilon(1e-14));
    CHECK(arrival(points, {1, 3, 4}) == Approx(std::min(3e-4 + 5 / D, 1e-4 + std::sqrt(34.0) / D)).epsilon(1e-14));
  }
  Explosive<Jwl, DetonationPoint>::State<double> one;
  Explosive{products, near, {D, width}}.begin(one, Vector3<double>{.3, .4, .5});
  CHECK(arrival(DetonationPoints{{near}}, {.3, .4, .5}) == Approx(-one.time_since_lit).epsilon(1e-15));
  CHECK(arrival(DetonationPoints{}, {.3, .4, .5}) == 0);
}

TEST_CASE("explosive: compression burns it, all at the volume of Chapman and Jouguet") {
  const Explosive tnt{products, DetonationPoint{{0, 0, 0}, 1.0}, {D, width, p_CJ}};
  const double V_CJ = 1 - p_CJ / (1630 * D * D);
  Explosive<Jwl, DetonationPoint>::State<double> state;
  tnt.begin(state);
  double V = 1, p = 0, work = 0;
  const double dt = 1e-8, theta = std::log(V_CJ) / 200;
  for (int i = 0; i < 200; ++i) {
    const double V_old = V, p_old = p;
    V *= (1 + theta / 2) / (1 - theta / 2);
    p = -tnt.stress(state, {SymmetricTensor<double>::isotropic(theta / (3 * dt)), V}, dt).xx;
    work -= .5 * (p_old + p) * (V - V_old);
    CHECK(state.burnt == Approx(std::min(1.0, (1 - V) / (1 - V_CJ))).epsilon(1e-12));
    CHECK(p > p_old);
    CHECK(state.internal_energy == Approx(7e9 + work).epsilon(1e-12));
  }
  const double burnt = state.burnt;
  CHECK(burnt == Approx(1).epsilon(1e-5));
  tnt.stress(state, {{}, 1.5}, dt);
  CHECK(state.burnt == burnt);  // for good
}

TEST_CASE("explosive: an element tells the material where it lies") {
  Nodal<double, 8> x;
  for (int i = 0; i < 8; ++i) x.col(i) = Vector3<double>{4. + ((i + 1) / 2 % 2), i / 2 % 2 * 1., i / 4 * 1.};
  const Explosive tnt{products, DetonationPlane{{0, 0, 0}, {1, 0, 0}}, {D, width}};
  Hex8<>::State<Explosive<Jwl, DetonationPlane>, double> state;
  Hex8{}.begin(state, tnt, x);
  CHECK(state.material.time_since_lit == Approx(-4.5 / D).epsilon(1e-14));
}

// It gives energy and its pressure grows while it burns, as no other material may; the other laws it obeys.
TEST_CASE("conformance: Explosive of Jwl") {
  const testing::Drive drive;
  const Explosive tnt{products, DetonationPoint{{0, 0, 0}, 5e-6}, {D, 20e-6 * D, p_CJ}};
  testing::lanes_agree<Pack<float, 16>>(tnt, drive);
  testing::bounds_its_tangent(tnt, drive);
  testing::bears_extremes<Pack<float, 16>>(tnt);
}
