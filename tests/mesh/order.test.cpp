#include <algorithm>
#include <random>

#include <strike/mesh/box.hpp>
#include <strike/mesh/order.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

template <class T>
std::vector<T> shuffled(std::vector<T> a, unsigned seed) {
  std::shuffle(a.begin(), a.end(), std::mt19937(seed));
  return a;
}

/// The cells as they stand in the order.
Cells<8> in_order(const Mesh& mesh, const Cells<8>& cells) {
  Cells<8> sorted;
  for (const Index e : locality_order(mesh.nodes, cells)) sorted.push_back(cells[e]);
  return sorted;
}

}  // namespace

TEST_CASE("order: every cell once, and the same sequence however the cells are given") {
  const Mesh mesh = box({.size = {3, 1, 2}, .cells = {12, 5, 7}});
  std::vector<Index> order = locality_order(mesh.nodes, mesh.hexahedra);
  const Cells<8> sorted = in_order(mesh, mesh.hexahedra);
  for (const unsigned seed : {1u, 2u, 3u}) CHECK(in_order(mesh, shuffled(mesh.hexahedra, seed)) == sorted);
  std::sort(order.begin(), order.end());
  for (std::size_t e = 0; e < order.size(); ++e) CHECK(order[e] == e);
}

TEST_CASE("order: the curve visits each octant of a cube before the next") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {8, 8, 8}});
  const std::vector<Index> order = locality_order(mesh.nodes, shuffled(mesh.hexahedra, 1));
  const Cells<8> sorted = in_order(mesh, mesh.hexahedra);
  for (std::size_t octant = 0; octant < 8; ++octant)
    for (std::size_t e = 64 * octant; e < 64 * (octant + 1); ++e) {
      const Eigen::Vector3d x = centroid(mesh.nodes, sorted[e]);
      for (std::size_t c = 0; c < 3; ++c) CHECK((x(static_cast<int>(c)) > 0.5) == ((octant >> c) % 2 == 1));
    }
}

TEST_CASE("order: cells beside one that is very far are told apart all the same") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {4, 4, 4}});
  const auto near = static_cast<Index>(mesh.nodes.size());
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = mesh.nodes[mesh.hexahedra[0][static_cast<std::size_t>(i)]];
    mesh.nodes.push_back(corner + Eigen::Vector3d(1e12, 0, 0));
  }
  mesh.hexahedra.push_back({near, near + 1, near + 2, near + 3, near + 4, near + 5, near + 6, near + 7});
  const Cells<8> sorted = in_order(mesh, mesh.hexahedra);
  CHECK(in_order(mesh, shuffled(mesh.hexahedra, 4)) == sorted);
  CHECK(sorted.back() == mesh.hexahedra.back());
}

TEST_CASE("order: no cells, one cell, and cells in one place") {
  const Mesh mesh = box({.size = {1, 1, 1}});
  CHECK(locality_order(mesh.nodes, Cells<8>{}).empty());
  CHECK(locality_order(mesh.nodes, mesh.hexahedra) == std::vector<Index>{0});
  CHECK(locality_order(mesh.nodes, Cells<8>(3, mesh.hexahedra[0])) == std::vector<Index>{0, 1, 2});
}
