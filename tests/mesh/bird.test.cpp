#include <algorithm>
#include <cmath>

#include <strike/mesh/bird.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
constexpr double mass = 1.81436948, density = 0.95e-6;  // 4 lb, mm and kg
constexpr BirdForm forms[] = {BirdForm::cylinder, BirdForm::hemispherical_ends, BirdForm::ellipsoid};
}  // namespace

TEST_CASE("bird: diameters and lengths of 4 lb at 950 kg/m3, twice as long as wide") {
  const std::pair<double, double> expected[] = {{106.73, 213.46}, {113.42, 226.84}, {122.18, 244.36}};
  for (std::size_t i = 0; i < 3; ++i) {
    const BirdSize size = size_of({.mass = mass, .density = density, .form = forms[i]});
    CHECK(size.diameter == Approx(expected[i].first).margin(0.005));
    CHECK(size.length == Approx(expected[i].second).margin(0.01));
  }
}

TEST_CASE("bird: every mesh is sound, has exactly its mass, and nearly the size of the smooth body") {
  for (const BirdForm form : forms)
    for (const auto& [sector, share] : {std::pair{Sector::quarter, 0.25}, {Sector::half, 0.5}, {Sector::full, 1.0}})
      for (const Index cells : {1u, 2u, 3u}) {
        const BirdShape shape{
            .mass = mass, .density = density, .form = form, .cells = cells, .layers = 6, .sector = sector};
        const Mesh mesh = bird(shape), tetrahedra = tetrahedralized(mesh);
        CAPTURE(static_cast<int>(form), share, cells);
        CHECK_NOTHROW(check(mesh));
        CHECK_NOTHROW(check(tetrahedra));
        CHECK(density * volume(mesh) == Approx(share * mass).epsilon(1e-12));
        // Warped faces are cut in two by tetrahedra: what they lose on one side of a face is the other's but outside.
        CHECK(density * volume(tetrahedra) == Approx(share * mass).epsilon(0.02));
        double length = 0, radius = 0;
        for (const auto& x : mesh.nodes)
          length = std::max(length, x.z()), radius = std::max(radius, std::hypot(x.x(), x.y()));
        const BirdSize size = size_of(shape);
        const double larger = cells == 3 ? 0.02 : cells == 2 ? 0.04 : 0.16;
        CHECK(length >= size.length);
        CHECK(length <= (1 + larger) * size.length);
        CHECK(2 * radius == Approx(size.diameter * length / size.length).epsilon(1e-9));
        CHECK(surface(mesh).size() > 0);
      }
  const Mesh ball = bird({.mass = 1, .density = 1, .form = BirdForm::ellipsoid, .cells = 2, .sector = Sector::full});
  CHECK(ball.hexahedra.size() == 8 * 4 * 8);
  CHECK(surface(ball).size() == 6 * 16 + 0);
}
