#include <algorithm>
#include <numeric>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/box.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

/// The largest stress, over the modulus, while a cube of edge h flies 100 h far from the origin: the noise of its
/// positions.
template <class E>
double noise(const E& element, double offset, double h) {
  const Nodal<double, 8> x = (h * unit_cube()).array() + offset;
  SingleElement single{element, testing::metal, x};
  double worst = 0;
  const Nodal<double, 8> v = Eigen::Vector3d(1, -2, 3).replicate(1, 8) * h;
  for (int i = 0; i < 1000; ++i) worst = std::max(worst, single.step(v, 0.1 / 3).stress.matrix().norm());
  return worst / testing::metal.eos.bulk_modulus;
}

}  // namespace

TEST_CASE("D21: a stress at 1e6 from the origin is the noise of the positions: eps offset/h, and it does not add up") {
  CHECK(noise(Hex8{}, 1e6, 1.0) < 1e-9);
  CHECK(noise(Hex8{}, 1e6, 1e-3) < 1e-6);
  CHECK(noise(Hex8Full{}, 1e6, 1.0) < 1e-9);
  CHECK(noise(Hex8Full{}, 1e6, 1e-3) < 1e-6);
}

TEST_CASE("D21: so is the force on a plate, in which hourglass and drilling resist too") {
  const auto noise_of_forces = [](const auto& element, double h) {
    const Homogeneous section{PlaneStress{testing::metal}, 0.1 * h};
    testing::Quadrilaterals shapes(21);
    const Nodal<double, 4> x = (h * shapes()).array() + 1e6;
    SingleElement single{element, section, x};
    Nodal<double, 8> v = Nodal<double, 8>::Zero();
    v.leftCols<4>().colwise() = h * Eigen::Vector3d(1, -2, 3);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) worst = std::max(worst, single.step(v, 0.1 / 3).force.norm());
    return worst / (0.1 * h * h);
  };
  for (const double h : {1.0, 1e-3}) {
    const double allowed = h == 1 ? 1e-9 : 1e-6;
    CHECK(noise_of_forces(Plate4{}, h) < allowed);
    CHECK(noise_of_forces(Plate4{PlateHourglass{}, RigidOffset{}}, h) < allowed);
  }
}

TEST_CASE("D21: the gradient operator far away errs by the spacing of the positions there") {
  const double offset = 1e6, h = 1e-3;
  testing::Shapes<8> shapes(20);
  for (int trial = 0; trial < 10; ++trial) {
    const Nodal<double, 8> far = (h * shapes()).array() + offset;
    const Nodal<double, 8> near = far.array() - offset;  // exact
    const auto sigma = SymmetricTensor<double>::isotropic(1);
    const auto B = testing::detail::forces(Hex8{}, sigma, near);
    const double spacing = offset * std::numeric_limits<double>::epsilon();
    CHECK((testing::detail::forces(Hex8{}, sigma, far) - B).norm() <= 8 * spacing / h * B.norm());
  }
}

TEST_CASE("D21: in mixed precision a bar far from the origin swings as at it") {
  const auto stress = [](double offset, auto numbers) {
    const Mesh bar = box({.lower = {offset, offset, offset}, .size = {1, 1, 4}, .cells = {2, 2, 8}});
    std::vector<Index> half(bar.nodes.size() / 2);
    std::iota(half.begin(), half.end(), Index{0});
    Explicit run{Scene{bar.nodes, Part{Hex8{}, testing::metal, bar.hexahedra}, InitialVelocity{{0.01, 0, 0.01}, half}},
                 {},
                 numbers};
    for (int i = 0; i < 200; ++i) run.step();
    return run.template part<0>().field([](const auto& state) { return state.stress.zz; });
  };
  const auto near = stress(0, in<Pack<double>>), far = stress(1e5, in<Pack<float>, double>);
  double largest = 0, error = 0;
  for (std::size_t e = 0; e < near.size(); ++e)
    largest = std::max(largest, std::abs(near[e])), error = std::max(error, std::abs(far[e] - near[e]));
  CHECK(error < 1e-3 * largest);  // strains of some 1e-3 are told to eps = 6e-8
  CHECK_THROWS_WITH(stress(1e5, in<Pack<float>>), Catch::Matchers::ContainsSubstring("move the mesh to the origin"));
}
