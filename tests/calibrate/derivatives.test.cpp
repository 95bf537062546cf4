// Derivatives by the parameters of strength laws, through material points and whole runs, against central differences.
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <strike/calibrate/bar_profile.hpp>
#include <strike/calibrate/uniaxial_stresses.hpp>
#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::calibrate;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The derivative of f(p) by the relative change of p, of fourth order.
std::vector<double> central_difference(const std::function<std::vector<double>(double)>& f, double h) {
  std::vector<double> slope = f(h);
  const auto below = f(-h), above2 = f(2 * h), below2 = f(-2 * h);
  for (std::size_t i = 0; i < slope.size(); ++i)
    slope[i] = (8 * (slope[i] - below[i]) - (above2[i] - below2[i])) / (12 * h);
  return slope;
}

/// The parameters of a law as the variables by which derivatives are taken.
template <class Law, std::size_t N>
std::array<Dual<double, N>, N> variables(const Law& law, const std::array<double Law::*, N>& members) {
  std::array<Dual<double, N>, N> p;
  for (std::size_t k = 0; k < N; ++k) p[k] = Dual<double, N>::variable(law.*members[k], k);
  return p;
}
template <class Law>
Law changed(Law law, double Law::*member, double relative_change) {
  law.*member *= 1 + relative_change;
  return law;
}

// A law as a user writes it, which knows nothing of derivatives by its parameters.
struct Voce {
  double shear_modulus, yield_stress, saturation_stress, saturation_strain;

  template <class T>
  T flow_stress(const T& e) const {
    return saturation_stress - (saturation_stress - yield_stress) * exp(-e / saturation_strain);
  }
};

const LinearEos eos{.density = 8.93e-6, .bulk_modulus = 130};
const std::vector<double> strains{0.001, 0.004, 0.02, 0.1, 0.2};

template <class Law, class... Members>
void check_material_point(const Law& law, Members... member) {
  constexpr std::size_t N = sizeof...(Members);
  const std::array<double Law::*, N> members{member...};
  const UniaxialTest test{.rate = 3, .largest_increment = 0.01};
  const auto stress = uniaxial_stresses(Solid{eos, Sensitive{law, variables(law, members), member...}}, strains, test,
                                        in<Dual<double, N>>);
  const auto plain = uniaxial_stresses(Solid{eos, law}, strains, test);
  for (std::size_t k = 0; k < N; ++k) {
    const auto slope = central_difference(
        [&](double change) {
          return uniaxial_stresses(Solid{eos, changed(law, members[k], change)}, strains, test);
        },
        1e-3);
    for (std::size_t i = 0; i < strains.size(); ++i) {
      CAPTURE(i, k);
      CHECK(stress[i].value() == Approx(plain[i]).epsilon(1e-11));  // both within the tolerance of prescribed stresses
      // 1e-6, or the tolerance of prescribed stresses, 1.4e-14 of K + 4/3 G = 188, over the change of 1e-3
      CHECK(std::abs(law.*members[k] * stress[i].derivative(k) - slope[i]) <
            1e-6 * std::abs(slope[i]) + 1e-8 * plain[i]);
    }
  }
}

}  // namespace

TEST_CASE("calibrate: stresses of a material point have the derivatives of central differences") {
  SECTION("linear hardening") {
    check_material_point(VonMises{.shear_modulus = 43.3, .yield_stress = 0.4, .hardening_modulus = 0.1},
                         &VonMises::yield_stress, &VonMises::hardening_modulus);
  }
  SECTION("a user's law") {
    check_material_point(
        Voce{.shear_modulus = 43.3, .yield_stress = 0.3, .saturation_stress = 0.55, .saturation_strain = 0.2},
        &Voce::yield_stress, &Voce::saturation_stress, &Voce::saturation_strain);
  }
  SECTION("rate and heat") {
    check_material_point(JohnsonCook{.shear_modulus = 43.3,
                                     .A = 0.09,
                                     .B = 0.292,
                                     .n = 0.31,
                                     .C = 0.025,
                                     .reference_rate = 1e-3,
                                     .m = 1.09,
                                     .initial_temperature = 293,
                                     .melting_temperature = 1356,
                                     .heating = 260},
                         &JohnsonCook::A, &JohnsonCook::B, &JohnsonCook::n, &JohnsonCook::C, &JohnsonCook::m);
  }
}

TEST_CASE("calibrate: a run in dual numbers has the derivatives of central differences and the values of a plain run") {
  const Mesh bar = cylinder({.radius = 3.2, .length = 16, .cells = 1, .layers = 8});
  const auto on = [&](Axis axis) { return nodes_where(bar.nodes, on_plane(axis, 0)); };
  const auto shape = [&](const auto& law, auto number) {
    // A step that no parameter changes: it has no derivatives.
    Explicit run{Scene{bar.nodes, Part{Hex8{}, Solid{eos, law}, bar.hexahedra}, InitialVelocity{{0, 0, -227}},
                       Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)}, RigidWall{{0, 0, 0}, {0, 0, 1}}},
                 ExplicitOptions{.largest_step = 1e-4}, number};
    run.until(0.012);
    CHECK(run.steps() == 120);
    const auto profile = bar_profile(bar, run.nodes());
    return std::vector{profile.length(), profile.foot_radius(), profile.radius_at(4.0)};
  };
  const VonMises law{.shear_modulus = 43.3, .yield_stress = 0.4, .hardening_modulus = 0.1};
  const std::array members{&VonMises::yield_stress, &VonMises::hardening_modulus};
  const auto derived =
      shape(Sensitive{law, variables(law, members), members[0], members[1]}, in<Dual<Pack<double>, 2>>);
  const auto plain = shape(law, in<Pack<double>>);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto slope = central_difference(
        [&](double change) { return shape(changed(law, members[k], change), in<Pack<double>>); }, 1e-5);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      CAPTURE(i, k, slope[i]);
      CHECK(derived[i].value() == Approx(plain[i]).epsilon(1e-12));
      CHECK(std::abs(law.*members[k] * derived[i].derivative(k) / slope[i] - 1) < 1e-6);
    }
  }
}

TEST_CASE("calibrate: parameters without derivatives are refused") {
  using D = Dual<double, 1>;
  const VonMises law{.shear_modulus = 43.3, .yield_stress = 0.4};
  CHECK_THROWS_WITH((Sensitive{law, std::array{D(0.0)}, &VonMises::hardening_modulus}),
                    ContainsSubstring("parameter 0 of Sensitive is 0 and so has no scale"));
  CHECK_THROWS_WITH((Sensitive{law, std::array{D(43.3)}, &VonMises::shear_modulus}),
                    ContainsSubstring("act outside the flow stress"));
  CHECK_THROWS_WITH(uniaxial_stresses(Solid{eos, law}, std::vector{0.1, 0.05}, {}),
                    ContainsSubstring("strain 1 of a uniaxial test is 0.05 after 0.1"));
}
