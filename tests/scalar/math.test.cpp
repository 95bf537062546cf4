// exp, log, pow, cbrt and rsqrt of a Pack against long double, whose 64 bits are exact to 0.001 ulp of a double.
#include <cmath>
#include <limits>
#include <vector>

#include <strike/scalar/math.hpp>

#include "scalar/samples.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace scalar_test;

namespace {

constexpr double bound = 2;  // ulp, as math.hpp and pack.hpp promise; 1.7 measured

using Doubles1 = Pack<double, 1>;
using Doubles2 = Pack<double, 2>;
using Doubles4 = Pack<double, 4>;
using Doubles8 = Pack<double, 8>;
using Doubles16 = Pack<double, 16>;
using Floats2 = Pack<float, 2>;
using Floats4 = Pack<float, 4>;
using Floats8 = Pack<float, 8>;
using Floats16 = Pack<float, 16>;
using Floats32 = Pack<float, 32>;

struct Deviation {
  double ulps = 0;
  double x = 0;
  double y = 0;
};

template <class P>
using Number = typename P::value_type;

/// The largest error of f over the samples.
template <class P, class F, class Exact>
Deviation worst(F f, Exact exact, const std::vector<Number<P>>& samples) {
  Deviation worst;
  for (std::size_t i = 0; i < samples.size(); i += P::size()) {
    const P x = P::generate([&](std::size_t lane) { return samples[(i + lane) % samples.size()]; });
    const P result = f(x);
    for (std::size_t lane = 0; lane < P::size(); ++lane) {
      const double error = ulps(result[lane], exact(static_cast<long double>(x[lane])));
      if (error > worst.ulps) worst = {error, static_cast<double>(x[lane]), 0};
    }
  }
  return worst;
}

template <class P>
Deviation worst_pow(const std::vector<Number<P>>& xs, const std::vector<Number<P>>& ys) {
  Deviation worst;
  for (std::size_t i = 0; i < xs.size(); i += P::size()) {
    const P x = P::generate([&](std::size_t lane) { return xs[(i + lane) % xs.size()]; });
    const P y = P::generate([&](std::size_t lane) { return ys[(i + lane) % ys.size()]; });
    const P result = pow(x, y);
    for (std::size_t lane = 0; lane < P::size(); ++lane) {
      const double error =
          ulps(result[lane], std::pow(static_cast<long double>(x[lane]), static_cast<long double>(y[lane])));
      if (error > worst.ulps) worst = {error, static_cast<double>(x[lane]), static_cast<double>(y[lane])};
    }
  }
  return worst;
}

#define CHECK_WITHIN_BOUND(error_) \
  do {                             \
    const Deviation e = error_;    \
    CAPTURE(e.ulps, e.x, e.y);     \
    CHECK(e.ulps <= bound);        \
  } while (false)

}  // namespace

TEMPLATE_TEST_CASE("exp is right to 2 ulp, denormal results included", "", Doubles1, Doubles2, Doubles4, Doubles8,
                   Doubles16, Floats2, Floats4, Floats8, Floats16, Floats32) {
  using T = Number<TestType>;
  const auto f = [](const TestType& x) { return exp(x); };
  const auto exact = [](long double x) { return std::exp(x); };
  const double overflow = std::log(static_cast<double>(std::numeric_limits<float>::max())) * (sizeof(T) == 8 ? 8 : 1);
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, extremes<T>()));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, any<T>(20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(-1, 1, 20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(-1.1 * overflow, 1.1 * overflow, 20000)));
}

TEMPLATE_TEST_CASE("log is right to 2 ulp, denormal arguments included", "", Doubles1, Doubles2, Doubles4, Doubles8,
                   Doubles16, Floats2, Floats4, Floats8, Floats16, Floats32) {
  using T = Number<TestType>;
  const auto f = [](const TestType& x) { return log(x); };
  const auto exact = [](long double x) { return std::log(x); };
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, extremes<T>()));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, any<T>(20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(0.5, 2, 20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(1 - 1e-5, 1 + 1e-5, 20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(0, double(std::numeric_limits<T>::min()), 20000)));
}

TEMPLATE_TEST_CASE("rsqrt is right to 2 ulp, of 0 and of denormals too", "", Doubles1, Doubles2, Doubles4, Doubles8,
                   Doubles16, Floats2, Floats4, Floats8, Floats16, Floats32) {
  using T = Number<TestType>;
  const auto f = [](const TestType& x) { return rsqrt(x); };
  const auto exact = [](long double x) { return 1 / std::sqrt(x); };
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, extremes<T>()));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, any<T>(20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(1, 4, 20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(0, double(std::numeric_limits<T>::min()), 20000)));
}

TEMPLATE_TEST_CASE("cbrt is right to 2 ulp", "", Doubles1, Doubles2, Doubles4, Doubles8, Doubles16, Floats2, Floats4,
                   Floats8, Floats16, Floats32) {
  using T = Number<TestType>;
  const auto f = [](const TestType& x) { return cbrt(x); };
  const auto exact = [](long double x) { return std::cbrt(x); };
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, extremes<T>()));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, any<T>(20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(1, 8, 20000)));
  CHECK_WITHIN_BOUND(worst<TestType>(f, exact, between<T>(0, double(std::numeric_limits<T>::min()), 20000)));
}

TEMPLATE_TEST_CASE("pow is right to 2 ulp wherever the result is a number", "", Doubles1, Doubles2, Doubles4, Doubles8,
                   Doubles16, Floats2, Floats4, Floats8, Floats16, Floats32) {
  using T = Number<TestType>;
  constexpr std::size_t n = 20000;
  CHECK_WITHIN_BOUND(worst_pow<TestType>(any<T>(n, 1), any<T>(n, 2)));
  CHECK_WITHIN_BOUND(worst_pow<TestType>(between<T>(0, 2, n, 3), any<T>(n, 4)));
  CHECK_WITHIN_BOUND(worst_pow<TestType>(between<T>(0, 2, n, 5), between<T>(1, 0, n, 6)));  // laws of hardening

  // y log2 x over its whole range, where an error in the logarithm is magnified a thousand times
  const double lowest = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  const double highest = std::numeric_limits<T>::max_exponent;
  for (const auto& x : {any<T>(n, 7), between<T>(0.5, 2, n, 8), between<T>(0.99, 1.01, n, 9)}) {
    std::vector<T> base(n), exponent = between<T>(lowest, highest, n, 10);
    std::shuffle(exponent.begin(), exponent.end(), std::mt19937_64(11));
    for (std::size_t i = 0; i < n; ++i) {
      base[i] = std::isfinite(x[i]) ? std::abs(x[i]) : 3;
      exponent[i] /= static_cast<T>(std::log2(static_cast<long double>(base[i])));
    }
    CHECK_WITHIN_BOUND(worst_pow<TestType>(base, exponent));
  }
}

TEMPLATE_TEST_CASE("pow has the special values of C, for each pair of extremes", "", Doubles4, Doubles8, Floats4,
                   Floats16) {
  using T = Number<TestType>;
  std::vector<T> x, y;
  for (const T a : extremes<T>())
    for (const T b : extremes<T>()) {
      x.push_back(a);
      y.push_back(b);
    }
  CHECK_WITHIN_BOUND(worst_pow<TestType>(x, y));
}

TEMPLATE_TEST_CASE("pow takes whole powers of negative numbers", "", Doubles8, Floats16) {
  using T = Number<TestType>;
  auto y = between<T>(-30, 30, 20000);
  for (T& y_i : y) y_i = std::floor(y_i);
  std::shuffle(y.begin(), y.end(), std::mt19937_64(1));
  CHECK_WITHIN_BOUND(worst_pow<TestType>(between<T>(-10, 10, 20000), y));
}

TEST_CASE("exp, log and pow run into infinity, zero and NaN as the formulas need") {
  const double inf = std::numeric_limits<double>::infinity();
  using P = Pack<double, 8>;
  CHECK(all(exp(P(710)) == P(inf)));
  CHECK(all(exp(P(-746)) == P(0)));
  CHECK(all(exp(P(0)) == P(1)));
  CHECK(all(log(P(0)) == P(-inf)));
  CHECK(all(log(P(1)) == P(0)));
  CHECK(std::isnan(log(P(-1))[0]));
  CHECK(all(pow(P(0), 0.3) == P(0)));
  CHECK(all(pow(P(0), 0) == P(1)));
  CHECK(all(pow(P(0), -1) == P(inf)));
  CHECK(all(pow(P(-8), 3) == P(-512)));
  CHECK(all(pow(P(inf), 0.3) == P(inf)));
  CHECK(std::isnan(pow(P(-8), 1.0 / 3)[0]));
  CHECK(all(cbrt(P(-8)) == P(-2)));
}

TEST_CASE("pow takes literals on either side") {
  using P = Pack<float, 8>;
  CHECK(all(pow(P(3), 2) == P(9)));
  CHECK(all(pow(3, P(2)) == P(9)));
  CHECK(all(pow(3.0, P(2)) == P(9)));
  const P x = P::generate([](std::size_t lane) { return double(lane) - 3; });
  for (const double y : {0., 0.3, 1., -2., 3.}) {
    const P by_number = pow(x, y), by_pack = pow(x, P(y));
    CHECK(all(by_number == by_pack || (by_number != by_number && by_pack != by_pack)));
  }
}

TEMPLATE_TEST_CASE("A function of one lane does not depend on the others", "", Doubles8, Floats16) {
  using T = Number<TestType>;
  const auto samples = any<T>(4000, 3);
  for (std::size_t i = 0; i + TestType::size() <= samples.size(); i += TestType::size()) {
    const TestType x = TestType::generate([&](std::size_t lane) { return samples[i + lane]; });
    const TestType y = TestType::generate([&](std::size_t lane) { return samples[samples.size() - 1 - i - lane]; });
    const TestType together[] = {exp(x), log(x), cbrt(x), pow(x, y)};
    for (std::size_t lane = 0; lane < TestType::size(); ++lane) {
      const TestType alone[] = {exp(TestType(x[lane])), log(TestType(x[lane])), cbrt(TestType(x[lane])),
                                pow(TestType(x[lane]), TestType(y[lane]))};
      for (int f = 0; f < 4; ++f) {
        const T a = together[f][lane], b = alone[f][0];
        if (!(std::isnan(a) && std::isnan(b))) CHECK(std::bit_cast<Bits<T>>(a) == std::bit_cast<Bits<T>>(b));
      }
    }
  }
}
