#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike {

/// Von Mises plasticity with the flow stress of a test, linear between points and constant after the last:
///   TabulatedHardening{80e9, {{0, 400e6}, {0.02, 450e6}, {0.1, 500e6}}}
class TabulatedHardening {
 public:
  struct Point {
    double plastic_strain, stress;  ///< equivalent plastic strain (logarithmic) [1], true stress [stress]
  };

  double shear_modulus;  ///< G [stress]

  /// Errors: no points; strains that do not start at 0 or do not rise; a stress below zero or one that falls as steeply
  /// as 3 G, the slope at which a stress relaxes; `where` is a place in these sentences, such as ", in test 2,".
  TabulatedHardening(double G, const std::vector<Point>& points, const std::string& where = {}) : shear_modulus(G) {
    if (points.empty())
      throw Error(detail::joined({"strike: a TabulatedHardening", where, " has no points: give it at least one."}));
    for (const auto& [strain, stress] : points)
      segments_.push_back({strain, stress, 0, std::numeric_limits<float>::max()});
    detail::check_ranges(*this, where);
    for (std::size_t i = 1; i < points.size(); ++i) {
      segments_[i - 1].slope =
          (points[i].stress - points[i - 1].stress) / (points[i].plastic_strain - points[i - 1].plastic_strain);
      segments_[i - 1].end = points[i].plastic_strain;
    }
  }

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const std::string point = detail::joined({" of point ", std::to_string(i)});
      const auto& [strain, stress, slope, end] = segments_[i];
      const Segment& before = segments_[i > 0 ? i - 1 : 0];
      if (i == 0)
        number("plastic_strain" + point, strain, range::between(0, 0),
               "start at 0 with the yield stress, and subtract the elastic strain from the rest");
      else
        number("plastic_strain" + point, strain, range::above(before.strain),
               "sort the points by their strain, each once");
      number("stress" + point, stress, range::not_negative);
      if (i > 0)
        number("stress" + point, stress, range::above(before.stress - 3 * shear_modulus * (strain - before.strain)),
               detail::joined({"no step can end where it falls as steeply as 3 G, so spread the fall over more than ",
                               detail::text((before.stress - stress) / (3 * shear_modulus))}));
    }
  }
  std::string warning() const {
    for (const Segment& segment : segments_)
      if (segment.slope < 0)
        return "A table of hardening falls: strain that softens gathers in one row of elements, and the result depends "
               "on the mesh.";
    return {};
  }

  template <class T>
  T flow_stress(const T& e) const {
    T sigma = segments_.front().at(e);
    for (const Segment& segment : segments_) sigma = select(e >= segment.strain, segment.at(e), sigma);
    return sigma;
  }

  /// q - 3 G dl = sigma(e + dl) in closed form: sigma + 3 G e rises, so that its value q + 3 G e gives the segment; the
  /// rest is the return of linear hardening.
  template <class T>
  T plastic_increment(const T& q, const T& e, double) const {
    const double G3 = 3 * shear_modulus;
    T dl = T(0.0);
    for (const Segment& segment : segments_)
      dl =
          select(q - segment.stress >= G3 * (segment.strain - e), (1 / (G3 + segment.slope)) * (q - segment.at(e)), dl);
    return max(T(0.0), dl);
  }

  /// The flow stress of a step, flow_curve.hpp.
  template <class T>
  class Curve {
   public:
    Curve(const TabulatedHardening& law, const T& e) : law_(law), strain_(e), first_(law.line(e)), line_(first_) {}

    T at_rest() const { return first_.stress; }
    void start_at(const T& dl) {
      line_ = first_;
      line_.stress += first_.slope * dl;
      const T strain = strain_ + dl;
      const auto beyond = strain > first_.to;
      if (any(beyond)) {
        const detail::StrainLine<T> other = law_.line(strain);
        line_ = {select(beyond, other.stress, line_.stress), select(beyond, other.slope, line_.slope),
                 select(beyond, other.from, line_.from), select(beyond, other.to, line_.to)};
      }
    }
    void move_to(const T& dl, const T&) { start_at(dl); }
    LogSeries<T> series(const T& dl) const {
      const T rise = line_.slope * dl;
      return {line_.stress, rise, 0.5 * rise, (1.0 / 6) * rise};
    }
    /// Where the strain passes no point of the table.
    auto is_smooth(const T& dl, const T& u) const {
      const T strain = strain_ + dl * (1.0 + u * (1.0 + u));
      return strain >= line_.from && strain <= line_.to;
    }

   private:
    const TabulatedHardening& law_;
    T strain_;
    detail::StrainLine<T> first_, line_;
  };
  template <class T>
  Curve<T> flow_curve(const T& e, double) const {
    return {*this, e};
  }

 private:
  struct Segment {
    double strain, stress, slope;
    double end;  ///< of the strains, for the last the largest of float

    template <class T>
    T at(const T& e) const {
      return stress + slope * (e - strain);
    }
  };

  /// The segment of a strain, with the stress there.
  template <class T>
  detail::StrainLine<T> line(const T& e) const {
    const Segment& first = segments_.front();
    detail::StrainLine<T> line{first.at(e), T(first.slope), T(first.strain), T(first.end)};
    for (const Segment& segment : segments_) {
      const auto after = e >= segment.strain;
      line = {select(after, segment.at(e), line.stress), select(after, T(segment.slope), line.slope),
              select(after, T(segment.strain), line.from), select(after, T(segment.end), line.to)};
    }
    return line;
  }

  std::vector<Segment> segments_;
};

}  // namespace strike
