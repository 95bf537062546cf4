// An aluminium panel, a third of a cylinder, on which a sheet of explosive gives a part of the crown 143.5 m/s inward.
//
//   bash examples/run explosive_panel
//   bash examples/run explosive_panel mesh=32 rule=gauss5
//   bash examples/run explosive_panel layers=4 rule=simpson3
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

// Inches, seconds, pounds of force; so psi and in-lbf.
constexpr double radius = 2.9375, length = 12.56, thickness = 0.125, arc = std::numbers::pi / 3;
constexpr double speed = 5650, loaded_arc = std::numbers::pi / 6, loaded_length = 26.0 / 32 * length;
constexpr double youngs_modulus = 1.05e7, poissons_ratio = 0.33, end = 1e-3;

const PlaneStress aluminium{
    Solid{LinearEos{.density = 2.49943e-4, .bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio))},
          VonMises{.shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio)), .yield_stress = 44000}}};

double angle_of(const Eigen::Vector3d& x) { return std::atan2(x.x(), x.z()); }

/// Radially inward under the explosive, half of that on its edge.
Eigen::Vector3d blast(const Eigen::Vector3d& x) {
  const auto share = [](double distance, double edge) {
    return std::abs(distance - edge) < 1e-6 * edge ? 0.5 : distance < edge ? 1.0 : 0.0;
  };
  const double angle = angle_of(x);
  const double v = speed * share(angle, loaded_arc) * share(std::abs(x.y() - length / 2), loaded_length / 2);
  return {-v * std::sin(angle), 0, -v * std::cos(angle)};
}

/// Records of a run.
struct Record {
  const Mesh& panel;
  History history{"history.csv",
                  {{"time", "ms"},
                   {"displacement of the crown at the middle", "in"},
                   {"displacement of the crown at three quarters", "in"},
                   {"kinetic energy", "in lbf"},
                   {"internal energy", "in lbf"},
                   {"hourglass energy", "in lbf"},
                   {"energy error", "1"}}};
  VtuSeries film{"panel"};
  Progress progress{{.end = end, .unit = "s"}};

  struct Point {
    Index node;
    double peak = 0, peak_time = 0;
    std::vector<double> displacement{};
  };
  std::array<Point, 2> points{{{nearest(panel, length / 2)}, {nearest(panel, 0.75 * length)}}};
  std::vector<double> times{};
  double drift = 0, seconds = 0, initial = 0;
  std::size_t steps = 0;
  Energy energy{};
  std::vector<Eigen::Vector3d> positions{};
  std::vector<double> plastic_strain{};
  std::vector<std::string> warnings{};

  static Index nearest(const Mesh& panel, double y) {
    const auto distance = [&](const Eigen::Vector3d& x) { return (x - Eigen::Vector3d(0, y, radius)).norm(); };
    const auto node = std::min_element(panel.nodes.begin(), panel.nodes.end(),
                                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    return static_cast<Index>(node - panel.nodes.begin());
  }

  template <class Run>
  void watch(const Run& run) {
    for (Point& point : points)
      if (const double u = radius - run.nodes().x(point.node).z(); u > point.peak)
        point.peak = u, point.peak_time = run.time();
    drift = std::max(drift, std::abs(run.energy().error()));
    progress(run);
  }
  template <class Run>
  void sample(const Run& run) {
    times.push_back(1000 * run.time());
    for (Point& point : points) point.displacement.push_back(radius - run.nodes().x(point.node).z());
    const Energy& e = run.energy();
    history.row(1000 * run.time(), points[0].displacement.back(), points[1].displacement.back(), 2 * e.kinetic,
                2 * e.internal, 2 * e.hourglass, e.error());
  }
};

template <class Section>
void blow(const Section& section, Record& record) {
  // Half of the panel. Its straight sides are clamped, its curved ends pinned.
  const Mesh& panel = record.panel;
  const std::vector<Index> side = nodes_where(panel.nodes, [](const auto& x) { return angle_of(x) > arc - 1e-6; });
  Explicit run{Scene{panel.nodes,                                                        //
                     Part{Plate4{}, section, panel.quadrilaterals},                      //
                     InitialVelocityField{blast},                                        //
                     Symmetry{Axis::x, nodes_where(panel.nodes, on_plane(Axis::x, 0))},  //
                     Clamped{side},                                                      //
                     Pinned{nodes_where(panel.nodes, on_plane(Axis::y, 0))},             //
                     Pinned{nodes_where(panel.nodes, on_plane(Axis::y, length))}}};
  record.initial = run.energy().kinetic;
  record.warnings = run.warnings();
  const auto& part = run.template part<0>();
  const auto strain = [&](std::size_t layer) {
    return part.field(layer, [](const auto& point) { return point.equivalent_plastic_strain; });
  };

  const std::clock_t begin = std::clock();
  run.until(
      end,  //
      [&] { record.watch(run); }, Every{end / 200, [&] { record.sample(run); }},
      Every{end / 20, [&] {
              std::vector<Field> fields;
              for (std::size_t k = 0; k < section.layers(); ++k)
                fields.push_back({"plastic strain, layer " + std::to_string(k), strain(k)});
              record.film.write(run.time(), panel, run.positions(), {}, fields);
            }});
  record.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  record.positions = run.positions(), record.energy = run.energy(), record.steps = run.steps();
  record.plastic_strain = part.field([](const auto& point) { return point.equivalent_plastic_strain; });
}

/// Results of an independent program with the same element and mesh (docs/verification.md) [in].
struct Reference {
  unsigned mesh;
  const char* rule;
  double middle, three_quarters;
};
constexpr Reference references[] = {{16, "simpson3", 1.319, 0.926}, {16, "simpson5", 1.238, 0.839},
                                    {16, "gauss5", 1.251, 0.849},   {32, "simpson3", 1.382, 0.972},
                                    {32, "simpson5", 1.301, 0.890}, {32, "gauss5", 1.310, 0.897},
                                    {64, "gauss5", 1.323, 0.913}};

void report(const Record& record, unsigned mesh, const std::string& rule, unsigned layers, const std::string& what) {
  std::printf("\nExplosively loaded panel, %zu plates, %s\n\n", record.panel.quadrilaterals.size(), what.c_str());
  for (const std::string& warning : record.warnings) std::printf("%s\n", warning.c_str());
  const auto reference = std::find_if(std::begin(references), std::end(references), [&](const Reference& r) {
    return layers == 1 && r.mesh == mesh && r.rule == rule;
  });
  const bool known = reference != std::end(references);
  const double none = std::numeric_limits<double>::quiet_NaN();
  Results results;
  const auto add = [&](const std::string& name, const Record::Point& point, double expected) {
    results.add({"largest displacement, " + name, point.peak, "in", expected, 0.02 * expected,
                 known ? "same mesh and rule (docs/verification.md)" : ""});
    results.add({"its time, " + name, 1000 * point.peak_time, "ms"});
    results.add({"at the end, " + name, point.displacement.back(), "in"});
  };
  add("crown at the middle", record.points[0], known ? reference->middle : none);
  add("crown at three quarters", record.points[1], known ? reference->three_quarters : none);
  results.add({"energy error", record.drift, "1", 0, 2e-3, "balance"});
  results.add({"hourglass energy", record.energy.hourglass / record.initial, "1", 0, 0.01, "share of the initial"});
  results.add({"steps", static_cast<double>(record.steps), "1"});
  results.add({"CPU time", record.seconds, "s"});
  results.print();
  results.write("results.csv");

  Chart chart{{.title = "Crown of the explosively loaded panel",
               .x = {.label = "time", .unit = "ms"},
               .y = {.label = "inward displacement", .unit = "in"}}};
  chart.curve("at the middle", record.times, record.points[0].displacement);
  chart.curve("at three quarters", record.times, record.points[1].displacement);
  if (known)
    chart.points("same mesh and rule: peaks", {1000 * record.points[0].peak_time, 1000 * record.points[1].peak_time},
                 {reference->middle, reference->three_quarters});
  chart.write("displacement.svg");
  Picture picture{{.title = "Explosively loaded panel at 1 ms",
                   .quantity = "plastic strain, mean over the thickness",
                   .from = {1.5, -2, 1.5},
                   .mirror = {Axis::x},
                   .length_unit = "in"}};
  picture.add(surface(record.panel), record.positions, record.plastic_strain);
  picture.write("panel.svg");
  std::printf("\nWritten: results.csv, history.csv, displacement.svg, panel.svg, panel.pvd (ParaView)\n");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const unsigned mesh = options.count("mesh", 16), layers = options.count("layers", 1);
    const std::string rule = options.choice("rule", {"simpson3", "simpson5", "gauss5"});
    options.check();
    const Mesh panel = strike::panel({.radius = radius, .length = length, .arc = {0, arc}, .cells = {mesh, 2 * mesh}});
    Record record{panel};

    const auto of = [&](const auto& points) {
      if (layers == 1)
        blow(Homogeneous{aluminium, thickness, points}, record);
      else
        blow(Layered{Plies{Layer{aluminium, thickness / layers, points}, layers}}, record);
    };
    if (rule == "simpson3") of(Simpson<3>{});
    if (rule == "simpson5") of(Simpson<5>{});
    if (rule == "gauss5") of(Gauss<5>{});
    report(record, mesh, rule, layers, layers == 1 ? rule : rule + " in each of " + std::to_string(layers) + " layers");
  });
}
