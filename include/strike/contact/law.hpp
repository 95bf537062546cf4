#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/error.hpp>
#include <strike/motion/step.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

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

namespace detail {
/// The largest change of velocity in a sweep over pairs that share nodes, relative to the fastest, after which they
/// need no other.
inline constexpr double settled = 1e-6;
}  // namespace detail

/// Impulses that bring nodes to the surface at the end of the step: inelastic impacts of m*, without a stiffness or a
/// smaller step, at any speed. Pairs that share nodes are corrected one after the other, forward and backward in turn,
/// each with the velocities that the others have left; an impulse that they make needless is taken back (projected
/// Gauss-Seidel), until no correction is more than 1e-6 of the fastest approach: so their order does not count. Touches
/// begin with their force in the last step, so that what rests comes to rest, and most steps take two sweeps. A node
/// that is inside, because its neighbours moved its face, leaves no faster than it came in: no impulse adds energy.
struct Kinematic {
  int sweeps = 400;  ///< largest number of corrections of every pair in a step

  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step) const {
    std::vector<double> approach(pairs.size());  // before all impulses
    for (std::size_t p = 0; p < pairs.size(); ++p) approach[p] = pairs[p].normal.dot(pairs[p].velocity(nodes));
    for (ContactPair& pair : pairs)
      if (pair.inverse_effective_mass > 0 && *pair.stored > 0) pair.nudge(nodes, *pair.stored * step.kick());
    correct(pairs, approach, nodes, step, true);
    if (work(pairs, approach, nodes) > 0) {  // the guess was wrong: without it no impulse adds energy
      for (ContactPair& pair : pairs) pair.nudge(nodes, -pair.impulse);
      correct(pairs, approach, nodes, step, false);
    }
    for (ContactPair& pair : pairs) pair.book(nodes), *pair.stored = pair.impulse / step.kick();
    return 0;
  }

 private:
  /// Without a guess the last sweep takes nothing back, so that it leaves no depth. Where pairs hang together closely,
  /// each sweep is followed by what the sweeps before point to (nonsmooth nonlinear conjugate gradients, Silcowitz,
  /// Niebe and Erleben 2010).
  void correct(std::vector<ContactPair>& pairs, const std::vector<double>& before, ContactNodes& nodes,
               const Step& step, bool guessed) const {
    double fastest = 0;
    for (const double v : before) fastest = std::max(fastest, std::abs(v));
    std::vector<double> direction, change(pairs.size());
    double most = std::numeric_limits<double>::infinity(), norm2 = 0;
    for (int sweep = 0; sweep < sweeps && most > detail::settled * fastest; ++sweep) {
      const double norm2_before = norm2;
      most = norm2 = 0;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::size_t p = sweep % 2 == 0 ? k : pairs.size() - 1 - k;
        ContactPair& pair = pairs[p];
        const double now = pair.normal.dot(pair.velocity(nodes)), w = pair.inverse_effective_mass;
        const double wanted = std::min(-pair.gap / step.dt, std::max(0.0, -before[p]));
        const bool takes_back = pair.impulse > 0 && (guessed || sweep + 1 < sweeps);
        change[p] = 0;
        if (!(w > 0) || !(now < wanted || takes_back)) continue;
        change[p] = std::max(-pair.impulse, (wanted - now) / w);
        pair.nudge(nodes, change[p]);
        most = std::max(most, std::abs(change[p]) * w), norm2 += change[p] * change[p] * w;
      }
      if (sweep < 4 || sweep + 2 >= sweeps) continue;
      if (direction.empty()) direction.assign(pairs.size(), 0.0);
      const double share = norm2 / norm2_before;
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (share < 1 && direction[p] != 0) pairs[p].nudge(nodes, std::max(-pairs[p].impulse, share * direction[p]));
        direction[p] = share < 1 ? share * direction[p] + change[p] : 0;
      }
    }
  }
  /// The energy that impulses J have added: the sum of J (v- + v+)/2.
  static double work(const std::vector<ContactPair>& pairs, const std::vector<double>& before,
                     const ContactNodes& nodes) {
    double sum = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p)
      sum += 0.5 * pairs[p].impulse * (before[p] + pairs[p].normal.dot(pairs[p].velocity(nodes)));
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

  double kappa(double inverse_effective_mass) const { return stiffness * inverse_effective_mass; }
  double press(std::vector<ContactPair>& pairs, ContactNodes& nodes, const Step& step) const {
    using namespace detail;
    std::vector<double> sum(nodes.size(), 0.0);  // kappa_I
    const auto add = [&](const ContactPair& pair) {
      double moved = 0;  // norm of the pair's row
      for (unsigned i = 0; i < pair.count; ++i)
        if (nodes.inverse_mass(pair.nodes[i]) > 0) moved += std::abs(pair.weights[i]);
      for (unsigned i = 0; i < pair.count; ++i)
        sum[pair.nodes[i]] += pair.stiffness * moved * std::abs(pair.weights[i]) * nodes.inverse_mass(pair.nodes[i]);
    };
    std::vector<double> allowed;  // kappa of each pair
    for (ContactPair& pair : pairs) {
      const double w = pair.inverse_effective_mass;
      allowed.push_back(stiffness > 0 ? std::numeric_limits<double>::infinity() : fraction / pair.squared_step(nodes));
      pair.stiffness = !(w > 0) ? 0 : stiffness > 0 ? stiffness : allowed.back() / w;
      add(pair);
    }
    double most = 0;
    std::vector<double> before;  // velocities before the forces of this step
    for (ContactPair& pair : pairs) {
      double here = 0;
      for (unsigned i = 0; i < pair.count; ++i) here = std::max(here, sum[pair.nodes[i]]);
      most = std::max(most, here);
      if (const double most_here = allowed[before.size()]; here > most_here) pair.stiffness *= most_here / here;
      before.push_back(pair.normal.dot(pair.velocity(nodes) - pair.kicked(nodes)));
    }
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      ContactPair& pair = pairs[p];
      if (!(pair.gap < 0 && pair.inverse_effective_mass > 0)) continue;
      const double held = std::sqrt(2 * std::max(0.0, *pair.stored) / pair.stiffness),
                   depth = std::min(-pair.gap, held + std::max(0.0, -before[p]) * step.dt_before);
      pair.push(nodes, pair.stiffness * depth * step.kick());
    }
    limit_what_comes_back(pairs, before, nodes);
    // Constant from step to step, for a changing step would cost balance.
    return stiffness > 0 ? most : fraction / (step.stable_dt * step.stable_dt);
  }

 private:
  /// Reduces the impulse of a spring that would give back more than it has stored, by its work along the mean of the
  /// velocities before and after the step, J (v- + v+)/2. A spring sampled in steps, entered and left within one, would
  /// otherwise add up to kappa dt^2/4 of the energy of an impact, and chatter near the stable step.
  static void limit_what_comes_back(std::vector<ContactPair>& pairs, const std::vector<double>& before,
                                    ContactNodes& nodes) {
    const auto mean = [&](std::size_t p) { return 0.5 * (before[p] + pairs[p].normal.dot(pairs[p].velocity(nodes))); };
    std::vector<double> less(pairs.size());    // all from the same velocities, so that no order counts
    for (int sweep = 0; sweep < 2; ++sweep) {  // a smaller impulse adds work to what presses from the other side
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        const double J = pairs[p].impulse, w = pairs[p].inverse_effective_mass, stored = *pairs[p].stored, v = mean(p);
        less[p] = 0;
        if (!(J * v > stored)) continue;
        const double alone = v - 0.5 * w * J, left = std::max(0.0, alone * alone + 2 * w * stored);
        less[p] = J - std::clamp((std::sqrt(left) - alone) / w, 0.0, J);
      }
      for (std::size_t p = 0; p < pairs.size(); ++p)
        if (less[p] > 0) pairs[p].push(nodes, -less[p]);
    }
    for (std::size_t p = 0; p < pairs.size(); ++p) *pairs[p].stored -= pairs[p].impulse * mean(p);
  }
};

namespace detail {

/// Error: numbers of a law that make no sense.
inline void check_law(const Penalty& law) {
  if (!(law.fraction > 0 && law.fraction <= 2) || !(law.stiffness >= 0))
    throw Error(
        joined({"strike: a Penalty has the fraction ", text(law.fraction), " and the stiffness ", text(law.stiffness),
                "; give a fraction of m*/dt^2 between 0 and 2, and a positive stiffness or none."}));
}
inline void check_law(const Kinematic& law) {
  if (law.sweeps < 1)
    throw Error(joined(
        {"strike: a Kinematic law makes ", std::to_string(law.sweeps), " sweeps; give 1 or more, such as 100."}));
}
inline void check_law(const auto&) {}

}  // namespace detail

}  // namespace strike
