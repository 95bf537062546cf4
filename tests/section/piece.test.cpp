#include <array>

#include <strike/material/plane_stress.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/section/piece.hpp>
#include <strike/section/transverse_shear.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

struct HalfShear {
  double stiffness(const TransverseShear<double>& shear) const { return 0.5 * shear.layer_sum; }
};
struct ToldByLength : HalfShear {
  std::string warning(double) const { return {}; }
};
struct FlowsByLayer : HalfShear {
  ShearFlow<double> flow(const ShearLayer<double>&) const { return {}; }
};
struct Forgetful : HalfShear {
  template <class T>
  struct State {
    T shear_stiffness{};
  };
};
struct Trapezoid {
  static constexpr std::array<double, 2> points{-1, 1}, weights{1, 1};
};
struct Lopsided {
  static constexpr std::array<double, 2> points{-1, 1};
  static constexpr std::array<double, 1> weights{2};
};

}  // namespace

static_assert(ShearPolicy<EnergyShear> && ShearPolicy<EffectiveShear> && ShearPolicy<FiveSixthsShear> &&
              ShearPolicy<InstantaneousShear> && ShearPolicy<HalfShear>);
static_assert(!ShearPolicy<int> && !ShearPolicy<Offset> && !ShearPolicy<Simpson<3>> && !ShearPolicy<Elastic>);
static_assert(ThicknessRule<Trapezoid> && !ThicknessRule<Lopsided> && !ThicknessRule<EnergyShear>);

// Policies with something nearly right.
using detail::ShearFlaw;
static_assert(detail::shear_flaw<HalfShear>() == ShearFlaw::none);
static_assert(detail::shear_flaw<EffectiveShear>() == ShearFlaw::none);
static_assert(detail::shear_flaw<InstantaneousShear>() == ShearFlaw::none);
static_assert(detail::shear_flaw<ToldByLength>() == ShearFlaw::warning);
static_assert(detail::shear_flaw<FlowsByLayer>() == ShearFlaw::flow);
static_assert(detail::shear_flaw<Forgetful>() == ShearFlaw::memory);

TEST_CASE("the integrals of a section are those of its layers: int (1, z, z^2)") {
  detail::SectionIntegrals sum;
  const PlaneModuli<double> moduli{.normal = 3, .shear = 1};
  sum.add(2, 1, moduli, 5);
  sum.add(1, 2.5, moduli, 5);
  CHECK(sum.extension.normal == 9);
  CHECK(sum.coupling.normal == Approx(3 * 4.5));  // 3^2/2
  CHECK(sum.bending.shear == Approx(9));          // 3^3/3
  CHECK(sum.mass == 15);
  CHECK(sum.rotary_inertia == Approx(45));
  const PlateKinematics::Moduli<double> twice = sum.moduli(2.0, 7.0);
  CHECK(twice.extension.normal == 2 * sum.extension.normal);
  CHECK(twice.bending.shear == 8 * sum.bending.shear);
  CHECK(twice.transverse_shear == 14);
}

TEST_CASE("a measured layer places its points around its middle, with weights that add up to its thickness") {
  detail::MeasuredLayer<3, ShearFlow<double>, false> layer;
  layer.place<Simpson<3>>(2, 0.5);
  CHECK(layer.z == std::array<double, 3>{1.75, 2, 2.25});
  CHECK(layer.weight[0] + layer.weight[1] + layer.weight[2] == Approx(0.5));
}
