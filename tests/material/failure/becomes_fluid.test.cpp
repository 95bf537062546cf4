#include <strike/material/eos/cubic.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("what has become a fluid carries the pressure of its equation of state alone, and no tension") {
  const CubicEos eos{.density = 1, .C1 = 1, .C2 = 2, .C3 = 3};
  const Solid bird{eos, VonMises{.shear_modulus = 0.5, .yield_stress = 1}, BecomesFluid{UltimateStress{0.01}}};
  decltype(bird)::State<double> state;
  bird.begin(state);
  SymmetricTensor<double> shear{};
  shear.xy = 1;
  CHECK(bird.stress(state, {shear, 1.0}, 1e-3).xy == Approx(1e-3));  // 2 G D
  CHECK(state.solid == 1);
  CHECK(bird.stress(state, {shear, 1.0}, 1e-1).xy == 0);
  CHECK(state.solid == 0);
  for (const double J : {0.9, 1.1, 0.8}) {
    const auto sigma = bird.stress(state, {shear, J}, 1e-3);
    const double p = std::max(0.0, eos.A(1 / J - 1));
    CHECK((sigma.matrix() + p * Eigen::Matrix3d::Identity()).norm() <= 1e-15);
  }
  static_assert(sizeof(decltype(bird)::State<double>) == 8 * sizeof(double));
}
