// Particles in contact: balls of half their spacing.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/section.hpp>

#include "support/catch.hpp"
#include "support/frame.hpp"

using namespace strike;

namespace {

constexpr double thickness = 0.5;
const Fluid water{CubicEos{.density = 1e-6, .C1 = 2.2, .C2 = 6, .C3 = 10, .pressure_cutoff = 0}};
const Homogeneous section{PlaneStress{Elastic{2.7e-6, 70, 0.3}}, thickness};

/// A ball of water over the middle of a plate, that much above touching it, and what belongs to it.
struct Struck {
  testing::Frame frame;
  double gap = 0.1;
  Mesh mesh = sheet({6, 6}, [](double s, double t) { return Eigen::Vector3d(12 * s, 12 * t, 0); });
  std::vector<Index> ball = {}, edge = nodes_where(mesh.nodes, [](const Eigen::Vector3d& x) {
                                  return std::min({x.x(), x.y(), 12 - x.x(), 12 - x.y()}) < 1e-9;
                                });
  double spacing = 0;

  explicit Struck(const testing::Frame& of = {}) : frame(of) {
    Mesh drop = particles(SphereShape{.radius = 2.5}, 6);
    spacing = std::cbrt(drop.particles.volumes[0]);
    double lowest = 0;
    for (const auto& x : drop.nodes) lowest = std::min(lowest, x.z());
    drop = translated(std::move(drop), {6.1, 5.8, 0.5 * (thickness + spacing) - lowest + gap});
    const Index first = append(mesh, drop);
    for (Index i = first; i < mesh.nodes.size(); ++i) ball.push_back(i);
    for (auto& x : mesh.nodes) x = frame(x);
  }
  template <class C>
  auto run_with(const C& contact) const {
    Explicit run{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals},
                       Part{Particle{}, water, mesh.particles},
                       InitialVelocity{frame.turn * Eigen::Vector3d(0, 0, -100), ball}, Clamped{edge}, contact}};
    run.until(0.03);
    return run;
  }
};

}  // namespace

TEST_CASE("contact: particles touch at half their spacing, by Everything as by a pairing, at any angle",
          "[particles]") {
  const Struck struck;
  const auto by_hand = struck.run_with(
      Contact{NodeToSurface{struck.ball, plate_surface(struck.mesh.quadrilaterals, thickness, 0), struck.spacing}});
  CHECK(std::abs(by_hand.energy().error()) < 5e-3);
  Eigen::Vector3d impulse = by_hand.contact<0>().impulse();
  CHECK(impulse.norm() > 0.5 * 100 * 1e-6 * 65);
  // None comes nearer to the plate's middle than half of both, but for what a step lets pass.
  const auto x = by_hand.positions();
  double nearest = 1e9;
  for (const Index i : struck.ball)
    for (const auto& cell : struck.mesh.quadrilaterals) {
      const Eigen::Vector3d away = x[i] - centroid<4>(x, cell), normal = area_vector(x, Face{cell, 0}).normalized();
      if ((away - away.dot(normal) * normal).norm() < 1) nearest = std::min(nearest, away.dot(normal));
    }
  CHECK(nearest > 0.45 * (thickness + struck.spacing));

  const auto everything = struck.run_with(Contact{Everything{}});
  testing::Frame frame;
  frame.turn = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 0.3, -0.5).normalized()).toRotationMatrix();
  frame.shift = {3, -20, 11};
  const auto turned = Struck(frame).run_with(Contact{Everything{}});
  double off = 0, turned_off = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    off = std::max(off, (everything.positions()[i] - x[i]).norm());
    turned_off = std::max(turned_off, (frame.back(turned.positions()[i]) - x[i]).norm());
  }
  CHECK(off < 1e-12);
  CHECK(turned_off < 1e-9);
}

TEST_CASE("contact: particles that cannot meet, or be excepted, are told", "[particles]") {
  const Mesh two = particles(BoxShape{.size = {4, 2, 2}, .cells = {4, 2, 2}});
  Particles left, right;
  for (std::size_t i = 0; i < two.particles.size(); ++i) {
    Particles& half = two.nodes[i].x() < 2 ? left : right;
    half.cells.push_back(two.particles[i]), half.volumes.push_back(1);
  }
  Explicit run{Scene{two.nodes, Part{Particle{}, water, left}, Part{Particle{}, water, right}}};
  REQUIRE(run.warnings().size() == 1);
  CHECK(run.warnings()[0] ==
        "Particles of different parts do not touch each other; those that shall meet belong in one part.");
  const Struck struck;
  CHECK_THROWS_WITH(struck.run_with(Contact{Everything{.except = {{{0, 1}}}}}),
                    Catch::Matchers::Contains("Everything excepts part 1, which is of particles"));
}
