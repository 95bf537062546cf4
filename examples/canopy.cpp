// A bird of 4 lb at 350 knots strikes the crown of a bubble canopy of polycarbonate half an inch thick, like the sample
// analysis of Brockman and Held (1991), figures 2, 14 and 15: 928 plates and the bird in tetrahedra, or in particles.
//
//   bash examples/run canopy
//   bash examples/run canopy bird=high
//   bash examples/run canopy ranks=2
//   bash examples/run canopy bird=particles across=12
//   bash examples/run canopy bird=particles strength=high
//   bash examples/run canopy speed=400 end=10
#include <cstdio>
#include <string>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/bird_strike.hpp"
#include "support/options.hpp"
#include "support/processes.hpp"

using namespace strike;

namespace {

// The canopy starts at fuselage station 88; the bird's centre strikes at 112, two feet aft of that, as in the paper.
// Its shape is an assumption, for the paper gives none: about as long, wide and high as that of an F-16.
constexpr double first_station = 88, struck_station = 112, thickness = 0.5;
constexpr CanopyShape shape{.length = 80,
                            .top = 50,
                            .height = {.front = 6, .top = 26, .back = 20},
                            .half_width = {.front = 10, .top = 18, .back = 15},
                            .cells = {29, 32}};

/// Polycarbonate by its data sheets: 340 ksi, yield at 8400 psi, 9500 psi and 100 % at rupture (true stress 19 ksi),
/// specific gravity 1.2, Poisson's ratio 0.37. Impact is faster than any of these tests: the yield is on the safe side.
constexpr double youngs_modulus = 340e3, poissons_ratio = 0.37;
const PlaneStress polycarbonate{Solid{
    LinearEos{.density = 1200 * examples::per_kg_m3, .bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio))},
    VonMises{
        .shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio)), .yield_stress = 8400, .hardening_modulus = 15e3},
    FailureStrain{0.7}}};

examples::Transparency bubble() {
  examples::Transparency canopy{strike::canopy(shape), {}, thickness, {}};
  const Mesh& mesh = canopy.mesh;
  canopy.edge = nodes_where(
      mesh.nodes, [](const Eigen::Vector3d& x) { return x.z() < 1e-6 || x.x() < 1e-6 || x.x() > shape.length - 1e-6; });
  for (const double station : {struck_station, 124.0, 138.0, 152.0}) {
    const double x = station - first_station;
    canopy.watched.push_back(
        {"station " + examples::text(station), nearest_node(mesh.nodes, {x, 0, shape.height_at(x)})});
  }
  return canopy;
}

void report(const examples::Transparency& canopy, const examples::Flight& flight, const std::string& bird,
            double speed) {
  std::printf("\nCanopy, %zu plates, %s at %.0f knots\n\n", canopy.mesh.quadrilaterals.size(),
              examples::name_of(bird).c_str(), speed);
  for (const std::string& warning : flight.warnings) std::printf("%s\n", warning.c_str());
  Results results;
  for (std::size_t k = 0; k < canopy.watched.size(); ++k)
    results.add({"largest displacement, " + canopy.watched[k].first, flight.peaks[k], "in"});
  results.add({"impulse on the bird", flight.impulse, "lbf s"});
  examples::add_checks(results, flight);
  results.add({"CPU time", flight.seconds, "s", 0, 60, "budget"});
  results.print();
  results.write("results.csv");

  Chart chart{{.title = "Crown of the canopy, " + examples::name_of(bird),
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "displacement", .unit = "in"}}};
  for (std::size_t k = 0; k < canopy.watched.size(); ++k)
    chart.curve(canopy.watched[k].first, flight.times, flight.displacements[k]);
  chart.write("displacement.svg");
  std::printf("\nWritten: results.csv, %s.csv, displacement.svg, %s_*ms.svg, %s.pvd (ParaView)\n", bird.c_str(),
              bird.c_str(), bird.c_str());
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [&](examples::Options& options) {
    const examples::Session session(count, arguments);
    const std::string bird = options.choice("bird", {"low", "high", "particles"}),
                      strength = options.choice("strength", {"none", "low", "high"});
    const double speed = options.number("speed", 350), end = options.number("end", 20);
    const unsigned across = options.count("across", 8);
    options.check();

    const examples::Transparency canopy = bubble();
    const Homogeneous section{polycarbonate, thickness, Simpson<5>{}};
    const auto fly = [&](const Mesh& upright, const auto& part_of) {
      report(canopy,
             examples::strike_at(canopy, section, upright, part_of, speed * examples::knot, 1e-3 * end, bird,
                                 "Canopy, " + examples::name_of(bird), {2, 5, 10, 20}),
             bird, speed);
    };
    const auto tetrahedra = [&](const auto& flesh) {
      fly(examples::Bird::tetrahedra(), [&](const Mesh& mesh) { return examples::part_of_tetrahedra(flesh, mesh); });
    };
    const auto particles = [&](const auto& flesh) {
      fly(examples::Bird::particles(across),
          [&](const Mesh& mesh) { return examples::part_of_particles(flesh, mesh); });
    };
    if (bird == "low") tetrahedra(examples::Bird::low_strength());
    if (bird == "high") tetrahedra(examples::Bird::high_strength());
    if (bird != "particles") return;
    if (strength == "none") particles(examples::Bird::tensionless());
    if (strength == "low") particles(examples::Bird::low_strength_flowing());
    if (strength == "high") particles(examples::Bird::high_strength());
  });
}
