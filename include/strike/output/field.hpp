#pragma once
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike {

template <class T>
struct SymmetricTensor;

namespace detail {
/// True of types that are a fixed number of doubles and nothing else.
template <class Row>
inline constexpr bool is_row = false;
template <class Row>
  requires std::same_as<typename Row::value_type, double> && std::is_trivially_destructible_v<Row>
inline constexpr bool is_row<Row> = true;  // std::array, Eigen's fixed matrices
template <>
inline constexpr bool is_row<SymmetricTensor<double>> = true;
}  // namespace detail

/// Rows of numbers, one per node or cell: scalars, vectors or tensors. They are a copy, so that the vector that they
/// come from may go.
class Rows {
 public:
  /// `components` numbers a row; rows start `stride` numbers apart (by default they follow each other).
  Rows(std::span<const double> numbers, std::size_t components, std::size_t stride = 0) : components_(components) {
    if (stride == 0) stride = components;
    if (components < 1 || stride < components)
      throw Error(detail::joined({"strike: rows of ", std::to_string(components), " numbers cannot start ",
                                  std::to_string(stride),
                                  " apart: give at least one number a row and a stride that holds it."}));
    for (std::size_t first = 0; first + components <= numbers.size(); first += stride)
      numbers_.insert(numbers_.end(), numbers.data() + first, numbers.data() + first + components);
  }

  Rows(std::vector<double> numbers) : numbers_(std::move(numbers)), components_(1) {}

  /// A vector of fixed arrays of double, as they are stored: `Eigen::Vector3d` (3), `std::array<double, N>` (N),
  /// `SymmetricTensor<double>` (6: xx yy zz xy yz zx).
  template <class Row>
    requires detail::is_row<Row>
  Rows(const std::vector<Row>& rows) : components_(sizeof(Row) / sizeof(double)) {
    const auto* numbers = reinterpret_cast<const double*>(rows.data());
    numbers_.assign(numbers, numbers + rows.size() * components_);
  }

  std::size_t size() const { return numbers_.size() / components_; }
  std::size_t components() const { return components_; }
  std::span<const double> operator[](std::size_t row) const {
    return {numbers_.data() + row * components_, components_};
  }

 private:
  std::vector<double> numbers_;
  std::size_t components_;
};

/// Rows of numbers with a name, one per node or per cell.
struct Field {
  std::string name;
  Rows rows;
};

}  // namespace strike
