#pragma once
#include <array>
#include <cstddef>

#include <strike/scalar/bisect.hpp>

namespace strike {

namespace detail {

/// Legendre's polynomial P_n and its slope: (k + 1) P_k+1 = (2k + 1) x P_k - k P_k-1, P'_k+1 = P'_k-1 + (2k + 1) P_k.
struct Legendre {
  long double value = 1, slope = 0;
};
constexpr Legendre legendre(std::size_t n, long double x) {
  Legendre below{0, 0}, P;
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<long double>(k);
    const Legendre above{((2 * i + 1) * x * P.value - i * below.value) / (i + 1), below.slope + (2 * i + 1) * P.value};
    below = P, P = above;
  }
  return P;
}

/// The root between each two neighbours of an even or odd f, by bisection below 0 and mirrored above.
template <std::size_t n, class F>
constexpr std::array<long double, n> roots_between(const std::array<long double, n + 1>& neighbours, F f) {
  std::array<long double, n> roots{};
  for (std::size_t i = 0; i < n / 2; ++i) {
    const bool rises = f(neighbours[i + 1]) > 0;
    const Bracket<long double> between{neighbours[i], neighbours[i + 1]};
    roots[i] = bisect(
                   between, [&](long double x) { return (f(x) > 0) != rises; }, 66)
                   .middle();
    roots[n - 1 - i] = -roots[i];
  }
  return roots;
}

/// The roots of P_n, one between each two of P_n-1 and the ends.
template <std::size_t n>
constexpr std::array<long double, n> legendre_roots() {
  if constexpr (n == 0) {
    return {};
  } else {
    std::array<long double, n + 1> neighbours{-1};
    const auto inner = legendre_roots<n - 1>();
    for (std::size_t i = 0; i + 1 < n; ++i) neighbours[i + 1] = inner[i];
    neighbours[n] = 1;
    return roots_between<n>(neighbours, [](long double x) { return legendre(n, x).value; });
  }
}

/// f(i) for i = 0 ... n - 1.
template <std::size_t n, class F>
constexpr std::array<double, n> tabulated(F f) {
  std::array<double, n> table{};
  for (std::size_t i = 0; i < n; ++i) table[i] = static_cast<double>(f(i));
  return table;
}

}  // namespace detail

/// Simpson's rule over (n - 1)/2 equal parts, exact for polynomials of degree 3, with points on both faces. With 3
/// points it carries two thirds of the fully plastic moment, with 5 or 9 all of it.
template <std::size_t n>
struct Simpson {
  static_assert(n == 3 || n == 5 || n == 7 || n == 9, "strike: Simpson's rule comes with 3, 5, 7 or 9 points.");
  static constexpr auto points = detail::tabulated<n>(
      [](std::size_t i) { return -1 + 2 * static_cast<long double>(i) / static_cast<long double>(n - 1); });
  static constexpr auto weights = detail::tabulated<n>([](std::size_t i) {
    const long double parts = i == 0 || i + 1 == n ? 1 : i % 2 == 1 ? 4 : 2;
    return 2 * parts / (3 * static_cast<long double>(n - 1));
  });
};

/// Gauss' rule, exact for polynomials of degree 2n - 1: the roots of P_n, weights 2/((1 - x^2) P'_n^2) (Abramowitz and
/// Stegun 1964, 25.4.29).
template <std::size_t n>
struct Gauss {
  static_assert(n >= 2 && n <= 10, "strike: Gauss' rule comes with 2 to 10 points.");
  static constexpr auto points = detail::tabulated<n>([](std::size_t i) { return detail::legendre_roots<n>()[i]; });
  static constexpr auto weights = detail::tabulated<n>([](std::size_t i) {
    const long double x = detail::legendre_roots<n>()[i], slope = detail::legendre(n, x).slope;
    return 2 / ((1 - x * x) * slope * slope);
  });
};

/// Lobatto's rule, exact for polynomials of degree 2n - 3, with points on both faces: the ends and the roots of P'_n-1,
/// weights 2/(n (n - 1) P_n-1^2) (25.4.32).
template <std::size_t n>
struct Lobatto {
  static_assert(n >= 3 && n <= 10, "strike: Lobatto's rule comes with 3 to 10 points.");

 private:
  static constexpr long double point(std::size_t i) {
    if (i == 0 || i + 1 == n) return i == 0 ? -1 : 1;
    return detail::roots_between<n - 2>(detail::legendre_roots<n - 1>(),
                                        [](long double x) { return detail::legendre(n - 1, x).slope; })[i - 1];
  }

 public:
  static constexpr auto points = detail::tabulated<n>([](std::size_t i) { return point(i); });
  static constexpr auto weights = detail::tabulated<n>([](std::size_t i) {
    const long double P = detail::legendre(n - 1, point(i)).value;
    return 2 / (static_cast<long double>(n * (n - 1)) * P * P);
  });
};

}  // namespace strike
