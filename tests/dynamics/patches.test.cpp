#include <numeric>

#include <strike/dynamics/patches.hpp>
#include <strike/mesh/box.hpp>
#include <strike/motion/nodes.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr std::size_t lanes_of_block = 8;

std::vector<Index> as_numbered(std::size_t size) {
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), Index{0});
  return order;
}

/// A bar of 960 hexahedra, whose nodes are renumbered as its elements name them first, cut into patches.
template <class Real, class ElementReal>
struct Bar {
  Mesh mesh = named_in_order(box({.size = {4, 4, 60}, .cells = {4, 4, 60}}));
  Nodes<Real, ElementReal> nodes{mesh.nodes, as_numbered(mesh.nodes.size())};
  std::size_t blocks = mesh.hexahedra.size() / lanes_of_block;
  std::vector<Index> named, corners;  // without and with ghosts
  detail::Patches patches;

  Bar() {
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t l = 0; l < lanes_of_block; ++l) named.push_back(mesh.hexahedra[b * lanes_of_block + l][i]);
    corners = named;
    patches = detail::Patches(corners, blocks, lanes_of_block, 0, nodes.places());
    nodes.add_ghosts(patches.sources());
  }

  /// Where the corners of patch p stand in the list.
  std::pair<std::size_t, std::size_t> corners_of(std::size_t p) const {
    return {patches[p].first_block * 8 * lanes_of_block, patches[p].last_block * 8 * lanes_of_block};
  }

  static Mesh named_in_order(const Mesh& mesh) {
    Mesh renumbered;
    std::vector<Index> number(mesh.nodes.size(), Index(mesh.nodes.size()));
    for (const auto& cell : mesh.hexahedra) {
      renumbered.hexahedra.push_back(cell);
      for (Index& i : renumbered.hexahedra.back()) {
        if (number[i] == mesh.nodes.size()) {
          number[i] = static_cast<Index>(renumbered.nodes.size());
          renumbered.nodes.push_back(mesh.nodes[i].array().round());
        }
        i = number[i];
      }
    }
    return renumbered;
  }
};

}  // namespace

TEST_CASE("a patch names its own nodes and its ghosts, which stand for the nodes that it had named") {
  const Bar<double, double> bar;
  REQUIRE(bar.patches.size() == 8);  // of 128 elements; the last of 64
  Index next_node = 0, next_ghost = static_cast<Index>(bar.nodes.size());
  std::size_t next_block = 0;
  for (std::size_t p = 0; p < bar.patches.size(); ++p) {
    const detail::Patch& patch = bar.patches[p];
    CHECK(patch.first_block == next_block);
    CHECK(patch.first_node == next_node);
    CHECK(patch.first_ghost == next_ghost);
    next_block = patch.last_block, next_node = patch.last_node, next_ghost = patch.last_ghost;
    for (auto [k, last] = bar.corners_of(p); k < last; ++k) {
      const Index place = bar.corners[k];
      const bool own = patch.first_node <= place && place < patch.last_node,
                 ghost = patch.first_ghost <= place && place < patch.last_ghost;
      REQUIRE(own != ghost);
      REQUIRE(bar.nodes.number(place) == bar.named[k]);
    }
  }
  CHECK(next_block == bar.blocks);
  CHECK(next_node == bar.nodes.size());
  CHECK(next_ghost == bar.nodes.places());
}

TEMPLATE_TEST_CASE("forces on own nodes and ghosts add up to those on the nodes", "", double, float) {
  Bar<double, TestType> bar;
  std::vector<double> valence(bar.nodes.size());
  for (const Index i : bar.named) valence[i] += 1;
  for (int step = 0; step < 2; ++step) {  // what was there before is gone
    for (std::size_t p = 0; p < bar.patches.size(); ++p) {
      bar.patches.load(bar.patches[p], bar.nodes);
      for (auto [k, last] = bar.corners_of(p); k < last; ++k) bar.nodes.motion().force[bar.corners[k]] += 1;
      bar.patches.store(bar.patches[p], bar.nodes);
    }
    bar.patches.store_ghosts(bar.nodes, Serial{});
  }
  for (std::size_t i = 0; i < valence.size(); ++i) REQUIRE(bar.nodes.f(i).z() == valence[i]);
}

TEMPLATE_TEST_CASE("a patch has the motion of its nodes, in a copy relative to one of them", "", double, float) {
  Bar<double, TestType> bar;
  const Eigen::Vector3d far(1e7, -1e7, 1e7);  // where floats are 1 apart
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    bar.nodes.set_position(i, bar.mesh.nodes[i] + far);
    bar.nodes.set_velocity(i, {0.5 * static_cast<double>(i), 0, 0});
  }
  for (std::size_t p = 0; p < bar.patches.size(); ++p) {
    bar.patches.load(bar.patches[p], bar.nodes);
    const auto& motion = bar.nodes.motion();
    const auto [first, last] = bar.corners_of(p);
    for (std::size_t k = first; k < last; ++k) {
      const Index i = bar.corners[k], i0 = bar.corners[first];
      const Eigen::Vector3d X = bar.mesh.nodes[bar.named[k]] - bar.mesh.nodes[bar.named[first]];
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(motion.position[i][c] - motion.position[i0][c] == X(static_cast<int>(c)));  // whole numbers: exact
      REQUIRE(motion.velocity[i][0] == 0.5 * bar.named[k]);
    }
  }
}
