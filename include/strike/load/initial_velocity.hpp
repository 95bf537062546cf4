#pragma once
#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
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
/// the plates around a node move as one rigid body, it gets their spin as its angular velocity; elsewhere it does not
/// turn. Error: a velocity that is not finite.
template <class Field>
class InitialVelocityField {
 public:
  explicit InitialVelocityField(Field field) : field_(std::move(field)) {}

  template <class N>
    requires(!N::nodes_turn)
  void begin(N& nodes) const {
    set_velocities(nodes);
  }
  template <class N>
    requires(N::nodes_turn)
  void begin(N& nodes, std::span<const PartFaces> parts) const {
    set_velocities(nodes);
    set_spins(nodes, parts);
  }

  template <class Archive>
  void serialize(Archive&) {}

 private:
  template <class N>
  void set_velocities(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const typename N::Vector v = field_(nodes.x(i));
      const Eigen::Vector3d value = v.template cast<double>();
      if (!value.allFinite())
        throw Error(detail::joined({"strike: the velocity that an InitialVelocityField gives node ", std::to_string(i),
                                    " at ", detail::text(Eigen::Vector3d(nodes.x(i).template cast<double>())), " is ",
                                    detail::text(value), "; it must be finite."}));
      nodes.set_velocity(i, v);
    }
  }
  /// Angular velocities of the nodes all of whose plates move as one rigid body.
  template <class N>
  static void set_spins(N& nodes, std::span<const PartFaces> parts) {
    constexpr double rounding = 1e3 * static_cast<double>(std::numeric_limits<RealOf<typename N::Number>>::epsilon());
    std::vector<Eigen::Vector3d> spin(nodes.size(), Eigen::Vector3d::Zero());
    std::vector<char> turns(nodes.size(), 0), is_rigid(nodes.size(), 1);
    const auto look = [&](const Face& plate) {
      const PlateMotion motion = motion_of(plate, nodes);
      const double turned = motion.spin.norm() * motion.size;
      const bool moves_rigidly =
          motion.strained <= std::max(1e-6, rounding) * turned + rounding * 1e-2 * motion.fastest;
      for (std::size_t k = 0; k < corners_of(plate); ++k) {
        const Index i = plate.nodes[k];
        const bool agrees =
            !turns[i] || (spin[i] - motion.spin).norm() * motion.size <= 1e-6 * turned + rounding * motion.fastest;
        is_rigid[i] = is_rigid[i] && moves_rigidly && agrees;
        spin[i] = motion.spin, turns[i] = 1;
      }
    };
    for (const PartFaces& part : parts)
      if (part.thickness > 0) std::for_each(part.faces.begin(), part.faces.end(), look);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (turns[i] && is_rigid[i]) nodes.set_angular_velocity(i, spin[i].template cast<typename N::Number>());
  }

  /// The motion of a rigid body that is nearest to that of a plate's corners.
  struct PlateMotion {
    Eigen::Vector3d spin;            // [1/time]
    double size, strained, fastest;  // of the plate [length]; what is left of the velocities, the largest of them
  };
  static std::size_t corners_of(const Face& plate) { return plate.is_triangle() ? 3 : 4; }
  /// sum of (d.d I - d d^T) w = sum of d x v, of corners that are d and move by v from their mean.
  template <class N>
  static PlateMotion motion_of(const Face& plate, const N& nodes) {
    const auto own = static_cast<Eigen::Index>(corners_of(plate));
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 4> d(3, own), v(3, own);
    for (Eigen::Index k = 0; k < own; ++k) {
      const Index i = plate.nodes[static_cast<std::size_t>(k)];
      d.col(k) = nodes.x(i).template cast<double>(), v.col(k) = nodes.v(i).template cast<double>();
    }
    const double fastest = v.cwiseAbs().maxCoeff();
    d.colwise() -= d.rowwise().mean().eval(), v.colwise() -= v.rowwise().mean().eval();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < own; ++k) moment += d.col(k).cross(v.col(k));
    const Eigen::Matrix3d inertia = d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
    const Eigen::Vector3d spin = inertia.ldlt().solve(moment);
    for (Eigen::Index k = 0; k < own; ++k) v.col(k) -= spin.cross(d.col(k));
    return {spin, d.norm(), v.norm(), fastest};
  }

  Field field_;
};

}  // namespace strike
