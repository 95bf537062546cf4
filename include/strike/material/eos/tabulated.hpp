#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike {

/// Table over the volumetric strain e = ln V, V = rho0/rho, negative in compression: p = C(e) + gamma T(e) E, linear
/// between points and continued along the first and the last piece (LS-DYNA *EOS_TABULATED); the pressure is cut off
/// from below. The bulk modulus without energy is -dC/de; at a point it is that of the denser side.
///   TabulatedEos{1000, {{-0.2, 800e6}, {-0.1, 300e6}, {0, 0}}}
/// The points may rise or fall in e. The work of a pressure grows with their number.
class TabulatedEos {
 public:
  struct Point {
    double volumetric_strain, C, T = 0;  ///< e [1], C [stress], T [1]
  };
  static constexpr double no_cutoff = std::numeric_limits<double>::lowest();

  double density;                      ///< reference density
  double gamma;                        ///< factor of T [1]
  double initial_energy;               ///< E at rest [energy/volume]
  double pressure_cutoff = no_cutoff;  ///< least pressure, at most 0 [stress]

  /// Errors: fewer than two points; strains that neither rise nor fall from each to the next; a C that does not fall as
  /// the volume grows, though it may stay where gamma T is positive.
  TabulatedEos(double rho0, std::vector<Point> points, double factor = 1, double energy = 0, double cutoff = no_cutoff)
      : density(rho0), gamma(factor), initial_energy(energy), pressure_cutoff(cutoff), points_(std::move(points)) {
    if (points_.size() < 2)
      throw Error(detail::joined({"strike: a TabulatedEos has ", std::to_string(points_.size()),
                                  points_.size() == 1 ? " point" : " points", ": give it at least two."}));
    table_ranges(detail::RangeCheck("TabulatedEos", {}));
    const bool rising = rises();
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const auto& [e0, C0, T0] = points_[rising ? i - 1 : points_.size() - i];
      const auto& [e1, C1, T1] = points_[rising ? i : points_.size() - 1 - i];
      pieces_.push_back({e0, e1, {C1, (C1 - C0) / (e1 - e0)}, {T1, (T1 - T0) / (e1 - e0)}});
    }
  }

  /// As they were given.
  const std::vector<Point>& points() const { return points_; }

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("gamma", gamma, range::between(0, 100));
    number("initial_energy", initial_energy, range::finite);
    number("pressure_cutoff", pressure_cutoff, range::or_infinite(range::at_most(0)));
    table_ranges(number);
  }

  template <class T>
  T A(const T& mu) const {
    return value(&Piece::C, mu);
  }
  template <class T>
  T B(const T& mu) const {
    return gamma * value(&Piece::T, mu);
  }

 private:
  struct Line {
    double end, slope;  ///< value at the end of the piece
  };
  struct Piece {
    double from, to;  ///< of e, ascending
    Line C, T;
  };

  /// True of most points, of the first two in a draw, so that an error names the one that is out of order.
  bool rises() const {
    std::size_t rising = 0;  // steps
    for (std::size_t i = 1; i < points_.size(); ++i)
      rising += points_[i].volumetric_strain > points_[i - 1].volumetric_strain ? 1 : 0;
    const bool first = points_[1].volumetric_strain > points_[0].volumetric_strain;
    return 2 * rising + (first ? 1 : 0) > points_.size() - 1;
  }

  /// Pieces begin after their first point and are measured from their last, so that the value at rest is the table's.
  template <class Number>
  Number value(Line Piece::*member, const Number& mu) const {
    const Number e = -log(Number(1.0 + mu));
    const auto in = [&](const Piece& piece) {
      const Line& line = piece.*member;
      return Number(line.end + line.slope * (e - piece.to));
    };
    Number result = in(pieces_.front());
    for (std::size_t i = 1; i < pieces_.size(); ++i) result = select(e > pieces_[i].from, in(pieces_[i]), result);
    return result;
  }

  void table_ranges(const auto& number) const {
    using detail::joined, detail::text, std::to_string;
    const bool rising = rises();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto& [e, C, T] = points_[i];
      const std::string point = joined({" of point ", to_string(i)});
      const auto& [e0, C0, T0] = points_[i > 0 ? i - 1 : 0];
      if (i == 0)
        number("volumetric_strain" + point, e, range::finite);
      else
        number("volumetric_strain" + point, e, rising ? range::above(e0) : range::below(e0),
               "sort the points by their strain, each once");
      number("T" + point, T, range::finite);
      if (i == 0) {
        number("C" + point, C, range::finite);
        continue;
      }
      const bool has_heat = gamma * T > 0 && gamma * T0 > 0;
      const Range falls = rising ? (has_heat ? range::at_most(C0) : range::below(C0))
                                 : (has_heat ? range::at_least(C0) : range::above(C0));
      number("C" + point, C, falls,
             falls.holds(C) ? std::string{}
                            : joined({"the bulk modulus from point ", to_string(i - 1), " to point ", to_string(i),
                                      " is ", text((C0 - C) / (e - e0)), ", so let C fall as the volume grows"}));
    }
  }

  std::vector<Point> points_;  ///< as given
  std::vector<Piece> pieces_;  ///< from the densest on
};

}  // namespace strike
