#pragma once
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <Eigen/Geometry>  // a.cross(b), which Eigen/Core declares and does not define
#include <Eigen/LU>        // A.inverse(), A.determinant(), likewise

#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

template <class T>
inline constexpr bool is_composite = false;
template <class T, std::size_t N>
inline constexpr bool is_composite<Pack<T, N>> = true;
template <class T, std::size_t N>
inline constexpr bool is_composite<Dual<T, N>> = true;

/// A number that is made of others: a Pack or a Dual.
template <class T>
concept Composite = is_composite<T>;

/// A number that may stand beside S in Eigen's formulas: what S is made of, and every built-in number.
template <class U, class S>
concept Constituent = std::is_arithmetic_v<U> || std::same_as<U, typename S::value_type>;

/// An expression of Eigen: a vector, a matrix, a sum of them.
template <class E>
concept Expression = std::derived_from<E, Eigen::MatrixBase<E>>;

/// Two expressions of which a number is composite, and whose product is more than one number.
template <class A, class B>
concept CompositeFactors = Expression<A> && Expression<B> &&
                           (Composite<typename A::Scalar> || Composite<typename B::Scalar>)&&!(
                               int(A::RowsAtCompileTime) == 1 && int(B::ColsAtCompileTime) == 1);

/// Properties of a number S that Eigen reads; cost, in built-in operations, decides what it unrolls.
template <class S, int cost>
struct EigenTraits {
  using T = RealOf<S>;
  using Real = S;
  using NonInteger = S;
  using Nested = S;
  using Literal = S;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = cost,
    AddCost = cost,
    MulCost = cost,
  };
  static S epsilon() { return std::numeric_limits<T>::epsilon(); }
  static S dummy_precision() { return Eigen::NumTraits<T>::dummy_precision(); }
  static S highest() { return std::numeric_limits<T>::max(); }
  static S lowest() { return std::numeric_limits<T>::lowest(); }
  static S infinity() { return std::numeric_limits<T>::infinity(); }
  static S quiet_NaN() { return std::numeric_limits<T>::quiet_NaN(); }
  static int digits() { return std::numeric_limits<T>::digits; }
  static int digits10() { return std::numeric_limits<T>::digits10; }
  static int max_digits10() { return std::numeric_limits<T>::max_digits10; }
};

}  // namespace strike::detail

/// Packs and Duals are scalars of Eigen: `Eigen::Matrix<Pack<double, 8>, 3, 3>`, in whose formulas literals and
/// matrices of doubles may stand. A function that branches on a value (`normalized`, decompositions with pivots) needs
/// a scalar whose comparison is a bool, and does not compile for packs.
template <class T, std::size_t N>
struct Eigen::NumTraits<strike::Pack<T, N>> : strike::detail::EigenTraits<strike::Pack<T, N>, 1> {};
template <class T, std::size_t N>
struct Eigen::NumTraits<strike::Dual<T, N>> : strike::detail::EigenTraits<strike::Dual<T, N>, 2 * int(N) + 1> {};

template <class T, std::size_t N, strike::detail::Constituent<strike::Pack<T, N>> U, class Operation>
struct Eigen::ScalarBinaryOpTraits<strike::Pack<T, N>, U, Operation> {
  using ReturnType = strike::Pack<T, N>;
};
template <class T, std::size_t N, strike::detail::Constituent<strike::Pack<T, N>> U, class Operation>
struct Eigen::ScalarBinaryOpTraits<U, strike::Pack<T, N>, Operation> {
  using ReturnType = strike::Pack<T, N>;
};
template <class T, std::size_t N, strike::detail::Constituent<strike::Dual<T, N>> U, class Operation>
struct Eigen::ScalarBinaryOpTraits<strike::Dual<T, N>, U, Operation> {
  using ReturnType = strike::Dual<T, N>;
};
template <class T, std::size_t N, strike::detail::Constituent<strike::Dual<T, N>> U, class Operation>
struct Eigen::ScalarBinaryOpTraits<U, strike::Dual<T, N>, Operation> {
  using ReturnType = strike::Dual<T, N>;
};

namespace strike {

/// Product by coefficients, evaluated. Eigen's own products of many coefficients branch on values and mix no scalars.
template <class A, class B>
  requires detail::CompositeFactors<A, B>
auto operator*(const A& a, const B& b) {
  return a.lazyProduct(b).eval();
}

}  // namespace strike
