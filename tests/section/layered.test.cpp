#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/material/failure/failure.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/point_values.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using namespace strike::testing;

namespace {

using Rate = PlateKinematics::Rate<double>;
using Resultant = PlateKinematics::Stress<double>;

const PlaneStress steel{Elastic{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = .3}};
const PlaneStress glassy{Elastic{.density = 2500, .youngs_modulus = 70e9, .poissons_ratio = .22}};

template <class M>
typename M::template State<double> resting(const M& section) {
  typename M::template State<double> state{};
  if constexpr (requires { section.begin(state); }) section.begin(state);
  return state;
}

/// All that a section answers to a rate from rest.
template <class M>
Resultant answer(const M& section, const Rate& rate, double dt = 1) {
  auto state = resting(section);
  return section.stress(state, rate, dt);
}

/// The mean of f over the points of layer k.
template <class State, class F>
double mean(const State& state, std::size_t k, F f) {
  double sum = 0, points = 0;
  state.each_point(k, [&](const auto& point) { sum += f(point), points += 1; });
  return sum / points;
}

const Rate any_rate{{1e-4, -2e-4, 3e-4}, {4e-2, 5e-2, -6e-2}, {7e-4, -8e-4}};

bool same(const Resultant& a, const Resultant& b) {
  const auto equal = [](const PlaneTensor<double>& s, const PlaneTensor<double>& t) {
    return s.xx == t.xx && s.yy == t.yy && s.xy == t.xy;
  };
  return equal(a.force, b.force) && equal(a.moment, b.moment) && a.shear == b.shear && a.normal_rate == b.normal_rate;
}

/// An elastic, perfectly plastic bar along x, so that its plate is a beam.
struct Fibre {
  double youngs_modulus, yield_stress;

  using Kinematics = PlaneStressKinematics;
  template <class T>
  struct State {
    PlaneTensor<T> stress{};
  };
  double density() const { return 1; }
  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    const T trial = state.stress.xx + (youngs_modulus * dt) * rate.rate_of_deformation.xx;
    state.stress.xx = max(T(-yield_stress), min(T(yield_stress), trial));
    return state.stress;
  }
  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }
  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>&) const {
    return {T(youngs_modulus), T(0.5 * youngs_modulus)};
  }
  template <class T>
  T normal_rate(const State<T>&, const PlaneStressKinematics::Rate<T>&, double, const PlaneTensor<T>&) const {
    return T(0.0);
  }
};

/// The moment of a beam of this rule at k times the curvature of first yield, per the exact one.
template <class R>
double moment_ratio(double k) {
  const double h = 2, E = 1000, Y = 1;
  const double exact = 0.25 * Y * h * h * (1 - 1 / (3 * k * k));
  return answer(Homogeneous{Fibre{E, Y}, h, R{}}, {{}, {k * 2 * Y / (E * h), 0, 0}, {0, 0}}).moment.xx / exact;
}

}  // namespace

// What a plate remembers is its points' states and two numbers of shear; a section that has no more plies than the
// compiler knows is copied as plain memory.
static_assert(sizeof(decltype(Homogeneous{steel, 1.0})::State<double>) == (5 * 3 + 2) * sizeof(double));
static_assert(sizeof(decltype(Homogeneous{steel, 1.0})::State<Pack<double, 8>>) ==
              (5 * 3 + 2) * sizeof(Pack<double, 8>));
static_assert(sizeof(decltype(Layered{Layer{steel, 1.0}, Layer{glassy, 1.0, Gauss<2>{}}, Offset{1},
                                      EffectiveShear{1}})::State<Pack<double, 8>>) ==
              ((5 + 2) * 3 + 2) * sizeof(Pack<double, 8>));
static_assert(sizeof(decltype(Homogeneous{steel, 1.0, InstantaneousShear{}})::State<Pack<double, 8>>) ==
              (5 * 3 + 2 + 2) * sizeof(Pack<double, 8>));
static_assert(std::is_trivially_copyable_v<decltype(Layered{Layer{steel, 1.0}, Layer{glassy, 1.0}})>);

static_assert(PlateSection<decltype(Homogeneous{steel, 1.0, Gauss<3>{}, Offset{1}})>);
static_assert(PlateSection<decltype(Layered{Plies{Layer{steel, 1.0}, 3}})>);
static_assert(!PlateSection<PlaneStress<Elastic>> && !PlaneMaterial<decltype(Homogeneous{steel, 1.0})>);

TEST_CASE("layered: Q = K gamma in every lay-up, to 1e-10") {
  const double gamma = 1e-6;
  for (const SandwichRow& row : sandwiches) {
    const auto check = [&](const auto& section, double K) {
      CHECK(section.shear_stiffness() == Approx(K).epsilon(1e-14));
      const Resultant s = answer(section, {{}, {}, {gamma, -2 * gamma}});
      CHECK(s.shear(0) == Approx(K * gamma).epsilon(1e-10));
      CHECK(s.shear(1) == Approx(-2 * K * gamma).epsilon(1e-10));
      CHECK(s.moment.xx == 0);
    };
    const TransverseShear<double> shear = row.strip.laminate(row.softness).transverse_shear();
    check(row.strip.section(row.softness), shear.stiffness);
    check(row.strip.section(row.softness, InstantaneousShear{}), shear.stiffness);
    check(row.strip.section(row.softness, FiveSixthsShear{}), 5. / 6 * shear.layer_sum);
    check(row.strip.section(row.softness, EffectiveShear{.length = 200}), shear.effective_stiffness(200));
  }
}

TEST_CASE("layered: elastic resultants are the integrals of the moduli, whatever the rule") {
  const double h1 = 2, h2 = 3, up = 0.7;
  const auto check = [&](const auto& section) {
    CHECK(section.thickness() == h1 + h2);
    CHECK(section.density() == Approx(7850 * h1 + 2500 * h2));
    const double z1 = up - 2.5 + h1 / 2, z2 = up + 2.5 - h2 / 2;
    CHECK(section.rotary_inertia() ==
          Approx(7850 * h1 * (z1 * z1 + h1 * h1 / 12) + 2500 * h2 * (z2 * z2 + h2 * h2 / 12)));
    const auto m = section.moduli(resting(section), Rate{});
    for (const double stretch : {1.0, 0.8}) {
      Rate rate = any_rate;
      rate.relative_thickness = stretch;
      const Resultant s = answer(section, rate);
      const auto hooke = [](double nu, const PlaneModuli<double>& of, const PlaneTensor<double>& e) {
        return PlaneTensor<double>::isotropic(nu * of.normal * trace(e)) + (2 * of.shear) * e;
      };
      const auto integral = [&](auto weight, const PlaneTensor<double>& e) {
        const PlaneModuli<double> a = steel.moduli(PlaneStress<Elastic>::State<double>{}, {}),
                                  b = glassy.moduli(PlaneStress<Elastic>::State<double>{}, {});
        const double A = weight(z1, h1), B = weight(z2, h2);
        return hooke(.3, {A * a.normal, A * a.shear}, e) + hooke(.22, {B * b.normal, B * b.shear}, e);
      };
      const auto one = [](double, double h) { return h; };
      const auto z = [](double middle, double h) { return h * middle; };
      const auto zz = [](double middle, double h) { return h * (middle * middle + h * h / 12); };
      const double t = stretch;
      const PlaneTensor<double> N = t * (integral(one, rate.membrane) + t * integral(z, rate.curvature)),
                                M = t * t * (integral(z, rate.membrane) + t * integral(zz, rate.curvature));
      CHECK(s.force.xx == Approx(N.xx).epsilon(1e-12));
      CHECK(s.force.yy == Approx(N.yy).epsilon(1e-12));
      CHECK(s.force.xy == Approx(N.xy).epsilon(1e-12));
      CHECK(s.moment.xx == Approx(M.xx).epsilon(1e-12));
      CHECK(s.moment.yy == Approx(M.yy).epsilon(1e-12));
      CHECK(s.moment.xy == Approx(M.xy).epsilon(1e-12));
      const double d_zz = -(h1 * .3 / .7 * (trace(rate.membrane) + t * z1 * trace(rate.curvature)) +
                            h2 * .22 / .78 * (trace(rate.membrane) + t * z2 * trace(rate.curvature))) /
                          (h1 + h2);
      CHECK(s.normal_rate == Approx(d_zz).epsilon(1e-12));
      const auto now = section.moduli(resting(section), rate);
      CHECK(now.extension.shear == Approx(t * m.extension.shear));
      CHECK(now.coupling.normal == Approx(t * t * m.coupling.normal));
      CHECK(now.bending.normal == Approx(t * t * t * m.bending.normal));
      CHECK(now.transverse_shear == Approx(t * section.shear_stiffness()));
    }
  };
  check(Layered{Layer{steel, h1}, Layer{glassy, h2}, Offset{up}});
  check(Layered{Layer{steel, h1, Simpson<3>{}}, Layer{glassy, h2, Gauss<2>{}}, Offset{up}});
  check(Layered{Layer{steel, h1, Lobatto<4>{}}, Layer{glassy, h2, Simpson<9>{}}, Offset{up}, FiveSixthsShear{}});
  check(Layered{Plies{Layer{steel, h1 / 4}, 4}, Layer{glassy, 0.0}, Plies{Layer{glassy, h2 / 3}, 3}, Offset{up}});
}

TEST_CASE("layered: one layer by any name gives the same bits, as do plies and layers") {
  const Resultant plain = answer(Homogeneous{steel, 3.0}, any_rate);
  CHECK(same(plain, answer(Layered{Layer{steel, 3.0}}, any_rate)));
  CHECK(same(plain, answer(Layered{Layer{steel, 3.0, Simpson<5>{}}, EnergyShear{}}, any_rate)));
  CHECK(same(plain, answer(Homogeneous{steel, 3.0, Simpson<5>{}, Offset{0}}, any_rate)));
  CHECK(same(plain, answer(Layered{Plies{Layer{steel, 3.0}, 1}}, any_rate)));
  const Layer a{steel, 1.0};
  const Layer b{glassy, 0.3, Simpson<3>{}};
  CHECK(same(answer(Layered{a, a, a, b, b, a}, any_rate), answer(Layered{Plies{a, 3}, b, Plies{b, 1}, a}, any_rate)));
}

TEST_CASE("layered: what is remembered gives the resultants, before and after a step") {
  const Layered section{Layer{steel, 1.0}, Plies{Layer{glassy, 0.5, Gauss<3>{}}, 2}, Offset{2}};
  auto state = resting(section);
  CHECK(same(section.stress(std::as_const(state)), {}));
  Resultant s = section.stress(state, any_rate, 0.5);
  s.normal_rate = 0;  // that of the step alone
  CHECK(same(section.stress(std::as_const(state)), s));

  std::size_t points = 0, of_layer_1 = 0;
  state.each_point([&](const auto& point) { points += point.stress.xx != 0; });
  state.each_point(1, [&](const auto& point) { of_layer_1 += point.stress.xx != 0; });
  CHECK(points == 5 + 3 + 3);
  CHECK(of_layer_1 == 3);
  CHECK(section.layers() == 3);
}

TEST_CASE("layered: a step of no time, as at the start of a run, is the stress that is remembered") {
  const Homogeneous closed{steel, 1e-3};
  const Homogeneous searched{ZeroNormalStress{Elastic{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = .3}},
                             1e-3};
  CHECK(same(answer(closed, any_rate, 0), Resultant{}));
  CHECK(same(answer(searched, any_rate, 0), Resultant{}));
  auto state = resting(closed);
  closed.stress(state, any_rate, 1);
  CHECK(same(closed.stress(state, any_rate, 0), closed.stress(std::as_const(state))));
}

TEST_CASE("layered: interlaminar stresses are the exact ones of long waves") {
  const auto section = glass.section(100);
  auto state = resting(section);
  section.stress(state, {{}, {}, {1e-3, 2e-3}}, 1);
  const double p = std::numbers::pi / 30000;
  for (std::size_t k = 0; k < 3; ++k)
    for (const double xi : {0., .25, .5, 1.}) {
      const double z = std::array{0., 3., 3.76}[k] + xi * glass.thickness[k];
      const double g = std::abs(glass.laminate(100).at(p, z).T) * p;
      CHECK(section.shear_stress(state, k, xi)(0) == Approx(g * state.shear(0)).margin(1e-5 * state.shear(0)));
      CHECK(section.shear_stress(state, k, xi)(1) == Approx(g * state.shear(1)).margin(1e-5 * state.shear(1)));
    }
}

TEST_CASE("layered: interlaminar stresses with EffectiveShear are within 1 % of exact elasticity in every lay-up") {
  for (const SandwichRow& row : sandwiches) {
    CAPTURE(row.strip.name, row.softness);
    const double p = row.strip.p();
    const auto section = row.strip.section(row.softness, EffectiveShear{.length = row.strip.length});
    auto state = resting(section);
    state.shear(0) = 1 / p;  // under the pressure sin px
    double bottom = 0, force = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double h = row.strip.thickness[k];
      for (const double xi : {0.5, 1.0})
        if (k < 2 || xi < 1) {
          const double exact = std::abs(row.strip.laminate(row.softness).at(p, bottom + xi * h).T);
          CHECK(section.shear_stress(state, k, xi)(0) == Approx(exact).epsilon(0.01));
        }
      const auto tau = [&](double xi) { return section.shear_stress(state, k, xi)(0); };
      force += h / 6 * (tau(0) + 4 * tau(0.5) + tau(1));
      bottom += h;
    }
    CHECK(force == Approx(1 / p).epsilon(1e-12));
  }
}

TEST_CASE("layered: plastic moments by rule") {
  const double all = 1e6;  // times the curvature of first yield
  CHECK(moment_ratio<Simpson<3>>(all) == Approx(2. / 3).epsilon(1e-9));
  CHECK(moment_ratio<Simpson<5>>(all) == Approx(1.).epsilon(1e-9));
  CHECK(moment_ratio<Simpson<7>>(all) == Approx(.963).margin(1e-3));
  CHECK(moment_ratio<Simpson<9>>(all) == Approx(1.).epsilon(1e-9));
  CHECK(moment_ratio<Gauss<3>>(all) == Approx(.861).margin(1e-3));
  CHECK(moment_ratio<Gauss<5>>(all) == Approx(.945).margin(1e-3));
  CHECK(moment_ratio<Gauss<7>>(all) == Approx(.971).margin(1e-3));
  CHECK(moment_ratio<Gauss<10>>(all) == Approx(1.008).margin(1e-3));
  CHECK(moment_ratio<Lobatto<3>>(all) == Approx(.667).margin(1e-3));
  CHECK(moment_ratio<Lobatto<5>>(all) == Approx(.913).margin(1e-3));
  CHECK(moment_ratio<Simpson<3>>(1.5) == Approx(.783).margin(1e-3));
  CHECK(moment_ratio<Simpson<5>>(1.5) == Approx(.978).margin(1e-3));
  CHECK(moment_ratio<Gauss<5>>(1.5) == Approx(.993).margin(1e-3));
  CHECK(moment_ratio<Gauss<5>>(0.999) == Approx(0.999 / 1.5 / (1 - 1 / (3 * .999 * .999))));  // elastic: E I kappa
}

TEST_CASE("layered: a plate bent into a cylinder carries 2/sqrt(3) of the plastic moment of a beam") {
  const PlaneStress metal{
      Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9}, VonMises{.shear_modulus = 27e9, .yield_stress = 300e6}}};
  const Homogeneous section{metal, 2.0};
  auto state = resting(section);
  Resultant s;
  for (int i = 0; i < 1000; ++i) s = section.stress(state, {{}, {1e-3, 0, 0}, {0, 0}}, 1);
  CHECK(s.moment.xx == Approx(2 / std::numbers::sqrt3 * 0.25 * 300e6 * 4).epsilon(1e-3));
  CHECK(s.moment.yy == Approx(s.moment.xx / 2).epsilon(1e-3));
}

TEST_CASE("layered: layers fail on their own") {
  const auto brittle = [](double strength) {
    return PlaneStress{Solid{LinearEos{.density = 2500, .bulk_modulus = 1000}, ElasticStrength{.shear_modulus = 600},
                             UltimateStress{strength}}};
  };
  const Layered section{Layer{brittle(1), 1.0}, Layer{brittle(2), 1.0}, Layer{brittle(1e9), 1.0, Gauss<2>{}}};
  const Layered sound{Layer{brittle(1e9), 1.0}};
  auto state = resting(section);
  auto one = resting(sound);
  std::vector<double> broken_at(3);
  for (int i = 1; i <= 40; ++i) {
    const Rate pull{{1e-4, 0, 0}, {}, {1e-4, 0}};
    const Resultant s = section.stress(state, pull, 1), per_layer = sound.stress(one, pull, 1);
    int intact = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool whole = mean(state, k, Failed{}) == 0;
      if (!whole && broken_at[k] == 0) broken_at[k] = i;
      intact += whole;
    }
    CHECK(s.force.xx == Approx(intact * per_layer.force.xx).epsilon(1e-12));
    CHECK(section.intact(state) == 1);
    CHECK(s.shear(0) > 0);
  }
  CHECK(broken_at[0] > 0);
  CHECK(broken_at[1] == Approx(2 * broken_at[0]).margin(1));
  CHECK(broken_at[2] == 0);
  CHECK(mean(state, 0, Failed{}) == 1);

  const Homogeneous all{brittle(1), 1.0};
  auto gone = resting(all);
  const Resultant s = all.stress(gone, {{1, 0, 0}, {}, {1, 1}}, 1);
  CHECK(all.intact(gone) == 0);
  CHECK(same({s.force, s.moment, s.shear, 0}, {}));
  static_assert(strike::detail::CanFail<decltype(all)> && !strike::detail::CanFail<decltype(Homogeneous{steel, 1.0})>);
}

TEST_CASE("layered: as layers yield, the shear stiffness follows their moduli slowly and the shear force is kept") {
  const PlaneStress metal{
      Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9}, VonMises{.shear_modulus = 27e9, .yield_stress = 300e6}}};
  const PlaneStress strong{
      Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9}, ElasticStrength{.shear_modulus = 27e9}}};
  const Layered section{Layer{metal, 1.0}, Layer{strong, 2.0}, Layer{metal, 1.0}, InstantaneousShear{}};
  auto state = resting(section);
  const double K0 = section.shear_stiffness();
  Resultant s = section.stress(state, {{}, {}, {1e-3, 0}}, 1);
  CHECK(s.shear(0) == Approx(K0 * 1e-3).epsilon(1e-14));
  const double Q = s.shear(0);

  double last = K0;
  for (int i = 0; i < 200; ++i) {
    s = section.stress(state, {{1e-3, 0, 0}, {}, {0, 0}}, 1);  // yields the faces
    CHECK(s.shear(0) == Q);
    CHECK(state.shear_stiffness >= last / 1.1 * (1 - 1e-12));
    CHECK(state.shear_stiffness <= last * 1.1 * (1 + 1e-12));
    last = state.shear_stiffness;
  }
  // with faces at a share f of their moduli, the closed form
  double share = 0;
  state.each_layer([&](std::size_t k, const auto& layer) {
    if (k == 0) share = layer.share;
    if (k == 1) CHECK(layer.share == Approx(1).epsilon(1e-9));
  });
  CHECK(mean(state, 0, PlasticStrain{}) > 0.1);
  CHECK(mean(state, 1, PlasticStrain{}) == 0);
  CHECK(mean(state, 2, Failed{}) == 0);
  CHECK(mean(state, 0, EquivalentStress{}) == Approx(300e6));
  CHECK(mean(state, 1, EquivalentStress{}) > 1e9);
  CHECK(share < 0.5);
  CHECK(share >= 1e-3);
  const PlaneModuli<double> m = metal.moduli(decltype(metal)::State<double>{}, {});
  const ShearLayer<double> face{1, {share * m.normal, share * m.shear}}, core{2, m};
  CHECK(last == Approx(transverse_shear(std::vector{face, core, face}).stiffness).epsilon(1e-9));
  s = section.stress(state, {{}, {}, {1e-3, 0}}, 1);
  CHECK(s.shear(0) == Approx(Q + last * 1e-3).epsilon(1e-12));

  for (int i = 0; i < 200; ++i) section.stress(state, {{-1e-6, 0, 0}, {}, {0, 0}}, 1);  // unloads
  CHECK(state.shear_stiffness == Approx(K0).epsilon(1e-9));
}

TEST_CASE("layered: thicknesses that cannot be are refused") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH((Layered{Layer{steel, 1.0}, Layer{steel, -1.0}}),
                    ContainsSubstring("the thickness of Layer, in layer 1, is -1; it must be zero or positive"));
  CHECK_THROWS_WITH((Layered{Layer{steel, 0.0}, Plies{Layer{steel, 0.0}, 3}}), ContainsSubstring("has no thickness"));
}

TEST_CASE("layered: a section tells what its materials and its shear have to say, each once") {
  const PlaneStress softening{Solid{LinearEos{.density = 1, .bulk_modulus = 1},
                                    VonMises{.shear_modulus = 1, .yield_stress = 1, .hardening_modulus = -.1}}};
  const std::string law = softening.warning();
  CHECK(!law.empty());
  CHECK(Layered{Layer{softening, 1.0}, Layer{softening, 1.0}}.warning() == law);
  CHECK(Homogeneous{steel, 1.0}.warning(1).empty());
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(glass.section(1e4, FiveSixthsShear{}).warning(), ContainsSubstring("5/6 sum G h of a section is"));
  CHECK(Homogeneous{steel, 1.0, FiveSixthsShear{}}.warning().empty());
}
