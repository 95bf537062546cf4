#include <cmath>
#include <string>
#include <vector>

#include <strike/element/hex8.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/verify/distortion.hpp>
#include <strike/verify/eigenmodes.hpp>
#include <strike/verify/patch_test.hpp>
#include <strike/verify/workbench.hpp>

#include "conformance/numbers.hpp"
#include "output/scratch.hpp"

using namespace strike;
using namespace strike::verify;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double K = 1, G = 0.4, rho = 2, Y = 4e-3, H = 0.1;
const Solid metal{LinearEos{.density = rho, .bulk_modulus = K},
                  VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}};

enum class Fault { none, hasty, cautious, stiff, anchored, lopsided, askew };

/// A hexahedron that can be wrong.
struct Faulty {
  using Kinematics = SolidKinematics;
  static constexpr int nodes = 8;
  using Sound = Hex8<StiffnessHourglass, HughesWinget, NoBulkViscosity>;
  template <class M, class T>
  using State = Sound::State<M, T>;

  Fault fault = Fault::none;
  Sound sound{};

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 8>& x) const {
    return sound.begin(state, material, x);
  }
  template <class M, class T>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                         double dt) const {
    Response<T, 8> response = sound.advance(state, material, x, v, dt);
    if (fault == Fault::hasty) response.critical_rate *= T(0.9);
    if (fault == Fault::cautious) {  // Flanagan and Belytschko 1981: dt <= V/(c sqrt(2 B:B))
      const Hex8Gradient<T> g(to_modes<T>(x));
      const T BB = T(1.0 / 512.0) * trace(g.squared_a() + g.squared_b());
      response.critical_rate = sqrt(2.0 * (K + 4. / 3 * G) / rho * BB) / g.volume;
    }
    if (fault == Fault::stiff) response.force *= T(1.05);
    if (fault == Fault::anchored) response.force += T(0.01) * x;
    if (fault == Fault::lopsided)
      for (int i = 0; i < 3; ++i) response.force(i, 0) *= T(1.01);
    if (fault == Fault::askew)
      for (int node = 0; node < 8; ++node) response.force(0, node) *= T(1.01);
    return response;
  }
};

const SweepOptions coarse{.aspects = {1, 10}, .steps = 4, .accuracy = 0.01};

}  // namespace

TEST_CASE("the modes of a one-point cube in closed form: 12 K, 8 G, and 24 kappa G over rho a^2") {
  const double a = 0.5, kappa = 0.02, unit = 1 / (rho * a * a);
  const SingleElement cube{Faulty{Fault::none, {StiffnessHourglass{kappa}}}, metal, Nodal<double, 8>(a * unit_cube())};
  const auto modes = eigenmodes(cube);
  REQUIRE(modes.size() == 24);
  for (std::size_t k = 0; k < 24; ++k) {
    const ModeKind kind = k < 6 ? ModeKind::rigid : k < 18 ? ModeKind::hourglass : ModeKind::straining;
    const double w2 = k < 6 ? 0 : k < 18 ? 24 * kappa * G * unit : k < 23 ? 8 * G * unit : 12 * K * unit;
    CHECK(modes[k].kind == kind);
    CHECK(modes[k].frequency == Approx(std::sqrt(w2)).epsilon(1e-9));
    CHECK(modes[k].shape.norm() == Approx(1));
    CHECK(modes[k].decay <= 1e-9 * modes[23].frequency);
  }
  CHECK(uniform_strain_error(cube) <= 1e-9);
  CHECK(modes[23].critical_step() == Approx(cube.vibration().critical_step()).epsilon(1e-9));

  // Of the viscous control every hourglass mode decays at 16 Q c/a.
  const SingleElement viscous{Hex8{ViscousHourglass{0.05}, HughesWinget{}, NoBulkViscosity{}}, metal,
                              Nodal<double, 8>(a * unit_cube())};
  const double c = std::sqrt((K + 4. / 3 * G) / rho);
  for (const Eigenmode& mode : eigenmodes(viscous))
    if (mode.kind == ModeKind::hourglass) {
      CHECK(mode.frequency == 0);
      CHECK(mode.decay == Approx(16 * 0.05 * c / a).epsilon(1e-9));
    }
}

TEST_CASE("the bound of Flanagan and Belytschko is safe and, on a cube, too small by sqrt(1 + 4 G/(3 K))") {
  const double expected = std::sqrt(1 + 4 * G / (3 * K));
  CHECK(step_study(SingleElement{Faulty{Fault::cautious}, metal, unit_cube()}).ratio() ==
        Approx(expected).epsilon(1e-6));
  CHECK(step_study(SingleElement{Faulty{}, metal, unit_cube()}).ratio() == Approx(1).epsilon(1e-3));  // ours is sharp
  CHECK(distortion_sweep(Faulty{Fault::cautious}, metal, unit_cube(), distortions::skew, coarse).least_ratio() >= 1);
}

TEST_CASE("distortions end where the shape does: a taper at a point, a dent at a third, a height at nothing") {
  const auto limit = [](const Distortion& distortion) {
    const auto sweep = distortion_sweep(Faulty{}, metal, unit_cube(), distortion, coarse);
    REQUIRE(sweep.limits.size() == 2);
    CHECK(sweep.limits[0].reason == sweep.limits[1].reason);
    CHECK(sweep.limits[0].amount == Approx(sweep.limits[1].amount).margin(1e-3));
    CHECK(sweep.least_ratio() >= 1 - 1e-9);
    return sweep.limits[0];
  };
  CHECK(limit(distortions::taper).amount == Approx(1).margin(2e-4));
  CHECK(limit(distortions::flatten).amount == Approx(1).margin(2e-4));
  // The corner (1, 1, 1) on the diagonal at 1 - 2 d: its neighbours' edges lie in a plane when it is in the plane
  // through three of them, x + y + z = 2.
  CHECK(limit(distortions::dent).amount == Approx(1. / 3).margin(2e-4));
  CHECK(limit(distortions::dent).reason == Soundness::inverted);
  CHECK(limit(distortions::skew).reason == Soundness::sound);
}

TEST_CASE("conformance: wrong numbers of sweeps are refused") {
  testing::WrongNumbers tried;
  testing::refuses_wrong_numbers(SweepOptions{.aspects = {1}, .steps = 2}, tried, [](const SweepOptions& options) {
    return distortion_sweep(Faulty{}, metal, unit_cube(), distortions::skew, options).least_ratio() > 0;
  });
  tried.print("sweeps");
}

TEST_CASE("every fault of an element is found by the study that looks for it, and by no sound element") {
  const auto rigid_frequency = [](Fault fault) {
    double highest = 0;
    for (const Eigenmode& mode : eigenmodes(SingleElement{Faulty{fault}, metal, unit_cube()}))
      if (mode.kind == ModeKind::rigid) highest = std::max(highest, mode.frequency);
    return highest;
  };
  const auto judge = [](Fault fault) {
    return judged(Faulty{fault}, metal, distorted(unit_cube(), distortions::skew, 2, 30), coarse).soundness;
  };
  CHECK(judge(Fault::none) == Soundness::sound);
  CHECK(judge(Fault::hasty) == Soundness::unstable);
  CHECK(judge(Fault::stiff) == Soundness::unstable);  // its forces are not those that its step knows
  CHECK(uniform_strain_error(SingleElement{Faulty{Fault::stiff}, metal, unit_cube()}) == Approx(0.05).epsilon(1e-6));
  CHECK(rigid_frequency(Fault::none) == 0);
  CHECK(rigid_frequency(Fault::anchored) == Approx(std::sqrt(0.01 * 8 / rho)).epsilon(1e-5));
  for (const Fault fault : {Fault::none, Fault::lopsided, Fault::anchored, Fault::askew}) {
    const bool balanced = fault == Fault::none || fault == Fault::askew;
    CHECK((patch_tests(Faulty{fault}, metal)[0].error() < 1e-9) == balanced);
    const RotationStudy rotation = rotation_study(Faulty{fault}, metal, unit_cube(), 0.1, 20);
    CHECK((rotation.unstrained < 1e-9) == (fault != Fault::anchored));
    CHECK((rotation.strained < 1e-9) == (fault != Fault::askew));
  }
}

TEST_CASE("the workbench tells a wrong formula and a wrong element in one sentence, and a sound one passes") {
  const ScratchFolder folder("workbench");
  const auto flow_stress = [](double hardening) {
    return [hardening](const auto& record) {
      const double e = record.state.equivalent_plastic_strain;
      return e > 0 ? Y + hardening * e : NAN;
    };
  };
  const Path pull = uniaxial_stress({.strain = 0.1, .steps = 10});
  Workbench good{folder / "good"};
  good.follow("tension", metal, pull, axial, flow_stress(H), 1e-9);
  good.follow(
      "squeeze", metal, hydrostatic({.strain = -0.1, .steps = 10}), volumetric,
      [](double volumetric_strain) { return K * std::expm1(-volumetric_strain); }, 1e-12);
  good.element("sound", Faulty{}, metal, unit_cube(), coarse);
  CHECK(good.failure().empty());
  CHECK(good.results().rows().size() == 14);
  for (const char* file : {"tension.csv", "tension.svg", "tension_error.svg", "sound_modes.svg", "sound_modes.csv",
                           "sound_skew.csv", "sound_skew.svg", "sound_envelope.svg"})
    CHECK(content_of(folder / (std::string("good/") + file)).size() > 40);

  Workbench bad{folder / "bad"};
  bad.follow("tension", metal, pull, axial, flow_stress(1.1 * H), 1e-3);
  bad.follow("too far", metal, {{Segment{.duration = 1, .stress = {.xx = 1e3, .yy = 0, .zz = 0}}}}, axial);
  bad.element("hasty", Faulty{Fault::hasty}, metal, unit_cube(), coarse);
  CHECK_THAT(bad.failure(), ContainsSubstring("strike: 8 of 14 expectations are not met, the first of them 'tension"));
  CHECK(bad.finish() == 1);
}
