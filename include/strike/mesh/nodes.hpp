#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/text.hpp>

namespace strike {

/// What becomes of a direction of a node's motion that is not free: it does not move, or moves as it is told.
enum class Held { still, moved };

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

  /// Takes a direction, a unit vector, from the motion of node i. Returns what of it was still free: a unit vector at
  /// right angles to all directions taken before, or zero. Which motions are left does not depend on the order.
  /// Errors: no such node; one of two directions that are not at right angles is prescribed.
  Eigen::Vector3d hold(std::size_t i, Eigen::Vector3d direction, Held how = Held::still) {
    if (i >= size())
      throw Error(detail::joined({"strike: a condition names node ", std::to_string(i), ", but there are ",
                                  std::to_string(size()), " nodes; count them from 0."}));
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) {
      const double overlap = h->second.direction.dot(direction);
      if (std::abs(overlap) > 1e-6 && (how == Held::moved || h->second.how == Held::moved))
        throw Error(
            detail::joined({"strike: node ", std::to_string(i), " at ",
                            detail::text(Eigen::Vector3d(x(i).template cast<double>())), " has two conditions along ",
                            detail::text(direction), ", and one prescribes its motion; take it out of the other."}));
      direction -= overlap * h->second.direction;
    }
    if (direction.norm() < 1e-6) return Eigen::Vector3d::Zero();
    direction.normalize();
    held_.insert({i, {direction, how}});
    return direction;
  }
  /// The part of a vector along which node i is free to move.
  Eigen::Vector3d free(std::size_t i, Eigen::Vector3d a) const {
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) a -= h->second.direction.dot(a) * h->second.direction;
    return a;
  }

  /// The padded vector of node i, for loops over all nodes.
  static auto wide(Padded<Real>& a) { return Eigen::Map<Eigen::Array<Real, 4, 1>, Eigen::Aligned>(a.x); }

  Field& position() { return position_; }
  Field& velocity() { return velocity_; }
  Field& force() { return force_; }
  const Field& position() const { return position_; }
  const Field& velocity() const { return velocity_; }
  const Field& force() const { return force_; }

 private:
  struct HeldDirection {
    Eigen::Vector3d direction;
    Held how;
  };

  Field position_, velocity_, force_;
  std::vector<Real> mass_;
  std::multimap<std::size_t, HeldDirection> held_;
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
