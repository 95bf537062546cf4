// A brick of steel with a stress locked into it turns rigidly through ten revolutions: its stress turns with it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Metres, seconds, kilograms.
constexpr double edge = 0.1, revolutions = 10, rate = 5000, locked_in = 200e6;

/// Steel that begins with a tension along x.
struct Strained : Elastic {
  template <class T>
  void begin(State<T>& state) const {
    state.stress.xx = T(locked_in);
  }
};

/// Turns every node about a skew axis through the origin.
class Turn {
 public:
  explicit Turn(std::vector<Eigen::Vector3d> X) : X_(std::move(X)) {}

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, rate * axis().cross(X_[i]));
  }
  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger&) const {
    const Eigen::Matrix3d change = (turned(step.time + step.dt) - turned(step.time)) / step.dt;
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, change * X_[i]);
  }

 private:
  static Eigen::Vector3d axis() { return Eigen::Vector3d(1, 2, 3).normalized(); }
  static Eigen::Matrix3d turned(double time) { return Eigen::AngleAxisd(rate * time, axis()).toRotationMatrix(); }
  std::vector<Eigen::Vector3d> X_;
};

constexpr auto turn = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{2} << setting.mesh;
  const Mesh brick = box({.size = {edge, edge, edge}, .cells = {n, n, n}});
  const Strained steel{{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3}};
  ExplicitOptions options = setting.options;
  options.energy_tolerance = std::numeric_limits<double>::infinity();  // the motion is given, whatever the forces do
  Explicit run{Scene{brick.nodes, Part{element, steel, brick.hexahedra}, Turn{brick.nodes}}, options, numbers};
  const double seconds = cpu_seconds([&] { run.until(revolutions * 2 * std::numbers::pi / rate); });

  const auto& part = run.template part<0>();
  const std::vector<double> drift = part.field([](const auto& state) {
    auto change = state.stress;
    change.xx -= locked_in;
    return sqrt(double_dot(change, change));
  });
  return {.error = *std::max_element(drift.begin(), drift.end()) / locked_in,
          .seconds = seconds,
          .steps = run.steps(),
          .elements = brick.hexahedra.size()};
};

}  // namespace

Problem spin() {
  return problem({.name = "spin",
                  .title = "Stressed brick in ten revolutions",
                  .error = "stress against the one that it began with, largest norm of the difference",
                  .meshes = {"2 x 2 x 2", "4 x 4 x 4", "8 x 8 x 8", "16 x 16 x 16"}},
                 turn, usual, elements, numbers, step_factors, rotations);
}

}  // namespace trade
