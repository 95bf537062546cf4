#include "problems/taylor_wedges.hpp"

#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"
#include "support/cut_hexahedra.hpp"

using namespace strike;

namespace {

struct Struck {
  double length, radius;  // [mm]
};
Struck struck(const Mesh& mesh, double share_of_time = 1) {
  check(mesh);
  const auto& data = taylor::mm_ms_kg;
  auto run = taylor::bar(data, mesh, in<Pack<double>>, Hex8{});
  run.until(share_of_time * data.end);
  CHECK(std::abs(run.energy().error()) < 1e-3);
  return {taylor::length(run), taylor::radius(run)};
}

}  // namespace

TEST_CASE("Taylor bar in rings about its axis, of which the innermost are wedges") {
  // X3D and DYNA3D (Brockman and Held 1991): 21.47 mm, 7.081 and 7.034 mm; the limit of fine meshes is 21.42 mm
  // and 7.21 to 7.23 mm (docs/verification.md). A mesh as coarse as theirs lies between.
  const auto [length, radius] = struck(taylor::bar_of_rings(3.2, 32.4, 5, 6, 50));
  CHECK(length == Approx(21.47).margin(0.08));
  CHECK(radius >= 7.03);
  CHECK(radius <= 7.23);
}

TEST_CASE("Taylor bar of wedges and of pyramids, cut from hexahedra, beside these") {
  // Until half the time, when the foot is nearly as wide as at the end: flat pyramids take most of their steps later.
  // With 3 cells and 50 layers 21.48 mm and 7.18 to 7.20 mm at the end, in minutes.
  constexpr double half = 0.5;
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4, .cells = 2, .layers = 32});
  const auto [length, radius] = struck(bar, half);
  for (const Mesh& mesh : {testing::cut_into_wedges(bar), testing::cut_into_pyramids(bar)}) {
    const auto [cut_length, cut_radius] = struck(mesh, half);
    CAPTURE(cut_length, length, cut_radius, radius);
    CHECK(cut_length == Approx(length).epsilon(2e-3));
    CHECK(cut_radius == Approx(radius).epsilon(2e-2));
  }
}
