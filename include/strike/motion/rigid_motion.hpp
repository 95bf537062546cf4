#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/inertia.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The motion of nodes that are fixed to each other: their place and orientation at the time n, their velocity and
/// their angular momentum about the centre of mass half a step later. What is free keeps its angular momentum to the
/// last bit and its energy to rounding, however far it turns in a step.
class RigidMotion {
 public:
  RigidMotion() = default;
  /// Nodes at these places; one without extent about an axis does not turn about it. What turns about a point, which
  /// does not move, has its moments about that.
  RigidMotion(std::vector<Index> nodes, std::span<const Eigen::Vector3d> places, const Inertia& inertia,
              const std::optional<Eigen::Vector3d>& pivot = {})
      : nodes_(std::move(nodes)), mass_(inertia.mass), is_pinned_(pivot), centre_(pivot.value_or(inertia.centre)) {
    for (const Eigen::Vector3d& x : places) places_.push_back(x - centre_);
    to_mass_ = inertia.centre - centre_;
    inertia_ = not_singular(inertia.moment + mass_ * Inertia::about(to_mass_), mass_);
    inverse_ = inverse(inertia_);
  }

  const std::vector<Index>& nodes() const { return nodes_; }
  double mass() const { return mass_; }
  /// Its centre of mass, or the point about which it turns.
  const Eigen::Vector3d& centre() const { return centre_; }
  const Eigen::Vector3d& velocity() const { return velocity_; }
  bool is_pinned() const { return is_pinned_; }
  Eigen::Vector3d momentum() const {
    return mass_ * (velocity_ + cross(angular_velocity(), times<double>(rotation_, to_mass_)));
  }
  Eigen::Vector3d angular_velocity() const { return turned(inverse_, angular_momentum_); }
  /// About the centre.
  const Eigen::Vector3d& angular_momentum() const { return angular_momentum_; }
  /// The rotation since the start.
  const Eigen::Matrix3d& rotation() const { return rotation_; }
  double kinetic_energy() const {
    return 0.5 * (mass_ * velocity_.squaredNorm() + angular_momentum_.dot(angular_velocity()));
  }
  /// The velocity of the point at x.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& x) const {
    return velocity_ + cross(angular_velocity(), Eigen::Vector3d(x - centre_));
  }
  /// The changes of its velocity and of its angular velocity by an impulse and one of moment, whose parts along its
  /// guides these take.
  Eigen::Vector3d velocity_by(Eigen::Vector3d impulse) const {
    for (const Eigen::Vector3d& d : directions_) impulse -= d.dot(impulse) * d;
    return impulse / mass_;
  }
  Eigen::Vector3d spin_by(const Eigen::Vector3d& of_moment) const {
    return turned(inverse_, of_moment + held_back(turned(inverse_, of_moment)));
  }
  /// The velocity that an impulse and one of moment give the points on which they act, along themselves.
  double response(const Eigen::Vector3d& impulse, const Eigen::Vector3d& of_moment) const {
    return impulse.dot(velocity_by(impulse)) + of_moment.dot(spin_by(of_moment));
  }
  /// No smaller than what an impulse changes the velocity of a point at this distance from the centre [1/mass].
  double largest_response(double distance) const { return largest_response(1, distance); }
  /// The same of an impulse and one of moment of these sizes, as if no guide took a part.
  double largest_response(double impulse, double of_moment) const {
    return impulse * impulse / mass_ + of_moment * of_moment * trace(inverse_);
  }
  /// The same as largest_response(distance), less what guides take in every direction.
  double largest_guided_response(double distance) const {
    return largest_response(directions_.size() < 3 ? 1 : 0, axes_.size() < 3 ? distance : 0);
  }

  void set(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity) {
    velocity_ = velocity, angular_momentum_ = turned(inertia_, angular_velocity);
  }
  /// Directions along which it moves as told, and axes about which it turns so: unit vectors, each at right angles to
  /// those before it.
  void guide(std::vector<Eigen::Vector3d> directions, std::vector<Eigen::Vector3d> axes) {
    directions_ = std::move(directions), axes_ = std::move(axes);
  }
  const std::vector<Eigen::Vector3d>& directions() const { return directions_; }
  const std::vector<Eigen::Vector3d>& axes() const { return axes_; }
  /// An impulse through the centre of mass, and one of moment.
  void push(const Eigen::Vector3d& impulse, const Eigen::Vector3d& of_moment) {
    velocity_ += impulse / mass_, angular_momentum_ += of_moment;
  }
  /// The impulses along the directions, and of moment about the axes, that give it these velocities along them.
  std::array<double, 3> impulses_along(std::span<const double> velocities) const {
    std::array<double, 3> impulses{};
    for (std::size_t i = 0; i < directions_.size(); ++i)
      impulses[i] = mass_ * (velocities[i] - directions_[i].dot(velocity_));
    return impulses;
  }
  std::array<double, 3> moments_about(std::span<const double> rates) const {
    std::array<double, 3> missing{};
    const Eigen::Vector3d w = angular_velocity();
    for (std::size_t i = 0; i < axes_.size(); ++i) missing[i] = rates[i] - axes_[i].dot(w);
    return moments_for(missing);
  }
  /// An impulse and one of moment, less the parts that its guides take and that it sums up until they are asked for.
  void push_guided(const Eigen::Vector3d& impulse, const Eigen::Vector3d& of_moment) {
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& d : directions_) along -= d.dot(impulse) * d;
    const Eigen::Vector3d about = held_back(turned(inverse_, of_moment));
    push(impulse + along, of_moment + about);
    by_guides_ += along, moment_by_guides_ += about;
  }
  /// The impulses that the guides have taken since this was asked.
  std::pair<Eigen::Vector3d, Eigen::Vector3d> take_guided() {
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    return {std::exchange(by_guides_, none), std::exchange(moment_by_guides_, none)};
  }

  /// The part of its own mass that those of its nodes lack, and that mass times its way from the centre, at the start.
  void set_beside_nodes(double mass, const Eigen::Vector3d& first_moment) {
    mass_beside_ = mass, first_moment_ = first_moment;
  }
  /// A body force acts on that too, with this acceleration, until the loads are cleared; and the power that it has, of
  /// the velocities before it pushes the body and after it.
  void clear_loads() {
    force_beside_.setZero(), moment_beside_.setZero();
    first_moment_now_ = times<double>(rotation_, first_moment_), spin_of_loads_ = angular_velocity();
  }
  void accelerate(const Eigen::Vector3d& a) {
    force_beside_ += mass_beside_ * a, moment_beside_ += cross(first_moment_now_, a);
  }
  double power_beside_nodes(const Eigen::Vector3d& a) const {
    return mass_beside_ * a.dot(velocity_) + cross(first_moment_now_, a).dot(spin_of_loads_);
  }
  double power_beside_nodes() const { return force_beside_.dot(velocity_) + moment_beside_.dot(spin_of_loads_); }
  const Eigen::Vector3d& force_beside_nodes() const { return force_beside_; }
  const Eigen::Vector3d& moment_beside_nodes() const { return moment_beside_; }

  /// Takes note of its velocities half a step ago: what it has beyond them forces and guides have given.
  void note_kick(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity) {
    kick_ = velocity_ - velocity, spin_of_kick_ = this->angular_velocity() - angular_velocity;
  }
  Eigen::Vector3d kicked_at(const Eigen::Vector3d& x) const {
    return kick_ + cross(spin_of_kick_, Eigen::Vector3d(x - centre_));
  }

  /// Moves over the step dt with its velocities; where axes hold the rotation at these rates, the moments about them
  /// that this takes change its angular momentum, and their work is returned.
  double move(double dt, std::span<const double> rates = {}) {
    centre_before_ = centre_, rotation_before_ = rotation_, spin_before_ = angular_velocity(), dt_ = dt;
    spin_of_loads_ = spin_before_;
    centre_ += dt * velocity_;
    return axes_.empty() ? (turn_freely(dt), 0.0) : turn_about(rates, dt);
  }
  /// The place of its node k, and the velocity that has brought it there in the last step.
  Eigen::Vector3d place(std::size_t k) const { return centre_ + times<double>(rotation_, places_[k]); }
  Eigen::Vector3d way_per_time(std::size_t k) const {
    const Eigen::Matrix3d change = rotation_ - rotation_before_;
    return (centre_ - centre_before_) / dt_ + times<double>(change, places_[k]) / dt_;
  }
  Eigen::Vector3d mean_angular_velocity() const { return 0.5 * (spin_before_ + angular_velocity()); }
  void stop() { velocity_.setZero(), angular_momentum_.setZero(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
    archive(centre_, velocity_, angular_momentum_, rotation_);
    archive(force_beside_, moment_beside_, first_moment_now_, spin_of_loads_);
  }
  /// The axis about which there is no inertia, if it is but one.
  static std::optional<Eigen::Vector3d> axis_without_inertia(const SymmetricTensor<double>& A) {
    const double size = trace(A);
    if (!(size > 0) || determinant(A) > 1e-12 * size * size * size) return {};
    const Eigen::Vector3d x(A.xx, A.xy, A.zx), y(A.xy, A.yy, A.yz), z(A.zx, A.yz, A.zz);
    Eigen::Vector3d line = cross(x, y);
    for (const Eigen::Vector3d& other : {cross(y, z), cross(z, x)})
      if (other.squaredNorm() > line.squaredNorm()) line = other;
    return line.normalized();
  }

 private:
  /// The impulses of moment about the axes that change the angular velocity by this along them.
  std::array<double, 3> moments_for(const std::array<double, 3>& missing) const {
    std::array<std::array<double, 4>, 3> rows{};  // Gauss, of a matrix that is positive definite
    const std::size_t n = axes_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) rows[i][j] = axes_[i].dot(turned(inverse_, axes_[j]));
      rows[i][3] = missing[i];
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (j != i) {
          const double factor = rows[j][i] / rows[i][i];
          for (std::size_t k = i; k < 4; ++k) rows[j][k] -= factor * rows[i][k];
        }
    std::array<double, 3> moments{};
    for (std::size_t i = 0; i < n; ++i) moments[i] = rows[i][3] / rows[i][i];
    return moments;
  }
  /// The impulse of moment by which the axes take a change of the angular velocity about them.
  Eigen::Vector3d held_back(const Eigen::Vector3d& spin) const {
    std::array<double, 3> missing{};
    for (std::size_t i = 0; i < axes_.size(); ++i) missing[i] = -axes_[i].dot(spin);
    const std::array<double, 3> moments = moments_for(missing);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < axes_.size(); ++i) sum += moments[i] * axes_[i];
    return sum;
  }

  /// A x, with A given in the axes of the body.
  Eigen::Vector3d turned(const SymmetricTensor<double>& A, const Eigen::Vector3d& x) const {
    return times<double>(rotation_, A * in_body(x));
  }
  Eigen::Vector3d in_body(const Eigen::Vector3d& x) const {
    return {column(rotation_, 0).dot(x), column(rotation_, 1).dot(x), column(rotation_, 2).dot(x)};
  }

  /// Of a line of nodes, or of one: what does not turn about an axis may have any inertia about it.
  static SymmetricTensor<double> not_singular(SymmetricTensor<double> A, double mass) {
    const double size = trace(A);
    if (!(size > 0)) return SymmetricTensor<double>::isotropic(mass);
    const std::optional<Eigen::Vector3d> line = axis_without_inertia(A);
    return line ? A + size * outer_square<double>(*line) : A;
  }

  /// Euler's equations by steps of the implicit midpoint (Austin, Krishnaprasad and Wang 1993, J. Comput. Phys. 107,
  /// 105), which keep energy and angular momentum, composed to the sixth order (Yoshida 1990, Phys. Lett. A 150, 262,
  /// solution A).
  void turn_freely(double dt) {
    constexpr double w1 = -1.17767998417887, w2 = 0.235573213359357, w3 = 0.784513610477560,
                     w0 = 1 - 2 * (w1 + w2 + w3);
    if (!(angular_momentum_.squaredNorm() > 0)) return;
    for (const double part : {w3, w2, w1, w0, w1, w2, w3}) {
      const double h = part * dt;
      const Eigen::Vector3d begin = in_body(angular_momentum_);
      Eigen::Vector3d middle = begin, spin = inverse_ * middle;
      for (int iteration = 0; iteration < 60; ++iteration) {
        const Eigen::Vector3d before = middle;
        middle = begin + (0.5 * h) * cross(middle, spin);
        spin = inverse_ * middle;
        if (!((middle - before).squaredNorm() > 1e-33 * begin.squaredNorm())) break;
      }
      const auto turn = HughesWinget{}.turn<double>(h * spin);  // Cayley's map
      rotation_ = product(rotation_, turn.Q);
    }
    make_orthogonal();
  }

  /// The midpoint of angular velocities that the axes hold at the start and the end.
  double turn_about(std::span<const double> rates, double dt) {
    const Eigen::Matrix3d R = rotation_;
    const Eigen::Vector3d L = angular_momentum_, start = angular_velocity();
    Eigen::Vector3d end = start;
    double work = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      const Eigen::Vector3d before = end;
      rotation_ = product(rotated_by(0.5 * dt * (start + end)), R);
      angular_momentum_ = L;
      const std::array<double, 3> moments = moments_about(rates);
      work = 0;
      for (std::size_t i = 0; i < axes_.size(); ++i)
        angular_momentum_ += moments[i] * axes_[i], work += moments[i] * rates[i];
      end = angular_velocity();
      if (!((end - before).squaredNorm() > 1e-32 * start.squaredNorm())) break;
    }
    make_orthogonal();
    return work;
  }
  /// exp of the cross product with w (Rodrigues).
  static Eigen::Matrix3d rotated_by(const Eigen::Vector3d& w) {
    const double angle = w.norm(), half = 0.5 * angle;
    const double sine = angle > 1e-8 ? std::sin(half) / half : 1 - half * half / 6;
    const double a = angle > 1e-8 ? std::sin(angle) / angle : 1 - angle * angle / 6, b = 0.5 * sine * sine;
    const double x = w(0), y = w(1), z = w(2);
    return columns<double>({1 - b * (y * y + z * z), b * x * y + a * z, b * z * x - a * y},
                           {b * x * y - a * z, 1 - b * (z * z + x * x), b * y * z + a * x},
                           {b * z * x + a * y, b * y * z - a * x, 1 - b * (x * x + y * y)});
  }
  static Eigen::Matrix3d product(const Eigen::Matrix3d& A, const Eigen::Matrix3d& B) {
    return columns<double>(times<double>(A, column(B, 0)), times<double>(A, column(B, 1)),
                           times<double>(A, column(B, 2)));
  }
  /// R (3 I - R^T R)/2, against rounding.
  void make_orthogonal() {
    Eigen::Matrix3d correction;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        correction(static_cast<int>(i), static_cast<int>(j)) =
            (i == j ? 1.5 : 0.0) - 0.5 * column(rotation_, i).dot(column(rotation_, j));
    rotation_ = product(rotation_, correction);
  }

  std::vector<Index> nodes_;
  std::vector<Eigen::Vector3d> places_;                // of the nodes, in the axes of the body, from its centre
  Eigen::Vector3d to_mass_ = Eigen::Vector3d::Zero();  // from the centre to that of mass, in the axes of the body
  double mass_ = 0;
  bool is_pinned_ = false;
  std::vector<Eigen::Vector3d> directions_, axes_;
  SymmetricTensor<double> inertia_, inverse_;  // in the axes of the body, those of the scene at the start
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero(),
                  angular_momentum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d centre_before_ = Eigen::Vector3d::Zero(), spin_before_ = Eigen::Vector3d::Zero();  // of the last step
  Eigen::Matrix3d rotation_before_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d kick_ = Eigen::Vector3d::Zero(), spin_of_kick_ = Eigen::Vector3d::Zero();  // of this one
  double mass_beside_ = 0;
  Eigen::Vector3d first_moment_ = Eigen::Vector3d::Zero(), first_moment_now_ = Eigen::Vector3d::Zero(),
                  force_beside_ = Eigen::Vector3d::Zero(), moment_beside_ = Eigen::Vector3d::Zero(),
                  spin_of_loads_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_guides_ = Eigen::Vector3d::Zero(), moment_by_guides_ = Eigen::Vector3d::Zero();
  double dt_ = 0;
};

}  // namespace strike
