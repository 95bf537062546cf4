// D17: layers 1e6 times softer, and one of no modulus at all.
#include <cmath>

#include <strike/material/plane_stress.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using namespace strike::verify;
using namespace strike::testing;

namespace {

const PlaneStress pane{Elastic{.density = 2500e-12, .youngs_modulus = 70000, .poissons_ratio = .22}};

/// Elastic in volume and as soft as wished in shear: E = 9 K G/(3 K + G).
auto jelly(double shear_modulus) {
  return PlaneStress{Solid{LinearEos{.density = 1070e-12, .bulk_modulus = 100}, ElasticStrength{shear_modulus}}};
}
template <class... Options>
auto sandwich(double shear_modulus, const Options&... options) {
  return Layered{Layer{pane, 3.0}, Layer{jelly(shear_modulus), .76}, Layer{pane, 3.0}, options...};
}

}  // namespace

TEST_CASE("D17: K is positive and finite down to a layer of no modulus, and falls with it") {
  double last = 1e99;
  for (const double G : {24e3, 24., 24e-3, 24e-6, 1e-7}) {
    const double K = sandwich(G).shear_stiffness();
    CHECK(K > 0);
    CHECK(K < last);
    last = K;
  }
  for (const double G : {1e-12, 1e-300, 0.0}) {
    CAPTURE(G);
    const auto section = sandwich(G);
    CHECK(section.shear_stiffness() > 0);
    CHECK(section.shear_stiffness() <= last);
    CHECK(std::isfinite(section.transverse_shear().own_bending));
    const auto check = [&](auto number) {
      using T = decltype(number);
      typename decltype(section)::template State<T> state{};
      const auto s =
          section.stress(state, {{T(1e-4), T(0.0), T(0.0)}, {T(1e-4), T(0.0), T(0.0)}, {T(1e-4), T(0.0)}}, 1);
      for (const T& x : {s.force.xx, s.moment.xx, s.shear(0), s.normal_rate}) CHECK(std::isfinite(lane(x, 0)));
      CHECK(lane(s.shear(0), 0) > 0);
    };
    check(double{});
    check(Pack<float, 16>{});

    // What is left are two panes, each for itself.
    const auto cured = sandwich(G, EffectiveShear{.length = 300});
    const double p = glass.p(), Q = 70000 / (1 - .22 * .22);
    CHECK(MindlinPlate{cured.transverse_shear().bending, cured.shear_stiffness()}.deflection(p) ==
          Approx(1 / (std::pow(p, 4) * 2 * Q * 27 / 12)).epsilon(1e-6));
  }
}

TEST_CASE("D17: what bounds the step does not rise with a soft layer") {
  const auto bounds = [](double G) {
    const auto section = sandwich(G);
    decltype(section)::State<double> state{};
    const auto m = section.moduli(state, {});
    return std::array{m.wave() / section.density(), m.bending.wave() / section.rotary_inertia(),
                      m.transverse_shear / section.density()};
  };
  const auto stiff = bounds(70000 / 2.44), soft = bounds(0.024), none = bounds(0);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(soft[i] <= stiff[i]);
    CHECK(none[i] <= soft[i]);
    CHECK(none[i] > 0);
  }
}
