#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include <strike/dynamics/execution.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/nodes.hpp>

namespace strike::detail {

/// A range of blocks that one thread takes at a time, and the places of its ghosts.
struct Patch {
  std::size_t first_block, last_block;
  Index first_ghost, last_ghost;
};

/// The patches of a part. A node belongs to the first patch that has it; the others have ghosts of it, so that all may
/// be at work at once. The patches, and with them the order in which forces are summed, follow from the mesh alone.
class Patches {
 public:
  Patches() = default;
  /// Cuts the blocks of `lanes` elements into patches and makes them name their ghosts.
  template <class Block, class Real>
  Patches(std::vector<Block>& blocks, std::size_t lanes, Nodes<Real>& nodes) : first_ghost_(nodes.places()) {
    constexpr std::size_t smallest = 128, largest = 2048;  // elements: enough for a cache, or for some threads
    constexpr Index none = std::numeric_limits<Index>::max();
    const std::size_t size = std::clamp(blocks.size() * lanes / 16, smallest, largest) / lanes;
    std::vector<Index> owner(nodes.size(), none), user(nodes.size(), none), ghost(nodes.size());
    for (std::size_t first = 0; first < blocks.size(); first += size) {
      const Index patch = static_cast<Index>(patches_.size());
      const std::size_t last = std::min(first + size, blocks.size());
      const Index first_ghost = nodes.places();
      for (std::size_t b = first; b < last; ++b)
        for (auto& corner : blocks[b].nodes)
          for (Index& place : corner) {
            if (owner[place] == none) owner[place] = patch;
            if (owner[place] == patch) continue;
            if (user[place] != patch) {
              user[place] = patch;
              ghost[place] = nodes.add_ghost(place);
              sources_.push_back(place);
            }
            place = ghost[place];
          }
      patches_.push_back({first, last, first_ghost, nodes.places()});
    }
    by_source_.resize(sources_.size());
    std::iota(by_source_.begin(), by_source_.end(), Index{0});
    std::stable_sort(by_source_.begin(), by_source_.end(), [&](Index a, Index b) { return sources_[a] < sources_[b]; });
    for (std::size_t k = 0; k < by_source_.size(); ++k)
      if (k == 0 || sources_[by_source_[k]] != sources_[by_source_[k - 1]]) groups_.push_back(static_cast<Index>(k));
    groups_.push_back(static_cast<Index>(by_source_.size()));
  }

  std::size_t size() const { return patches_.size(); }
  const Patch& operator[](std::size_t p) const { return patches_[p]; }

  /// Brings the ghosts of a patch to where their nodes are, and clears their forces.
  template <class Real>
  void refresh(const Patch& patch, Nodes<Real>& nodes) const {
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) {
      const Index source = sources_[g - first_ghost_];
      nodes.position()[g] = nodes.position()[source];
      nodes.velocity()[g] = nodes.velocity()[source];
      nodes.force()[g] = {};
    }
  }

  /// Adds the forces on the ghosts to those on their nodes, patch after patch.
  template <class Real, class Execution>
  void gather_forces(Nodes<Real>& nodes, const Execution& execution) const {
    for_each_chunk(execution, groups_.size() - 1, [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        Padded<Real>& sum = nodes.force()[sources_[by_source_[groups_[k]]]];
        for (Index i = groups_[k]; i < groups_[k + 1]; ++i) {
          const Padded<Real>& f = nodes.force()[first_ghost_ + by_source_[i]];
          for (int c = 0; c < 4; ++c) sum.x[c] += f.x[c];
        }
      }
    });
  }

  /// The same for a field of vectors that is multiplied by a matrix into another: brings the ghosts of a patch to what
  /// their nodes have and clears the product, ...
  template <class Field>
  void refresh(const Patch& patch, Field& field, Field& product) const {
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) {
      field[g] = field[sources_[g - first_ghost_]];
      product[g] = {};
    }
  }
  /// ... and adds the product at them to that at their nodes, if patch after patch then as the forces.
  template <class Field>
  void gather(const Patch& patch, Field& product) const {
    for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) {
      auto& sum = product[sources_[g - first_ghost_]];
      for (int c = 0; c < 4; ++c) sum.x[c] += product[g].x[c];
    }
  }

 private:
  Index first_ghost_ = 0;
  std::vector<Patch> patches_;
  std::vector<Index> sources_;    // of each ghost, the place of its node
  std::vector<Index> by_source_;  // the ghosts, those of a node together and in the order of their patches
  std::vector<Index> groups_;     // where those of a node begin
};

}  // namespace strike::detail
