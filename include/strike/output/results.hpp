#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <strike/output/file.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

/// A result of a run beside its reference.
struct Result {
  std::string quantity;
  double value;  ///< one that is not finite does not pass
  std::string unit = {};
  double reference = std::numeric_limits<double>::quiet_NaN();  ///< none if not a number
  double tolerance = std::numeric_limits<double>::infinity();   ///< largest |value - reference| that passes [unit]
  std::string source = {};                                      ///< of the reference

  void ranges(const auto& number) const {
    number("value", value, range::or_nan(range::or_infinite(range::finite)));
    number("reference", reference, range::or_nan(range::finite));
    number("tolerance", tolerance, range::or_infinite(range::not_negative));
  }

  bool has_reference() const { return !std::isnan(reference); }
  bool passes() const { return std::isfinite(value) && !(has_reference() && std::abs(value - reference) > tolerance); }
  /// Relative to the reference [%].
  double difference() const { return 100 * (value - reference) / std::abs(reference); }
};

/// The table of a run's results: `results.add({.quantity = "length", .value = 21.52, .unit = "mm", .reference = 21.47,
/// .tolerance = .08, .source = "X3D"})`, then `write("results.csv")` and `print()`.
class Results {
 public:
  /// Error: a reference that is infinite, a negative tolerance.
  void add(Result result) {
    detail::check_ranges(result);
    rows_.push_back(std::move(result));
  }
  const std::vector<Result>& rows() const { return rows_; }

  bool passed() const {
    return std::all_of(rows_.begin(), rows_.end(), [](const Result& r) { return r.passes(); });
  }

  /// CSV: quantity,value,unit,reference,tolerance,source; a reference or tolerance that is not given stays empty.
  [[gnu::cold]] void write(const std::string& path) const {
    std::string text = "quantity,value,unit,reference,tolerance,source\n";
    for (const Result& r : rows_) {
      text +=
          detail::csv_escaped(r.quantity) + ',' + detail::shortest(r.value) + ',' + detail::csv_escaped(r.unit) + ',';
      if (r.has_reference()) text += detail::shortest(r.reference);
      text += ',';
      if (std::isfinite(r.tolerance)) text += detail::shortest(r.tolerance);
      text += ',' + detail::csv_escaped(r.source) + '\n';
    }
    detail::replace_file(path, text);
  }

  /// The table in aligned columns, with the difference from the reference and whether it is within the tolerance.
  [[gnu::cold]] std::string table() const {
    using TableRow = std::array<std::string, 8>;
    std::vector<TableRow> lines{{"quantity", "value", "unit", "reference", "difference", "tolerance", "", "source"}};
    for (const Result& r : rows_) {
      TableRow line{r.quantity, number(r.value), r.unit, "", "", "", "", r.source};
      if (r.has_reference()) {
        line[3] = number(r.reference);
        char percent[32];
        std::snprintf(percent, sizeof percent, "%+.2f %%", r.difference());
        line[4] = r.reference != 0 ? percent : "";
        if (std::isfinite(r.tolerance)) {
          line[5] = number(r.tolerance);
          line[6] = r.passes() ? "pass" : "FAIL";
        }
      }
      lines.push_back(std::move(line));
    }
    std::array<std::size_t, 8> width{};
    for (const TableRow& line : lines)
      for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], line[c].size());
    std::string text;
    for (const TableRow& line : lines) {
      for (std::size_t c = 0; c < line.size(); ++c) {
        const std::string space(width[c] - line[c].size(), ' ');
        const bool right = c == 1 || (c >= 3 && c <= 5);  // numbers
        text += (right ? space + line[c] : line[c] + space) + "  ";
      }
      text.erase(text.find_last_not_of(' ') + 1);
      text += '\n';
    }
    return text;
  }

  void print(std::FILE* stream = stdout) const { std::fputs(table().c_str(), stream); }

 private:
  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
  }

  std::vector<Result> rows_;
};

}  // namespace strike
