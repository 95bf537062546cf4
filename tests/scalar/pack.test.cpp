#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <strike/scalar/pack.hpp>

#include "scalar/samples.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace scalar_test;

// A Pack is its numbers and nothing else.
static_assert(sizeof(Pack<double, 1>) == 8);
static_assert(sizeof(Pack<double, 2>) == 16);
static_assert(sizeof(Pack<double, 4>) == 32);
static_assert(sizeof(Pack<double, 8>) == 64);
static_assert(sizeof(Pack<double, 16>) == 128);
static_assert(sizeof(Pack<float, 8>) == 32);
static_assert(sizeof(Pack<float, 16>) == 64);
static_assert(sizeof(Mask<double, 8>) == 64);
static_assert(sizeof(Mask<float, 8>) == 32);
static_assert(sizeof(Pack<double>) == sizeof(Pack<float>));  // one register of the machine
static_assert(std::is_trivially_copyable_v<Pack<double, 8>>);
static_assert(std::is_trivially_default_constructible_v<Pack<double, 8>>);
static_assert(Pack<float, 16>::size() == 16);

// Literals convert by themselves; packs of another size or number do not, and a mask is no number.
static_assert(std::is_convertible_v<double, Pack<float, 8>>);
static_assert(std::is_convertible_v<int, Pack<double, 8>>);
static_assert(!std::is_convertible_v<Pack<double, 4>, Pack<double, 8>>);
static_assert(!std::is_convertible_v<Pack<float, 8>, Pack<double, 8>>);
static_assert(!std::is_convertible_v<Mask<double, 8>, Pack<double, 8>>);
static_assert(!std::is_convertible_v<Mask<double, 8>, bool>);
static_assert(!std::is_convertible_v<Pack<double, 8>, double>);

namespace {

using Doubles1 = Pack<double, 1>;
using Doubles4 = Pack<double, 4>;
using Doubles8 = Pack<double, 8>;
using Doubles16 = Pack<double, 16>;
using Floats2 = Pack<float, 2>;
using Floats8 = Pack<float, 8>;
using Floats16 = Pack<float, 16>;

/// The same bits, or both NaN.
template <class T>
bool same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<Bits<T>>(a) == std::bit_cast<Bits<T>>(b);
}

template <class P>
P load(const std::vector<typename P::value_type>& x, std::size_t first) {
  return P::generate([&](std::size_t lane) { return x[(first + lane) % x.size()]; });
}

}  // namespace

TEMPLATE_TEST_CASE("Lane i of a pack gives what the number gives, bit for bit", "", Doubles1, Doubles4, Doubles8,
                   Doubles16, Floats2, Floats8, Floats16) {
  using P = TestType;
  using T = typename P::value_type;
  const auto check = [](const P& a, const P& b) {
    const P sum = a + b, difference = a - b, product = a * b, quotient = a / b, opposite = -a, root = sqrt(a),
            size = abs(a), less = min(a, b), more = max(a, b), chosen = select(a < b, a, b);
    const auto below = a<b, not_above = a <= b, above = a> b, not_below = a >= b, equal = a == b, other = a != b;
    bool good = true;
    for (std::size_t i = 0; i < P::size(); ++i) {
      const T x = a[i], y = b[i];
      good = good && same<T>(sum[i], x + y) && same<T>(difference[i], x - y) && same<T>(product[i], x * y) &&
             same<T>(quotient[i], x / y) && same<T>(opposite[i], -x) && same<T>(root[i], std::sqrt(x)) &&
             same<T>(size[i], std::abs(x)) && same<T>(less[i], strike::min(x, y)) &&
             same<T>(more[i], strike::max(x, y)) && same<T>(chosen[i], x < y ? x : y);
      good = good && below[i] == (x < y) && not_above[i] == (x <= y) && above[i] == (x > y) &&
             not_below[i] == (x >= y) && equal[i] == (x == y) && other[i] == (x != y);
    }
    return good;
  };
  const auto special = extremes<T>();
  for (std::size_t i = 0; i < special.size(); ++i)
    for (std::size_t j = 0; j < special.size(); ++j) CHECK(check(load<P>(special, i), load<P>(special, j)));
  const auto x = scalar_test::any<T>(4096, 1), y = scalar_test::any<T>(4096, 2);
  for (std::size_t i = 0; i < x.size(); i += P::size()) CHECK(check(load<P>(x, i), load<P>(y, i)));
}

TEMPLATE_TEST_CASE("select never leaks the branch that is not taken", "", Doubles4, Doubles8, Floats16) {
  using P = TestType;
  using T = typename P::value_type;
  const P x = P::generate([](std::size_t lane) { return lane % 2 == 0 ? 4 : -4; });
  const P root = select(x > 0, sqrt(x), 0);  // sqrt(-4) is NaN
  const P ratio = select(x > 0, 1, 1 / (x - x));
  for (std::size_t i = 0; i < P::size(); i += 2) {
    CHECK(root[i] == T(2));
    CHECK(root[i + 1] == T(0));
    CHECK(ratio[i] == T(1));
    CHECK(std::isinf(ratio[i + 1]));
  }
}

TEMPLATE_TEST_CASE("Masks combine as bools do", "", Doubles1, Doubles4, Doubles16, Floats2, Floats16) {
  using P = TestType;
  using M = Mask<typename P::value_type, P::size()>;
  const P x = P::generate([](std::size_t lane) { return lane; });
  const M none = x < 0, every = x >= 0, last = x == P::size() - 1;
  CHECK_FALSE(any(none));
  CHECK(all(every));
  CHECK(any(last));
  CHECK(all(last) == (P::size() == 1));
  CHECK(all(!none));
  CHECK(all(none || every));
  CHECK_FALSE(any(none && every));
  CHECK(all(M(true)));
  CHECK_FALSE(any(M(false)));
  for (std::size_t i = 0; i < P::size(); ++i) {
    CHECK(last[i] == (i == P::size() - 1));
    CHECK((!last)[i] == (i != P::size() - 1));
  }
}

TEMPLATE_TEST_CASE("A pack reduces over its lanes", "", Doubles1, Doubles4, Doubles16, Floats2, Floats16) {
  using P = TestType;
  constexpr double n = P::size();
  const P x = P::generate([](std::size_t lane) { return (lane + 1) % P::size(); });  // 1, 2, ... n - 1, 0
  CHECK(reduce_sum(x) == n * (n - 1) / 2);
  CHECK(reduce_min(x) == 0);
  CHECK(reduce_max(x) == n - 1);
}

TEMPLATE_TEST_CASE("Literals stand in formulas on packs", "", Doubles8, Floats8) {
  TestType x = 3;
  x += 1;
  x -= 0.5;
  x *= 2;
  x /= 7.0;
  CHECK(all(x == 1));
  CHECK(all(2.5 * x + 1 == 3.5));
  CHECK(all((1 - x) / 2 < 0.5f));
  CHECK(all(min(x, 0.5) == 0.5));
  CHECK(all(max(2, x) == 2));
  CHECK(all(select(x > 0.5, 4, x) == 4));
}
