#include <cmath>
#include <random>

#include <Eigen/LU>

#include <strike/mesh/box.hpp>
#include <strike/mesh/measure.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// Volume of the trilinear map by 2 x 2 x 2 Gauss points, exact for its determinant (quadratic in each coordinate).
double gauss_volume(const std::vector<Eigen::Vector3d>& x) {
  const double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                             {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const double g = 1 / std::sqrt(3.0);
  double volume = 0;
  for (const auto& point : sign) {
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < 8; ++n)
      for (int j = 0; j < 3; ++j) {
        double dN = sign[n][j] / 8;
        for (int k = 0; k < 3; ++k)
          if (k != j) dN *= 1 + sign[n][k] * g * point[k];
        J.col(j) += dN * x[n];
      }
    volume += J.determinant();
  }
  return volume;
}

}  // namespace

TEST_CASE("hexahedron_volume is that of the trilinear map, for any shape and place") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  const Mesh cube = box({.size = {1, 1, 1}});
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Eigen::Vector3d> x;
    for (const Index n : cube.hexahedra[0])
      x.push_back(cube.nodes[n] + Eigen::Vector3d(jitter(random), jitter(random), jitter(random)));
    const std::array<Index, 8> cell{0, 1, 2, 3, 4, 5, 6, 7};
    const double exact = gauss_volume(x);
    CHECK(std::abs(hexahedron_volume(x, cell) - exact) < 1e-14);  // sums of 24 terms of order 1
    std::vector<Eigen::Vector3d> far = x;
    for (auto& p : far) p += Eigen::Vector3d(1e6, -1e6, 1e6);
    CHECK(std::abs(hexahedron_volume(far, cell) - exact) < 1e-8);  // rounding of the positions, 1e6 eps = 2e-10
  }
}

TEST_CASE("volumes are negative inside out, areas are vector areas") {
  Mesh cube = box({.size = {1, 1, 1}});
  auto& c = cube.hexahedra[0];
  std::swap(c[1], c[3]);
  std::swap(c[5], c[7]);
  CHECK(hexahedron_volume(cube.nodes, c) == Approx(-1));
  const std::vector<Eigen::Vector3d> x{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  CHECK(tetrahedron_volume(x, {0, 1, 2, 3}) == Approx(4));
  CHECK(tetrahedron_volume(x, {0, 2, 1, 3}) == Approx(-4));
  CHECK(quadrilateral_area(cube.nodes, {0, 1, 3, 2}) == Approx(1));
}
