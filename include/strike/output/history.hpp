#pragma once
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/output/file.hpp>
#include <strike/text.hpp>

namespace strike {

/// A column of a table of numbers.
struct Column {
  std::string name;
  std::string unit = {};  ///< without brackets; empty for a plain number
};

/// A CSV file that grows by a row whenever something is known: `history.row(t, length, energy)`. The head names columns
/// as `name [unit]`. Numbers are the shortest that read back the same. Each row is complete in the file when `row`
/// returns, even if the program is killed after. Errors: the file cannot be opened or written; a row of another length.
class History {
 public:
  History(std::string path, const std::vector<Column>& columns) : columns_(columns.size()), file_(std::move(path)) {
    if (columns.empty())
      throw Error(detail::joined({"History '", file_.path(), "' has no columns: name at least one."}));
    std::string head;
    for (const Column& column : columns) {
      if (!head.empty()) head += ',';
      head += detail::csv_escaped(column.unit.empty() ? column.name
                                                      : detail::joined({column.name, " [", column.unit, "]"}));
    }
    file_.write(head + '\n');
  }

  void row(std::span<const double> values) {
    if (values.size() != columns_)
      throw Error(detail::joined({"History '", file_.path(), "' has ", std::to_string(columns_), " columns, but row ",
                                  std::to_string(rows_), " brings ", std::to_string(values.size()),
                                  " values: give one for each column."}));
    line_.clear();
    for (const double value : values) {
      if (!line_.empty()) line_ += ',';
      line_ += detail::shortest(value);
    }
    file_.write(line_ += '\n');
    ++rows_;
  }

  template <std::convertible_to<double>... Values>
  requires(sizeof...(Values) > 0) void row(Values... values) {
    const double row_of_values[] = {static_cast<double>(values)...};
    row(std::span<const double>(row_of_values));
  }

  /// Rows written so far.
  std::size_t rows() const { return rows_; }

 private:
  std::size_t columns_, rows_ = 0;
  detail::OutputFile file_;
  std::string line_;
};

}  // namespace strike
