// Hexahedra of one layer bend: linear static problems, from the stiffness that GlobalStep knows, and plastic ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using Flags = std::array<bool, 3>;

/// Displacements of a linear solid under loads at its nodes.
class Static {
 public:
  Mesh mesh;
  Elastic law;

  Static(Mesh given, const Elastic& elastic) : mesh(std::move(given)), law(elastic), held_(3 * mesh.nodes.size()) {
    load_ = Eigen::VectorXd::Zero(std::ssize(held_));
  }

  /// Holds the components of the displacement that f(x) marks, three flags.
  template <class F>
  void hold(F f) {
    each_component([&](std::size_t i, const Eigen::Vector3d& x, int axis) {
      if (f(x)[std::size_t(axis)]) held_[i] = 1;
    });
  }
  /// The force f(x) at each node.
  template <class F>
  void load(F f) {
    each_component([&](std::size_t i, const Eigen::Vector3d& x, int axis) { load_(Eigen::Index(i)) = f(x)(axis); });
  }

  /// The mean displacement along the axis of the nodes where f(x).
  template <class E, class F>
  double deflection(const E& element, int axis, F f) const {
    const Eigen::VectorXd u = displacements(element);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (f(mesh.nodes[i])) sum += u(Eigen::Index(3 * i) + axis), count += 1;
    return sum / count;
  }

 private:
  template <class F>
  void each_component(F f) const {
    for (std::size_t i = 0; i < held_.size(); ++i) f(i, mesh.nodes[i / 3], int(i % 3));
  }

  template <class E>
  Eigen::VectorXd displacements(const E& element) const {
    const double dt = 1e9;  // the resistance is K dt^2/4, beside which its damping is nothing
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& corners : mesh.hexahedra) {
      Nodal<double, 8> x;
      for (int k = 0; k < 8; ++k) x.col(k) = mesh.nodes[corners[std::size_t(k)]];
      typename E::template State<Elastic, double> state;
      element.begin(state, law, x);
      const auto resistance = element.resistance(state, law, x, Nodal<double, 8>::Zero().eval(), dt);
      const auto place = [&](int i) { return std::size_t(3 * corners[std::size_t(i / 3)] + i % 3); };
      for (int j = 0; j < 24; ++j) {
        Nodal<double, 8> p = Nodal<double, 8>::Zero();
        p(j) = 4 / (dt * dt);
        const Nodal<double, 8> f = resistance(x, p);
        for (int i = 0; i < 24; ++i)
          if (!held_[place(i)] && !held_[place(j)]) entries.emplace_back(place(i), place(j), f(i));
      }
    }
    Eigen::VectorXd f = load_;
    for (std::size_t i = 0; i < held_.size(); ++i)
      if (held_[i]) entries.emplace_back(i, i, 1), f(Eigen::Index(i)) = 0;
    Eigen::SparseMatrix<double> K(load_.size(), load_.size());
    K.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(f);
  }

  std::vector<char> held_;
  Eigen::VectorXd load_;
};

const Hex8 physical{PhysicalHourglass{}, HughesWinget{}, NoBulkViscosity{}};
constexpr double tiny = 1e-9;

/// Deflection of MacNeal and Harder's slender beam (1985), 6 x 0.2 x 0.1 of six elements, by a unit force at its tip in
/// the plane, over the exact one. The edges lean by 45 degrees: shift(k) is that of the upper end of edge k.
template <class F>
double slender_beam(F shift) {
  Static beam(box({.lower = {0, 0, 0}, .size = {6, 0.2, 0.1}, .cells = {6, 1, 1}}), Elastic{1, 1e7, 0.3});
  const auto lean = [&](long k, double y) { return (y > 0.1 ? 0.1 : -0.1) * shift(k); };
  for (auto& x : beam.mesh.nodes) x.x() += lean(std::lround(x.x()), x.y());
  const auto on_edge = [&](long k, const Eigen::Vector3d& x) {
    return std::abs(x.x() - static_cast<double>(k) - lean(k, x.y())) < tiny;
  };
  const auto at_tip = [&](const Eigen::Vector3d& x) { return on_edge(6, x); };
  beam.hold([&](const Eigen::Vector3d& x) -> Flags {
    const bool foot = on_edge(0, x);
    return {foot, foot, foot};
  });
  beam.load([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return {0, at_tip(x) ? 0.25 : 0, 0}; });
  return beam.deflection(physical, 1, at_tip) / 0.1081;
}

}  // namespace

TEST_CASE("bending: a cantilever of one layer of hexahedra deflects as Timoshenko's beam, whatever their aspect") {
  const double L = 40, nu = 0.3, P = 1;
  const double exact = 12 * P * std::pow(L, 3) / 3 + P * L * 2 * (1 + nu) * 6 / 5;
  for (const double aspect : {1.0, 4.0, 10.0}) {
    Static beam(box({.lower = {0, -0.5, -0.5}, .size = {L, 1, 1}, .cells = {Index(L / aspect), 1, 1}}),
                Elastic{1, 1, nu});
    beam.hold([](const Eigen::Vector3d& x) -> Flags {
      const bool foot = x.x() < tiny;
      return {foot, foot && x.y() < 0, foot && x.z() < 0};
    });
    const auto at_tip = [&](const Eigen::Vector3d& x) { return x.x() > L - tiny; };
    beam.load([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return {0, 0, at_tip(x) ? P / 4 : 0}; });
    CAPTURE(aspect);
    CHECK(beam.deflection(physical, 2, at_tip) == Approx(exact).epsilon(0.03));  // seen: .999, .995, .977
  }
}

// Of their mesh of parallelograms the elements at both ends are trapezoids. Those are stiff, as any that pass the patch
// test (MacNeal 1987): the corners of pure bending move in them as in a stretch across. If all edges lean, nothing is
// lost.
TEST_CASE("bending: MacNeal and Harder's slender beam, of bricks, parallelograms and trapezoids") {
  const auto inside = [](long k) { return k > 0 && k < 6; };
  CHECK(slender_beam([](long) { return 0.0; }) == Approx(1).epsilon(0.03));  // seen: .981
  CHECK(slender_beam([](long) { return 1.0; }) == Approx(1).epsilon(0.03));
  CHECK(slender_beam([&](long k) { return inside(k) ? 1.0 : 0.0; }) == Approx(0.625).epsilon(0.01));
  CHECK(slender_beam([&](long k) { return inside(k) ? k % 2 ? 1.0 : -1.0 : 0.0; }) == Approx(0.0475).epsilon(0.02));
}

TEST_CASE("bending: a clamped plate of one layer, a hundredth as thick as wide, deflects as Kirchhoff's") {
  const double t = 0.01, q = 1e-6, D = t * t * t / 12 / (1 - 0.09);
  for (const Index n : {4, 8}) {
    Static quarter(box({.lower = {0, 0, -t / 2}, .size = {0.5, 0.5, t}, .cells = {n, n, 1}}), Elastic{1, 1, 0.3});
    quarter.hold([](const Eigen::Vector3d& x) -> Flags {
      const bool clamped = std::max(x.x(), x.y()) > 0.5 - tiny;
      return {clamped || x.x() < tiny, clamped || x.y() < tiny, clamped};
    });
    const double each = q / 8 / static_cast<double>(n * n);
    quarter.load([&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return {0, 0, each * (x.x() < tiny ? 0.5 : 1) * (x.y() < tiny ? 0.5 : 1)};
    });
    const double w = quarter.deflection(physical, 2, [](const auto& x) { return std::max(x.x(), x.y()) < tiny; });
    CHECK(w == Approx(0.00126532 * q / D).epsilon(0.01));  // Timoshenko and Woinowsky-Krieger 1959; .996, 1.0003
  }
}

TEST_CASE("bending: the pinched cylinder in hexahedra of one layer") {
  const double R = 300, half_length = 300, t = 3, reference = 1.8248e-5;  // MacNeal and Harder 1985
  const auto deflection = [&](Index n) {
    Static octant(box({.lower = {0, 0, -0.5}, .size = {1, 1, 1}, .cells = {n, n, 1}}), Elastic{1, 3e6, 0.3});
    for (auto& x : octant.mesh.nodes) {
      const double angle = x.x() * std::numbers::pi / 2, r = R + t * x.z();
      x = {r * std::sin(angle), half_length * x.y(), r * std::cos(angle)};
    }
    octant.hold([&](const Eigen::Vector3d& x) -> Flags {
      const bool diaphragm = x.y() > half_length - tiny;
      return {diaphragm || x.x() < 1e-6, x.y() < tiny, diaphragm || x.z() < 1e-6};
    });
    const auto pinched = [&](const Eigen::Vector3d& x) { return x.y() < tiny && x.x() < 1e-6; };
    octant.load([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return {0, 0, pinched(x) ? -0.125 : 0}; });
    return -octant.deflection(physical, 2, pinched);
  };
  CHECK(deflection(16) == Approx(0.911 * reference).epsilon(0.005));
  CHECK(deflection(32) == Approx(reference).epsilon(0.02));  // seen: .989
}
