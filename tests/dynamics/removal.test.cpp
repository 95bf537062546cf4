#include <cmath>
#include <cstddef>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/removal.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/section.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using Vector = Eigen::Vector3d;

Matrix3<double> turn(double angle, const Vector& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
const Matrix3<double> turned = turn(0.7, {1, 2, 3}), turned_again = turn(2.9, {-1, 0.3, 1});

/// Deforms every node of a mesh by F over the time 1.
template <class F>
auto driven(const Mesh& mesh, const F& gradient_rate) {
  std::vector<Index> all;
  for (Index i = 0; i < mesh.nodes.size(); ++i) all.push_back(i);
  return InitialVelocityField{[=](const Vector& x) { return Vector(gradient_rate * x); }};
}

const Fluid water{LinearEos{.density = 1, .bulk_modulus = 1e-9}};  // so soft that nodes fly straight on

/// The stretch at which the cube of a fluid is deleted that is drawn out along an axis of its own, turned by Q.
template <class Element, class Cells, class... Policies>
double stretch_at_end(const Element& element, const Mesh& cube, const Cells& cells, const Matrix3<double>& Q,
                      double limit, const Policies&... policies) {
  const Mesh mesh = transformed(cube, [&](const Vector& x) { return Vector(Q * x); });
  const Matrix3<double> L = Q * Vector(1, 0, 0).asDiagonal() * Q.transpose();
  Explicit run{Scene{mesh.nodes, Part{element, water, cells, Erosion{.strain = limit}}, driven(mesh, L)},
               {.largest_step = 1e-3},
               policies...};
  while (run.template part<0>().deleted() < cells.size() && run.time() < 5) run.step();
  return 1 + run.time();
}

struct Thin {
  double least;
  template <class State, class Condition>
  auto keeps(const State&, const Condition& element) const {
    return element.relative_volume() > least;
  }
};
struct Strained {
  double most;
  static constexpr bool needs_geometric_strain = true;
  template <class State, class Condition>
  auto keeps(const State&, const Condition& element) const {
    return element.geometric_strain() < most;
  }
};

using Metal = Solid<LinearEos, VonMises>;
static_assert(detail::RemovalLaw<Erosion, Hex8<>, Metal> && detail::RemovalLaw<Erosion, Hex8<>, Fluid<LinearEos>>);
static_assert(detail::RemovalLaw<Thin, Tet4<>, Metal> && detail::RemovalLaw<Strained, Hex8<>, Metal>);
static_assert(!detail::RemovalLaw<NoErosion, Hex8<>, Metal> && !detail::RemovalLaw<int, Hex8<>, Metal>);
static_assert(!detail::RemovalLaw<FailureStrain, Hex8<>, Metal>);

// The geometric strain is known where a material has no other, and costs nothing elsewhere.
static_assert(detail::needs_geometric_strain<Erosion, Fluid<LinearEos>>() &&
              detail::needs_geometric_strain<Erosion, Elastic>());
static_assert(!detail::needs_geometric_strain<Erosion, Metal>() &&
              !detail::needs_geometric_strain<Erosion, Homogeneous<PlaneStress<Metal>>>());
static_assert(detail::needs_geometric_strain<Erosion, Homogeneous<PlaneStress<Elastic>>>());
static_assert(!detail::needs_geometric_strain<Thin, Metal>() && detail::needs_geometric_strain<Strained, Metal>());

}  // namespace

TEST_CASE("removal: the geometric strain of closed forms, whatever turns before and after") {
  const auto strain = [](const Matrix3<double>& F) {
    return detail::equivalent_hencky_strain<double>(turned * F * turned_again);
  };
  for (const double stretch : {0.2, 0.9, 1.0 + 1e-4, 1.5, 7.0}) {
    CHECK(strain(Vector(stretch, 1, 1).asDiagonal()) ==
          Approx(2.0 / 3.0 * std::abs(std::log(stretch))).epsilon(1e-6).margin(1e-7));
    CHECK(strain(Vector(stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch)).asDiagonal()) ==
          Approx(std::abs(std::log(stretch))).epsilon(1e-6).margin(1e-7));  // a bar of constant volume
    CHECK(strain(stretch * Matrix3<double>::Identity()) == Approx(0).margin(1e-6));
  }
  for (const double shear : {1e-3, 0.5, 4.0}) {
    Matrix3<double> F = Matrix3<double>::Identity();
    F(0, 1) = shear;
    CHECK(strain(F) == Approx(2 / std::sqrt(3.0) * std::asinh(shear / 2)).epsilon(1e-6));
  }
}

TEST_CASE("removal: a homogeneous deformation is measured exactly on distorted elements") {
  Matrix3<double> F;
  F << 1.2, 0.3, -0.1, 0.05, 0.8, 0.2, -0.3, 0.1, 1.1;
  const double expected = detail::equivalent_hencky_strain<double>(F);
  const auto measured = [&]<class E>(const E&, const Nodal<double, E::nodes>& x) {
    const Matrix3<double> before = detail::element_axes<E, double>(x),
                          after = detail::element_axes<E, double>(Nodal<double, E::nodes>(F * x));
    return detail::equivalent_hencky_strain<double>(after * detail::inverse_of_columns<double>(before));
  };
  Nodal<double, 8> hexahedron;
  hexahedron << 0, 1.2, 1, 0.1, 0, 1, 1.3, 0, 0, 0.1, 1, 0.9, 0.2, 0, 1.1, 1, 0, 0.1, 0, 0.2, 1, 1.2, 0.9, 1;
  CHECK(measured(Hex8{}, hexahedron) == Approx(expected).epsilon(1e-9));
  Nodal<double, 4> tetrahedron;
  tetrahedron << 0, 1, 0.2, 0.3, 0, 0.1, 1, 0.2, 0, 0, 0.1, 0.7;
  CHECK(measured(Tet4{}, tetrahedron) == Approx(expected).epsilon(1e-9));
}

TEST_CASE(
    "removal: a fluid is deleted at a geometric strain, at any angle, of hexahedra and tetrahedra, in any numbers") {
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const double limit = 0.4, stretch = std::exp(1.5 * limit);                                // 2/3 ln(stretch) = limit
  const auto near = [&](double found) { CHECK(found == Approx(stretch).margin(1.1e-3)); };  // a step and rounding
  for (const Matrix3<double>& Q : {Matrix3<double>(Matrix3<double>::Identity()), turned, turned_again}) {
    near(stretch_at_end(Hex8{}, cube, cube.hexahedra, Q, limit));
    near(stretch_at_end(Hex8Full{}, cube, cube.hexahedra, Q, limit));
    near(stretch_at_end(Tet4{}, cube, tetrahedralized(cube).tetrahedra, Q, limit));
  }
  near(stretch_at_end(Hex8{}, cube, cube.hexahedra, turned, limit, in<double>));
  near(stretch_at_end(Hex8{}, cube, cube.hexahedra, turned, limit, in<Pack<float>>));
  near(stretch_at_end(Hex8{}, cube, cube.hexahedra, turned, limit, in<Pack<float>, double>, OpenMP{.threads = 2}));
}

TEST_CASE("removal: laws of one's own, by volume and by geometric strain of a metal") {
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const Metal soft{LinearEos{.density = 1, .bulk_modulus = 1e-9},
                   VonMises{.shear_modulus = 1e-9, .yield_stress = 1, .hardening_modulus = 0}};
  const Hex8 free_of_viscosity{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}};
  const auto end_of = [&](const auto& law, double rate) {
    Explicit run{Scene{cube.nodes, Part{free_of_viscosity, soft, cube.hexahedra, law},
                       driven(cube, Matrix3<double>(Vector(rate, 0, 0).asDiagonal()))},
                 {.largest_step = 1e-3}};
    while (run.template part<0>().deleted() < 8 && run.time() < 5) run.step();
    CHECK(run.energy().error() == Approx(0).margin(1e-6));
    CHECK(run.template part<0>().alive() == std::vector<bool>(8, false));
    return 1 + rate * run.time();
  };
  CHECK(end_of(Thin{0.6}, -1) == Approx(0.6).margin(1.1e-3));
  CHECK(end_of(Strained{0.4}, 1) == Approx(std::exp(0.6)).margin(1.1e-3));
  CHECK(end_of(Strained{0.4}, -1) == Approx(std::exp(-0.6)).margin(1.1e-3));
}
