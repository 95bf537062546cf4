#pragma once
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>

namespace strike {

/// The velocity of all nodes, or of those given, at the start. Error: no such node.
class InitialVelocity {
 public:
  explicit InitialVelocity(Eigen::Vector3d velocity) : velocity_(std::move(velocity)), everywhere_(true) {}
  InitialVelocity(Eigen::Vector3d velocity, std::vector<Index> nodes)
      : velocity_(std::move(velocity)), nodes_(std::move(nodes)) {}

  template <class N>
  void begin(N& nodes) const {
    if (everywhere_)
      for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, velocity_.cast<typename N::Number>());
    for (const Index i : nodes_) nodes.check_number(i), nodes.set_velocity(i, velocity_.cast<typename N::Number>());
  }

  template <class Archive>
  void serialize(Archive&) {}

 private:
  Eigen::Vector3d velocity_;
  bool everywhere_ = false;
  std::vector<Index> nodes_;
};

/// The velocity of all nodes at the start by their positions, a function Eigen::Vector3d(const Eigen::Vector3d&).
template <class Field>
class InitialVelocityField {
 public:
  explicit InitialVelocityField(Field field) : field_(std::move(field)) {}

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, field_(nodes.x(i)));
  }

  template <class Archive>
  void serialize(Archive&) {}

 private:
  Field field_;
};

}  // namespace strike
