#pragma once
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <strike/scalar/eigen.hpp>

namespace bench {

/// What is done with numbers.
struct Operations {
  std::size_t sums = 0, products = 0, quotients = 0, roots = 0;
  std::size_t functions = 0;   ///< cbrt, exp, log, pow
  std::size_t selections = 0;  ///< select, min, max, abs

  std::size_t flops() const { return sums + products; }
};

/// A double that counts what is done with it, `Counted::done`, as far as the machine has to do it in every element: an
/// operation on constants alone is done once, and a product with the constant one never. Constant is what comes from
/// literals and parameters alone; what comes out of a field of the nodes, as into a lane, is not.
class Counted {
 public:
  using value_type = double;
  static inline Operations done;

  Counted() = default;
  template <class U>
    requires std::is_arithmetic_v<U>
  Counted(U value) : value_(static_cast<double>(value)) {}  // implicit: literals stand in formulas

  double operator[](std::size_t) const { return value_; }
  void set(std::size_t, double value) { value_ = value, constant_ = false; }

  friend Counted operator+(const Counted& a, const Counted& b) {
    return count(&Operations::sums, a.value_ + b.value_, a, b);
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return count(&Operations::sums, a.value_ - b.value_, a, b);
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    if (a.is_one()) return b;
    if (b.is_one()) return a;
    return count(&Operations::products, a.value_ * b.value_, a, b);
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return count(&Operations::quotients, a.value_ / b.value_, a, b);
  }
  friend Counted operator+(const Counted& a) { return a; }
  friend Counted operator-(Counted a) {  // goes into the sum or the product that it stands in
    a.value_ = -a.value_;
    return a;
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }

  friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
  friend bool operator<=(const Counted& a, const Counted& b) { return a.value_ <= b.value_; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }
  friend bool operator>=(const Counted& a, const Counted& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Counted& a, const Counted& b) { return a.value_ != b.value_; }

  friend Counted select(bool condition, const Counted& then, const Counted& otherwise) {
    Counted chosen;
    chosen.set(0, (condition ? then : otherwise).value_);
    ++done.selections;
    return chosen;
  }
  friend Counted min(const Counted& a, const Counted& b) {
    return count(&Operations::selections, (b < a ? b : a).value_, a, b);
  }
  friend Counted max(const Counted& a, const Counted& b) {
    return count(&Operations::selections, (a < b ? b : a).value_, a, b);
  }
  friend Counted abs(const Counted& a) { return count(&Operations::selections, std::abs(a.value_), a); }

  friend Counted sqrt(const Counted& a) { return count(&Operations::roots, std::sqrt(a.value_), a); }
  friend Counted rsqrt(const Counted& a) { return count(&Operations::roots, 1 / std::sqrt(a.value_), a); }
  friend Counted cbrt(const Counted& a) { return count(&Operations::functions, std::cbrt(a.value_), a); }
  friend Counted exp(const Counted& a) { return count(&Operations::functions, std::exp(a.value_), a); }
  friend Counted log(const Counted& a) { return count(&Operations::functions, std::log(a.value_), a); }
  friend Counted pow(const Counted& a, const Counted& b) {
    return count(&Operations::functions, std::pow(a.value_, b.value_), a, b);
  }

  friend double reduce_sum(const Counted& a) { return a.value_; }
  friend double reduce_min(const Counted& a) { return a.value_; }
  friend double reduce_max(const Counted& a) { return a.value_; }

 private:
  bool is_one() const { return constant_ && value_ == 1; }

  // Not inlined: an element of some thousand operations would take minutes to compile.
  template <class... Operands>
  [[gnu::noinline]] static Counted count(std::size_t Operations::*kind, double value, const Operands&... operands) {
    Counted result = value;
    result.constant_ = (operands.constant_ && ...);
    if (!result.constant_) ++(done.*kind);
    return result;
  }

  double value_ = 0;
  bool constant_ = true;
};

}  // namespace bench

template <>
struct strike::detail::ScalarTraits<bench::Counted> {
  using Real = double;
  using Lane = double;
  static constexpr std::size_t lanes = 1;
};
template <>
inline constexpr bool strike::detail::is_composite<bench::Counted> = true;
template <>
struct Eigen::NumTraits<bench::Counted> : strike::detail::EigenTraits<bench::Counted, 1> {};

static_assert(strike::Scalar<bench::Counted>);
