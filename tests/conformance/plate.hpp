#pragma once
// The laws of elements of plates as one suite, those that they share with solids from conformance/element.hpp:
//   TEST_CASE("conformance: my plate") { testing::conforms_as_plate(MyPlate{}); }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>

#include "conformance/element.hpp"

namespace strike::testing {

using namespace strike::verify;

/// The undistorted corners of a plate of n nodes.
template <int n>
Nodal<double, n> plate_corners() {
  if constexpr (n == 3)
    return unit_triangle();
  else
    return unit_square();
}

/// Distorted triangles, or quadrilaterals, warped or plane.
template <int n>
class PlateShapes : public Shapes<n> {
 public:
  explicit PlateShapes(unsigned seed, double distortion = 0.2)
      : Shapes<n>(seed, plate_corners<n>(), distortion), distortion_(distortion) {}

  /// In the plane z = 0.
  Nodal<double, n> flat() {
    const Eigen::Vector3d stretch(std::exp(this->unit()), std::exp(this->unit()), 1);
    const Nodal<double, n> distorted = plate_corners<n>() + distortion_ * this->nodal();
    Nodal<double, n> x = stretch.asDiagonal() * distorted;
    x.row(2).setZero();
    return x;
  }
  Eigen::Matrix3d turn() { return Eigen::AngleAxisd(3 * this->unit(), this->vector().normalized()).toRotationMatrix(); }
  /// In any plane.
  Nodal<double, n> plane() { return turn() * flat(); }

 private:
  double distortion_;
};

using Quadrilaterals = PlateShapes<4>;
using Triangles = PlateShapes<3>;

/// The frame of a plate at x.
inline Plate4Frame<double> plate_frame(const Nodal<double, 4>& x) {
  const Plate4Modes<double> m = to_plate_modes<double>(x);
  return {m.xi, m.eta};
}
inline Plate4Frame<double> plate_frame(const Nodal<double, 3>& x) {
  const Plate3Modes<double> m = to_triangle_modes<double>(x);
  return {m.xi, m.eta};
}

// Sections that show what a plate does.

/// No resultants, but moduli; remembers what the element measured.
struct PlateWitness {
  using Kinematics = PlateKinematics;
  template <class T>
  struct State {
    PlateKinematics::Rate<T> rate;
  };

  double density() const { return 1; }
  double thickness() const { return 1; }
  double rotary_inertia() const { return 1.0 / 12; }
  template <class T>
  PlateKinematics::Stress<T> stress(State<T>& state, const PlateKinematics::Rate<T>& rate, double) const {
    state.rate = rate;
    return {};
  }
  template <class T>
  PlateKinematics::Stress<T> stress(const State<T>&) const {
    return {};
  }
  template <class T>
  PlateKinematics::Moduli<T> moduli(const State<T>&, const PlateKinematics::Rate<T>&) const {
    return {{T(1.0), T(0.4)}, {T(0.0), T(0.0)}, {T(0.1), T(0.04)}, T(0.3)};
  }
};

/// The same resultants whatever happens.
struct ConstantResultants : PlateWitness {
  PlateKinematics::Stress<double> resultants{};

  template <class T>
  PlateKinematics::Stress<double> stress(State<T>&, const PlateKinematics::Rate<T>&, double) const {
    return resultants;
  }
  template <class T>
  PlateKinematics::Stress<double> stress(const State<T>&) const {
    return resultants;
  }
};

/// Plates of the metal of the solids, elastic, plastic or brittle.
inline const Homogeneous elastic_plate{PlaneStress{Elastic{1, 1, 0.3}}, 0.2};
inline const Homogeneous metal_plate{PlaneStress{metal}, 0.2};
inline const Homogeneous brittle_plate{PlaneStress{brittle}, 0.2};

/// Velocities and angular velocities that are linear in the positions X of a plane, and do not drill: v = L X + a,
/// w = W X + b, but about the normal the spin of L. Or, for elements that measure the shear along their edges, with a
/// deflection to the curvature, so that the shear is uniform too.
enum class Bending { rotations, deflection };
template <int n>
class LinearPlateMotion {
 public:
  LinearPlateMotion(PlateShapes<n>& shapes, const Nodal<double, n>& X, Bending bending)
      : L_(shapes.matrix()),
        W_(shapes.matrix()),
        a_(shapes.vector()),
        b_(shapes.vector()),
        middle_(X.rowwise().mean()) {
    const Plate4Frame<double> frame = plate_frame(X);
    e_ << frame.e1(), frame.e2(), frame.normal;
    const Eigen::Vector3d e3 = e_.col(2);
    const auto drilling = [&](const auto& w) { return (e3 * e3.transpose() * w).eval(); };
    W_ -= drilling(W_);
    b_ += e3 * axial_vector<double>(L_).dot(e3) - drilling(b_);
    turn_ << 0, e3.z(), -e3.y(), -e3.z(), 0, e3.x(), e3.y(), -e3.x(), 0;
    if (bending == Bending::deflection) {
      const Eigen::Matrix3d in_plane = -turn_ * turn_, K = in_plane * turn_ * W_ * in_plane;
      curvature_ = 0.5 * (K + K.transpose());
      W_ = -turn_ * curvature_;
    }
  }

  Nodal<double, 2 * n> operator()(const Nodal<double, n>& X) const {
    Nodal<double, 2 * n> v;
    v << (L_ * X).colwise() + a_, (W_ * X).colwise() + b_;
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector3d d = X.col(i) - middle_;
      v.col(i) -= 0.5 * d.dot(curvature_ * d) * e_.col(2);
    }
    return v;
  }
  /// A point z over the plane moves at v + w x z e3.
  PlateKinematics::Rate<double> rate() const {
    const auto in_plane = [&](const Eigen::Matrix3d& A) -> PlaneTensor<double> {
      const Eigen::Matrix3d local = e_.transpose() * A * e_;
      return {local(0, 0), local(1, 1), 0.5 * (local(0, 1) + local(1, 0))};
    };
    const Eigen::Vector3d e3 = e_.col(2), w = W_ * middle_ + b_;
    const Eigen::Vector3d shear = e_.transpose() * (L_.transpose() * e3 + w.cross(e3));
    return {in_plane(L_), in_plane(turn_ * W_), {shear.x(), shear.y()}};
  }
  double size() const { return L_.norm() + W_.norm() + b_.norm(); }

 private:
  Eigen::Matrix3d L_, W_, e_, turn_, curvature_ = Eigen::Matrix3d::Zero();  // turn w = w x e3
  Eigen::Vector3d a_, b_, middle_;
};

namespace detail {
inline double norm(const PlaneTensor<double>& a) { return std::sqrt(double_dot(a, a)); }

/// A history of random steps.
template <int n>
struct RandomSteps {
  Nodal<double, n> X;
  std::vector<Nodal<double, 2 * n>> v;

  explicit RandomSteps(PlateShapes<n>& shapes) : X(shapes()) {
    for (int i = 0; i < 5; ++i) v.push_back(shapes.template nodal<2 * n>());
  }
  /// The same with the corners named in another order.
  template <class Order>
  RandomSteps renumbered(const Order& order) const {
    RandomSteps other = *this;
    for (int i = 0; i < n; ++i) {
      other.X.col(i) = X.col(order[std::size_t(i)]);
      for (std::size_t k = 0; k < v.size(); ++k) {
        other.v[k].col(i) = v[k].col(order[std::size_t(i)]);
        other.v[k].col(n + i) = v[k].col(n + order[std::size_t(i)]);
      }
    }
    return other;
  }
  template <class E, class M>
  auto run(const E& element, const M& material) const {
    SingleElement single{element, material, X};
    for (const auto& v_k : v) single.step(v_k, 0.02);
    return single.now();
  }
};
}  // namespace detail

/// On any plane plate membrane rate, curvature and transverse shear of linear fields are measured exactly, and
/// the hourglass control ignores them.
template <class E>
void reproduces_linear_plate_motions(const E& element, PlateShapes<E::nodes> shapes) {
  constexpr int n = E::nodes;
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, n> middle = shapes.plane();  // where the nodes are in the middle of the step
    const LinearPlateMotion<n> motion(shapes, middle, E::projects_shear ? Bending::deflection : Bending::rotations);
    const Nodal<double, 2 * n> v = motion(middle);
    const double dt = 0.01;
    typename E::template State<PlateWitness, double> state;
    element.begin(state, PlateWitness{}, middle);
    const auto response =
        element.advance(state, PlateWitness{}, Nodal<double, n>(middle + 0.5 * dt * v.template leftCols<n>()), v, dt);

    const auto expected = motion.rate();
    const double rounding = 1e-13 * motion.size() * (1 + detail::size(middle));
    state.each_point([&](const auto& point) {
      CHECK(detail::norm(point.rate.membrane - expected.membrane) <= rounding);
      CHECK(detail::norm(point.rate.curvature - expected.curvature) <= rounding);
      CHECK((point.rate.shear - expected.shear).norm() <= rounding);
    });
    const double wave_force = v.norm() * std::pow(detail::size(middle), 2);  // rho c v h^2
    CHECK(response.force.norm() <= 1e-14 * wave_force);
    CHECK(std::abs(response.hourglass_work) <= 1e-28 * wave_force * v.norm());
  }
}

/// It does not matter with which corner the numbers begin; nor, for a section that is the same from above and below,
/// whether they go round one way or the other.
template <class E, class Section = decltype(metal_plate)>
void numbering_does_not_matter(const E& element, PlateShapes<E::nodes> shapes, const Section& section = metal_plate) {
  constexpr int n = E::nodes;
  std::vector<std::array<int, n>> orders(n);  // each corner first, and the other way round
  for (int first = 0; first < n; ++first)
    for (int i = 0; i < n; ++i) orders[std::size_t(first)][std::size_t(i)] = first == 0 ? (n - i) % n : (first + i) % n;
  for (int trial = 0; trial < 5; ++trial) {
    const detail::RandomSteps<n> steps(shapes);
    const auto expected = steps.run(element, section);
    for (const auto& order : orders) {
      const auto found = steps.renumbered(order).run(element, section);
      const double rounding = 1e-13 * detail::size(expected.x);  // of forces of a strain of 1
      for (int i = 0; i < n; ++i) {
        const int j = order[std::size_t(i)];
        CHECK((found.force.col(i) - expected.force.col(j)).norm() <= rounding);
        CHECK((found.force.col(n + i) - expected.force.col(n + j)).norm() <= rounding);
      }
      CHECK(found.volume == Approx(expected.volume).epsilon(1e-14));
      CHECK(found.stable_step == Approx(expected.stable_step).epsilon(1e-13));
      CHECK(found.internal == Approx(expected.internal).epsilon(1e-12));
      CHECK(found.hourglass == Approx(expected.hourglass).epsilon(1e-12));
    }
  }
}

/// The step is never beyond the exact one of the free plate: 3990 quadrilaterals or triangles, plane and warped, of
/// h/sqrt(A) from 1e-3 to 10, and sections of one layer, of stiff faces on a soft core, and of layers beside the
/// surface of the nodes.
template <class E>
void plate_step_is_safe(const E& element, PlateShapes<E::nodes> shapes = PlateShapes<E::nodes>(1)) {
  constexpr int n = E::nodes;
  double least = 10;  // exact over claimed
  const auto ask = [&](const auto& section, const Nodal<double, n>& x) {
    const SingleElement single{element, section, x};
    const double exact = 2 / single.vibration().frequencies()(6 * n - 1);  // nothing damps
    least = std::min(least, exact / single.now().stable_step);
  };
  for (int trial = 0; trial < 3990; ++trial) {
    const double nu = std::array{0.0, 0.3, 0.49}[static_cast<std::size_t>(trial % 3)], c = 0.5 * (1 + shapes.unit());
    const Nodal<double, n> x = trial % 2 == 0 ? shapes() : shapes.plane();
    const double h = std::pow(10, 2 * shapes.unit() - 1) * std::sqrt(plate_frame(x).area);
    const Layer stiff{PlaneStress{Elastic{1, 1, nu}}, c * h, Gauss<3>{}};
    const Layer soft{PlaneStress{Elastic{0.5, std::pow(10, -3 * c), 0.3}}, (1 - c) * h, Gauss<3>{}};
    // Two layers, three, two with an offset: of one type, for each takes seconds to compile.
    const bool three = trial % 5 == 1;
    const Layer third{PlaneStress{Elastic{1, 1, nu}}, (three ? c : 1e-9) * h, Gauss<3>{}};
    if (trial % 5 < 3)
      ask(Layered{stiff, soft, third, Offset{trial % 5 == 2 ? shapes.unit() * h : 0}}, x);
    else
      ask(Homogeneous{PlaneStress{Elastic{1, 1, nu}}, h, Gauss<3>{}}, x);
  }
  CHECK(least >= 1 - 1e-9);
}

/// Layers that slide on each other without resistance.
struct SlidingLayers {
  double stiffness(const TransverseShear<double>& shear) const { return 1e-300 * shear.stiffness; }
};

/// A square of five distorted quadrilaterals, or of the ten triangles that halve them along either diagonal.
template <int n>
PatchMesh<n> plates_patch(PlateShapes<n>& shapes) {
  const PatchMesh<4> whole =
      quadrilaterals_patch((0.4 * (unit_square().array() - 0.5) + 0.5).matrix() + 0.08 * shapes.template nodal<4>());
  PatchMesh<n> patch{whole.nodes, {}, whole.first_inner};
  if constexpr (n == 4)
    patch = whole;
  else
    for (auto cell : whole.cells) {
      if (shapes.unit() > 0) std::rotate(cell.begin(), cell.begin() + 1, cell.end());
      patch.cells.push_back({cell[0], cell[1], cell[2]}), patch.cells.push_back({cell[0], cell[2], cell[3]});
    }
  patch.nodes.row(2).setZero();
  return patch;
}

/// The patch tests: in a square of distorted plates whose nodes move by a linear field, the resultants are
/// the same everywhere and the inner nodes are in equilibrium: of membrane strain, of curvature where layers slide or,
/// if the shear is that along the edges, of any section, and of a uniform transverse shear, of which each node bears
/// the couple e3 x Q of its share of the area.
template <class E>
void passes_the_plate_patch_tests(const E& element, PlateShapes<E::nodes> shapes) {
  const double tolerance = 1e-12;  // rounding
  using Vectors = Eigen::Matrix<double, 3, 8>;
  struct Response {
    std::vector<Eigen::Matrix3d> force, moment;  // of each plate, in space
    std::vector<Eigen::Vector3d> shear;
    Vectors nodal_force, nodal_moment, couple = Vectors::Zero();
    double area;
  };
  const auto same = [&](const auto& all) {
    for (const auto& one : all) CHECK((one - all[0]).norm() <= tolerance * all[0].norm());
  };
  const auto balance = [&](const auto& nodal) { CHECK(nodal.rightCols(4).norm() <= tolerance * nodal.norm()); };

  for (int trial = 0; trial < 5; ++trial) {
    PatchMesh<E::nodes> patch = plates_patch(shapes);
    const Eigen::Matrix3d turn = shapes.turn();
    const Vectors X = turn * patch.nodes;
    patch.nodes = X;

    const auto respond = [&](const auto& section, const Vectors& v, const Vectors& w) {
      Eigen::Matrix3Xd motion(3, 16);
      motion << v, w;
      const auto moved = move_patch(element, section, patch, motion, 1e-14);  // so short that its end is its middle
      Response response{{}, {}, {}, moved.force, moved.moment, Vectors::Zero(), moved.volume()};
      for (std::size_t k = 0; k < patch.cells.size(); ++k) {
        const auto& now = moved.elements[k];
        const Plate4Frame<double> frame = plate_frame(now.x);
        Eigen::Matrix<double, 3, 2> e;
        e << frame.e1(), frame.e2();
        const auto in_space = [&](const PlaneTensor<double>& a) -> Eigen::Matrix3d {
          return e * Eigen::Matrix2d{{a.xx, a.xy}, {a.xy, a.yy}} * e.transpose();
        };
        response.force.push_back(in_space(now.stress.force));
        response.moment.push_back(in_space(now.stress.moment));
        response.shear.push_back(e * now.stress.shear);
        for (const int node : patch.cells[k])
          response.couple.col(node) += now.volume / E::nodes * frame.normal.cross(response.shear.back());
      }
      return response;
    };
    const auto in_plane = [&](Eigen::Matrix3d A) -> Eigen::Matrix3d {
      A.row(2).setZero(), A.col(2).setZero();
      return turn * A * turn.transpose();
    };
    const Vectors still = Vectors::Zero();

    const Eigen::Matrix3d L = in_plane(shapes.matrix());
    const Response stretched = respond(elastic_plate, L * X, axial_vector<double>(L).replicate(1, 8));
    same(stretched.force), balance(stretched.nodal_force);
    CHECK(stretched.nodal_moment.norm() <= tolerance * stretched.nodal_force.norm());
    CHECK(stretched.area == Approx(1).epsilon(1e-13));

    const Homogeneous sliding{PlaneStress{Elastic{1, 1, 0.3}}, 0.2, Simpson<5>{}, SlidingLayers{}};
    const Response bent = respond(sliding, still, in_plane(shapes.matrix()) * X);
    same(bent.moment), balance(bent.nodal_moment);
    CHECK(bent.nodal_force.norm() <= tolerance * bent.nodal_moment.norm());

    const Eigen::Vector3d normal = turn.col(2), slope = turn * shapes.vector();
    const Vectors turned = (turn.leftCols<2>() * Eigen::Vector2d(shapes.unit(), shapes.unit())).replicate(1, 8);
    const Response sheared = respond(elastic_plate, normal * slope.transpose() * X, turned);
    same(sheared.shear), balance(sheared.nodal_force);
    if (E::projects_shear) {  // the edges give nodes other shares of the couple
      const Eigen::Vector3d left = (sheared.nodal_moment - sheared.couple).rowwise().sum();
      CHECK(left.norm() <= tolerance * sheared.couple.norm());

      const Eigen::Matrix3d curvature = in_plane(symmetric_part(shapes.matrix()).matrix());  // of w = x.curvature x/2
      const Vectors slopes = curvature * X;
      const Vectors sinks = normal * (0.5 * slopes.cwiseProduct(X).colwise().sum());
      Vectors turns;
      for (int i = 0; i < 8; ++i) turns.col(i) = normal.cross(Eigen::Vector3d(slopes.col(i)));
      const Response deflected = respond(elastic_plate, sinks, -turns);
      same(deflected.moment), balance(deflected.nodal_moment);
      for (const auto& shear : deflected.shear) CHECK(shear.norm() <= tolerance * deflected.moment[0].norm());
      CHECK(deflected.nodal_force.norm() <= 10 * tolerance * deflected.nodal_moment.norm());
    } else {
      CHECK((sheared.nodal_moment - sheared.couple).norm() <= tolerance * sheared.couple.norm());
    }
  }
}

/// All laws but that of the step, plate_step_is_safe, which takes longest: element/stable_step.test.cpp has it.
template <class E>
void conforms_as_plate(const E& element) {
  const PlateShapes<E::nodes> shapes(1);
  reproduces_linear_plate_motions(element, shapes);
  rigid_motions_give_no_force(element, elastic_plate, shapes, FiniteRotations::exact);
  forces_and_moments_sum_to_zero(element, metal_plate, shapes);
  creates_no_energy(element, PlateWitness{}, shapes);
  books_its_work(element, metal_plate, shapes);
  lanes_agree<Pack<double, 8>>(element, metal_plate, shapes);
  lanes_agree<Pack<float, 16>>(element, metal_plate, shapes);
  numbering_does_not_matter(element, shapes);
  failed_elements_are_silent(element, brittle_plate, shapes);
  passes_the_plate_patch_tests(element, shapes);
}

}  // namespace strike::testing
