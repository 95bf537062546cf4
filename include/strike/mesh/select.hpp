#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// A coordinate axis.
enum class Axis { x, y, z };

/// The unit vector along an axis.
inline Eigen::Vector3d unit(Axis axis) {
  return {axis == Axis::x ? 1.0 : 0.0, axis == Axis::y ? 1.0 : 0.0, axis == Axis::z ? 1.0 : 0.0};
}

/// Diagonal of the smallest box around the nodes [length], to which tolerances are relative.
inline double extent(std::span<const Eigen::Vector3d> nodes) {
  using namespace detail;
  if (nodes.empty()) return 0;
  Eigen::Vector3d lower = nodes[0], upper = nodes[0];
  for (const Eigen::Vector3d& x : nodes)
    for (int c = 0; c < 3; ++c) lower(c) = std::min(lower(c), x(c)), upper(c) = std::max(upper(c), x(c));
  return (upper - lower).norm();
}

/// A condition on a position: `bool(x)`, or `bool(x, size)` where `size` is the extent of all nodes, so that a
/// tolerance can be relative.
template <class P>
concept PositionPredicate =
    std::predicate<P, const Eigen::Vector3d&> || std::predicate<P, const Eigen::Vector3d&, double>;

/// Mean position of the corners of a cell [length]; a wedge has 6, a pyramid 5.
template <std::size_t N>
Eigen::Vector3d centroid(std::span<const Eigen::Vector3d> nodes, const std::array<Index, N>& cell) {
  using namespace detail;
  Eigen::Vector3d sum{0, 0, 0};
  std::size_t count = 0;
  for (std::size_t i = 0; i < N; ++i) {
    if (N == 8 && std::find(cell.begin(), cell.begin() + i, cell[i]) != cell.begin() + i) continue;
    sum += nodes[cell[i]], ++count;
  }
  return (1.0 / static_cast<double>(count)) * sum;
}

namespace detail {
template <PositionPredicate P>
bool holds(P& predicate, const Eigen::Vector3d& x, [[maybe_unused]] double size) {
  if constexpr (std::predicate<P, const Eigen::Vector3d&, double>)
    return predicate(x, size);
  else
    return predicate(x);
}
}  // namespace detail

/// Numbers of the nodes whose position satisfies the predicate, in ascending order:
/// `nodes_where(mesh.nodes, on_plane(Axis::z, 0))`.
template <PositionPredicate P>
std::vector<Index> nodes_where(std::span<const Eigen::Vector3d> nodes, P predicate) {
  const double size = extent(nodes);
  std::vector<Index> chosen;
  for (Index i = 0; i < nodes.size(); ++i)
    if (detail::holds(predicate, nodes[i], size)) chosen.push_back(i);
  return chosen;
}

/// Numbers of all nodes.
inline std::vector<Index> all_nodes(std::span<const Eigen::Vector3d> nodes) {
  return nodes_where(nodes, [](const Eigen::Vector3d&) { return true; });
}

/// Numbers of the cells whose centroid satisfies the predicate, in ascending order:
/// `cells_where(mesh.nodes, mesh.hexahedra, [](const auto& x) { return x[2] < 1; })`.
template <std::size_t N, PositionPredicate P>
std::vector<Index> cells_where(std::span<const Eigen::Vector3d> nodes, const Cells<N>& cells, P predicate) {
  const double size = extent(nodes);
  std::vector<Index> chosen;
  for (Index e = 0; e < cells.size(); ++e)
    if (detail::holds(predicate, centroid<N>(nodes, cells[e]), size)) chosen.push_back(e);
  return chosen;
}

/// The cells with the given numbers, such as those of `cells_where`.
template <std::size_t N>
Cells<N> cells_of(const Cells<N>& cells, std::span<const Index> numbers) {
  Cells<N> chosen;
  for (const Index e : numbers) chosen.push_back(cells.at(e));
  return chosen;
}

/// Number of the node nearest to a place, the lowest of several. Error: no nodes.
inline Index nearest_node(std::span<const Eigen::Vector3d> nodes, const Eigen::Vector3d& place) {
  using namespace detail;
  RangeCheck("nearest_node", "")("place", place, range::point);
  if (nodes.empty()) throw Error("strike: a mesh without nodes has no nearest node; build or read the mesh first.");
  Index nearest = 0;
  for (Index i = 1; i < nodes.size(); ++i)
    if ((nodes[i] - place).squaredNorm() < (nodes[nearest] - place).squaredNorm()) nearest = i;
  return nearest;
}

/// Predicate: in the plane normal . x = offset [length], within `tolerance` times the extent of the mesh.
inline auto on_plane(const Eigen::Vector3d& normal, double offset, double tolerance = 1e-9) {
  const detail::RangeCheck check("on_plane", "");
  check("normal", normal, range::direction), check("offset", offset, range::finite);
  check("tolerance", tolerance, range::not_negative);
  return [n = detail::direction(normal), offset, tolerance](const Eigen::Vector3d& x, double size) {
    return std::abs(n.dot(x) - offset) <= tolerance * size;
  };
}

/// Predicate: in the plane where the coordinate has the given value [length], within `tolerance` times the extent of
/// the mesh.
inline auto on_plane(Axis axis, double offset, double tolerance = 1e-9) {
  return on_plane(unit(axis), offset, tolerance);
}

/// Predicate: on the mantle of the cylinder about the line through `centre` along `axis`, within `tolerance` times the
/// extent.
inline auto on_cylinder(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius,
                        double tolerance = 1e-9) {
  const detail::RangeCheck check("on_cylinder", "");
  check("centre", centre, range::point), check("axis", axis, range::direction);
  check("radius", radius, range::not_negative), check("tolerance", tolerance, range::not_negative);
  return [=, a = detail::direction(axis)](const Eigen::Vector3d& x, double size) {
    using namespace detail;
    const Eigen::Vector3d r = x - centre;
    return std::abs((r - a * a.dot(r)).norm() - radius) <= tolerance * size;
  };
}

/// Predicate: in the box between two corners, which may be infinitely far, its faces included within `tolerance` times
/// the extent.
inline auto in_box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, double tolerance = 1e-9) {
  const detail::RangeCheck check("in_box", "");
  for (const int c : {0, 1, 2}) {
    check("lower", lower(c), Range{.without_low = false});
    check("upper", upper(c), range::or_infinite(range::at_least(lower(c))), "`lower` is the corner of the least ones");
  }
  check("tolerance", tolerance, range::not_negative);
  return [=](const Eigen::Vector3d& x, double size) {
    const auto inside = [&](int c) { return std::min(x(c) - lower(c), upper(c) - x(c)) >= -tolerance * size; };
    return inside(0) && inside(1) && inside(2);
  };
}

/// Predicate: in the ball, its surface included within `tolerance` times the extent.
inline auto in_sphere(const Eigen::Vector3d& centre, double radius, double tolerance = 1e-9) {
  const detail::RangeCheck check("in_sphere", "");
  check("centre", centre, range::point), check("radius", radius, range::not_negative);
  check("tolerance", tolerance, range::not_negative);
  return [=](const Eigen::Vector3d& x, double size) {
    using namespace detail;
    return (x - centre).norm() <= radius + tolerance * size;
  };
}

}  // namespace strike
