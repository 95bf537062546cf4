#include <strike/element/hex8_modes.hpp>

#include "conformance/element.hpp"
#include "element/nodal_hex8.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

using Modes = Hex8Modes<double>;

double dot(const Modes& a, const Modes& b) {
  return a.a1.dot(b.a1) + a.a2.dot(b.a2) + a.a3.dot(b.a3) + a.b1.dot(b.b1) + a.b2.dot(b.b2) + a.b3.dot(b.b3) +
         a.d.dot(b.d);
}

Modes modes_of(const Hex8Gradient<double>& g) { return {g.a1, g.a2, g.a3, g.b1, g.b2, g.b3, Vector3<double>::Zero()}; }

}  // namespace

TEST_CASE("the modes are the values of xi, eta, zeta and their products at the corners") {
  const auto x = unit_cube();
  Nodal<double, 8> field = Nodal<double, 8>::Zero();
  const auto mode_of = [&](auto f) {
    for (int I = 0; I < 8; ++I) field(0, I) = f(2 * x(0, I) - 1, 2 * x(1, I) - 1, 2 * x(2, I) - 1);
    return to_modes<double>(field);
  };
  const auto is = [](const Modes& m, Eigen::Matrix<double, 7, 1> expected) {
    Eigen::Matrix<double, 7, 1> found;
    found << m.a1(0), m.a2(0), m.a3(0), m.b1(0), m.b2(0), m.b3(0), m.d(0);
    return found == 8 * expected;
  };
  using U = Eigen::Matrix<double, 7, 1>;
  CHECK(is(mode_of([](double xi, double, double) { return xi; }), U::Unit(0)));
  CHECK(is(mode_of([](double, double eta, double) { return eta; }), U::Unit(1)));
  CHECK(is(mode_of([](double, double, double zeta) { return zeta; }), U::Unit(2)));
  CHECK(is(mode_of([](double, double eta, double zeta) { return eta * zeta; }), U::Unit(3)));
  CHECK(is(mode_of([](double xi, double, double zeta) { return zeta * xi; }), U::Unit(4)));
  CHECK(is(mode_of([](double xi, double eta, double) { return xi * eta; }), U::Unit(5)));
  CHECK(is(mode_of([](double xi, double eta, double zeta) { return xi * eta * zeta; }), U::Unit(6)));
  CHECK(is(mode_of([](double, double, double) { return 1; }), U::Zero()));
}

TEST_CASE("to_nodes is the transpose of to_modes") {
  testing::Shapes<8> shapes(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, 8> x = shapes.nodal();
    const Modes F{shapes.vector(), shapes.vector(), shapes.vector(), shapes.vector(),
                  shapes.vector(), shapes.vector(), shapes.vector()};
    CHECK(to_nodes(F).cwiseProduct(x).sum() == Approx(dot(F, to_modes<double>(x))).margin(1e-13));  // 168 terms
  }
}

TEST_CASE("in the modes the volume and the mean gradient are those of Flanagan and Belytschko") {
  testing::Shapes<8> shapes(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Nodal<double, 8> x = shapes(), v = shapes.nodal();
    const Hex8Gradient<double> g(to_modes<double>(x));
    const auto B = nodal_hex8::gradient(x);
    const double V = nodal_hex8::volume(x), rounding = 1e-14 * B.norm();
    CHECK(g.volume == Approx(V).epsilon(1e-13));
    CHECK((to_nodes(modes_of(g)) / 64 - B).norm() <= rounding);
    CHECK((g.gradient_of(to_modes<double>(v), 1 / V) - v * B.transpose() / V).norm() <= rounding / V * v.norm());
    const auto BB = (1 / 512.) * (g.squared_a() + g.squared_b());
    CHECK((BB.matrix() - B * B.transpose()).norm() <= rounding * B.norm());
  }
}
