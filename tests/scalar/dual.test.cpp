#include <cmath>
#include <limits>
#include <type_traits>

#include <strike/scalar/dual.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(sizeof(Dual<double, 3>) == 4 * sizeof(double));
static_assert(sizeof(Dual<Pack<double, 8>, 24>) == 25 * sizeof(Pack<double, 8>));
static_assert(std::is_trivially_copyable_v<Dual<double, 3>>);
static_assert(std::is_trivially_default_constructible_v<Dual<double, 3>>);
static_assert(std::is_convertible_v<double, Dual<Dual<double, 2>, 2>>);
static_assert(std::is_convertible_v<Pack<double, 8>, Dual<Pack<double, 8>, 2>>);
static_assert(!std::is_convertible_v<Dual<double, 2>, double>);
static_assert(!std::is_convertible_v<Dual<double, 2>, Dual<double, 3>>);
static_assert(!std::is_convertible_v<Dual<double, 2>, bool>);

namespace {

using D = Dual<double, 2>;
using DD = Dual<D, 2>;
using P = Pack<double, 4>;
using DP = Dual<P, 2>;

constexpr double rounding = 1e-14;  // a few operations of 2 ulp each

/// df/dx at x by dual numbers.
template <class F>
double slope(F f, double x) {
  return f(D::variable(x, 0)).derivative(0);
}
/// d2f/dx2 at x by dual numbers of dual numbers.
template <class F>
double curvature(F f, double x) {
  return f(DD::variable(D::variable(x, 0), 0)).derivative(0).derivative(0);
}

Approx near(double x) { return Approx(x).epsilon(rounding).margin(rounding); }

const double points[] = {0.03, 0.4, 1, 1.7, 2, 30};

}  // namespace

TEST_CASE("A variable has derivative 1 by itself and 0 by the others, a constant has none") {
  const D x = D::variable(3, 1);
  CHECK(x.value() == 3);
  CHECK(x.derivative(0) == 0);
  CHECK(x.derivative(1) == 1);
  const D c = 4;
  CHECK(c.value() == 4);
  CHECK(c.derivative(0) == 0);
  CHECK(c.derivative(1) == 0);
  const D g{2, {5, 6}};
  CHECK(g.derivative(1) == 6);
}

TEST_CASE("Each function has its derivative and second derivative") {
  for (const double x : points) {
    CAPTURE(x);
    const auto root = [](const auto& u) { return sqrt(u); };
    CHECK(slope(root, x) == near(0.5 / std::sqrt(x)));
    CHECK(curvature(root, x) == near(-0.25 / (x * std::sqrt(x))));
    const auto inverse_root = [](const auto& u) { return rsqrt(u); };
    CHECK(slope(inverse_root, x) == near(-0.5 / (x * std::sqrt(x))));
    CHECK(curvature(inverse_root, x) == near(0.75 / (x * x * std::sqrt(x))));
    for (const double sign : {1., -1.}) {
      const auto cube_root = [](const auto& u) { return cbrt(u); };
      CHECK(slope(cube_root, sign * x) == near(1 / (3 * std::cbrt(x * x))));
      CHECK(curvature(cube_root, sign * x) == near(-sign * 2 / (9 * std::cbrt(x * x) * x)));
    }
    const auto exponential = [](const auto& u) { return exp(u); };
    CHECK(slope(exponential, x) == near(std::exp(x)));
    CHECK(curvature(exponential, x) == near(std::exp(x)));
    const auto logarithm = [](const auto& u) { return log(u); };
    CHECK(slope(logarithm, x) == near(1 / x));
    CHECK(curvature(logarithm, x) == near(-1 / (x * x)));
    for (const double n : {0.26, -1.5, 1., 2., 3.}) {
      const auto power = [n](const auto& u) { return pow(u, n); };
      CHECK(slope(power, x) == near(n * std::pow(x, n - 1)));
      CHECK(curvature(power, x) == near(n * (n - 1) * std::pow(x, n - 2)));
    }
    const auto raised = [](const auto& u) { return pow(1.3, u); };
    CHECK(slope(raised, x) == near(std::log(1.3) * std::pow(1.3, x)));
    CHECK(curvature(raised, x) == near(std::log(1.3) * std::log(1.3) * std::pow(1.3, x)));
    const auto inverse = [](const auto& u) { return 1 / u; };
    CHECK(slope(inverse, x) == near(-1 / (x * x)));
    CHECK(curvature(inverse, x) == near(2 / (x * x * x)));
  }
}

TEST_CASE("pow has both partial derivatives, and a Hessian that is symmetric") {
  for (const double x : points)
    for (const double y : {-1.2, 0., 0.3, 2.}) {
      CAPTURE(x, y);
      const DD u = DD::variable(D::variable(x, 0), 0), v = DD::variable(D::variable(y, 1), 1);
      const DD f = pow(u, v);
      const double p = std::pow(x, y), l = std::log(x);
      CHECK(f.value().value() == near(p));
      CHECK(f.derivative(0).value() == near(y * p / x));
      CHECK(f.derivative(1).value() == near(p * l));
      CHECK(f.derivative(0).derivative(0) == near(y * (y - 1) * p / (x * x)));
      CHECK(f.derivative(1).derivative(1) == near(p * l * l));
      CHECK(f.derivative(0).derivative(1) == near((1 + y * l) * p / x));
      CHECK(f.derivative(1).derivative(0) == near((1 + y * l) * p / x));
    }
}

TEST_CASE("Products follow Leibniz's rule, quotients theirs, compositions the chain rule") {
  const D x = D::variable(0.7, 0), y = D::variable(1.9, 1);
  const D f = exp(x) * y + sqrt(y), g = log(x + y) - x;
  const D product = f * g, quotient = f / g, composition = exp(f);
  for (std::size_t i = 0; i < 2; ++i) {
    const double df = f.derivative(i), dg = g.derivative(i);
    CHECK((f + g).derivative(i) == df + dg);
    CHECK((f - g).derivative(i) == df - dg);
    CHECK(product.derivative(i) == near(df * g.value() + f.value() * dg));
    CHECK(quotient.derivative(i) == near((df * g.value() - f.value() * dg) / (g.value() * g.value())));
    CHECK(composition.derivative(i) == near(std::exp(f.value()) * df));
  }
  // Leibniz's rule of second order: (fg)'' = f'' g + 2 f' g' + f g''
  const auto u = [](const auto& t) { return exp(2 * t); };
  const auto v = [](const auto& t) { return t * t * t; };
  const double t = 0.8, e = std::exp(2 * t);
  CHECK(curvature([&](const auto& s) { return u(s) * v(s); }, t) ==
        near(4 * e * t * t * t + 2 * (2 * e) * (3 * t * t) + e * (6 * t)));
}

TEST_CASE("What is inverse stays inverse: the derivative is that of x") {
  for (const double x : points) {
    CAPTURE(x);
    for (const D& same : {log(exp(D::variable(x, 0))), exp(log(D::variable(x, 0))), pow(cbrt(D::variable(x, 0)), 3),
                          sqrt(D::variable(x, 0)) * sqrt(D::variable(x, 0)), 1 / (1 / D::variable(x, 0))}) {
      CHECK(same.value() == near(x));
      CHECK(same.derivative(0) == near(1));
      CHECK(same.derivative(1) == 0);
    }
  }
}

TEST_CASE("A homogeneous function of degree k obeys Euler's theorem x f,x + y f,y = k f") {
  const D x = D::variable(1.3, 0), y = D::variable(0.4, 1);
  const D norm = sqrt(x * x + y * y);
  CHECK(1.3 * norm.derivative(0) + 0.4 * norm.derivative(1) == near(norm.value()));
  const D degree_minus_2 = pow(x, 0.5) / pow(y, 2.5);
  CHECK(1.3 * degree_minus_2.derivative(0) + 0.4 * degree_minus_2.derivative(1) == near(-2 * degree_minus_2.value()));
}

TEST_CASE("A kink has the derivative of the branch that is taken") {
  CHECK(slope([](const D& x) { return abs(x); }, 2) == 1);
  CHECK(slope([](const D& x) { return abs(x); }, -2) == -1);
  CHECK(slope([](const D& x) { return abs(x); }, 0) == 1);
  const D x = D::variable(2, 0), y = D::variable(3, 1);
  CHECK(min(x, y).derivative(0) == 1);
  CHECK(min(x, y).derivative(1) == 0);
  CHECK(max(x, y).derivative(1) == 1);
  CHECK(max(x, 5).derivative(0) == 0);
  CHECK(min(x, 2).derivative(0) == 1);  // of equals the first
  CHECK(select(x < y, x * x, y).derivative(0) == 4);
  CHECK(select(x > y, x * x, 7).derivative(0) == 0);
}

TEST_CASE("select never leaks the derivative of the branch that is not taken") {
  const D x = D::variable(0, 0);
  const D safe = select(x > 0, sqrt(x), x);  // sqrt has slope inf at 0
  CHECK(safe.value() == 0);
  CHECK(safe.derivative(0) == 1);
  CHECK(safe.derivative(1) == 0);
}

TEST_CASE("A function keeps its value where its slope is infinite") {
  const D x = D::variable(0, 0);
  CHECK(sqrt(x).value() == 0);
  CHECK(std::isinf(sqrt(x).derivative(0)));
  CHECK(cbrt(x).value() == 0);
  CHECK(pow(x, 0.3).value() == 0);
  CHECK(std::isinf(pow(x, 0.3).derivative(0)));
  CHECK(std::isinf(log(x).value()));
}

TEST_CASE("pow is smooth at 0 and below where it is a polynomial, also with a variable type of exponent") {
  const D x = D::variable(0, 0), negative = D::variable(-2, 0);
  CHECK(pow(x, 0).value() == 1);
  CHECK(pow(x, 0).derivative(0) == 0);
  CHECK(pow(x, 1).derivative(0) == 1);
  CHECK(pow(x, 2).derivative(0) == 0);
  CHECK(pow(x, D(2)).derivative(0) == 0);
  CHECK(pow(negative, 3).derivative(0) == 12);
  CHECK(pow(negative, D(3)).value() == -8);
  CHECK(pow(negative, D(3)).derivative(0) == 12);
  CHECK(pow(0, D::variable(2, 0)).value() == 0);
  CHECK(pow(0, D::variable(2, 0)).derivative(0) == 0);
}

TEST_CASE("A constant has no derivative that infinity could spoil") {
  const double inf = std::numeric_limits<double>::infinity();
  const D x = D::variable(2, 0);
  CHECK((x * inf).derivative(1) != 0);  // 0 inf in the direction of y: x does not move, and neither rule can know
  CHECK((x / inf).derivative(0) == 0);
  CHECK((x + inf).derivative(0) == 1);
  CHECK((inf - x).derivative(0) == -1);
  CHECK((D::variable(inf, 0) * 2).derivative(0) == 2);
  CHECK((2 * D::variable(inf, 0)).derivative(1) == 0);
  CHECK((D::variable(inf, 0) + D(1)).derivative(0) == 1);
}

TEST_CASE("Literals and values stand beside duals on either side of every operator") {
  D x = D::variable(2, 0);
  x += 1;
  x -= 0.5f;
  x *= 2;
  x /= 4.0;
  CHECK(x.value() == 1.25);
  CHECK(x.derivative(0) == 0.5);
  x *= x;
  CHECK(x.derivative(0) == 1.25);
  x += D(1);
  CHECK((1 - x).derivative(0) == -1.25);
  CHECK((2 / D::variable(2, 0)).derivative(0) == -0.5);
  CHECK(+x == x);
  CHECK((-x).derivative(0) == -1.25);
  CHECK((x > 1 && 1 < x && x >= 1 && 1 <= x && x != 1 && !(x == 1)));
  const DP p = DP::variable(P(2), 0);
  CHECK(all((P(3) * p).derivative(0) == 3));
  CHECK(all((p - P(3)).value() == -1));
  CHECK(all(p > 1.0));
  const DD q = DD::variable(D::variable(2, 0), 0);
  CHECK((D(3) * q).derivative(0).value() == 3);
  CHECK((q * 3).derivative(0).value() == 3);
}

TEST_CASE("Lane i of a dual of packs is the dual of lane i") {
  const auto f = [](const auto& x, const auto& y) {
    return select(x < y, pow(x, y) * exp(-x), log(x) / y) + abs(x - y) * cbrt(y) - min(x, 2 * y) + sqrt(max(x, y));
  };
  const P x = P::generate([](std::size_t lane) { return 0.3 + double(lane); });
  const DP together = f(DP::variable(x, 0), DP::variable(P(1.7), 1));
  for (std::size_t i = 0; i < P::size(); ++i) {
    const D alone = f(D::variable(x[i], 0), D::variable(1.7, 1)), in_lane = lane(together, i);
    CHECK(in_lane.value() == near(alone.value()));
    CHECK(in_lane.derivative(0) == near(alone.derivative(0)));
    CHECK(in_lane.derivative(1) == near(alone.derivative(1)));
  }
  static_assert(std::is_same_v<decltype(DP() < DP(1)), Mask<double, 4>>);
  static_assert(std::is_same_v<decltype(D() < D(1)), bool>);
}

TEST_CASE("A dual of packs reduces with its derivatives") {
  const P x = P::generate([](std::size_t lane) { return double(lane) - 1.5; });
  const DP square = DP::variable(x, 1) * DP::variable(x, 1);
  CHECK(reduce_sum(square).value() == 5);
  CHECK(reduce_sum(square).derivative(1) == 0);
  CHECK(reduce_min(square).derivative(1) == -1);
  CHECK(reduce_max(square).derivative(1) == -3);  // the first of equals
  CHECK(reduce_sum(D::variable(3, 0)).derivative(0) == 1);
}
