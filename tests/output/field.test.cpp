#include <array>

#include <Eigen/Core>

#include <strike/output/field.hpp>
#include <strike/tensor/tensor.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(std::constructible_from<Rows, const std::vector<Eigen::Vector3d>&>);
static_assert(std::constructible_from<Rows, const std::vector<SymmetricTensor<double>>&>);
static_assert(
    !std::constructible_from<Rows, const std::vector<std::array<unsigned, 4>>&>);  // also 16 bytes, but no doubles
static_assert(!std::constructible_from<Rows, const std::vector<Eigen::VectorXd>&>);
static_assert(!std::constructible_from<Rows, const std::vector<SymmetricTensor<float>>&>);

TEST_CASE("Rows: components and values as they are stored") {
  const std::vector<Eigen::Vector3d> vectors{{1, 2, 3}, {4, 5, 6}};
  const Rows rows = vectors;
  CHECK(rows.size() == 2);
  CHECK(rows.components() == 3);
  CHECK(rows[1][2] == 6);
  const std::vector<SymmetricTensor<double>> tensors{{1, 2, 3, 4, 5, 6}};
  CHECK(Rows(tensors).components() == 6);
  CHECK(Rows(tensors)[0][4] == 5);  // yz, as VTK numbers it
  CHECK(Rows(std::vector<double>{7, 8, 9}).size() == 3);
}

TEST_CASE("Rows: a stride skips the padding, also when the last row has none") {
  const std::vector<double> padded{1, 2, 3, -1, 4, 5, 6, -1};
  const Rows rows(padded, 3, 4);
  CHECK(rows.size() == 2);
  CHECK(rows[1][0] == 4);
  CHECK(Rows(std::span(padded).first(7), 3, 4).size() == 2);
  CHECK(Rows(std::span(padded).first(0), 3, 4).size() == 0);
  CHECK_THROWS_WITH(Rows(padded, 3, 2),
                    "strike: rows of 3 numbers cannot start 2 apart: give at least one number a row and a "
                    "stride that holds it.");
}

TEST_CASE("Field: keeps its numbers when the vector that it was made from is gone") {
  std::vector<Field> fields;
  const auto add = [&](const std::string& name, double value) {
    const std::vector<double> numbers(1000, value);
    const std::vector<Eigen::Vector3d> vectors(1000, Eigen::Vector3d::Constant(value));
    fields.push_back({name, numbers});
    fields.push_back({name, vectors});
    fields.push_back({name, std::vector<double>(1000, value)});
    fields.push_back({name, {std::vector<double>(4000, value), 3, 4}});
  };
  for (int i = 0; i < 3; ++i) add("number", i);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    CHECK(fields[k].rows.size() == 1000);
    for (std::size_t row : {std::size_t{0}, std::size_t{999}})
      for (const double number : fields[k].rows[row]) CHECK(number == static_cast<double>(k / 4));
  }
}
