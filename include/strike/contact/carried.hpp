#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/error.hpp>
#include <strike/mesh/frame.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/text.hpp>

namespace strike {

/// A rigid obstacle that moves and turns with the RigidBody to which the nodes of a frame belong, and pushes it back:
/// a wall of a mass, a roller that is driven, a ball.
///   const Frame frame = add_frame(nodes, centre, radius);
///   Scene{nodes, ..., RigidBody{frame.nodes, Inertia{mass, centre, moment}}.moving(velocity),
///         Contact{NodeToRigid{plate, Carried{RigidSphere{centre, radius}, frame}}}}
/// Errors: the nodes of the frame do not belong to one RigidBody; they lie in a plane.
template <RigidObstacle Body>
struct Carried {
  Body body;  ///< as it lies at the start
  Frame frame;

  void ranges(const auto& number) const { number(body); }

  Clearance clearance(const Eigen::Vector3d& x) const { return body.clearance(x); }
};

template <class Body>
Carried(Body, Frame) -> Carried<Body>;

namespace detail {

/// A rigid obstacle in a step, at rest.
template <RigidObstacle Body>
class ObstacleInMotion {
 public:
  explicit ObstacleInMotion(Body body) : body_(std::move(body)) {}

  void begin(const ContactNodes&) {}
  /// The node is a part of the obstacle.
  static bool is_of(const ContactNodes&, Index) { return false; }
  Clearance clearance(const ContactNodes&, const Eigen::Vector3d& x) const { return body_.clearance(x); }
  /// The velocity of its point at x.
  static Eigen::Vector3d velocity(const ContactNodes&, const Eigen::Vector3d&) { return Eigen::Vector3d::Zero(); }
  /// Makes its point at x the other side of a pair.
  static void add_to(ContactPair&, const ContactNodes&, const Eigen::Vector3d&) {}
  /// No smaller than 1/m* of its points as near as x, in any direction [1/mass].
  static double inverse_mass(const ContactNodes&, const Eigen::Vector3d&) { return 0; }

 private:
  Body body_;
};

/// The same, carried by a rigid body.
template <RigidObstacle Body>
class ObstacleInMotion<Carried<Body>> {
 public:
  explicit ObstacleInMotion(Carried<Body> carried) : carried_(std::move(carried)) {}

  void begin(const ContactNodes& all) {
    const std::vector<Index>& nodes = carried_.frame.nodes;
    if (nodes.size() != corners_.size())
      throw Error(joined({"strike: the frame of a Carried obstacle has ", std::to_string(nodes.size()),
                          " nodes; give it four, such as those of add_frame."}));
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Index number = nodes[k], corner = corners_[k] = all.local(number);
      if (!all.is_rigid(corner) || all.bodies().of(corner) != all.bodies().of(corners_[0]))
        throw Error(joined({"strike: node ", std::to_string(number),
                            " of the frame of a Carried obstacle does not belong to the RigidBody of its first node; "
                            "give one RigidBody all four."}));
    }
    of_ = all.bodies().of(corners_[0]);
    centre_ = motion(all).centre();
    first_ = all.x[corners_[0]];
    Eigen::Matrix3d edges;
    for (std::size_t k = 0; k < 3; ++k) set_column(edges, k, Eigen::Vector3d(all.x[corners_[k + 1]] - first_));
    const double longest = edges.colwise().norm().maxCoeff();
    if (!(std::abs(edges.determinant()) > 1e-6 * longest * longest * longest))
      throw Error(joined({"strike: the frame of a Carried obstacle, nodes ", std::to_string(all.number(corners_[0])),
                          " to ", std::to_string(all.number(corners_[3])),
                          ", lies in a plane; take nodes that span a body, such as those of add_frame."}));
    to_shares_ = edges.inverse();
  }
  bool is_of(const ContactNodes& all, Index i) const { return all.is_rigid(i) && all.bodies().of(i) == of_; }
  Clearance clearance(const ContactNodes& all, const Eigen::Vector3d& x) const {
    const auto [gap, normal] = carried_.body.clearance(at_start(all, x));
    return {gap, times<double>(motion(all).rotation(), normal)};
  }
  Eigen::Vector3d velocity(const ContactNodes& all, const Eigen::Vector3d& x) const {
    return motion(all).velocity_at(x);
  }
  void add_to(ContactPair& pair, const ContactNodes& all, const Eigen::Vector3d& x) const {
    const Eigen::Vector3d shares = times<double>(to_shares_, Eigen::Vector3d(at_start(all, x) - first_));
    pair.add(corners_[0], shares.sum() - 1);
    for (std::size_t k = 0; k < 3; ++k) pair.add(corners_[k + 1], -shares(static_cast<Eigen::Index>(k)));
  }
  double inverse_mass(const ContactNodes& all, const Eigen::Vector3d& x) const {
    return motion(all).largest_guided_response((x - motion(all).centre()).norm());
  }

 private:
  const RigidMotion& motion(const ContactNodes& all) const { return *all.bodies().all()[of_].motion; }
  /// The place of its point at x, at the start.
  Eigen::Vector3d at_start(const ContactNodes& all, const Eigen::Vector3d& x) const {
    const RigidMotion& now = motion(all);
    const Eigen::Matrix3d back = now.rotation().transpose();
    return centre_ + times<double>(back, Eigen::Vector3d(x - now.centre()));
  }

  Carried<Body> carried_;
  std::array<Index, 4> corners_{};  // of the frame, by the numbers of the contact
  std::size_t of_ = 0;              // the body, among those of the contact
  // At the start: its centre, the first corner, and what gives the shares of the others in a way from that.
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(), first_ = centre_;
  Eigen::Matrix3d to_shares_ = Eigen::Matrix3d::Identity();
};

}  // namespace detail

}  // namespace strike
