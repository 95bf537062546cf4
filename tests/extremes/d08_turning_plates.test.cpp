#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/section.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

using P = Pack<double, 2>;
using Plate = Plate4<>;
const Homogeneous section{PlaneStress{Elastic{1, 1, 0.3}}, 0.2, Simpson<3>{}};
using Section = std::remove_const_t<decltype(section)>;

// A warped unit square is stretched, bent and sheared, and then turned about its normal in one lane and about an axis
// in its plane in the other.
const std::array<Eigen::Vector3d, 2> axes{{{0, 0, 1}, {0.6, 0.8, 0}}};

/// The norms of the resultants in each lane.
std::array<double, 2> norms(const Plate::State<Section, P>& state) {
  const auto s = section.stress(state.material);
  const P sum =
      double_dot(s.force, s.force) + double_dot(s.moment, s.moment) + s.shear(0) * s.shear(0) + s.shear(1) * s.shear(1);
  std::array<double, 2> norms;
  for (std::size_t l = 0; l < 2; ++l) norms[l] = std::sqrt(lane(sum, l));
  return norms;
}

}  // namespace

// theta = 0.01 a step: 6.3e6 steps.
TEST_CASE("D8: 1e4 revolutions of a plate about its normal and about an axis in its plane leave its stress as it was") {
  constexpr int revolutions = 10000, per_revolution = 628;
  Plate::State<Section, P> state;
  Nodal<P, 4> X;
  Nodal<P, 8> v;
  const auto spread = [](auto& to, std::size_t l, const auto& from) {
    for (int i = 0; i < from.size(); ++i) set_lane(to(i), l, from(i));
  };
  std::array<Nodal<double, 4>, 2> x0;
  testing::Quadrilaterals shapes(8);
  const Nodal<double, 8> strain = 0.01 * shapes.nodal<8>();
  for (std::size_t l = 0; l < 2; ++l) {
    x0[l] = unit_square();
    x0[l].row(2) << 0, 0.1, 0, 0.1;
    spread(X, l, x0[l]), spread(v, l, strain);
    x0[l] += strain.leftCols<4>();
  }
  Plate{}.begin(state, section, X);
  for (std::size_t l = 0; l < 2; ++l) spread(X, l, x0[l]);
  Plate{}.advance(state, section, X, v, 1.0);
  const auto before = norms(state);
  const auto resistance = state.hourglass.membrane(0);

  std::vector<Nodal<P, 4>> circle(per_revolution + 1);
  for (int i = 0; i <= per_revolution; ++i)
    for (std::size_t l = 0; l < 2; ++l) {
      const double angle = 2 * std::numbers::pi * (i % per_revolution) / per_revolution;
      spread(circle[static_cast<std::size_t>(i)], l,
             (Eigen::AngleAxisd(angle, axes[l]).toRotationMatrix() * x0[l]).eval());
    }
  for (std::size_t l = 0; l < 2; ++l) {  // chords belong to tan(theta/2)
    const Eigen::Vector3d w = 2 * std::tan(std::numbers::pi / per_revolution) * axes[l];
    Nodal<double, 8> turn = Nodal<double, 8>::Zero();
    turn.rightCols<4>().colwise() = w;
    spread(v, l, turn);
  }
  for (int r = 0; r < revolutions; ++r)
    for (std::size_t i = 1; i < circle.size(); ++i) {
      for (int k = 0; k < 12; ++k) v(k) = circle[i](k) - circle[i - 1](k);
      Plate{}.advance(state, section, circle[i], v, 1.0);
    }

  const auto after = norms(state);
  const double steps = double(revolutions) * per_revolution;
  for (std::size_t l = 0; l < 2; ++l) {
    CAPTURE(l, after[l] / before[l] - 1);
    CHECK(std::abs(after[l] / before[l] - 1) < 1e-6);
    // the strain that the hourglass control has felt on the way; its stiffness is below 1
    CHECK(std::abs(lane(state.hourglass.membrane(0) - resistance, l)) < 1e-9 * std::sqrt(steps));
  }
}
