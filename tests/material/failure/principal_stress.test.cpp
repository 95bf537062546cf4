#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/principal_stress.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/section/layered.hpp>
#include <strike/tensor/rotation.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// Soda-lime glass.
constexpr double K = 41.7e9, G = 28.7e9, strength = 60e6;
constexpr LinearEos eos{.density = 2500, .bulk_modulus = K};
constexpr Solid glass{eos, ElasticStrength{.shear_modulus = G}, PrincipalStress{.strength = strength}};

}  // namespace

TEST_CASE("principal stress: the largest principal value of any tensor, double ones too") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto n = [&] { return normal(random); };
  for (int i = 0; i < 300; ++i) {
    const Matrix3<double> A{{n(), n(), n()}, {n(), n(), n()}, {n(), n(), n()}};
    const Matrix3<double> Q = Eigen::AngleAxisd(n(), Eigen::Vector3d{n(), n(), n()}.normalized()).toRotationMatrix();
    const SymmetricTensor<double> a = symmetric_part(A);
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> exact(a.matrix());
    CHECK(largest_principal(a) == Approx(exact.eigenvalues()(2)).margin(1e-13));
    const double shift = n(), size = std::abs(n());
    const auto turned = [&](double x, double y, double z) {
      return rotated<double>(
          Q, SymmetricTensor<double>{.xx = shift + size * x, .yy = shift + size * y, .zz = shift + size * z});
    };
    CHECK(largest_principal(turned(1, 0, 0)) == Approx(shift + size).margin(1e-13));
    CHECK(largest_principal(turned(0, 1, 1)) == Approx(shift + size).margin(3e-8 * size));  // the root of rounding
    CHECK(largest_principal(turned(0, 0, 0)) == Approx(shift).margin(1e-13));
  }
  CHECK(largest_principal(SymmetricTensor<double>{}) == Approx(0).margin(1e-100));
  CHECK(largest_principal(PlaneTensor<double>{1, -1, 2}) == Approx(std::sqrt(5)).epsilon(1e-15));
}

TEST_CASE(
    "principal stress: glass breaks at its strength in tension, in shear as soon, and bears ten times that pressed") {
  const double E = 9 * K * G / (3 * K + G), nu = E / (2 * G) - 1;
  const auto survives = [](const SymmetricTensor<double>& e) {  // at the volume at which p = -K tr e
    decltype(glass)::State<double> state;
    glass.stress(state, {e, 1 / (1 - trace(e))}, 1.0);
    return state.intact == 1;
  };
  for (const double share : {.999, 1.001}) {
    const double s = share * strength, pulled = s / E;
    CHECK(survives({.xx = -nu * pulled, .yy = pulled, .zz = -nu * pulled}) == (share < 1));
    CHECK(survives({.xy = .5 * s / G}) == (share < 1));  // s1 = tau
    CHECK(survives({.zz = s / (K + 4 * G / 3)}) == (share < 1));
    CHECK(survives(SymmetricTensor<double>::isotropic(s / (3 * K))) == (share < 1));
  }
  const double pressed = -10 * strength / E;
  CHECK(survives({.xx = -nu * pressed, .yy = pressed, .zz = -nu * pressed}));
}

TEST_CASE("principal stress: a pane that is bent breaks where it is stretched, its face first, and then further in") {
  const double h = .006, Q = 4 * G * (3 * K + G) / (3 * K + 4 * G);  // E/(1 - nu^2)
  const double limit = strength / (Q * h / 2);                       // the curvature at which its face breaks
  const Homogeneous pane{PlaneStress{glass}, h, Lobatto<5>{}};
  decltype(pane)::State<double> state;
  PlateKinematics::Rate<double> rate{};
  rate.curvature.xx = .01 * limit, rate.relative_thickness = 1;
  const auto intact = [&] {
    std::vector<double> all;
    state.each_point([&](const auto& point) { all.push_back(point.intact); });
    return all;
  };
  for (int i = 1; i <= 99; ++i) {
    const double moment = pane.stress(state, rate, 1.0).moment.xx;
    CHECK(moment == Approx(.01 * i * limit * Q * h * h * h / 12).epsilon(1e-12));
  }
  CHECK(intact() == std::vector<double>{1, 1, 1, 1, 1});
  for (int i = 0; i < 2; ++i) pane.stress(state, rate, 1.0);
  CHECK(intact() == std::vector<double>{1, 1, 1, 1, 0});
  for (int i = 0; i < 60; ++i) pane.stress(state, rate, 1.0);
  CHECK(intact() == std::vector<double>{1, 1, 1, 0, 0});  // the next lies at sqrt(3/7) of the half thickness
  CHECK(pane.intact(state) == 1);
}
