// D30: three points of Simpson carry two thirds of the fully plastic moment.
#include <cmath>
#include <type_traits>

#include <strike/material/plane_stress.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

const PlaneStress metal{
    Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9}, VonMises{.shear_modulus = 27e9, .yield_stress = 300e6}}};

/// After bending into a cylinder far beyond yield, in units of the exact one.
template <class R>
double plastic_moment() {
  const Homogeneous section{metal, 1.0, R{}};
  typename decltype(section)::template State<double> state{};
  double moment = 0;
  for (int i = 0; i < 2000; ++i) moment = section.stress(state, {{}, {1e-3, 0, 0}, {0, 0}}, 1).moment.xx;
  return moment / (2 / std::sqrt(3.) * 0.25 * 300e6);
}

}  // namespace

TEST_CASE("D30: Simpson's three points reach 0.6667 of the plastic moment, the default all of it") {
  CHECK(plastic_moment<Simpson<3>>() == Approx(2. / 3).epsilon(1e-3));
  CHECK(plastic_moment<Simpson<5>>() == Approx(1).epsilon(1e-3));
  CHECK(std::is_same_v<decltype(Layer{metal, 1.0})::Rule, Simpson<5>>);
  CHECK(
      std::is_same_v<decltype(Homogeneous{metal, 1.0}), Homogeneous<std::remove_const_t<decltype(metal)>, Simpson<5>>>);
}
