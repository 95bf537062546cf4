#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/count.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// The mesh with every node at `place(x)` [length]; the map must keep handedness, which `mirrored` does not, and
/// particles keep their volumes, which `scaled` changes.
template <class Place>
Mesh transformed(Mesh mesh, Place&& place) {
  for (Eigen::Vector3d& x : mesh.nodes) x = Eigen::Vector3d(place(std::as_const(x)));
  return mesh;
}

/// The mesh moved by a displacement [length]. Error: one that is not finite.
inline Mesh translated(Mesh mesh, const Eigen::Vector3d& displacement) {
  using namespace detail;
  RangeCheck("translated", "")("displacement", displacement, range::point);
  return transformed(std::move(mesh), [&](const Eigen::Vector3d& x) { return x + displacement; });
}

/// The mesh turned right-handedly about an axis through the origin by an angle [rad]. Errors: an axis that is
/// zero, a number that is not finite.
inline Mesh rotated(Mesh mesh, const Eigen::Vector3d& axis, double angle) {
  using namespace detail;
  const RangeCheck check("rotated", "");
  check("axis", axis, range::direction), check("angle", angle, range::finite);
  const Eigen::Vector3d n = direction(axis);
  const double c = std::cos(angle), s = std::sin(angle);
  return transformed(std::move(mesh), [&](const Eigen::Vector3d& x) {  // Rodrigues' formula
    return c * x + s * cross(n, x) + (1 - c) * n.dot(x) * n;
  });
}

/// The mesh stretched from the origin by a factor per axis. Error: a factor that is not positive.
inline Mesh scaled(Mesh mesh, const Eigen::Vector3d& factor) {
  detail::RangeCheck("scaled", "")("factor", factor, range::positive, "`mirrored` reflects a mesh");
  for (double& volume : mesh.particles.volumes) volume *= factor.prod();
  return transformed(std::move(mesh), [&](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x[0] * factor[0], x[1] * factor[1], x[2] * factor[2]);
  });
}

/// The mirror image in the plane through the origin with the given normal. Corners are reordered so that volumes stay
/// positive, and plates face the side that they faced. Error: a normal that is zero or not finite.
inline Mesh mirrored(Mesh mesh, const Eigen::Vector3d& normal) {
  using namespace detail;
  RangeCheck("mirrored", "")("normal", normal, range::direction);
  const Eigen::Vector3d n = direction(normal);
  mesh = transformed(std::move(mesh), [&](const Eigen::Vector3d& x) { return x - 2 * n.dot(x) * n; });
  for (auto& c : mesh.hexahedra) c = {c[0], c[3], c[2], c[1], c[4], c[7], c[6], c[5]};
  for (auto& c : mesh.tetrahedra) c = {c[0], c[2], c[1], c[3]};
  for (auto& c : mesh.quadrilaterals) c = {c[0], c[3], c[2], c[1]};
  for (auto& c : mesh.triangles) c = {c[0], c[2], c[1]};
  return mesh;
}

/// Adds a copy of `other` to the mesh without joining nodes; returns the new number of its node 0. Error: 2^32 nodes or
/// more.
inline Index append(Mesh& mesh, const Mesh& other) {
  const std::size_t offset = mesh.nodes.size();
  if (offset + other.nodes.size() > std::numeric_limits<Index>::max())
    throw Error("strike: a mesh holds fewer than 2^32 nodes; keep these two apart.");
  const auto add = [offset](auto& cells, auto added) {  // a copy: `other` may be `mesh` itself
    for (auto& cell : added) {
      for (Index& node : cell) node += static_cast<Index>(offset);
      cells.push_back(cell);
    }
  };
  add(mesh.hexahedra, other.hexahedra);
  add(mesh.tetrahedra, other.tetrahedra);
  add(mesh.quadrilaterals, other.quadrilaterals);
  add(mesh.triangles, other.triangles);
  add(mesh.particles.cells, other.particles.cells);
  const auto volumes = other.particles.volumes;
  mesh.particles.volumes.insert(mesh.particles.volumes.end(), volumes.begin(), volumes.end());
  const auto nodes = other.nodes;
  mesh.nodes.insert(mesh.nodes.end(), nodes.begin(), nodes.end());
  return static_cast<Index>(offset);
}

namespace detail {

/// The mesh with these nodes, where node i has become node `number[i]`.
inline Mesh renumbered(Mesh mesh, std::span<const Index> number, std::vector<Eigen::Vector3d> nodes) {
  const auto renumber = [&](auto& cells) {
    for (auto& cell : cells)
      for (Index& node : cell) node = number[node];
  };
  renumber(mesh.hexahedra);
  renumber(mesh.tetrahedra);
  renumber(mesh.quadrilaterals);
  renumber(mesh.triangles);
  renumber(mesh.particles.cells);
  mesh.nodes = std::move(nodes);
  return mesh;
}

}  // namespace detail

/// The mesh with nodes closer than `tolerance` [length] joined into the first of them; the others keep their order.
/// Error: a tolerance that is not positive.
inline Mesh merge_coincident_nodes(Mesh mesh, double tolerance) {
  using namespace detail;
  RangeCheck("merge_coincident_nodes", "")("tolerance", tolerance, range::positive, "it is a length");
  // Kept nodes are hashed by the cube of edge 4 tolerance that holds them; a node looks into the cubes which its
  // tolerance touches: one, rarely up to eight.
  constexpr Index none = std::numeric_limits<Index>::max();
  std::size_t buckets = 1;
  while (buckets < 2 * mesh.nodes.size()) buckets *= 2;
  std::vector<Index> head(buckets, none), next;
  std::vector<Eigen::Vector3d> kept;
  const auto cube = [&](const Eigen::Vector3d& x) {
    std::array<std::int64_t, 3> index;
    for (std::size_t i = 0; i < 3; ++i)
      index[i] = static_cast<std::int64_t>(std::floor(x[static_cast<Eigen::Index>(i)] / (4 * tolerance)));
    return index;
  };
  const auto bucket = [&](std::int64_t i, std::int64_t j, std::int64_t k) -> std::size_t {
    std::uint64_t hash = 0;
    for (const std::int64_t index : {i, j, k}) {
      hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15u;  // Fibonacci hashing (Knuth, TAOCP 3)
      hash ^= hash >> 32;
    }
    return hash & (buckets - 1);
  };
  const Eigen::Vector3d reach{tolerance, tolerance, tolerance};

  std::vector<Index> number;
  for (const Eigen::Vector3d& x : mesh.nodes) {
    Index same = none;
    const auto lower = cube(x - reach), upper = cube(x + reach);
    for (auto i = lower[0]; i <= upper[0]; ++i)
      for (auto j = lower[1]; j <= upper[1]; ++j)
        for (auto k = lower[2]; k <= upper[2]; ++k)
          for (Index n = head[bucket(i, j, k)]; n != none; n = next[n])
            if ((kept[n] - x).norm() <= tolerance) same = std::min(same, n);
    if (same == none) {
      same = static_cast<Index>(kept.size());
      kept.push_back(x);
      const auto home = cube(x);
      const std::size_t b = bucket(home[0], home[1], home[2]);
      next.push_back(head[b]);
      head[b] = same;
    }
    number.push_back(same);
  }
  return renumbered(std::move(mesh), number, std::move(kept));
}

/// Numbers of the nodes that belong to no cell, in ascending order.
inline std::vector<Index> orphan_nodes(const Mesh& mesh) {
  std::vector<char> used(mesh.nodes.size(), 0);
  const auto mark = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const Index node : cell) used.at(node) = 1;
  };
  mark(mesh.hexahedra);
  mark(mesh.tetrahedra);
  mark(mesh.quadrilaterals);
  mark(mesh.triangles);
  mark(mesh.particles);
  std::vector<Index> orphans;
  for (Index node = 0; node < used.size(); ++node)
    if (!used[node]) orphans.push_back(node);
  return orphans;
}

/// The mesh without the nodes that belong to no cell; the others keep their order.
inline Mesh remove_orphan_nodes(Mesh mesh) {
  const std::vector<Index> orphans = orphan_nodes(mesh);
  std::vector<Index> number(mesh.nodes.size());
  std::vector<Eigen::Vector3d> kept;
  auto orphan = orphans.begin();
  for (Index node = 0; node < number.size(); ++node) {
    if (orphan != orphans.end() && *orphan == node) {
      ++orphan;
      continue;
    }
    number[node] = static_cast<Index>(kept.size());
    kept.push_back(mesh.nodes[node]);
  }
  return detail::renumbered(std::move(mesh), number, std::move(kept));
}

/// Hexahedra swept along z by the quadrilaterals of a plan (counter-clockwise seen from +z), and behind them in each
/// layer wedges by its triangles, one layer between each two levels [length], layer after layer. Errors: fewer than two
/// levels; levels that do not rise.
inline Mesh extruded(const Mesh& plan, std::span<const double> levels) {
  if (levels.size() < 2) throw Error("strike: a plan is extruded between at least two levels; give two or more.");
  for (std::size_t i = 0; i < levels.size(); ++i)
    detail::RangeCheck("extruded", "")(detail::joined({"levels[", std::to_string(i), "]"}), levels[i],
                                       i == 0 ? range::finite : range::above(levels[i - 1]));
  detail::check_count("layers that are extruded", double(plan.nodes.size()) * double(levels.size()));
  Mesh mesh;
  for (const double z : levels)
    for (const Eigen::Vector3d& x : plan.nodes) mesh.nodes.emplace_back(x[0], x[1], x[2] + z);
  const auto stride = static_cast<Index>(plan.nodes.size());
  for (Index layer = 0; layer + 1 < levels.size(); ++layer) {
    const Index foot = layer * stride, head = foot + stride;
    const auto sweep = [&](Index a, Index b, Index c, Index d) {
      mesh.hexahedra.push_back({foot + a, foot + b, foot + c, foot + d, head + a, head + b, head + c, head + d});
    };
    for (const auto& [a, b, c, d] : plan.quadrilaterals) sweep(a, b, c, d);
    for (const auto& [a, b, c] : plan.triangles) sweep(a, b, c, c);
  }
  return mesh;
}

}  // namespace strike
