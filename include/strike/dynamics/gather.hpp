#pragma once
#include <array>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/nodes.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The nodes of a block of elements: node[i][l] is node i of the element in lane l.
template <std::size_t n, std::size_t lanes>
using BlockNodes = std::array<std::array<Index, lanes>, n>;

/// Nodal vectors into lanes.
template <class T, std::size_t n>
Eigen::Matrix<T, 3, static_cast<int>(n)> gather(const std::vector<Padded<RealOf<T>>>& field,
                                                const BlockNodes<n, lanes<T>>& nodes) {
  Eigen::Matrix<T, 3, static_cast<int>(n)> a;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (int c = 0; c < 3; ++c) set_lane(a(c, static_cast<int>(i)), l, field[nodes[i][l]].x[c]);
  return a;
}

/// field -= f for the first `count` lanes, lane after lane.
template <class T, std::size_t n>
void scatter_subtract(const Eigen::Matrix<T, 3, static_cast<int>(n)>& f, std::vector<Padded<RealOf<T>>>& field,
                      const BlockNodes<n, lanes<T>>& nodes, std::size_t count) {
  for (std::size_t l = 0; l < count; ++l)
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c) field[nodes[i][l]].x[c] -= lane(f(c, static_cast<int>(i)), l);
}

}  // namespace strike
