#include <strike/element/solid_point.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("the work at a point is that of the mean of the stresses before and after the step") {
  const Elastic material{.density = 1, .youngs_modulus = 2};
  Elastic::State<double> state;
  state.stress = {3, 0, 0, 0, 0, 0};
  const SolidKinematics::Rate<double> rate{{0.1, 0, 0, 0, 0, 0}, 1.0};
  const auto [stress, work] = advance_point(material, state, rate, 0.5, 7.0, 1.0);
  CHECK(stress.xx == Approx(3 + 2 * 0.1 * 0.5));
  CHECK(work == Approx(0.5 * 0.5 * 0.1 * (6 * 3 + 7 * stress.xx)));
}

TEST_CASE("a viscous stress, which is not remembered, dissipates in full") {
  const double eta = 3, rate = 0.2, dt = 0.5, V = 7;
  const Fluid oil{LinearEos{.density = 1, .bulk_modulus = 2}, Newtonian{eta}};
  decltype(oil)::State<double> state;
  oil.begin(state);
  for (int step = 0; step < 3; ++step) {
    const auto [stress, work] = advance_point(oil, state, {{0, 0, 0, rate, 0, 0}, 1.0}, dt, V, 0.0);
    CHECK(stress.xy == Approx(2 * eta * rate));
    CHECK(work == Approx(V * 4 * eta * rate * rate * dt));
  }
}

TEST_CASE("heat goes to materials that know their energy") {
  struct Cold {
  } cold;
  struct Warm {
    double internal_energy = 1;
  } warm;
  heat(cold, 2.0);
  heat(warm, 2.0);
  CHECK(warm.internal_energy == 3);
}

TEST_CASE("what cannot fail is intact, what has failed is silent") {
  const Elastic elastic{.density = 1, .youngs_modulus = 1};
  CHECK(intact_share<double>(elastic, Elastic::State<double>{}) == 1);
  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 1}, VonMises{.shear_modulus = 1, .yield_stress = 1},
                      UltimateStress{1}};
  decltype(brittle)::State<double> state;
  CHECK(intact_share<double>(brittle, state) == 1);
  state.intact = 0;
  CHECK(intact_share<double>(brittle, state) == 0);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  Response<double, 8> response{Nodal<double, 8>::Constant(nan), -1, nan, nan, nan, nan};
  zero_if_failed(false, response);
  CHECK(response.force.norm() == 0);
  CHECK(response.volume > 0);
  CHECK(response.critical_rate == 0);
  CHECK(response.internal_work + response.hourglass_work + response.bulk_viscosity_work == 0);

  using P = Pack<double, 4>;
  Response<P, 8> two{Nodal<P, 8>::Constant(P(5.0)), P(2.0), P(3.0), P(4.0), P(5.0), P(6.0)};
  P first(1.0);
  first.set(2, 0.0);
  zero_if_failed(first > 0.0, two);
  CHECK(two.force(7)[0] == 5);
  CHECK(two.force(7)[2] == 0);
  CHECK(two.critical_rate[1] == 3);
}
