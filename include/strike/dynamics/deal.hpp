#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <strike/dynamics/patches.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// The place of a part among all elements of a scene, by the bytes of their blocks: the time of a step goes with them,
/// within a quarter for most elements and laws (docs/prices.md).
struct PlaceInScene {
  std::size_t before, of_block, all;  ///< bytes of parts before it, of a block of its own, and of all parts
};

/// The patches of a part as they are dealt to the processes of a run, so that each has as many bytes of the scene as
/// the others. A process works on patches that follow each other, whose nodes and ghosts do too.
class Deal {
 public:
  Deal() = default;
  /// All patches for every process.
  explicit Deal(const Patches& patches) : last_(patches.size()) {}
  /// Of a part of `size` elements in blocks of `lanes`. A patch goes to the process whose share has its middle.
  template <class Ranks>
  Deal(const Patches& patches, std::size_t size, std::size_t lanes, const PlaceInScene& place, const Ranks& ranks)
      : last_(patches.size()) {
    if (ranks.size() == 1) return;
    std::size_t p = 0;
    for (std::size_t r = 0; r < ranks.size(); ++r) {
      const auto middle = [&] {
        return place.before + (patches[p].first_block + patches[p].last_block) * place.of_block / 2;
      };
      if (r == ranks.rank()) first_ = p;
      while (p < patches.size() && (r + 1 == ranks.size() || middle() * ranks.size() < (r + 1) * place.all)) ++p;
      if (r == ranks.rank()) last_ = p;
      const Patch& end = patches[p > 0 ? p - 1 : 0];
      patches_.push_back(p);
      nodes_.push_back(p > 0 ? end.last_node : end.first_node);
      ghosts_.push_back(p > 0 ? end.last_ghost : end.first_ghost);
      elements_.push_back(p > 0 ? std::min(end.last_block * lanes, size) : 0);
    }
    first_node_ = patches[0].first_node, first_ghost_ = patches[0].first_ghost;
    for (std::size_t& end : nodes_) end -= first_node_;
    for (std::size_t& end : ghosts_) end -= first_ghost_;
  }

  /// Processes have different patches.
  bool is_dealt() const { return !patches_.empty(); }
  /// The patches of this process.
  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }
  std::size_t size() const { return last_ - first_; }
  /// Those of a process.
  std::size_t first_of(std::size_t rank) const { return rank > 0 ? patches_[rank - 1] : 0; }
  std::size_t last_of(std::size_t rank) const { return patches_[rank]; }
  /// Number of nodes that patches of ranks up to one are the first to name.
  std::size_t nodes_up_to(std::size_t rank) const { return nodes_[rank]; }

  /// Number of places of the nodes and ghosts of the parts up to this one.
  std::size_t places() const { return first_ghost_ + ghosts_.back(); }

  /// Gives all processes a list patch by patch, ...
  template <class Ranks, class T>
  void exchange_patches(const Ranks& ranks, std::vector<T>& list) const {
    if (is_dealt()) ranks.exchange(std::span(list), ends(patches_));
  }
  /// ... one of the elements, place by place, ...
  template <class Ranks, class T>
  void exchange_elements(const Ranks& ranks, std::vector<T>& list) const {
    if (is_dealt()) ranks.exchange(std::span(list), ends(elements_));
  }
  /// ... and a field at the nodes that patches of the part are the first to name, and at its ghosts.
  template <class Ranks, class T>
  void exchange_nodes(const Ranks& ranks, std::vector<T>& field) const {
    if (is_dealt()) ranks.exchange(std::span(field).subspan(first_node_, nodes_.back()), ends(nodes_));
  }
  template <class Ranks, class T>
  void exchange_ghosts(const Ranks& ranks, std::vector<T>& field) const {
    if (is_dealt()) ranks.exchange(std::span(field).subspan(first_ghost_, ghosts_.back()), ends(ghosts_));
  }

 private:
  static std::span<const std::size_t> ends(const std::vector<std::size_t>& of) { return of; }

  std::size_t first_ = 0, last_ = 0;
  std::size_t first_node_ = 0, first_ghost_ = 0;                  // of the part
  std::vector<std::size_t> patches_, nodes_, ghosts_, elements_;  // where those of each process end
};

}  // namespace strike::detail
