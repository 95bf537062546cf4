#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <strike/error.hpp>
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
  /// as 3 G, the slope at which a stress relaxes.
  TabulatedHardening(double G, const std::vector<Point>& points) : shear_modulus(G) {
    if (points.empty()) throw Error("strike: a TabulatedHardening has no points: give it at least one.");
    for (const auto& [strain, stress] : points) segments_.push_back({strain, stress, 0});
    detail::check_ranges(*this);
    for (std::size_t i = 1; i < points.size(); ++i)
      segments_[i - 1].slope =
          (points[i].stress - points[i - 1].stress) / (points[i].plastic_strain - points[i - 1].plastic_strain);
  }

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const std::string point = detail::joined({" of point ", std::to_string(i)});
      const auto& [strain, stress, slope] = segments_[i];
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

 private:
  struct Segment {
    double strain, stress, slope;

    template <class T>
    T at(const T& e) const {
      return stress + slope * (e - strain);
    }
  };
  std::vector<Segment> segments_;
};

}  // namespace strike
