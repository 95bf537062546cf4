#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// The rigid bodies of which a contact has nodes, in its own numbering of nodes.
class ContactBodies {
 public:
  struct Body {
    std::size_t number;              ///< among those of the run
    std::vector<Index> nodes;        ///< of the contact
    const RigidMotion* motion;       ///< in this step
    Eigen::Vector3d velocity, spin;  ///< with what `nudge` has added in it
  };

  template <class N>
  void begin(const N& nodes, std::span<const Index> numbers) {
    std::vector<int> mine(nodes.bodies().size(), none);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!nodes.is_rigid(numbers[i])) continue;
      const std::size_t b = nodes.body_of(numbers[i]);
      if (mine[b] == none) {
        mine[b] = static_cast<int>(all_.size());
        all_.push_back({b, {}, &nodes.bodies()[b], Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
      }
      of_.resize(numbers.size(), none);
      of_[i] = mine[b], all_[of(static_cast<Index>(i))].nodes.push_back(static_cast<Index>(i));
    }
    gathered_.assign(of_.size(), Eigen::Vector3d::Zero());
  }
  const std::vector<Body>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  bool has(Index i) const { return i < of_.size() && of_[i] != none; }
  std::size_t of(Index i) const { return static_cast<std::size_t>(of_[i]); }
  const Eigen::Vector3d& centre(Index i) const { return all_[of(i)].motion->centre(); }

  /// Takes the motion of the bodies, and the velocities of the nodes, at the start of the contact.
  template <class N>
  void gather(const N& nodes, const std::vector<Eigen::Vector3d>& v) {
    for (Body& body : all_) {
      body.motion = &nodes.bodies()[body.number];
      body.velocity = body.motion->velocity(), body.spin = body.motion->angular_velocity();
      for (const Index i : body.nodes) gathered_[i] = v[i];
    }
  }
  const Eigen::Vector3d& velocity_at(Index i) const { return gathered_[i]; }
  /// Change of the velocity of node i by the forces of this step.
  Eigen::Vector3d kicked_at(Index i, const Eigen::Vector3d& x) const { return all_[of(i)].motion->kicked_at(x); }

  /// RigidMotion::response of body b; 0 if its guides take all but rounding.
  double response(std::size_t b, const Eigen::Vector3d& impulse, const Eigen::Vector3d& of_moment) const {
    const RigidMotion& body = *all_[b].motion;
    const double guided = body.response(impulse, of_moment);
    return guided > 1e-9 * body.largest_response(impulse.norm(), of_moment.norm()) ? guided : 0;
  }
  /// No smaller than what an impulse on node i changes its velocity, along itself.
  double largest_response(Index i, const Eigen::Vector3d& x) const {
    return all_[of(i)].motion->largest_guided_response((x - centre(i)).norm());
  }
  /// An impulse on node i changes the velocities of all nodes of its body.
  void nudge(Index i, const Eigen::Vector3d& impulse, const std::vector<Eigen::Vector3d>& x,
             std::vector<Eigen::Vector3d>& v) {
    Body& body = all_[of(i)];
    body.velocity += body.motion->velocity_by(impulse);
    body.spin += body.motion->spin_by(cross(Eigen::Vector3d(x[i] - body.motion->centre()), impulse));
    for (const Index k : body.nodes)
      v[k] = body.velocity + cross(body.spin, Eigen::Vector3d(x[k] - body.motion->centre()));
  }
  /// Gives the bodies of the run the impulses on these nodes.
  template <class N, class Impulse>
  void scatter(N& nodes, std::span<const Index> touched, const std::vector<Eigen::Vector3d>& x,
               const Impulse& impulse) const {
    if (empty()) return;
    std::vector<Eigen::Vector3d> sum(all_.size(), Eigen::Vector3d::Zero()), of_moment = sum;
    for (const Index i : touched) {
      if (!has(i)) continue;
      const Eigen::Vector3d J = impulse(i);
      sum[of(i)] += J, of_moment[of(i)] += cross(Eigen::Vector3d(x[i] - centre(i)), J);
    }
    for (std::size_t b = 0; b < all_.size(); ++b) {
      RigidMotion& motion = nodes.bodies()[all_[b].number];
      motion.push_guided(sum[b], of_moment[b]);
      move_with(nodes, motion);
    }
  }

  /// Impulses on the nodes of a pair, summed body by body.
  class Impulses {
   public:
    void add(const ContactBodies& bodies, Index i, const Eigen::Vector3d& x, const Eigen::Vector3d& impulse) {
      std::size_t k = 0;
      while (k < count_ && on_[k].body != bodies.of(i)) ++k;
      if (k == count_) on_[count_++] = {bodies.of(i), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
      on_[k].impulse += impulse, on_[k].of_moment += cross(Eigen::Vector3d(x - bodies.centre(i)), impulse);
    }
    /// The velocity that they give the points on which they act, along themselves: the sum, and f(body, part).
    double response(const ContactBodies& bodies) const {
      double sum = 0;
      each_response(bodies, [&](std::size_t, double part) { sum += part; });
      return sum;
    }
    template <class F>
    void each_response(const ContactBodies& bodies, const F& f) const {
      for (std::size_t k = 0; k < count_; ++k)
        f(on_[k].body, bodies.response(on_[k].body, on_[k].impulse, on_[k].of_moment));
    }

   private:
    struct OnBody {
      std::size_t body;
      Eigen::Vector3d impulse, of_moment;
    };
    std::array<OnBody, 5> on_;
    std::size_t count_ = 0;
  };

 private:
  static constexpr int none = -1;

  std::vector<Body> all_;
  std::vector<int> of_;                    // of each node, or empty
  std::vector<Eigen::Vector3d> gathered_;  // velocities of the nodes at the start of the contact
};

}  // namespace strike::detail
