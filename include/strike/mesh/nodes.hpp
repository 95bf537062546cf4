#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace strike {

/// A vector at a node, padded so that it moves as one register.
template <class Real>
struct alignas(4 * sizeof(Real)) Padded {
  Real x[4]{};
};

/// The nodes of a scene in motion: reference position X, position x, velocity v and force f of node i [consistent
/// units] and its mass.
template <class Real>
class Nodes {
 public:
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Field = std::vector<Padded<Real>>;

  explicit Nodes(const std::vector<Eigen::Vector3d>& X)
      : position_(X.size()), velocity_(X.size()), force_(X.size()), mass_(X.size()) {
    for (std::size_t i = 0; i < X.size(); ++i) x(i) = X[i].cast<Real>();
  }

  std::size_t size() const { return mass_.size(); }

  auto x(std::size_t i) { return Eigen::Map<Vector>(position_[i].x); }
  auto v(std::size_t i) { return Eigen::Map<Vector>(velocity_[i].x); }
  auto f(std::size_t i) { return Eigen::Map<Vector>(force_[i].x); }
  Real& mass(std::size_t i) { return mass_[i]; }
  auto x(std::size_t i) const { return Eigen::Map<const Vector>(position_[i].x); }
  auto v(std::size_t i) const { return Eigen::Map<const Vector>(velocity_[i].x); }
  auto f(std::size_t i) const { return Eigen::Map<const Vector>(force_[i].x); }
  Real mass(std::size_t i) const { return mass_[i]; }

  /// The padded vector of node i, for loops over all nodes.
  static auto wide(Padded<Real>& a) { return Eigen::Map<Eigen::Array<Real, 4, 1>, Eigen::Aligned>(a.x); }

  Field& position() { return position_; }
  Field& velocity() { return velocity_; }
  Field& force() { return force_; }
  const Field& position() const { return position_; }
  const Field& velocity() const { return velocity_; }
  const Field& force() const { return force_; }

 private:
  Field position_, velocity_, force_;
  std::vector<Real> mass_;
};

/// A step in time as those see it who push or hold nodes: it begins at `time`, `dt` long, after one of `dt_before`.
struct Step {
  std::size_t number = 0;
  double time = 0;
  double dt_before = 0;
  double dt = 0;

  /// How long a force at `time` acts on the velocities: from the middle of the last step to the middle of this one.
  double kick() const { return 0.5 * (dt_before + dt); }
};

}  // namespace strike
