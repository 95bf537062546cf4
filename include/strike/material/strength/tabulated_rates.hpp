#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/material/strength/flow_curve.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {
/// Stresses at rising strains, linear between points and constant beyond the first and the last one.
inline std::vector<double> stresses_at(const std::vector<TabulatedHardening::Point>& points,
                                       const std::vector<double>& strains) {
  std::vector<double> stresses;
  std::size_t next = 0;
  for (const double e : strains) {
    while (next < points.size() && points[next].plastic_strain <= e) ++next;
    if (next == 0 || next == points.size()) {
      stresses.push_back(points[next == 0 ? 0 : next - 1].stress);
    } else {
      const auto& [e0, s0] = points[next - 1];
      const auto& [e1, s1] = points[next];
      stresses.push_back(s0 + (s1 - s0) / (e1 - e0) * (e - e0));
    }
  }
  return stresses;
}
}  // namespace detail

/// Von Mises plasticity with the flow stress of tests at several rates of plastic strain. Each test is linear between
/// its points and constant after the last, as TabulatedHardening; between two rates the stress is linear in the rate,
/// or in its logarithm; below the first and above the last rate it is that of the first and of the last test.
///   TabulatedRates{80e9, {{1e-3, {{0, 400e6}, {0.1, 500e6}}}, {1e3, {{0, 520e6}, {0.1, 600e6}}}},
///                  TabulatedRates::Between::logarithms}
class TabulatedRates {
 public:
  enum class Between { rates, logarithms };  ///< in what the stress is linear
  using Point = TabulatedHardening::Point;
  struct Test {
    double rate;  ///< of the equivalent plastic strain [1/time]
    std::vector<Point> points;
  };

  double shear_modulus;  ///< G [stress]

  /// Errors: no tests; rates that do not rise, are negative, or 0 between logarithms; those of TabulatedHardening; a
  /// stress below that of the test before, for the flow stress does not fall with the rate.
  TabulatedRates(double G, const std::vector<Test>& tests, Between between = Between::rates)
      : shear_modulus(G), is_logarithmic_(between == Between::logarithms) {
    if (tests.empty()) throw Error("strike: a TabulatedRates has no tests: give it at least one.");
    for (const auto& [rate, points] : tests) {
      rates_.push_back(rate);
      tests_.emplace_back(G, points, detail::joined({", in test ", std::to_string(rates_.size()), ","}));
      for (const Point& point : points) strains_.push_back(point.plastic_strain);
    }
    std::sort(strains_.begin(), strains_.end());
    strains_.erase(std::unique(strains_.begin(), strains_.end()), strains_.end());
    for (const Test& test : tests) stresses_.push_back(detail::stresses_at(test.points, strains_));
    detail::check_ranges(*this);
    make_cells();
  }

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    for (std::size_t i = 0; i < tests_.size(); ++i) {
      const std::string test = detail::joined({" of test ", std::to_string(i + 1)});
      if (i > 0)
        number("rate" + test, rates_[i], range::above(rates_[i - 1]), "sort the tests by their rate, each once");
      else if (is_logarithmic_)
        number("rate" + test, rates_[i], range::positive, "its logarithm is taken");
      else
        number("rate" + test, rates_[i], range::not_negative);
      number(tests_[i], detail::joined({"test ", std::to_string(i + 1)}));
      for (std::size_t j = 0; i > 0 && j < strains_.size(); ++j)
        number(detail::joined({"stress", test, " at the plastic strain ", detail::text(strains_[j])}), stresses_[i][j],
               range::at_least((1 - 1e-12) * stresses_[i - 1][j]),
               "the stress of a test is not below that of a slower one");
    }
  }
  std::string warning() const {
    for (const TabulatedHardening& test : tests_)
      if (std::string text = test.warning(); !text.empty()) return text;
    return {};
  }

  template <class T>
  T flow_stress(const T& e, const T& rate) const {
    const T x = coordinate(rate);
    return cell(e, x).stress_at(e, x);
  }

  /// The flow stress of a step, flow_curve.hpp.
  template <class T>
  class Curve;
  template <class T>
  Curve<T> flow_curve(const T& e, double dt) const {
    return {*this, e, dt};
  }

 private:
  /// The stress between two strains and two rates, bilinear from its first corner: at the strain e and the coordinate x
  /// of the rate s + h (e - e0) + (x - x0) [g + q (e - e0)].
  template <class T>
  struct Cell {
    T strain, strain_to, x, x_from, x_to;
    T stress, slope, rise, bend;  ///< s, h, g, q

    T stress_at(const T& e, const T& at) const {
      return stress + slope * (e - strain) + (at - x) * (rise + bend * (e - strain));
    }
  };
  static constexpr double largest = std::numeric_limits<float>::max();

  /// The rate, or its logarithm.
  template <class T>
  T coordinate(const T& rate) const {
    return is_logarithmic_ ? T(log(max(rate, T(std::numeric_limits<RealOf<T>>::min())))) : rate;
  }

  /// Cells row by row: below the first rate, from each rate to the next, above the last.
  void make_cells() {
    const std::size_t n = strains_.size(), m = rates_.size();
    std::vector<double> stresses, slopes;
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        stresses.push_back(i == 0 ? stresses_[i][j] : std::max(stresses_[i][j], stresses[(i - 1) * n + j]));
      for (std::size_t j = 0; j < n; ++j)
        slopes.push_back(
            j + 1 == n ? 0 : (stresses[i * n + j + 1] - stresses[i * n + j]) / (strains_[j + 1] - strains_[j]));
    }
    for (std::size_t row = 0; row <= m; ++row) {
      const std::size_t i = row == 0 ? 0 : row - 1;
      const bool is_between = row > 0 && row < m;
      const double x = coordinate(rates_[i]), next = is_between ? coordinate(rates_[row]) : largest;
      from_.push_back(row == 0 ? -largest : x);
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t here = i * n + j;
        const double per_width = is_between ? 1 / (next - x) : 0;
        cells_.push_back({strains_[j], j + 1 < n ? strains_[j + 1] : largest, x, from_[row], row == 0 ? x : next,
                          stresses[here], slopes[here],
                          is_between ? per_width * (stresses[here + n] - stresses[here]) : 0,
                          is_between ? per_width * (slopes[here + n] - slopes[here]) : 0});
      }
    }
  }

  /// The cell of a strain and of the coordinate of a rate. Cells that no lane is beyond are not looked at.
  template <class T>
  Cell<T> cell(const T& e, const T& x) const {
    const std::size_t n = strains_.size();
    std::size_t column = 0, row = 0;
    while (column + 1 < n && all(e >= strains_[column + 1])) ++column;
    while (row + 1 < from_.size() && all(x >= from_[row + 1])) ++row;
    Cell<T> found = in_lanes<T>(cells_[row * n + column]);
    for (std::size_t i = row; i < from_.size() && (i == row || any(x >= from_[i])); ++i)
      for (std::size_t j = column; j < n && (j == column || any(e >= strains_[j])); ++j) {
        if (i == row && j == column) continue;
        const auto is_beyond = x >= from_[i] && e >= strains_[j];
        const Cell<T> other = in_lanes<T>(cells_[i * n + j]);
        for (T Cell<T>::*member : members<T>) found.*member = select(is_beyond, other.*member, found.*member);
      }
    return found;
  }
  template <class T>
  static constexpr T Cell<T>::*members[] = {&Cell<T>::strain, &Cell<T>::strain_to, &Cell<T>::x,
                                            &Cell<T>::x_from, &Cell<T>::x_to,      &Cell<T>::stress,
                                            &Cell<T>::slope,  &Cell<T>::rise,      &Cell<T>::bend};
  template <class T>
  static Cell<T> in_lanes(const Cell<double>& c) {
    return {T(c.strain), T(c.strain_to), T(c.x), T(c.x_from), T(c.x_to), T(c.stress), T(c.slope), T(c.rise), T(c.bend)};
  }

  bool is_logarithmic_;
  std::vector<double> rates_ = {};
  std::vector<TabulatedHardening> tests_ = {};
  std::vector<double> strains_ = {};                ///< of the points of all tests
  std::vector<std::vector<double>> stresses_ = {};  ///< of each test at these strains
  std::vector<double> from_ = {};                   ///< the least coordinate of each row
  std::vector<Cell<double>> cells_ = {};
};

template <class T>
class TabulatedRates::Curve {
 public:
  Curve(const TabulatedRates& law, const T& e, double dt)
      : law_(law), strain_(e), per_dt_(1 / dt), cell_(law.cell(e, T(-largest))) {}

  T at_rest() const {
    const Cell<T> slowest = law_.cell(strain_, T(-largest));
    return slowest.stress_at(strain_, slowest.x);
  }
  void start_at(const T& dl) {
    x_ = law_.coordinate(T(dl * per_dt_));
    cell_ = law_.cell(T(strain_ + dl), x_);
  }
  void move_to(const T& dl, const T& u) {
    x_ = law_.is_logarithmic_ ? T(x_ + u) : T(dl * per_dt_);
    cell_ = law_.cell(T(strain_ + dl), x_);
  }
  LogSeries<T> series(const T& dl) const {
    const T e = strain_ - cell_.strain, x = x_ - cell_.x;
    const LogSeries<T> rate =
        law_.is_logarithmic_ ? LogSeries<T>{x, T(1.0), T(0.0), T(0.0)} : T(-cell_.x) + LogSeries<T>::proportional(x_);
    return T(cell_.stress + cell_.slope * e) + LogSeries<T>::proportional(cell_.slope * dl) +
           rate * (T(cell_.rise + cell_.bend * e) + LogSeries<T>::proportional(cell_.bend * dl));
  }
  /// Where strain and rate pass no point of the table.
  auto is_smooth(const T& dl, const T& u) const {
    const T growth = 1.0 + u * (1.0 + u), strain = strain_ + dl * growth;
    const T x = law_.is_logarithmic_ ? T(x_ + u) : T(x_ * growth);
    return strain >= cell_.strain && strain <= cell_.strain_to && x >= cell_.x_from && x <= cell_.x_to;
  }

 private:
  const TabulatedRates& law_;
  T strain_;
  double per_dt_;
  Cell<T> cell_;
  T x_{};  ///< coordinate of the rate
};

}  // namespace strike
