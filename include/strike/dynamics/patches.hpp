#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/node_share.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// A thread's unit of work: a range of blocks, the places of the nodes that it owns, which no patch before it has, and
/// those of its ghosts, copies of nodes that it shares with patches before.
struct Patch {
  std::size_t first_block, last_block;
  Index first_node, last_node;
  Index first_ghost, last_ghost;
};

/// The patches of a part. None writes where another reads or writes, so that all can work at once. They follow from the
/// mesh alone, and with them the order in which forces are summed.
class Patches {
 public:
  Patches() = default;
  /// Cuts blocks of `lanes` elements into patches. `corners` are the places that they name, block after block, and
  /// become those of ghosts where they must, which begin at `first_ghost`. Nodes lie in the order in which elements
  /// name them; those before `first_node` other parts have named.
  Patches(std::vector<Index>& corners, std::size_t blocks, std::size_t lanes, Index first_node, Index first_ghost)
      : first_ghost_(first_ghost) {
    constexpr std::size_t smallest = 128, largest = 2048;  // elements: some for each thread, or enough for its cache
    const std::size_t size = std::clamp(blocks * lanes / 16, smallest, largest) / lanes;
    std::vector<Index> ghost(first_ghost), user(first_ghost);  // user: the patch that has the ghost, from 1
    for (std::size_t first = 0; first < blocks; first += size) {
      const std::size_t last = std::min(first + size, blocks), block = corners.size() / blocks;
      Patch patch{first, last, first_node, first_node, next_ghost(), 0};
      const auto number = static_cast<Index>(patches_.size() + 1);
      for (std::size_t k = first * block; k < last * block; ++k) {
        Index& place = corners[k];
        patch.last_node = std::max(patch.last_node, place + 1);
        if (place >= first_node) continue;
        if (user[place] != number) {
          user[place] = number;
          ghost[place] = next_ghost();
          sources_.push_back(place);
        }
        place = ghost[place];
      }
      patch.last_ghost = next_ghost();
      first_node = patch.last_node;
      patches_.push_back(patch);
    }
    group({0, first_ghost});
  }
  /// Leaves to other processes all patches but [first, last), and all nodes but those that are kept, of which the own
  /// add up what their ghosts have. Of the ghosts these are kept, in ascending order, which begin at `first_ghost` now.
  void keep(std::size_t first, std::size_t last, const std::vector<Index>& ghosts, Index first_ghost,
            const NodeShare& share) {
    const auto at = [&](Index ghost) {
      return first_ghost + static_cast<Index>(std::lower_bound(ghosts.begin(), ghosts.end(), ghost) - ghosts.begin());
    };
    for (std::size_t p = first; p < last; ++p) {
      Patch& patch = patches_[p];
      const Index nodes = patch.last_node - patch.first_node;
      patch.first_node = nodes > 0 ? share.here(patch.first_node) : 0, patch.last_node = patch.first_node + nodes;
      patch.first_ghost = at(patch.first_ghost), patch.last_ghost = at(patch.last_ghost);
    }
    std::vector<Index> sources;
    for (const Index ghost : ghosts) sources.push_back(share.here(source(ghost)));
    sources_ = std::move(sources), first_ghost_ = first_ghost;
    group(share.own());
  }

  /// Of each ghost, the place of its node; of all, in their order, or of one at its place.
  Index source(Index ghost) const { return sources_[ghost - first_ghost_]; }
  const std::vector<Index>& sources() const { return sources_; }
  std::size_t size() const { return patches_.size(); }
  const Patch& operator[](std::size_t p) const { return patches_[p]; }

  /// Copies to the ghosts of a patch the motion of their nodes, and clears the forces that its elements add to. A copy
  /// of lesser precision is relative to a node of the patch, so that it is as good far from the origin.
  template <class N>
  void load(const Patch& patch, N& nodes) const {
    auto& motion = nodes.motion();
    using Copy = std::decay_t<decltype(motion.position[0])>;
    const auto origin = this->origin(patch, nodes);
    const auto clear = [&](Index i) {
      motion.force[i] = 0;
      if constexpr (N::nodes_turn) motion.moment[i] = 0;
    };
    const auto copy = [&](Index from, Index to) {
      motion.position[to] = Copy(nodes.position()[from] - origin);
      motion.velocity[to] = Copy(nodes.velocity()[from]);
      if constexpr (N::nodes_turn) motion.angular_velocity[to] = Copy(nodes.angular_velocity()[from]);
      clear(to);
    };
    for (Index i = patch.first_node; i < patch.last_node; ++i) {
      if constexpr (N::elements_have_copy)
        copy(i, i);
      else
        clear(i);
    }
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) copy(sources_[g - first_ghost_], g);
  }
  /// Copies the forces on a copy of lesser precision to the nodes.
  template <class N>
  void store(const Patch& patch, N& nodes) const {
    using Sum = std::decay_t<decltype(nodes.force()[0])>;
    if constexpr (N::elements_have_copy)
      for (Index i = patch.first_node; i < patch.last_node; ++i) {
        nodes.force()[i] = Sum(nodes.motion().force[i]);
        if constexpr (N::nodes_turn) nodes.moment()[i] = Sum(nodes.motion().moment[i]);
      }
  }
  /// Adds the forces (and moments) on the ghosts to those on the nodes, patch after patch.
  template <class N, class Execution>
  void store_ghosts(N& nodes, const Execution& execution) const {
    using Sum = std::decay_t<decltype(nodes.force()[0])>;
    for_each_chunk(execution, groups_.size() - 1, [&](std::size_t, std::size_t first, std::size_t last) {
      each_ghost(first, last, [&](Index node, Index ghost) {
        nodes.force()[node] += Sum(nodes.motion().force[ghost]);
        if constexpr (N::nodes_turn) nodes.moment()[node] += Sum(nodes.motion().moment[ghost]);
      });
    });
  }
  /// The same of a field of numbers.
  template <class Field>
  void gather(Field& field) const {
    each_ghost(0, groups_.size() - 1, [&](Index node, Index ghost) { field[node] += field[ghost]; });
  }

  /// For the product of a matrix with a field of vectors: copies to the ghosts of a patch the vectors of their nodes
  /// and clears their product, ...
  template <class Field>
  void refresh(const Patch& patch, Field& field, Field& product) const {
    refresh(patch, field);
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) product[g] = 0;
  }
  template <class Field>
  void refresh(const Patch& patch, Field& field) const {
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) field[g] = field[sources_[g - first_ghost_]];
  }
  /// ... and adds the product at the ghosts to that at their nodes.
  template <class Field>
  void gather(const Patch& patch, Field& product) const {
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) product[sources_[g - first_ghost_]] += product[g];
  }

 private:
  /// Puts the ghosts of a node together, of the nodes in a range of places.
  void group(const Places& nodes) {
    by_source_.clear(), groups_.clear();
    for (Index g = 0; g < sources_.size(); ++g)
      if (sources_[g] >= nodes.first && sources_[g] < nodes.last) by_source_.push_back(g);
    std::stable_sort(by_source_.begin(), by_source_.end(), [&](Index a, Index b) { return sources_[a] < sources_[b]; });
    for (Index k = 0; k < by_source_.size(); ++k)
      if (k == 0 || sources_[by_source_[k]] != sources_[by_source_[k - 1]]) groups_.push_back(k);
    groups_.push_back(static_cast<Index>(by_source_.size()));
  }
  /// f(node, ghost) for the ghosts of the `first`th to the one before the `last`th node that has any.
  template <class F>
  void each_ghost(std::size_t first, std::size_t last, const F& f) const {
    for (Index i = groups_[first]; i < groups_[last]; ++i) f(sources_[by_source_[i]], first_ghost_ + by_source_[i]);
  }
  Index next_ghost() const { return first_ghost_ + static_cast<Index>(sources_.size()); }
  template <class N>
  auto origin(const Patch& patch, const N& nodes) const {
    if constexpr (!N::elements_have_copy)
      return std::decay_t<decltype(nodes.position()[0])>(0);
    else if (patch.first_node < patch.last_node)
      return nodes.position()[patch.first_node];
    else
      return nodes.position()[sources_[patch.first_ghost - first_ghost_]];
  }

  Index first_ghost_ = 0;
  std::vector<Patch> patches_;
  std::vector<Index> sources_;    // of each ghost, the place of its node
  std::vector<Index> by_source_;  // the ghosts, those of a node together and in the order of their patches
  std::vector<Index> groups_;     // where those of a node begin
};

}  // namespace strike::detail
