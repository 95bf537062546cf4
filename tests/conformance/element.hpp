#pragma once
// The laws of the Element concept (strike/element/element.hpp), and for elements of solids all of them as one suite:
//   TEST_CASE("conformance: my element") { testing::conforms(MyElement{}); }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include <strike/element/element.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/verify/patch_test.hpp>
#include <strike/verify/single_element.hpp>

#include "conformance/degenerate.hpp"
#include "support/catch.hpp"

namespace strike::testing {

using namespace strike::verify;

/// The corners of an undistorted element of n nodes and unit size.
template <int n>
Nodal<double, n> reference_corners() {
  static_assert(n == 8, "give conforms the corners of your element");
  return unit_cube();
}

/// Distorted elements of any size, aspect and place, none of them inverted at a corner of the cube that holds it.
template <int n>
class Shapes {
 public:
  explicit Shapes(unsigned seed, Nodal<double, n> corners = reference_corners<n>(), double distortion = 0.2)
      : random_(seed), corners_(std::move(corners)), distortion_(distortion) {}

  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Eigen::Vector3d vector() { return {unit(), unit(), unit()}; }
  Eigen::Matrix3d matrix() {
    return Eigen::Matrix3d::NullaryExpr([&] { return unit(); });
  }
  template <int m = n>
  Nodal<double, m> nodal() {
    return Nodal<double, m>::NullaryExpr([&] { return unit(); });
  }

  Nodal<double, n> operator()() {
    const Eigen::Vector3d stretch(std::exp(unit()), std::exp(unit()), std::exp(unit()));
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(3 * unit(), vector().normalized()).toRotationMatrix();
    const Eigen::Matrix3d shear = Eigen::Matrix3d::Identity() + 0.3 * matrix();
    const Nodal<double, n> distorted = corners_ + distortion_ * nodal();
    return ((turn * shear * stretch.asDiagonal()) * distorted).colwise() + vector();
  }

 private:
  std::mt19937 random_;
  Nodal<double, n> corners_;
  double distortion_;
};

// Materials that show what an element does.

/// The same stress whatever happens, and moduli for those who ask.
struct ConstantStress {
  SymmetricTensor<double> sigma{};
  double modulus = 1;

  using Kinematics = SolidKinematics;
  template <class T>
  struct State {};

  double density() const { return 1; }
  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>&, double) const {
    return stress(std::as_const(state));
  }
  template <class T>
  SymmetricTensor<T> stress(const State<T>&) const {
    return {T(sigma.xx), T(sigma.yy), T(sigma.zz), T(sigma.xy), T(sigma.yz), T(sigma.zx)};
  }
  template <class T>
  Moduli<T> moduli(const State<T>&, const SolidKinematics::Rate<T>&) const {
    return {T(modulus), T(0.5 * modulus)};
  }
};

/// No stress; remembers what the element measured.
struct Witness {
  using Kinematics = SolidKinematics;
  template <class T>
  struct State {
    SolidKinematics::Rate<T> rate;
  };

  double density() const { return 1; }
  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double) const {
    state.rate = rate;
    return {};
  }
  template <class T>
  SymmetricTensor<T> stress(const State<T>&) const {
    return {};
  }
  template <class T>
  Moduli<T> moduli(const State<T>&, const SolidKinematics::Rate<T>&) const {
    return {T(1.0), T(0.5)};
  }
};

/// A metal in units of its own: density, bulk modulus and size 1.
inline const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1},
                         VonMises{.shear_modulus = 0.4, .yield_stress = 4e-3, .hardening_modulus = 4e-3}};

/// One that breaks at the first strain worth the name.
inline const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 1},
                           VonMises{.shear_modulus = 0.4, .yield_stress = 1}, UltimateStress{1e-3}};

namespace detail {

template <class E, class M>
Response<double, motions<E>> respond(const E& element, const M& material, const Nodal<double, E::nodes>& x,
                                     const Nodal<double, motions<E>>& v, double dt) {
  typename E::template State<M, double> state;
  element.begin(state, material, x);
  return element.advance(state, material, x, v, dt);
}

/// The gradient operator B, from the forces of a stress: f_iI = sigma_ij B_jI. As if the nodes were at rest.
template <class E>
Nodal<double, E::nodes> forces(const E& element, const SymmetricTensor<double>& sigma,
                               const Nodal<double, E::nodes>& x) {
  return respond(element, ConstantStress{sigma}, x, Nodal<double, E::nodes>::Zero().eval(), 1.0).force;
}

/// Whether the trilinear map of the corners is positive at each of them.
inline bool is_convex(const Nodal<double, 8>& x) {
  constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  for (int I = 0; I < 8; ++I) {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = x.col(neighbours[I][k]) - x.col(I);
    if (!(edges.determinant() > 0)) return false;
  }
  return true;
}

inline double size(const auto& x) { return (x.colwise() - x.rowwise().mean()).cwiseAbs().maxCoeff(); }

}  // namespace detail

/// The gradient operator is dV/dx, B x^T = V 1, and every stress does its work on it. The masses of the nodes are the
/// element's.
template <class E>
void gradient_is_that_of_the_volume(const E& element, Shapes<E::nodes> shapes) {
  constexpr int n = E::nodes;
  using D = Dual<double, 3>;
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, n> x = shapes();
    const Nodal<double, n> B = detail::forces(element, SymmetricTensor<double>::isotropic(1), x);
    const double rounding = 1e-13 * B.cwiseAbs().maxCoeff();

    double volume = 0;
    for (int node = 0; node < n; ++node) {
      Nodal<D, n> x_dual = x.template cast<D>();
      for (int i = 0; i < 3; ++i) x_dual(i, node) = D::variable(x(i, node), static_cast<std::size_t>(i));
      typename E::template State<ConstantStress, D> state;
      const D V = double(n) * element.begin(state, ConstantStress{}, x_dual);  // of the density 1
      for (int i = 0; i < 3; ++i) CHECK(std::abs(B(i, node) - V.derivative(static_cast<std::size_t>(i))) <= rounding);
      volume = V.value();
    }
    const Eigen::Matrix3d Bx = B * x.transpose();
    CHECK((Bx - volume * Eigen::Matrix3d::Identity()).norm() <= 1e-13 * (B.norm() * x.norm()));
    const Eigen::Matrix3d S = shapes.matrix();
    const auto sigma = symmetric_part<double>(S);
    CHECK((detail::forces(element, sigma, x) - sigma.matrix() * B).norm() <= 10 * rounding);
  }
}

/// Linear velocity fields are measured exactly at every point of any shape; the rate of the volume is theirs.
template <class E>
void reproduces_linear_fields(const E& element, Shapes<E::nodes> shapes) {
  constexpr int n = E::nodes;
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, n> x = shapes();
    const Eigen::Matrix3d L = shapes.matrix();
    const Nodal<double, n> v = (L * x).colwise() + shapes.vector();
    typename E::template State<Witness, double> state;
    element.begin(state, Witness{}, x);
    element.advance(state, Witness{}, x, v, 1e-15);  // so short that its middle is its end
    const double rounding = 1e-13 * v.norm() / detail::size(x);
    state.each_point([&](const auto& point) {
      CHECK((point.rate.rate_of_deformation.matrix() - symmetric_part(L).matrix()).norm() <= 10 * rounding);
      CHECK(point.rate.relative_volume == Approx(1).epsilon(1e-14));
    });
  }
}

/// What an element makes of the middle of a step.
enum class FiniteRotations { exact, strain };

/// Rigid motions strain nothing, in steps of any angle; or if their angle is infinitesimal.
template <class E, class M>
void rigid_motions_give_no_force(const E& element, const M& material, Shapes<E::nodes> shapes,
                                 FiniteRotations rotations) {
  const double angle = rotations == FiniteRotations::exact ? 0.5 : 1e-8;
  for (int trial = 0; trial < 5; ++trial) {
    const Nodal<double, E::nodes> x = shapes();
    SingleElement single{element, material, x};
    const double rounding = 1e-13 * std::pow(detail::size(x) + 5, 2);  // the rotation is about the origin
    for (const auto& record : single.run(motion::rotation(angle * shapes.vector().normalized()), 1.0, 10))
      CHECK(record.force.norm() <= rounding);
    Nodal<double, motions<E>> along = Nodal<double, motions<E>>::Zero();
    along.template leftCols<E::nodes>().colwise() = shapes.vector();
    CHECK(single.step(along, 1.0).force.norm() <= rounding);
  }
}

/// Nodal forces sum to zero, and so do their moments, whatever the motion.
template <class E, class M>
void forces_and_moments_sum_to_zero(const E& element, const M& material, Shapes<E::nodes> shapes) {
  constexpr int n = E::nodes;
  for (int trial = 0; trial < 10; ++trial) {
    SingleElement single{element, material, shapes()};
    for (int i = 0; i < 5; ++i) {
      const auto& now = single.step(shapes.template nodal<motions<E>>(), 0.01);
      Eigen::Vector3d moment = now.force.template rightCols<motions<E> - n>().rowwise().sum();
      for (int I = 0; I < n; ++I) moment += Eigen::Vector3d(now.x.col(I)).cross(Eigen::Vector3d(now.force.col(I)));
      CHECK(now.force.template leftCols<n>().rowwise().sum().norm() <= 1e-14 * now.force.norm());
      CHECK(moment.norm() <= 1e-13 * now.force.norm() * now.x.norm());  // of the modulus, of which the stress is 1 %
    }
  }
}

/// Hourglass control gives no force and does no work on linear fields of any shape.
template <class E>
void hourglass_control_ignores_linear_fields(const E& element, Shapes<E::nodes> shapes) {
  constexpr int n = E::nodes;
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, n> x = shapes();
    Eigen::Matrix3d L = shapes.matrix();
    L += (1 - L.trace()) / 3 * Eigen::Matrix3d::Identity();  // no compression, no bulk viscosity
    const Nodal<double, n> v = (L * x).colwise() + shapes.vector();
    const auto response = detail::respond(element, ConstantStress{}, x, v, 0.01);
    const double wave_force = 1 * v.norm() * std::pow(detail::size(x), 2);  // rho c v h^2
    CHECK(response.force.norm() <= 1e-14 * wave_force);
    CHECK(std::abs(response.hourglass_work) <= 1e-28 * wave_force * v.norm());
  }
}

/// Without a stress, an element only takes energy: nodes that are moved at random feel a resistance, and the work
/// against the hourglass control is never given back in full.
template <class E, class M>
void creates_no_energy(const E& element, const M& unstressed, Shapes<E::nodes> shapes) {
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, E::nodes> x = shapes();
    const Nodal<double, motions<E>> v = shapes.template nodal<motions<E>>();
    CHECK(detail::respond(element, unstressed, x, v, 0.01).force.cwiseProduct(v).sum() >= 0);

    SingleElement single{element, unstressed, x};
    for (int i = 0; i < 30; ++i) {
      const auto& now = single.step(shapes.template nodal<motions<E>>(), 1e-3);
      CHECK(now.hourglass >= 0);
      CHECK(now.internal == 0);
    }
  }
}

/// What the motion of the nodes puts in is booked, as work of the stresses, against the hourglass control or as
/// dissipation, but for an error that falls with the step.
template <class E, class M>
void books_its_work(const E& element, const M& material, Shapes<E::nodes> shapes) {
  using Vectors = Nodal<double, motions<E>>;
  for (int trial = 0; trial < 3; ++trial) {
    const Nodal<double, E::nodes> x = shapes();
    const Vectors a = shapes.template nodal<motions<E>>(), b = shapes.template nodal<motions<E>>();
    const auto swing = [&](const auto&, double t) -> Vectors {
      return 0.01 * (std::cos(2 * t) * a + std::sin(3 * t) * b);
    };
    const auto error = [&](int steps) {
      SingleElement single{element, material, x};
      const auto now = single.run(swing, 3.0 / steps, static_cast<std::size_t>(steps)).back();
      CHECK(now.bulk_viscosity >= 0);
      return std::abs(now.internal + now.hourglass + now.bulk_viscosity - now.external) / now.external;
    };
    const double coarse = error(100), fine = error(1000);
    CHECK(coarse < 1e-2);
    // The rest is of the third power of the strains: of 0.01 over the shortest distance of two corners.
    double shortest = 1;
    for (int i = 0; i < x.cols(); ++i)
      for (int j = 0; j < i; ++j)
        if (const double distance = (x.col(i) - x.col(j)).norm(); distance > 0) shortest = std::min(shortest, distance);
    CHECK(fine < std::max(0.2 * coarse, std::pow(0.01 / shortest, 3)));
  }
}

/// Lane i of a pack gives what a double gives, to the rounding of the pack's numbers.
template <class P, class E, class M>
void lanes_agree(const E& element, const M& material, Shapes<E::nodes> shapes) {
  constexpr int n = E::nodes, m = motions<E>;
  constexpr std::size_t width = lanes<P>;
  const double rounding = std::numeric_limits<RealOf<P>>::epsilon();
  Nodal<P, n> x;
  Nodal<P, m> v;
  std::array<Nodal<double, n>, width> x_alone;
  std::array<Nodal<double, m>, width> v_alone;
  std::array<typename E::template State<M, double>, width> alone;
  typename E::template State<M, P> pack;
  const auto spread = [&](const auto& from, auto& to) {
    for (int i = 0; i < to.size(); ++i) to(i) = P::generate([&](std::size_t l) { return from[l](i); });
  };
  const auto round = [](const auto& a) {
    return a.template cast<RealOf<P>>().template cast<double>().eval();  // the same numbers for both
  };
  for (std::size_t l = 0; l < width; ++l) {
    x_alone[l] = round(shapes());
    element.begin(alone[l], material, x_alone[l]);
  }
  spread(x_alone, x);
  element.begin(pack, material, x);
  for (int step = 1; step <= 5; ++step) {
    const double dt = 0x1p-8;
    for (std::size_t l = 0; l < width; ++l) {
      v_alone[l] = round(shapes.template nodal<m>());
      if (l == 0) v_alone[l].setZero();  // lane 0 stays at rest
      x_alone[l] = round(x_alone[l] + dt * v_alone[l].template leftCols<n>());
    }
    spread(x_alone, x), spread(v_alone, v);
    const auto response = element.advance(pack, material, x, v, dt);
    for (std::size_t l = 0; l < width; ++l) {
      const auto expected = element.advance(alone[l], material, x_alone[l], v_alone[l], dt);
      CAPTURE(width, l, step);
      const double force = std::pow(detail::size(x_alone[l]), 2), work = force * detail::size(x_alone[l]);
      for (int i = 0; i < 3 * m; ++i)
        CHECK(std::abs(double(lane(response.force(i), l)) - expected.force(i)) <= 100 * step * rounding * force);
      CHECK(double(lane(response.volume, l)) == Approx(expected.volume).epsilon(100 * rounding));
      CHECK(double(lane(response.critical_rate, l)) == Approx(expected.critical_rate).epsilon(1e3 * rounding));
      CHECK(std::abs(double(lane(response.internal_work, l)) - expected.internal_work) <= 10 * rounding * work);
      CHECK(std::abs(double(lane(response.hourglass_work, l)) - expected.hourglass_work) <= 10 * rounding * work);
      CHECK(std::abs(double(lane(response.bulk_viscosity_work, l)) - expected.bulk_viscosity_work) <=
            10 * rounding * work);
    }
  }
}

/// The stable step is never beyond the exact one of the free element, at rest and in compression, compressible or not.
template <class E>
void stable_step_is_safe(const E& element, Shapes<E::nodes> shapes) {
  for (int trial = 0; trial < 60; ++trial) {
    const double nu = std::array{0.0, 0.3, 0.4999}[static_cast<std::size_t>(trial % 3)];
    const Nodal<double, E::nodes> x = shapes();
    SingleElement single{element, Elastic{1, 1, nu}, x};
    CHECK(vibration_of(single).critical_step() >= (1 - 1e-9) * single.now().stable_step);

    const Nodal<double, E::nodes> v = -0.02 / single.now().stable_step * x;
    const double exact = vibration_of(single, v).critical_step();  // by motions of a millionth of a step
    CHECK(exact >= (1 - 1e-7) * single.step(v, 1e-9 * single.now().stable_step).stable_step);
  }
}

/// An element whose material has failed gives no force and allows every step, whatever its shape becomes.
template <class E, class M>
void failed_elements_are_silent(const E& element, const M& brittle_material, Shapes<E::nodes> shapes) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(0, 1) = 0.1;
  SingleElement single{element, brittle_material, shapes()};
  single.run(motion::homogeneous(shear), 0.1, 2);
  CHECK(single.now().force.norm() == 0);
  const double booked = single.now().internal;
  for (int i = 0; i < 20; ++i) {
    const auto& now = single.step(shapes.template nodal<motions<E>>(), 0.3);  // inside out sooner or later
    CHECK(now.force.norm() == 0);
    CHECK(now.volume > 0);
    CHECK(now.stable_step == std::numeric_limits<double>::infinity());
    CHECK(now.internal == booked);
    CHECK((std::isfinite(now.hourglass) && std::isfinite(now.bulk_viscosity)));
  }
}

/// The patch test: in a cube of seven distorted hexahedra, stretched to a brick, whose outer nodes move by a linear
/// field and whose inner nodes do too, the stress is the same everywhere and the inner nodes are in equilibrium.
template <class E>
void passes_the_patch_test(const E& element, Shapes<8> shapes, const Eigen::Vector3d& stretch = Eigen::Vector3d::Ones(),
                           double tolerance = 1e-12) {
  for (int trial = 0; trial < 5; ++trial) {
    PatchMesh<8> patch = hexahedra_patch((0.4 * (unit_cube().array() - 0.5) + 0.5).matrix() + 0.08 * shapes.nodal());
    patch.nodes = stretch.asDiagonal() * patch.nodes.eval();
    Eigen::Matrix3d L = 1e-3 * shapes.matrix();
    L += (1e-3 - L.trace() / 3) * Eigen::Matrix3d::Identity();  // no compression: bulk viscosity depends on the size
    const auto response = move_patch(element, Elastic{1, 1, 0.3}, patch, L * patch.nodes, 1.0);
    CHECK(response.spread([](const auto& s) { return s.matrix(); }) <= tolerance);
    CHECK(response.unbalanced_force() <= tolerance);
    const double stress = response.elements[0].stress.matrix().norm();
    CHECK(response.force.leftCols(8).norm() > 0.1 * stress * (stretch.prod() / stretch.maxCoeff()));
    CHECK(response.volume() == Approx(stretch.prod() * (Eigen::Matrix3d::Identity() + L).determinant()).epsilon(1e-13));
  }
}

/// All laws.
template <class E>
void conforms(const E& element, FiniteRotations rotations = FiniteRotations::exact,
              const Nodal<double, E::nodes>& corners = reference_corners<E::nodes>()) {
  const Shapes<E::nodes> shapes(1, corners);
  gradient_is_that_of_the_volume(element, shapes);
  reproduces_linear_fields(element, shapes);
  rigid_motions_give_no_force(element, Elastic{1, 1, 0.3}, shapes, rotations);
  forces_and_moments_sum_to_zero(element, metal, shapes);
  hourglass_control_ignores_linear_fields(element, shapes);
  creates_no_energy(element, ConstantStress{}, shapes);
  books_its_work(element, metal, shapes);
  lanes_agree<Pack<double, 8>>(element, metal, shapes);
  lanes_agree<Pack<float, 16>>(element, metal, shapes);
  stable_step_is_safe(element, shapes);
  failed_elements_are_silent(element, brittle, shapes);
  if constexpr (E::nodes == 8) passes_the_patch_test(element, shapes);
}

}  // namespace strike::testing
