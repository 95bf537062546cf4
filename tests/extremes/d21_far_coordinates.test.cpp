#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "conformance/element.hpp"

using namespace strike;

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
