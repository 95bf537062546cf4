#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "conformance/element.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

constexpr double rho = 1, E = 1;

Eigen::VectorXd squared_frequencies(double nu, const Nodal<double, 8>& x) {
  return SingleElement{Hex8Full{}, Elastic{rho, E, nu}, x}.vibration().frequencies().array().square();
}

/// Bends the unit cube about y: v_x = z x, v_z = -x^2/2 at the corners (+-1/2, ., +-1/2).
const auto bend = motion::field([](const Eigen::Vector3d& x) -> Eigen::Vector3d { return {x.x() * x.z(), 0, 0}; });

Nodal<double, 8> centred_cube() { return (unit_cube().array() - 0.5).matrix(); }

}  // namespace

TEST_CASE("Hex8Full has no modes without stiffness but the six rigid ones") {
  testing::Shapes<8> shapes(14);
  for (int trial = 0; trial < 10; ++trial) {
    const auto w2 = squared_frequencies(0.3, shapes());
    CHECK(w2(5) <= 1e-8 * w2(23));
    CHECK(w2(6) >= 1e-4 * w2(23));
  }
}

TEST_CASE("Hex8Full does not lock: of its modes the volume alone resists with the bulk modulus") {
  testing::Shapes<8> shapes(15);
  for (int trial = 0; trial < 10; ++trial) {
    const Nodal<double, 8> x = shapes();
    const auto soft = squared_frequencies(0.499, x), stiff = squared_frequencies(0.49999, x);
    const double shear = 1.499 / 1.49999;  // ratio of the shear moduli
    CHECK(stiff(23) == Approx(100 * soft(23)).epsilon(0.05));
    for (int i = 6; i < 22; ++i) CHECK(stiff(i) == Approx(shear * soft(i)).epsilon(0.02));
  }
}

TEST_CASE("Hex8Full bends with the deviatoric stiffness at its points, where Hex8 needs hourglass control") {
  // eps_xx = z, which at the points z = +-1/(2 sqrt 3) gives the mean z^2 = 1/12; gamma_xz = x likewise; the mean
  // volume does not change: energy = 2 G (2/3 + 1/2)/12 t^2/2
  const double nu = 0.3, G = E / 2 / (1 + nu), t = 1e-4;
  SingleElement full{Hex8Full{}, Elastic{rho, E, nu}, centred_cube()};
  full.run(bend, t / 10, 10);
  CHECK(full.now().internal == Approx(2 * G * (2. / 3 + 1. / 2) / 12 * t * t / 2).epsilon(1e-3));
  SingleElement one{Hex8{NoHourglass{}}, Elastic{rho, E, nu}, centred_cube()};
  one.run(bend, t / 10, 10);
  CHECK(std::abs(one.now().internal) <= 1e-8 * full.now().internal);
}

TEST_CASE("in a homogeneous motion Hex8Full is Hex8") {
  testing::Shapes<8> shapes(16);
  for (int trial = 0; trial < 10; ++trial) {
    const Nodal<double, 8> x = shapes();
    const Eigen::Matrix3d L = shapes.matrix();
    const auto one = SingleElement{Hex8{}, testing::metal, x}.run(motion::homogeneous(L), 0.003, 20).back();
    const auto full = SingleElement{Hex8Full{}, testing::metal, x}.run(motion::homogeneous(L), 0.003, 20).back();
    const double q = 0.01 * L.norm() * x.squaredNorm();  // bulk viscosity with a length that differs by a few per cent
    CHECK((full.force - one.force).norm() <= 1e-10 * one.force.norm() + (L.trace() < 0 ? q : 0));
    CHECK(full.internal == Approx(one.internal).epsilon(1e-10));
    CHECK(full.volume == Approx(one.volume).epsilon(1e-13));
  }
}

TEST_CASE("a point that has failed gives no force, the others do, and in the end the element is silent") {
  using Brittle = Solid<LinearEos, VonMises, UltimateStress>;
  const Brittle brittle{{.density = rho, .bulk_modulus = 1}, {.shear_modulus = 0.4, .yield_stress = 1}, {1e-2}};
  const Hex8Full element{HughesWinget{}, NoBulkViscosity{}};
  decltype(element)::State<Brittle, double> state;
  Nodal<double, 8> x = centred_cube(), v = Nodal<double, 8>::Zero();
  element.begin(state, brittle, x);
  for (int I = 4; I < 8; ++I) v(0, I) = x(1, I);  // the upper face shears, the lower holds: the upper points fail first

  testing::Shapes<8> shapes(17);
  int intact = 8;
  bool partly = false;
  for (int step = 0; step < 1000 && intact > 0; ++step) {
    x += 0.002 * v;
    const auto response = element.advance(state, brittle, x, v, 0.002);
    const int before = intact;
    intact = 0;
    for (const auto& point : state.material) intact += point.intact > 0;
    partly = partly || (intact > 0 && intact < 8);
    CHECK(intact <= before);

    // Power on any velocities: the points' deviators on their gradients and the mean tension on the mean gradient.
    const Nodal<double, 8> w = shapes.nodal();
    const Hex8Modes<double> m = to_modes<double>(x), u = to_modes<double>(w);
    const Hex8Gradient<double> g(m);
    double power = 0, tension = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const Hex8Map<double> map(Hex8Point(i).derivatives(m));
      const auto& sigma = state.material[i].stress;
      if (state.material[i].intact == 0) CHECK(sigma.matrix().norm() == 0);
      const auto D = symmetric_part(map.gradient(Hex8Point(i).derivatives(u), 1 / map.volume));
      power += map.volume * double_dot(deviator(sigma), D);
      tension += map.volume * trace(sigma) / 3;
    }
    power += tension * g.gradient_of(u, 1 / g.volume).trace();
    CHECK(response.force.cwiseProduct(w).sum() == Approx(power).margin(1e-15));
  }
  CHECK(intact == 0);
  CHECK(partly);
  const auto response = element.advance(state, brittle, x, v, 0.002);
  CHECK(response.force.norm() == 0);
  CHECK(response.critical_rate == 0);
}

TEST_CASE("Hex8Full reports the first point that turns inside out") {
  Nodal<double, 8> x = unit_cube();
  x.col(6) << 0.1, 0.1, 0.1;  // pushed through: the volume is still positive, the point beside it is not
  const Hex8Gradient<double> g(to_modes<double>(x));
  REQUIRE(g.volume > 0);
  Hex8Full<> element;
  decltype(element)::State<Elastic, double> state;
  const Elastic material{rho, E};
  element.begin(state, material, unit_cube());
  CHECK(element.advance(state, material, x, Nodal<double, 8>::Zero().eval(), 0.1).volume < 0);
}

TEST_CASE("the state of Hex8Full is that of its eight points") {
  static_assert(sizeof(Hex8Full<>::State<Elastic, double>) == (1 + 1 + 8 * 6) * sizeof(double));
  static_assert(sizeof(Hex8Full<HughesWinget, NoBulkViscosity>::State<Elastic, double>) ==
                (1 + 8 * 6) * sizeof(double));
  SUCCEED();
}

TEST_CASE("Hex8Full: a cube at rest has its exact step, with bulk viscosity too: w^2 = 12 K/(rho a^2)") {
  const SingleElement cube{Hex8Full{}, Elastic{1, 1, 0.3}, unit_cube()};
  const double K = 1 / (3 * (1 - 2 * 0.3));
  CHECK(cube.vibration().critical_step() == Approx(2 / std::sqrt(12 * K)).epsilon(1e-9));
}
