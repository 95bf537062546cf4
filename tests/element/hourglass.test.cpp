#include <strike/element/hex8.hpp>
#include <strike/element/hourglass.hpp>

#include "conformance/element.hpp"
#include "element/nodal_hex8.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

template <class Control>
auto hex8_with(Control control) {
  return Hex8{control, HughesWinget{}, NoBulkViscosity{}};
}

/// Forces, and rho c^2 = K + 4/3 G, of the stressless material.
constexpr double K = 1, G = 0.5, wave_modulus = K + 4 * G / 3;

Nodal<double, 8> brick(double a, double b, double c) { return Eigen::Vector3d(a, b, c).asDiagonal() * unit_cube(); }

/// Takes the linear field from a motion of the nodes, whose spin would turn the resistance.
Eigen::Matrix<double, 8, 8> without_linear_field(const Nodal<double, 8>& x) {
  return Eigen::Matrix<double, 8, 8>::Identity() - nodal_hex8::gradient(x).transpose() * x / nodal_hex8::volume(x);
}

}  // namespace

TEST_CASE("viscous control is a gamma (gamma . v) with a = Q rho c V^(2/3)/4, in any shape") {
  testing::Shapes<8> shapes(8);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodal<double, 8> x = shapes(), v = shapes.nodal();
    const double Q = 0.12, V = nodal_hex8::volume(x), dt = 0.1;
    const double a = Q * std::sqrt(wave_modulus) * std::pow(V, 2. / 3) / 4;  // rho = 1
    const auto gamma = nodal_hex8::hourglass_vectors(x);
    const Eigen::Matrix<double, 3, 4> rates = v * gamma.transpose();
    const auto response = testing::detail::respond(hex8_with(ViscousHourglass{Q}), testing::ConstantStress{}, x, v, dt);
    CHECK((response.force - a * rates * gamma).norm() <= 1e-13 * a * rates.norm() * gamma.norm());
    CHECK(response.hourglass_work == Approx(dt * a * rates.squaredNorm()).epsilon(1e-12));
  }
}

TEST_CASE("stiffness control is k gamma (gamma . u) with k = kappa 2 G B:B/(8 V), in any shape") {
  testing::Shapes<8> shapes(9);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodal<double, 8> x = shapes(), v = shapes.nodal() * without_linear_field(x);
    const double kappa = 0.02, V = nodal_hex8::volume(x), dt = 0.1;
    const double k = kappa * 2 * G * nodal_hex8::gradient(x).squaredNorm() / (8 * V);
    const auto gamma = nodal_hex8::hourglass_vectors(x);
    const Eigen::Matrix<double, 3, 4> rates = v * gamma.transpose();
    const auto response =
        testing::detail::respond(hex8_with(StiffnessHourglass{kappa}), testing::ConstantStress{}, x, v, dt);
    CHECK((response.force - k * dt * rates * gamma).norm() <= 1e-13 * k * dt * rates.norm() * gamma.norm());
    CHECK(response.hourglass_work == Approx(0.5 * k * dt * dt * rates.squaredNorm()).epsilon(1e-12));
  }
}

TEST_CASE("stiffness control is conservative: a closed path of hourglass motions gives back what it took") {
  testing::Shapes<8> shapes(10);
  for (int trial = 0; trial < 10; ++trial) {
    Hex8 element = hex8_with(StiffnessHourglass{});
    decltype(element)::State<testing::ConstantStress, double> state;
    const Nodal<double, 8> x = shapes();  // held, so that the stiffness is
    element.begin(state, testing::ConstantStress{}, x);
    std::array<Nodal<double, 8>, 6> v;
    Nodal<double, 8> back = Nodal<double, 8>::Zero();
    for (std::size_t i = 0; i < 5; ++i) back -= v[i] = shapes.nodal() * without_linear_field(x);
    v[5] = back;
    double sum = 0, most = 0;
    for (const auto& step : v) {
      const auto response = element.advance(state, testing::ConstantStress{}, x, step, 0.1);
      sum += response.hourglass_work;
      most = std::max(most, std::abs(sum));
      CHECK(sum >= -1e-14 * most);
    }
    CHECK(std::abs(sum) <= 1e-13 * most);
  }
}

TEST_CASE("viscous control damps bricks at its own rate: its critical step is V^(1/3)/(8 Q c)") {
  for (const auto& [x, r] : {std::pair{brick(1, 1, 1), 0.125}, {brick(1, .1, .1), 0.269}, {brick(1, 1, .1), 0.580}}) {
    const double Q = 10, c = 1, smallest = (x.col(6) - x.col(0)).minCoeff();  // so much that it alone matters
    const Elastic material{.density = 1, .youngs_modulus = 1};
    const double step = SingleElement{hex8_with(ViscousHourglass{Q}), material, x}.vibration().critical_step();
    CHECK(step * c * Q / smallest == Approx(r).epsilon(2e-3));
  }
}

static_assert(HourglassControl<NoHourglass> && HourglassControl<ViscousHourglass> &&
              HourglassControl<StiffnessHourglass>);
static_assert(!HourglassControl<int> && !HourglassControl<HughesWinget>);
