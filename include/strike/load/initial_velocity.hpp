#pragma once
#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// A rotation about an axis through a point.
struct Spin {
  Eigen::Vector3d angular_velocity;                  ///< [1/time]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< a point of the axis [length]

  void ranges(const auto& number) const {
    number("angular_velocity", angular_velocity, range::point);
    number("centre", centre, range::point);
  }
};

/// The velocity of all nodes, or of those given, at the start; with a Spin that of a rigid body, plates too. Error: no
/// such node.
///   InitialVelocity{{0, 0, -200}, nodes}      InitialVelocity{{0, 0, -200}, Spin{{50, 0, 0}, centre}, nodes}
class InitialVelocity {
 public:
  explicit InitialVelocity(Eigen::Vector3d velocity) : velocity_(std::move(velocity)), everywhere_(true) {}
  InitialVelocity(Eigen::Vector3d velocity, std::vector<Index> nodes)
      : velocity_(std::move(velocity)), nodes_(std::move(nodes)) {}
  template <std::same_as<Spin> S>
  InitialVelocity(Eigen::Vector3d velocity, const S& spin)
      : velocity_(std::move(velocity)), spin_(spin), everywhere_(true) {}
  template <std::same_as<Spin> S>
  InitialVelocity(Eigen::Vector3d velocity, const S& spin, std::vector<Index> nodes)
      : velocity_(std::move(velocity)), spin_(spin), nodes_(std::move(nodes)) {}

  void ranges(const auto& number) const {
    number("velocity", velocity_, range::point);
    if (spin_) number(*spin_);
  }

  template <class N>
  void begin(N& nodes) const {
    if (everywhere_)
      for (std::size_t i = 0; i < nodes.size(); ++i) set(nodes, i);
    for (const Index i : nodes_) nodes.check_number(i), set(nodes, i);
  }

  template <class Archive>
  void serialize(Archive&) {}

 private:
  template <class N>
  void set(N& nodes, std::size_t i) const {
    using Number = typename N::Number;
    if (!spin_) return nodes.set_velocity(i, velocity_.cast<Number>());
    const Eigen::Vector3d from_centre = nodes.x(i).template cast<double>() - spin_->centre,
                          v = velocity_ + cross<double>(spin_->angular_velocity, from_centre);
    nodes.set_velocity(i, v.cast<Number>());
    if constexpr (N::nodes_turn) nodes.set_angular_velocity(i, spin_->angular_velocity.cast<Number>());
  }

  Eigen::Vector3d velocity_;
  std::optional<Spin> spin_;
  bool everywhere_ = false;
  std::vector<Index> nodes_;
};

/// The velocity of all nodes at the start by their positions, a function Eigen::Vector3d(const Eigen::Vector3d&). Where
/// it is that of a rigid body about a node, plates get the spin as their angular velocity; elsewhere they do not turn.
/// Error: a velocity that is not finite.
template <class Field>
class InitialVelocityField {
 public:
  explicit InitialVelocityField(Field field) : field_(std::move(field)) {}

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const typename N::Vector v = field_(nodes.x(i));
      const Eigen::Vector3d value = v.template cast<double>();
      if (!value.allFinite())
        throw Error(detail::joined({"strike: the velocity that an InitialVelocityField gives node ", std::to_string(i),
                                    " at ", detail::text(Eigen::Vector3d(nodes.x(i).template cast<double>())), " is ",
                                    detail::text(value), "; it must be finite."}));
      nodes.set_velocity(i, v);
    }
    if constexpr (N::nodes_turn) turn(nodes);
  }

  template <class Archive>
  void serialize(Archive&) {}

 private:
  /// Central differences over a thousandth of the scene, exact for a rigid motion but for rounding.
  template <class N>
  void turn(N& nodes) const {
    std::vector<Eigen::Vector3d> all;
    for (std::size_t i = 0; i < nodes.size(); ++i) all.push_back(nodes.x(i).template cast<double>());
    const double h = 1e-3 * extent(all);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Eigen::Matrix3d gradient;
      for (int c = 0; c < 3; ++c) {
        const Eigen::Vector3d way = h * unit(Axis{c});
        const auto at = [&](const Eigen::Vector3d& x) {
          return Eigen::Vector3d(
              typename N::Vector(field_(typename N::Vector(x.cast<typename N::Number>()))).template cast<double>());
        };
        gradient.col(c) = (at(all[i] + way) - at(all[i] - way)) / (2 * h);
      }
      const Eigen::Matrix3d rotation = 0.5 * (gradient - gradient.transpose());
      const double turned = rotation.norm(), strained = (gradient - rotation).norm();
      if (turned > 0 && strained < 1e-6 * turned)
        nodes.set_angular_velocity(
            i, Eigen::Vector3d(rotation(2, 1), rotation(0, 2), rotation(1, 0)).cast<typename N::Number>());
    }
  }

  Field field_;
};

}  // namespace strike
