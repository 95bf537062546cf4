#include <algorithm>
#include <cmath>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D10: an aluminium ball of 1 mm does not tunnel into a plate of 1 mm at 10 km/s") {
  // [mm, us, mg]: km/s, GPa
  const double rho = 2.785, c = 5.33, s = 1.34, modulus = rho * c * c;
  const Solid aluminium{PolynomialEos{.density = rho,
                                      .C1 = modulus,
                                      .C2 = modulus * (2 * s - 1),
                                      .C3 = modulus * (s - 1) * (3 * s - 1),
                                      .C4 = 2,
                                      .C5 = 2,
                                      .pressure_cutoff = -1.5},
                        VonMises{.shear_modulus = 27, .yield_stress = 0.3}};
  const Mesh ball = transformed(box({.lower = {-1, -1, -1}, .size = {2, 2, 2}, .cells = {8, 8, 8}}),
                                [](const Eigen::Vector3d& x) {  // a cube blown up to a ball
                                  const double r = x.norm();
                                  return Eigen::Vector3d(Eigen::Vector3d(0.003, 0.002, 0.51) +
                                                         (r > 0 ? 0.5 * x.cwiseAbs().maxCoeff() / r : 0.0) * x);
                                });
  const Mesh plate = box({.lower = {-1.2, -1.2, -1}, .size = {2.4, 2.4, 1}, .cells = {18, 18, 8}});
  Mesh mesh = plate;
  const Index first = append(mesh, ball);
  std::vector<Index> ball_nodes;
  for (Index i = first; i < mesh.nodes.size(); ++i) ball_nodes.push_back(i);
  const Cells<8> of_ball(mesh.hexahedra.end() - 512, mesh.hexahedra.end());
  const std::vector<Face> skin = surface(Mesh{mesh.nodes, of_ball});

  std::vector<detail::FaceCorners> faces;
  for (const Face& face : surface(plate)) faces.push_back(face.nodes);
  const detail::Target target(faces, mesh.nodes.size());

  const auto strike_with = [&](auto pairing) {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, aluminium, mesh.hexahedra}, Contact{pairing},
                       InitialVelocity{{0, 0, -10}, ball_nodes}},
                 ExplicitOptions{}};
    const double momentum = run.momentum().z();
    run.until(0.1, [] {});  // by then the ball has come in by its radius
    int inside = 0;
    const auto x = run.positions();
    for (const Index i : surface_nodes(skin)) {
      detail::Foot nearest;
      for (Index f = 0; f < target.faces().size(); ++f) {
        const auto foot = target.foot(f, target.corners(f, x), x[i], x);
        if (foot.point.distance2 < nearest.point.distance2) nearest = foot;
      }
      if (nearest.height < -0.01 / 8) ++inside;
    }
    CHECK(inside == 0);
    CHECK(run.template item<1>().penetration() < 0.01 / 8);  // a hundredth of an element
    CHECK(run.momentum().z() == Approx(momentum).epsilon(1e-10));
    double lowest = 0;
    for (const Index i : ball_nodes) lowest = std::min(lowest, x[i].z());
    CHECK(lowest < -0.5);
  };
  strike_with(NodeToSurface{surface_nodes(skin), Surface{surface(plate)}});
  strike_with(TwoWay{Surface{skin}, Surface{surface(plate)}});
}
