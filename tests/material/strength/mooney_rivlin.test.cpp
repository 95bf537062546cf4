#include <algorithm>
#include <cmath>

#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/mooney_rivlin.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

constexpr double C10 = .4e6, C01 = .1e6, K = 1e10;  // so hard that nothing but the shape changes, to s/K = 1e-3
const Solid rubber{LinearEos{.density = 1000, .bulk_modulus = K}, MooneyRivlin{.C10 = C10, .C01 = C01}};

}  // namespace

static_assert(StrengthWithMemory<MooneyRivlin>);
static_assert(sizeof(StrengthState<MooneyRivlin, double>) == 6 * sizeof(double));

TEST_CASE("Mooney-Rivlin: pulled and pressed one way, sigma = 2 (l^2 - 1/l)(C10 + C01/l)") {
  for (const double strain : {1.0, -1.0}) {
    MaterialPoint point{rubber};
    point.run(uniaxial_stress({.strain = strain, .steps = 300}), [&](const auto& now) {
      const double l = now.deformation_gradient(0, 0);
      const double exact = 2 * (l * l - 1 / l) * (C10 + C01 / l);
      CHECK(now.stress.xx == Approx(exact).epsilon(1e-3).margin(1e-6 * C10));
    });
  }
}

TEST_CASE("Mooney-Rivlin: pulled two ways, sigma = 2 (l^2 - l^-4)(C10 + C01 l^2), in a membrane") {
  const ZeroNormalStress membrane{rubber};  // which asks the solid until the stress across is none
  decltype(membrane)::State<double> state;
  membrane.begin(state);
  const double step = 2e-3;
  double l2 = 1;
  for (int i = 0; i < 350; ++i) {
    const auto sigma = membrane.stress(state, {{step, step, 0}}, 1.0);
    l2 *= std::pow((1 + step / 2) / (1 - step / 2), 2);  // so that the step is the strain at its middle
    const double exact = 2 * (l2 - 1 / (l2 * l2)) * (C10 + C01 * l2);
    CHECK(sigma.xx == Approx(exact).epsilon(1e-3));
    CHECK(sigma.yy == Approx(exact).epsilon(1e-3));
  }
}

TEST_CASE("Mooney-Rivlin: in simple shear tau = 2 (C10 + C01) g, and normal stresses of its square") {
  MaterialPoint point{rubber};
  const double G = 2 * (C10 + C01);
  point.run(simple_shear({.strain = 3, .steps = 3000}), [&](const auto& now) {
    const double g = now.deformation_gradient(0, 1);
    CHECK(now.stress.xy == Approx(G * g).epsilon(1e-6));  // the square of a step
    CHECK(now.stress.xx - now.stress.yy == Approx(G * g * g).epsilon(1e-6).margin(1e-6 * G));
    CHECK(now.stress.yy - now.stress.zz == Approx(-2 * C01 * g * g).epsilon(1e-6).margin(1e-6 * G));
  });
}

TEST_CASE("Mooney-Rivlin: it remembers the motion: from any path it comes back to no stress, with all its work") {
  MaterialPoint point{Solid{LinearEos{.density = 1000, .bulk_modulus = 4e6}, MooneyRivlin{.C10 = C10, .C01 = C01}}};
  const Path loop = simple_shear({.strain = 1, .steps = 500}) + uniaxial_strain({.strain = .5, .steps = 500});
  double most = 0;
  point.run(loop, [&](const auto& now) {
    most = std::max(most, now.work);
    const Matrix3<double>& F = now.deformation_gradient;
    const double J = F.determinant();
    const SymmetricTensor<double> B = symmetric_part<double>(std::pow(J, -2 / 3.) * F * F.transpose());
    CHECK((now.state.stretch - B).matrix().norm() < 1e-5 * B.matrix().norm());  // the square of a step
    const SymmetricTensor<double> s = (2 / J) * deviator(C10 * B - C01 * inverse(B));
    CHECK((deviator(now.stress) - s).matrix().norm() < 3e-5 * C10);
  });
  point.run(back(loop));
  CHECK(point.now().stress.matrix().norm() < 1e-9 * C10);  // the steps are those of the way there
  CHECK(std::abs(point.now().work) < 1e-5 * most);
}

TEST_CASE("Mooney-Rivlin: far stretched along x, its moduli bound its tangent there, in closed form") {
  // C10 (2/3 B_xx + 2/9 tr B), the same of C01 and B^-1, and the change of 1/J that the moduli leave out
  using D = Dual<double, 1>;
  const double bulk = 1, A1 = 3, A2 = 2;
  const Solid soft{LinearEos{.density = 1, .bulk_modulus = bulk}, MooneyRivlin{.C10 = A1, .C01 = A2}};
  for (const SymmetricTensor<double> B : {SymmetricTensor<double>{9, 1 / 3., 1 / 3.}, {1 / 9., 3, 3}, {4, 1, .25}}) {
    decltype(soft)::State<D> state;
    state.stretch = {B.xx, B.yy, B.zz, 0., 0., 0.};
    const double wave = soft.moduli(state, {{}, D(1.0)}).wave().value();
    const D strain = D::variable(0., 0);
    const D sigma = soft.stress(state, {{.xx = strain}, 1.0 + strain}, 1.0).xx;
    const double tr = B.xx + B.yy + B.zz, tr_inverse = 1 / B.xx + 1 / B.yy + 1 / B.zz;
    const double along = A1 * (2 / 3. * B.xx + 2 / 9. * tr) + A2 * (2 / 3. / B.xx + 2 / 9. * tr_inverse);
    CHECK(sigma.derivative(0) == Approx(bulk + 2 * along - sigma.value()).epsilon(1e-13));
    CHECK(bulk + 2 * along <= wave);
  }
}
