// A charge beside faces: the pressure's history, its angle, and laws of a whole scene under it.
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/air_blast.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/section/layered.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A unit square around the origin, which looks along z.
const std::vector<Eigen::Vector3d> square{{-.5, -.5, 0}, {.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 0}};
const std::vector<Face> face{{{0, 1, 2, 3}, 0}};

/// The force on a square of area 1, over the area: along its normal, and its largest component in the plane.
struct Felt {
  double pressure, along;
};
Felt felt(AirBlast blast, double time) {
  Nodes<double> nodes(square, {0, 1, 2, 3});
  blast.begin(nodes);
  blast.apply_loads(nodes, time);
  const Eigen::Vector3d sum = nodes.f(0) + nodes.f(1) + nodes.f(2) + nodes.f(3);
  return {-sum.z(), std::max(std::abs(sum.x()), std::abs(sum.y()))};
}
/// A charge at a range in the direction that makes an angle with the normal of the square.
Charge at(double range, double angle, Burst burst = Burst::free_air) {
  return {.mass = 2, .centre = range * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)), .burst = burst};
}
constexpr double degree = 3.14159265358979323846 / 180;

}  // namespace

TEST_CASE("air blast: the impulse of its history on a wall across its way is the reflected impulse of the table") {
  for (const Burst burst : {Burst::free_air, Burst::surface})
    for (const double range : {0.25, 0.8, 2.0, 10.0, 45.0}) {
      Charge charge = at(range, 0, burst);
      charge.start = 0.003, charge.suction = false;
      const BlastWave wave = charge.wave(range);
      const double begins = charge.start + wave.arrival;
      const AirBlast blast{face, charge};
      CHECK(felt(blast, begins - 1e-9).pressure == 0);
      CHECK(felt(blast, begins + 1e-3 * wave.duration * 1e-6).pressure ==
            Approx(wave.reflected_pressure).epsilon(1e-6));
      CHECK(felt(blast, begins + 1.001 * wave.duration).pressure == 0);
      const int n = 1000;  // the midpoint rule: a^2/(24 n^2), a < 20
      double impulse = 0;
      for (int i = 0; i < n; ++i)
        impulse += felt(blast, begins + (i + 0.5) / n * wave.duration).pressure * wave.duration / n;
      CHECK(impulse == Approx(wave.reflected_impulse).epsilon(2e-5));
    }
}

TEST_CASE("air blast: the angle of incidence turns the reflected history into the incident one") {
  const double range = 3;
  const BlastWave wave = at(range, 0).wave(range);
  const auto share_at = [&](double angle) {
    const Felt now = felt(AirBlast{face, at(range, angle * degree)}, wave.arrival * (1 + 1e-12));
    CHECK(now.along < 1e-9 * wave.reflected_pressure);  // the air slides along a wall
    return now.pressure / wave.incident_pressure;
  };
  const double reflected = wave.reflected_pressure / wave.incident_pressure;
  CHECK(share_at(0) == Approx(reflected).epsilon(1e-9));
  for (const double angle : {20.0, 45.0, 60.0, 75.0, 89.0}) {
    const double c = std::cos(angle * degree);
    CHECK(share_at(angle) == Approx(reflected * c * c + 1 + c - 2 * c * c).epsilon(1e-9));
  }
  CHECK(share_at(90.0001) == Approx(1).epsilon(1e-9));
  CHECK(share_at(135) == Approx(1).epsilon(1e-9));  // from behind
  CHECK(share_at(180) == Approx(1).epsilon(1e-9));
  for (double angle = 1; angle < 90; angle += 1) {  // less than the incident pressure is nowhere
    CHECK(share_at(angle) >= 1);
    CHECK(share_at(angle) < share_at(angle - 1));
  }
}

TEST_CASE("air blast: after the positive phase it sucks, at most as a vacuum does, unless told not to") {
  const double range = 0.6;
  Charge charge = at(range, 0);
  const BlastWave wave = charge.wave(range);
  const double later = wave.arrival + 1.2 * wave.duration;
  const double s = 1.2, p = wave.reflected_pressure * (1 - s) * std::exp(-wave.reflected_decay * s);
  REQUIRE(p < 0);
  CHECK(felt(AirBlast{face, charge}, later).pressure == Approx(std::max(p, -101325.0)).epsilon(1e-12));
  charge.mass = 1e4, charge.centre.z() = 4;  // strong enough
  const BlastWave strong = charge.wave(4);
  double least = 0;
  for (double t = 1; t < 3; t += 0.01)
    least = std::min(least, felt(AirBlast{face, charge}, strong.arrival + t * strong.duration).pressure);
  CHECK(least == -101325);
  charge.suction = false;
  CHECK(felt(AirBlast{face, charge}, strong.arrival + 1.1 * strong.duration).pressure == 0);
  charge.end = strong.arrival + 0.5 * strong.duration;
  CHECK(felt(AirBlast{face, charge}, strong.arrival + 0.4 * strong.duration).pressure > 0);
  CHECK(felt(AirBlast{face, charge}, charge.end).pressure == 0);
}

TEST_CASE("air blast: the first corner of a face is any, and a triangle is one whose last corner is twice there") {
  const Charge charge = at(2, 30 * degree);
  const double time = charge.wave(2).arrival * 1.1;
  const Felt one = felt(AirBlast{face, charge}, time);
  for (const std::array<Index, 4>& corners :
       {std::array<Index, 4>{1, 2, 3, 0}, std::array<Index, 4>{2, 3, 0, 1}, std::array<Index, 4>{3, 0, 1, 2}})
    CHECK(felt(AirBlast{{{corners, 0}}, charge}, time).pressure == Approx(one.pressure).epsilon(1e-14));
  const Eigen::Vector3d middle = (square[0] + square[1] + square[2]) / 3;
  Charge beside = charge;
  beside.centre = middle + Eigen::Vector3d(0, 0, 2);
  const Felt triangle = felt(AirBlast{{{{0, 1, 2, 2}, 0}}, beside}, time);
  CHECK(triangle.pressure == Approx(0.5 * felt(AirBlast{face, at(2, 0)}, time).pressure).epsilon(1e-12));
}

TEST_CASE("air blast: forces have the derivatives of dual numbers by where the nodes are now") {
  using D = Dual<double, 1>;
  const Charge charge = at(2, 50 * degree);
  const double time = charge.wave(2).arrival * 1.2;
  const auto force = [&]<class Real>(const Real& moved) {
    Nodes<Real> nodes(square, {0, 1, 2, 3});
    AirBlast blast{face, charge};
    blast.begin(nodes);
    const Vector3<Real> before = nodes.x(1);
    nodes.set_position(1, Vector3<Real>(before.x(), before.y(), before.z() + moved));
    blast.apply_loads(nodes, time);
    return Real(nodes.f(2).z());
  };
  const double h = 1e-5;
  const D f = force(D::variable(0.0, 0));
  CHECK(f.derivative(0) == Approx((force(h) - force(-h)) / (2 * h)).epsilon(1e-7));  // h^2 times third derivatives of 1
}

TEST_CASE("air blast: what is wrong is told with the face, and faces that all look away are warned of") {
  Nodes<double> nodes(square, {0, 1, 2, 3});
  AirBlast near{face, at(0.1, 0)}, far{face, at(60, 0)}, nowhere{{{{0, 1, 2, 9}, 0}}, at(2, 0)};
  CHECK_THROWS_WITH(near.begin(nodes), ContainsSubstring("strike: face 0 of AirBlast: a range of 0.1 from 2 of TNT"));
  CHECK_THROWS_WITH(far.begin(nodes), ContainsSubstring("hold from 0.147 to 40"));
  CHECK_THROWS_WITH(nowhere.begin(nodes), ContainsSubstring("names node 9, but there are 4 nodes"));
  AirBlast behind{face, at(2, 180 * degree)}, before{face, at(2, 0)}, none{{}, at(2, 0)};
  behind.begin(nodes), before.begin(nodes), none.begin(nodes);
  CHECK_THAT(behind.warning(), ContainsSubstring("AirBlast: no face looks to the charge"));
  CHECK(before.warning().empty());
  CHECK(none.warning().empty());
}

TEST_CASE("air blast: steps resolve the wave until it has passed, and not longer") {
  Nodes<double> nodes(square, {0, 1, 2, 3});
  AirBlast blast{face, at(2, 0)};
  const BlastWave wave = at(2, 0).wave(2);
  blast.begin(nodes);
  CHECK(blast.stable_step(1) == Approx(wave.reflected_impulse / wave.reflected_pressure / 50));
  CHECK(blast.stable_step(1e-9) == 1e-9);
  blast.apply_loads(nodes, wave.arrival + 0.9 * wave.duration);
  CHECK(blast.stable_step(1) < 1e-3);
  blast.apply_loads(nodes, wave.arrival + 1.1 * wave.duration);
  CHECK(blast.stable_step(1) == 1);
}

namespace {

constexpr double half = 0.2, thickness = 0.008;
const Elastic steel{.density = 7850, .youngs_modulus = 210e9, .poissons_ratio = 0.3};
/// Above the middle of a plate over [0, 2 half]^2.
const Charge over{.mass = 0.05, .centre = {half, half, 0.5}, .start = -2.8e-4, .burst = Burst::surface};

std::vector<Face> faces_of(const Mesh& mesh) { return quadrilateral_surface(mesh.quadrilaterals); }
const std::vector<Eigen::Vector3d> all_axes{unit(Axis::x), unit(Axis::y), unit(Axis::z)};
template <class F>
Support clamped(const Mesh& mesh, const F& where) {
  return Support{nodes_where(mesh.nodes, where), all_axes, all_axes};
}
bool on_rim(const Eigen::Vector3d& x) { return std::min({x.x(), x.y(), 2 * half - x.x(), 2 * half - x.y()}) < 1e-9; }

/// One type of scene for all tests, which costs the compiler most.
auto plate(const Mesh& mesh, const Charge& charge, const std::vector<Support>& held, const Elastic& law, double h,
           const auto&... method) {
  return Explicit{Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{law}, h}, mesh.quadrilaterals},
                        AirBlast{faces_of(mesh), charge}, held},
                  method...};
}

}  // namespace

TEST_CASE("air blast: momentum and work of free plates are those of the impulse, and balance") {
  const Mesh mesh = rectangle({.size = {2 * half, 2 * half}, .cells = {2, 2}});
  Charge charge = over;
  charge.suction = false;
  auto run = plate(mesh, charge, {}, steel, thickness);
  run.until(0.9e-3);
  double impulse = 0;  // of each face by the histories' closed integrals
  for (const Face& one : faces_of(mesh)) {
    const Eigen::Vector3d way = charge.centre - centroid(mesh.nodes, one);
    const BlastWave wave = charge.wave(way.norm());
    REQUIRE(charge.start + wave.arrival + wave.duration < 0.9e-3);
    const double c = way.z() / way.norm(), area = area_vector(mesh.nodes, one).z();
    impulse += area * (wave.reflected_impulse * c * c + wave.incident_impulse * (1 + c - 2 * c * c));
  }
  // Steps of a 1/50 of i_r/p_r or less: the arrival falls anywhere in one, 1 %; and the plate turns a little.
  CHECK(run.momentum().z() == Approx(-impulse).epsilon(0.01));
  CHECK(run.momentum().head<2>().norm() < 1e-3 * impulse);
  const double mass = steel.density * thickness * 4 * half * half;
  CHECK(run.energy().external >= impulse * impulse / (2 * mass) * 0.98);
  CHECK(std::abs(run.energy().error()) < 1e-3);
}

TEST_CASE("air blast: a quarter of a symmetric plate takes a quarter of the impulse and sinks as the whole") {
  const auto sink = [](const Mesh& mesh, const std::vector<Support>& held) {
    auto run = plate(mesh, over, held, steel, thickness);
    run.until(3e-4);
    return std::pair{run.nodes().x(nearest_node(mesh.nodes, {half, half, 0})).z(), run.energy().external};
  };
  const Mesh whole = rectangle({.size = {2 * half, 2 * half}, .cells = {4, 4}});
  const auto [z, work] = sink(whole, {clamped(whole, on_rim)});
  const Mesh corner = translated(rectangle({.size = {half, half}, .cells = {2, 2}}), {half, half, 0});
  const auto on = [&](Axis axis) { return nodes_where(corner.nodes, on_plane(axis, half)); };
  const auto [z_quarter, work_quarter] =
      sink(corner, {clamped(corner, on_rim), Support{on(Axis::x), {unit(Axis::x)}, {unit(Axis::y), unit(Axis::z)}},
                    Support{on(Axis::y), {unit(Axis::y)}, {unit(Axis::x), unit(Axis::z)}}});
  CHECK(z < -1e-4);
  CHECK(z_quarter == Approx(z).epsilon(1e-9));
  CHECK(4 * work_quarter == Approx(work).epsilon(1e-9));
}

TEST_CASE("air blast: turned scenes, other units, threads, mixed lanes, a checkpoint and another charge") {
  const Mesh mesh = rectangle({.size = {2 * half, 2 * half}, .cells = {4, 4}});
  const std::vector<Support> held{clamped(mesh, on_rim)};
  constexpr double end = 1.5e-4;
  constexpr Index centre = 12;
  auto run = plate(mesh, over, held, steel, thickness);
  run.until(end);
  const double z = run.nodes().x(centre).z();
  REQUIRE(z < -1e-5);

  const Eigen::Vector3d axis(1, 2, 3);
  Charge turned_charge = over;
  turned_charge.centre = rotated(Mesh{.nodes = {over.centre}}, axis, 0.7).nodes[0];
  auto turned = plate(rotated(mesh, axis, 0.7), turned_charge, held, steel, thickness);
  turned.until(end);
  const Eigen::Vector3d back = rotated(Mesh{.nodes = {turned.nodes().x(centre)}}, axis, -0.7).nodes[0];
  CHECK(back.z() == Approx(z).epsilon(1e-9));

  Charge deck = over;  // tonnes, mm, s, MPa
  deck.mass *= 1e-3, deck.centre *= 1e3;
  deck.units = {.mass = 1e3, .length = 1e-3, .time = 1, .pressure = 1e6};
  Mesh millimetres = mesh;
  for (Eigen::Vector3d& x : millimetres.nodes) x *= 1e3;
  auto other = plate(millimetres, deck, held, {.density = 7.85e-9, .youngs_modulus = 210e3, .poissons_ratio = 0.3},
                     1e3 * thickness);
  other.until(end);
  CHECK(other.nodes().x(centre).z() == Approx(1e3 * z).epsilon(1e-9));

  auto parallel = plate(mesh, over, held, steel, thickness, OpenMP{2});
  parallel.until(end);
  CHECK(parallel.positions() == run.positions());
  auto mixed = plate(mesh, over, held, steel, thickness, in<Pack<float>, double>);
  mixed.until(end);
  CHECK(mixed.nodes().x(centre).z() == Approx(z).epsilon(1e-3));  // seven digits of 0.4, z above 1e-5

  const ScratchFolder folder("air_blast");
  auto first = plate(mesh, over, held, steel, thickness);
  first.until(end / 2);
  write_checkpoint(folder / "a", first);
  auto second = plate(mesh, over, held, steel, thickness);
  read_checkpoint(folder / "a", second);
  second.until(end);
  first.until(end);
  CHECK(second.positions() == first.positions());
  Charge heavier = over;
  heavier.mass *= 1.1;
  auto another = plate(mesh, heavier, held, steel, thickness);
  CHECK_THROWS_WITH(read_checkpoint(folder / "a", another), ContainsSubstring("is of another scene"));
}

namespace {

/// Deletes elements whose middle is beyond x = half once they have moved by a micrometre.
struct BeyondHalf {
  template <class State, class E, class M, class T, bool has_geometry>
  auto keeps(const State&, const ElementCondition<E, M, T, has_geometry>& element) const {
    T x = T(0.0), z = T(0.0);
    for (int i = 0; i < E::nodes; ++i)
      x += T(1.0 / E::nodes) * element.position(0, i), z += T(1.0 / E::nodes) * element.position(2, i);
    return T(x - half) < select(z < -1e-6, T(0.0), T(1e9));
  }
};

}  // namespace

TEST_CASE("air blast ends with its faces: nodes of plates that are gone fly on at their velocity") {
  const Mesh mesh = rectangle({.size = {2 * half, 2 * half}, .cells = {4, 4}});
  Explicit run{Scene{mesh.nodes,
                     Part{Plate4{}, Homogeneous{PlaneStress{steel}, thickness}, mesh.quadrilaterals, BeyondHalf{}},
                     AirBlast{faces_of(mesh), over}}};
  const BlastWave wave = over.wave(0.5);
  run.until(over.start + wave.arrival + 0.3 * wave.duration);
  REQUIRE(run.part<0>().deleted() == 8);
  const double far = run.nodes().v(14).z(), momentum = run.momentum().z();
  run.until(over.start + wave.arrival + 0.6 * wave.duration);
  CHECK(run.nodes().v(14).z() == far);
  CHECK(run.momentum().z() < momentum);  // of the others
  CHECK(std::abs(run.energy().error()) < 0.01);
}
