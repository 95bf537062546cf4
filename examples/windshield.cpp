// A bird of 4 lb at 400 knots strikes a curved laminate at 45 degrees: acrylic, interlayer, polycarbonate, interlayer
// and polycarbonate in one layer of plates. The same strike on the section with the plain shear factor of 5/6 and on
// one monolithic plate of the same mass shows the effect of the layers.
//
//   bash examples/run windshield
//   bash examples/run windshield bird=high
//   bash examples/run windshield ranks=2
//   bash examples/run windshield bird=particles across=12
//   bash examples/run windshield speed=350 end=10
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/bird_strike.hpp"
#include "support/options.hpp"
#include "support/processes.hpp"

using namespace strike;

namespace {

// The windshield lies on a cylinder whose axis climbs at 45 degrees along the flight. Shape and lay-up are assumptions
// after figure 9 of Brockman and Held (1991), which gives no sizes.
constexpr double radius = 24, length = 30, half_arc = 40 * std::numbers::pi / 180;
constexpr double acrylic_thickness = 0.1, interlayer_thickness = 0.05, outer_thickness = 0.25, inner_thickness = 0.125;
constexpr double thickness = acrylic_thickness + 2 * interlayer_thickness + outer_thickness + inner_thickness;

/// A plastic by its data sheet [psi].
struct Plastic {
  double specific_gravity, youngs_modulus, poissons_ratio;
  LinearEos eos() const {
    return {.density = 1000 * specific_gravity * examples::per_kg_m3,
            .bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio))};
  }
  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
};
constexpr Plastic polycarbonate_sheet{1.2, 340e3, 0.37}, acrylic_sheet{1.19, 450e3, 0.35},
    interlayer_sheet{1.08, 1500, 0.49};

/// Yields at 8400 psi and carries 100 % of strain.
const PlaneStress polycarbonate{Solid{
    polycarbonate_sheet.eos(),
    VonMises{.shear_modulus = polycarbonate_sheet.shear_modulus(), .yield_stress = 8400, .hardening_modulus = 15e3},
    FailureStrain{0.7}}};
/// Breaks at 10 500 psi, without any flow.
const PlaneStress acrylic{Solid{acrylic_sheet.eos(),
                                VonMises{.shear_modulus = acrylic_sheet.shear_modulus(), .yield_stress = 10.5e3},
                                UltimateStress{10.5e3}}};
/// A polyurethane, elastic; its modulus is an assumption, for it depends on temperature and rate more than on its make.
const PlaneStress interlayer{Elastic{.density = 1080 * examples::per_kg_m3,
                                     .youngs_modulus = interlayer_sheet.youngs_modulus,
                                     .poissons_ratio = interlayer_sheet.poissons_ratio}};

/// From the outside, which plates face, to the inside: so layer 0, the lowest, is the inner polycarbonate.
template <class Shear>
auto laminate(const Shear& shear) {
  return Layered{Layer{polycarbonate, inner_thickness}, Layer{interlayer, interlayer_thickness},
                 Layer{polycarbonate, outer_thickness}, Layer{interlayer, interlayer_thickness},
                 Layer{acrylic, acrylic_thickness},     shear};
}

examples::Transparency pane() {
  const std::array<Index, 2> cells{32, 24};
  const Mesh flat = panel({.radius = radius, .length = length, .arc = {-half_arc, half_arc}, .cells = cells});
  const auto on_edge = [&](const Eigen::Vector3d& x) {
    return x.y() < 1e-6 || x.y() > length - 1e-6 || std::abs(std::atan2(x.x(), x.z())) > half_arc - 1e-6;
  };
  const double right = std::numbers::pi / 2;
  return {rotated(rotated(flat, {0, 0, 1}, -right), {0, 1, 0}, -right / 2),
          nodes_where(flat.nodes, on_edge),
          thickness,
          {{"middle", nearest_node(flat.nodes, {0, length / 2, radius})},
           {"half way up", nearest_node(flat.nodes, {0, 0.75 * length, radius})}}};
}

void report(const std::vector<std::pair<std::string, examples::Flight>>& flights, const std::string& bird) {
  std::printf("\nWindshield, %s\n\n", examples::name_of(bird).c_str());
  Results results;
  Chart chart{{.title = "Middle of the windshield",
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "displacement", .unit = "in"}}};
  for (const auto& [model, flight] : flights) {
    for (const std::string& warning : flight.warnings) std::printf("%s: %s\n", model.c_str(), warning.c_str());
    results.add({model + ": largest displacement", flight.peaks[0], "in"});
    for (std::size_t k = 0; k < flight.layers.size(); ++k) {
      const auto& [strain, failed] = flight.layers[k];
      const std::string layer = ", layer " + std::to_string(k);
      if (strain > 0) results.add({model + ": plastic strain" + layer, strain, "1"});
      if (failed > 0) results.add({model + ": failed share" + layer, failed, "1"});
    }
    examples::add_checks(results, flight, model + ": ");
    chart.curve(model, flight.times, flight.displacements[0]);
  }
  results.print();
  results.write("results.csv");
  chart.write("displacement.svg");
  std::printf(
      "\nWritten: results.csv, displacement.svg, and of each model NAME.csv, NAME_*ms.svg, NAME.pvd (ParaView)\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [&](examples::Options& options) {
    const examples::Session session(count, arguments);
    const std::string bird = options.choice("bird", {"low", "high", "particles"});
    const double speed = options.number("speed", 400), end = options.number("end", 20);
    const unsigned across = options.count("across", 8);
    options.check();

    const examples::Transparency windshield = pane();
    std::vector<std::pair<std::string, examples::Flight>> flights;
    const auto all = [&](const Mesh& upright, const auto& part_of) {
      const auto fly = [&](const std::string& model, const auto& section) {
        flights.push_back({model, examples::strike_at(windshield, section, upright, part_of, speed * examples::knot,
                                                      1e-3 * end, model, "Windshield, " + model, {1, 2, 5})});
      };
      const auto layered = laminate(EffectiveShear{.length = length / 2});
      fly("layered", layered);
      fly("plain_shear", laminate(FiveSixthsShear{}));
      fly("monolithic", Homogeneous{polycarbonate, layered.density() / density_of(polycarbonate)});
    };
    const auto tetrahedra = [&](const auto& flesh) {
      all(examples::Bird::tetrahedra(), [&](const Mesh& mesh) { return examples::part_of_tetrahedra(flesh, mesh); });
    };
    if (bird == "low") tetrahedra(examples::Bird::low_strength());
    if (bird == "high") tetrahedra(examples::Bird::high_strength());
    if (bird == "particles")
      all(examples::Bird::particles(across),
          [](const Mesh& mesh) { return examples::part_of_particles(examples::Bird::tensionless(), mesh); });
    report(flights, bird);
  });
}
