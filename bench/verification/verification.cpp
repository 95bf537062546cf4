// The verification problems that take longer than a test may: each prints a row of docs/verification.md.
//
//   build/bench/bench/verification                 all, some quarter of an hour on one core
//   build/bench/bench/verification taylor          only those whose name contains a word
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <utility>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/hex8_full.hpp>

#include "problems/free_cubes.hpp"
#include "problems/hertz.hpp"
#include "problems/revolutions.hpp"
#include "problems/taylor_bar.hpp"
#include "problems/taylor_tetrahedra.hpp"
#include "problems/water_bird.hpp"
#include "row.hpp"

using namespace strike;
using namespace verification;

namespace {

/// The bar after 80 us.
template <class Run>
void report_bar(const char* name, Run& run, const Band& L, const Band& R, const Band& strain) {
  double drift = 0;
  const std::clock_t begin = std::clock();
  run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  row(name, "length", L, taylor::length(run), "mm");
  row(name, "radius of the foot", R, taylor::radius(run), "mm");
  row(name, "largest plastic strain", strain, taylor::plastic_strain(run), "");
  row(name, "error of the balance", {0, 0.1}, 100 * drift, "%");
  row(name, "hourglass energy", {0, 2}, 100 * run.energy().hourglass / run.energy().initial, "% of the first");
  double lift = std::numeric_limits<double>::infinity();
  for (const auto& x : run.positions())
    if (std::hypot(x.x(), x.y()) < 1e-6) lift = std::min(lift, x.z());
  std::printf("<!-- %s: %zu steps, %.1f s, the middle of the foot at z = %.3f mm -->\n", name, run.steps(), seconds,
              lift);
}

/// With a wall that can push only: no node is held on it.
auto bar_on_unilateral_wall(Index cells, Index layers) {
  const Mesh mesh = cylinder({.radius = 3.2, .length = 32.4, .cells = cells, .layers = layers});
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  return Explicit{Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, taylor::copper(taylor::mm_ms_kg), mesh.hexahedra},
                        InitialVelocity{{0, 0, -227}}, Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)},
                        RigidWall{{0, 0, 0}, {0, 0, 1}}}};
}

void incompressible_cubes(const char* name) {
  auto run = free_cubes::cubes();
  row(name, "error of the balance after 1e5 steps", {0, 1e-3}, free_cubes::drift(run, 100000), "");
  std::printf("<!-- %s: stable step %.4f h/c, kinetic energy %.3g of the first -->\n", name,
              run.stable_step().dt * free_cubes::wave_speed() / free_cubes::h,
              run.energy().kinetic / run.energy().initial);
}

/// A ball on a rigid plane against Hertz, with so many elements to an octant's edge.
template <class... Policies>
void ball_on_plane(const char* name, Index cells, double grading, const Policies&... policies) {
  const hertz::Impact impact = hertz::strike_plane(cells, grading, policies...);
  row(name, "force", {1, 0.02}, impact.force, "of Hertz'");
  row(name, "time of contact", {1, 0.02}, impact.time, "of Hertz'");
  row(name, "approach", {1, 0.02}, impact.approach, "of Hertz'");
  row(name, "speed of rebound", {1, 0.01}, impact.rebound, "of the first");
  std::printf("<!-- %s: %zu steps, the contact has kept %.2g of the energy -->\n", name, impact.steps, impact.lost);
}

/// 1e4 revolutions by 0.01 a step.
template <class E>
void many_revolutions(const char* name, const E& element) {
  const auto norm_after = [&](double stretch) {
    return revolutions::norm(revolutions::spin(element, stretch, 10000, 628)) / revolutions::E;
  };
  row(name, "strain from nothing", {0, 1e-9 * std::sqrt(6.28e6)}, norm_after(0), "");
  row(name, "change of a stress of 0.01 E", {0, 1e-6}, norm_after(0.01) / 0.01 - 1, "of it");
}

/// How far it gets, and by what steps.
void bird(const char* name, double share) {
  auto run = water_bird::on_plate(Tet4{NodalPressure{share}}, 4);
  const double first = run.stable_step().dt;
  double least = first;
  try {
    run.until(1.1, [&] { least = std::min(least, run.stable_step().dt); });
  } catch (const Error& error) {
    std::printf("<!-- %s: %s -->\n", name, error.what());
  }
  row(name, "end", unknown, run.time(), "ms");
  row(name, "least step", unknown, least / first, "of the first");
}

}  // namespace

int main(int count, char** arguments) {
  wanted() = count > 1 ? arguments[1] : "";
  std::printf("| problem | quantity | reference | tolerance | ours | unit | within |\n|---|---|--:|--:|--:|---|---|\n");
  const auto usual = [](const char* name, Index cells, const Band& L, const Band& R, const Band& strain) {
    if (!is_wanted(name)) return;
    auto run = taylor::bar(taylor::mm_ms_kg, cells, 50 * cells / 3, in<Pack<double>>);
    report_bar(name, run, L, R, strain);
  };
  const auto full = [](const char* name, Index cells) {
    if (!is_wanted(name)) return;
    auto run = taylor::bar(taylor::mm_ms_kg, cells, 50 * cells / 3, in<Pack<double>>, Hex8Full{});
    report_bar(name, run, unknown, unknown, unknown);
  };
  usual("taylor 3x50", 3, {21.47, 0.08}, {7.08, 0.08}, {2.92, 0.12});
  if (is_wanted("taylor 3x50 unilateral")) {
    auto run = bar_on_unilateral_wall(3, 50);
    report_bar("taylor 3x50 unilateral", run, unknown, unknown, unknown);
  }
  full("taylor 3x50, fully integrated", 3);
  usual("taylor 6x100", 6, {21.45, 0.03}, {7.18, 0.03}, {3.19, 0.06});
  full("taylor 6x100, fully integrated", 6);
  usual("taylor 9x150", 9, {21.434, 0.02}, {7.19, 0.02}, unknown);
  const auto tetrahedra = [](const char* name, const auto& element, Index cells, Index layers, const Band& R) {
    if (!is_wanted(name)) return;
    auto run = taylor::bar_of_tetrahedra(element, cells, layers);
    report_bar(name, run, unknown, R, unknown);
  };
  for (const auto& [name, layers] : {std::pair{"taylor tetrahedra 3x36", 36}, {"taylor tetrahedra 3x50", 50}}) {
    const auto on_mesh = [&, name = name, layers = static_cast<Index>(layers)](const char* pressure,
                                                                               const auto& element, const Band& R) {
      tetrahedra(strike::detail::joined({name, ", ", pressure}).c_str(), element, 3, layers, R);
    };
    on_mesh("own pressure", Tet4{ElementPressure{}}, {4.8, 0.7});
    on_mesh("of nodes", Tet4{NodalPressure{1.0}}, {7.1, 0.1});
    on_mesh("blend", Tet4{NodalPressure{0.9}}, unknown);
  }
  if (is_wanted("D7 pressure of nodes")) bird("D7 pressure of nodes", 1.0);
  if (is_wanted("D7 blend")) bird("D7 blend", 0.9);
  if (is_wanted("D8 Hex8")) many_revolutions("D8 Hex8", Hex8{ViscousHourglass{}});
  if (is_wanted("D2 undamped")) incompressible_cubes("D2 undamped");
  if (is_wanted("Hertz 12")) ball_on_plane("Hertz 12", 12, 20);
  if (is_wanted("Hertz 18")) ball_on_plane("Hertz 18", 18, 40);
  if (is_wanted("Hertz 18 penalty")) ball_on_plane("Hertz 18 penalty", 18, 40, Penalty{});
  plates();
  particles();
}
