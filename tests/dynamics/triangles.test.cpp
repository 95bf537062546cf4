// Triangular plates at work: a scene of them beside quadrilaterals, told and run in several ways.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/strike.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/frame.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using testing::difference;
using testing::Frame;
using testing::Points;
using testing::positions;

namespace {

const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1000 / 1.2},
                  VonMises{.shear_modulus = 1000 / 2.6, .yield_stress = 1}};
const Layered section{Layer{PlaneStress{metal}, 0.1, Gauss<3>{}}, Layer{PlaneStress{metal}, 0.1, Gauss<3>{}}};

/// Bends a sheet in its plane and out of it, stretches and twists it.
struct Struck {
  Frame frame;
  template <class Archive>
  void serialize(Archive&) {}
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d x = frame.back(nodes.x(i));
      const double s = x.x() / 6, y = x.y() - 1;
      nodes.set_velocity(i, frame.turn * Eigen::Vector3d(-1.5 * s * y, 2 * s * s, s * s + s * y));
      nodes.set_angular_velocity(i, frame.turn.determinant() * (frame.turn * Eigen::Vector3d(s, -s / 3, s)));
    }
  }
};
/// A sheet of which the half at large x is of triangles.
const Mesh sheet_of_both = [] {
  Mesh mesh = rectangle({.size = {6, 2}, .cells = {6, 2}});
  for (auto& x : mesh.nodes) x += Eigen::Vector3d(0.1 * std::sin(5 * x.x()), 0, 0.15 * std::sin(x.x() + 2 * x.y()));
  Mesh cut = mesh;
  const auto is_far = [&](const std::array<Index, 4>& cell) { return centroid<4>(mesh.nodes, cell).x() > 3; };
  std::erase_if(cut.quadrilaterals, [&](const auto& cell) { return !is_far(cell); });
  std::erase_if(mesh.quadrilaterals, is_far);
  mesh.triangles = triangulated(cut).triangles;
  return mesh;
}();
constexpr double end = 1;

template <class... Policies>
auto struck(const Frame& frame, const Mesh& mesh, const Policies&... policies) {
  Mesh placed = mesh;
  for (auto& x : placed.nodes) x = frame(x);
  return Explicit{
      Scene{placed.nodes, Part{Plate4{}, section, placed.quadrilaterals},
            Part{Plate3{ThicknessChange{}}, section, placed.triangles, Erosion{.strain = 0.12}}, Struck{frame}},
      ExplicitOptions{}, policies...};
}

}  // namespace

TEST_CASE("triangles beside quadrilaterals: turned, moved, mirrored, flipped or numbered anew, in any numbers") {
  auto plain = struck(Frame{}, sheet_of_both, in<double>);
  plain.until(end);
  CHECK(std::abs(plain.energy().error()) < 5e-3);
  CHECK(plain.energy().eroded > 0);
  const Points x = positions(plain);
  const auto alike = [&](const Frame& frame, const Mesh& mesh) {
    auto run = struck(frame, mesh, in<double>);
    run.until(end);
    CHECK(difference(positions(run, frame), x) < 1e-9 * 6);
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  alike({turn, {3, -5, 7}}, sheet_of_both);
  alike({Eigen::Vector3d(1, -1, 1).asDiagonal(), {0, 0, 0}}, sheet_of_both);
  Mesh renumbered = sheet_of_both;
  std::ranges::reverse(renumbered.triangles);
  for (std::size_t c = 0; c < renumbered.triangles.size(); ++c) {
    auto& t = renumbered.triangles[c];
    std::rotate(t.begin(), t.begin() + std::ptrdiff_t(c % 3), t.end());
  }
  alike({}, renumbered);
  for (auto& t : renumbered.triangles) std::swap(t[1], t[2]);
  alike({}, renumbered);

  const ScratchFolder folder("triangles");
  auto first = struck(Frame{}, sheet_of_both, in<double>), second = struck(Frame{}, sheet_of_both, in<double>);
  first.until(0.4 * end), write_checkpoint(folder / "first", first);
  read_checkpoint(folder / "first", second), first.until(end), second.until(end);
  CHECK(positions(second) == positions(first));

  auto mixed = struck(Frame{}, sheet_of_both, in<Pack<float>, double>);
  mixed.until(end);
  CHECK(difference(positions(mixed), x) < 1e-3 * 6);

  auto threads = struck(Frame{}, sheet_of_both, in<double>, OpenMP{.threads = 2});
  threads.until(end);
  CHECK(positions(threads) == x);

  write_vtu(folder / "film", plain);
  static_assert(strike::detail::VtuCells::kind(3, false) == 5);  // VTK_TRIANGLE
  const auto& triangles = plain.part<1>();
  const auto strain = triangles.field([](const auto& point) { return point.equivalent_plastic_strain; });
  CHECK(strain.size() == sheet_of_both.triangles.size());
  CHECK(*std::max_element(strain.begin(), strain.end()) > 0.01);
  CHECK(triangles.deleted() > 0);
}

TEST_CASE("triangles beside quadrilaterals: with parts in steps of their own, or at the step of the whole mesh") {
  Mesh mesh = sheet_of_both;
  const auto run_of = [&](const auto&... policies) {
    Explicit run{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals},
                       Part{Plate3{}, section, mesh.triangles}, Struck{}},
                 ExplicitOptions{}, policies...};
    run.until(end);
    CHECK(std::abs(run.energy().error()) < 5e-3);
    return std::pair{positions(run), run.steps()};
  };
  const auto [plain, steps] = run_of();
  CHECK(difference(run_of(Subcycling{}).first, plain) < 0.02 * 6);
  const auto [global, fewer] = run_of(GlobalStep{});
  CHECK(difference(global, plain) < 0.02 * 6);
  CHECK(fewer < steps);
}

TEST_CASE("triangles: half a sheet at a plane of symmetry moves as the whole one") {
  // Its triangles are mirror images, so their diagonals are too.
  const Mesh half = triangulated(rectangle({.size = {3, 2}, .cells = {3, 2}}));
  Mesh whole = half;
  append(whole, mirrored(half, unit(Axis::x)));
  whole = merge_coincident_nodes(whole, 1e-9);
  const auto pressed = [&](const Mesh& mesh, const auto&... supports) {
    Explicit run{Scene{mesh.nodes, Part{Plate3{}, section, mesh.triangles}, Pressure{surface(mesh), Constant{0.02}},
                       Clamped{nodes_where(mesh.nodes, on_plane(Axis::y, 0))}, supports...}};
    run.until(2);
    return run.positions();
  };
  const Points expected = pressed(whole);
  const Points found = pressed(half, Symmetry{Axis::x, nodes_where(half.nodes, on_plane(Axis::x, 0))});
  CHECK(difference(found, expected) < 1e-12);
  CHECK(difference(found, half.nodes) > 0.01);
}

TEST_CASE("triangles: a block bounces off a free sheet of them, whichever side they show it") {
  Mesh sheet = triangulated(rectangle({.lower = {-1.5, -1.5, 0}, .size = {3, 3}, .cells = {6, 6}}));
  Mesh block = translated(box({.size = {1, 1, 1}, .cells = {2, 2, 2}}), {-0.53, -0.47, 0.2});
  const Index first = append(sheet, block);
  const auto bounced = [&](const Mesh& mesh) {
    const Elastic soft{1, 10, 0.3};
    std::vector<Index> falling;
    for (Index i = first; i < mesh.nodes.size(); ++i) falling.push_back(i);
    Explicit run{Scene{mesh.nodes, Part{Plate3{}, Homogeneous{PlaneStress{soft}, 0.2}, mesh.triangles},
                       Part{Hex8{}, soft, mesh.hexahedra}, InitialVelocity{{0, 0, -0.3}, falling},
                       Contact{Everything{}}}};
    const auto momentum = [&] {
      double sum = 0;
      for (Index i = 0; i < mesh.nodes.size(); ++i) sum += run.nodes().mass(i) * run.nodes().v(i).z();
      return sum;
    };
    const double before = momentum();
    run.until(3);
    CHECK(momentum() == Approx(before).epsilon(1e-12));
    CHECK(std::abs(run.energy().error()) < 0.01);
    double block_speed = 0;
    for (const Index i : falling) block_speed += run.nodes().v(i).z() / double(falling.size());
    CHECK(block_speed > -0.3 * 0.9);
    return run.positions();
  };
  const Points x = bounced(sheet);
  for (auto& t : sheet.triangles) std::swap(t[1], t[2]);
  CHECK(difference(bounced(sheet), x) < 1e-9);
}

TEST_CASE("triangles: a cell that is flat, and plates far thicker than their edges, are told at the start") {
  Mesh mesh{.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 3}, {0, 1, 2}}};
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, Part{Plate3{}, section, mesh.triangles}}}),
                    ContainsSubstring("strike: element 1 of part 0") && ContainsSubstring("is flat at corner"));
  mesh.triangles[1] = {1, 2, 3};
  const Homogeneous thick{PlaneStress{metal}, 3};
  const Explicit run{Scene{mesh.nodes, Part{Plate3{}, thick, mesh.triangles}}};
  REQUIRE(run.warnings().size() == 1);
  CHECK_THAT(run.warnings()[0],
             ContainsSubstring("2 of 2 plates of part 0 are thicker than twice their shortest edge"));
}
