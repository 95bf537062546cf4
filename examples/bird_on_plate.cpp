// A bird of 4 lb strikes a rigid plate head-on.
//
//   bash examples/run bird_on_plate
//   bash examples/run bird_on_plate speed=225 form=ellipsoid strength=high
//   bash examples/run bird_on_plate cells=hexahedra strength=none mesh=4
//   bash examples/run bird_on_plate cells=particles across=16
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

// Millimetres, milliseconds, kilograms: so GPa, kN and J, and speeds in m/s.
constexpr double mass = 1.81436948, density = 0.95e-6;
/// Brockman and Held (1991), with no tension.
constexpr CubicEos water{.density = density, .C1 = 2.06, .C2 = 6.19, .C3 = 10.3, .pressure_cutoff = 0};
constexpr VonMises flesh{.shear_modulus = 2.07e-3, .yield_stress = 2e-5, .hardening_modulus = 1e-6};
constexpr double at_yield = 0.999 * flesh.yield_stress;

/// Fails where it first yields, and flows as water then.
const Solid low_strength{water, flesh, BecomesFluid{UltimateStress{at_yield}}};
/// Fails where it first yields; failed elements give no force (X3D).
const Solid no_strength{water, flesh, UltimateStress{at_yield}};
/// Fails at a plastic strain of 500 %.
const Solid high_strength{water, flesh, FailureStrain{5}};

/// The stagnation pressure, from the forces on the nodes of the plate about the axis, with weights that fall from 1
/// there to 0 at `reach`.
struct Gauge {
  double reach, plate = 0;  // plate: the height at which nodes, or the middles of particles, are on it

  template <class Run>
  double pressure(const Run& run) const {
    double force = 0;
    for (std::size_t i = 0; i < run.nodes().size(); ++i) {
      const Eigen::Vector3d x = run.nodes().x(i);
      if (const double w = 1 - (x.x() * x.x() + x.y() * x.y()) / (reach * reach); w > 0 && x.z() - plate < 1e-6 * reach)
        force -= w * run.nodes().f(i).z();
    }
    return force / (std::numbers::pi / 8 * reach * reach);  // of a quarter
  }
};

/// Records of a run.
struct Record {
  const BirdShape& shape;
  double speed;
  BirdSize size = size_of(shape);
  Gauge gauge{0.3 * size.diameter};
  History history{"history.csv",
                  {{"time", "ms"},
                   {"length over that at the start", "1"},
                   {"force of the plate", "kN"},
                   {"impulse of the plate", "N s"},
                   {"pressure at the centre", "MPa"},
                   {"kinetic energy", "J"},
                   {"internal energy", "J"},
                   {"eroded energy", "J"},
                   {"energy error", "1"}}};
  double squash_time = size.length / speed;
  Progress progress{{.end = 1.6 * squash_time, .unit = "ms"}};
  double drift = 0, seconds = 0, lag = 0, impulse_before = 0, time_before = 0, steady = 0, steady_time = 0;
  std::vector<double> times{}, forces{}, lengths{};
  std::size_t steps = 0, deleted = 0, elements = 0;
  double impulse = 0;
  std::vector<std::string> warnings{};

  template <class Run>
  void watch(const Run& run) {
    drift = std::max(drift, std::abs(run.energy().error()));
    if (run.time() > 0.2 * squash_time && run.time() < 0.5 * squash_time) {
      steady += run.dt() * gauge.pressure(run);
      steady_time += run.dt();
    }
    progress(run);
  }
  template <class Run>
  void sample(const Run& run) {
    double tail = 0;
    for (const Index i : rear) tail += run.nodes().x(i).z() / static_cast<double>(rear.size());
    if (times.empty()) start = tail;
    const double t = run.time(), J = 4 * run.template item<4>().impulse().z();
    const double expected = 1 - speed * t / size.length, length = 1 - (start - tail) / size.length;
    if (t <= 0.42 * squash_time) lag = std::max(lag, std::abs(length - expected) / expected);
    times.push_back(t), lengths.push_back(length);
    forces.push_back(t > time_before ? (J - impulse_before) / (t - time_before) : 0);
    time_before = t, impulse_before = J;
    const Energy& e = run.energy();
    history.row(t, length, forces.back(), J, 1e3 * gauge.pressure(run), 4 * e.kinetic, 4 * e.internal, 4 * e.eroded,
                e.error());
  }
  std::vector<Index> rear{};
  double start = 0;  // of the rear
};

/// Exact for the steady flow of this water: int dp/rho = v^2/2.
double stagnation_pressure(double speed) {
  double p = 0, mu = 0;
  for (double head = 0; head < 0.5 * speed * speed;) {
    constexpr double d = 1e-6;
    const double next = water.A(mu + d), step = (next - p) / (density * (1 + mu + 0.5 * d));
    head += step, p = next, mu += d;
  }
  return p;
}

/// Picture of the remaining bird and of the nodes of its deleted elements.
void draw(const Record& record, const Mesh& mesh, const std::vector<Eigen::Vector3d>& positions,
          const std::vector<double>& pressure, const std::vector<bool>& alive, double time) {
  const Mesh left = remaining(mesh, alive);
  std::vector<Eigen::Vector3d> debris;
  for (const Index i : orphan_nodes(left)) debris.push_back(positions[i]);
  Picture picture{{.title = "Bird on a rigid plate after " + examples::text(std::round(1e3 * time) / 1e3) + " ms",
                   .quantity = "pressure",
                   .unit = "MPa",
                   .from = {1, -2.5, 0.6},
                   .mirror = {Axis::x},  // the other plane of symmetry is a section
                   .low = 0,
                   .high = 2e3 * stagnation_pressure(record.speed),
                   .length_unit = "mm"}};
  if (left.particles.empty())
    picture.add(surface(left), positions, remaining(pressure, alive));
  else
    picture.add(left.particles, positions, remaining(pressure, alive));
  picture.add_particles(debris);
  picture.write("bird.svg");
}

/// `edge` is that of the smallest element; the plate is at the height of the gauge.
template <class Part>
void strike_plate(const Part& bird, const Mesh& mesh, double edge, Record& record) {
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  const double c = std::sqrt(water.C1 / density);
  record.rear = nodes_where(mesh.nodes, [&](const auto& x) { return x.z() > 0.9 * record.size.length; });
  Explicit run{Scene{mesh.nodes,                              //
                     bird,                                    //
                     InitialVelocity{{0, 0, -record.speed}},  //
                     Symmetry{Axis::x, on(Axis::x)},          //
                     Symmetry{Axis::y, on(Axis::y)},          //
                     RigidWall{{0, 0, record.gauge.plate}, {0, 0, 1}}},
               ExplicitOptions{.largest_step = edge / c}};
  record.elements = bird.cells.size();
  const auto& part = run.template part<0>();
  const auto pressure = [&] {
    return part.field([](const auto& s) {
      if constexpr (requires { s.stress; })
        return (-1e3 / 3) * trace(s.stress);
      else
        return 1e3 * s.pressure;
    });
  };
  VtuSeries film{"bird"};
  int pictured = 0;
  const std::clock_t begin = std::clock();
  const double end = 1.6 * record.squash_time;
  run.until(
      end, [&] { record.watch(run); }, Every{end / 200, [&] { record.sample(run); }},
      Every{end / 20,
            [&] {
              const std::vector<double> left = remaining(pressure(), part.alive());
              film.write(run.time(), remaining(mesh, part.alive()), run.positions(), {}, {{"pressure [MPa]", left}});
            }},
      Every{0.35 * record.squash_time, [&] {
              if (pictured++ == 1) draw(record, mesh, run.positions(), pressure(), part.alive(), run.time());
            }});
  record.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  record.steps = run.steps(), record.warnings = run.warnings();
  const std::vector<bool> alive = part.alive();
  record.deleted = static_cast<std::size_t>(std::count(alive.begin(), alive.end(), false));
  record.impulse = 4 * run.template item<4>().impulse().z();
}

void report(const Record& r, const std::string& what) {
  std::printf("\nBird on a rigid plate at %g m/s, %zu %s\n\n", r.speed, r.elements, what.c_str());
  for (const std::string& warning : r.warnings) std::printf("%s\n", warning.c_str());
  Results results;
  const double p = 1e3 * stagnation_pressure(r.speed), momentum = mass * r.speed;
  results.add({"impulse of the plate", r.impulse, "N s", momentum, 0.02 * momentum, "m v"});
  results.add({"mean pressure at the centre", 1e3 * r.steady / r.steady_time, "MPa", p, 0.15 * p, "stagnation"});
  // Of no reference: where water without tension is released at once from its sides and its rear, it parts there.
  results.add({"largest lag of the tail behind 1 - v t/L, to 0.42 L/v", r.lag, "1"});
  results.add({"energy error", r.drift, "1", 0, 0.01, "balance"});
  results.add({"deleted elements", static_cast<double>(r.deleted), "1"});
  results.add({"steps", static_cast<double>(r.steps), "1"});
  results.add({"CPU time", r.seconds, "s"});
  results.print();
  results.write("results.csv");
  Chart chart{{.title = "Bird on a rigid plate",
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "force of the plate", .unit = "kN"}}};
  chart.curve("plate", r.times, r.forces);
  chart.write("force.svg");
  std::printf("\nWritten: results.csv, history.csv, force.svg, bird.svg, bird.pvd (ParaView)\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string form = options.choice("form", {"cylinder", "hemispherical", "ellipsoid"}),
                      cells = options.choice("cells", {"tetrahedra", "hexahedra", "particles"}),
                      strength = options.choice("strength", {"low", "high", "none"});
    const double speed = options.number("speed", 180.0556);
    const unsigned mesh = options.count("mesh", 3), layers = options.count("layers", 8 * mesh),
                   across = options.count("across", 12);
    const double share = options.number("share", 0.5), hourglass = options.number("hourglass", 0.1);
    options.check();
    const BirdShape shape{.mass = mass,
                          .density = density,
                          .form = form == "cylinder"    ? BirdForm::cylinder
                                  : form == "ellipsoid" ? BirdForm::ellipsoid
                                                        : BirdForm::hemispherical_ends,
                          .cells = mesh,
                          .layers = layers};
    Record record{shape, speed};
    const double edge = record.size.diameter / (4 * mesh);
    const Erosion erosion{.volume = 0.1, .step = 0.02 * edge / std::sqrt(water.C1 / density)};
    const auto of_particles = [&](const auto& material) {
      const Mesh quarter = particles(shape, across);
      const double spacing = std::cbrt(quarter.particles.volumes[0]);
      const Particle particle{Smoothing{}, Mirrors{Mirror{unit(Axis::x)}, Mirror{unit(Axis::y)}}};
      record.gauge.plate = quarter.nodes[0].z();  // half a spacing below the lowest, as balls touch
      strike_plate(Part{particle, material, quarter.particles}, quarter, 4 * spacing, record);
    };
    const auto of = [&](const auto& material) {
      if (cells == "particles") return of_particles(material);
      const Mesh hexahedra = bird(shape);
      if (cells == "hexahedra")
        return strike_plate(Part{Hex8{ViscousHourglass{hourglass}}, material, hexahedra.hexahedra, erosion}, hexahedra,
                            edge, record);
      const Mesh tetrahedra = tetrahedralized(hexahedra);
      strike_plate(Part{Tet4{NodalPressure{share}}, material, tetrahedra.tetrahedra, erosion}, tetrahedra, edge,
                   record);
    };
    if (strength == "low") of(low_strength);
    if (strength == "high") of(high_strength);
    if (strength == "none" && cells == "particles")
      of_particles(Fluid{water});
    else if (strength == "none")
      of(no_strength);
    report(record, cells + ", " + form + ", " + strength + " strength");
  });
}
