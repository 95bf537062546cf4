#include <cmath>
#include <cstddef>

#include <strike/section/piece.hpp>
#include <strike/section/thickness_rule.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// The rule on x^k against 2/(k + 1), or 0 if k is odd.
template <class R>
double error(std::size_t k) {
  double sum = 0;
  for (std::size_t i = 0; i < R::points.size(); ++i)
    sum += R::weights[i] * std::pow(R::points[i], static_cast<double>(k));
  return sum - (k % 2 == 0 ? 2.0 / static_cast<double>(k + 1) : 0);
}

/// Exact up to its degree and no further, with rising points that mirror each other and positive weights.
template <class R>
void check(std::size_t degree) {
  constexpr std::size_t n = R::points.size();
  CAPTURE(n, degree);
  static_assert(ThicknessRule<R>);
  for (std::size_t k = 0; k <= degree; ++k) CHECK(std::abs(error<R>(k)) < 4e-16);
  CHECK(std::abs(error<R>(degree + 1)) > 1e-6);
  for (std::size_t i = 0; i < n; ++i) {
    CHECK(R::weights[i] > 0);
    CHECK(R::points[i] == -R::points[n - 1 - i]);
    CHECK(R::weights[i] == R::weights[n - 1 - i]);
    if (i > 0) CHECK(R::points[i] > R::points[i - 1]);
  }
}

}  // namespace

static_assert(!ThicknessRule<int> && !ThicknessRule<std::array<double, 3>>);
static_assert(Simpson<3>::weights[1] == 4.0 / 3 && Gauss<3>::points[1] == 0 && Lobatto<3>::points[0] == -1);

TEST_CASE("thickness rule: Simpson's integrate cubics") {
  check<Simpson<3>>(3);
  check<Simpson<5>>(3);
  check<Simpson<7>>(3);
  check<Simpson<9>>(3);
}

TEST_CASE("thickness rule: n points of Gauss integrate the degree 2n - 1") {
  check<Gauss<2>>(3);
  check<Gauss<3>>(5);
  check<Gauss<4>>(7);
  check<Gauss<5>>(9);
  check<Gauss<6>>(11);
  check<Gauss<7>>(13);
  check<Gauss<8>>(15);
  check<Gauss<9>>(17);
  check<Gauss<10>>(19);
  CHECK(Gauss<2>::points[1] == Approx(1 / std::sqrt(3.)).epsilon(3e-16));
  CHECK(Gauss<3>::points[2] == Approx(std::sqrt(.6)).epsilon(3e-16));
  CHECK(Gauss<3>::weights[1] == Approx(8. / 9).epsilon(3e-16));
}

TEST_CASE("thickness rule: n points of Lobatto, both ends among them, integrate the degree 2n - 3") {
  check<Lobatto<3>>(3);
  check<Lobatto<4>>(5);
  check<Lobatto<5>>(7);
  check<Lobatto<6>>(9);
  check<Lobatto<7>>(11);
  check<Lobatto<10>>(17);
  CHECK(Lobatto<4>::points[2] == Approx(std::sqrt(.2)).epsilon(3e-16));
  CHECK(Lobatto<5>::points[4] == 1);
  CHECK(Lobatto<5>::weights[1] == Approx(49. / 90).epsilon(3e-16));
}
