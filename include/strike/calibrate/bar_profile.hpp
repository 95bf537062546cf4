#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::calibrate {

/// The shape of a round bar along z: the rings of nodes of its mantle, from its foot on, by their mean height and
/// radius. T: double or Dual.
template <class T>
struct BarProfile {
  struct Ring {
    T z{}, radius{};
  };
  std::vector<Ring> rings;

  T length() const { return rings.back().z; }
  T foot_radius() const { return rings.front().radius; }
  /// Linear between two rings. Errors: a height that is not on the bar.
  T radius_at(double height) const {
    for (std::size_t i = 1; i < rings.size(); ++i) {
      const Ring &a = rings[i - 1], &b = rings[i];
      if (a.z <= height && height <= b.z) return a.radius + (height - a.z) / (b.z - a.z) * (b.radius - a.radius);
    }
    throw Error(detail::joined({"strike: the height ", detail::text(height), " is not on the bar, which goes from ",
                                detail::text(static_cast<double>(rings.front().z)), " to ",
                                detail::text(static_cast<double>(length())), "; measure the radius there."}));
  }
};

/// The profile of a bar in a run, whose mesh was a cylinder about the z axis, or a sector of one: `bar_profile(bar,
/// run.nodes())`.
template <class N>
BarProfile<typename N::Number> bar_profile(const Mesh& bar, const N& nodes) {
  using T = typename N::Number;
  double R = 0;
  for (const auto& X : bar.nodes) R = std::max(R, std::hypot(X.x(), X.y()));
  std::vector<Index> mantle;
  for (Index i = 0; i < bar.nodes.size(); ++i)
    if (std::hypot(bar.nodes[i].x(), bar.nodes[i].y()) > (1 - 1e-6) * R) mantle.push_back(i);
  std::stable_sort(mantle.begin(), mantle.end(), [&](Index i, Index j) { return bar.nodes[i].z() < bar.nodes[j].z(); });

  BarProfile<T> profile;
  for (std::size_t first = 0, last; first < mantle.size(); first = last) {
    typename BarProfile<T>::Ring ring;
    for (last = first; last < mantle.size() && bar.nodes[mantle[last]].z() - bar.nodes[mantle[first]].z() < 1e-6 * R;
         ++last) {
      const typename N::Vector x = nodes.x(mantle[last]);
      ring.z += x.z(), ring.radius += sqrt(x.x() * x.x() + x.y() * x.y());
    }
    const double count = static_cast<double>(last - first);
    profile.rings.push_back({ring.z / count, ring.radius / count});
  }
  return profile;
}

}  // namespace strike::calibrate
