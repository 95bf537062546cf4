#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <strike/dynamics/elements.hpp>
#include <strike/dynamics/growth_of_rates.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/dynamics/removal.hpp>
#include <strike/element/element.hpp>
#include <strike/motion/gather.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// The schedule of a run without subcycling: all blocks of a part are advanced after a step, over the step, with the
/// velocities of the nodes.
struct EveryStep {
  double step;

  void load(const Patches&, const Patch&) const {}
  static constexpr bool is_due(std::size_t) { return true; }
  double dt(std::size_t) const { return step; }
  template <class Motion>
  const Motion& velocities(std::size_t, const Motion& motion) const {
    return motion;
  }
  template <class T, class A>
  const A& times_multiple(std::size_t, const A& a) const {
    return a;
  }
};

/// The outcome of a step for a patch; elements by their places.
struct Outcome {
  double critical_rate = 0, inverted_volume = 1;
  std::size_t slowest = 0, inverted = 0;
  double internal_work = 0, hourglass_work = 0, bulk_viscosity_work = 0;
  Deletions deletions{};
  GrowthOfRates<double> growth{};  // of elements that are followed
};

/// The same lane by lane on the way through the blocks of a patch, which are counted from its first.
template <class T>
struct LanesOfOutcome {
  T critical_rate = T(0.0), slowest = T(0.0), inverted_volume = T(1.0), inverted = T(0.0);
  T internal_work = T(0.0), hourglass_work = T(0.0), bulk_viscosity_work = T(0.0);

  /// `busy` is 0 in idle lanes.
  template <int n>
  void add(const T& block, const Response<T, n>& response, const T& rate, const T& busy) {
    slowest = select(critical_rate < rate, block, slowest);
    critical_rate = max(critical_rate, rate);
    const auto sound = response.volume > 0.0;
    inverted = select(sound, inverted, block);
    inverted_volume = select(sound, inverted_volume, response.volume);
    internal_work += busy * response.internal_work;
    hourglass_work += busy * response.hourglass_work;
    bulk_viscosity_work += busy * response.bulk_viscosity_work;
  }
  /// Over the lanes; `elements` are those of the part.
  void reduce(Outcome& outcome, std::size_t first_block, std::size_t elements) const {
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      const auto place_of = [&](const T& block) {
        const auto b = first_block + static_cast<std::size_t>(static_cast<double>(lane(block, l)));
        return std::min(b * lanes<T> + l, elements - 1);
      };
      if (const auto rate = static_cast<double>(lane(critical_rate, l)); outcome.critical_rate < rate)
        outcome.critical_rate = rate, outcome.slowest = place_of(slowest);
      if (const auto V = static_cast<double>(lane(inverted_volume, l)); !(V > 0))
        outcome.inverted_volume = V, outcome.inverted = place_of(inverted);
    }
    outcome.internal_work = static_cast<double>(reduce_sum(internal_work));
    outcome.hourglass_work = static_cast<double>(reduce_sum(hourglass_work));
    outcome.bulk_viscosity_work = static_cast<double>(reduce_sum(bulk_viscosity_work));
  }
};

/// Velocities that are gathered when an element that knows how to wait asks for them.
template <class E, class T, class Motion>
struct VelocitiesOf {
  static constexpr std::size_t n = static_cast<std::size_t>(E::nodes);
  const Motion& motion;
  const BlockNodes<n, lanes<T>>& nodes;

  operator Nodal<T, motions<E>>() const {
    if constexpr (turns_nodes<E>())
      return gather<T, n>(motion.velocity, motion.angular_velocity, nodes);
    else
      return gather<T, n>(motion.velocity, nodes);
  }
};

/// Prefetches a block two iterations ahead: left to itself the machine fetches states late. Always inline: g++ drops
/// calls of a function that only prefetches.
template <class Data>
[[gnu::always_inline]] inline void prefetch(const Data& data) {
  const char* begin = reinterpret_cast<const char*>(&data);
  for (std::size_t line = 0; line < sizeof(Data) / 64; ++line) __builtin_prefetch(begin + 64 * line, 1);
}

/// A model whose numbers no store into a block can change, so that they stay in registers; one that owns tables is not
/// copied.
template <class Model>
using Local = std::conditional_t<std::is_trivially_copyable_v<Model>, const Model, const Model&>;

/// Deletes elements of block b that the law does not keep; they get back the state that they had before the step over
/// dt. In its last step the forces at its start have done their half of the work, and those at its end do none:
/// `end_work()` is their half.
template <class E, class M, class T, class Removal, class EndWork>
void erode(Elements<E, M, T, Removal>& elements, std::size_t b, const typename Elements<E, M, T, Removal>::State& state,
           const Nodal<T, E::nodes>& x, double dt, Response<T, motions<E>>& response, Deletions& deletions,
           const EndWork& end_work) {
  auto& block = elements.blocks[b];
  auto& removal = block.removal;
  if (!(dt > 0)) removal.initial_volume = response.volume;
  const auto there = removal.alive > 0.0;
  const ElementCondition<E, M, T, Elements<E, M, T, Removal>::has_geometry> condition{
      response.volume, removal.initial_volume, response.critical_rate, x, removal.reference};
  const auto stays = there && elements.removal.keeps(state, condition) && response.volume > 0.0;
  if (all(stays)) {
    block.state = state;
    removal.energy += response.internal_work;
    return;
  }
  const T last = response.internal_work - end_work();
  const T finite = select(abs(last) <= std::numeric_limits<RealOf<T>>::max(), last, T(0.0));
  zero_if_failed(stays, response);
  response.internal_work = select(stays, response.internal_work, select(there, finite, T(0.0)));
  removal.energy += response.internal_work;
  const T left = select(stays, T(1.0), T(0.0));
  for (std::size_t l = 0; l < elements.count(b); ++l)
    if (lane(left, l) < lane(removal.alive, l)) deletions.add({1, static_cast<double>(lane(removal.energy, l))});
  removal.alive = left;
  visit_numbers<T>(block.state, state, [&](auto kept, auto now) {
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = select(stays, now[i], kept[i]);
  });
  if constexpr (requires { elements.element.record(block.state, response); })
    elements.element.record(block.state, response);
}

/// Advances the elements of a patch that are due and subtracts their forces from those of its nodes. `volume` is the
/// relative volume at the nodes, for elements that average it.
template <class E, class M, class T, class Removal, class Motion, class Volume, class Schedule>
[[gnu::__flatten__]] Outcome advance(Elements<E, M, T, Removal>& elements, const Patch& patch, Motion& motion,
                                     const Volume& volume, const Schedule& schedule) {
  using All = Elements<E, M, T, Removal>;
  constexpr std::size_t n = All::n;
  constexpr bool erodes = All::erodes, state_is_small = sizeof(typename All::State) < 32 * sizeof(T);
  Outcome outcome;
  LanesOfOutcome<T> sum;
  [[maybe_unused]] GrowthOfRates<T> growth;
  Local<E> element = elements.element;
  Local<M> material = elements.material;
  auto& blocks = elements.blocks;
  for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
    if (!schedule.is_due(b)) continue;
    auto& block = blocks[b];
    const double dt = schedule.dt(b);
    prefetch(blocks[std::min(b + 2, patch.last_block - 1)]);
    if constexpr (erodes)
      if (!any(block.removal.alive > 0.0)) continue;
    // A small state stays in registers while its element works on it.
    std::conditional_t<state_is_small || erodes, typename All::State, typename All::State&> state = block.state;
    const Nodal<T, E::nodes> x = gather<T, n>(motion.position, block.nodes);
    const VelocitiesOf<E, T, Motion> v{schedule.velocities(b, motion), block.nodes};
    using Answer = Response<T, motions<E>>;
    [[maybe_unused]] VibrationSources<T> sources;  // of elements that merge corners
    std::conditional_t<erodes || All::merges, Answer, const Answer> response = [&] {
      if constexpr (All::averages_volume)
        return element.advance(state, material, x, Nodal<T, motions<E>>(v), volume.template mean<T, n>(block.nodes),
                               dt);
      else if constexpr (All::merges)
        return element.advance(state, material, x, v, dt, &sources);
      else if constexpr (requires { element.advance(state, material, x, v, dt); })
        return element.advance(state, material, x, v, dt);
      else
        return element.advance(state, material, x, Nodal<T, motions<E>>(v), dt);
    }();
    if constexpr (All::merges)
      if (elements.merges_in(b)) {
        const VibrationSources<T> known = sources;
        const T rate = response.critical_rate, V = response.volume;
        response.critical_rate = elements.merged_rate(b, motion.position, rate, V, known);
        if constexpr (requires { element.record(state, response); }) element.record(state, response);
      }
    if constexpr (erodes)
      erode(elements, b, state, x, dt, response, outcome.deletions,
            [&] { return T(0.5 * dt * response.force.cwiseProduct(Nodal<T, motions<E>>(v)).sum()); });
    else if constexpr (state_is_small)
      block.state = state;
    if constexpr (Followed<typename All::State>) growth.add(state);
    const auto& force = schedule.template times_multiple<T>(b, response.force);
    scatter_subtract<T, n>(force, motion.force, block.nodes, elements.count(b));
    if constexpr (turns_nodes<E>()) scatter_subtract<T, n>(force, motion.moment, block.nodes, elements.count(b), n);
    sum.add(T(static_cast<double>(b - patch.first_block)), response,
            T(schedule.template times_multiple<T>(b, response.critical_rate)),
            b + 1 < blocks.size() ? T(1.0) : elements.busy());
  }
  sum.reduce(outcome, patch.first_block, elements.size);
  if constexpr (Followed<typename All::State>) outcome.growth = growth.reduced();
  return outcome;
}

/// Adds the volumes of the elements of a patch to their nodes; of a part that may lose elements, of those that are
/// left.
template <class E, class M, class T, class Removal, class Motion, class Volume>
void add_volumes(const Elements<E, M, T, Removal>& elements, const Patch& patch, const Motion& motion, Volume& volume) {
  using All = Elements<E, M, T, Removal>;
  constexpr std::size_t n = All::n;
  const auto& blocks = elements.blocks;
  for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
    const auto& block = blocks[b];
    prefetch(blocks[std::min(b + 4, patch.last_block - 1)].nodes);
    const T V = elements.element.volume(gather<T, n>(motion.position, block.nodes));
    if constexpr (All::loses_elements) {
      T share = intact_share<T>(elements.material, block.state.material);
      if constexpr (All::erodes) share = share * block.removal.alive;
      volume.template add<T, n>(select(share > 0.0, V, T(0.0)), share / block.state.inverse_volume, block.nodes,
                                elements.count(b));
    } else {
      volume.template add<T, n>(V, block.nodes, elements.count(b));
    }
  }
}

}  // namespace strike::detail
