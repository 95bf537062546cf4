#pragma once
// A law along the normals, a friction and a rigid body of one's own.
#include <algorithm>
#include <vector>

#include <strike/contact.hpp>

namespace strike {

/// A node leaves with a part of the speed with which it came (Newton's restitution).
struct Restitution {
  double coefficient;

  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step) const {
    for (ContactPair& pair : pairs) {
      const double approach = pair.normal.dot(pair.velocity(nodes));
      if (!(pair.gap + step.dt * approach < 0) || !(approach < 0) || !(pair.inverse_effective_mass > 0)) continue;
      pair.push(nodes, -(1 + coefficient) * approach / pair.inverse_effective_mass);
    }
    return 0;  // no stiffness: the step may stay as it is
  }
};

/// Coulomb's friction up to what the surface can bear.
struct LimitedFriction {
  double coefficient, largest;

  double impulse(double normal, double stops) const { return std::min({coefficient * normal, largest, stops}); }
};

/// A rigid torus about the z axis.
struct RigidTorus {
  double radius, tube;

  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d ring = radius * Eigen::Vector3d(x.x(), x.y(), 0).normalized(), r = x - ring;
    return {r.norm() - tube, r.normalized()};
  }
};

}  // namespace strike
