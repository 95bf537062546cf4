#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/section/transverse_shear.hpp>

#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using namespace strike::verify;
using namespace strike::testing;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<ShearFlow<double>> flows(const std::vector<ShearLayer<double>>& layers) {
  std::vector<ShearFlow<double>> all;
  each_shear_flow(
      transverse_shear(layers),
      [&](auto f) {
        for (const auto& layer : layers) f(layer);
      },
      [&](const auto&, const auto& flow) { all.push_back(flow); });
  return all;
}

std::vector<ShearLayer<double>> random_layers(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ShearLayer<double>> layers(2 + random() % 6);
  for (auto& [h, moduli] : layers) {
    h = 0.1 + unit(random);
    moduli.shear = std::pow(10, 4 * unit(random));
    moduli.normal = (2 + 2 * unit(random)) * moduli.shear;
  }
  return layers;
}

}  // namespace

TEST_CASE("transverse shear: one layer has 5/6 G h and the parabola 3/2 V/h") {
  const std::vector<ShearLayer<double>> layers{{12.7, {2800, 870}}};
  const auto shear = transverse_shear(layers);
  CHECK(shear.stiffness == Approx(5. / 6 * 870 * 12.7).epsilon(1e-15));
  CHECK(shear.bending == Approx(2800 * 12.7 * 12.7 * 12.7 / 12).epsilon(1e-15));
  CHECK(shear.neutral_axis == Approx(12.7 / 2).epsilon(1e-15));
  CHECK(shear.own_bending == Approx(0).margin(1e-15 * shear.bending));
  CHECK(shear.effective_stiffness(1) == Approx(shear.stiffness).epsilon(1e-14));
  CHECK(shear.error(1) == Approx(0).margin(1e-14));
  CHECK(flows(layers)[0](0.5) == Approx(1.5 / 12.7).epsilon(1e-15));
}

TEST_CASE("transverse shear: the table of K, of deflections against exact elasticity, and of the predicted error") {
  for (const SandwichRow& row : sandwiches) {
    CAPTURE(row.strip.name, row.softness);
    const double p = row.strip.p();
    const TransverseShear<double> shear = row.strip.laminate(row.softness).transverse_shear();
    const double K = shear.stiffness, exact = row.deflection;
    CHECK(K == Approx(row.shear_stiffness).epsilon(row.softness == 1 ? 3e-5 : 1e-5));  // half a last digit as printed
    CHECK(MindlinPlate{shear.bending, K}.deflection(p) / exact == Approx(row.fsdt).epsilon(1e-4).margin(1e-4));
    CHECK(MindlinPlate{shear.bending, FiveSixthsShear{}.stiffness(shear)}.deflection(p) / exact ==
          Approx(row.five_sixths).margin(1e-4));

    // For soft cores the share of the faces in 1/K is nothing; the formula is for s that matter.
    CHECK(shear.error(row.strip.length) == Approx(row.error).epsilon(0.01).margin(2e-4));
    CHECK(row.fsdt - 1 == Approx(shear.error(row.strip.length)).epsilon(0.025).margin(4e-3));

    // The cure: within 1 % of exact elasticity, where the core is not squeezed.
    const double cured = EffectiveShear{.length = row.strip.length}.stiffness(shear);
    CHECK(MindlinPlate{shear.bending, cured}.deflection(p) / exact == Approx(1).margin(0.01));
  }
}

TEST_CASE("transverse shear: with the cure frequencies are within 1 % of exact for cores up to 1e5 times softer") {
  for (const Sandwich& strip : {glass, thick})
    for (const double softness : {1., 10., 1e2, 1e3, 1e4, 1e5}) {
      CAPTURE(strip.name, softness);
      const auto section = strip.section(softness, EffectiveShear{.length = strip.length});
      const MindlinPlate plate{section.transverse_shear().bending, section.shear_stiffness(), section.density(),
                               section.rotary_inertia()};
      CHECK(plate.angular_frequency(strip.p()) / strip.laminate(softness).angular_frequency(strip.p()) ==
            Approx(1).margin(0.01));
    }
}

TEST_CASE("transverse shear: two faces that do not shear and a core that does nothing else are sandwich theory") {
  // Allen (1969): W = q/(p^4 Df + 1/(1/(p^4 D0) + 1/(p^2 Kc))), of which error() and the cure are exact consequences
  const double h1 = 3, hc = 0.76, h2 = 5, Q1 = 7e4, Q2 = 5e4, Gc = 8, rigid = 1e12;
  const double d = hc + (h1 + h2) / 2, D0 = Q1 * h1 * Q2 * h2 / (Q1 * h1 + Q2 * h2) * d * d, Kc = Gc * d * d / hc;
  const double Df = (Q1 * h1 * h1 * h1 + Q2 * h2 * h2 * h2) / 12, phi = Df / D0;
  const auto shear =
      transverse_shear(std::vector<ShearLayer<double>>{{h1, {Q1, rigid}}, {hc, {0, Gc}}, {h2, {Q2, rigid}}});
  const double K = shear.stiffness;
  CHECK(shear.bending == Approx(D0 + Df).epsilon(1e-14));
  CHECK(shear.own_bending == Approx(Df).epsilon(1e-10));
  CHECK(K == Approx(Kc * (1 + phi) * (1 + phi)).epsilon(1e-10));
  for (const double length : {10., 100., 1000.}) {
    const double p = pi / length, p2 = p * p, p4 = p2 * p2;
    const double exact = 1 / (p4 * Df + 1 / (1 / (p4 * D0) + 1 / (p2 * Kc)));
    CHECK(MindlinPlate{shear.bending, K}.deflection(p) / exact - 1 == Approx(shear.error(length)).epsilon(1e-8));
    CHECK(MindlinPlate{shear.bending, shear.effective_stiffness(length)}.deflection(p) == Approx(exact).epsilon(1e-9));
  }
}

TEST_CASE("transverse shear: five layers with two soft ones, cured, are within 2 % of exact elasticity") {
  for (const double softness : {1., 1e2, 1e3, 1e4, 1e5}) {
    CAPTURE(softness);
    const ElasticLayer face{3, 70000, .22}, core{.76, 70000 / softness, .45};
    const Laminate laminate({face, core, face, core, face});
    const auto shear = laminate.transverse_shear();
    const double p = pi / 300, exact = laminate.deflection(p);
    CHECK(MindlinPlate{shear.bending, shear.effective_stiffness(300)}.deflection(p) / exact == Approx(1).margin(0.02));
    CHECK(MindlinPlate{shear.bending, shear.stiffness}.deflection(p) / exact - 1 ==
          Approx(shear.error(300)).epsilon(0.03).margin(4e-3));
  }
}

TEST_CASE("transverse shear: the flow is in equilibrium, and exact for long waves") {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const auto layers = random_layers(random);
    const auto g = flows(layers);
    double force = 0, last = 0, energy = 0;
    for (std::size_t k = 0; k < g.size(); ++k) {
      const double h = layers[k].thickness;
      CHECK(g[k].bottom == Approx(last).margin(1e-14));
      force += h * (g[k](0) + 4 * g[k](0.5) + g[k](1)) / 6;
      for (int n = 0; n < 1000; ++n)
        energy += h * g[k]((n + .5) / 1000) * g[k]((n + .5) / 1000) / 1000 / layers[k].moduli.shear;
      last = g[k].top;
    }
    CHECK(force == Approx(1).epsilon(1e-12));
    CHECK(last == Approx(0).margin(1e-12));
    CHECK(1 / energy == Approx(transverse_shear(layers).stiffness).epsilon(1e-5));  // the midpoint rule
  }
  const double p = pi / 30000;  // glass, but a hundred times as long
  for (const double softness : {1., 10., 100.}) {
    const Laminate laminate = glass.laminate(softness);
    std::vector<ShearLayer<double>> layers;
    for (const ElasticLayer& layer : laminate.layers())
      layers.push_back({layer.thickness, {layer.plane_modulus(), layer.shear_modulus()}});
    const auto g = flows(layers);
    double bottom = 0;
    std::size_t k = 0;
    for (const LaminateWave& wave : laminate.profile(p, 10)) {
      if (wave.layer != k) bottom += layers[k++].thickness;
      const double xi = (wave.z - bottom) / layers[k].thickness;
      CHECK(g[k](xi) == Approx(std::abs(wave.T) * p).margin(1e-5 / laminate.thickness()));
    }
  }
}

TEST_CASE("transverse shear: K rises in proportion to all moduli, never exceeds the sum of G h, and runs in lanes") {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const auto layers = random_layers(random);
    const auto shear = transverse_shear(layers);
    CHECK(shear.stiffness <= shear.layer_sum);

    // Euler: dK/dc = K at c = 1 of all moduli times c
    using D = Dual<double, 1>;
    std::vector<ShearLayer<D>> scaled;
    const D c = D::variable(1, 0);
    for (const auto& [h, m] : layers) scaled.push_back({h, {c * m.normal, c * m.shear}});
    const D K = transverse_shear(scaled).stiffness;
    CHECK(K.value() == Approx(shear.stiffness).epsilon(1e-14));
    CHECK(K.derivative(0) == Approx(shear.stiffness).epsilon(1e-11));

    using P = Pack<double, 8>;
    std::vector<ShearLayer<P>> packed;
    for (const auto& [h, m] : layers) packed.push_back({h, {m.normal, m.shear}});
    CHECK(transverse_shear(packed).stiffness[5] == Approx(shear.stiffness).epsilon(1e-14));
    using F = Pack<float, 16>;
    std::vector<ShearLayer<F>> single;
    for (const auto& [h, m] : layers) single.push_back({h, {m.normal, m.shear}});
    CHECK(transverse_shear(single).stiffness[5] == Approx(shear.stiffness).epsilon(1e-4));
  }
}
