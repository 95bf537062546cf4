#pragma once
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/coupled_pairs.hpp>
#include <strike/motion/step.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// The part of a vector along the surface.
inline Eigen::Vector3d along(const ContactPair& pair, const Eigen::Vector3d& a) {
  return a - pair.normal.dot(a) * pair.normal;
}

/// Friction against the velocity along the surface that the normal impulses have left: the impulses of all pairs
/// follow together, and begin with their friction in the last step, so that what sticks does not creep; without it if
/// that would add energy. Contacts of any pairing and normal law share it.
template <class Friction, class Execution>
void rub(const Friction& friction, std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step,
         const Execution& execution) {
  // An impulse that would stop the sliding, as far as the friction gives it.
  const auto bounded = [&](const ContactPair& pair, const Eigen::Vector3d& stopping) {
    const double stops = stopping.norm();
    return stops > 0 ? Eigen::Vector3d((friction.impulse(pair.impulse, stops) / stops) * stopping) : stopping;
  };
  CoupledPairs coupled(pairs, nodes, execution);
  const Eigen::Vector3d none{0, 0, 0};
  std::vector<Eigen::Vector3d> impulses(pairs.size(), none), before(pairs.size());  // velocities without friction
  const double fastest = coupled.largest(execution, [&](std::size_t p) {
    const ContactPair& pair = pairs[p];
    before[p] = coupled.velocity(p);
    if (pair.friction && pair.impulse > 0)
      impulses[p] = bounded(pair, Eigen::Vector3d(step.kick() * along(pair, *pair.friction)));
    return along(pair, before[p]).norm();
  });
  coupled.give(execution, impulses);
  const auto settle = [&] {
    constexpr int iterations = 50;
    coupled.settle(
        execution, impulses, 1e-6 * fastest, iterations,
        [&](std::size_t p) { return Eigen::Vector3d(-along(pairs[p], coupled.velocity(p))); },
        [&](std::size_t p, const Eigen::Vector3d& J) { return pairs[p].impulse > 0 ? bounded(pairs[p], J) : none; });
  };
  settle();
  double work = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) work += 0.5 * impulses[p].dot(before[p] + coupled.velocity(p));
  if (work > 0) {
    coupled.take_back(execution, impulses, none);
    settle();
  }
  coupled.end(nodes, execution);
  coupled.each(execution, [&](std::size_t p) {
    if (pairs[p].friction) *pairs[p].friction = (1 / step.kick()) * impulses[p];
  });
  coupled.each_share(execution, impulses, [&](Index i, const Eigen::Vector3d& J) { nodes.book_drag(i, J); });
}

}  // namespace strike::detail
