#pragma once
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike {

template <class T>
struct SymmetricTensor;

namespace detail {
/// Types that are nothing but a fixed number of doubles.
template <class Row>
inline constexpr bool is_row = false;
template <class Row>
  requires std::same_as<typename Row::value_type, double> && std::is_trivially_destructible_v<Row>
inline constexpr bool is_row<Row> = true;  // std::array, Eigen's fixed matrices
template <>
inline constexpr bool is_row<SymmetricTensor<double>> = true;
}  // namespace detail

/// A view of rows of numbers that someone else keeps: scalars, vectors or tensors, one per node or cell.
class Rows {
 public:
  /// `components` numbers a row; rows begin `stride` numbers apart (by default they follow each other).
  Rows(std::span<const double> numbers, std::size_t components, std::size_t stride = 0)
      : data_(numbers.data()), components_(components), stride_(stride ? stride : components) {
    if (components < 1 || stride_ < components)
      throw Error(
          detail::joined({"Rows of ", std::to_string(components), " numbers cannot begin ", std::to_string(stride_),
                          " apart: give at least one number a row and a stride that holds it."}));
    count_ = (numbers.size() + stride_ - components) / stride_;
  }

  Rows(const std::vector<double>& numbers) : Rows(numbers, 1) {}

  /// A vector of fixed arrays of double, as they are stored: `Eigen::Vector3d` (3), `std::array<double, N>` (N),
  /// `SymmetricTensor<double>` (6: xx yy zz xy yz zx).
  template <class Row>
    requires detail::is_row<Row>
  Rows(const std::vector<Row>& rows)
      : data_(reinterpret_cast<const double*>(rows.data())),
        count_(rows.size()),
        components_(sizeof(Row) / sizeof(double)),
        stride_(components_) {}

  std::size_t size() const { return count_; }
  std::size_t components() const { return components_; }
  std::span<const double> operator[](std::size_t row) const { return {data_ + row * stride_, components_}; }

 private:
  const double* data_;
  std::size_t count_ = 0, components_, stride_;
};

/// Numbers with a name, one row per node or per cell.
struct Field {
  std::string name;
  Rows rows;
};

}  // namespace strike
