#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include <strike/mesh/transform.hpp>

namespace strike::testing {

/// Numbers of the nodes that a mesh gets by a copy of another.
inline std::vector<Index> append_body(Mesh& mesh, const Mesh& body) {
  std::vector<Index> numbers(body.nodes.size());
  Index next = append(mesh, body);
  for (Index& i : numbers) i = next++;
  return numbers;
}

/// The largest distance between the same nodes of two runs.
inline double apart(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

}  // namespace strike::testing
