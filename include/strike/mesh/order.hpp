#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>

namespace strike {

namespace detail {

/// The lowest 21 bits of x, spread so that two zeros precede each.
constexpr std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// The number of a point and its place on Morton's curve.
struct OnCurve {
  std::uint64_t at;
  Index point;
};

/// Radix sort by the 63 bits of the place on the curve, eleven at a time; `room` is a buffer of the same length.
inline void sort_along_curve(std::span<OnCurve> points, std::span<OnCurve> room) {
  constexpr std::size_t digits = 2048;
  for (int shift = 0; shift < 63; shift += 11) {
    std::size_t begin[digits + 1]{};
    const auto digit = [&](const OnCurve& p) { return (p.at >> shift) % digits; };
    for (const OnCurve& p : points) ++begin[digit(p) + 1];
    for (std::size_t d = 0; d < digits; ++d) begin[d + 1] += begin[d];
    for (const OnCurve& p : points) room[begin[digit(p)]++] = p;
    std::copy(room.begin(), room.end(), points.begin());
  }
}

/// Sorts points along the curve through their box; points that 21 bits of a coordinate do not tell apart are sorted
/// along a curve of their own.
inline void order_along_curve(std::span<const Eigen::Vector3d> x, std::span<OnCurve> points, std::span<OnCurve> room) {
  constexpr double finest = 0x1fffff;
  Eigen::Vector3d lower = x[points[0].point];
  double size = 0;
  for (const OnCurve& p : points)
    for (int c = 0; c < 3; ++c) lower(c) = std::min(lower(c), x[p.point](c));
  for (const OnCurve& p : points)
    for (int c = 0; c < 3; ++c) size = std::max(size, x[p.point](c) - lower(c));
  if (!(size > 0 && size < std::numeric_limits<double>::infinity())) return;
  for (OnCurve& p : points) {
    const auto along = [&](int c) {
      const double part = finest * ((x[p.point](c) - lower(c)) / size);
      return spread(part > 0 ? static_cast<std::uint64_t>(std::min(part, finest)) : 0);
    };
    p.at = along(0) | along(1) << 1 | along(2) << 2;
  }
  sort_along_curve(points, room);
  for (std::size_t first = 0, last = 1; first < points.size(); first = last++) {
    while (last < points.size() && points[last].at == points[first].at) ++last;
    if (last - first > 1) order_along_curve(x, points.subspan(first, last - first), room.subspan(first, last - first));
  }
}

}  // namespace detail

/// Numbers of the cells in an order that keeps neighbours together: along Morton's curve (1966) through their
/// centroids, which visits each half, quarter, eighth ... of space before it goes on. Takes time proportional to their
/// number. The order does not depend on that of the list, but for cells with the same centroid.
template <std::size_t n>
std::vector<Index> locality_order(std::span<const Eigen::Vector3d> nodes, const Cells<n>& cells) {
  std::vector<Eigen::Vector3d> centroids(cells.size());
  std::vector<detail::OnCurve> places(cells.size()), room(cells.size());
  for (std::size_t e = 0; e < cells.size(); ++e) {
    centroids[e] = centroid(nodes, cells[e]);
    places[e] = {0, static_cast<Index>(e)};
  }
  if (!cells.empty()) detail::order_along_curve(centroids, places, room);
  std::vector<Index> order(cells.size());
  for (std::size_t e = 0; e < cells.size(); ++e) order[e] = places[e].point;
  return order;
}

}  // namespace strike
