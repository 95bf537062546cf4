// The direction of fibres, in whole scenes: it must not depend on how the scene lies or how its mesh is numbered.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material/point_values.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/delamination.hpp>
#include <strike/verify/single_element.hpp>

#include "support/catch.hpp"
#include "support/plies.hpp"

using namespace strike;
using testing::carbon, testing::carbon_hashin;

namespace {

using Vectors = std::vector<Eigen::Vector3d>;

/// A plate of distorted cells, struck somewhere beside its middle, that breaks matrix and fibres.
struct Struck {
  Mesh mesh = rectangle({.size = {20, 16}, .cells = {5, 4}});
  std::vector<double> angles{10, 70, -20, 35};
  Eigen::Vector3d along{1, 0, 0};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< or mirror, of the whole scene
  double ply = 0.125;

  Struck() {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      const double s = std::sin(3.7 * static_cast<double>(i)), c = std::cos(2.3 * static_cast<double>(i * i));
      mesh.nodes[i] += Eigen::Vector3d(0.5 * s, 0.5 * c, 0.05 * s * c);
    }
  }

  auto section() const { return testing::of_four(FailingPly{carbon, carbon_hashin}, ply, angles, turn * along); }
  struct Blow {
    Eigen::Matrix3d turn;
    template <class N>
    void begin(N& nodes) const {
      for (const std::size_t i : {14u, 15u, 20u}) nodes.set_velocity(i, turn * Eigen::Vector3d(1e4, -1e4, 2e5));
    }
  };
  /// Where the nodes are and what the plies are like, in the scene that is not turned.
  struct Outcome {
    Vectors positions;
    std::vector<double> matrix, fibres, delamination;
  };
  Outcome operator()() const {
    Mesh turned = mesh;
    for (auto& x : turned.nodes) x = turn * x;
    Explicit run{Scene{turned.nodes, Part{Plate4{}, section(), turned.quadrilaterals}, Blow{turn}}};
    run.until(1.2e-5);
    const auto& part = run.part<0>();
    Outcome out{{}, part.field(MatrixFailed{}), part.field(Failed{}), part.field(Delamination{.shear_strength = 60})};
    for (std::size_t i = 0; i < turned.nodes.size(); ++i)
      out.positions.push_back(turn.transpose() * Eigen::Vector3d(run.nodes().x(i)) - mesh.nodes[i]);
    return out;
  }
};

/// To 1e-9 of the largest displacement.
void same(const Struck::Outcome& a, const Struck::Outcome& b) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    largest = std::max(largest, a.positions[i].norm());
    difference = std::max(difference, (a.positions[i] - b.positions[i]).norm());
  }
  CHECK(difference <= 1e-9 * largest);
  CHECK(a.matrix == b.matrix);
  CHECK(a.fibres == b.fibres);
  for (std::size_t e = 0; e < a.delamination.size(); ++e)
    CHECK(a.delamination[e] == Approx(b.delamination[e]).epsilon(1e-6).margin(1e-9));
}
double sum(const std::vector<double>& a) {
  double s = 0;
  for (const double x : a) s += x;
  return s;
}

}  // namespace

TEST_CASE("fibres: their direction turns with the scene, not with its mesh") {
  const Struck plain;
  const Struck::Outcome expected = plain();
  const double cells = static_cast<double>(expected.matrix.size());
  CHECK(sum(expected.matrix) > 0.2 * cells);
  CHECK(sum(expected.matrix) < 0.95 * cells);
  CHECK(sum(expected.fibres) > 0);
  CHECK(sum(expected.delamination) > 0);

  SECTION("turned with its direction") {
    Struck turned;
    turned.turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    same(expected, turned());
  }
  SECTION("the direction turned, and all angles back") {
    Struck turned;
    turned.along = Eigen::AngleAxisd(40 * std::acos(-1.) / 180, Eigen::Vector3d::UnitZ()) * turned.along;
    turned.along.z() = 3;  // along the normal, which does not count here but for the warp of the cells
    for (auto& x : turned.mesh.nodes) x.z() = 0;
    for (double& a : turned.angles) a -= 40;
    Struck flat;
    flat.mesh = turned.mesh;
    same(flat(), turned());
  }
  SECTION("corners from another one on, and cells in another order") {
    for (std::size_t by = 1; by < 4; ++by) {
      Struck renumbered;
      for (auto& cell : renumbered.mesh.quadrilaterals)
        std::rotate(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(by), cell.end());
      same(expected, renumbered());
    }
  }
  SECTION("corners the other way round, plies in the other order and angles negative") {
    Struck flipped;
    for (auto& cell : flipped.mesh.quadrilaterals) std::swap(cell[1], cell[3]);
    flipped.angles = {-35, 20, -70, -10};
    same(expected, flipped());
  }
  SECTION("mirrored: angles negative") {
    Struck mirrored;
    mirrored.turn = Eigen::Vector3d(1, -1, 1).asDiagonal();
    for (auto& cell : mirrored.mesh.quadrilaterals) std::swap(cell[1], cell[3]);  // the normal stays
    for (double& a : mirrored.angles) a = -a;
    same(expected, mirrored());
  }
  SECTION("half a turn of each ply is none") {
    Struck half;
    for (double& a : half.angles) a += 180;
    same(expected, half());
  }
}

TEST_CASE("fibres: a direction that is normal to a plate is refused by its number") {
  using Catch::Matchers::ContainsSubstring;
  Struck scene;
  scene.mesh = rectangle({.size = {2, 2}, .cells = {2, 2}});
  scene.mesh.nodes[8].z() = 1;  // only the last plate is not horizontal
  scene.along = {0, 0, 1};
  CHECK_THROWS_WITH((Explicit{Scene{scene.mesh.nodes, Part{Plate4{}, scene.section(), scene.mesh.quadrilaterals}}}),
                    ContainsSubstring("element 0 of part 0 at") &&
                        ContainsSubstring("is normal to the FibreDirection of its section"));
}

// A strain along the direction, on plates that lie in it by any angle: the stresses of plies are the same.
TEST_CASE("fibres: stresses of plies are those along and across them on every plate") {
  const double e = 1e-4;
  const auto section = testing::of_four(carbon, 0.125, {0, 90, 30, -45});
  for (const double by : {0., 25., 90., 135.}) {
    Nodal<double, 4> x = verify::unit_square();
    x.row(0) *= 3;
    x = Eigen::AngleAxisd(by * std::acos(-1.) / 180, Eigen::Vector3d::UnitZ()).toRotationMatrix() * x.eval();
    verify::SingleElement plate{Plate4{}, section, x};
    Nodal<double, 8> v = Nodal<double, 8>::Zero();
    v.row(0).head(4) = e * x.row(0);
    plate.step(v, 1.0);
    std::size_t k = 0;
    for (const double angle : {0., 90., 30., -45.}) {
      const auto own = carbon.elastic(turn_by_degrees(angle).into(PlaneTensor<double>{e, 0, 0}));
      plate.state().each_point(k++, [&](const auto& point) {
        CHECK(point.stress.xx == Approx(own.xx).epsilon(2 * e));  // the step is finite
        CHECK(point.stress.yy == Approx(own.yy).epsilon(2 * e).margin(carbon.E1 * e * e));
        CHECK(point.stress.xy == Approx(own.xy).epsilon(2 * e).margin(carbon.E1 * e * e));
      });
    }
  }
}
