#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/bird.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/count.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

/// Particles at these places, each with the same share of a volume. Error: there are none.
inline Mesh sharing(std::vector<Eigen::Vector3d> nodes, double spacing, double volume) {
  if (nodes.empty())
    throw Error(joined(
        {"strike: particles ", text(spacing), " apart are too coarse: none is inside the body; give more across it."}));
  Mesh mesh{.nodes = std::move(nodes)};
  for (Index i = 0; i < mesh.nodes.size(); ++i) mesh.particles.cells.push_back({i});
  mesh.particles.volumes.assign(mesh.nodes.size(), volume / static_cast<double>(mesh.nodes.size()));
  return mesh;
}

/// A body of revolution about z: its diameter and length, and where its middle is on the axis.
struct RoundBody {
  double diameter, length, middle;
  BirdForm form = BirdForm::cylinder;

  double volume() const { return std::numbers::pi * std::pow(diameter, 3) * volume_per_cube(form, length / diameter); }
  /// Of a place relative to the middle.
  bool holds(const Eigen::Vector3d& x) const {
    const double R = diameter / 2, half = length / 2, r2 = x[0] * x[0] + x[1] * x[1], z = std::abs(x[2]);
    if (form == BirdForm::ellipsoid) return r2 / (R * R) + z * z / (half * half) < 1;
    if (form == BirdForm::cylinder) return r2 < R * R && z < half;
    const double beyond = std::max(0.0, z - (half - R));  // the straight part
    return r2 + beyond * beyond < R * R;
  }
};

/// Error: `across` is odd or no count.
inline Mesh round_particles(const RoundBody& body, Index across, Sector sector) {
  RangeCheck("particles", "")("across", across, range::between(2, range::count.high));
  if (across % 2 != 0)
    throw Error(joined({"strike: the across of particles is ", std::to_string(across),
                        ", which is odd; an even number has none in the planes of symmetry."}));
  const double h = body.diameter / across, rows = std::ceil(body.length / (2 * h));
  check_count("particles of a body", 2 * rows * across * across);
  const auto half = static_cast<int>(across / 2), half_rows = static_cast<int>(rows);
  std::vector<Eigen::Vector3d> nodes;
  for (int k = -half_rows; k < half_rows; ++k)
    for (int j = sector == Sector::full ? -half : 0; j < half; ++j)
      for (int i = sector == Sector::quarter ? 0 : -half; i < half; ++i)
        if (const Eigen::Vector3d x = h * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5); body.holds(x))
          nodes.emplace_back(x[0], x[1], body.middle + x[2]);
  const double share = sector == Sector::quarter ? 0.25 : sector == Sector::half ? 0.5 : 1;
  return sharing(std::move(nodes), h, share * body.volume());
}

/// The height at which a vertical line passes a face, and whether it goes out of the body there or into it.
struct Passage {
  double z;
  int out;
};

/// On which side of the line from a to b a point is, seen along z.
struct Side {
  double area;  ///< twice that of a, b and the point: zero on the line
  double sign;  ///< of which the sign tells the side
};
/// The same for whatever face has that edge. The sign is zero only on an edge along z: the point is thought to be moved
/// by an infinitely small way along x, and by one that is smaller still along y. Exact for whole numbers whose products
/// are below 2^53.
inline Side side_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double x, double y) {
  const bool turned = std::pair(b[0], b[1]) < std::pair(a[0], a[1]);
  const Eigen::Vector3d &from = turned ? b : a, &to = turned ? a : b;
  const double dx = to[0] - from[0], dy = to[1] - from[1], way = turned ? -1 : 1;
  const double area = dx * (y - from[1]) - dy * (x - from[0]);
  return {way * area, way * (area != 0 ? area : dy != 0 ? -dy : dx)};
}

/// Parts of the spacing of a lattice of particles, to which places are rounded before they are compared: what lies on a
/// line of the lattice but for rounding does lie on it, and sides are told exactly up to 2^10 spacings from one
/// another.
inline constexpr double parts_of_spacing = 65536;

/// A closed surface of triangles, and its passages by columns along z.
class ClosedSurface {
 public:
  /// Error: an edge of the faces that belongs to one of them only, or that two pass in the same direction.
  ClosedSurface(std::span<const Eigen::Vector3d> nodes, const std::vector<Face>& faces, double spacing)
      : nodes_(nodes), places_(nodes.begin(), nodes.end()) {
    for (Eigen::Vector3d& place : places_) place = (place * (parts_of_spacing / spacing)).array().round();
    for (const Face& face : faces) {
      triangles_.push_back({face.nodes[0], face.nodes[1], face.nodes[2]});
      if (!face.is_triangle()) triangles_.push_back({face.nodes[0], face.nodes[2], face.nodes[3]});
    }
    check_closed();
    for (const auto& [a, b, c] : triangles_) volume_ += nodes[a].dot(nodes[b].cross(nodes[c])) / 6;
  }

  /// Volume that the triangles enclose, negative if they face inwards [length^3].
  double volume() const { return volume_; }

  /// Corners of triangle t, in whole parts of the spacing.
  std::array<Eigen::Vector3d, 3> corners(std::size_t t) const {
    return {places_[triangles_[t][0]], places_[triangles_[t][1]], places_[triangles_[t][2]]};
  }
  std::size_t size() const { return triangles_.size(); }

  /// Adds the passage of the vertical line at (x, y) through triangle t, if there is one [parts of the spacing].
  void pass(std::size_t t, double x, double y, std::vector<Passage>& passages) const {
    const auto [a, b, c] = corners(t);
    const Side ab = side_of(a, b, x, y), bc = side_of(b, c, x, y), ca = side_of(c, a, x, y);
    const bool out = ab.sign > 0 && bc.sign > 0 && ca.sign > 0, in = ab.sign < 0 && bc.sign < 0 && ca.sign < 0;
    if (!out && !in) return;
    const double area = ab.area + bc.area + ca.area, z = bc.area * a[2] + ca.area * b[2] + ab.area * c[2];
    passages.push_back({area != 0 ? std::round(z / area) : a[2], out ? 1 : -1});
  }

 private:
  void check_closed() const {
    std::vector<std::array<Index, 3>> edges;  // lower node, higher node, direction
    for (const auto& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b), a < b ? 0u : 1u});
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
      int sum = 0;
      for (; last < edges.size() && edges[last][0] == edges[first][0] && edges[last][1] == edges[first][1]; ++last)
        sum += edges[last][2] == 0 ? 1 : -1;
      if (sum != 0)
        throw Error(
            joined({"strike: the surface to fill with particles is open, or its faces do not all face "
                    "outwards, at the edge of nodes ",
                    std::to_string(edges[first][0]), " and ", std::to_string(edges[first][1]), " at ",
                    text(nodes_[edges[first][0]]), "; close it."}));
    }
  }

  std::span<const Eigen::Vector3d> nodes_;
  std::vector<Eigen::Vector3d> places_;  // of the nodes [parts of the spacing]
  std::vector<std::array<Index, 3>> triangles_;
  double volume_ = 0;
};

}  // namespace detail

/// Particles that fill the smooth body of a bird: the points inside it of a cubic lattice. All have the same volume,
/// the body's over their number, so that its mass is exact: but for the stairs along the surface the cube of the
/// spacing. They are D/across apart, those of planes of symmetry half a spacing from them, of which its middle is one.
/// Of a quarter and a half they are exactly those of the whole. Its `cells` and `layers` have no say. Errors: those of
/// `size_of`; `across` odd or below 2; a body so flat that no particle is inside.
inline Mesh particles(const BirdShape& shape, Index across) {
  const auto [D, L] = size_of(shape);
  return detail::round_particles({D, L, L / 2, shape.form}, across, shape.sector);
}
/// Of a round bar, in the same way.
inline Mesh particles(const CylinderShape& shape, Index across) {
  detail::check_ranges(shape);
  return detail::round_particles({2 * shape.radius, shape.length, shape.length / 2}, across, shape.sector);
}
/// Of a ball, in the same way.
inline Mesh particles(const SphereShape& shape, Index across) {
  detail::check_ranges(shape);
  return detail::round_particles({2 * shape.radius, 2 * shape.radius, 0, BirdForm::ellipsoid}, across, shape.sector);
}

/// Particles of a brick, one in the middle of each of the cells that its `cells` cut it into, whatever its grading;
/// cubes are best. Errors: a number out of its range; 2^32 particles or more.
inline Mesh particles(const BoxShape& shape) {
  detail::check_ranges(shape);
  const auto [nx, ny, nz] = shape.cells;
  detail::check_count("particles of a box", double(nx) * double(ny) * double(nz));
  std::vector<Eigen::Vector3d> nodes;
  const auto at = [&](Eigen::Index c, Index i, Index n) { return shape.lower[c] + shape.size[c] * ((i + 0.5) / n); };
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) nodes.emplace_back(at(0, i, nx), at(1, j, ny), at(2, k, nz));
  const double volume = shape.size.prod();
  return detail::sharing(std::move(nodes), std::cbrt(volume / (double(nx) * ny * nz)), volume);
}

/// Particles inside hexahedra and tetrahedra, or if there are none inside closed surfaces of plates. They lie
/// half a spacing [length] from the planes x = 0, y = 0 and z = 0, so that what these planes cut off a body takes its
/// own particles away and no others. A point belongs to the body if a vertical line through it leaves the body above it
/// once more than it enters; faces of four corners are cut along their first diagonal. Places are told apart to 2^-16
/// of the spacing. Errors: a spacing that is not positive; an open surface, or faces that look both ways; no particle
/// inside; 2^32 of them or more.
inline Mesh particles(const Mesh& body, double spacing) {
  using namespace detail;
  RangeCheck("particles", "")("spacing", spacing, range::positive, "it is a length");
  const bool is_solid = !body.hexahedra.empty() || !body.tetrahedra.empty();
  Mesh solid{.nodes = body.nodes, .hexahedra = body.hexahedra, .tetrahedra = body.tetrahedra};
  const Mesh plates{.nodes = {}, .quadrilaterals = body.quadrilaterals, .triangles = body.triangles};
  const std::vector<Face> skin = surface(is_solid ? solid : plates);
  if (skin.empty()) throw Error("strike: a mesh without cells has no inside to fill with particles; build it first.");
  const ClosedSurface closed(body.nodes, skin, spacing);
  const int outwards = closed.volume() < 0 ? -1 : 1;

  // The columns of the lattice over the box of the body, and their passages.
  const auto at = [](double i) { return (i + 0.5) * parts_of_spacing; };
  const auto lowest = [](double x) { return std::floor(x / parts_of_spacing - 0.5); };  // lattice point at or below x
  const auto box_of = [&](std::size_t t) {
    const auto [a, b, c] = closed.corners(t);
    return std::pair<Eigen::Vector3d, Eigen::Vector3d>(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
  };
  auto [lower, upper] = box_of(0);
  for (std::size_t t = 1; t < closed.size(); ++t) {
    const auto [low, high] = box_of(t);
    lower = lower.cwiseMin(low), upper = upper.cwiseMax(high);
  }
  const double x0 = lowest(lower[0]), y0 = lowest(lower[1]), z0 = lowest(lower[2]);
  const double nx = lowest(upper[0]) - x0 + 1, ny = lowest(upper[1]) - y0 + 1, nz = lowest(upper[2]) - z0 + 1;
  check_count("particles of a body", nx * ny * nz);
  std::vector<std::vector<Passage>> passages(static_cast<std::size_t>(nx * ny));
  const auto column = [nx](double i, double j) { return static_cast<std::size_t>(i + nx * j); };
  for (std::size_t t = 0; t < closed.size(); ++t) {
    const auto [low, high] = box_of(t);
    for (double j = lowest(low[1]); j <= lowest(high[1]); ++j)
      for (double i = lowest(low[0]); i <= lowest(high[0]); ++i)
        closed.pass(t, at(i), at(j), passages[column(i - x0, j - y0)]);
  }

  std::vector<Eigen::Vector3d> nodes;
  const auto place = [spacing](double i) { return (i + 0.5) * spacing; };
  for (double k = z0; k < z0 + nz; ++k)
    for (double j = 0; j < ny; ++j)
      for (double i = 0; i < nx; ++i) {
        int out = 0;
        for (const Passage& passage : passages[column(i, j)]) out += passage.z > at(k) ? passage.out : 0;
        if (out * outwards > 0) nodes.emplace_back(place(x0 + i), place(y0 + j), place(k));
      }
  return sharing(std::move(nodes), spacing, is_solid ? volume(solid) : std::abs(closed.volume()));
}

/// A particle at each node of some hexahedra or tetrahedra, in the order in which these name them, with its share of
/// their volumes: what Debris makes of them. The positions are those of all nodes.
template <std::size_t n>
  requires(n == 8 || n == 4)
Particles particles_at_nodes(std::span<const Eigen::Vector3d> nodes, const Cells<n>& cells) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> particle(nodes.size(), none);
  Particles made;
  for (const auto& cell : cells) {
    const double volume = solid_volume(nodes, cell);
    const std::array<double, n> shares = detail::corner_shares(cell);
    for (std::size_t i = 0; i < n; ++i) {
      const Index node = cell[i];
      if (particle[node] == none) {
        particle[node] = made.size();
        made.cells.push_back({node}), made.volumes.push_back(0);
      }
      made.volumes[particle[node]] += shares[i] * volume / n;
    }
  }
  return made;
}

}  // namespace strike
