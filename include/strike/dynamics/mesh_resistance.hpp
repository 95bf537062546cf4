#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/deal.hpp>
#include <strike/dynamics/estimated_blocks.hpp>
#include <strike/dynamics/lanczos.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/element/element.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/gather.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// Chooses in block b and adds the masses there; failed elements have no rate and no part in the estimate. Returns how
/// many it has chosen.
template <class Part, class E, class T, class Nodes, class Masses>
std::size_t choose_in_block(Part& part, EstimatedPart<E, T>& estimated, std::size_t b, double dt, Nodes& nodes,
                            const std::vector<char>& near, Masses& masses, double& rate_of_others) {
  constexpr std::size_t n = Part::n;
  const auto& corners = part.blocks()[b].nodes;
  auto& state = part.blocks()[b].state;
  const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
  const auto is_near = [&](std::size_t l) {
    return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) { return near[place(corner[l])]; });
  };
  T chosen = T(0.0);
  for (std::size_t l = 0; l < lanes<T>; ++l)
    if (is_near(l)) set_lane(chosen, l, RealOf<T>(1));
  state.follow(chosen);
  const auto is_chosen = state.followed.per_estimated > 0.0;
  rate_of_others =
      std::max(rate_of_others, static_cast<double>(reduce_max(select(is_chosen, T(0.0), state.followed.now))));
  if (!any(is_chosen)) return 0;

  auto& resistance = estimated.resistance[b];
  const auto& motion = nodes.motion();
  const Nodal<T, E::nodes> x = gather<T, n>(motion.position, corners);
  if constexpr (turns_nodes<E>())
    resistance = part.element().resistance(state, part.material(), x,
                                           gather<T, n>(motion.velocity, motion.angular_velocity, corners), dt);
  else
    resistance = part.element().resistance(state, part.material(), x, gather<T, n>(motion.velocity, corners), dt);
  std::size_t count = 0;
  for (std::size_t l = 0; l < part.count(b); ++l)
    if (lane(state.followed.per_estimated, l) > 0) {
      ++count;
      std::array<Index, n> cell;
      for (std::size_t i = 0; i < n; ++i) cell[i] = corners[i][l];
      const std::array<double, n> shares = corner_shares(cell, merges_corners<E>());
      for (std::size_t i = 0; i < n; ++i) {
        masses[0][cell[i]] += static_cast<RealOf<T>>(shares[i]) * lane(resistance.mass, l);
        if constexpr (turns_nodes<E>()) masses[1][cell[i]] += lane(resistance.inertia, l);
      }
    }
  return count;
}

/// f(b) for the blocks of a patch with chosen elements.
template <class Part, class F>
void for_each_chosen(const Part& part, const Patch& patch, const F& f) {
  for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
    const auto is_chosen = part.blocks()[b].state.followed.per_estimated > 0.0;
    if (any(is_chosen)) f(b, is_chosen);
  }
}

/// Adds the volumes of chosen elements, and what the motion q changes of them, at their nodes.
template <class Part, class E, class T, class Nodes, class Vector>
[[gnu::__flatten__]] void add_chosen_volumes(const Part& part, EstimatedPart<E, T>& estimated, const Patch& patch,
                                             Nodes& nodes, const std::vector<Vector>& q) {
  constexpr std::size_t n = Part::n;
  for_each_chosen(part, patch, [&](std::size_t b, const auto& is_chosen) {
    const auto& corners = part.blocks()[b].nodes;
    const auto V =
        estimated.resistance[b].volume(gather<T, n>(nodes.motion().position, corners), gather<T, n>(q, corners));
    estimated.volume.template add<T, n>(select(is_chosen, V.change, T(0.0)), select(is_chosen, V.present, T(0.0)),
                                        corners, part.count(b));
  });
}

/// product -= A q of the chosen elements of a patch.
template <class Part, class E, class T, class Nodes, class Fields>
[[gnu::__flatten__]] void subtract_chosen(const Part& part, const EstimatedPart<E, T>& estimated, const Patch& patch,
                                          Nodes& nodes, const Fields& q, Fields& product) {
  constexpr std::size_t n = Part::n;
  for_each_chosen(part, patch, [&](std::size_t b, const auto& is_chosen) {
    const auto& corners = part.blocks()[b].nodes;
    const auto& resistance = estimated.resistance[b];
    const Nodal<T, E::nodes> x = gather<T, n>(nodes.motion().position, corners);
    const Nodal<T, motions<E>> all = [&] {
      if constexpr (turns_nodes<E>())
        return resistance(x, gather<T, n>(q[0], q[1], corners));
      else if constexpr (Part::averages_volume)
        return resistance(x, gather<T, n>(q[0], corners), estimated.volume.template mean<T, n>(corners));
      else
        return resistance(x, gather<T, n>(q[0], corners));
    }();
    const Nodal<T, motions<E>> f = all.unaryExpr([&](const T& f_i) -> T { return select(is_chosen, f_i, T(0.0)); });
    scatter_subtract<T, n>(f, product[0], corners, part.count(b));
    if constexpr (turns_nodes<E>()) scatter_subtract<T, n>(f, product[1], corners, part.count(b), n);
  });
}

/// The resistance A(dt) = K dt^2/4 + C dt/2 of those elements of a run that are chosen for an estimate, and their own
/// masses, so that the others are safe with theirs.
template <class Nodes, class Items>
class MeshResistance {
  using Vector = typename std::decay_t<decltype(std::declval<Nodes&>().motion().position)>::value_type;
  using Real = RealOf<Vector>;

 public:
  static constexpr std::size_t kinds = Nodes::nodes_turn ? 2 : 1;
  using Iteration = Lanczos<Vector, kinds>;
  using Fields = typename Iteration::Fields;
  using Masses = typename Iteration::Masses;

  const Masses& masses() const { return masses_; }
  /// The largest critical rate of the other elements.
  double rate_of_others() const { return rate_of_others_; }
  /// Number of components of the motion of the chosen elements.
  std::size_t size() const {
    std::size_t size = 0;
    for (const auto& masses : masses_)
      size += 3 * static_cast<std::size_t>(std::count_if(masses.begin(), masses.end(), [](Real m) { return m > 0; }));
    return size;
  }

  /// Chooses the elements whose own step is below `target`, and their neighbours, and takes their resistance in a step
  /// dt. Returns their share of all.
  double choose(double target, double dt, Nodes& nodes, Items& items, EstimatedParts<Items>& parts) {
    std::vector<char> near(nodes.size());
    const auto place = [&](Index i) { return nodes.place(nodes.number(i)); };
    parts.each_part(items, [&](const auto& part, const auto&) {
      for (std::size_t b = part.blocks().first(); b < part.blocks().last(); ++b) {
        const auto& corners = part.blocks()[b].nodes;
        const auto& state = part.blocks()[b].state;
        for (std::size_t l = 0; l < part.count(b); ++l)
          if (static_cast<double>(lane(state.followed.now, l)) * target > 1)
            for (const auto& corner : corners) near[place(corner[l])] = true;
      }
    });

    mark_for_all_ranks(nodes.ranks(), near);

    for (auto& masses : masses_) masses.assign(nodes.places(), 0);
    rate_of_others_ = 0;
    std::size_t chosen = 0, all = 0;
    parts.each_part(items, [&](auto& part, auto& estimated) {
      const auto& patches = part.patches();
      const Deal& deal = part.deal();
      std::vector<std::size_t> chosen_in(patches.size());
      estimated.resistance.resize(part.blocks().size());
      for (std::size_t p = deal.first(); p < deal.last(); ++p)
        for (std::size_t b = patches[p].first_block; b < patches[p].last_block; ++b)
          chosen_in[p] += choose_in_block(part, estimated, b, dt, nodes, near, masses_, rate_of_others_);
      deal.exchange_patches(nodes.ranks(), chosen_in);
      estimated.patches.clear(), estimated.own_patches.clear();
      for (std::size_t p = 0; p < patches.size(); ++p) {
        chosen += chosen_in[p];
        if (chosen_in[p] == 0) continue;
        estimated.patches.push_back(p);
        if (p >= deal.first() && p < deal.last()) estimated.own_patches.push_back(p);
      }
      for (std::size_t kind = 0; kind < kinds; ++kind) gather(part, estimated, nodes, masses_[kind]);
      all += part.size();
      if constexpr (std::decay_t<decltype(part)>::averages_volume)
        estimated.volume = std::decay_t<decltype(estimated.volume)>(nodes.places());
    });
    for (auto& masses : masses_) masses.resize(nodes.size());
    rate_of_others_ = largest_of_ranks(nodes.ranks(), rate_of_others_);
    return static_cast<double>(chosen) / static_cast<double>(all);
  }

  /// product -= A q, with the ghosts of both.
  template <class Execution>
  void subtract_product(Fields& q, Fields& product, Nodes& nodes, Items& items, EstimatedParts<Items>& parts,
                        const Execution& execution) const {
    parts.each_part(items, [&](const auto& part, auto& estimated) {
      const auto for_each_patch = [&](const auto& f) {
        execution.for_each(estimated.own_patches.size(),
                           [&](std::size_t k) { f(part.patches()[estimated.own_patches[k]]); });
      };
      for_each_patch([&](const Patch& patch) {
        for (std::size_t kind = 0; kind < kinds; ++kind) part.patches().refresh(patch, q[kind], product[kind]);
      });
      if constexpr (std::decay_t<decltype(part)>::averages_volume) {
        estimated.volume.clear();
        for_each_patch([&](const Patch& patch) { add_chosen_volumes(part, estimated, patch, nodes, q[0]); });
        estimated.volume.exchange(part.deal(), nodes.ranks());
        estimated.volume.update(part.patches());
      }
      for_each_patch([&](const Patch& patch) { subtract_chosen(part, estimated, patch, nodes, q, product); });
      for (std::size_t kind = 0; kind < kinds; ++kind) gather(part, estimated, nodes, product[kind]);
    });
  }

 private:
  /// Adds up what the patches with chosen elements have of a field at each node, patch after patch, for all processes.
  template <class Part, class Estimated, class Field>
  static void gather(const Part& part, const Estimated& estimated, const Nodes& nodes, Field& field) {
    part.deal().exchange_nodes(nodes.ranks(), field), part.deal().exchange_ghosts(nodes.ranks(), field);
    for (const std::size_t p : estimated.patches) part.patches().gather(part.patches()[p], field);
  }

  Masses masses_;
  double rate_of_others_ = 0;
};

}  // namespace strike::detail
