// A laminated pane, glass on a soft interlayer on glass: the shear stiffness, the deflection and the stress between the
// layers as a section of a plate has them, beside three-dimensional elasticity, for five decades of the ratio of
// moduli.
//
//   bash examples/run laminated_plate
//   bash examples/run laminated_plate core=10 face=1
//   bash examples/run laminated_plate length=100
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>
#include <strike/verify.hpp>

#include "support/options.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

// Millimetres, newtons, megapascals.
struct Pane {
  double face, core, length, softness;

  Elastic glass() const { return {.density = 2.5e-9, .youngs_modulus = 70000, .poissons_ratio = 0.22}; }
  Elastic interlayer() const {
    return {.density = 1.07e-9, .youngs_modulus = 70000 / softness, .poissons_ratio = 0.45};
  }
  double p() const { return std::numbers::pi / length; }

  // Section of a plate.
  template <class Shear>
  auto section(const Shear& shear) const {
    return Layered{Layer{PlaneStress{glass()}, face}, Layer{PlaneStress{interlayer()}, core},
                   Layer{PlaneStress{glass()}, face}, shear};
  }
  // Three-dimensional elasticity without any assumption.
  Laminate exact() const {
    const auto layer = [](const Elastic& e, double h) {
      return ElasticLayer{h, e.youngs_modulus, e.poissons_ratio, e.density};
    };
    return Laminate({layer(glass(), face), layer(interlayer(), core), layer(glass(), face)});
  }
};

/// Prediction of a section for the strip under the pressure sin px.
struct Answer {
  double K, deflection, interlaminar;
  std::vector<double> z, tau;
};
template <class Shear>
Answer answer(const Pane& pane, const Shear& shear) {
  const auto section = pane.section(shear);
  typename decltype(section)::template State<double> state{};
  state.shear(0) = 1 / pane.p();  // V = q/p whatever the plate is made of
  const MindlinPlate plate{section.transverse_shear().bending, section.shear_stiffness()};
  Answer all{section.shear_stiffness(), plate.deflection(pane.p()), section.shear_stress(state, 1, 0.5)(0), {}, {}};
  double bottom = 0;
  for (std::size_t k = 0; k < section.layers(); ++k) {
    const double h = k == 1 ? pane.core : pane.face;
    for (const double xi : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      all.z.push_back(bottom + xi * h);
      all.tau.push_back(section.shear_stress(state, k, xi)(0));
    }
    bottom += h;
  }
  return all;
}

std::string power(int decade) { return "1e" + std::to_string(decade); }

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    Pane pane{options.number("face", 3), options.number("core", 0.76), options.number("length", 300), 1};
    options.check();

    std::printf("Strip of %g mm, %g + %g + %g mm, half a wave of pressure of 1 MPa\n\n", pane.length, pane.face,
                pane.core, pane.face);
    std::printf("%8s%11s |%12s   per exact deflection:%29s |%12s   per exact stress:\n", "glass to", "K", "deflection",
                "", "interlayer");
    std::printf("%8s%11s |%12s%13s%13s%15s%11s |%12s%13s%16s\n\n", "core", "[N/mm]", "[mm]", "5/6 sum G h",
                "EnergyShear", "EffectiveShear", "1 + error", "stress [MPa]", "EnergyShear", "EffectiveShear");
    std::vector<double> ratio, kirchhoff, five_sixths, energy, effective;
    Chart stress{{.title = "Shear stress through the pane",
                  .caption = "By the ratio of the moduli of glass and interlayer. Lines: three-dimensional elasticity; "
                             "circles: a section with EffectiveShear.",
                  .x = {.label = "shear stress per pressure"},
                  .y = {.label = "height", .unit = "mm"}}};
    Results results;
    for (int decade = 0; decade <= 5; ++decade) {
      pane.softness = std::pow(10, decade);
      const Laminate exact = pane.exact();
      const double w = exact.deflection(pane.p());
      const double tau = std::abs(exact.at(pane.p(), pane.face + pane.core / 2).T);
      const TransverseShear<double> shear = exact.transverse_shear();
      const Answer plain = answer(pane, FiveSixthsShear{}), ours = answer(pane, EnergyShear{}),
                   cured = answer(pane, EffectiveShear{.length = pane.length});
      std::printf("%8s%11.6g |%12.5g%13.4f%13.4f%15.4f%11.4f |%12.5g%13.4f%16.4f\n", power(decade).c_str(), ours.K, w,
                  plain.deflection / w, ours.deflection / w, cured.deflection / w, 1 + shear.error(pane.length), tau,
                  ours.interlaminar / tau, cured.interlaminar / tau);

      const auto named = [&](const char* what) { return std::string(what) + ", ratio " + power(decade); };
      const std::string source = "three-dimensional elasticity";
      results.add({named("deflection with EffectiveShear"), cured.deflection, "mm", w, 0.01 * w, source});
      const double predicted = w * (1 + shear.error(pane.length));
      results.add({named("deflection with EnergyShear"), ours.deflection, "mm", predicted, 0.02 * predicted,
                   source + " and the formula of the error"});
      results.add(
          {named("interlaminar stress with EffectiveShear"), cured.interlaminar, "MPa", tau, 0.01 * tau, source});

      ratio.push_back(pane.softness);
      kirchhoff.push_back(MindlinPlate{shear.bending, 1e99}.deflection(pane.p()) / w);
      five_sixths.push_back(plain.deflection / w), energy.push_back(ours.deflection / w),
          effective.push_back(cured.deflection / w);
      std::vector<double> z, t;
      for (const LaminateWave& wave : exact.profile(pane.p(), 60)) z.push_back(wave.z), t.push_back(std::abs(wave.T));
      stress.curve(power(decade), t, z, {.colour = decade});
      stress.points("", cured.tau, cured.z, {.marker = Marker::circle, .colour = decade});
    }
    std::printf("\n%s\n", pane.section(EnergyShear{}).warning(pane.length).c_str());
    results.write("results.csv");
    stress.write("stress.svg");

    Chart deflection{{.title = "Deflection of the pane in units of the exact one",
                      .x = {.label = "modulus of glass per modulus of interlayer", .scale = Scale::logarithmic},
                      .y = {.label = "deflection per exact deflection", .scale = Scale::logarithmic}}};
    deflection.curve("EffectiveShear", ratio, effective, {.marker = Marker::circle});
    deflection.curve("EnergyShear", ratio, energy, {.marker = Marker::square});
    deflection.curve("5/6 sum G h", ratio, five_sixths, {.marker = Marker::triangle});
    deflection.curve("no shear (Kirchhoff)", ratio, kirchhoff, {.line = Line::dashed});
    deflection.write("deflection.svg");
    std::printf("\nWritten: results.csv, stress.svg, deflection.svg\n");
  });
}
