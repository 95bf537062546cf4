#pragma once
// The laws of contact as one suite:
//   TEST_CASE("conformance: my law") { testing::conforms_as_contact(MyLaw{}, Coulomb{0.3}); }
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/mesh/sheet.hpp>

#include "problems/balls.hpp"
#include "support/catch.hpp"

namespace strike::testing {

/// A bumpy sheet of 9 x 9 loose nodes and `shots` that fly at it from above, obliquely; masses between 1 and 100.
struct Shower {
  static constexpr Index side = 8, shots = 60;
  Mesh mesh;
  std::vector<Eigen::Vector3d> v;
  std::vector<double> mass;
  std::vector<Index> balls;

  explicit Shower(unsigned seed, double speed = 1, double height = 0.05) {
    std::mt19937 random(seed);
    const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    mesh = sheet({side, side}, [&](double s, double t) { return Eigen::Vector3d(s, t, 0.02 * number()); });
    v.assign(mesh.nodes.size(), Eigen::Vector3d::Zero());
    for (Index i = 0; i < shots; ++i) {
      balls.push_back(static_cast<Index>(mesh.nodes.size()));
      mesh.nodes.emplace_back(0.5 + 0.4 * number(), 0.5 + 0.4 * number(), height * (1.5 + 0.4 * number()));
      v.push_back(speed * Eigen::Vector3d(0.3 * number(), 0.3 * number(), -1));
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) mass.push_back(std::pow(10, 1 + number()));
  }
  std::vector<Face> faces() const { return quadrilateral_surface(mesh.quadrilaterals); }
};

/// Two bumpy sheets of loose nodes that fly into each other, one finer than the other.
struct Clap : Shower {
  std::vector<Face> upper;

  explicit Clap(unsigned seed) : Shower(seed) {
    mesh.nodes.resize(mesh.nodes.size() - shots), v.resize(mesh.nodes.size()), mass.resize(mesh.nodes.size());
    std::mt19937 random(seed);
    const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    const Mesh other = sheet({13, 11}, [&](double s, double t) {
      return Eigen::Vector3d(0.1 + 0.8 * t, 0.1 + 0.8 * s, 0.08 + 0.01 * number());
    });
    const Index offset = static_cast<Index>(mesh.nodes.size());
    for (Face face : quadrilateral_surface(other.quadrilaterals)) {
      for (Index& i : face.nodes) i += offset;
      upper.push_back(face);
    }
    for (const auto& x : other.nodes) {
      mesh.nodes.push_back(x);
      v.push_back({0.3, 0, -1});
      mass.push_back(std::pow(10, 0.5 + 0.5 * number()));
    }
  }
  std::vector<Face> both() const {
    std::vector<Face> all = faces();
    all.insert(all.end(), upper.begin(), upper.end());
    return all;
  }
};

/// Forces and moments sum to zero in every step, momenta are kept, no energy appears, friction only dissipates, and the
/// balance closes.
template <class Pairing, class... Policies>
void conforms(const Shower& shower, const Pairing& pairing, const Policies&... policies) {
  Balls run(shower.mesh.nodes, shower.v, shower.mass, Contact{pairing, policies...});
  const Eigen::Vector3d momentum = run.momentum(), angular = run.angular_momentum();
  const bool slides = ((Friction<Policies> && !std::is_same_v<Policies, Frictionless>) || ...);
  const double dt = 2e-3;
  double most = 0, touched = 0, peak = 0;
  for (int n = 0; n < 200; ++n) {
    const auto x = [&](std::size_t i) { return run.nodes.x(i); };
    std::vector<Eigen::Vector3d> before;
    for (std::size_t i = 0; i < run.nodes.size(); ++i) before.push_back(x(i));
    const double friction = run.ledger.friction.settled();
    run.step(dt);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = sum;
    const auto forces = run.contact.forces(run.nodes.size());
    for (std::size_t i = 0; i < forces.size(); ++i) {
      sum += forces[i], moment += cross<double>(before[i], forces[i]);
      peak = std::max(peak, forces[i].norm());
    }
    touched += static_cast<double>(run.contact.pairs().size());
    CHECK(sum.norm() <= 1e-12 * peak);
    if (!slides) CHECK(moment.norm() <= 1e-12 * peak);
    CHECK(run.ledger.friction.settled() >= friction - 1e-14 * run.begin_energy);
    most = std::max(most, run.energy());
  }
  CHECK(touched > 30);
  CHECK(most <= (1 + 1e-14) * run.begin_energy);
  CHECK((run.momentum() - momentum).norm() < 1e-12 * momentum.norm());
  if (!slides) CHECK((run.angular_momentum() - angular).norm() < 1e-12 * angular.norm());
  CHECK(run.energy() + run.ledger.contact.settled() + run.ledger.friction.settled() ==
        Approx(run.begin_energy).epsilon(1e-12));
  if (slides) CHECK(run.ledger.friction.settled() > 1e-3 * run.begin_energy);
}

template <class... Policies>
void conforms_as_contact(const Policies&... policies) {
  for (const unsigned seed : {1u, 2u}) {
    const Shower shower(seed);
    conforms(shower, NodeToSurface{shower.balls, Surface{shower.faces()}}, policies...);
    conforms(shower, NodeToSurface{shower.balls, Surface{shower.faces(), 0.02}, 0.01}, policies...);
    const Clap clap(seed);
    conforms(clap, TwoWay{Surface{clap.faces()}, Surface{clap.upper}}, policies...);
    conforms(clap, TwoWay{Surface{clap.faces(), 0.01}, Surface{clap.upper, 0.01}}, policies...);
    conforms(clap, SelfContact{Surface{clap.both()}}, policies...);
  }
}

}  // namespace strike::testing
