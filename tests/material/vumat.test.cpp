#include <cmath>
#include <cstddef>
#include <string>

#include <strike/element/hex8.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/vumat.hpp>
#include <strike/verify/material_point.hpp>
#include <strike/verify/single_element.hpp>

#include "conformance/material.hpp"
#include "examples/vumat/copper_vumat.h"

using namespace strike;
using namespace strike::verify;
using Catch::Matchers::ContainsSubstring;

namespace {

const Solid native{LinearEos{.density = 8930, .bulk_modulus = 130e9},
                   VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
Vumat<1> copper(VumatRoutine<double>* routine = copper_vumat) {
  return Vumat<1>{{.routine = routine, .density = 8930, .properties = {8930, 130e9, 43.3e9, 400e6, 100e6}}};
}
/// What the elastic moduli make of a rounding error of the strain.
constexpr double rounding = 1e-16 * 188e9;

static_assert(SolidMaterial<Vumat<1>> && sizeof(Vumat<1>::State<double>) == 16 * sizeof(double));

}  // namespace

TEST_CASE("a VUMAT of the same law gives what the native law gives") {
  const Vumat<1> user = copper();
  Matrix3<double> L;
  L << 20, 300, -50, -100, -40, 80, 10, 200, 30;  // strains and turns by 0.3 in a thousand steps

  MaterialPoint point{user};
  MaterialPoint expected{native};
  for (int i = 0; i < 1000; ++i) {
    if (i == 500) L *= -1;
    point.step(L, 1e-6), expected.step(L, 1e-6);
  }
  CHECK(point.now().state.variable[0] == Approx(expected.now().state.equivalent_plastic_strain).epsilon(1e-12));
  CHECK((point.now().stress - expected.now().stress).matrix().norm() <= 1000 * rounding);
  CHECK(point.now().state.specific_internal_energy * 8930 == Approx(expected.now().work).epsilon(1e-6));

  // In an element that asks for no modulus but for its step: the native law's grows with the compression.
  const Hex8<NoHourglass, HughesWinget, NoBulkViscosity> element;
  SingleElement cube{element, user, unit_cube()};
  SingleElement expected_cube{element, native, unit_cube()};
  const auto crushed = motion::field([](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return {20 * x.z() * x.z(), 0, -100 * x.z() * (1 + 0.5 * x.x())};
  });
  const auto now = cube.run(crushed, 1e-5, 100).back(), then = expected_cube.run(crushed, 1e-5, 100).back();
  CHECK((now.force - then.force).norm() <= 1000 * rounding);
}

#ifdef STRIKE_TEST_FORTRAN
extern "C" VumatRoutine<double> copper_in_fortran_;

TEST_CASE("a VUMAT in Fortran gives what that in C gives") {
  MaterialPoint point{copper(copper_in_fortran_)};
  MaterialPoint expected{copper()};
  Matrix3<double> L;
  L << 20, 300, -50, -100, -40, 80, 10, 200, 30;
  for (int i = 0; i < 100; ++i) point.step(L, 1e-5), expected.step(L, 1e-5);
  CHECK(point.now().state.variable[0] > 0.01);
  CHECK((point.now().stress - expected.now().stress).matrix().norm() <= 100 * rounding);
  testing::lanes_agree<Pack<double, 4>>(copper(copper_in_fortran_), {});
}
#endif

TEST_CASE("a VUMAT obeys the laws of a material") {
  const testing::Drive drive;
  testing::rests(copper(), drive);
  testing::lanes_agree<Pack<double, 4>>(copper(), drive);
  testing::lanes_agree<Pack<float, 16>>(copper(), drive);
  testing::gives_no_energy(copper(), drive);
  testing::is_frame_indifferent(copper(), drive);
}

namespace {

/// Elastic along the axes of its frame, each with its own modulus, in single precision; notes what it is told.
struct Told {
  int nblock, nstatev, nprops;
  float step_time, dt, temperature, length, stretch;
  std::string name;
} told;

void fibres(const int* nblock, const int*, const int*, const int* nstatev, const int*, const int* nprops, const int*,
            const float* stepTime, const float*, const float* dt, const char* cmname, const float*,
            const float* charLength, const float* props, const float*, const float* strainInc, const float*,
            const float* tempOld, const float*, const float*, const float*, const float* stressOld,
            const float* stateOld, const float*, const float*, const float*, const float* stretchNew, const float*,
            const float*, float* stressNew, float* stateNew, float*, float*, std::size_t length) {
  told = {*nblock, *nstatev, *nprops, *stepTime, *dt, *tempOld, *charLength, *stretchNew, {cmname, length}};
  for (int k = 0; k < *nblock; ++k) {
    for (int c = 0; c < 6; ++c) {
      const int i = c * *nblock + k;
      stressNew[i] = stressOld[i] + props[c < 3 ? c : 3] * strainInc[i];
    }
    for (int c = 0; c < 3; ++c) stateNew[c * *nblock + k] = stateOld[c * *nblock + k] + strainInc[c * *nblock + k];
  }
}

}  // namespace

TEST_CASE("a VUMAT in single precision feels strains in a frame that turns with the material") {
  const Vumat<3, float> user{{.routine = fibres,
                              .density = 1,
                              .properties = {4, 1, 1, 1},
                              .initial_variables = {0, 0, 5},
                              .name = "FIBRES",
                              .axis_1 = {0, 1, 0},
                              .axis_2 = {0, 0, 1},
                              .temperature = 20,
                              .characteristic_length = 3}};
  MaterialPoint point{user};
  const double c = std::sqrt(2.0);  // couples the volume and the deviators, of the moduli 3 K = 2 and 2 G = 3 at most
  CHECK(point.moduli().wave() == Approx((2 + c) / 3 + 2 * (3 + c) / 3).epsilon(1e-4));

  const double quarter = std::acos(-1) / 2;  // a quarter about x brings the axis 1 from y to z
  Matrix3<double> spin = Matrix3<double>::Zero(), stretch = Matrix3<double>::Zero();
  spin(2, 1) = quarter, spin(1, 2) = -quarter, stretch(2, 2) = 1e-3;
  for (int i = 0; i < 100; ++i) point.step(spin, 0.01);
  point.step(stretch, 0.5);
  CHECK(point.now().stress.zz == Approx(4 * 0.5e-3).epsilon(1e-3));  // the turn of Hughes and Winget lacks 3e-5
  CHECK(std::abs(point.now().stress.yy) <= 1e-6);
  CHECK(point.now().state.variable[0] == Approx(0.5e-3).epsilon(1e-3));
  CHECK(point.now().state.variable[2] == 5);

  CHECK((told.nblock == 1 && told.nstatev == 3 && told.nprops == 4));
  CHECK((told.step_time == Approx(1.5) && told.dt == 0.5f && told.temperature == 20 && told.length == 3));
  CHECK(std::isnan(told.stretch));
  CHECK(told.name == "FIBRES" + std::string(74, ' '));
}

TEST_CASE("a VUMAT that answers nothing elastic is refused") {
  CHECK_THROWS_WITH((Vumat<1>{{.routine = nullptr, .density = 1}}), ContainsSubstring("has no routine"));
  CHECK_THROWS_WITH((Vumat<3, float>{{.routine = fibres, .density = 1, .properties = {0, 0, 0, 0}}}),
                    ContainsSubstring("gives the wave modulus K + 4/3 G = 0"));
}
