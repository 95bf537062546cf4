#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// What becomes of a direction of a node's motion that is not free: it does not move, or moves as it is told.
enum class Held { still, moved };

namespace detail {

/// The directions that conditions take from the motion of nodes.
class HeldDirections {
 public:
  /// See Nodes::hold; `place` is for the message.
  Eigen::Vector3d hold(std::size_t i, const Eigen::Vector3d& place, Eigen::Vector3d direction, Held how) {
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) {
      const double overlap = h->second.direction.dot(direction);
      if (std::abs(overlap) > 1e-6 && (how == Held::moved || h->second.how == Held::moved))
        throw Error(joined({"strike: node ", std::to_string(i), " at ", text(place), " has two conditions along ",
                            text(direction), ", and one prescribes its motion; take it out of the other."}));
      direction -= overlap * h->second.direction;
    }
    if (direction.norm() < 1e-6) return Eigen::Vector3d::Zero();
    direction.normalize();
    held_.insert({i, {direction, how}});
    return direction;
  }
  /// The part of a vector along which node i is free to move.
  template <class Vector>
  Vector free(std::size_t i, Vector a) const {
    const auto [first, last] = held_.equal_range(i);
    for (auto h = first; h != last; ++h) a -= h->second.direction.dot(a) * h->second.direction;
    return a;
  }

 private:
  struct HeldDirection {
    Eigen::Vector3d direction;
    Held how;
  };

  std::multimap<std::size_t, HeldDirection> held_;
};

}  // namespace detail

namespace detail {
template <class Real>
struct NodalNumber {
  using Padded = Pack<Real, 4>;
  using Told = double;
};
template <class Real, std::size_t N>
struct NodalNumber<Dual<Real, N>> {
  using Padded = Dual<Pack<Real, 4>, N>;
  using Told = Dual<Real, N>;
};
}  // namespace detail

/// A vector at a node, padded so that it moves as one register; the fourth number is nobody's.
template <class Real>
using Padded = typename detail::NodalNumber<Real>::Padded;

/// A vector for each place.
template <class Real>
using NodalField = std::vector<Padded<Real>>;

/// What elements read and write, place by place: positions, velocities and forces, and of nodes that turn angular
/// velocities and moments.
template <class Real, bool turn = false>
struct Motion {
  NodalField<Real> position, velocity, force;

  explicit Motion(std::size_t places = 0) : position(places, zero()), velocity(position), force(position) {}
  void resize(std::size_t places) {
    for (NodalField<Real>* field : {&position, &velocity, &force}) {
      field->reserve(places);  // and no more
      field->resize(places, zero());
    }
  }
  static Padded<Real> zero() { return Padded<Real>(0); }
};
template <class Real>
struct Motion<Real, true> : Motion<Real> {
  NodalField<Real> angular_velocity, moment;

  explicit Motion(std::size_t places = 0)
      : Motion<Real>(places), angular_velocity(places, this->zero()), moment(angular_velocity) {}
  void resize(std::size_t places) {
    Motion<Real>::resize(places);
    for (NodalField<Real>* field : {&angular_velocity, &moment}) {
      field->reserve(places);
      field->resize(places, this->zero());
    }
  }
};

/// The nodes of a scene in motion: position x, velocity v and force f of node i [consistent units] and its mass; where
/// elements turn them (`turn`) their angular velocity w and moment too, and one moment of inertia for all directions.
/// They are kept in Real and told and given in double, or if Real has derivatives in that. Node i lies in memory at
/// place(i), chosen for locality. Elements work on `motion()` of ElementReal: the nodes' own, or if that is of another
/// precision a copy.
template <class Real, class ElementReal = Real, bool turn = false>
class Nodes {
  using Plain = RealOf<Real>;

 public:
  static constexpr bool elements_have_copy = !std::is_same_v<Real, ElementReal>, nodes_turn = turn;
  /// In what vectors are told and given.
  using Number = typename detail::NodalNumber<Real>::Told;
  using Vector = Vector3<Number>;

  /// `order` names every node once, in the order of their places.
  Nodes(const std::vector<Eigen::Vector3d>& X, std::vector<Index> order)
      : own_(X.size()), mass_(X.size()), number_(std::move(order)), place_(X.size()) {
    if constexpr (elements_have_copy) copy_ = Motion<ElementReal, turn>(X.size());
    if constexpr (turn) inertia_.resize(X.size());
    for (std::size_t k = 0; k < number_.size(); ++k) place_[number_[k]] = static_cast<Index>(k);
    for (std::size_t i = 0; i < X.size(); ++i) set_position(i, X[i]);
  }

  std::size_t size() const { return mass_.size(); }

  // const: `nodes.v(i).z() = 1` would be lost, and does not compile.
  const Vector x(std::size_t i) const { return told(own_.position[place_[i]]); }
  const Vector v(std::size_t i) const { return told(own_.velocity[place_[i]]); }
  const Vector f(std::size_t i) const { return told(own_.force[place_[i]]); }
  double mass(std::size_t i) const { return static_cast<double>(mass_[place_[i]]); }
  const Vector w(std::size_t i) const { return told(own_.angular_velocity[place_[i]]); }
  const Vector moment(std::size_t i) const { return told(own_.moment[place_[i]]); }
  double inertia(std::size_t i) const { return static_cast<double>(inertia_[place_[i]]); }

  void set_position(std::size_t i, const Vector& x) { own_.position[place_[i]] = kept(x); }
  void set_velocity(std::size_t i, const Vector& v) { own_.velocity[place_[i]] = kept(v); }
  void add_force(std::size_t i, const Vector& change) { own_.force[place_[i]] = kept(f(i) + change); }
  void add_mass(std::size_t i, double m) { mass_[place_[i]] += static_cast<Plain>(m); }
  void set_angular_velocity(std::size_t i, const Vector& w) { own_.angular_velocity[place_[i]] = kept(w); }
  void add_moment(std::size_t i, const Vector& change) { own_.moment[place_[i]] = kept(moment(i) + change); }
  void add_inertia(std::size_t i, double I) { inertia_[place_[i]] += static_cast<Plain>(I); }

  /// Error: there is no node of this number.
  void check_number(std::size_t i) const {
    if (i >= size())
      throw Error(detail::joined({"strike: a condition names node ", std::to_string(i), ", but there are ",
                                  std::to_string(size()), " nodes; count them from 0."}));
  }
  /// Takes a direction, a unit vector, from the motion of node i. Returns what of it was still free: a unit vector at
  /// right angles to all directions taken before, or zero. Which motions are left does not depend on the order.
  /// Errors: no such node; one of two directions that are not at right angles is prescribed.
  Eigen::Vector3d hold(std::size_t i, const Eigen::Vector3d& direction, Held how = Held::still) {
    check_number(i);
    return held_.hold(i, x(i).template cast<double>(), direction, how);
  }
  /// The same for an axis about which the node could turn.
  Eigen::Vector3d hold_turn(std::size_t i, const Eigen::Vector3d& axis, Held how = Held::still) {
    check_number(i);
    return held_turns_.hold(i, x(i).template cast<double>(), axis, how);
  }
  /// The part of a vector along which node i is free to move.
  Eigen::Vector3d free(std::size_t i, const Eigen::Vector3d& a) const { return held_.free(i, a); }
  Vector free(std::size_t i, const Vector& a) const requires(!std::is_same_v<Number, double>) {
    return held_.free(i, a);
  }

  /// The spacing of the numbers where node i is [length].
  double resolution(std::size_t i) const {
    const Eigen::Vector3d at = x(i).template cast<double>();
    return static_cast<double>(std::numeric_limits<Plain>::epsilon()) *
           std::max({std::abs(at.x()), std::abs(at.y()), std::abs(at.z())});
  }

  /// Gives the nodes at these places others behind all, where patches of elements have them to themselves.
  void add_ghosts(const std::vector<Index>& places) {
    motion().resize(number_.size() + places.size());
    for (const Index place : places) number_.push_back(number_[place]);
  }
  /// How many places there are: those of the nodes, and after them those of ghosts.
  Index places() const { return static_cast<Index>(number_.size()); }

  /// Where node i lies in the fields, and the number of the node that lies at a place.
  Index place(std::size_t i) const { return place_[i]; }
  Index number(std::size_t place) const { return number_[place]; }

  // The fields, place by place, and how they keep a vector.
  static Vector told(const Padded<Real>& a) {
    return {static_cast<Number>(lane(a, 0)), static_cast<Number>(lane(a, 1)), static_cast<Number>(lane(a, 2))};
  }
  static Padded<Real> kept(const Vector& a) {
    Padded<Real> b = 0;
    for (int c = 0; c < 3; ++c) set_lane(b, static_cast<std::size_t>(c), static_cast<Real>(a(c)));
    return b;
  }
  NodalField<Real>& position() { return own_.position; }
  NodalField<Real>& velocity() { return own_.velocity; }
  NodalField<Real>& force() { return own_.force; }
  const NodalField<Real>& position() const { return own_.position; }
  const NodalField<Real>& velocity() const { return own_.velocity; }
  const NodalField<Real>& force() const { return own_.force; }
  /// What elements work on.
  Motion<ElementReal, turn>& motion() {
    if constexpr (elements_have_copy)
      return copy_;
    else
      return own_;
  }
  NodalField<Real>& angular_velocity() { return own_.angular_velocity; }
  NodalField<Real>& moment() { return own_.moment; }
  const NodalField<Real>& angular_velocity() const { return own_.angular_velocity; }
  const NodalField<Real>& moment() const { return own_.moment; }
  const std::vector<Plain>& mass() const { return mass_; }
  const std::vector<Plain>& inertia() const { return inertia_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(place_, mass_, inertia_);
    archive(own_.position, own_.velocity, own_.force);
    if constexpr (turn) archive(own_.angular_velocity, own_.moment);
  }

 private:
  struct None {};

  Motion<Real, turn> own_;
  [[no_unique_address]] std::conditional_t<elements_have_copy, Motion<ElementReal, turn>, None> copy_;
  std::vector<Plain> mass_, inertia_;
  std::vector<Index> number_, place_;
  detail::HeldDirections held_, held_turns_;
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
