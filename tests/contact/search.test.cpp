#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/search.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>

#include "support/catch.hpp"

namespace {

using namespace strike;

TEST_CASE("a search finds the faces whose enlarged boxes hold a node, and no other") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1), edge(0, 0.1);
  std::vector<Eigen::Vector3d> x;
  std::vector<Index> nodes;
  std::vector<std::array<Index, 4>> faces;
  for (Index i = 0; i < 300; ++i) nodes.push_back(i), x.emplace_back(place(random), place(random), 0.2 * place(random));
  for (Index f = 0; f < 200; ++f) {
    const Eigen::Vector3d corner(place(random), place(random), 0.2 * place(random));
    const auto first = static_cast<Index>(x.size());
    const double size = f == 0 ? 20 : 1;  // one is much larger than the others
    for (int k = 0; k < 4; ++k) x.push_back(corner + size * Eigen::Vector3d(edge(random), edge(random), edge(random)));
    faces.push_back({first, first + 1, first + 2, first + 3});
  }
  const double reach = 0.15;
  const auto less = [&](Index s, Index f) {
    return (s + f) % 7 == 0 ? std::numeric_limits<double>::infinity() : 0.01 * static_cast<double>((s + 3 * f) % 10);
  };
  detail::BucketSearch search;
  REQUIRE(search.sort(nodes, faces, x, reach, Serial{}, less) == 0);
  std::size_t found = 0;
  for (Index s = 0; s < nodes.size(); ++s) {
    std::vector<Index> expected;
    for (Index f = 0; f < faces.size(); ++f) {
      Eigen::Array3d lower = x[faces[f][0]], upper = lower;
      for (const Index i : faces[f]) lower = lower.min(x[i].array()), upper = upper.max(x[i].array());
      const double grown = reach - less(s, f);
      if ((x[s].array() >= lower - grown).all() && (x[s].array() <= upper + grown).all()) expected.push_back(f);
    }
    const auto near = search.near(s);
    CHECK(std::vector<Index>(near.begin(), near.end()) == expected);
    CHECK(std::binary_search(search.awake().begin(), search.awake().end(), s) == !expected.empty());
    found += expected.size();
  }
  CHECK(found > 1000);
  CHECK(search.size() == found);
}

}  // namespace
