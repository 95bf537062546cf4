#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
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
#include <strike/motion/by_number.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/held_directions.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/node_share.hpp>
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
  static constexpr bool has_ranks = !std::is_same_v<RanksOfRun, Alone>;

 public:
  static constexpr bool elements_have_copy = !std::is_same_v<Real, ElementReal>, nodes_turn = turn;
  /// Number of the interface: double or Dual.
  using Number = typename detail::NodalNumber<Real>::Value;
  using Vector = Vector3<Number>;
  using Ranks = RanksOfRun;

  /// `order` names every node once, in the order of their places.
  Nodes(const std::vector<Eigen::Vector3d>& X, std::vector<Index> order, const Ranks& ranks = {})
      : size_(X.size()), own_(X.size()), mass_(X.size()), number_(std::move(order)), place_(X.size()), ranks_(ranks) {
    detail::check_count("elements of a run", static_cast<double>(X.size()));
    if constexpr (elements_have_copy) copy_ = Motion<ElementReal, turn>(X.size());
    if constexpr (turn) inertia_.resize(X.size());
    for (std::size_t k = 0; k < number_.size(); ++k) place_[number_[k]] = static_cast<Index>(k);
    for (std::size_t i = 0; i < X.size(); ++i) set_position(i, X[i]);
  }

  /// Number of the nodes of the scene.
  std::size_t size() const { return size_; }
  /// The processes of the run.
  const Ranks& ranks() const { return ranks_; }

  // const: `nodes.v(i).z() = 1` would be lost, and does not compile.
  const Vector x(std::size_t i) const { return vector_of(own_.position[known_place(i)]); }
  const Vector v(std::size_t i) const { return vector_of(own_.velocity[known_place(i)]); }
  const Vector f(std::size_t i) const { return vector_of(own_.force[known_place(i)]); }
  double mass(std::size_t i) const { return static_cast<double>(mass_[known_place(i)]); }
  const Vector w(std::size_t i) const { return vector_of(own_.angular_velocity[known_place(i)]); }
  const Vector moment(std::size_t i) const { return vector_of(own_.moment[known_place(i)]); }
  double inertia(std::size_t i) const { return static_cast<double>(inertia_[known_place(i)]); }

  // Error: there is no node of this number.
  void set_position(std::size_t i, const Vector& x) { own_.position[checked_place(i)] = padded(x); }
  void set_velocity(std::size_t i, const Vector& v) { own_.velocity[checked_place(i)] = padded(v); }
  void add_force(std::size_t i, const Vector& change) { add(own_.force[checked_place(i)], change); }
  void add_mass(std::size_t i, double m) { mass_[checked_place(i)] += static_cast<Plain>(m); }
  void set_angular_velocity(std::size_t i, const Vector& w) { own_.angular_velocity[checked_place(i)] = padded(w); }
  void add_moment(std::size_t i, const Vector& change) { add(own_.moment[checked_place(i)], change); }
  void add_inertia(std::size_t i, double I) { inertia_[checked_place(i)] += static_cast<Plain>(I); }

  // Processes that share the nodes.
  /// How they do; none: each has all.
  const detail::NodeShare* node_share() const { return share_.get(); }
  /// Keeps from now on what this process needs of the nodes, and of the ghosts those at these places.
  void share(std::shared_ptr<const detail::NodeShare> share, const std::vector<Index>& ghosts) {
    share_ = std::move(share);
    std::vector<Index> numbers;
    numbers.reserve(share_->size() + ghosts.size());
    share_->each_kept([&](std::size_t place, std::size_t here) {
      numbers.push_back(number_[place]);
      here_.at(number_[place]) = static_cast<Index>(here);
    });
    for (const Index place : ghosts) numbers.push_back(number_[place]);
    number_ = std::move(numbers);
    for (Index& place : bare_) place = share_->here(place);
    if constexpr (elements_have_copy) copy_ = Motion<ElementReal, turn>(number_.size());
    leave_others();
  }
  /// Brings those of other processes; all processes do it together.
  void bring_others() {
    if (knows_all_) return;
    place_ = places_of_all();
    each_field([&](auto& field) { field = of_all(field); });
    knows_all_ = true;
  }
  /// Leaves them to the other processes again, whatever has been done to what this one keeps.
  void leave_others() {
    if (!share_ || !knows_all_) return;
    each_field([&](auto& field) {
      std::decay_t<decltype(field)> kept(share_->size());
      share_->each_kept([&](std::size_t place, std::size_t here) { kept[here] = field[place]; });
      field = std::move(kept);
    });
    if constexpr (!elements_have_copy) own_.resize(number_.size());
    place_ = {};
    knows_all_ = false;
  }

  /// Calls f(place) for the nodes that this process has.
  template <class F>
  void each_known_place(const F& f) const {
    for (std::size_t k = 0; k < mass_.size(); ++k) f(k);
  }
  /// The sum of f(place), of three numbers, over all nodes, chunk by chunk: the same bits on any number of processes.
  template <class F>
  Eigen::Vector3d sum(const F& f) const {
    std::vector<Padded<double>> of_chunks(detail::chunks(size()), Padded<double>(0));
    const detail::Places own = knows_all_ ? detail::Places{0, size()} : share_->own();
    std::size_t c = knows_all_ ? 0 : share_->first_chunk();
    for (std::size_t first = own.first; first < own.last; first += detail::chunk, ++c)
      for (std::size_t k = first; k < std::min(first + detail::chunk, own.last); ++k) of_chunks[c] += f(k);
    if (!knows_all_) share_->exchange_chunks(ranks_, of_chunks);
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
    std::vector<Eigen::Vector3d> places;
    for (const Index i : numbers) {
      check_number(i);
      if (is_rigid(i))
        throw Error(detail::joined({"strike: node ", std::to_string(i), " belongs to the rigid bodies ",
                                    std::to_string(body_of_[i]), " and ", std::to_string(bodies_.size()),
                                    "; make them one body."}));
      body_of_.at(i) = static_cast<Index>(bodies_.size());
      if (!(mass(i) > 0)) bare_.push_back(place(i));
      places.push_back(x(i).template cast<double>());
    }
    bodies_.emplace_back(std::move(numbers), places, whole, pivot);
    return bodies_.size() - 1;
  }
  std::vector<RigidMotion>& bodies() { return bodies_; }
  const std::vector<RigidMotion>& bodies() const { return bodies_; }
  /// Node i belongs to a rigid body, that of this number.
  bool is_rigid(std::size_t i) const { return body_of_[i] != none; }
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

  /// Place of node i in the fields, and number of the node at a place. Where processes share the nodes, places change
  /// when these begin to, after the start.
  Index place(std::size_t i) const {
    if constexpr (has_ranks)
      if (!knows_all_) return here_[i];
    return place_[i];
  }
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

  /// By the numbers of the nodes; all processes ask together.
  std::vector<Eigen::Vector3d> positions() const { return by_number(own_.position); }
  std::vector<Eigen::Vector3d> velocities() const { return by_number(own_.velocity); }

  template <class Archive>
  void serialize(Archive& archive) {
    if (knows_all_)
      archive.same(place_, mass_, inertia_);
    else
      archive.same(places_of_all(), of_all(mass_), of_all(inertia_));
    const auto keep = [&](NodalField<Real>& field) {
      if (knows_all_) return archive(std::span(field).first(size()));
      NodalField<Real> all = of_all(field);
      archive(std::span(all));
      if (archive.reads()) share_->each_kept([&](std::size_t place, std::size_t here) { field[here] = all[place]; });
    };
    keep(own_.position), keep(own_.velocity), keep(own_.force);
    if constexpr (turn) keep(own_.angular_velocity), keep(own_.moment);
    for (RigidMotion& body : bodies_) archive(body);
  }

 private:
  struct None {};

  /// A field at the places of all nodes, to which each process gives its own, ...
  template <class T>
  std::vector<T> of_all(const std::vector<T>& field) const {
    if (field.empty()) return {};
    std::vector<T> all(size());
    const auto [first, last] = share_->own();
    std::copy(field.begin() + std::ptrdiff_t(first), field.begin() + std::ptrdiff_t(last),
              all.begin() + std::ptrdiff_t(share_->own_among_all().first));
    share_->exchange(ranks_, all);
    return all;
  }
  /// ... and these places, by the numbers of the nodes.
  std::vector<Index> places_of_all() const {
    const std::vector<Index> numbers = of_all(number_);
    std::vector<Index> places(size());
    for (std::size_t k = 0; k < size(); ++k) places[numbers[k]] = static_cast<Index>(k);
    return places;
  }
  std::vector<Eigen::Vector3d> by_number(const NodalField<Real>& field) const {
    const auto in_order = [&](const NodalField<Real>& all, const std::vector<Index>& places) {
      std::vector<Eigen::Vector3d> values(size());
      for (std::size_t i = 0; i < size(); ++i) values[i] = vector_of(all[places[i]]).template cast<double>();
      return values;
    };
    return knows_all_ ? in_order(field, place_) : in_order(of_all(field), places_of_all());
  }
  /// f(field) for what each node has.
  template <class F>
  void each_field(const F& f) {
    f(own_.position), f(own_.velocity), f(own_.force), f(mass_);
    if constexpr (turn) f(own_.angular_velocity), f(own_.moment), f(inertia_);
  }

  /// Error: another process has the node.
  Index known_place(std::size_t i) const {
    const Index place = this->place(i);
    if constexpr (has_ranks)
      if (place == none) refuse_unknown(i);
    return place;
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

  std::size_t size_;
  Motion<Real, turn> own_;
  [[no_unique_address]] std::conditional_t<elements_have_copy, Motion<ElementReal, turn>, None> copy_;
  std::vector<Plain> mass_, inertia_;
  std::vector<Index> number_, place_;
  [[no_unique_address]] Ranks ranks_;
  std::shared_ptr<const detail::NodeShare> share_;  // if processes share the nodes
  bool knows_all_ = true;
  static constexpr Index none = std::numeric_limits<Index>::max();
  detail::ByNumber<Index> here_{none};  // places, while others have the rest of the nodes
  detail::HeldDirections held_, held_turns_;
  detail::ByNumber<Index> body_of_{none};
  std::vector<RigidMotion> bodies_;
  std::vector<Index> bare_;  // places of nodes of bodies that no element has
};

}  // namespace strike
