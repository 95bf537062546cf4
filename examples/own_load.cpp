// A load, a failure law, a removal law and an observer of your own: a pulse runs through a bar and tears off its end.
//
//   bash examples/run own_load
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

/// A load: a pulse of pressure p exp(-t/t0) on nodes that share an area equally, along -z.
class Pulse {
 public:
  Pulse(double pressure, double duration, double area, std::vector<Index> nodes)
      : pressure_(pressure), duration_(duration), area_(area), nodes_(std::move(nodes)) {}

  template <class N>
  void begin(const N& nodes) const {
    for (const Index i : nodes_) nodes.check_number(i);  // an Error where there is no such node
  }
  template <class N>
  void apply_loads(N& nodes, double time) {
    force_.z() = -pressure_ * std::exp(-time / duration_) * area_ / static_cast<double>(nodes_.size());
    for (const Index i : nodes_) nodes.add_force(i, force_);
  }
  template <class N>
  double power(const N& nodes) const {
    double sum = 0;
    for (const Index i : nodes_) sum += force_.dot(nodes.v(i));
    return sum;
  }

 private:
  double pressure_, duration_, area_;  // [stress], [time], [length^2]
  std::vector<Index> nodes_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
};

/// A failure law: a point fails where its mean stress reaches the strength.
struct Spall {
  double strength;  ///< [stress]

  template <class T>
  struct State {
    T intact{1.0};  // 1, or 0 once failed
  };
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return trace(state.stress) > 3 * strength;
  }
};

/// A removal law: an element goes when its shape is strained too far.
struct Torn {
  double strain;  ///< equivalent [1]

  static constexpr bool needs_geometric_strain = true;
  auto keeps(const auto&, const auto& element) const { return element.geometric_strain() < strain; }
};

/// An observer: follows the speed of a free surface until it has fallen from its peak and rises again.
struct PullBack {
  Index node;
  double peak = 0, least = 0;  ///< [velocity]
  bool rises = false;

  void operator()(const auto& run) {
    const double speed = -run.nodes().v(node).z();
    if (speed > peak) peak = least = speed;
    least = std::min(least, speed);
    rises = peak > 1 && least < 0.9 * peak && speed > least + 0.1 * peak;
  }
  bool stops() const { return rises; }
};

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    options.check();
    // Millimetres, milliseconds, kilograms; so kN, GPa and J. A bar of aluminium that cannot widen, as in a plate.
    const double density = 2.7e-6, K = 76, G = 26, M = K + 4 * G / 3, c = std::sqrt(M / density);
    const double pressure = 2, duration = 2e-3, strength = 0.8, length = 20;
    const Mesh bar = box({.size = {1, 1, length}, .cells = {1, 1, 400}});
    const auto all = all_nodes(bar.nodes), struck = nodes_where(bar.nodes, on_plane(Axis::z, length));

    Explicit run{Scene{bar.nodes,
                       Part{Hex8{}, Solid{LinearEos{density, K}, ElasticStrength{G}, Spall{strength}}, bar.hexahedra,
                            Torn{.strain = 0.4}},
                       Pulse{pressure, duration, 1.0, struck}, Symmetry{Axis::x, all}, Symmetry{Axis::y, all}}};
    PullBack surface{.node = nearest_node(bar.nodes, {0, 0, 0})};
    run.until(0.01, surface);
    run.until(run.time() + 1e-3);  // until it is torn off

    const auto alive = run.part<0>().alive();
    const auto first = static_cast<double>(std::find(alive.begin(), alive.end(), false) - alive.begin());
    const double stress = strength * M / K;                 // along the bar, where the mean stress is the strength
    const double arrived = surface.peak * density * c / 2;  // of the pulse, whose front bulk viscosity has rounded
    Results results;
    results.add({"thickness torn off", first * length / 400, "mm",
                 0.5 * c * duration * std::log(arrived / (arrived - stress)), 0.3, "c t0/2 ln(p/(p - s))"});
    results.add({"peak speed", surface.peak, "mm/ms", 2 * pressure / (density * c), 15, "2 p/(rho c)"});
    results.add({"pull-back", surface.peak - surface.least, "mm/ms", 2 * stress / (density * c), 10, "2 s/(rho c)"});
    results.add({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
    results.print(), results.write("results.csv");
  });
}
