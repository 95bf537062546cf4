#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <strike/error.hpp>
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
    if (points.front().plastic_strain != 0)
      throw Error(
          detail::joined({"strike: the first point of a TabulatedHardening is at the plastic strain ",
                          detail::text(points.front().plastic_strain),
                          ": start at 0 with the yield stress, and subtract the elastic strain from the rest."}));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [strain, stress] = points[i];
      const auto refuse = [&, here = i](const std::string& what) {
        throw Error(detail::joined({"strike: point ", std::to_string(here), " of a TabulatedHardening, at the strain ",
                                    detail::text(points[here].plastic_strain), ", ", what}));
      };
      if (!(stress >= 0)) refuse(detail::joined({"has the stress ", detail::text(stress), ": give 0 or more."}));
      if (i > 0) {
        const Point& before = points[i - 1];
        const double width = strain - before.plastic_strain, slope = (stress - before.stress) / width;
        if (!(width > 0)) refuse("is not beyond the one before: sort the points by their strain, each once.");
        if (!(slope > -3 * G))
          refuse(
              detail::joined({"falls as steeply as 3 G, so that no step can end on it: spread the fall over more than ",
                              detail::text((before.stress - stress) / (3 * G)), "."}));
        segments_.back().slope = slope;
      }
      segments_.push_back({strain, stress, 0});
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
