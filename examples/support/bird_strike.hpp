#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "options.hpp"
#include "processes.hpp"

// A bird that strikes a transparency, for the examples canopy and windshield. Inches, seconds, pounds of force;
// so psi and in-lbf.
namespace examples {

inline constexpr double psi_per_GPa = 145037.738, per_kg_m3 = 1 / 1.0686896e7;  // lbf s^2/in^4
inline constexpr double knot = 20.253718;                                       // in/s

/// A right cylinder of 4 lb, twice as long as wide, of water by its shock velocity c + 2 u at the density of gelatine
/// (950 kg/m^3). The stiffness and the strength in shear are assumptions: Poisson's ratio 0.4995 and 20 kPa.
struct Bird {
  static constexpr double mass = 1.0360317e-2, density = 950 * per_kg_m3;
  static constexpr strike::CubicEos water{
      .density = 950 * per_kg_m3, .C1 = 2.06 * psi_per_GPa, .C2 = 6.19 * psi_per_GPa, .C3 = 10.3 * psi_per_GPa};
  static constexpr strike::VonMises flesh{.shear_modulus = 2.06e-3 * psi_per_GPa, .yield_stress = 2e-5 * psi_per_GPa};

  /// Flows, and takes no tension.
  static auto tensionless() {
    strike::CubicEos eos = water;
    eos.pressure_cutoff = 0;
    return strike::Fluid{eos};
  }
  /// Fails as soon as it yields; the nodes of its deleted elements strike one by one.
  static auto low_strength() { return strike::Solid{water, flesh, strike::UltimateStress{0.999 * flesh.yield_stress}}; }
  /// Becomes a fluid as soon as it yields: what low strength means for particles, which do not lose their pressure.
  static auto low_strength_flowing() {
    return strike::Solid{water, flesh, strike::BecomesFluid{strike::UltimateStress{0.999 * flesh.yield_stress}}};
  }
  /// Flows up to a plastic strain of 5.
  static auto high_strength() { return strike::Solid{water, flesh, strike::FailureStrain{5}}; }

  static constexpr strike::BirdShape shape{
      .mass = mass, .density = density, .cells = 1, .layers = 14, .sector = strike::Sector::full};
  /// Its 1008 tetrahedra, upright on z = 0.
  static strike::Mesh tetrahedra() { return strike::tetrahedralized(strike::bird(shape)); }
  /// As many particles across its diameter: 832 of 8.
  static strike::Mesh particles(strike::Index across) { return strike::particles(shape, across); }
  /// With the axis along x and the middle of its face at a place.
  static strike::Mesh placed(const strike::Mesh& upright, const Eigen::Vector3d& face) {
    return strike::translated(strike::rotated(upright, {0, 1, 0}, -std::numbers::pi / 2), face);
  }
};

/// The part of a bird in tetrahedra, whose nodes strike, and of one in particles, balls of half their spacing.
template <class Material>
auto part_of_tetrahedra(const Material& flesh, const strike::Mesh& mesh) {
  return strike::Part{strike::Tet4{}, flesh, mesh.tetrahedra, strike::Erosion{.step = 2e-7}};
}
template <class Material>
auto part_of_particles(const Material& flesh, const strike::Mesh& mesh) {
  return strike::Part{strike::Particle{}, flesh, mesh.particles};
}

/// "low-strength bird" or "bird in particles".
inline std::string name_of(const std::string& bird) {
  return bird == "particles" ? "bird in particles" : bird + "-strength bird";
}

/// The target: plates, their clamped nodes, their thickness, and nodes whose motion is recorded.
struct Transparency {
  strike::Mesh mesh;
  std::vector<strike::Index> edge;
  double thickness;
  std::vector<std::pair<std::string, strike::Index>> watched;
};

/// The mesh of both and what belongs to the bird, which flies along x and has come as close as a clearance allows.
struct Encounter {
  strike::Mesh mesh;
  std::vector<strike::Index> bird;
  double spacing = 0;  ///< of particles

  Encounter(const Transparency& target, strike::Mesh body) : mesh(target.mesh) {
    if (!body.particles.empty()) spacing = std::cbrt(body.particles.volumes[0]);
    // Along x only the faces in front of a node matter: those whose shadow in the y, z plane holds it.
    double way = std::numeric_limits<double>::infinity();
    for (const auto& cell : target.mesh.quadrilaterals)
      for (const Eigen::Vector3d& x : body.nodes) way = std::min(way, way_to(target, cell, x));
    body = strike::translated(std::move(body), {way - 0.05 * target.thickness, 0, 0});
    const strike::Index first = strike::append(mesh, body);
    for (strike::Index i = 0; i < body.nodes.size(); ++i) bird.push_back(first + i);
  }

 private:
  /// Distance along x from a point to a triangle of the cell, less half a thickness and a radius.
  double way_to(const Transparency& target, const std::array<strike::Index, 4>& cell, const Eigen::Vector3d& x) const {
    double way = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      const auto corner = [&](int i) -> const Eigen::Vector3d& {
        return target.mesh.nodes[cell[static_cast<unsigned>(i)]];
      };
      const Eigen::Vector3d p = corner(a), u = corner(b) - p, v = corner(c) - p,
                            n = strike::cross<double>(u, v).normalized();
      if (std::abs(n.x()) < 1e-9) continue;
      const double t = n.dot(p - x) / n.x();
      const Eigen::Vector3d q = x + t * Eigen::Vector3d::UnitX() - p;
      const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), qu = q.dot(u), qv = q.dot(v), det = uu * vv - uv * uv;
      const double r = (vv * qu - uv * qv) / det, s = (uu * qv - uv * qu) / det;
      if (r < -0.1 || s < -0.1 || r + s > 1.1) continue;
      way = std::min(way, t - 0.5 * (target.thickness + spacing) / std::abs(n.x()));
    }
    return way;
  }
};

/// Records of a strike.
struct Flight {
  std::vector<double> times;                       ///< [ms]
  std::vector<std::vector<double>> displacements;  ///< of the watched nodes, by node and time [in]
  std::vector<double> peaks;                       ///< their largest [in]
  struct LayerState {
    double strain, failed;  ///< largest equivalent plastic strain; share of its points that have failed
  };
  std::vector<LayerState> layers;  ///< at the end
  double energy_error = 0, impulse = 0, impulse_error = 0, deepest = 0, seconds = 0;
  std::size_t steps = 0, passed = 0;
  std::vector<std::string> warnings;
};

/// Checks of every strike.
inline void add_checks(strike::Results& results, const Flight& flight, const std::string& of = {}) {
  results.add({of + "energy error", flight.energy_error, "1", 0, 0.02, "balance"});
  results.add({of + "impulse on the bird against its momentum", flight.impulse_error, "1", 0, 1e-9, "balance"});
  results.add({of + "nodes of the bird that passed", static_cast<double>(flight.passed), "1", 0, 0, "contact"});
  results.add({of + "steps", static_cast<double>(flight.steps), "1"});
}

/// Number of nodes behind the plate whose middle is nearest to them and within its edges.
inline std::size_t passed(const strike::Mesh& plates, const std::vector<Eigen::Vector3d>& x,
                          const std::vector<strike::Index>& nodes) {
  std::size_t behind = 0;
  for (const strike::Index i : nodes) {
    double nearest = std::numeric_limits<double>::infinity(), height = 0, size = 0;
    for (const auto& cell : plates.quadrilaterals) {
      const Eigen::Vector3d away = x[i] - strike::centroid<4>(x, cell);
      if (away.squaredNorm() >= nearest) continue;
      nearest = away.squaredNorm();
      const Eigen::Vector3d area = strike::area_vector(x, strike::Face{cell, 0});
      height = away.dot(area.normalized()), size = std::sqrt(area.norm());
    }
    behind += height < 0 && nearest < size * size;
  }
  return behind;
}

/// Runs until `end` [s] with the bird of a mesh, of which `part_of` makes the part; writes `name`.csv, `name`.pvd and a
/// picture at each of the times `seen` [ms].
template <class Section, class PartOf>
Flight strike_at(const Transparency& target, const Section& section, const strike::Mesh& upright, const PartOf& part_of,
                 double speed, double end, const std::string& name, const std::string& title,
                 const std::vector<double>& seen) {
  using namespace strike;
  const Encounter both(target, Bird::placed(upright, target.mesh.nodes[target.watched.front().second]));
  const Mesh& mesh = both.mesh;
  const double h = target.thickness;

  Explicit run{Scene{mesh.nodes,                                    //
                     Part{Plate4{}, section, mesh.quadrilaterals},  //
                     part_of(mesh), InitialVelocity{{speed, 0, 0}, both.bird}, Clamped{target.edge},
                     Contact{NodeToSurface{both.bird, plate_surface(mesh.quadrilaterals, h, 0), both.spacing}}},
               Processes{}};
  const auto& panel = run.template part<0>();
  const auto& bird = run.template item<1>();
  const auto& contact = run.template item<4>();

  Flight flight;
  flight.displacements.resize(target.watched.size()), flight.peaks.resize(target.watched.size());
  std::vector<Column> columns{{"time", "ms"}};
  for (const auto& [place, node] : target.watched) columns.push_back({"displacement, " + place, "in"});
  for (const char* energy : {"kinetic energy", "internal energy", "contact energy", "eroded energy"})
    columns.push_back({energy, "in lbf"});
  columns.push_back({"force on the bird", "lbf"});
  History history{name + ".csv", columns};
  VtuSeries film{name};
  Progress progress{{.end = end, .unit = "s"}};

  const auto moved = [&](Index node) { return (run.nodes().x(node) - mesh.nodes[node]).norm(); };
  const auto momentum = [&] {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Index i : both.bird) p += run.nodes().mass(i) * run.nodes().v(i);
    return p;
  };
  const Eigen::Vector3d before = momentum();
  const auto sample = [&] {
    flight.times.push_back(1e3 * run.time());
    std::vector<double> row{flight.times.back()};
    for (std::size_t k = 0; k < target.watched.size(); ++k)
      row.push_back(flight.displacements[k].emplace_back(moved(target.watched[k].second)));
    const Energy& e = run.energy();
    row.insert(row.end(), {e.kinetic, e.internal, e.contact, e.eroded, contact.force().norm()});
    history.row(row);
  };
  const auto what_is_left = [&] {
    Mesh left = mesh;
    if (!mesh.tetrahedra.empty()) left.tetrahedra = remaining(mesh.tetrahedra, bird.alive());
    return left;
  };
  const auto draw = [&](double time) {
    Picture picture{{.title = title + " at " + examples::text(time) + " ms",
                     .quantity = "plastic strain, mean over the thickness",
                     .from = {-1.2, -2, 0.9},
                     .length_unit = "in"}};
    const std::vector<Eigen::Vector3d> x = run.positions();
    picture.add(quadrilateral_surface(mesh.quadrilaterals), x, panel.field(PlasticStrain{}), Sides::both);
    const Mesh left = what_is_left();
    if (!left.tetrahedra.empty()) picture.add(tetrahedron_surface(left.tetrahedra), x);
    picture.add(left.particles, x);
    std::vector<Eigen::Vector3d> debris;  // nodes of what has been deleted
    for (const Index i : orphan_nodes(left)) debris.push_back(x[i]);
    picture.add_particles(debris);
    picture.write(name + "_" + examples::text(time) + "ms.svg");
  };
  std::size_t drawn = 0;
  const std::clock_t begin = std::clock();
  run.until(
      end,
      [&] {
        for (std::size_t k = 0; k < target.watched.size(); ++k)
          flight.peaks[k] = std::max(flight.peaks[k], moved(target.watched[k].second));
        flight.energy_error = std::max(flight.energy_error, std::abs(run.energy().error()));
        flight.deepest = std::max(flight.deepest, contact.penetration());
        progress(run);
        if (drawn < seen.size() && 1e3 * run.time() >= seen[drawn]) draw(seen[drawn++]);
      },
      Every{end / 400, sample},
      Every{end / 40, [&] {
              flight.passed += passed(target.mesh, run.positions(), both.bird);
              const std::vector<bool> alive = bird.alive();
              std::vector<Field> fields;
              const auto add = [&](const std::string& quantity, const std::vector<double>& of_bird,
                                   const std::vector<double>& of_plates) {
                std::vector<double> values = remaining(of_bird, alive);
                const bool first = mesh.particles.empty();  // tetrahedra stand before quadrilaterals, particles behind
                values.insert(first ? values.end() : values.begin(), of_plates.begin(), of_plates.end());
                fields.push_back({quantity, values});
              };
              add("plastic strain", bird.field(PlasticStrain{}), panel.field(PlasticStrain{}));
              const std::vector<double> none(bird.size());
              for (std::size_t k = 0; k < section.layers() && section.layers() > 1; ++k) {
                add("plastic strain, layer " + std::to_string(k), none, panel.field(k, PlasticStrain{}));
                add("failed, layer " + std::to_string(k), none, panel.field(k, Failed{}));
              }
              film.write(run.time(), what_is_left(), run.positions(), {}, fields);
            }});
  flight.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  print_imbalance(run);
  flight.steps = run.steps(), flight.warnings = run.warnings();
  flight.impulse = contact.impulse().norm();
  flight.impulse_error = (momentum() - before - contact.impulse()).norm() / before.norm();
  for (std::size_t k = 0; k < section.layers(); ++k) {
    const std::vector<double> strains = panel.field(k, PlasticStrain{}), fails = panel.field(k, Failed{});
    flight.layers.push_back({*std::max_element(strains.begin(), strains.end()),
                             std::accumulate(fails.begin(), fails.end(), 0.0) / static_cast<double>(fails.size())});
  }
  return flight;
}

}  // namespace examples
