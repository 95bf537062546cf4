#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "problems/two_bars.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::two_bars;

TEST_CASE("two equal bars exchange their velocities after 2 L/c under rho c v/2") {
  const double v = 1;
  const Bars bars(40);
  const double area = bars.width * bars.width, m = rho * L * area;
  struct Meeting {
    double stress, time, velocity, drift, lost;
  };
  const auto meet = [&](auto... policies) {
    auto run = bars.run(v / 2, -v / 2, 0, {.step_factor = 0.9},
                        Contact{TwoWay{Surface{bars.end(false)}, Surface{bars.end(true)}}, policies...});
    Meeting meeting{};
    double impulse = 0;
    run.until(2.6 * L / c, [&] {
      const double stress = -run.template item<1>().force().x() / (0.5 * rho * c * v * area);
      if (stress > 0.5) meeting.time = run.time() * c / (2 * L);
      impulse = -run.template item<1>().impulse().x();
      if (run.time() < 2.5 * L / c) meeting.drift = std::max(meeting.drift, std::abs(run.energy().error()));
    });
    meeting.stress = impulse / (0.5 * rho * c * v * area * 2 * L / c);
    for (Index i = 0; i < bars.first_right; ++i) meeting.velocity += run.nodes().mass(i) * run.nodes().v(i).x();
    meeting.velocity /= -0.5 * m * v;
    meeting.lost = run.energy().contact / run.energy().initial;
    CHECK(std::abs(run.momentum().x()) < 1e-10 * m * v);
    CHECK(meeting.drift < 1e-4);
    return meeting;
  };
  for (const Meeting& exact : {meet(), meet(Kinematic{1})}) {
    CHECK(exact.stress == Approx(1).epsilon(0.01));
    CHECK(exact.time == Approx(1).epsilon(0.02));
    CHECK(exact.velocity == Approx(1).epsilon(0.02));
    CHECK(exact.lost == Approx(1.0 / (2 * 40)).epsilon(1e-6));  // the end nodes' part of the energy
  }
  // A spring of 0.5 m*/dt^2 is that of some 7 elements: it takes 3 h/c to load and as long to unload.
  const Meeting soft = meet(Penalty{});
  CHECK(soft.stress == Approx(1).epsilon(0.01));
  CHECK(soft.time == Approx(1).epsilon(0.06));
  CHECK(soft.velocity == Approx(1).epsilon(0.02));
  CHECK(std::abs(soft.lost) < 1e-3);
}

namespace {

/// The stable step of a chain of n elements in units of h/c, by its highest frequency: a spring f E A/h holds its end
/// or its middle.
double step_of_chain(int n, double f, bool in_the_middle) {
  const int size = in_the_middle ? 2 * n + 2 : n + 1;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd m = Eigen::VectorXd::Zero(size);
  const auto spring = [&](int i, int j, double k) { K(i, i) += k, K(j, j) += k, K(i, j) -= k, K(j, i) -= k; };
  for (int i = 0; i + 1 < size; ++i) {
    if (i == n) continue;  // between the bars
    spring(i, i + 1, 1);
    m[i] += 0.5, m[i + 1] += 0.5;
  }
  if (in_the_middle)
    spring(n, n + 1, f);
  else
    K(n, n) += f;
  const Eigen::VectorXd scale = m.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd A = scale.asDiagonal() * K * scale.asDiagonal();
  return 2 /
         std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
}

}  // namespace

TEST_CASE("the step with a spring between bars is that of the exact chain") {
  const Bars bars(30);
  const double h = bars.h, area = bars.width * bars.width;
  const double f[] = {0.1, 0.5, 1, 2, 4, 10};
  const double wall[] = {0.9988, 0.9717, 0.9102, 0.7862, 0.6248, 0.4254},
               bar[] = {0.9951, 0.9102, 0.7862, 0.6248, 0.4698, 0.3084};
  for (int i = 0; i < 6; ++i) {
    const Penalty law{.stiffness = f[i] * E * area / h / 4};
    const auto to_bar = [&] { return Contact{NodeToSurface{bars.end_nodes(false), Surface{bars.end(true)}}, law}; };
    const auto to_walls = [&] {
      const std::vector<Index> ends = bars.end_nodes(false);
      return Contact{NodeToRigid{ends, RigidPlane{{0, 0, 0}, {-1, 0, 0}}}, law};
    };
    const double dt_bar = bars.run(0.5, -0.5, 0, {}, to_bar()).stable_step().dt,
                 dt_wall = bars.run(0.5, -0.5, 0, {}, to_walls()).stable_step().dt;
    CHECK(dt_bar * c / h == Approx(bar[i]).margin(1e-4));
    CHECK(dt_wall * c / h == Approx(wall[i]).margin(1e-4));
    CHECK(stable_step_with_contact(1, 2 * f[i]) == Approx(step_of_chain(60, f[i], false)).epsilon(1e-6));
    CHECK(stable_step_with_contact(1, 4 * f[i]) == Approx(step_of_chain(60, f[i], true)).epsilon(1e-6));
  }
}
