#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/range.hpp>

namespace strike {

/// A bubble canopy: half ellipses across the x axis, on the plane z = 0. Their height and half width follow parabolas
/// from the front to `top`, where they are largest, and from there to the back.
struct CanopyShape {
  /// Heights or widths in front, at the top and at the back [length].
  struct Profile {
    double front, top, back;
  };
  double length;                     ///< along x, from 0 [length]
  double top;                        ///< x of its largest section [length]
  Profile height;                    ///< of the crown over the sill
  Profile half_width;                ///< of the sill
  std::array<Index, 2> cells{1, 1};  ///< quadrilaterals along x and from sill to sill

  void ranges(const auto& number) const {
    number("length", length, range::positive);
    number("top", top, Range{.low = 0, .high = length});
    number("height.front", height.front, range::positive);
    number("height.top", height.top, range::positive);
    number("height.back", height.back, range::positive);
    number("half_width.front", half_width.front, range::positive);
    number("half_width.top", half_width.top, range::positive);
    number("half_width.back", half_width.back, range::positive);
    number("cells", cells, range::count);
  }

  double height_at(double x) const { return at(height, x); }
  double half_width_at(double x) const { return at(half_width, x); }

 private:
  double at(const Profile& p, double x) const {
    const double away = x < top ? (top - x) / top : (x - top) / (length - top);
    return p.top - (p.top - (x < top ? p.front : p.back)) * away * away;
  }
};

/// Quadrilaterals on a canopy, facing outward, at equal steps in x and in the angle of the ellipses.
/// Errors: a length, height or width that is not positive, a top that is not between front and back, no cells.
inline Mesh canopy(const CanopyShape& shape) {
  detail::check_ranges(shape);
  return sheet(shape.cells, [&](double s, double t) {
    const double x = s * shape.length, angle = (t - 0.5) * std::numbers::pi;
    return Eigen::Vector3d(x, shape.half_width_at(x) * std::sin(angle), shape.height_at(x) * std::cos(angle));
  });
}

}  // namespace strike
