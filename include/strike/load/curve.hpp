#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

/// A history: linear between points, constant before the first and after the last. Wherever a Curve is taken, any
/// function double(double time) is.
class Curve {
 public:
  struct Point {
    double time, value;
  };

  /// Errors: no points; a number that is not finite; times that do not increase.
  Curve(std::vector<Point> points) : points_(std::move(points)) {
    if (points_.empty()) throw Error("strike: a Curve has no points; give it at least one.");
    detail::check_ranges(*this);
    for (std::size_t i = 1; i < points_.size(); ++i)
      if (!(points_[i].time > points_[i - 1].time))
        throw Error(detail::joined({"strike: point ", std::to_string(i), " of a Curve is at time ",
                                    detail::text(points_[i].time), ", not after the one before at ",
                                    detail::text(points_[i - 1].time), "; sort the points by time."}));
  }

  void ranges(const auto& number) const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::string of = detail::joined({" of point ", std::to_string(i)});
      number(("time" + of).c_str(), points_[i].time, range::finite);
      number(("value" + of).c_str(), points_[i].value, range::finite);
    }
  }

  double operator()(double time) const {
    const auto next =
        std::upper_bound(points_.begin(), points_.end(), time, [](double t, const Point& p) { return t < p.time; });
    if (next == points_.begin()) return points_.front().value;
    if (next == points_.end()) return points_.back().value;
    const Point &a = *(next - 1), &b = *next;
    return a.value + (b.value - a.value) * ((time - a.time) / (b.time - a.time));
  }

 private:
  std::vector<Point> points_;
};

/// A constant history.
struct Constant {
  double value = 1;

  void ranges(const auto& number) const { number("value", value, range::finite); }

  double operator()(double) const { return value; }
};

}  // namespace strike
