#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/protocol.hpp>

// The protocols of a contact: pairing, normal law, friction, rigid body.
namespace strike {

/// The distance of a point from a rigid body and the unit vector that leads away from it.
struct Clearance {
  double gap;  ///< negative inside [length]
  Eigen::Vector3d normal;
};

namespace detail {

struct InitialPenetration;

struct Press {
  struct Decoy {
    int press;
  };
  template <class Model>
  using Member = decltype(&Model::press);
  template <class Execution>
  static double call(const auto& law, std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step,
                     const Execution& execution) {
    if constexpr (requires { law.press(pairs, nodes, step, execution); })
      return law.press(pairs, nodes, step, execution);
    else
      return law.press(pairs, nodes, step);
  }
};
struct Kappa {
  struct Decoy {
    int kappa;
  };
  template <class Model>
  using Member = decltype(&Model::kappa);
  static double call(const auto& law, double inverse_effective_mass)
    requires requires {
      { law.kappa(inverse_effective_mass) } -> std::convertible_to<double>;
    }
  {
    return law.kappa(inverse_effective_mass);
  }
};
struct Impulse {
  struct Decoy {
    int impulse;
  };
  template <class Model>
  using Member = decltype(&Model::impulse);
};
struct ClearanceOf {
  struct Decoy {
    int clearance;
  };
  template <class Model>
  using Member = decltype(&Model::clearance);
};
struct Points {
  struct Decoy {
    int points;
  };
  template <class Model>
  using Member = decltype(&Model::points);
  static std::vector<Eigen::Vector3d> call(const auto& pairing)
    requires requires {
      { pairing.points() } -> std::convertible_to<std::vector<Eigen::Vector3d>>;
    }
  {
    return pairing.points();
  }
};
struct Find {
  template <class Execution>
  static void call(auto& meeting, const ContactNodes& nodes, const Step& step, std::vector<ContactPair>& pairs,
                   const Execution& execution)
    requires requires { meeting.find(nodes, step, pairs, execution); } || requires { meeting.find(nodes, step, pairs); }
  {
    if constexpr (requires { meeting.find(nodes, step, pairs, execution); })
      meeting.find(nodes, step, pairs, execution);
    else
      meeting.find(nodes, step, pairs);
  }
};
struct Remove {
  struct Decoy {
    int remove;
  };
  template <class Model>
  using Member = decltype(&Model::remove);
  static void call(auto& meeting, std::size_t part, const std::vector<bool>& alive, const ContactNodes& nodes)
    requires requires { meeting.remove(part, alive, nodes); }
  {
    meeting.remove(part, alive, nodes);
  }
};
struct ClosingStep {
  struct Decoy {
    int closing_step;
  };
  template <class Model>
  using Member = decltype(&Model::closing_step);
  static double call(auto& meeting, const ContactNodes& nodes, double moved, double dt)
    requires requires {
      { meeting.closing_step(nodes, moved, dt) } -> std::convertible_to<double>;
    }
  {
    return meeting.closing_step(nodes, moved, dt);
  }
};
struct See {
  struct Decoy {
    int see;
  };
  template <class Model>
  using Member = decltype(&Model::see);
  static void call(auto& pairing, std::span<const PartFaces> parts)
    requires requires { pairing.see(parts); }
  {
    pairing.see(parts);
  }
};

}  // namespace detail

/// A normal law: the impulses along the normals of pairs.
///
/// 1. It is copyable.
/// 2. `press(pairs, nodes, step) const` gives each pair of the std::vector<ContactPair> its impulse J [force time] by
///    `pair.push(nodes, J)`, and returns the largest stiffness over mass that it has set on a node, kappa [1/time^2],
///    from which the stable step follows; 0 if there is none. Or `press(pairs, nodes, step, execution)`, which may use
///    the Execution of the run.
/// 3. `kappa(inverse_effective_mass) const`, optional: the kappa that the first touch of a pair with 1/m* may set,
///    where that can exceed what the step allows.
///
/// Laws that no compiler checks: it never pulls, J >= 0; a contact gives back no more energy than it took; the result
/// does not depend on threads. `testing::conforms_as_contact` checks them.
///
/// Models: Kinematic, Penalty.
template <class L>
concept ContactLaw =
    std::copyable<L> && requires(const L law, std::vector<ContactPair> pairs, ContactNodes nodes, const Step step) {
      { law.press(pairs, nodes, step) } -> std::convertible_to<double>;
    };

/// The friction of a contact.
///
/// 1. It is copyable.
/// 2. `impulse(normal, stops) const` is the impulse against the sliding, from the normal impulse and from the impulse
///    that would stop the sliding [force time].
///
/// Laws that no compiler checks: the impulse is between 0 and `stops`. In a run of dual numbers, which a RigidPlane
/// alone can have, `impulse` is a template over the number.
///
/// Models: Frictionless, Coulomb.
template <class F>
concept Friction = std::copyable<F> && requires(const F friction) {
  { friction.impulse(1.0, 1.0) } -> std::convertible_to<double>;
};

/// A rigid body at rest, given by a formula.
///
/// 1. It is copyable.
/// 2. `clearance(x) const` is the Clearance of the point x: the signed distance to the surface and its gradient.
///
/// Laws that no compiler checks: the distance is never more than the true one, for a node that flies past is followed
/// by it; the gradient is a unit vector.
///
/// Models: RigidPlane, RigidSphere, RigidCylinder.
template <class B>
concept RigidObstacle = std::copyable<B> && requires(const B body, const Eigen::Vector3d x) {
  { body.clearance(x) } -> std::same_as<Clearance>;
};

/// A pairing at work: the nodes and faces of one run, with their touches.
///
/// 1. `begin(nodes, inside)` is called once; it adds nodes that start inside to the InitialPenetration.
/// 2. `find(nodes, step, pairs)` appends the pairs of the step, in the order of the nodes' numbers; or
///    `find(nodes, step, pairs, execution)`, which may use the Execution of the run.
/// 3. `largest_inverse_mass()` bounds the 1/m* of all pairs [1/mass].
/// 4. `serialize(archive)`: see strike/output/archive.hpp.
/// 5. `remove(part, alive, nodes)`, optional: cells of a part have gone.
/// 6. `closing_step(nodes, moved, dt)`, optional: a step of at most dt in which nothing that comes to touch closes
///    by more than its gap and a tenth of a cell, when the nodes have moved for the time `moved` at their velocities.
///
/// Laws that no compiler checks: `pair.stored` stays the same number as long as a touch lasts, and begins at 0.
///
/// Models: detail::SurfaceMeeting, detail::Approach, detail::RigidApproach.
template <class M>
concept Meeting = requires(M meeting, const M same, const ContactNodes nodes, detail::InitialPenetration& inside,
                           const Step step, std::vector<ContactPair> pairs) {
  meeting.begin(nodes, inside);
  detail::Find::call(meeting, nodes, step, pairs, Serial{});
  { same.largest_inverse_mass() } -> std::convertible_to<double>;
};

/// A pairing: nodes, and what they may touch.
///
/// 1. It is copyable.
/// 2. `numbers() const` are the numbers of all nodes that it concerns, in ascending order.
/// 3. `first() const` are the numbers of the nodes whose force `Contact::force` sums.
/// 4. `start(nodes) const` is its Meeting with these ContactNodes.
/// 5. `points() const`, optional: positions that never move and are counted after the nodes [length].
/// 6. `see(parts)`, optional: before all others, in a run, the std::span<const PartFaces> of the scene; throws an Error
///    if the pairing names a part, or cells of a part, that are not there.
///
/// Models: NodeToSurface, TwoWay, SelfContact, Everything, NodeToRigid.
template <class P>
concept Pairing = std::copyable<P> && requires(const P pairing, const ContactNodes nodes) {
  { pairing.numbers() } -> std::convertible_to<std::vector<Index>>;
  { pairing.first() } -> std::convertible_to<std::vector<Index>>;
  { pairing.start(nodes) } -> Meeting;
};

}  // namespace strike
