#pragma once
#include <cstddef>
#include <limits>

#include <Eigen/Core>

#include <strike/scalar/pack.hpp>

namespace strike::detail {

template <class T>
inline constexpr bool is_composite = false;
template <class T, std::size_t N>
inline constexpr bool is_composite<Pack<T, N>> = true;

/// What Eigen asks of a number S whose built-in number is T.
template <class S, class T>
struct EigenTraits {
  using Real = S;
  using NonInteger = S;
  using Nested = S;
  using Literal = S;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1,
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

/// A Pack is a scalar of Eigen: `Eigen::Matrix<Pack<double, 8>, 3, 3>`, in which double literals and matrices of
/// doubles may stand. What branches on a value (`normalized`, decompositions with pivots) does not compile.
template <class T, std::size_t N>
struct Eigen::NumTraits<strike::Pack<T, N>> : strike::detail::EigenTraits<strike::Pack<T, N>, T> {};

template <class T, std::size_t N, class Operation>
struct Eigen::ScalarBinaryOpTraits<strike::Pack<T, N>, double, Operation> {
  using ReturnType = strike::Pack<T, N>;
};
template <class T, std::size_t N, class Operation>
struct Eigen::ScalarBinaryOpTraits<double, strike::Pack<T, N>, Operation> {
  using ReturnType = strike::Pack<T, N>;
};

// Eigen's blocked matrix products branch on values and mix no scalars; here every product goes by coefficients.
template <class A, class B>
requires(strike::detail::is_composite<typename A::Scalar> ||
         strike::detail::is_composite<typename B::Scalar>) struct Eigen::internal::
    generic_product_impl<A, B, Eigen::DenseShape, Eigen::DenseShape, Eigen::GemvProduct>
    : generic_product_impl<A, B, DenseShape, DenseShape, CoeffBasedProductMode> {
};
template <class A, class B>
requires(strike::detail::is_composite<typename A::Scalar> ||
         strike::detail::is_composite<typename B::Scalar>) struct Eigen::internal::
    generic_product_impl<A, B, Eigen::DenseShape, Eigen::DenseShape, Eigen::GemmProduct>
    : generic_product_impl<A, B, DenseShape, DenseShape, CoeffBasedProductMode> {
};
