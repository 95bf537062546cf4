#include <strike/material/elastic.hpp>

#include "support/catch.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;

static_assert(SolidMaterial<Elastic>);

TEST_CASE("elastic: Hooke's law between the rates, with the moduli of E and nu") {
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = .3};
  CHECK(steel.shear_modulus() == Approx(76.923077e9).epsilon(1e-8));
  CHECK(steel.bulk_modulus() == Approx(166.666667e9).epsilon(1e-8));

  Elastic::State<double> state{{1e6, 2e6, 3e6, 4e6, 5e6, 6e6}};
  const Tensor D{1, -2, 3, .5, .25, -.125}, before = state.stress;
  const double dt = 1e-6, lambda = 200e9 * .3 / (1.3 * .4), G = 200e9 / 2.6;
  const Tensor after = steel.stress(state, {D, 1.0}, dt);
  const Matrix3<double> expected =
      before.matrix() + dt * (lambda * trace(D) * Matrix3<double>::Identity() + 2 * G * D.matrix());
  CHECK((after.matrix() - expected).norm() < 1e-9 * expected.norm());
  CHECK((steel.stress(state).matrix() - after.matrix()).norm() == 0);

  // uniaxial strain: M = lambda + 2 G = 2.692308e11, c_L = 5856.357
  const double M = steel.moduli(state, {D, 1.0}).wave();
  CHECK(M == Approx(2.692308e11).epsilon(1e-6));
  CHECK(std::sqrt(M / steel.density) == Approx(5856.357).epsilon(1e-6));
}

TEST_CASE("elastic: without Poisson's ratio the directions know nothing of each other") {
  const Elastic bar{.density = 1, .youngs_modulus = 7};
  Elastic::State<double> state;
  const Tensor sigma = bar.stress(state, {Tensor{.yy = 2}, 1.0}, 1.0);
  CHECK(sigma.yy == Approx(14).epsilon(1e-15));
  CHECK(std::abs(sigma.xx) < 1e-15);
}
