#include <strike/element/hex8.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/fluid.hpp>

#include "conformance/element.hpp"
#include "element/nodal_hex8.hpp"

using namespace strike;
using namespace strike::verify;

TEST_CASE("Hex8 gives the forces of Flanagan and Belytschko: sigma B + a gamma (gamma . v)") {
  testing::Shapes<8> shapes(12);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodal<double, 8> x = shapes(), v = shapes.nodal();
    const SymmetricTensor<double> sigma = symmetric_part<double>(shapes.matrix());
    const Hex8 element{ViscousHourglass{0.1}, HughesWinget{}, NoBulkViscosity{}};
    const auto found = testing::detail::respond(element, testing::ConstantStress{sigma}, x, v, 0.1).force;

    const auto B = nodal_hex8::gradient(x);
    const auto gamma = nodal_hex8::hourglass_vectors(x);
    const double a = 0.1 * std::sqrt(1 + 4 * 0.5 / 3) * std::pow(nodal_hex8::volume(x), 2. / 3) / 4;
    const Nodal<double, 8> expected = sigma.matrix() * B + a * (v * gamma.transpose()) * gamma;
    CHECK((found - expected).norm() <= 1e-13 * (B.norm() + a * v.norm() * gamma.squaredNorm()));
  }
}

TEST_CASE("Hex8 takes the pressure of bulk viscosity with the length of its own step") {
  const double h = 0.5, rate = 0.1, modulus = 1 + 4 * 0.5 / 3, c = std::sqrt(modulus);
  for (const double thin : {1.0, 1e-3}) {
    const Nodal<double, 8> x = Eigen::Vector3d(h, h, thin * h).asDiagonal() * unit_cube();
    const Nodal<double, 8> v = -rate / 3 * x;
    const auto force = testing::detail::respond(Hex8{NoHourglass{}}, testing::ConstantStress{}, x, v, 1e-12).force;
    const double l = thin * h, q = l * rate * (1.5 * 1.5 * l * rate + 0.06 * c);
    const Nodal<double, 8> expected = -q * nodal_hex8::gradient(x);
    CHECK((force - expected).norm() <= 2e-3 * expected.norm());  // largest_eigenvalue is from above
  }
}

TEST_CASE("a cube of Hex8 vibrates in six modes, and in none of its twelve hourglass modes") {
  const double E = 2, nu = 0.3, rho = 3, h = 0.5, G = E / 2 / (1 + nu), K = E / 3 / (1 - 2 * nu);
  const SingleElement cube{Hex8{NoHourglass{}}, Elastic{rho, E, nu}, Nodal<double, 8>(h * unit_cube())};
  const auto w = cube.vibration().frequencies();
  for (int i = 0; i < 18; ++i) CHECK(w(i) < 1e-6 * w(23));  // roots of the rounding
  for (int i = 18; i < 23; ++i) CHECK(w(i) * w(i) == Approx(8 * G / rho / h / h).epsilon(1e-9));
  CHECK(w(23) * w(23) == Approx(12 * K / rho / h / h).epsilon(1e-9));
}

TEST_CASE("with stiffness control the twelve hourglass modes of a cube vibrate at w^2 = 24 kappa G/(rho h^2)") {
  const double E = 2, nu = 0.3, rho = 3, h = 0.5, G = E / 2 / (1 + nu), kappa = 0.01;
  const SingleElement cube{Hex8{StiffnessHourglass{kappa}}, Elastic{rho, E, nu}, Nodal<double, 8>(h * unit_cube())};
  const auto w = cube.vibration().frequencies();
  for (int i = 0; i < 6; ++i) CHECK(w(i) < 1e-6 * w(23));
  for (int i = 6; i < 18; ++i) CHECK(w(i) * w(i) == Approx(24 * kappa * G / rho / h / h).epsilon(1e-9));
  CHECK(w(18) * w(18) == Approx(8 * G / rho / h / h).epsilon(1e-9));
}

TEST_CASE("the critical step of a free cube: 0.734 h/c at Poisson's ratio 0.3, 0.577 in a fluid") {
  for (const auto& [nu, expected] : {std::pair{0.3, 0.734}, {0.4999, 0.577}}) {
    const Elastic material{1, 1, nu};
    const double c = std::sqrt(material.bulk_modulus() + 4. / 3 * material.shear_modulus());
    const SingleElement cube{Hex8{ViscousHourglass{}, HughesWinget{}, NoBulkViscosity{}}, material, unit_cube()};
    CHECK(cube.vibration().critical_step() * c == Approx(expected).margin(1e-3));
    CHECK(cube.now().stable_step == Approx(cube.vibration().critical_step()).epsilon(2e-3));  // exact for cubes
  }
}

TEST_CASE("the step knows a Newtonian viscosity") {
  const double eta = 5;
  const Fluid honey{LinearEos{.density = 1, .bulk_modulus = 1}, Newtonian{eta}};
  testing::Shapes<8> shapes(13);
  for (int trial = 0; trial < 20; ++trial) {
    const SingleElement single{Hex8{}, honey, shapes()};
    const double exact = single.vibration().critical_step();
    CHECK(exact >= (1 - 1e-9) * single.now().stable_step);
    CHECK(exact <= 1.6 * single.now().stable_step);  // a viscosity without bulk viscosity is bounded less sharply
  }
}

TEST_CASE("absent physics has no state") {
  using M = Elastic;
  using Pure = Hex8<NoHourglass, HughesWinget, NoBulkViscosity>;
  static_assert(sizeof(Pure::State<M, double>) == (1 + 6) * sizeof(double));
  static_assert(sizeof(Hex8<ViscousHourglass>::State<M, double>) == (1 + 1 + 6) * sizeof(double));
  static_assert(sizeof(Hex8<StiffnessHourglass>::State<M, double>) == (1 + 1 + 12 + 6) * sizeof(double));
  static_assert(sizeof(Hex8<PhysicalHourglass>::State<M, double>) == (1 + 1 + 12 + 6) * sizeof(double));
  using Water = Fluid<CubicEos>;
  static_assert(sizeof(Hex8<PhysicalHourglass>::State<Water, double>) ==
                sizeof(Hex8<ViscousHourglass>::State<Water, double>));
  static_assert(sizeof(Hex8<ViscousHourglass>) == 3 * sizeof(double));  // Q, C0, C1
  SUCCEED();
}
