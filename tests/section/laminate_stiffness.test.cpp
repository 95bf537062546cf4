#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/section.hpp>

#include "support/catch.hpp"
#include "support/plies.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using testing::carbon, testing::four_plies, testing::of_four, testing::pagano_ply;

namespace {

using strike::detail::LaminaStiffness, strike::detail::laminate_shear;
using Rate = PlateKinematics::Rate<double>;

/// Q in turned axes by the invariants of Tsai and Pagano (Jones 1975, chapter 2), a road of its own.
PlaneStiffness by_invariants(const OrthotropicPly& ply, double degrees) {
  const double d = 1 - ply.nu12 * ply.nu12 * ply.E2 / ply.E1, Q11 = ply.E1 / d, Q22 = ply.E2 / d, Q12 = ply.nu12 * Q22,
               Q66 = ply.G12;
  const double U1 = (3 * Q11 + 3 * Q22 + 2 * Q12 + 4 * Q66) / 8, U2 = (Q11 - Q22) / 2,
               U3 = (Q11 + Q22 - 2 * Q12 - 4 * Q66) / 8, U4 = (Q11 + Q22 + 6 * Q12 - 4 * Q66) / 8, U5 = (U1 - U4) / 2;
  const double a = 2 * degrees * std::numbers::pi / 180;
  const double c2 = std::cos(a), s2 = std::sin(a), c4 = std::cos(2 * a), s4 = std::sin(2 * a);
  const double q16 = U2 / 2 * s2 + U3 * s4, q26 = U2 / 2 * s2 - U3 * s4;
  PlaneStiffness Q;
  Q << U1 + U2 * c2 + U3 * c4, U4 - U3 * c4, q16, U4 - U3 * c4, U1 - U2 * c2 + U3 * c4, q26, q16, q26, U5 - U3 * c4;
  return Q;
}

struct ClassicalLaminate {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero(), B = A, D = A;
  ClassicalLaminate(const OrthotropicPly& ply, double h, const std::vector<double>& angles, double up = 0) {
    double z = up - 0.5 * h * static_cast<double>(angles.size());
    for (const double angle : angles) {
      const double top = z + h;
      const PlaneStiffness Q = by_invariants(ply, angle);
      A += (top - z) * Q, B += (top * top - z * z) / 2 * Q, D += (top * top * top - z * z * z) / 3 * Q;
      z = top;
    }
  }
};

std::vector<LaminaStiffness> laminae(const OrthotropicPly& ply, double h, const std::vector<double>& angles) {
  std::vector<LaminaStiffness> all;
  for (const double angle : angles)
    all.push_back({h, turned_back(ply.plane_stiffness(), turn_by_degrees(angle)),
                   turned_back(ply.transverse_stiffness(), turn_by_degrees(angle))});
  return all;
}
Matrix2 shear_of(const std::vector<LaminaStiffness>& layers) {
  std::vector<ShearFlow<Matrix2>> flows;
  return laminate_shear(layers, flows).stiffness;
}
double angle_of(std::mt19937& random) { return std::uniform_real_distribution<double>(-90, 90)(random); }

}  // namespace

TEST_CASE("laminate stiffness: A, B and D are those of classical lamination theory, to 1e-10") {
  const double h = 0.125, up = 0.07;
  for (const auto& angles : four_plies) {
    const ClassicalLaminate exact(carbon, h, angles, up);
    const Layered section{LayUp{carbon, h, {angles[0], angles[1], angles[2], angles[3]}}, FibreDirection{{1, 0, 0}},
                          Offset{up}};
    const auto near = [](const Eigen::Matrix3d& found, const Eigen::Matrix3d& is, double scale) {
      CHECK((found - is).cwiseAbs().maxCoeff() <= 1e-10 * scale);
    };
    const double A = exact.A.norm(), D = exact.D.norm(), B = std::sqrt(A * D);
    near(section.laminate_stiffness().A, exact.A, A);
    near(section.laminate_stiffness().B, exact.B, B);
    near(section.laminate_stiffness().D, exact.D, D);

    // and so it answers
    for (int c = 0; c < 6; ++c) {
      Eigen::Matrix<double, 6, 1> e = Eigen::Matrix<double, 6, 1>::Zero();
      e(c) = 1e-3;
      auto state = decltype(section)::State<double>{};
      const auto s = section.stress(state, Rate{{e(0), e(1), e(2) / 2}, {e(3), e(4), e(5) / 2}, {0, 0}}, 1.0);
      const Eigen::Vector3d N = exact.A * e.head(3) + exact.B * e.tail(3),
                            M = exact.B * e.head(3) + exact.D * e.tail(3);
      CHECK((Eigen::Vector3d(s.force.xx, s.force.yy, s.force.xy) - N).norm() <= 1e-10 * 1e-3 * (c < 3 ? A : B));
      CHECK((Eigen::Vector3d(s.moment.xx, s.moment.yy, s.moment.xy) - M).norm() <= 1e-10 * 1e-3 * (c < 3 ? B : D));
    }
  }
}

TEST_CASE("laminate stiffness: a LayUp, Layers, Plies and a PlyStack are the same, and n equal plies are one") {
  const Rate rate{{1e-3, -2e-3, 5e-4}, {1e-2, 2e-2, -1e-2}, {1e-3, -3e-3}};
  const auto check = [&](const auto& a, const auto& b, double tolerance) {
    auto one = typename std::decay_t<decltype(a)>::template State<double>{};
    auto other = typename std::decay_t<decltype(b)>::template State<double>{};
    if constexpr (requires { a.begin(one); }) a.begin(one);
    if constexpr (requires { b.begin(other); }) b.begin(other);
    const auto s = a.stress(one, rate, 1.0), t = b.stress(other, rate, 1.0);
    CHECK(s.force.xx == Approx(t.force.xx).epsilon(tolerance));
    CHECK(s.force.xy == Approx(t.force.xy).epsilon(tolerance));
    CHECK(s.moment.yy == Approx(t.moment.yy).epsilon(tolerance));
    CHECK(s.moment.xy == Approx(t.moment.xy).epsilon(tolerance));
    CHECK((s.shear - t.shear).norm() <= tolerance * t.shear.norm());
    CHECK(s.normal_rate == Approx(t.normal_rate).epsilon(tolerance));
  };
  const FibreDirection along{{1, 0, 0}};
  const auto at = [](double angle) {
    OrthotropicPly ply = carbon;
    ply.angle = angle;
    return Layer{ply, 0.125, Gauss<2>{}};
  };
  check(Layered{LayUp{carbon, 0.125, {0, 45, -45, 90}}, along}, Layered{at(0), at(45), at(-45), at(90), along}, 1e-14);
  check(Layered{Plies{at(30), 4}, along}, Layered{at(30), at(30), at(30), at(30), along}, 1e-14);
  const OrthotropicPly glass{
      .density = 2e-9, .E1 = 40e3, .E2 = 10e3, .nu12 = 0.25, .G12 = 4e3, .G13 = 4e3, .G23 = 3e3, .angle = 10};
  const Layered stack{PlyStack{{Ply{carbon, 0.125, 45}, Ply{glass, 0.2, 20}, Ply{carbon, 0.1}}}, along, Offset{0.3}};
  OrthotropicPly turned = glass;
  turned.angle = 30;
  const Layered layers{at(45), Layer{turned, 0.2, Gauss<2>{}}, Layer{carbon, 0.1, Gauss<2>{}}, along, Offset{0.3}};
  check(stack, layers, 1e-14);
  CHECK(stack.layers() == 3);
  CHECK(stack.thickness() == layers.thickness());
  CHECK(stack.density() == Approx(layers.density()).epsilon(1e-14));
  CHECK_THROWS_WITH((Layered{PlyStack{std::vector<Ply<OrthotropicPly>>{}}, along}), ContainsSubstring("count"));
  CHECK_THROWS_WITH((Layered{PlyStack{{Ply{carbon, 0.1}, Ply{carbon, -0.1}}}, along}), ContainsSubstring("thickness"));
  check(Layered{LayUp{carbon, 0.125, {30, 30, 30, 30}}, along}, Homogeneous{at(30).material, 0.5, Gauss<2>{}, along},
        1e-12);
  check(Layered{LayUp{carbon, 0.125, {30, -20, 90, 0}}, along},
        Layered{LayUp{carbon, 0.125, {210, 160, -90, 180}}, along}, 1e-14);
}

TEST_CASE("laminate stiffness: fibres that are no stiffer than the rest are the isotropic plate") {
  const double E = 70e3, nu = 0.25;
  const OrthotropicPly glassy{.density = 2.5e-9,
                              .E1 = E,
                              .E2 = E,
                              .nu12 = nu,
                              .G12 = E / 2 / (1 + nu),
                              .G13 = E / 2 / (1 + nu),
                              .G23 = E / 2 / (1 + nu),
                              .nu23 = nu};
  const PlaneStress glass{Elastic{.density = 2.5e-9, .youngs_modulus = E, .poissons_ratio = nu}};
  const PlaneStress soft{Elastic{.density = 1e-9, .youngs_modulus = 3e3, .poissons_ratio = 0.45}};
  const Layered plies{Layer{glassy, 3.0}, Layer{soft, 0.76}, Layer{glassy, 2.0}, FibreDirection{{1, 1, 0}},
                      Offset{0.3}};
  const Layered plain{Layer{glass, 3.0}, Layer{soft, 0.76}, Layer{glass, 2.0}, Offset{0.3}};
  CHECK((plies.shear_stiffness() - plain.shear_stiffness() * Matrix2::Identity()).norm() <=
        1e-14 * plain.shear_stiffness());
  auto one = decltype(plies)::State<double>{};
  auto other = decltype(plain)::State<double>{};
  plies.align<double>(one, Vector3<double>{1, 0, 0}, Vector3<double>{0, 1, 0});
  const Rate rate{{1e-3, -2e-3, 5e-4}, {1e-2, 2e-2, -1e-2}, {1e-3, -3e-3}};
  const auto s = plies.stress(one, rate, 1.0), t = plain.stress(other, rate, 1.0);
  CHECK(s.force.xx == Approx(t.force.xx).epsilon(1e-13));
  CHECK(s.force.xy == Approx(t.force.xy).epsilon(1e-13));
  CHECK(s.moment.yy == Approx(t.moment.yy).epsilon(1e-13));
  CHECK((s.shear - t.shear).norm() <= 1e-14 * t.shear.norm());
  CHECK(s.normal_rate == Approx(t.normal_rate).epsilon(1e-13));
  const auto m = plies.moduli(one, rate), n = plain.moduli(other, rate);
  CHECK(m.extension.normal >= n.extension.normal * (1 - 1e-12));  // of layers of different nu a little above
  CHECK(m.extension.normal <= n.extension.normal * 1.03);
  CHECK(m.bending.shear <= n.bending.shear * 1.03);
  for (const double xi : {0.2, 1.0})
    CHECK((plies.shear_stress(one, 1, xi) - turn_by_degrees(45).into(plain.shear_stress(other, 1, xi))).norm() <=
          1e-13 * plain.shear_stress(other, 1, xi).norm());
}

TEST_CASE("laminate shear: one ply has five sixths, and it turns with its fibres") {
  for (const double angle : {0., 30., 45., 90.})
    CHECK((shear_of(laminae(pagano_ply, 1, {angle})) -
           turned_back(Matrix2(5. / 6 * pagano_ply.transverse_stiffness()), turn_by_degrees(angle)))
              .norm() <= 1e-13);
}

TEST_CASE("laminate shear: of every lay-up symmetric, positive, below the sum, turned and mirrored with it") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < testing::repeated(200); ++i) {
    OrthotropicPly ply = pagano_ply;
    ply.E1 = std::pow(10, 3 * unit(random)), ply.G23 = std::pow(10, -2 * unit(random));
    std::vector<double> angles(1 + static_cast<std::size_t>(6 * unit(random)));
    for (double& a : angles) a = angle_of(random);
    std::vector<LaminaStiffness> layers = laminae(ply, 1, angles);
    for (LaminaStiffness& layer : layers) layer.thickness = std::pow(10, -2 * unit(random));
    std::vector<ShearFlow<Matrix2>> flows;
    const LaminateShear shear = laminate_shear(layers, flows);
    const Matrix2& K = shear.stiffness;
    const double scale = K.norm();
    CHECK(std::abs(K(0, 1) - K(1, 0)) <= 1e-13 * scale);
    CHECK((0.5 * (K + K.transpose())).eval().selfadjointView<Eigen::Upper>().eigenvalues()(0) > 0);
    CHECK((shear.layer_sum - K).eval().selfadjointView<Eigen::Upper>().eigenvalues()(0) > 0);

    // f is continuous, zero on both faces and its integral is 1
    Matrix2 integral = Matrix2::Zero();
    double largest = 0;
    for (std::size_t k = 0; k < flows.size(); ++k) {
      integral += layers[k].thickness * (0.5 * (flows[k].bottom + flows[k].top) + 2. / 3 * flows[k].bulge);
      largest = std::max({largest, flows[k].bottom.norm(), flows[k].bulge.norm()});
      if (k > 0) CHECK((flows[k].bottom - flows[k - 1].top).norm() <= 1e-12 * largest);
    }
    CHECK((integral - Matrix2::Identity()).norm() <= 1e-11);
    CHECK(flows[0].bottom.norm() == 0);
    CHECK(flows.back().top.norm() <= 1e-11 * largest);

    const double by = angle_of(random);
    std::vector<LaminaStiffness> turned = layers, mirrored = layers, flipped(layers.rbegin(), layers.rend());
    Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
    Matrix2 mirror2;
    mirror2 << 1, 0, 0, -1;
    for (std::size_t k = 0; k < layers.size(); ++k) {
      turned[k].plane = turned_back(layers[k].plane, turn_by_degrees(by));
      turned[k].shear = turned_back(layers[k].shear, turn_by_degrees(by));
      mirrored[k].plane = mirror * layers[k].plane * mirror, mirrored[k].shear = mirror2 * layers[k].shear * mirror2;
    }
    CHECK((shear_of(turned) - turned_back(K, turn_by_degrees(by))).norm() <= 1e-9 * scale);
    CHECK((shear_of(mirrored) - mirror2 * K * mirror2).norm() <= 1e-9 * scale);
    CHECK((shear_of(flipped) - K).norm() <= 1e-9 * scale);
  }
}

// Along the outer fibres of a symmetric cross-ply the fit is that of cylindrical bending to 0.1 %, across it 5 % above.
TEST_CASE("laminate shear: of a cross-ply near that of cylindrical bending along its axes") {
  const auto layers = laminae(pagano_ply, 1. / 3, {0, 90, 0});
  const auto along = [&](int i) {
    std::vector<ShearLayer<double>> strip;
    for (const LaminaStiffness& layer : layers)
      strip.push_back({layer.thickness, {layer.plane(i, i), layer.shear(i, i)}});
    return transverse_shear(strip).stiffness;
  };
  const Matrix2 K = shear_of(layers);
  CHECK(std::abs(K(0, 1)) <= 1e-14);
  CHECK(K(0, 0) / along(0) == Approx(0.9995).margin(1e-4));
  CHECK(K(1, 1) / along(1) == Approx(1.0498).margin(1e-4));
}

// The step needs [A, B; B, D] bounded as one.
TEST_CASE("laminate stiffness: isotropic bounds hold for every lay-up, and are sharp where it is symmetric") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto orthonormal = [](const PlaneStiffness& Q) { return strike::detail::orthonormal(Q); };
  for (int i = 0; i < 500; ++i) {
    OrthotropicPly ply = pagano_ply;
    ply.E1 = std::pow(10, 3 * unit(random)), ply.G12 = std::pow(10, -2 * unit(random));
    LaminateStiffness of;
    double z = 2 * unit(random) - 1;
    const bool symmetric = i % 3 == 0;
    const double a = angle_of(random), b = angle_of(random);
    for (const double angle : {a, b, symmetric ? b : angle_of(random), symmetric ? a : angle_of(random)}) {
      const double h = symmetric ? 0.2 : 0.3 * unit(random);
      of.add(h, z + 0.5 * h, turned_back(ply.plane_stiffness(), turn_by_degrees(angle)));
      z += h;
    }
    strike::detail::SectionIntegrals bounds;
    strike::detail::bound_moduli(of, bounds);
    const auto iso = [&](const PlaneModuli<double>& m) { return orthonormal(strike::detail::plane_stiffness(m)); };
    Eigen::Matrix<double, 6, 6> M, bound;
    M << orthonormal(of.A), orthonormal(of.B), orthonormal(of.B), orthonormal(of.D);
    bound << iso(bounds.extension), iso(bounds.coupling), iso(bounds.coupling), iso(bounds.bending);
    const Eigen::Matrix<double, 6, 6> over = bound - M;
    CHECK(over.selfadjointView<Eigen::Upper>().eigenvalues()(0) >= -1e-10 * M.norm());
    if (symmetric)
      CHECK(bounds.extension.normal <= orthonormal(of.A).selfadjointView<Eigen::Upper>().eigenvalues()(2) * (1 + 1e-9));
  }
}

namespace {

/// Pagano (1969, 1970): orthotropic layers at 0 or 90 degrees in cylindrical bending along x under sigma_z = sin px on
/// the top, exactly, by the state (U, W, S, T) of the two faces: the deflection of the middle.
struct PaganoStrip {
  std::vector<double> angles;
  double thickness = 1;

  double deflection(double p) const {
    Eigen::Matrix4d all = Eigen::Matrix4d::Identity(), half = all;
    const double h = thickness / static_cast<double>(angles.size());
    for (std::size_t k = 0; k < angles.size(); ++k)
      for (int i = 0; i < 2; ++i) {
        all = exponential(0.5 * h * slope(angles[k], p)) * all;
        if (2 * k + static_cast<std::size_t>(i) + 1 == angles.size()) half = all;
      }
    const Eigen::Vector2d bottom = all.bottomLeftCorner<2, 2>().partialPivLu().solve(Eigen::Vector2d(1, 0));
    return (half * Eigen::Vector4d(bottom(0), bottom(1), 0, 0))(1);
  }

 private:
  /// d/dz of u = U cos px, w = W sin px, sigma_z = S sin px, tau_xz = T cos px, in plane strain.
  static Eigen::Matrix4d slope(double angle, double p) {
    const auto& ply = pagano_ply;
    Eigen::Matrix3d S;  // of (1, 2, 3)
    S << 1 / ply.E1, -ply.nu12 / ply.E1, -ply.nu12 / ply.E1, -ply.nu12 / ply.E1, 1 / ply.E2, -ply.nu23 / ply.E2,
        -ply.nu12 / ply.E1, -ply.nu23 / ply.E2, 1 / ply.E2;
    const Eigen::Matrix3d C = S.inverse();
    const int x = angle == 0 ? 0 : 1;
    const double C11 = C(x, x), C13 = C(x, 2), C33 = C(2, 2), G = angle == 0 ? ply.G13 : ply.G23;
    Eigen::Matrix4d A;
    A << 0, -p, 0, 1 / G,                                       // U' = T/G - p W
        p * C13 / C33, 0, 1 / C33, 0,                           // S = C33 W' - C13 p U
        0, 0, 0, p,                                             // S' = p T
        p * p * (C11 - C13 * C13 / C33), 0, -p * C13 / C33, 0;  // T' = -p X, X = C13/C33 S - (C11 - C13^2/C33) p U
    return A;
  }
  static Eigen::Matrix4d exponential(Eigen::Matrix4d A) {
    int n = 0;
    for (; A.norm() > 0.5; ++n) A *= 0.5;
    Eigen::Matrix4d E = Eigen::Matrix4d::Identity(), term = E;
    for (int k = 1; k <= 16; ++k) term = term * A / k, E += term;
    for (; n > 0; --n) E = E * E;
    return E;
  }
};

}  // namespace

// Pagano (1970): three plies under sin px, w 100 E2 h^3/(q l^4); his figures are read to the digits that are given.
TEST_CASE("laminate shear: three plies in cylindrical bending against Pagano's elasticity") {
  const PaganoStrip strip{{0, 90, 0}};
  struct Row {
    double S, exact, plate;  // plate over elasticity
  };
  for (const auto& [S, exact, plate] : {Row{4, 2.887, 1.1178}, Row{10, 0.932, 1.0138}, Row{50, 0.527, 1.0001}}) {
    const double p = std::numbers::pi / S;
    const double w = strip.deflection(p), scale = 100 / (S * S * S * S);
    CHECK(w * scale == Approx(exact).margin(6e-4));
    const ClassicalLaminate laminate(pagano_ply, 1. / 3, strip.angles);
    const Matrix2 K = shear_of(laminae(pagano_ply, 1. / 3, strip.angles));
    const double plate_w = 1 / (p * p * p * p * laminate.D(0, 0)) + 1 / (p * p * K(0, 0));
    CAPTURE(S, w * scale, plate_w / w);
    CHECK(plate_w / w == Approx(plate).margin(1e-4));
  }
}
