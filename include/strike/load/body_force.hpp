#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/range.hpp>

namespace strike {

/// A body force such as gravity: an acceleration of all nodes [length/time^2] times a history.
template <class History = Constant>
class BodyForce {
 public:
  using LoadHistory = History;

  explicit BodyForce(Eigen::Vector3d acceleration, History history = {})
      : acceleration_(std::move(acceleration)), history_(std::move(history)) {}

  void ranges(const auto& number) const {
    number("acceleration", acceleration_, range::point);
    number(history_);
  }

  template <class N>
  void apply_loads(N& nodes, double time) {
    now_ = history_(time) * acceleration_;
    const auto g = N::padded(now_.cast<typename N::Number>());
    nodes.each_known_place([&](std::size_t k) { nodes.force()[k] += nodes.mass()[k] * g; });
    for (RigidMotion& body : nodes.bodies()) body.accelerate(now_);
  }
  template <class N>
  double power(const N& nodes) const {
    double power =
        now_.dot(nodes.sum([&](std::size_t k) { return Padded<double>(nodes.mass()[k] * nodes.velocity()[k]); }));
    for (const RigidMotion& body : nodes.bodies()) power += body.power_beside_nodes(now_);
    return power;
  }

  /// None: of all nodes a process sees to those that it knows.
  std::vector<Index> nodes_named() const { return {}; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(now_);
  }

 private:
  Eigen::Vector3d acceleration_, now_ = Eigen::Vector3d::Zero();
  History history_;
};

}  // namespace strike
