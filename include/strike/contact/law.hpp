#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
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
  const double s = 0.5 * kappa * dt * dt;
  return dt * std::sqrt(2 / (1 + std::sqrt(1 + s * s)));
}

/// Impulses that bring nodes to the surface at the end of the step: inelastic impacts of m*, without a stiffness or a
/// smaller step, at any speed. Pairs that share nodes are corrected one after the other, forward and backward in turn,
/// each with the velocities that the others have left; an impulse that they make needless is taken back (projected
/// Gauss-Seidel), until no correction is more than 1e-6 of the fastest approach: so their order does not count. Touches
/// begin with their force in the last step, so that what rests comes to rest, and most steps take few sweeps. A node
/// that is inside, because its neighbours moved its face, leaves no faster than it came in: no impulse adds energy.
struct Kinematic {
  int sweeps = 400;  ///< largest number of corrections of every pair in a step

  void ranges(const auto& number) const { number("sweeps", sweeps, range::at_least(1)); }

  template <Execution E = Serial>
  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step, const E& execution = {}) const {
    detail::CoupledPairs coupled(pairs, nodes, execution);
    std::vector<Approach> all(pairs.size());
    coupled.each(execution, [&](std::size_t p) { all[p] = approach(coupled, pairs[p], p, step); });
    coupled.each(execution, [&](std::size_t p) {
      if (all[p].impulse > 0) coupled.give(p, all[p].impulse);
    });
    correct(coupled, all, true, execution);
    if (work(coupled, all) > 0) {  // the guess was wrong: without it no impulse adds energy
      coupled.each(execution, [&](std::size_t p) { coupled.give(p, -all[p].impulse), all[p].impulse = 0; });
      correct(coupled, all, false, execution);
    }
    coupled.end(nodes, execution);
    coupled.each(execution, [&](std::size_t p) {
      *pairs[p].stored = all[p].impulse / step.kick();
      pairs[p].impulse = all[p].impulse, pairs[p].book(nodes);
    });
    return 0;
  }

 private:
  /// The normal approach of a pair.
  struct Approach {
    double before;                  // velocity before all impulses
    double wanted;                  // at least, after them
    double inverse_effective_mass;  // [1/mass]
    double effective_mass;
    double impulse;            // [force time]
    double change, direction;  // by the last sweep, and of the sweeps before
  };
  static Approach approach(const detail::CoupledPairs& coupled, const ContactPair& pair, std::size_t p,
                           const Step& step) {
    const double before = coupled.approach(p), w = pair.inverse_effective_mass;
    return {.before = before,
            .wanted = std::min(-pair.gap / step.dt, std::max(0.0, -before)),
            .inverse_effective_mass = w,
            .effective_mass = w > 0 ? 1 / w : 0.0,
            .impulse = w > 0 ? std::max(0.0, *pair.stored * step.kick()) : 0.0,
            .change = 0,
            .direction = 0};
  }
  /// Without a guess the last sweep takes nothing back, so that it leaves no depth. Where pairs hang together closely,
  /// each sweep is followed by what the sweeps before point to (nonsmooth nonlinear conjugate gradients, Silcowitz,
  /// Niebe and Erleben 2010).
  template <class E>
  void correct(detail::CoupledPairs& coupled, std::vector<Approach>& all, bool guessed, const E& execution) const {
    double fastest = 0, norm2 = 0;
    for (Approach& pair : all) fastest = std::max(fastest, std::abs(pair.before)), pair.direction = 0;
    for (detail::Settling settling(fastest, sweeps); settling.goes_on();) {
      const bool is_last = settling.is_last(), may_take_back = guessed || !is_last;
      settling.note(coupled.sweep(execution, settling.is_forward(), [&](std::size_t p) {
        Approach& pair = all[p];
        pair.change =
            std::max(may_take_back ? -pair.impulse : 0.0, (pair.wanted - coupled.approach(p)) * pair.effective_mass);
        pair.impulse += pair.change;
        coupled.give(p, pair.change);
        return std::abs(pair.change) * pair.inverse_effective_mass;
      }));
      if (is_last || settling.sweep() < detail::Settling::patience) continue;
      const double norm2_before = norm2;
      norm2 = 0;
      for (const Approach& pair : all) norm2 += pair.change * pair.change * pair.inverse_effective_mass;
      if (settling.sweep() == detail::Settling::patience) continue;
      const double share = norm2 / norm2_before;
      coupled.each(execution, [&](std::size_t p) {
        Approach& pair = all[p];
        if (share < 1 && pair.direction != 0) {
          const double J = std::max(-pair.impulse, share * pair.direction);
          coupled.give(p, J), pair.impulse += J;
        }
        pair.direction = share < 1 ? share * pair.direction + pair.change : 0;
      });
    }
  }
  /// The energy that impulses J have added: the sum of J (v- + v+)/2.
  static double work(const detail::CoupledPairs& coupled, const std::vector<Approach>& all) {
    double sum = 0;
    for (std::size_t p = 0; p < all.size(); ++p) sum += 0.5 * all[p].impulse * (all[p].before + coupled.approach(p));
    return sum;
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
    std::vector<double> sum(nodes.size(), 0.0);  // kappa_I
    std::vector<Spring> springs(pairs.size());
    coupled.each(execution, [&](std::size_t p) {
      ContactPair& pair = pairs[p];
      const double w = pair.inverse_effective_mass, own = fraction / pair.squared_step(nodes);
      pair.stiffness = !(w > 0) ? 0 : stiffness > 0 ? stiffness : own / w;
      springs[p] = {.most = stiffness > 0 ? std::numeric_limits<double>::infinity() : own,
                    .before = pair.normal.dot(coupled.velocity(p) - pair.kicked(nodes)),
                    .less = 0};
      double moved = 0;  // norm of the pair's row
      for (unsigned i = 0; i < pair.count; ++i)
        if (nodes.inverse_mass(pair.nodes[i]) > 0) moved += std::abs(pair.weights[i]);
      for (unsigned i = 0; i < pair.count; ++i)
        sum[pair.nodes[i]] += pair.stiffness * moved * std::abs(pair.weights[i]) * nodes.inverse_mass(pair.nodes[i]);
    });
    const double most = coupled.sweep(execution, true, [&](std::size_t p) {
      ContactPair& pair = pairs[p];
      double here = 0;
      for (unsigned i = 0; i < pair.count; ++i) here = std::max(here, sum[pair.nodes[i]]);
      if (here > springs[p].most) pair.stiffness *= springs[p].most / here;
      if (pair.gap < 0 && pair.inverse_effective_mass > 0) {
        const double held = std::sqrt(2 * std::max(0.0, *pair.stored) / pair.stiffness),
                     depth = std::min(-pair.gap, held + std::max(0.0, -springs[p].before) * step.dt_before);
        pair.impulse = pair.stiffness * depth * step.kick();
        coupled.give(p, pair.impulse);
      }
      return here;
    });
    limit_what_comes_back(pairs, springs, coupled, execution);
    coupled.end(nodes, execution);
    coupled.each(execution, [&](std::size_t p) { pairs[p].book(nodes); });
    // Constant from step to step, for a changing step would cost balance.
    return stiffness > 0 ? most : fraction / (step.stable_dt * step.stable_dt);
  }

 private:
  struct Spring {
    double most;    // kappa of a node [1/time^2]
    double before;  // approach before the forces of this step
    double less;    // impulse [force time]
  };
  /// Reduces the impulse of a spring that would give back more than it has stored, by its work along the mean of the
  /// velocities before and after the step, J (v- + v+)/2. A spring sampled in steps, entered and left within one, would
  /// otherwise add up to kappa dt^2/4 of the energy of an impact, and chatter near the stable step.
  template <class E>
  static void limit_what_comes_back(std::vector<ContactPair>& pairs, std::vector<Spring>& springs,
                                    detail::CoupledPairs& coupled, const E& execution) {
    const auto mean = [&](std::size_t p) { return 0.5 * (springs[p].before + coupled.approach(p)); };
    for (int sweep = 0; sweep < 2; ++sweep) {       // a smaller impulse adds work to what presses from the other side
      coupled.each(execution, [&](std::size_t p) {  // all from the same velocities, so that no order counts
        const double J = pairs[p].impulse, w = pairs[p].inverse_effective_mass, stored = *pairs[p].stored, v = mean(p);
        springs[p].less = 0;
        if (!(J * v > stored)) return;
        const double alone = v - 0.5 * w * J, left = std::max(0.0, alone * alone + 2 * w * stored);
        springs[p].less = J - std::clamp((std::sqrt(left) - alone) / w, 0.0, J);
      });
      coupled.each(execution, [&](std::size_t p) {
        if (springs[p].less > 0) coupled.give(p, -springs[p].less), pairs[p].impulse -= springs[p].less;
      });
    }
    coupled.each(execution, [&](std::size_t p) { *pairs[p].stored -= pairs[p].impulse * mean(p); });
  }
};

}  // namespace strike
