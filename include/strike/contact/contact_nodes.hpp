#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/ascending.hpp>
#include <strike/contact/contact_bodies.hpp>
#include <strike/contact/plates_beside.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

struct ContactPair;

/// Nodes of a contact and points of rigid surfaces, in a numbering of their own: nodes in the order of their numbers in
/// the scene, so that no result depends on their order in memory. Positions x at the time n and velocities v after it,
/// which impulses change along the directions that no condition holds.
class ContactNodes {
 public:
  std::vector<Eigen::Vector3d> x, v;      ///< [length], [velocity]
  std::vector<Eigen::Vector3d> x_before;  ///< positions at the time n - 1 [length]
  std::vector<Eigen::Vector3d> kicked;    ///< change of v by this step's forces, of nodes in pairs
  std::vector<Eigen::Vector3d> normal_impulse, friction_impulse;  ///< of this step [force time]

  /// Nodes by their numbers, in ascending order, and points that never move. `parts` are those of the scene, from which
  /// follow the springs of the nodes; where plates are beside their nodes, x is in their middle. Error: no such node.
  template <class N>
  void begin(const N& nodes, std::vector<Index> numbers, const std::vector<Eigen::Vector3d>& points,
             std::span<const PartFaces> parts) {
    if (!numbers.empty() && numbers.back() >= nodes.size())
      throw Error(detail::joined({"strike: a contact names node ", std::to_string(numbers.back()), ", but there are ",
                                  std::to_string(nodes.size()), " nodes; count them from 0."}));
    number_ = std::move(numbers);
    place_.resize(number_.size());
    find_places(nodes);
    x.resize(number_.size());
    x.insert(x.end(), points.begin(), points.end());
    x_before = x;
    v.assign(x.size(), Eigen::Vector3d::Zero());
    kicked = normal_impulse = friction_impulse = v;
    is_touched_.assign(x.size(), 0), held_.assign(x.size(), -1), inverse_mass_.assign(x.size(), 0.0);
    for (std::size_t i = 0; i < number_.size(); ++i) inverse_mass_[i] = 1 / nodes.mass(number_[i]);
    bodies_.begin(nodes, number_);
    for (const auto& body : bodies_.all())
      for (const Index i : body.nodes)
        inverse_mass_[i] =
            body.motion->largest_response((nodes.x(number_[i]).template cast<double>() - body.motion->centre()).norm());
    spring_.assign(x.size(), 0.0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      beside_.add(p, parts[p], [&](Index number) {
        const Index i = local(number);
        return i < number_.size() && number_[i] == number ? i : detail::PlatesBeside::none;
      });
      add_springs(nodes, parts[p]);
    }
    gather(nodes, Serial{}), x_before = x;
  }

  /// Copies positions and velocities from the scene and clears the impulses.
  template <class N, class E>
  void gather(const N& nodes, const E& execution) {
    x_before.swap(x);
    detail::for_each_chunk(execution, place_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        x[i] = N::vector_of(nodes.position()[place_[i]]);
        v[i] = N::vector_of(nodes.velocity()[place_[i]]);
      }
    });
    if (!beside_.empty()) shift(nodes);
    bodies_.gather(nodes, v);
    for (const Index i : touched_) is_touched_[i] = 0, normal_impulse[i].setZero(), friction_impulse[i].setZero();
    touched_.clear();
  }

  /// The numbers of all nodes that it reads or changes.
  std::vector<Index> nodes_named() const { return detail::ascending(beside_.nodes_named(), number_); }
  /// Finds where the nodes are in memory.
  template <class N>
  void find_places(const N& nodes) {
    for (std::size_t i = 0; i < number_.size(); ++i) place_[i] = nodes.place(number_[i]);
  }
  /// Plates of a part that are not alive no longer shift their nodes.
  void remove(std::size_t part, const std::vector<bool>& alive) { beside_.remove(part, alive); }

  /// Takes note of the nodes in pairs, computes their `kicked`, and 1/m* of the pairs.
  template <class N, class E>
  void gather_forces(const N& nodes, std::vector<ContactPair>& pairs, double kick, const E& execution);

  /// Finds the directions of the nodes that conditions hold, once: at the first step, when all items have begun.
  template <class N>
  void find_held_directions(const N& nodes) {
    if (knows_held_) return;
    knows_held_ = true;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      Eigen::Matrix3d free;
      for (std::size_t a = 0; a < 3; ++a) {
        Eigen::Vector3d unit{0, 0, 0};
        unit[static_cast<Eigen::Index>(a)] = 1;
        set_column(free, a, nodes.free(number_[i], unit));
      }
      if (std::equal(free.data(), free.data() + 9, Eigen::Matrix3d::Identity().eval().data())) continue;
      held_[i] = static_cast<int>(free_.size());
      free_.push_back(free);
    }
  }

  /// Writes the velocities to the scene and books the work of the impulses.
  template <class N, class Ledger, class E>
  void scatter(N& nodes, Ledger& ledger, const E& execution) const {
    using namespace detail;
    struct Sums {
      double normal_before = 0, normal_after = 0, friction_before = 0, friction_after = 0;
    };
    std::vector<Sums> sums(chunks(touched_.size()));
    for_each_chunk(execution, touched_.size(), [&](std::size_t c, std::size_t first, std::size_t last) {
      Sums sum;
      for (std::size_t k = first; k < last; ++k) {
        const Index i = touched_[k];
        Eigen::Vector3d v_before = bodies_.has(i) ? bodies_.velocity_at(i) : v[i];
        if (!bodies_.has(i)) {
          v_before -= inverse_mass_[i] * (normal_impulse[i] + friction_impulse[i]);
          nodes.set_velocity(number_[i], v[i]);
        }
        v_before -= kicked[i];
        sum.normal_before += normal_impulse[i].dot(v_before), sum.normal_after += normal_impulse[i].dot(v[i]);
        sum.friction_before += friction_impulse[i].dot(v_before), sum.friction_after += friction_impulse[i].dot(v[i]);
      }
      sums[c] = sum;
    });
    for (const Sums& sum : sums) {
      ledger.contact.book_impulse(-sum.normal_before, -sum.normal_after);
      ledger.friction.book_impulse(-sum.friction_before, -sum.friction_after);
    }
    bodies_.scatter(nodes, touched_, x, [&](Index i) { return normal_impulse[i] + friction_impulse[i]; });
  }

  /// The part of a vector along which node i may move.
  Eigen::Vector3d free(Index i, const Eigen::Vector3d& a) const {
    return held_[i] < 0 ? a : times<double>(free_[static_cast<std::size_t>(held_[i])], a);
  }
  /// Inverse effective mass along a unit vector: the change of velocity per unit impulse, 1/m of a free node [1/mass].
  double inverse_mass_along(Index i, const Eigen::Vector3d& a) const {
    if (is_rigid(i)) return bodies_.response(bodies_.of(i), a, cross(Eigen::Vector3d(x[i] - bodies_.centre(i)), a));
    return held_[i] < 0 ? inverse_mass_[i] : inverse_mass_[i] * free(i, a).dot(a);
  }
  /// Of a node of a rigid body no smaller than along any vector, as if the body had no guides.
  double inverse_mass(Index i) const { return inverse_mass_[i]; }
  /// No smaller than inverse_mass_along any vector at the start.
  double largest_inverse_mass(Index i) const {
    return is_rigid(i) ? bodies_.largest_response(i, x[i]) : inverse_mass_[i];
  }
  /// It belongs to a rigid body, whose nodes all move by its impulses.
  bool is_rigid(Index i) const { return bodies_.has(i); }
  const detail::ContactBodies& bodies() const { return bodies_; }
  /// True if conditions hold it in a direction.
  bool is_held(Index i) const { return held_[i] >= 0; }
  /// True if they hold it in every direction.
  bool is_held_fast(Index i) const { return is_held(i) && free_[static_cast<std::size_t>(held_[i])].isZero(); }
  /// Stiffness of the cells of a node, by which they swing with it at about their stable step; 0 if it is not known
  /// [force/length].
  double spring(Index i) const { return spring_[i]; }

  /// The square of the stable step of a node's cells [time^2]: of those at the start, shortened as the step of the
  /// elements has been since, and no less than that.
  double squared_step(Index i) const {
    const double own = spring_[i] * inverse_mass_[i] > 0 ? shortened_ / (spring_[i] * inverse_mass_[i]) : 0;
    return std::max(own, squared_stable_step_);
  }
  /// Takes note of the stable step of the elements.
  void note(const Step& step) {
    squared_stable_step_ = step.stable_dt * step.stable_dt;
    if (step.number <= 1) squared_first_step_ = squared_stable_step_;
    shortened_ = std::min(1.0, squared_stable_step_ / squared_first_step_);
  }

  /// Gives node i an impulse along a normal, or of friction [force time].
  void push(Index i, const Eigen::Vector3d& impulse) { book_push(i, impulse), nudge(i, impulse); }
  void drag(Index i, const Eigen::Vector3d& impulse) { book_drag(i, impulse), nudge(i, impulse); }
  /// Changes its velocity alone, for laws that try impulses and book the last ones.
  void nudge(Index i, const Eigen::Vector3d& impulse) {
    using namespace detail;
    if (is_rigid(i))
      bodies_.nudge(i, impulse, x, v);
    else if (inverse_mass_[i] > 0)
      v[i] += inverse_mass_[i] * free(i, impulse);
  }
  void book_push(Index i, const Eigen::Vector3d& impulse) { book(i, impulse, normal_impulse); }
  void book_drag(Index i, const Eigen::Vector3d& impulse) { book(i, impulse, friction_impulse); }

  /// Nodes that may have got an impulse in this step, those of pairs.
  const std::vector<Index>& touched() const { return touched_; }
  std::size_t size() const { return x.size(); }
  /// Number of node i in the scene.
  Index number(Index i) const { return number_[i]; }
  const std::vector<Index>& numbers() const { return number_; }
  /// Node of a number in the scene, which must be one of this contact's.
  Index local(Index number) const {
    return static_cast<Index>(std::lower_bound(number_.begin(), number_.end(), number) - number_.begin());
  }
  /// The first of the points that never move.
  Index first_point() const { return static_cast<Index>(number_.size()); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(number_);
    archive(x, normal_impulse, friction_impulse, touched_, is_touched_, beside_, squared_first_step_);
  }

 private:
  /// Adds to the nodes of each cell its share of M V/h^2, of a plate M t A/L^2: M = rho c^2, h the volume over the
  /// largest face, of a tetrahedron three times that, its height; t the thickness, A the area, L the longest edge.
  template <class N>
  void add_springs(const N& nodes, const PartFaces& part) {
    const auto& faces = part.faces;
    for (std::size_t first = 0, end = 0; first < faces.size(); first = end) {
      double volume = 0, largest = 0;
      std::array<Eigen::Vector3d, 4> X;
      X.fill(Eigen::Vector3d::Zero());
      std::array<Index, 8> corners{};
      std::size_t count = 0;
      for (; end < faces.size() && faces[end].cell == faces[first].cell; ++end) {
        for (std::size_t k = 0; k < 4; ++k) X[k] = nodes.x(faces[end].nodes[k]).template cast<double>();
        const Eigen::Vector3d area = 0.5 * cross<double>(X[2] - X[0], X[3] - X[1]);
        volume += 0.25 * (X[0] + X[1] + X[2] + X[3]).dot(area) / 3, largest = std::max(largest, area.norm());
        for (const Index i : faces[end].nodes)
          if (std::find(corners.begin(), corners.begin() + count, i) == corners.begin() + count && count < 8)
            corners[count++] = i;
      }
      double stiffness = 0;
      if (end - first == 1) {
        double longest = 0;
        for (std::size_t k = 0; k < 4; ++k) longest = std::max(longest, (X[(k + 1) % 4] - X[k]).squaredNorm());
        stiffness = part.wave_modulus * largest / longest;
      } else {
        stiffness = part.wave_modulus * largest * largest / volume / (end - first == 4 ? 9 : 1);
      }
      for (std::size_t k = 0; k < count; ++k)
        if (const Index i = local(corners[k]); i < number_.size() && number_[i] == corners[k])
          spring_[i] += stiffness / static_cast<double>(count);
    }
  }
  /// Moves nodes to the middle of their plates.
  template <class N>
  void shift(const N& nodes) {
    const auto ways = beside_.ways(nodes, number_.size());
    for (std::size_t i = 0; i < ways.size(); ++i) x[i] += ways[i];
  }

  void note_touched(Index i) {
    if (inverse_mass_[i] > 0 && !is_touched_[i]) is_touched_[i] = 1, touched_.push_back(i);
  }
  void book(Index i, const Eigen::Vector3d& impulse, std::vector<Eigen::Vector3d>& to) {
    using namespace detail;
    if (!(inverse_mass_[i] > 0)) return;
    note_touched(i);
    to[i] += free(i, impulse);
  }

  std::vector<Index> number_, place_, touched_;
  std::vector<unsigned char> is_touched_;
  std::vector<double> inverse_mass_, spring_;
  detail::ContactBodies bodies_;
  double squared_stable_step_ = 0, squared_first_step_ = 0, shortened_ = 1;
  detail::PlatesBeside beside_;
  std::vector<int> held_;  // index into free_, or -1
  std::vector<Eigen::Matrix3d> free_;
  bool knows_held_ = false;
};

namespace detail {

/// The nodes of the scene compute in double or float, not in dual numbers.
template <class N>
inline constexpr bool is_plain = std::is_same_v<typename N::Number, double>;

/// One sentence for a run of dual numbers, whose derivatives the contact would lose.
template <class N>
constexpr void refuse_dual_numbers() {
  static_assert(is_plain<N>,
                "strike: this contact computes in double; in a run of dual numbers take a RigidWall, or a NodeToRigid "
                "with a RigidPlane and the Kinematic law.");
}

}  // namespace detail

/// Two points that touch, each the mean of nodes: sum of w_I x_I = gap n, where the weights w of one side, that to
/// which n points, have the sum 1 and those of the other -1 (0 if that is a rigid body without nodes). Impulses w_I J n
/// along the line through both points keep momentum and its moment.
struct ContactPair {
  std::array<Index, 5> nodes{};  ///< a node first and the corners of a face after it, or the ends of two edges
  std::array<double, 5> weights{};
  unsigned count = 0;                                ///< of nodes
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit vector
  double gap = 0;                                    ///< less what is tolerated; negative inside [length]
  double stiffness = 0;                              ///< of the spring of a penalty law [force/length]
  double* stored = nullptr;             ///< of the law, kept while the touch lasts: energy taken and not given back
  Eigen::Vector3d* friction = nullptr;  ///< in the last step, against the sliding, if it is kept [force]
  double inverse_effective_mass = 0;    ///< 1/m* along the normal; 0 if all its nodes are held [1/mass]
  double impulse = 0;                   ///< normal impulse of this step [force time]

  ContactPair() = default;
  ContactPair(Eigen::Vector3d normal_of_pair, double gap_of_pair)
      : normal(std::move(normal_of_pair)), gap(gap_of_pair) {}
  void add(Index node, double weight) { nodes[count] = node, weights[count] = weight, ++count; }

  /// All members but `stored` and `friction`, which the next step sets.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(nodes, weights, count, normal, gap, stiffness, inverse_effective_mass, impulse);
  }

  /// Velocity of the points relative to each other.
  Eigen::Vector3d velocity(const ContactNodes& all) const { return sum(all.v); }
  /// Change of that velocity by the forces of this step.
  Eigen::Vector3d kicked(const ContactNodes& all) const { return sum(all.kicked); }
  /// 1/m* = sum of w_I^2/m_I along a unit vector [1/mass]; 0 if conditions hold all its nodes.
  double inverse_effective_mass_along(const ContactNodes& all, const Eigen::Vector3d& a) const {
    double along = 0, free = 0;
    for (unsigned i = 0; i < count; ++i) {
      if (all.is_rigid(nodes[i])) continue;
      const double share = weights[i] * weights[i];
      free += share * all.inverse_mass(nodes[i]);
      along += share * all.inverse_mass_along(nodes[i], a);
    }
    return (along > 1e-6 * free ? along : 0) + on_bodies(all, a).response(all.bodies());
  }
  /// A unit impulse along a unit vector, as far as rigid bodies get it.
  detail::ContactBodies::Impulses on_bodies(const ContactNodes& all, const Eigen::Vector3d& a) const {
    detail::ContactBodies::Impulses impulses;
    for (unsigned i = 0; i < count; ++i)
      if (all.is_rigid(nodes[i])) impulses.add(all.bodies(), nodes[i], all.x[nodes[i]], weights[i] * a);
    return impulses;
  }
  /// The square of the least stable step of the cells at its nodes [time^2]; of rigid bodies alone that of the
  /// elements.
  double squared_step(const ContactNodes& all) const {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned i = 0; i < count; ++i)
      if (all.inverse_mass(nodes[i]) > 0 && !all.is_rigid(nodes[i]))
        least = std::min(least, all.squared_step(nodes[i]));
    return std::isinf(least) ? all.squared_step(nodes[0]) : least;
  }
  /// Gives the pair a normal impulse J [force time].
  void push(ContactNodes& all, double J) {
    using namespace detail;
    impulse += J;
    for (unsigned i = 0; i < count; ++i) all.push(nodes[i], (weights[i] * J) * normal);
  }
  /// Gives the pair an impulse of friction.
  void drag(ContactNodes& all, const Eigen::Vector3d& J) const {
    using namespace detail;
    for (unsigned i = 0; i < count; ++i) all.drag(nodes[i], weights[i] * J);
  }
  /// Books its impulse, which the velocities have got already.
  void book(ContactNodes& all) const {
    using namespace detail;
    if (impulse != 0)
      for (unsigned i = 0; i < count; ++i) all.book_push(nodes[i], (weights[i] * impulse) * normal);
  }

 private:
  Eigen::Vector3d sum(const std::vector<Eigen::Vector3d>& of) const {
    using namespace detail;
    Eigen::Vector3d total{0, 0, 0};
    for (unsigned i = 0; i < count; ++i) total += weights[i] * of[nodes[i]];
    return total;
  }
};

template <class N, class E>
void ContactNodes::gather_forces(const N& nodes, std::vector<ContactPair>& pairs, double kick, const E& execution) {
  using namespace detail;
  for (const ContactPair& pair : pairs)
    for (unsigned k = 0; k < pair.count; ++k) note_touched(pair.nodes[k]);
  for_each_chunk(execution, touched_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Index i = touched_[k];
      kicked[i] = is_rigid(i) ? bodies_.kicked_at(i, x[i])
                              : (inverse_mass_[i] * kick) * free(i, N::vector_of(nodes.force()[place_[i]]));
    }
  });
  for_each_chunk(execution, pairs.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p)
      pairs[p].inverse_effective_mass = pairs[p].inverse_effective_mass_along(*this, pairs[p].normal);
  });
}

}  // namespace strike
