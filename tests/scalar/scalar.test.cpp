#include <array>
#include <complex>
#include <span>
#include <string>
#include <type_traits>

#include <Eigen/Core>

#include <strike/scalar.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using Eight = Pack<double, 8>;

struct AlmostScalar {  // arithmetic alone
  AlmostScalar(double);
  AlmostScalar operator+(AlmostScalar) const;
  AlmostScalar operator-(AlmostScalar) const;
  AlmostScalar operator*(AlmostScalar) const;
  AlmostScalar operator/(AlmostScalar) const;
  AlmostScalar operator-() const;
  bool operator<(AlmostScalar) const;
};

}  // namespace

static_assert(Scalar<double>);
static_assert(Scalar<float>);
static_assert(Scalar<Pack<double, 1>>);
static_assert(Scalar<Eight>);
static_assert(Scalar<Pack<double>>);
static_assert(Scalar<Pack<float, 16>>);
static_assert(Scalar<Dual<double, 3>>);
static_assert(Scalar<Dual<Eight, 24>>);
static_assert(Scalar<Dual<Dual<double, 2>, 2>>);
static_assert(Scalar<Dual<Dual<Pack<float, 8>, 2>, 2>>);

static_assert(!Scalar<int>);
static_assert(!Scalar<unsigned long>);
static_assert(!Scalar<bool>);
static_assert(!Scalar<char>);
static_assert(!Scalar<void>);
static_assert(!Scalar<double&>);
static_assert(!Scalar<const double>);
static_assert(!Scalar<double*>);
static_assert(!Scalar<std::string>);
static_assert(!Scalar<std::complex<double>>);
static_assert(!Scalar<Mask<double, 8>>);
static_assert(!Scalar<Eigen::Vector3d>);
static_assert(!Scalar<AlmostScalar>);

static_assert(lanes<double> == 1);
static_assert(lanes<Eight> == 8);
static_assert(lanes<Dual<Eight, 3>> == 8);
static_assert(lanes<Dual<Dual<double, 3>, 3>> == 1);
static_assert(std::is_same_v<RealOf<float>, float>);
static_assert(std::is_same_v<RealOf<Pack<float, 8>>, float>);
static_assert(std::is_same_v<RealOf<Dual<Eight, 3>>, double>);
static_assert(std::is_same_v<LaneOf<Eight>, double>);
static_assert(std::is_same_v<LaneOf<Dual<Eight, 3>>, Dual<double, 3>>);

TEST_CASE("min, max and select of built-in numbers take literals, int included, and keep the first of equals") {
  const double x = 0.5;
  CHECK(min(x, 1) == 0.5);
  CHECK(min(0, x) == 0);
  CHECK(max(x, 1) == 1);
  CHECK(max(0, x) == 0.5);
  CHECK(select(x < 1, x, 0) == 0.5);
  CHECK(select(x > 1, 1, x) == 0.5);
  CHECK(std::signbit(min(-0.0, 0.0)));
  CHECK(std::signbit(max(-0.0, 0.0)));
  static_assert(std::is_same_v<decltype(max(0, 1.0f)), float>);
}

TEST_CASE("The lanes of a scalar are read and written one by one") {
  double a = 1;
  set_lane(a, 0, 2);
  CHECK(lane(a, 0) == 2);

  Eight b = 1;
  set_lane(b, 3, 2);
  CHECK(lane(b, 3) == 2);
  CHECK(reduce_sum(b) == 9);

  Dual<Eight, 2> c = 1;
  set_lane(c, 3, Dual<double, 2>::variable(5, 1));
  CHECK(lane(c, 3).value() == 5);
  CHECK(lane(c, 3).derivative(1) == 1);
  CHECK(lane(c, 2).value() == 1);
  CHECK(lane(c, 2).derivative(1) == 0);
}

namespace {

/// Every function of the concept, in one formula.
template <Scalar T>
T formula(const T& x, const T& y) {
  const T a = sqrt(x * x + 0.25) - abs(y) / 3 + min(x, y) * max(x, 0.5);
  const T b = rsqrt(x * x + 4) + exp(-x) + log(2 + y * y) * cbrt(x - 7) - pow(x * x, 0.3) + pow(1.5, y);
  return select(a < b && !(x > 2.0), a * b, b - a);
}

}  // namespace

TEST_CASE("One formula runs on every scalar") {
  for (double x = -3; x < 3; x += 0.4)
    for (double y = -3; y < 3; y += 0.7) {
      const double exact = formula(x, y);
      // eleven functions of 2 ulp each, of terms up to 20; sums may be fused or not
      CHECK(formula(Eight(x), Eight(y))[5] == Approx(exact).epsilon(1e-14).margin(1e-14));
      CHECK(formula<Pack<float, 16>>(x, y)[5] == Approx(exact).epsilon(1e-5).margin(1e-5));
      CHECK(formula<Dual<double, 2>>(x, y).value() == Approx(exact).epsilon(1e-14).margin(1e-14));
      CHECK(formula<Dual<Eight, 2>>(x, y).value()[5] == Approx(exact).epsilon(1e-14).margin(1e-14));
    }
}

TEST_CASE("An aggregate of numbers is the range of them") {
  struct State {
    double a = 1;
    std::array<double, 2> b{2, 3};
    Eigen::Vector3d c{4, 5, 6};
  } state;
  const State& seen = state;
  static_assert(std::same_as<decltype(numbers_of<double>(seen)), std::span<const double, 6>>);
  for (double& number : numbers_of<double>(state)) number *= 10;
  CHECK(numbers_of<double>(seen)[0] == 10);
  CHECK(state.b[1] == 30);
  CHECK(state.c == Eigen::Vector3d(40, 50, 60));
}
