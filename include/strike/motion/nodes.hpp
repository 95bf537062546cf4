#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/count.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/held_directions.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// The nodes of a scene in motion: position x, velocity v and force f of node i [consistent units] and its mass; where
/// elements turn them (`turn`) their angular velocity w and moment too, and one moment of inertia for all directions.
/// Stored as Real; the interface uses double, or Dual. Node i is in memory at place(i), chosen for locality. Elements
/// work on `motion()` of ElementReal: the nodes' own, or if that is of another precision a copy.
template <class Real, class ElementReal = Real, bool turn = false, class RanksOfRun = Alone>
class Nodes {
  using Plain = RealOf<Real>;

 public:
  static constexpr bool elements_have_copy = !std::is_same_v<Real, ElementReal>, nodes_turn = turn;
  /// Number of the interface: double or Dual.
  using Number = typename detail::NodalNumber<Real>::Value;
  using Vector = Vector3<Number>;
  using Ranks = RanksOfRun;

  /// `order` names every node once, in the order of their places.
  Nodes(const std::vector<Eigen::Vector3d>& X, std::vector<Index> order, const Ranks& ranks = {})
      : own_(X.size()), mass_(X.size()), number_(std::move(order)), place_(X.size()), ranks_(ranks) {
    detail::check_count("elements of a run", static_cast<double>(X.size()));
    if constexpr (elements_have_copy) copy_ = Motion<ElementReal, turn>(X.size());
    if constexpr (turn) inertia_.resize(X.size());
    for (std::size_t k = 0; k < number_.size(); ++k) place_[number_[k]] = static_cast<Index>(k);
    for (std::size_t i = 0; i < X.size(); ++i) set_position(i, X[i]);
  }

  std::size_t size() const { return mass_.size(); }
  /// The processes that share the elements; each has all nodes.
  const Ranks& ranks() const { return ranks_; }

  // const: `nodes.v(i).z() = 1` would be lost, and does not compile.
  const Vector x(std::size_t i) const { return vector_of(own_.position[known_place(i)]); }
  const Vector v(std::size_t i) const { return vector_of(own_.velocity[known_place(i)]); }
  const Vector f(std::size_t i) const { return vector_of(own_.force[known_place(i)]); }
  double mass(std::size_t i) const { return static_cast<double>(mass_[place_[i]]); }
  const Vector w(std::size_t i) const { return vector_of(own_.angular_velocity[known_place(i)]); }
  const Vector moment(std::size_t i) const { return vector_of(own_.moment[known_place(i)]); }
  double inertia(std::size_t i) const { return static_cast<double>(inertia_[place_[i]]); }

  // Error: there is no node of this number.
  void set_position(std::size_t i, const Vector& x) { own_.position[checked_place(i)] = padded(x); }
  void set_velocity(std::size_t i, const Vector& v) { own_.velocity[checked_place(i)] = padded(v); }
  void add_force(std::size_t i, const Vector& change) { add(own_.force[checked_place(i)], change); }
  void add_mass(std::size_t i, double m) { mass_[checked_place(i)] += static_cast<Plain>(m); }
  void set_angular_velocity(std::size_t i, const Vector& w) { own_.angular_velocity[checked_place(i)] = padded(w); }
  void add_moment(std::size_t i, const Vector& change) { add(own_.moment[checked_place(i)], change); }
  void add_inertia(std::size_t i, double I) { inertia_[checked_place(i)] += static_cast<Plain>(I); }

  /// Of several processes that share the nodes: where it knows what moves, place by place, the chunks of places up to
  /// those of each process, and whether it knows all now.
  void set_known(std::vector<char> known, std::vector<std::size_t> chunk_ends) {
    known_ = std::move(known), chunk_ends_ = std::move(chunk_ends);
  }
  void know_all(bool all) { knows_all_ = all; }
  bool knows_all() const { return knows_all_; }

  /// Calls f(place) for the nodes that this process knows.
  template <class F>
  void each_known_place(const F& f) const {
    for (std::size_t k = 0; k < size(); ++k)
      if (knows(k)) f(k);
  }
  /// The sum of f(place), of three numbers, over all nodes, chunk by chunk: the same bits on any number of processes.
  template <class F>
  Eigen::Vector3d sum(const F& f) const {
    std::vector<Padded<double>> of_chunks(detail::chunks(size()), Padded<double>(0));
    const std::size_t rank = ranks_.rank(), first = knows_all_ || rank == 0 ? 0 : chunk_ends_[rank - 1],
                      last = knows_all_ ? of_chunks.size() : chunk_ends_[rank];
    for (std::size_t c = first; c < last; ++c)
      for (std::size_t k = c * detail::chunk; k < std::min((c + 1) * detail::chunk, size()); ++k) of_chunks[c] += f(k);
    if (!knows_all_) ranks_.exchange(std::span(of_chunks), std::span<const std::size_t>(chunk_ends_));
    Padded<double> sum = 0;
    for (const Padded<double>& of_chunk : of_chunks) sum += of_chunk;
    return Nodes<double>::vector_of(sum);
  }

  /// Error: there is no node of this number.
  void check_number(std::size_t i) const {
    if (i >= size()) refuse(i);
  }

  /// Nodes move as one body of this inertia from now on; about a point that does not move, if there is one. Returns its
  /// number. Error: a node belongs to another body.
  std::size_t add_body(std::vector<Index> numbers, const Inertia& whole, const std::optional<Eigen::Vector3d>& pivot) {
    body_of_.resize(size(), no_body);
    std::vector<Eigen::Vector3d> places;
    for (const Index i : numbers) {
      check_number(i);
      if (is_rigid(i))
        throw Error(detail::joined({"strike: node ", std::to_string(i), " belongs to the rigid bodies ",
                                    std::to_string(body_of_[i]), " and ", std::to_string(bodies_.size()),
                                    "; make them one body."}));
      body_of_[i] = static_cast<Index>(bodies_.size());
      if (!(mass(i) > 0)) bare_.push_back(place_[i]);
      places.push_back(x(i).template cast<double>());
    }
    bodies_.emplace_back(std::move(numbers), places, whole, pivot);
    return bodies_.size() - 1;
  }
  std::vector<RigidMotion>& bodies() { return bodies_; }
  const std::vector<RigidMotion>& bodies() const { return bodies_; }
  /// Node i belongs to a rigid body, that of this number.
  bool is_rigid(std::size_t i) const { return i < body_of_.size() && body_of_[i] != no_body; }
  std::size_t body_of(std::size_t i) const { return body_of_[i]; }
  /// Clears the forces on nodes of bodies to which no element adds, and what acts on bodies beside their nodes.
  void clear_bare_forces() {
    for (RigidMotion& body : bodies_) body.clear_loads();
    for (const Index place : bare_) {
      own_.force[place] = 0;
      if constexpr (turn) own_.moment[place] = 0;
    }
  }
  /// Takes a direction, a unit vector, from the motion of node i. Returns its part that was still free: a unit vector
  /// at right angles to all directions taken before, or zero. The motions that are left do not depend on the order.
  /// Errors: no such node; one of two directions that are not at right angles is prescribed; a node of a rigid body.
  Eigen::Vector3d hold(std::size_t i, const Eigen::Vector3d& direction, Held how = Held::still) {
    check_number(i), check_not_rigid(i);
    return held_.hold(i, x(i).template cast<double>(), direction, how);
  }
  /// Takes an axis, a unit vector, from the rotation of node i; see hold.
  Eigen::Vector3d hold_turn(std::size_t i, const Eigen::Vector3d& axis, Held how = Held::still) {
    check_number(i), check_not_rigid(i);
    return held_turns_.hold(i, x(i).template cast<double>(), axis, how);
  }
  /// The part of a vector along which node i is free to move.
  Eigen::Vector3d free(std::size_t i, const Eigen::Vector3d& a) const { return held_.free(i, a); }
  Vector free(std::size_t i, const Vector& a) const
    requires(!std::is_same_v<Number, double>)
  {
    return held_.free(i, a);
  }

  /// Spacing of floating-point numbers at the position of node i [length].
  double resolution(std::size_t i) const { return resolution(x(i).template cast<double>()); }
  /// The same at a position.
  static double resolution(const Eigen::Vector3d& at) {
    return static_cast<double>(std::numeric_limits<Plain>::epsilon()) *
           std::max({std::abs(at.x()), std::abs(at.y()), std::abs(at.z())});
  }

  /// Adds copies of the nodes at these places behind all others, each for one patch of elements alone. Error: 2^32
  /// places or more.
  void add_ghosts(const std::vector<Index>& places) {
    detail::check_count("patches of a run", static_cast<double>(number_.size() + places.size()));
    motion().resize(number_.size() + places.size());
    for (const Index place : places) number_.push_back(number_[place]);
  }
  /// Number of places: those of the nodes, and after them those of ghosts.
  Index places() const { return static_cast<Index>(number_.size()); }

  /// Place of node i in the fields, and number of the node at a place.
  Index place(std::size_t i) const { return place_[i]; }
  Index number(std::size_t place) const { return number_[place]; }

  // The fields, place by place, and conversions of their vectors.
  static Vector vector_of(const Padded<Real>& a) {
    return {static_cast<Number>(lane(a, 0)), static_cast<Number>(lane(a, 1)), static_cast<Number>(lane(a, 2))};
  }
  static Padded<Real> padded(const Vector& a) {
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
  /// Fields that elements work on.
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
    const auto without_ghosts = [&](NodalField<Real>& field) { archive(std::span(field).first(size())); };
    for (NodalField<Real>* field : {&own_.position, &own_.velocity, &own_.force}) without_ghosts(*field);
    if constexpr (turn) without_ghosts(own_.angular_velocity), without_ghosts(own_.moment);
    for (RigidMotion& body : bodies_) archive(body);
  }

 private:
  struct None {};

  /// Error: another process has moved the node.
  Index known_place(std::size_t i) const {
    const Index place = place_[i];
    if (!knows(place)) refuse_unknown(i);
    return place;
  }
  bool knows(std::size_t place) const {
    if constexpr (std::is_same_v<Ranks, Alone>)
      return true;
    else
      return knows_all_ || known_[place];
  }
  [[noreturn, gnu::cold, gnu::noinline]] static void refuse_unknown(std::size_t i) {
    throw Error(detail::joined({"strike: node ", std::to_string(i),
                                " is on another process; ask run.nodes() for it anew in each step, in all processes "
                                "together, and give an item that acts on it nodes_named()."}));
  }

  [[noreturn, gnu::cold, gnu::noinline]] void refuse(std::size_t i) const {
    throw Error(detail::joined({"strike: a condition names node ", std::to_string(i), ", but there are ",
                                std::to_string(size()), " nodes; count them from 0."}));
  }
  void check_not_rigid(std::size_t i) const {
    if (is_rigid(i))
      throw Error(detail::joined({"strike: a condition names node ", std::to_string(i), " of the rigid body ",
                                  std::to_string(body_of_[i]),
                                  "; hold and move a body by what is given to its RigidBody, such as "
                                  "HeldBody{{unit(Axis::x)}}."}));
  }
  Index checked_place(std::size_t i) const {
    check_number(i);
    return known_place(i);
  }
  static void add(Padded<Real>& sum, const Vector& change) { sum = padded(vector_of(sum) + change); }

  Motion<Real, turn> own_;
  [[no_unique_address]] std::conditional_t<elements_have_copy, Motion<ElementReal, turn>, None> copy_;
  std::vector<Plain> mass_, inertia_;
  std::vector<Index> number_, place_;
  [[no_unique_address]] Ranks ranks_;
  std::vector<char> known_;
  std::vector<std::size_t> chunk_ends_;
  bool knows_all_ = true;
  detail::HeldDirections held_, held_turns_;
  static constexpr Index no_body = std::numeric_limits<Index>::max();
  std::vector<Index> body_of_;  // node by node, if there are bodies
  std::vector<RigidMotion> bodies_;
  std::vector<Index> bare_;  // places of nodes of bodies that no element has
};

}  // namespace strike
