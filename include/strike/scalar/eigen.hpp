#pragma once
#include <cstddef>
#include <limits>

#include <Eigen/Core>

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

/// What may stand beside a number S in Eigen's formulas: what S is made of, and every built-in number.
template <class U, class S>
concept Constituent = is_composite<S> && (std::is_arithmetic_v<U> || std::same_as<U, typename S::value_type>);

/// What Eigen asks of a number S; cost, in built-in operations, decides what it unrolls.
template <class S, std::size_t cost>
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
  static int digits10() { return std::numeric_limits<T>::digits10; }
};

}  // namespace strike::detail

/// Packs and Duals are scalars of Eigen: `Eigen::Matrix<Pack<double, 8>, 3, 3>`, in whose formulas literals and
/// matrices of doubles may stand. What branches on a value (`normalized`, decompositions with pivots) needs a scalar
/// whose comparison is a bool, and does not compile for packs.
template <class T, std::size_t N>
struct Eigen::NumTraits<strike::Pack<T, N>> : strike::detail::EigenTraits<strike::Pack<T, N>, 1> {};
template <class T, std::size_t N>
struct Eigen::NumTraits<strike::Dual<T, N>> : strike::detail::EigenTraits<strike::Dual<T, N>, 2 * N + 1> {};

template <class S, class U, class Operation>
  requires strike::detail::Constituent<U, S>
struct Eigen::ScalarBinaryOpTraits<S, U, Operation> {
  using ReturnType = S;
};
template <class S, class U, class Operation>
  requires strike::detail::Constituent<U, S>
struct Eigen::ScalarBinaryOpTraits<U, S, Operation> {
  using ReturnType = S;
};

// Eigen's blocked matrix products branch on values and mix no scalars; here every product goes by coefficients.
template <class A, class B>
  requires(strike::detail::is_composite<typename A::Scalar> || strike::detail::is_composite<typename B::Scalar>)
struct Eigen::internal::generic_product_impl<A, B, Eigen::DenseShape, Eigen::DenseShape, Eigen::GemvProduct>
    : generic_product_impl<A, B, DenseShape, DenseShape, CoeffBasedProductMode> {};
template <class A, class B>
  requires(strike::detail::is_composite<typename A::Scalar> || strike::detail::is_composite<typename B::Scalar>)
struct Eigen::internal::generic_product_impl<A, B, Eigen::DenseShape, Eigen::DenseShape, Eigen::GemmProduct>
    : generic_product_impl<A, B, DenseShape, DenseShape, CoeffBasedProductMode> {};
