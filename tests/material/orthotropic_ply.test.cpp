#include <cmath>

#include <strike/material/elastic.hpp>
#include <strike/material/orthotropic_ply.hpp>
#include <strike/material/plane_stress.hpp>

#include "support/catch.hpp"
#include "support/plies.hpp"

using namespace strike;
using testing::carbon;

namespace {
using Rate = PlaneStressKinematics::Rate<double>;
}

static_assert(PlaneMaterial<OrthotropicPly> && sizeof(OrthotropicPly::State<double>) == 3 * sizeof(double));

TEST_CASE("orthotropic ply: pulls along the axes and shear give the constants") {
  const double s = 100, nu21 = carbon.nu12 * carbon.E2 / carbon.E1;
  const auto along = carbon.elastic(PlaneTensor<double>{s / carbon.E1, -carbon.nu12 * s / carbon.E1, 0});
  const auto across = carbon.elastic(PlaneTensor<double>{-nu21 * s / carbon.E2, s / carbon.E2, 0});
  const auto shear = carbon.elastic(PlaneTensor<double>{0, 0, 0.5 * s / carbon.G12});
  CHECK(along.xx == Approx(s).epsilon(1e-14));
  CHECK(along.yy == Approx(0).margin(1e-12));
  CHECK(across.xx == Approx(0).margin(1e-12));
  CHECK(across.yy == Approx(s).epsilon(1e-14));
  CHECK(shear.xy == Approx(s).epsilon(1e-14));
  CHECK(carbon.normal_rate(OrthotropicPly::State<double>{}, Rate{}, 2.0, along) ==
        Approx(-carbon.nu12 * s / carbon.E1 / 2).epsilon(1e-13));
  CHECK(carbon.normal_rate(OrthotropicPly::State<double>{}, Rate{}, 2.0, across) ==
        Approx(-carbon.nu23 * s / carbon.E2 / 2).epsilon(1e-13));
}

TEST_CASE("orthotropic ply: with the constants of an isotropic solid it is that in plane stress") {
  const double E = 70e3, nu = 0.3, G = E / 2 / (1 + nu);
  const OrthotropicPly ply{
      .density = 1, .E1 = E, .E2 = E, .nu12 = nu, .G12 = G, .G13 = G, .G23 = G, .angle = 0, .nu23 = nu};
  const PlaneStress solid{Elastic{.density = 1, .youngs_modulus = E, .poissons_ratio = nu}};
  OrthotropicPly::State<double> one;
  PlaneStress<Elastic>::State<double> other;
  const Rate rate{{1e-3, -2e-3, 4e-3}};
  const auto s = ply.stress(one, rate, 0.5), t = solid.stress(other, rate, 0.5);
  CHECK(s.xx == Approx(t.xx).epsilon(1e-14));
  CHECK(s.yy == Approx(t.yy).epsilon(1e-14));
  CHECK(s.xy == Approx(t.xy).epsilon(1e-14));
  CHECK(ply.normal_rate(one, rate, 0.5, s) == Approx(solid.normal_rate(other, rate, 0.5, t)).epsilon(1e-13));
  CHECK(ply.moduli(one, rate).normal == Approx(solid.moduli(other, rate).normal).epsilon(1e-14));
  CHECK(ply.moduli(one, rate).shear == Approx(G).epsilon(1e-14));
}

TEST_CASE("orthotropic ply: constants that cannot be are refused") {
  using Catch::Matchers::ContainsSubstring;
  const auto refused = [](auto change) {
    OrthotropicPly ply = carbon;
    change(ply);
    strike::detail::check_ranges(ply);
  };
  CHECK_THROWS_WITH(refused([](auto& p) { p.E2 = 0; }),
                    ContainsSubstring("the E2 of OrthotropicPly is 0; it must be positive"));
  CHECK_THROWS_WITH(refused([](auto& p) { p.G23 = -1; }), ContainsSubstring("the G23 of OrthotropicPly is -1"));
  CHECK_THROWS_WITH(refused([](auto& p) { p.nu12 = 4; }),
                    ContainsSubstring("the nu12 of OrthotropicPly is 4; it must be above -3.94") &&
                        ContainsSubstring("its square is below E1/E2"));
  refused([](auto& p) { p.nu12 = 3.9; });
}
