#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/coupled_pairs.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The stable step of elements whose own stable step is `dt`, with a contact of kappa = k/m* [1/time^2] on some of
/// their nodes: dt sqrt(2/(1 + sqrt(1 + s^2))), s = kappa dt^2/2. Exact for the end of a uniform chain [derived]: the
/// spectrum of the chain seen from there is the arcsine law on [0, W^2], W = 2/dt, so that its resolvent is
/// 1/sqrt(w^2 (w^2 - W^2)), and the bound state above the spectrum has w^2 (w^2 - W^2) = kappa^2.
inline double stable_step_with_contact(double dt, double kappa) {
  if (!(kappa > 0)) return dt;
  if (std::isinf(dt)) return 2 / std::sqrt(kappa);  // of a spring alone
  const double s = 0.5 * kappa * dt * dt;
  return dt * std::sqrt(2 / (1 + std::sqrt(1 + s * s)));
}

/// Impulses that bring nodes to the surface at the end of the step: inelastic impacts of m*, without a stiffness or a
/// smaller step, at any speed. The impulses of pairs that share nodes follow together (CoupledPairs::settle), each from
/// the velocities that all leave, and none pulls: until no pair misses more than 1e-6 of the fastest approach, or after
/// `iterations`, where more is asked of nodes than they can give; the next step takes up what is left. Touches begin
/// with their force in the last step, so that what rests comes to rest, and most steps take few iterations. A node that
/// is inside, because its neighbours moved its face, leaves no faster than it came in: no impulse adds energy.
struct Kinematic {
  int iterations = 50;  ///< in a step at most

  void ranges(const auto& number) const { number("iterations", iterations, range::at_least(1)); }

  template <Execution E = Serial>
  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step, const E& execution = {}) const {
    detail::CoupledPairs coupled(pairs, nodes, execution);
    std::vector<double> before(pairs.size()), wanted(pairs.size()), impulses(pairs.size());  // before all impulses
    const double fastest = coupled.largest(execution, [&](std::size_t p) {
      const ContactPair& pair = pairs[p];
      before[p] = coupled.approach(p);
      wanted[p] = std::min(-pair.gap / step.dt, std::max(0.0, -before[p]));
      impulses[p] = pair.inverse_effective_mass > 0 ? std::max(0.0, *pair.stored * step.kick()) : 0.0;
      return std::abs(before[p]);
    });
    coupled.give(execution, impulses);
    const auto settle = [&] {
      coupled.settle(
          execution, impulses, 1e-6 * fastest, iterations,
          [&](std::size_t p) { return wanted[p] - coupled.approach(p); },
          [](std::size_t, double J) { return std::max(0.0, J); });
    };
    settle();
    double work = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) work += 0.5 * impulses[p] * (before[p] + coupled.approach(p));
    if (work > 0) {  // the guess was wrong: without it no impulse adds energy
      coupled.take_back(execution, impulses, 0.0);
      settle();
    }
    coupled.end(nodes, execution);
    coupled.each(execution, [&](std::size_t p) {
      *pairs[p].stored = impulses[p] / step.kick();
      pairs[p].impulse = impulses[p];
    });
    coupled.each_share(execution, impulses, [&](Index i, const Eigen::Vector3d& J) { nodes.book_push(i, J); });
    return 0;
  }
};

/// Springs k against the depth at the time n. Without a `stiffness`, k = fraction m*/dt^2 with the least stable step dt
/// of the cells at the nodes of the pair (ContactNodes::squared_step), whatever bounds the step elsewhere and whatever
/// shortens it; scaled so that kappa_I dt^2 <= fraction with kappa_I = sum of k |w_I| (sum of |w_J|)/m_I over the pairs
/// of node I, a bound of the highest frequency (Gershgorin): the step stays nearly that of the elements. With one, the
/// step becomes as small as it needs. No spring gives back more energy than it took, and one whose k grows presses by
/// the depth at which the new k holds that energy.
struct Penalty {
  double fraction = 0.5;  ///< of m*/dt^2, between 0 and 2
  double stiffness = 0;   ///< of each pair [force/length]; 0: by the fraction

  void ranges(const auto& number) const {
    number("fraction", fraction, Range{.low = 0, .high = 2, .without_high = false});
    number("stiffness", stiffness, range::not_negative);
  }

  double kappa(double inverse_effective_mass) const { return stiffness * inverse_effective_mass; }
  template <Execution E = Serial>
  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step, const E& execution = {}) const {
    detail::CoupledPairs coupled(pairs, nodes, execution);
    std::vector<Spring> springs(pairs.size());
    coupled.each(execution, [&](std::size_t p) {
      ContactPair& pair = pairs[p];
      const double w = pair.inverse_effective_mass, own = fraction / pair.squared_step(nodes);
      pair.stiffness = !(w > 0) ? 0 : stiffness > 0 ? stiffness : own / w;
      springs[p] = {.most = stiffness > 0 ? std::numeric_limits<double>::infinity() : own,
                    .before = pair.normal.dot(coupled.velocity(p) - pair.kicked(nodes))};
      for (unsigned i = 0; i < pair.count; ++i)
        if (moves(nodes, pair.nodes[i])) springs[p].moved += std::abs(pair.weights[i]);
    });
    // kappa_I
    const std::vector<double> sums = coupled.sums_at_nodes(execution, [&](Index i, std::size_t p, double weight) {
      return moves(nodes, i) ? pairs[p].stiffness * springs[p].moved * std::abs(weight) * nodes.inverse_mass(i) : 0;
    });
    // Of a rigid body, on which all springs pull, the trace bounds the highest frequency.
    std::vector<double> of_body(nodes.bodies().all().size(), 0.0);
    coupled.each_on_bodies([&](std::size_t p) {
      pairs[p].on_bodies(nodes, pairs[p].normal).each_response(nodes.bodies(), [&](std::size_t b, double response) {
        of_body[b] += pairs[p].stiffness * response;
      });
    });
    std::vector<double> impulses(pairs.size(), 0.0);
    coupled.each(execution, [&](std::size_t p) {
      ContactPair& pair = pairs[p];
      double here = coupled.largest_at_nodes(sums, p);
      pair.on_bodies(nodes, pair.normal).each_response(nodes.bodies(), [&](std::size_t b, double) {
        here += of_body[b];
      });
      if (here > springs[p].most) pair.stiffness *= springs[p].most / here;
      if (pair.gap < 0 && pair.inverse_effective_mass > 0) {
        const double held = std::sqrt(2 * std::max(0.0, *pair.stored) / pair.stiffness),
                     depth = std::min(-pair.gap, held + std::max(0.0, -springs[p].before) * step.dt_before);
        impulses[p] = pair.stiffness * depth * step.kick();
      }
    });
    coupled.give(execution, impulses);
    limit_what_comes_back(pairs, springs, impulses, coupled, execution);
    coupled.end(nodes, execution);
    coupled.each_share(execution, impulses, [&](Index i, const Eigen::Vector3d& J) { nodes.book_push(i, J); });
    // Constant from step to step, for a changing step would cost balance.
    if (!(stiffness > 0)) return fraction / (step.stable_dt * step.stable_dt);
    const double of_node = sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
    return std::accumulate(of_body.begin(), of_body.end(), of_node);
  }

 private:
  /// The node moves by an impulse on it, and alone.
  static bool moves(const ContactNodes& nodes, Index i) { return nodes.inverse_mass(i) > 0 && !nodes.is_rigid(i); }

  struct Spring {
    double most;       // kappa of a node [1/time^2]
    double before;     // approach before the forces of this step
    double moved = 0;  // norm of the pair's row
  };
  /// Reduces the impulse of a spring that would give back more than it has stored, by its work along the mean of the
  /// velocities before and after the step, J (v- + v+)/2. A spring sampled in steps, entered and left within one, would
  /// otherwise add up to kappa dt^2/4 of the energy of an impact, and chatter near the stable step.
  template <class E>
  static void limit_what_comes_back(std::vector<ContactPair>& pairs, const std::vector<Spring>& springs,
                                    std::vector<double>& impulses, detail::CoupledPairs& coupled, const E& execution) {
    const auto mean = [&](std::size_t p) { return 0.5 * (springs[p].before + coupled.approach(p)); };
    std::vector<double> less(pairs.size());
    for (int sweep = 0; sweep < 2; ++sweep) {       // a smaller impulse adds work to what presses from the other side
      coupled.each(execution, [&](std::size_t p) {  // all from the same velocities, so that no order counts
        const double J = impulses[p], w = pairs[p].inverse_effective_mass, stored = *pairs[p].stored, v = mean(p);
        less[p] = 0;
        if (!(J * v > stored)) return;
        const double alone = v - 0.5 * w * J, left = std::max(0.0, alone * alone + 2 * w * stored);
        const double given = std::clamp((std::sqrt(left) - alone) / w, 0.0, J);
        less[p] = given - J, impulses[p] = given;
      });
      coupled.give(execution, less);
    }
    coupled.each(execution, [&](std::size_t p) {
      pairs[p].impulse = impulses[p];
      *pairs[p].stored -= impulses[p] * mean(p);
    });
  }
};

}  // namespace strike
