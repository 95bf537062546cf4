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
#include <strike/load/body_guides.hpp>
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

/// Nodes that move as one body: those of cells, which carry no stress and take no time, of a density or with an inertia
/// of the body's own; or any nodes, with an inertia beside the masses that they have from elements, or a TotalInertia
/// with these. Its centre of mass may lie anywhere: a body force acts there, the masses of the nodes do not count in
/// its motion. Elements may share its nodes, loads and contacts act on them, an InitialVelocity sets it in motion.
/// Guides hold or move it: HeldBody, PinnedBody, BodyVelocity, BodyDisplacement, BodySpin, BodyAngle. Errors: no nodes;
/// a node in two bodies, or under another condition; an inertia that no body has; velocities at the start that no rigid
/// motion has; guides that exclude each other.
///   RigidBody{Mesh{mesh.nodes, ball}, 7850}
///   RigidBody{Mesh{mesh.nodes, ball}, Inertia{0.1, centre, moment}}.with_nodes(nodes)
///   RigidBody{nodes, Inertia{0.1, centre, moment}, HeldBody{{unit(Axis::x)}}}
///   RigidBody{nodes, TotalInertia{{0.1, centre, moment}}}
template <class... Guides>
class RigidBody {
 public:
  static constexpr bool is_rigid_body = true;

  explicit RigidBody(std::vector<Index> nodes, const Inertia& own = {}, Guides... guides)
      : nodes_(detail::ascending(std::move(nodes))), own_(own), guides_(std::move(guides)...) {}
  RigidBody(std::vector<Index> nodes, const TotalInertia& whole, Guides... guides)
      : RigidBody(std::move(nodes), static_cast<const Inertia&>(whole), std::move(guides)...) {
    replaces_ = is_total_ = true;
  }
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
    is_of_cells_ = true;
  }
  RigidBody(const Mesh& mesh, double density, Guides... guides)
    requires(!(std::is_arithmetic_v<Guides> || ...))
      : RigidBody(mesh, density, 0.0, std::move(guides)...) {}
  /// The cells of a mesh, whose mass, centre of mass and moment of inertia are these; plates have this thickness.
  RigidBody(const Mesh& mesh, const Inertia& own, double thickness, Guides... guides)
      : RigidBody(mesh, 1.0, thickness, std::move(guides)...) {
    for (double& m : masses_) m *= own.mass / own_.mass;
    own_ = own, replaces_ = true;
  }
  RigidBody(const Mesh& mesh, const Inertia& own, Guides... guides)
    requires(!(std::is_arithmetic_v<Guides> || ...))
      : RigidBody(mesh, own, 0.0, std::move(guides)...) {}
  RigidBody(const Mesh& mesh, const TotalInertia& whole, double thickness, Guides... guides)
      : RigidBody(mesh, static_cast<const Inertia&>(whole), thickness, std::move(guides)...) {
    is_total_ = true;
  }
  RigidBody(const Mesh& mesh, const TotalInertia& whole, Guides... guides)
    requires(!(std::is_arithmetic_v<Guides> || ...))
      : RigidBody(mesh, whole, 0.0, std::move(guides)...) {}

  const std::vector<Index>& nodes_named() const { return nodes_; }

  /// The same body with more nodes, by which it carries what hangs on them. Their masses from elements are its own too.
  RigidBody with_nodes(std::vector<Index> more) const {
    RigidBody other = *this;
    for (const Index i : more) {
      const auto at = std::lower_bound(other.nodes_.begin(), other.nodes_.end(), i);
      if (at != other.nodes_.end() && *at == i) continue;
      if (is_of_cells_) other.masses_.insert(other.masses_.begin() + (at - other.nodes_.begin()), 0.0);
      other.nodes_.insert(at, i);
    }
    return other;
  }
  /// The same body, which begins with this velocity of the centre of its own inertia, or of its centre of mass if it
  /// has none, and this angular velocity [1/time], whatever an InitialVelocity gives its nodes.
  RigidBody moving(const Eigen::Vector3d& velocity,
                   const Eigen::Vector3d& angular_velocity = Eigen::Vector3d::Zero()) const {
    RigidBody other = *this;
    other.start_ = {velocity, angular_velocity};
    return other;
  }

  void ranges(const auto& number) const {
    number(own_);
    if (start_) number("velocity", start_->velocity, range::point);
    if (start_) number("angular_velocity", start_->angular_velocity, range::point);
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
    number_ = nodes.bodies().size();
    check_inertia(nodes);
    const std::vector<double> masses = nodal_masses(nodes);
    nodes.add_body(nodes_, whole(nodes), pivot);
    Inertia lumped;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      lumped.add(masses[k] + (is_total_ ? nodes.mass(nodes_[k]) : 0), nodes.x(nodes_[k]).template cast<double>());
      nodes.add_mass(nodes_[k], masses[k]);
    }
    RigidMotion& body = nodes.bodies()[number_];
    body.set_beside_nodes(own_.mass - lumped.mass,
                          own_.mass * (own_.centre - body.centre()) - lumped.mass * (lumped.centre - body.centre()));
    guide(body);
  }

  /// Takes the motion of its nodes at the start.
  template <class N>
  void start_body(N& nodes) {
    RigidMotion& body = nodes.bodies()[number_];
    if (start_) {
      const Eigen::Vector3d from =
          own_.mass > 0 ? Eigen::Vector3d(body.centre() - own_.centre) : Eigen::Vector3d::Zero();
      body.set(start_->velocity + cross(start_->angular_velocity, from), start_->angular_velocity);
      momentum_ = body.momentum();
      detail::move_with(nodes, body);
      return;
    }
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
    Eigen::Vector3d force = body.force_beside_nodes(), moment = body.moment_beside_nodes();
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
    if (spin_before_.isZero(0)) momentum_.setZero();  // a relaxation has stopped what is pinned
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
  /// Errors: an inertia that no body has; none about an axis about which nodes turn.
  template <class N>
  void check_inertia(const N& nodes) const {
    const auto refuse = [&](const std::string& why) {
      throw Error(detail::joined({"strike: the rigid body ", std::to_string(number_), ": ", why, "."}));
    };
    if (const std::string fault = detail::fault_of(own_, replaces_); !fault.empty()) refuse(fault);
    if (is_total_)
      if (const std::string fault = detail::fault_of(TotalInertia{own_}, with_nodes_of({}, nodes)); !fault.empty())
        refuse(fault);
    const Inertia all = whole(nodes);
    Inertia even;
    for (const Index i : nodes_) even.add(1, nodes.x(i).template cast<double>());
    if (!(all.mass > 0)) return;  // told where masses are checked
    const std::optional<Eigen::Vector3d> line = RigidMotion::axis_without_inertia(all.moment);
    const double size = trace(even.moment), about = line ? line->dot(even.moment * *line) : 0;
    if (size > 0 && (!(trace(all.moment) > 0) || about > 1e-6 * size))
      refuse("its nodes lie apart and it has no moment of inertia; give its Inertia one");
  }
  /// An inertia with that which the nodes have from elements.
  template <class N>
  Inertia with_nodes_of(Inertia all, const N& nodes) const {
    for (const Index i : nodes_) {
      all.add(nodes.mass(i), nodes.x(i).template cast<double>());
      if constexpr (N::nodes_turn) all.moment += SymmetricTensor<double>::isotropic(nodes.inertia(i));
    }
    return all;
  }
  template <class N>
  Inertia whole(const N& nodes) const {
    return is_total_ ? own_ : with_nodes_of(own_, nodes);
  }
  /// Masses of the nodes: of cells theirs, else those that have the sum and the centre of its own if there are such, m
  /// (1 + a . (x - mean)), or equal ones. Nodes without any mass get a mean one. By none of these does the body move.
  template <class N>
  std::vector<double> nodal_masses(const N& nodes) const {
    std::vector<double> masses = is_of_cells_ ? masses_ : shares(nodes);
    double all = own_.mass;
    if (!is_total_)
      for (const Index i : nodes_) all += nodes.mass(i);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (!(masses[k] + nodes.mass(nodes_[k]) > 0)) masses[k] = all / static_cast<double>(nodes_.size());
    return masses;
  }
  template <class N>
  std::vector<double> shares(const N& nodes) const {
    double mass = own_.mass;  // beside that of elements
    if (is_total_)
      for (const Index i : nodes_) mass -= nodes.mass(i);
    std::vector<double> masses(nodes_.size(), std::max(0.0, mass) / static_cast<double>(nodes_.size()));
    if (!(mass > 0)) return masses;
    Inertia even;
    for (const Index i : nodes_) even.add(1, nodes.x(i).template cast<double>());
    // sum of (x - mean)(x - mean), which is tr(J)/2 I - J; lifted where the nodes lie in a plane or a line
    const double size = trace(even.moment);
    const SymmetricTensor<double> second =
        SymmetricTensor<double>::isotropic(0.5 * size + 1e-9 * size + 1e-300) + (-1.0) * even.moment;
    const Eigen::Vector3d way = own_.centre - even.centre, a = even.mass * (inverse(second) * way);
    std::vector<double> linear = masses;
    double least = 1;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const double share = 1 + a.dot(nodes.x(nodes_[k]).template cast<double>() - even.centre);
      linear[k] *= share, least = std::min(least, share);
    }
    return least > 1e-3 ? linear : masses;
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
  std::vector<double> masses_;                   // of the nodes, from its cells
  bool is_of_cells_ = false, replaces_ = false;  // it has cells; its inertia is not theirs
  bool is_total_ = false;                        // with the masses that its nodes have from elements
  struct Start {
    Eigen::Vector3d velocity, angular_velocity;
  };
  std::optional<Start> start_ = {};
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
template <class... Guides>
RigidBody(std::vector<Index>, TotalInertia, Guides...) -> RigidBody<Guides...>;
template <class Thickness, class... Guides>
  requires std::is_arithmetic_v<Thickness>
RigidBody(Mesh, double, Thickness, Guides...) -> RigidBody<Guides...>;
template <class... Guides>
  requires(!(std::is_arithmetic_v<Guides> || ...))
RigidBody(Mesh, double, Guides...) -> RigidBody<Guides...>;
template <class Thickness, class... Guides>
  requires std::is_arithmetic_v<Thickness>
RigidBody(Mesh, Inertia, Thickness, Guides...) -> RigidBody<Guides...>;
template <class... Guides>
  requires(!(std::is_arithmetic_v<Guides> || ...))
RigidBody(Mesh, Inertia, Guides...) -> RigidBody<Guides...>;
template <class Thickness, class... Guides>
  requires std::is_arithmetic_v<Thickness>
RigidBody(Mesh, TotalInertia, Thickness, Guides...) -> RigidBody<Guides...>;
template <class... Guides>
  requires(!(std::is_arithmetic_v<Guides> || ...))
RigidBody(Mesh, TotalInertia, Guides...) -> RigidBody<Guides...>;

}  // namespace strike
