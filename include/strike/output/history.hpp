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

/// A CSV file that grows row by row: `history.row(t, length, energy)`. The head, written with the first row, names
/// columns as `name [unit]`. Numbers have the shortest text that reads back the same. Each row is complete in the file
/// when `row` returns, even if the program is killed later. Errors: the file cannot be opened or written; a row of
/// another length.
class History {
 public:
  History(std::string path, const std::vector<Column>& columns) : columns_(columns.size()), file_(std::move(path)) {
    if (columns.empty())
      throw Error(detail::joined({"strike: the History '", file_.path(), "' has no columns: name at least one."}));
    for (const Column& column : columns) {
      if (!line_.empty()) line_ += ',';
      line_ += detail::csv_escaped(column.unit.empty() ? column.name
                                                       : detail::joined({column.name, " [", column.unit, "]"}));
    }
    line_ += '\n';
  }

  void row(std::span<const double> values) {
    if (values.size() != columns_)
      throw Error(detail::joined({"strike: the History '", file_.path(), "' has ", std::to_string(columns_),
                                  " columns, but row ", std::to_string(rows_), " brings ",
                                  std::to_string(values.size()), " values: give one for each column."}));
    if (rows_ > 0) line_.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) line_ += ',';
      line_ += detail::shortest(values[i]);
    }
    file_.write(line_ += '\n');
    ++rows_;
  }

  template <std::convertible_to<double>... Values>
    requires(sizeof...(Values) > 0)
  void row(Values... values) {
    const double row_of_values[] = {static_cast<double>(values)...};
    row(std::span<const double>(row_of_values));
  }

  /// Rows written so far.
  std::size_t rows() const { return rows_; }

  template <class Archive>
  void serialize(Archive& archive) {
    std::uint64_t bytes = file_.size();
    archive.same(columns_);
    archive(rows_, bytes);
    if (archive.reads() && bytes > 0) file_.go_on_behind(bytes);
  }

 private:
  std::size_t columns_, rows_ = 0;
  detail::OutputFile file_;
  std::string line_;  // the head, until the first row is written
};

}  // namespace strike
