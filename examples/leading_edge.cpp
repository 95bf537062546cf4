// A bird of 4 lb strikes the nose of a wing whose skin is of carbon fibres or of aluminium.
//
//   bash examples/run leading_edge
//   bash examples/run leading_edge skin=aluminium
//   bash examples/run leading_edge speed=90 sweep=25 ply=0.375
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

// Millimetres, milliseconds, kilograms: so GPa, kN and J, and speeds in m/s.

/// The nose of a NACA 0012 (Jacobs, Ward and Pinkerton 1933) before a front spar, between two ribs: a radius of
/// 1.1019 t^2 c = 24 mm. Chord, spar and ribs are assumptions; the skin is clamped there.
struct Nose {
  double chord = 1500, thickness = 0.12, spar = 0.15 * chord, span = 540;

  double half_height(double x) const {
    const double s = x / chord;
    return 5 * thickness * chord * (0.2969 * std::sqrt(s) + s * (-0.1260 + s * (-0.3516 + s * (0.2843 - s * 0.1015))));
  }
  double slope(double x) const {
    const double s = x / chord;
    return 5 * thickness * (0.14845 / std::sqrt(s) - 0.1260 + s * (-2 * 0.3516 + s * (3 * 0.2843 - s * 4 * 0.1015)));
  }
  /// Upper and lower skin around the nose, cells finest there, facing outwards.
  Mesh skin(Index around, Index along) const {
    return sheet({around, along}, [&](double s, double t) {
      const double side = 2 * s - 1, x = spar * side * side;
      return Eigen::Vector3d(x, span * (t - 0.5), std::copysign(half_height(x), side));
    });
  }
};

/// Water of Brockman and Held (1991), with no tension.
const Fluid water{CubicEos{.density = 0.95e-6, .C1 = 2.06, .C2 = 6.19, .C3 = 10.3, .pressure_cutoff = 0}};
constexpr double mass = 1.81436948;

/// T300/5208 by Tsai and Hahn (1980). Assumed: G13 = G12, and G23 of a Poisson's ratio of 0.5 in the plane across.
const FailingPly carbon{
    OrthotropicPly{.density = 1.6e-6, .E1 = 181, .E2 = 10.3, .nu12 = 0.28, .G12 = 7.17, .G13 = 7.17, .G23 = 3.4},
    ChangChang{.Xt = 1.5, .Xc = 1.5, .Yt = 0.040, .Yc = 0.246, .S = 0.068}};

/// 2024-T351: flow by Johnson and Cook (1983), fracture by Johnson and Holmquist (1989), elasticity of sheet by
/// MIL-HDBK-5. Assumed: 0.9 of the plastic work is heat, and sheet flows and breaks as the plate that was tested.
constexpr double E = 72.4, nu = 0.33, room = 294, melting = 775, per_second = 1e-3;
const PlaneStress aluminium{Solid{LinearEos{.density = 2.77e-6, .bulk_modulus = E / (3 * (1 - 2 * nu))},
                                  JohnsonCook{.shear_modulus = E / (2 * (1 + nu)),
                                              .A = 0.265,
                                              .B = 0.426,
                                              .n = 0.34,
                                              .C = 0.015,
                                              .reference_rate = per_second,
                                              .m = 1,
                                              .initial_temperature = room,
                                              .melting_temperature = melting,
                                              .heating = 0.9 / (2.77e-6 * 875)},
                                  JohnsonCookFailure{.D1 = 0.13,
                                                     .D2 = 0.13,
                                                     .D3 = -1.5,
                                                     .D4 = 0.011,
                                                     .reference_rate = per_second,
                                                     .D5 = 0,
                                                     .initial_temperature = room,
                                                     .melting_temperature = melting}}};

struct Strike {
  double speed, sweep, height;  ///< sweep in radians; height of the bird's axis over the nose
  Index across;                 ///< particles across the bird
  Nose nose{};
  BirdShape shape{.mass = mass, .density = 0.95e-6, .sector = Sector::full};
  BirdSize size = size_of(shape);
  double spacing = size.diameter / across, end = 1.6 * size.length / speed;

  Eigen::Vector3d flight() const { return {std::cos(sweep), std::sin(sweep), 0}; }
  bool is_symmetric() const { return sweep == 0 && height == 0; }

  /// The bird, along its flight, clear of the nose at x = 0 by half the thickness of the skin and half a spacing.
  Mesh bird(double skin) const {
    Mesh bird = rotated(particles(shape, across), {0, 1, 0}, -std::numbers::pi / 2);
    bird = rotated(translated(bird, {0.5 * size.length, 0, 0}), {0, 0, 1}, sweep);
    double front = -size.length;
    for (const Eigen::Vector3d& x : bird.nodes) front = std::max(front, x.x());
    const double way = front + 0.51 * (skin + spacing);
    return translated(bird, Eigen::Vector3d(0, 0, height) - way / std::cos(sweep) * flight());
  }
  /// The share of its momentum that a bird gives to this nose whose layers keep what they have along the skin and lose
  /// what they have across: the mean of sin^2 of the angle between both over the bird (Newton), of no sweep.
  double glancing_share() const {
    double sum = 0, width = 0;
    for (int k = 0; k < 2000; ++k) {
      const double x = nose.spar * (k + 0.5) / 2000, z = nose.half_height(x), dz = nose.slope(x) * nose.spar / 2000;
      for (const double y : {z - height, z + height})
        if (const double r = 0.5 * size.diameter; std::abs(y) < r) {
          const double w = std::sqrt(r * r - y * y) * dz, t = nose.slope(x);
          sum += w * t * t / (1 + t * t), width += w;
        }
    }
    return sum / width;
  }
};

struct Outcome {
  std::vector<double> times{}, forces{};
  double energy_error = 0, impulse_error = 0, dent = 0, seconds = 0, absorbed = 0, delamination = 0;
  Eigen::Vector3d impulse{0, 0, 0};
  double fibres = 0, matrix = 0, hourglass = 0;  ///< shares of all points that have failed, of the bird's energy
  bool has_fibres = false;
  std::size_t deleted = 0, steps = 0, plates = 0, particles = 0;
  std::vector<std::string> warnings{};
};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Aluminium fails by its law; plates of carbon go when they are strained ten times as far as fibres bear, 0.8 %, if
/// some of their points have not failed by then. Crushed ones, whose steps have become a fifth, go in both.
constexpr Erosion torn{.strain = 0.08, .step = 1e-4}, crushed{.step = 1e-4};

template <class Section, class Damage>
Outcome fly(const Strike& strike, const Section& section, const Damage& damage, const char* quantity,
            const Mesh& skin) {
  const double h = section.thickness();
  Mesh mesh = skin;
  std::vector<Index> bird;
  const Index first = append(mesh, strike.bird(h));
  for (Index i = first; i < mesh.nodes.size(); ++i) bird.push_back(i);
  const std::vector<Index> edges = nodes_where(skin.nodes, [&](const Eigen::Vector3d& x) {
    return x.x() > (1 - 1e-9) * strike.nose.spar || std::abs(x.y()) > (0.5 - 1e-9) * strike.nose.span;
  });

  Explicit run{Scene{mesh.nodes,                                                                          //
                     Part{Plate4{}, section, mesh.quadrilaterals, Section::has_fibres ? torn : crushed},  //
                     Part{Particle{}, water, mesh.particles},                                             //
                     InitialVelocity{strike.speed * strike.flight(), bird},                               //
                     Clamped{edges},                                                                      //
                     Contact{NodeToSurface{bird, plate_surface(mesh.quadrilaterals, h, 0), strike.spacing}}}};
  const auto& panel = run.template part<0>();
  const auto& contact = run.template item<4>();

  Outcome outcome{.plates = mesh.quadrilaterals.size(), .particles = bird.size()};
  const auto momentum = [&] {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Index i : bird) p += run.nodes().mass(i) * run.nodes().v(i);
    return p;
  };
  const auto bird_energy = [&] {
    double energy = 0;
    for (const Index i : bird) energy += 0.5 * run.nodes().mass(i) * run.nodes().v(i).squaredNorm();
    return energy;
  };
  const auto draw = [&] {
    Picture picture{
        {.title = "Bird on a leading edge after " + examples::text(std::round(1e3 * run.time()) / 1e3) + " ms",
         .quantity = quantity,
         .from = {-1.6, -1.2, 1},
         .low = 0,
         .length_unit = "mm"}};
    const std::vector<Eigen::Vector3d> x = run.positions();
    const std::vector<bool> alive = panel.alive();
    const Mesh left{.nodes = mesh.nodes, .quadrilaterals = remaining(mesh.quadrilaterals, alive)};
    picture.add(quadrilateral_surface(left.quadrilaterals), x, remaining(panel.field(damage), alive), Sides::both);
    picture.add(mesh.particles, x);
    picture.write("leading_edge.svg");
  };
  History history{"history.csv",
                  {{"time", "ms"},
                   {"force on the bird along its flight", "kN"},
                   {"impulse on the bird along its flight", "N s"},
                   {"dent of the nose", "mm"},
                   {"kinetic energy of the bird", "J"},
                   {"internal energy", "J"},
                   {"contact energy", "J"},
                   {"eroded energy", "J"},
                   {"energy error", "1"}}};
  VtuSeries film{"leading_edge"};
  Progress progress{{.end = strike.end, .unit = "ms"}};
  const Eigen::Vector3d before = momentum();
  const double energy_before = bird_energy();
  double impulse_before = 0, time_before = 0;
  bool pictured = false;
  std::vector<bool> parting(mesh.quadrilaterals.size());  // plies that would
  const std::clock_t begin = std::clock();
  run.until(
      strike.end,
      [&] {
        outcome.energy_error = std::max(outcome.energy_error, std::abs(run.energy().error()));
        outcome.hourglass = std::max(outcome.hourglass, std::abs(run.energy().hourglass) / energy_before);
        progress(run);
        if (!pictured && run.time() > 0.5 * strike.end) pictured = true, draw();
      },
      Every{strike.end / 200,
            [&] {
              const std::vector<bool> alive = panel.alive();
              for (std::size_t e = 0; e < alive.size(); ++e)
                for (const Index i : mesh.quadrilaterals[e])
                  if (alive[e]) outcome.dent = std::max(outcome.dent, run.nodes().x(i).x() - skin.nodes[i].x());
              if constexpr (Section::has_fibres) {
                const auto index = panel.field(Delamination{.shear_strength = carbon.criterion.S});
                for (std::size_t e = 0; e < index.size(); ++e) parting[e] = parting[e] || index[e] >= 1;
              }
              const double t = run.time(), J = -contact.impulse().dot(strike.flight());
              outcome.times.push_back(t);
              outcome.forces.push_back(t > time_before ? (J - impulse_before) / (t - time_before) : 0);
              time_before = t, impulse_before = J;
              const Energy& e = run.energy();
              history.row(t, outcome.forces.back(), J, outcome.dent, bird_energy(), e.internal, e.contact, e.eroded,
                          e.error());
            }},
      Every{strike.end / 20, [&] {
              const std::vector<bool> alive = panel.alive();
              Mesh left = mesh;
              left.quadrilaterals = remaining(mesh.quadrilaterals, alive);
              std::vector<double> values = remaining(panel.field(damage), alive);  // before those of the particles
              values.resize(values.size() + bird.size());
              film.write(run.time(), left, run.positions(), {}, {{quantity, values}});
            }});
  outcome.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  outcome.impulse = -contact.impulse();
  outcome.impulse_error = (momentum() - before - contact.impulse()).norm() / before.norm();
  outcome.absorbed = (energy_before - bird_energy()) / energy_before;
  outcome.fibres = mean(panel.field(Failed{}));
  outcome.has_fibres = Section::has_fibres;
  if constexpr (Section::has_fibres) {
    outcome.matrix = mean(panel.field(MatrixFailed{}));
    outcome.delamination =
        static_cast<double>(std::count(parting.begin(), parting.end(), true)) / static_cast<double>(parting.size());
  }
  outcome.deleted = panel.deleted(), outcome.steps = run.steps(), outcome.warnings = run.warnings();
  return outcome;
}

void report(const Strike& strike, const Outcome& o, const std::string& skin) {
  std::printf("\nBird at %g m/s on a nose of %s, %zu plates, %zu particles\n\n", strike.speed, skin.c_str(), o.plates,
              o.particles);
  for (const std::string& warning : o.warnings) std::printf("%s\n", warning.c_str());
  Results results;
  const double along = o.impulse.dot(strike.flight()), share = along / (mass * strike.speed);
  const bool holds = o.deleted == 0;  // a skin that breaks lets through what it pleases, and any rounding decides where
  if (holds && strike.sweep == 0) {
    const double least = strike.glancing_share();
    results.add({"impulse on the skin over m v", share, "1", 0.5 * (1 + least), 0.5 * (1 - least), "sin^2 to 1"});
  } else {
    results.add({"impulse on the skin over m v", share, "1"});
  }
  const double aside = std::hypot(o.impulse.y(), o.impulse.z()) / along;
  if (holds && strike.is_symmetric())  // the skin is its own image when it turns by 180 degrees about the flight
    results.add({"impulse aside over that along", aside, "1", 0, 0.01, "symmetry"});
  else
    results.add({"impulse aside over that along", aside, "1"});
  results.add({"momentum of the bird less the impulse, over m v", o.impulse_error, "1", 0, 1e-9, "balance"});
  results.add({"energy error", o.energy_error, "1", 0, 0.01, "balance"});
  results.add({"kinetic energy that the bird lost", 100 * o.absorbed, "%"});
  results.add({"dent of the nose", o.dent, "mm"});
  if (o.has_fibres) {
    results.add({"matrix failed", 100 * o.matrix, "%"});
    results.add({"fibres failed", 100 * o.fibres, "%"});
    results.add({"plates whose plies would part", 100 * o.delamination, "%"});
  } else {
    results.add({"failed", 100 * o.fibres, "%"});
  }
  // With aluminium all but a fiftieth is that of particles, which damp what is not linear in their splash.
  results.add({"hourglass energy over the bird's", 100 * o.hourglass, "%"});
  results.add({"deleted plates", static_cast<double>(o.deleted), "1"});
  results.add({"steps", static_cast<double>(o.steps), "1"});
  results.add({"CPU time", o.seconds, "s", 0, 60, "budget"});
  results.print();
  results.write("results.csv");
  Chart chart{{.title = "Bird on a leading edge of " + skin,
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "force along the flight", .unit = "kN"}}};
  chart.curve(skin, o.times, o.forces);
  chart.write("force.svg");
  std::printf("\nWritten: results.csv, history.csv, force.svg, leading_edge.svg, leading_edge.pvd (ParaView)\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string skin = options.choice("skin", {"composite", "aluminium"});
    const double speed = options.number("speed", 120), sweep = options.number("sweep", 0),
                 height = options.number("height", 0), ply = options.number("ply", 0.25),
                 sheet = options.number("sheet", 2);
    const Index across = options.count("across", 10), around = options.count("around", 40),
                along = options.count("along", 36);
    options.check();
    const Strike strike{speed, sweep * std::numbers::pi / 180, height, across};
    const Mesh mesh = strike.nose.skin(around, along);
    if (skin == "composite") {
      const Layered laminate{LayUp{carbon, ply, {0, 45, -45, 90, 90, -45, 45, 0}}, FibreDirection{{0, 1, 0}}};
      report(strike, fly(strike, laminate, Failed{}, "fibres failed", mesh), "eight plies");
    } else {
      report(strike, fly(strike, Layered{Layer{aluminium, sheet}}, PlasticStrain{}, "plastic strain", mesh),
             "aluminium");
    }
  });
}
