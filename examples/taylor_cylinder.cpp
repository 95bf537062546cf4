// Taylor's copper cylinder: 3.2 mm x 32.4 mm strikes a rigid wall at 227 m/s and comes to rest in 80 microseconds.
//
//   bash examples/run taylor_cylinder
//   bash examples/run taylor_cylinder cells=6 layers=100
//   bash examples/run taylor_cylinder scalar=float hourglass=0.05
//   bash examples/run taylor_cylinder wall=unilateral
//   bash examples/run taylor_cylinder ranks=2                           (on two processes, with the same bits)
//   bash examples/run taylor_cylinder checkpoint=2 restart=if_there     (after whatever has ended it, it goes on)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"
#include "support/processes.hpp"

using namespace strike;

namespace {

// Millimetres, milliseconds, kilograms; so kN, GPa and J.
constexpr double radius = 3.2, length = 32.4, speed = 227, end = 0.08;
constexpr double youngs_modulus = 117, poissons_ratio = 0.35;

const Solid copper{
    LinearEos{.density = 8.93e-6, .bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio))},
    VonMises{
        .shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio)), .yield_stress = 0.4, .hardening_modulus = 0.1}};

struct Study {
  Mesh bar;
  double step_factor;
  bool unilateral;
  CheckpointOptions checkpoint;
};

double length_of(const std::vector<Eigen::Vector3d>& positions) {
  double top = 0;
  for (const auto& x : positions) top = std::max(top, x.z());
  return top;
}
double radius_of(const std::vector<Eigen::Vector3d>& positions) {
  double r = 0;
  for (const auto& x : positions) r = std::max(r, std::hypot(x.x(), x.y()));
  return r;
}

/// What is left of a run: a history, a film, and the figures of the report.
struct Record {
  const Mesh& bar;
  History history{"history.csv",
                  {{"time", "ms"},
                   {"length", "mm"},
                   {"radius", "mm"},
                   {"kinetic energy", "J"},
                   {"internal energy", "J"},
                   {"hourglass energy", "J"},
                   {"bulk viscosity", "J"},
                   {"contact", "J"},
                   {"energy error", "1"}}};
  VtuSeries film{"bar"};
  Progress progress{{.end = end, .unit = "ms"}};
  std::vector<double> times{}, lengths{};
  double drift = 0;

  std::vector<Eigen::Vector3d> positions{};
  std::vector<double> plastic_strain{};
  Energy energy{};
  double seconds = 0;
  std::size_t steps = 0;

  void sample(double time, const std::vector<Eigen::Vector3d>& x, const Energy& e) {
    times.push_back(1000 * time), lengths.push_back(length_of(x));
    history.row(time, length_of(x), radius_of(x), 4 * e.kinetic, 4 * e.internal, 4 * e.hourglass, 4 * e.bulk_viscosity,
                4 * e.contact, e.error());
  }
  void frame(double time, const std::vector<Eigen::Vector3d>& x, const std::vector<double>& strain) {
    film.write(time, bar, x, {}, {{"equivalent plastic strain", strain}});
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(history, film, times, lengths, drift);
  }
  void watch(double time, std::size_t step, double dt, double error) {
    drift = std::max(drift, std::abs(error));
    progress.update(time, step, dt, error);
  }
};

template <class Element, class T>
void strike_wall(const Element& element, In<T> number, const Study& study, Record& record) {
  // A quarter of the bar. The foot slides on the wall; `wall=unilateral` also lets it leave.
  const Mesh& bar = study.bar;
  const std::vector<Index> foot = nodes_where(bar.nodes, on_plane(Axis::z, 0)), nobody;
  Explicit run{Scene{bar.nodes,                                                        //
                     Part{element, copper, bar.hexahedra},                             //
                     InitialVelocity{{0, 0, -speed}},                                  //
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},  //
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))},  //
                     Symmetry{Axis::z, study.unilateral ? nobody : foot},              //
                     RigidWall{{0, 0, 0}, {0, 0, 1}, study.unilateral ? all_nodes(bar.nodes) : nobody}},
               ExplicitOptions{.step_factor = study.step_factor}, number, examples::Processes{}};
  const auto plastic_strain = [&] {
    return run.template part<0>().field([](const auto& state) { return state.equivalent_plastic_strain; });
  };

  const std::clock_t begin = std::clock();
  run.until(
      end,  //
      Every{end / 160, [&] { record.sample(run.time(), run.positions(), run.energy()); }},
      Every{end / 16, [&] { record.frame(run.time(), run.positions(), plastic_strain()); }},
      [&] { record.watch(run.time(), run.steps(), run.dt(), run.energy().error()); },
      Checkpoint{"bar.checkpoint", study.checkpoint, record});
  record.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  examples::print_imbalance(run);
  record.positions = run.positions(), record.plastic_strain = plastic_strain(), record.energy = run.energy(),
  record.steps = run.steps();
}

/// The published table (Brockman and Held 1991), the limit of fine meshes (docs/verification.md), and this run.
void report(const Study& study, const Record& record, const std::string& what) {
  struct Row {
    const char* quantity;
    double ours;
    std::array<double, 5> others;
  };
  const Mesh& bar = study.bar;
  const double L = length_of(record.positions), R = radius_of(record.positions);
  const double strain = *std::max_element(record.plastic_strain.begin(), record.plastic_strain.end());
  const Energy& e = record.energy;
  std::printf("\nTaylor cylinder, %zu hexahedra, %s\n\n", bar.hexahedra.size(), what.c_str());
  std::printf("%-24s%9s%9s%9s%9s%11s%11s%11s%11s\n", "", "X3D", "DYNA2D", "DYNA3D", "NIKE2D", "converged", "this run",
              "to X3D", "to limit");
  for (const Row& row : {Row{"final length [mm]", L, {21.47, 21.47, 21.47, 21.47, 21.42}},
                         Row{"foot radius [mm]", R, {7.081, 7.127, 7.034, 7.068, 7.22}},
                         Row{"largest plastic strain", strain, {2.95, 3.05, 2.95, 2.97, 3.3}}}) {
    std::printf("%-24s", row.quantity);
    for (const double other : row.others) std::printf(&other == &row.others[4] ? "%11.2f" : "%9.3f", other);
    std::printf("%11.4f%+9.2f %%%+9.2f %%\n", row.ours, 100 * (row.ours / row.others[0] - 1),
                100 * (row.ours / row.others[4] - 1));
  }
  std::printf(
      "\n%zu steps (X3D: 8886), %.2f s of CPU with its output (X3D on a VAX 8650: 6 h 36 min), %.0f ns per element and "
      "step\n",
      record.steps, record.seconds, 1e9 * record.seconds / static_cast<double>(record.steps * bar.hexahedra.size()));
  std::printf("\nEnergies of the whole bar [J] and their share of the first [%%]\n");
  for (const auto& [name, energy] : {std::pair{"initial kinetic", e.initial},
                                     {"kinetic", e.kinetic},
                                     {"internal", e.internal},
                                     {"hourglass", e.hourglass},
                                     {"bulk viscosity", e.bulk_viscosity},
                                     {"contact", e.contact}})
    std::printf("  %-18s%10.4f%10.3f %%\n", name, 4 * energy, 100 * energy / e.initial);
  std::printf("  %-18s%10s%10.4f %%\n", "largest error", "", 100 * record.drift);

  Results results;
  const double wide = std::numeric_limits<double>::infinity();
  if (bar.hexahedra.size() == 1350) {
    const std::string source = "X3D and DYNA3D (Brockman and Held 1991)";
    results.add({"final length", L, "mm", 21.47, 0.08, source});
    results.add({"foot radius", R, "mm", 7.08, 0.08, source});
    results.add({"largest plastic strain", strain, "1", 2.92, 0.12, source});
  } else {
    const std::string source = "limit of fine meshes (docs/verification.md)";
    results.add({"final length", L, "mm", 21.42, wide, source});
    results.add({"foot radius", R, "mm", 7.22, wide, source});
    results.add({"largest plastic strain", strain, "1", 3.3, wide, source});
  }
  results.add({"energy error", record.drift, "1", 0, 1e-3, "balance"});
  results.add({"hourglass energy", e.hourglass / e.initial, "1", 0, 0.02, "share of the initial kinetic energy"});
  results.add({"steps", static_cast<double>(record.steps), "1", 8886, wide, "X3D (Brockman and Held 1991)"});
  results.add({"CPU time", record.seconds, "s"});
  results.write("results.csv");

  Chart chart{{.title = "Length of the Taylor bar",
               .x = {.label = "time", .unit = "us"},
               .y = {.label = "length", .unit = "mm"}}};
  chart.curve("strike", record.times, record.lengths);
  chart.points("X3D, DYNA, NIKE: final length", {80}, {21.47});
  chart.write("length.svg");
  Picture picture{{.title = "Taylor cylinder at 80 us",
                   .quantity = "equivalent plastic strain",
                   .mirror = {Axis::x, Axis::y},
                   .length_unit = "mm"}};
  picture.add(surface(bar), record.positions, record.plastic_strain);
  picture.write("bar.svg");
  std::printf("\nWritten: results.csv, history.csv, length.svg, bar.svg, bar.pvd (ParaView)\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [&](examples::Options& options) {
    const examples::Session session(count, arguments);
    const Index cells = options.count("cells", 3), layers = options.count("layers", 50);
    const std::string scalar = options.choice("scalar", {"double", "float"});
    const std::string wall = options.choice("wall", {"held", "unilateral"});
    const double Q = options.number("hourglass", 0.1), interval = options.number("checkpoint", 1000);  // [us]
    const std::string restart = options.choice("restart", {"never", "if_there"});
    const Study study{.bar = cylinder({.radius = radius, .length = length, .cells = cells, .layers = layers}),
                      .step_factor = options.number("step", 0.9),
                      .unilateral = wall == "unilateral",
                      .checkpoint = {.interval = 1e-3 * interval,
                                     .restart = restart == "never" ? Restart::never : Restart::if_there}};
    options.check();

    const Hex8 brick{ViscousHourglass{.coefficient = Q}};
    Record record{study.bar};
    if (scalar == "float")
      strike_wall(brick, in<Pack<float>>, study, record);
    else
      strike_wall(brick, in<Pack<double>>, study, record);
    report(study, record, detail::joined({scalar, ", hourglass ", detail::text(Q), ", wall ", wall}));
  });
}
