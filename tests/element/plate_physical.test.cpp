#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <strike/element/plate4.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/strength/kinematic_hardening.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/section.hpp>

#include "conformance/plate.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

const Plate4 element{PhysicalHourglass{}};
const Plate4 drilling_freely{PhysicalHourglass{}, BelytschkoWongChiang{}, ConstantThickness{}, FreeDrilling{}};

/// Steel of unit modulus and density, without hardening.
auto perfectly_plastic(double yield_stress, double E = 1, double nu = 0.3) {
  return PlaneStress{Solid{LinearEos{.density = 1, .bulk_modulus = E / (3 * (1 - 2 * nu))},
                           VonMises{.shear_modulus = E / (2 * (1 + nu)), .yield_stress = yield_stress}}};
}

/// Velocities of the corners of the unit square, whose sides along y turn against each other in its plane.
Nodal<double, 8> bending(double rate) {
  Nodal<double, 8> v = Nodal<double, 8>::Zero();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d x = unit_square().col(i), from_middle = x - Eigen::Vector3d(0.5, 0.5, 0);
    v(0, i) = -rate * 2 * from_middle.x() * from_middle.y();
    v(2, 4 + i) = rate * 2 * from_middle.x();
  }
  return v;
}
/// The moment about z that the nodes at x = 1 bear.
double moment(const Nodal<double, 8>& force) {
  double sum = force(2, 4 + 1) + force(2, 4 + 2);
  for (const int i : {1, 2}) sum -= (unit_square()(1, i) - 0.5) * force(0, i);
  return sum;
}
template <class E, class Section>
double bent(const E& plate, const Section& section, double strain, int steps = 400) {
  SingleElement single{plate, section, unit_square()};
  for (int i = 0; i < steps; ++i) single.step(bending(strain / steps), 1);
  return moment(single.now().force);
}

}  // namespace

TEST_CASE("physical hourglass of plates: a parallelogram bends in its plane as Hooke's law says, and nothing drills") {
  testing::Quadrilaterals shapes(5);
  for (int trial = 0; trial < 10; ++trial) {
    const double nu = 0.1 * (trial % 5), h = 0.2;
    const Eigen::Matrix3d turn = shapes.turn();
    const Eigen::Vector3d a = turn * Eigen::Vector3d(1 + 0.4 * shapes.unit(), 0.4 * shapes.unit(), 0),
                          b = turn * Eigen::Vector3d(0.4 * shapes.unit(), 1 + 0.4 * shapes.unit(), 0), n = turn.col(2);
    const Nodal<double, 4> corner = 2 * unit_square().array() - 1;
    const Nodal<double, 4> X = a * corner.row(0) + b * corner.row(1);
    const auto along = [&](const Eigen::Vector3d& s, const Eigen::Vector3d& other) {
      // The stress (w.x) s (x) s is in equilibrium; its strain (w.x) e belongs to u = (w.x) e x - (x.e x) w/2.
      const Eigen::Vector3d w = s.cross(n) / s.cross(n).dot(other);
      const Eigen::Matrix3d in_plane = Eigen::Matrix3d::Identity() - n * n.transpose();
      const Eigen::Matrix3d e = 1e-7 * ((1 + nu) * s * s.transpose() - nu * s.squaredNorm() * in_plane);
      Nodal<double, 8> v;
      Nodal<double, 4> exact = Nodal<double, 4>::Zero();
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3d x = X.col(i);
        v.col(i) = w.dot(x) * e * x - 0.5 * x.dot(e * x) * w;
        v.col(4 + i) = w.cross(e * x);
        // integral of the stress over the bilinear field of the corner, w.x = the coordinate across
        const Eigen::Vector3d dual = other.cross(n) / other.cross(n).dot(s);
        exact.col(i) = 1e-7 * h * a.cross(b).norm() / 3 * corner(0, i) * corner(1, i) * s.dot(dual) * s;
      }
      SingleElement single{element, Homogeneous{PlaneStress{Elastic{1, 1, nu}}, h}, X};
      const Nodal<double, 8> f = single.step(v, 1).force;
      CHECK((f.leftCols<4>() - exact).norm() <= 1e-5 * exact.norm());  // a strain of 1e-7
      CHECK(f.rightCols<4>().norm() <= 1e-5 * exact.norm());
    };
    along(a, b), along(b, a);
  }
}

TEST_CASE("physical hourglass of plates: none but rigid motions are free, whatever the shape") {
  testing::Quadrilaterals shapes(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodal<double, 4> X = trial % 2 ? shapes() : shapes.plane();
    const auto free = [&](const auto& plate) {
      const Eigen::VectorXd w = SingleElement{plate, testing::elastic_plate, X}.vibration().frequencies();
      return (w.array() < 1e-3 * w.maxCoeff()).count();
    };
    if (trial % 2 == 0) CHECK(free(drilling_freely) == 6 + 4);  // plane: and the drilling of each node
    const Plate4 stiff{PhysicalHourglass{}, BelytschkoWongChiang{}, ConstantThickness{}, DrillingStiffness{1}};
    CHECK(free(stiff) == 6);
  }
}

TEST_CASE("physical hourglass of plates: a layer yields in its plane at its plastic moment, layers at their sum") {
  const double h = 0.3, Y = 1e-3;
  const double elastic = bent(element, Homogeneous{PlaneStress{Elastic{1, 1, 0.3}}, h}, 1e-5);
  CHECK(elastic == Approx(h / 12 * 2e-5).epsilon(1e-3));  // E I kappa, kappa = 2 e/H
  CHECK(bent(element, Homogeneous{perfectly_plastic(Y), h}, 0.02) == Approx(Y * h / 4).epsilon(0.01));
  const Layered laminate{Layer{perfectly_plastic(Y), 0.1}, Layer{perfectly_plastic(3 * Y, 0.5), 0.2, Gauss<2>{}},
                         Layer{PlaneStress{Elastic{1, 1e-6, 0.4}}, 0.1}, Offset{0.3}};
  CHECK(bent(element, laminate, 0.04) == Approx((0.1 * Y + 0.2 * 3 * Y) / 4).epsilon(0.01));
  CHECK(bent(element, Layered{Plies{Layer{perfectly_plastic(Y), 0.1, Gauss<2>{}}, 3}}, 0.02) ==
        Approx(Y * h / 4).epsilon(0.01));
  CHECK(bent(Plate4{PhysicalHourglass{}, NoWarping{}, ThicknessChange{}}, Homogeneous{perfectly_plastic(Y), h}, 0.02) ==
        Approx(Y * h / 4).epsilon(0.02));
}

TEST_CASE("physical hourglass of plates: every law yields, in a solid of any equation of state too") {
  const double h = 0.3, Y = 1e-3, K = 1 / (3 * 0.4), G = 1 / 2.6;
  const LinearEos eos{.density = 1, .bulk_modulus = K};
  const VonMises law{.shear_modulus = G, .yield_stress = Y};
  CHECK(bent(element, Homogeneous{ZeroNormalStress{Solid{eos, law}}, h, Gauss<2>{}}, 0.02) ==
        Approx(Y * h / 4).epsilon(0.02));
  // half of the hardening moves the centre of the yield surface, which the linear stresses do not have
  const KinematicHardening kinematic{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e-6};
  CHECK(bent(element, Homogeneous{ZeroNormalStress{Solid{eos, kinematic}}, h, Gauss<2>{}}, 0.02) ==
        Approx(Y * h / 4).epsilon(0.02));
  const RateVonMises rate{.shear_modulus = G, .yield_stress = Y, .rate_factor = 0.5, .rate_exponent = 1e-3};
  CHECK(bent(element, Homogeneous{PlaneStress{Solid{eos, rate}}, h, Gauss<2>{}}, 0.02) ==
        Approx(1.5 * Y * h / 4).epsilon(0.02));
  const VonMises hardening{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 0.05};
  const double more = bent(element, Homogeneous{PlaneStress{Solid{eos, hardening}}, h, Gauss<2>{}}, 0.04);
  CHECK(more > 1.3 * Y * h / 4);
  CHECK(more < 3 * Y * h / 4);
}

TEST_CASE("physical hourglass of plates: stretched plastically all over, a plate does not resist its bending") {
  const double h = 0.3, Y = 1e-3;
  SingleElement single{element, Homogeneous{perfectly_plastic(Y), h}, unit_square()};
  Nodal<double, 8> stretch = Nodal<double, 8>::Zero();
  stretch(0, 1) = stretch(0, 2) = 1e-4;
  stretch(1, 2) = stretch(1, 3) = -5e-5;
  for (int i = 0; i < 100; ++i) single.step(stretch, 1);
  for (int i = 0; i < 100; ++i) single.step(stretch + bending(2e-5), 1);  // every fibre is stretched on
  CHECK(std::abs(moment(single.now().force)) < 0.02 * Y * h / 4);
  CHECK(single.now().stress.force.xx == Approx(Y * h).epsilon(0.02));
}

TEST_CASE("physical hourglass of plates: nodes off the middle of the section bear what those in it do") {
  testing::Quadrilaterals shapes(9);
  const double h = 0.2, z = 0.35, Y = 2e-6;
  for (int trial = 0; trial < 5; ++trial) {
    const Nodal<double, 4> X = shapes.flat();
    const Nodal<double, 8> v = 1e-6 * shapes.nodal<8>();
    SingleElement middle{drilling_freely, Homogeneous{perfectly_plastic(Y), h}, X};
    SingleElement off{drilling_freely, Homogeneous{perfectly_plastic(Y), h, Simpson<5>{}, Offset{z}}, X};
    Nodal<double, 8> v_off = v;  // the middle moves at v + w x z e3
    const Eigen::Vector3d arm(0, 0, z);
    for (int i = 0; i < 4; ++i) v_off.col(i) -= Eigen::Vector3d(v.col(4 + i)).cross(arm);
    for (int step = 0; step < 10; ++step) middle.step(v, 1), off.step(v_off, 1);
    const Nodal<double, 8> f = middle.now().force;
    Nodal<double, 8> expected = f;
    for (int i = 0; i < 4; ++i) expected.col(4 + i) += arm.cross(Eigen::Vector3d(f.col(i)));
    // strains of 1e-5 turn the plate by as much; about the normal nothing resists
    CHECK((off.now().force - expected).norm() <= 1e-3 * f.norm());
  }
}

TEST_CASE("physical hourglass of plates: a point that fails carries no linear stress") {
  const Solid glass{LinearEos{.density = 1, .bulk_modulus = 1 / 1.5}, ElasticStrength{1 / 2.5}, UltimateStress{1e-3}};
  const Layered pane{Layer{PlaneStress{glass}, 0.1, Gauss<2>{}}, Layer{PlaneStress{Elastic{1, 1, 0.25}}, 0.1}};
  SingleElement single{drilling_freely, pane, unit_square()};
  for (int i = 0; i < 10; ++i) single.step(bending(1e-5), 1);
  CHECK(moment(single.now().force) > 0);
  Nodal<double, 8> bends = Nodal<double, 8>::Zero();
  bends(1, 4 + 1) = bends(1, 4 + 2) = 1e-3;
  const double before = moment(single.now().force);
  for (int i = 0; i < 60; ++i) single.step(bends, 1);
  CHECK(moment(single.now().force) == Approx(0.5 * before).epsilon(0.05));
}

TEST_CASE("physical hourglass of plates: 1e4 revolutions leave locked-in stresses as they were") {
  testing::Quadrilaterals shapes(4, 0.1);
  const Nodal<double, 4> X = shapes();
  SingleElement single{element, testing::metal_plate, X};
  single.step(0.005 * shapes.nodal<8>(), 1);
  single.step(Nodal<double, 8>::Zero().eval(), 1);
  const Nodal<double, 4> x = single.now().x;
  const Nodal<double, 8> f = single.now().force;
  constexpr int per_revolution = 16;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  std::array<Nodal<double, 8>, per_revolution> steps;  // chords belong to tan(theta/2)
  const auto at = [&](int i) -> Nodal<double, 4> {
    return Eigen::AngleAxisd(2 * std::numbers::pi * (i % per_revolution) / per_revolution, axis).toRotationMatrix() * x;
  };
  for (int i = 0; i < per_revolution; ++i) {
    steps[static_cast<std::size_t>(i)].leftCols<4>() = at(i + 1) - at(i);
    steps[static_cast<std::size_t>(i)].rightCols<4>().colwise() =
        2 * std::tan(std::numbers::pi / per_revolution) * axis;
  }
  for (int revolution = 0; revolution < testing::repeated(10000); ++revolution)
    for (const auto& step : steps) single.step(step, 1);
  CHECK((single.now().force - f).norm() <= 1e-8 * f.norm());
}
