#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/error.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/mesh/inertia.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

/// A direction along which a rigid body moves, or an axis about which it turns, as a history tells.
template <class History, class Kind, bool turns>
class BodyGuide {
 public:
  using LoadHistory = History;
  static constexpr bool is_moved = true;

  BodyGuide(const Eigen::Vector3d& direction, History history) : given_(direction), history_(std::move(history)) {}
  BodyGuide(Axis axis, History history) : BodyGuide(unit(axis), std::move(history)) {}

  void ranges(const auto& number) const {
    number(turns ? "axis" : "direction", given_, range::direction);
    number(history_);
  }
  std::vector<Eigen::Vector3d> directions() const { return turns ? none() : std::vector{given_}; }
  std::vector<Eigen::Vector3d> axes() const { return turns ? std::vector{given_} : none(); }
  double velocity(const Step& step) { return Kind::velocity(history_, step); }

 private:
  static std::vector<Eigen::Vector3d> none() { return {}; }

  Eigen::Vector3d given_;
  History history_;
};

}  // namespace detail

/// Directions along which the centre of a rigid body does not move, and axes about which the body does not turn.
///   HeldBody{{unit(Axis::x)}, {unit(Axis::y), unit(Axis::z)}}
class HeldBody {
 public:
  static constexpr bool is_moved = false;

  explicit HeldBody(std::vector<Eigen::Vector3d> directions, std::vector<Eigen::Vector3d> axes = {})
      : directions_(std::move(directions)), axes_(std::move(axes)) {}

  void ranges(const auto& number) const {
    for (const auto& direction : directions_) number("direction", direction, range::direction);
    for (const auto& axis : axes_) number("axis", axis, range::direction);
  }
  const std::vector<Eigen::Vector3d>& directions() const { return directions_; }
  const std::vector<Eigen::Vector3d>& axes() const { return axes_; }
  double velocity(const Step&) const { return 0; }

 private:
  std::vector<Eigen::Vector3d> directions_, axes_;
};

/// A point of a rigid body that does not move: it turns about that.
class PinnedBody : public HeldBody {
 public:
  explicit PinnedBody(Eigen::Vector3d point)
      : HeldBody({unit(Axis::x), unit(Axis::y), unit(Axis::z)}), point_(std::move(point)) {}

  void ranges(const auto& number) const { number("point", point_, range::point); }
  const Eigen::Vector3d& point() const { return point_; }

 private:
  Eigen::Vector3d point_;
};

/// The centre of a rigid body moves along a direction with a history of velocity, or of displacement.
///   BodyVelocity{Axis::z, Constant{-5}}
template <class History>
struct BodyVelocity : detail::BodyGuide<History, detail::FromVelocity, false> {
  using detail::BodyGuide<History, detail::FromVelocity, false>::BodyGuide;
};
template <class History>
BodyVelocity(Eigen::Vector3d, History) -> BodyVelocity<History>;
template <class History>
BodyVelocity(Axis, History) -> BodyVelocity<History>;
template <class History>
struct BodyDisplacement : detail::BodyGuide<History, detail::FromDisplacement, false> {
  using detail::BodyGuide<History, detail::FromDisplacement, false>::BodyGuide;
};
template <class History>
BodyDisplacement(Eigen::Vector3d, History) -> BodyDisplacement<History>;
template <class History>
BodyDisplacement(Axis, History) -> BodyDisplacement<History>;

/// A rigid body turns about an axis that keeps its direction with a history of angular velocity, or of an angle [rad];
/// hold it about the other two where they shall not turn.
template <class History>
struct BodySpin : detail::BodyGuide<History, detail::FromVelocity, true> {
  using detail::BodyGuide<History, detail::FromVelocity, true>::BodyGuide;
};
template <class History>
BodySpin(Eigen::Vector3d, History) -> BodySpin<History>;
template <class History>
BodySpin(Axis, History) -> BodySpin<History>;
template <class History>
struct BodyAngle : detail::BodyGuide<History, detail::FromDisplacement, true> {
  using detail::BodyGuide<History, detail::FromDisplacement, true>::BodyGuide;
};
template <class History>
BodyAngle(Eigen::Vector3d, History) -> BodyAngle<History>;
template <class History>
BodyAngle(Axis, History) -> BodyAngle<History>;

/// Nodes that move as one body: those of cells of a density, which carry no stress and take no time; or any nodes, with
/// an inertia of their own beside the masses that they have from elements. Elements may share them, loads and contacts
/// act on them, an InitialVelocity sets it in motion. Guides hold or move it: HeldBody, PinnedBody, BodyVelocity,
/// BodyDisplacement, BodySpin, BodyAngle. Errors: no nodes; a node in two bodies, or under another condition;
/// velocities at the start that no rigid motion has; guides that exclude each other.
///   RigidBody{Mesh{mesh.nodes, ball}, 7850}
///   RigidBody{nodes, Inertia{0.1, centre, moment}, HeldBody{{unit(Axis::x)}}}
template <class... Guides>
class RigidBody {
 public:
  static constexpr bool is_rigid_body = true;

  explicit RigidBody(std::vector<Index> nodes, const Inertia& own = {}, Guides... guides)
      : nodes_(detail::ascending(std::move(nodes))), own_(own), guides_(std::move(guides)...) {}
  /// The cells of a mesh, of this density; plates have this thickness.
  RigidBody(const Mesh& mesh, double density, double thickness, Guides... guides) : guides_(std::move(guides)...) {
    std::vector<double> nodal(mesh.nodes.size(), 0.0);
    own_ = inertia(mesh, density, thickness, nodal);
    cells_ = {{}, mesh.hexahedra, mesh.tetrahedra, mesh.quadrilaterals, mesh.triangles};
    PartFaces solids{.cells = mesh.hexahedra.size() + mesh.tetrahedra.size()};
    detail::append_faces(solids.faces, mesh.hexahedra, detail::hexahedron_faces, 0);
    detail::append_faces(solids.faces, mesh.tetrahedra, detail::tetrahedron_faces, mesh.hexahedra.size());
    if (solids.cells > 0) outside_.push_back(std::move(solids));
    const auto add_plates = [&](std::vector<Face> plates) {
      const std::size_t count = plates.size();
      if (count > 0) outside_.push_back({.cells = count, .faces = std::move(plates), .thickness = thickness});
    };
    add_plates(quadrilateral_surface(mesh.quadrilaterals)), add_plates(triangle_surface(mesh.triangles));
    for (std::size_t i = 0; i < nodal.size(); ++i)
      if (nodal[i] > 0) nodes_.push_back(static_cast<Index>(i)), masses_.push_back(nodal[i]);
  }
  RigidBody(const Mesh& mesh, double density, Guides... guides)
    requires(!(std::is_arithmetic_v<Guides> || ...))
      : RigidBody(mesh, density, 0.0, std::move(guides)...) {}

  void ranges(const auto& number) const {
    number(own_);
    std::apply([&](const auto&... guide) { (number(guide), ...); }, guides_);
  }

  /// Its number among the rigid bodies of the run: `run.nodes().bodies()[number()]` is its motion.
  std::size_t number() const { return number_; }
  /// Its cells, if it has been made of some.
  const Mesh& cells() const { return cells_; }
  /// The force and the moment of its guides on it in the last step.
  const Eigen::Vector3d& force() const { return force_; }
  const Eigen::Vector3d& moment() const { return moment_; }

  /// Adds its cells to what contacts know of the scene, behind the parts.
  void add_faces(std::vector<PartFaces>& parts) const { parts.insert(parts.end(), outside_.begin(), outside_.end()); }

  template <class N>
  void add_body(N& nodes) {
    static_assert(std::is_same_v<typename N::Number, double>,
                  "strike: a RigidBody computes in double; a run of dual numbers would lose its derivatives.");
    if (nodes_.empty()) throw Error("strike: a RigidBody has no nodes; give it some.");
    for (const Index i : nodes_) nodes.check_number(i);
    std::optional<Eigen::Vector3d> pivot;
    each_guide([&](const auto& guide) {
      if constexpr (requires { guide.point(); }) pivot = guide.point();
    });
    number_ = nodes.add_body(nodes_, own_, pivot);
    if (masses_.empty()) share_mass(nodes);
    for (std::size_t k = 0; k < nodes_.size(); ++k) nodes.add_mass(nodes_[k], masses_[k]);
    guide(nodes.bodies()[number_]);
  }

  /// Takes the motion of its nodes at the start.
  template <class N>
  void start_body(N& nodes) {
    RigidMotion& body = nodes.bodies()[number_];
    Inertia even;
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), of_momentum = momentum;
    for (const Index i : nodes_) even.add(nodes.mass(i), nodes.x(i).template cast<double>());
    double fastest = 0;
    for (const Index i : nodes_) {
      const Eigen::Vector3d v = nodes.v(i), p = nodes.mass(i) * v;
      momentum += p, fastest = std::max(fastest, v.norm());
      of_momentum += cross(Eigen::Vector3d(nodes.x(i).template cast<double>() - even.centre), p);
    }
    RigidMotion fitted({}, {}, even);
    fitted.push(momentum, of_momentum);
    body.set(fitted.velocity_at(body.centre()), fitted.angular_velocity());
    momentum_ = body.momentum();
    for (const Index i : nodes_)
      if (const Eigen::Vector3d v = nodes.v(i), rigid = body.velocity_at(nodes.x(i).template cast<double>());
          (v - rigid).norm() > 1e-5 * fastest)
        throw Error(detail::joined({"strike: node ", std::to_string(i), " of the rigid body ", std::to_string(number_),
                                    " begins with the velocity ", detail::text(v), ", the body there with ",
                                    detail::text(rigid), "; give all its nodes one InitialVelocity."}));
  }
  /// It turns by no more than this in a step [rad].
  static constexpr double largest_turn = 0.3;
  template <class N>
  double stable_step(double dt, const N& nodes) const {
    return std::min(dt, largest_turn / nodes.bodies()[number_].angular_velocity().norm());
  }

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) {
    RigidMotion& body = nodes.bodies()[number_];
    const double kick = step.kick();
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
    double apart = 0;  // kinetic energy of the nodes, as if they were free
    for (const Index i : nodes_) {
      const Eigen::Vector3d x = nodes.x(i), f = nodes.f(i), v = nodes.v(i);
      force += f, moment += cross(Eigen::Vector3d(x - body.centre()), f);
      apart += 0.5 * (nodes.mass(i) * v - kick * f).dot(v);
      if constexpr (N::nodes_turn) {
        const Eigen::Vector3d w = nodes.w(i), of_node = nodes.moment(i);
        moment += of_node;
        apart += 0.5 * (nodes.inertia(i) * w - kick * of_node).dot(w);
      }
    }
    velocity_before_ = body.velocity(), spin_before_ = body.angular_velocity();
    body.push(kick * force, kick * moment);
    ledger.kinetic +=
        0.5 * (body.mass() * velocity_before_.dot(body.velocity()) + spin_before_.dot(body.angular_momentum())) - apart;
    find_velocities(step);
    force_.setZero(), moment_.setZero();
    keep_to_guides(body, step, ledger);
    body.note_kick(velocity_before_, spin_before_);
    detail::move_with(nodes, body);
  }

  /// After contacts have pushed it.
  template <class N, class Ledger>
  void move_body(N& nodes, const Step& step, Ledger& ledger) {
    RigidMotion& body = nodes.bodies()[number_];
    book_guided(body, step, ledger);
    if (body.is_pinned()) {  // the pin takes the change of the momentum too
      force_ += (body.momentum() - momentum_) / step.kick();
      momentum_ = body.momentum();
    }
    const Eigen::Vector3d before = body.angular_momentum();
    ledger.external.book_impulse(0, 2 * body.move(step.dt, rates_));
    moment_ += (body.angular_momentum() - before) / step.kick();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
    archive(force_, moment_, momentum_);
  }

 private:
  /// Masses of the nodes that have the sum and the centre of its own: m (1 + a . (x - mean)), which need not be equal.
  template <class N>
  void share_mass(const N& nodes) {
    masses_.assign(nodes_.size(), 0.0);
    if (!(own_.mass > 0)) return;
    Inertia even;
    for (const Index i : nodes_) even.add(1, nodes.x(i).template cast<double>());
    // sum of (x - mean)(x - mean), which is tr(J)/2 I - J; lifted where the nodes lie in a plane or a line
    const double size = trace(even.moment);
    const SymmetricTensor<double> second =
        SymmetricTensor<double>::isotropic(0.5 * size + 1e-9 * size + 1e-300) + (-1.0) * even.moment;
    const Eigen::Vector3d way = own_.centre - even.centre, a = even.mass * (inverse(second) * way);
    const double extent = std::sqrt(size);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double least = 1;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Eigen::Vector3d x = nodes.x(nodes_[k]).template cast<double>();
      const double share = 1 + a.dot(x - even.centre);
      masses_[k] = own_.mass / even.mass * share, least = std::min(least, share);
      centre += share / even.mass * x;
    }
    if (!(least > 0) || (centre - own_.centre).norm() > 1e-6 * extent)
      throw Error(detail::joined({"strike: the centre of mass ", detail::text(own_.centre), " of the rigid body ",
                                  std::to_string(number_), " is not well within its nodes, whose mean is ",
                                  detail::text(even.centre), "; give it nodes on all sides of it."}));
  }

  /// Makes the directions and axes orthonormal: each less its parts along those before it.
  void guide(RigidMotion& body) {
    std::vector<Eigen::Vector3d> directions, axes;
    std::size_t mine = 0;
    const auto add = [&](std::vector<Eigen::Vector3d>& all, std::vector<Row>& rows, const Eigen::Vector3d& given,
                         bool is_moved) {
      Row row{.of = mine, .less = {}, .size = 1, .is_moved = is_moved};
      Eigen::Vector3d direction = detail::direction(given);
      for (std::size_t k = 0; k < all.size(); ++k) {
        row.less[k] = all[k].dot(direction);
        direction -= row.less[k] * all[k];
      }
      row.size = direction.norm();
      if (!(row.size > 1e-6)) {
        if (!is_moved && std::none_of(rows.begin(), rows.end(), [](const Row& other) { return other.is_moved; }))
          return;
        throw Error(detail::joined({"strike: the rigid body ", std::to_string(number_), " is told twice how to ",
                                    &all == &axes ? "turn about " : "move along ", detail::text(given),
                                    "; take one of the guides away."}));
      }
      all.push_back(direction / row.size), rows.push_back(row);
    };
    rows_.clear(), turns_.clear();
    each_guide([&](const auto& guide) {
      for (const Eigen::Vector3d& d : guide.directions()) add(directions, rows_, d, guide.is_moved);
      for (const Eigen::Vector3d& a : guide.axes()) add(axes, turns_, a, guide.is_moved);
      ++mine;
    });
    body.guide(std::move(directions), std::move(axes));
  }
  void find_velocities(const Step& step) {
    std::vector<double> told;
    each_guide([&](auto& guide) { told.push_back(guide.velocity(step)); });
    const auto find = [&](const std::vector<Row>& rows, std::vector<double>& velocities) {
      velocities.clear();
      for (const Row& row : rows) {
        double velocity = told[row.of];
        for (std::size_t k = 0; k < velocities.size(); ++k) velocity -= row.less[k] * velocities[k];
        velocities.push_back(velocity / row.size);
      }
    };
    find(rows_, velocities_), find(turns_, rates_);
  }
  /// Gives the body the impulses of its guides and books their work.
  template <class Ledger>
  void keep_to_guides(RigidMotion& body, const Step& step, Ledger& ledger) {
    const std::array<double, 3> impulses = body.impulses_along(velocities_), moments = body.moments_about(rates_);
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero(), of_moment = impulse;
    for (std::size_t k = 0; k < rows_.size(); ++k) impulse += impulses[k] * body.directions()[k];
    for (std::size_t k = 0; k < turns_.size(); ++k) of_moment += moments[k] * body.axes()[k];
    body.push(impulse, of_moment);
    book(body, impulse, of_moment, step, ledger);
  }
  /// Books what the guides have taken of the impulses of contacts.
  template <class Ledger>
  void book_guided(RigidMotion& body, const Step& step, Ledger& ledger) {
    const auto [impulse, of_moment] = body.take_guided();
    book(body, impulse, of_moment, step, ledger);
  }
  template <class Ledger>
  void book(const RigidMotion& body, const Eigen::Vector3d& impulse, const Eigen::Vector3d& of_moment, const Step& step,
            Ledger& ledger) {
    const auto book_one = [&](const Row& row, double J, double before, double after) {
      if (row.is_moved)
        ledger.external.book_impulse(J * before, J * after);
      else
        ledger.contact.book_impulse(-J * before, -J * after);
    };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Eigen::Vector3d& along = body.directions()[k];
      book_one(rows_[k], along.dot(impulse), along.dot(velocity_before_), velocities_[k]);
    }
    for (std::size_t k = 0; k < turns_.size(); ++k) {
      const Eigen::Vector3d& about = body.axes()[k];
      book_one(turns_[k], about.dot(of_moment), about.dot(spin_before_), rates_[k]);
    }
    force_ += impulse / step.kick(), moment_ += of_moment / step.kick();
  }

  void each_guide(const auto& f) {
    std::apply([&](auto&... guide) { (f(guide), ...); }, guides_);
  }

  struct Row {
    std::size_t of;              // number of the guide
    std::array<double, 3> less;  // parts along the directions before
    double size;                 // of what is left
    bool is_moved;
  };

  std::vector<Index> nodes_;
  std::vector<double> masses_;      // of its own, of the nodes
  Mesh cells_;                      // without nodes
  std::vector<PartFaces> outside_;  // of these
  Inertia own_;
  std::tuple<Guides...> guides_;
  std::size_t number_ = 0;
  std::vector<Row> rows_, turns_;                  // of the directions and axes of the motion
  std::vector<double> velocities_, rates_;         // along and about them in this step
  Eigen::Vector3d velocity_before_, spin_before_;  // half a step ago
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), moment_ = Eigen::Vector3d::Zero(),
                  momentum_ = Eigen::Vector3d::Zero();  // of what is pinned, half a step ago
};

template <class... Guides>
RigidBody(std::vector<Index>, Inertia, Guides...) -> RigidBody<Guides...>;
template <class Thickness, class... Guides>
  requires std::is_arithmetic_v<Thickness>
RigidBody(Mesh, double, Thickness, Guides...) -> RigidBody<Guides...>;
template <class... Guides>
  requires(!(std::is_arithmetic_v<Guides> || ...))
RigidBody(Mesh, double, Guides...) -> RigidBody<Guides...>;

}  // namespace strike
