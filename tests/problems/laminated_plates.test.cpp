// Laminated strips and plates of Plate4 against plates with shear deformation and against elasticity (REFERENCES of the
// section alone are in tests/section/transverse_shear.test.cpp).
#include <cmath>
#include <numbers>

#include <strike/section.hpp>

#include "problems/shells.hpp"
#include "support/catch.hpp"
#include "support/lay_ups.hpp"

using namespace strike;
using strike::testing::Sandwich;

namespace {

constexpr Index cells = 12;  // along half of a strip

/// Half of a strip in plane strain between simple supports, of one row of nearly square elements.
struct Strip {
  double p;
  Mesh mesh;

  explicit Strip(const Sandwich& sandwich)
      : p(sandwich.p()),
        mesh(rectangle({.size = {sandwich.length / 2, sandwich.length / 2 / cells}, .cells = {cells, 1}})) {}

  double width() const { return mesh.nodes.back().y(); }
  /// x = 0 is on a support, the other end in the middle.
  shells::Supports supports() const {
    return {{Support{shells::on(mesh, Axis::x, 0), {unit(Axis::z)}, {unit(Axis::x)}},
             Symmetry{Axis::x, shells::on(mesh, Axis::x, mesh.nodes.back().x())},
             Symmetry{Axis::y, shells::on(mesh, Axis::y, 0)}, Symmetry{Axis::y, shells::on(mesh, Axis::y, width())}}};
  }
  Index middle() const { return static_cast<Index>(mesh.nodes.size() - 1); }
};

Sandwich with_mass(Sandwich sandwich) {
  if (!(sandwich.face_density > 0)) sandwich.face_density = sandwich.core_density = 1000e-12;  // mm, t
  return sandwich;
}

/// What the middle sinks by under the pressure sin px, per pressure.
template <class... Options>
double deflection(const Sandwich& sandwich, double softness, const Options&... options) {
  const Strip strip(sandwich);
  const double thick = sandwich.thickness[0] + sandwich.thickness[1] + sandwich.thickness[2];
  const double q = 1e-6 * thick / sandwich.laminate(softness).deflection(strip.p);
  shells::Forces load;
  const double area = 0.5 * strip.width() * strip.mesh.nodes[1].x();  // of a node inside, on one edge
  for (Index i = 0; i < strip.mesh.nodes.size(); ++i)
    load.forces.emplace_back(i, Eigen::Vector3d(0, 0, q * area * std::sin(strip.p * strip.mesh.nodes[i].x())));
  for (auto& [i, f] : load.forces)
    if (strip.mesh.nodes[i].x() > strip.mesh.nodes.back().x() * (1 - 1e-9)) f *= 0.5;
  return shells::settle(strip.mesh, Plate4{}, sandwich.section(softness, options...), load, strip.supports(),
                        strip.middle(), {0, 0, 1})
             .displacement /
         q;
}

/// Begins in the mode of a plate with the shear stiffness K: rotations follow the slope but for the shear.
struct Mode {
  double p, share, speed;

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double x = nodes.x(i).x();
      nodes.set_velocity(i, {0, 0, speed * std::sin(p * x)});
      nodes.set_angular_velocity(i, {0, -share * speed * p * std::cos(p * x), 0});
    }
  }
};

/// The lowest natural frequency, from the time of half a period [Hz].
template <class... Options>
double frequency(const Sandwich& sandwich, double softness, const Options&... options) {
  const Strip strip(sandwich);
  const auto section = sandwich.section(softness, options...);
  const double K = section.shear_stiffness(), D = section.transverse_shear().bending;
  Explicit run{Scene{strip.mesh.nodes, Part{Plate4{}, section, strip.mesh.quadrilaterals},
                     Mode{strip.p, K / (K + D * strip.p * strip.p), 1e-3}, strip.supports()}};
  double before = 0, now = 0;
  do {
    run.step();
    before = now, now = run.nodes().x(strip.middle()).z();
  } while (run.steps() < 3 || now > 0);
  return 0.5 / (run.time() - run.dt() * now / (now - before));
}

}  // namespace

// One row of one-point elements bends too easily by (p h)^2/12 of 0.14 %; K is that of the section to rounding.
TEST_CASE("laminated strips deflect as plates with their shear stiffness, and with K_eff as elasticity") {
  for (const auto& row : testing::sandwiches) {
    const Sandwich sandwich = with_mass(row.strip);
    CAPTURE(row.strip.name, row.softness);
    const double exact = row.deflection;
    CHECK(deflection(sandwich, row.softness) == Approx(row.fsdt * exact).epsilon(0.01));
    if (row.softness <= 1e5)
      CHECK(deflection(sandwich, row.softness, EffectiveShear{sandwich.length}) == Approx(exact).epsilon(0.01));
  }
}

// Exact frequencies and those of a plate with K by an independent code.
TEST_CASE(
    "laminated strips swing at the frequency of plates with their shear stiffness, and with K_eff of elasticity") {
  struct Row {
    const Sandwich& strip;
    double softness, exact, fsdt;
  };
  for (const auto& [strip, softness, exact, fsdt] :
       {Row{testing::glass, 1, 190.8552, 1.000}, Row{testing::glass, 1e2, 187.8205, 0.9999},
        Row{testing::glass, 1e3, 167.6537, 0.9925}, Row{testing::glass, 1e4, 112.3316, 0.8346},
        Row{testing::glass, 1e5, 84.5152, 0.397}, Row{testing::thick, 1, 7931.00, 0.9993},
        Row{testing::thick, 1e2, 5211.81, 0.968}, Row{testing::thick, 1e3, 2874.59, 0.700},
        Row{testing::thick, 1e4, 2272.51, 0.289}}) {
    CAPTURE(strip.name, softness);
    CHECK(frequency(strip, softness) == Approx(fsdt * exact).epsilon(0.01));
    CHECK(frequency(strip, softness, EffectiveShear{strip.length}) == Approx(exact).epsilon(0.01));
  }
}

/// A quarter of a plate of 300 x 300 mm on hard simple supports, 16 x 16 elements on the whole: how far its middle
/// sinks under a uniform pressure of 1 MPa, were it small.
template <class Section>
double square_plate(const Section& section) {
  constexpr double half = 150, q = 1e-6;
  const Mesh plate = rectangle({.size = {half, half}, .cells = {8, 8}});
  return shells::settle(
             plate, Plate4{}, section, shells::spread(plate, {0, 0, q}),
             {{Symmetry{Axis::x, shells::on(plate, Axis::x, 0)}, Symmetry{Axis::y, shells::on(plate, Axis::y, 0)},
               Support{shells::on(plate, Axis::x, half), {unit(Axis::z)}, {unit(Axis::x)}},
               Support{shells::on(plate, Axis::y, half), {unit(Axis::z)}, {unit(Axis::y)}}}},
             0, {0, 0, 1})
             .displacement /
         q;
}

// FSDT(K) by an independent code.
TEST_CASE("square laminated plates sink under pressure as plates with their shear stiffness") {
  CHECK(square_plate(testing::glass.section(1e2)) == Approx(18.4385).epsilon(0.01));
  CHECK(square_plate(testing::glass.section(1e3)) == Approx(27.4830).epsilon(0.01));
  CHECK(square_plate(testing::glass.section(1e4)) == Approx(117.925).epsilon(0.01));
  const PlaneStress polycarbonate{Elastic{.density = 1200e-12, .youngs_modulus = 2400, .poissons_ratio = 0.38}};
  CHECK(square_plate(Homogeneous{polycarbonate, 12.7}) == Approx(69.4419).epsilon(0.01));
}

TEST_CASE("a run tells where layers slide over four elements") {
  const auto warnings = [](double softness) {
    const Strip strip(testing::glass);
    return Explicit{
        Scene{strip.mesh.nodes, Part{Plate4{}, testing::glass.section(softness), strip.mesh.quadrilaterals}}}
        .warnings();
  };
  CHECK(warnings(1).empty());
  const auto told = warnings(1e4);
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("slide") != std::string::npos);
}
