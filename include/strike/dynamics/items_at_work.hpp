#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/ascending.hpp>
#include <strike/dynamics/item_at_work.hpp>
#include <strike/dynamics/not_finite.hpp>
#include <strike/dynamics/part_checks.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/node_share.hpp>
#include <strike/process.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Error: a node without mass.
template <class Nodes>
[[gnu::cold]] void check_masses(const Nodes& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!(nodes.mass(i) > 0))
      throw Error(joined({"strike: node ", std::to_string(i), " at ", text(nodes.x(i).template cast<double>()),
                          " has no mass, for it belongs to no element; remove it."}));
}

/// The nodes of a run in its numbers, and its items, of which it knows what they can do.
template <class Method, class NodesOfRun>
class ItemsAtWork {
 public:
  using Numbers = typename Method::Numbers;
  using Nodes = NodesOfRun;

  Eigen::Vector3d momentum() const { return detail::momentum(nodes()); }

  /// Of several processes all ask for them together, and anew after a step.
  const Nodes& nodes() const {
    know_all_nodes();
    return nodes_;
  }
  Nodes& nodes() {
    know_all_nodes();
    return nodes_;
  }
  /// By the numbers of the nodes as given.
  std::vector<Eigen::Vector3d> positions() const { return nodes_.positions(); }
  std::vector<Eigen::Vector3d> velocities() const { return nodes_.velocities(); }

  /// Sentences that the user should read before the results.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    std::size_t clouds = 0;
    for (const Item& one : listed_) {
      if (one.can->warning)
        if (std::string warning = one.can->warning(one.item); !warning.empty()) all.push_back(std::move(warning));
      clouds += one.can->sees_neighbours;
    }
    if (clouds > 1)
      all.push_back("Particles of different parts do not touch each other; those that shall meet belong in one part.");
    for (std::string& sentence : stretch_warnings()) all.push_back(std::move(sentence));
    return all;
  }

 protected:
  using Item = ItemAtWork<Method, Nodes>;

  ItemsAtWork(const std::vector<Eigen::Vector3d>& positions, std::vector<Index> order,
              const typename Nodes::Ranks& ranks)
      : nodes_(positions, std::move(order), ranks) {}

  /// The items, in the order of the scene. A copy lists its own anew.
  template <class Listed>
  void list(Listed& item, std::size_t place) {
    listed_.push_back({&item, place, &functions_of<Listed, Method, Nodes>});
  }
  void list_none() { listed_.clear(); }

  /// Errors: those of the items; a velocity that is not finite.
  void begin_items() {
    std::vector<PartFaces> parts;
    if (std::any_of(listed_.begin(), listed_.end(), [](const Item& one) { return one.can->takes_parts; }))
      parts = part_faces();
    for (const Item& one : listed_)
      if (one.can->add_faces) one.can->add_faces(one.item, parts);
    for (const Item& one : listed_)
      if (one.can->begin) one.can->begin(one.item, nodes_, parts);
    check_start(nodes_);
    for (const Item& one : listed_)
      if (one.can->start_body) one.can->start_body(one.item, nodes_);
  }
  std::vector<PartFaces> part_faces() const {
    std::vector<PartFaces> parts;
    for (const Item& one : listed_)
      if (one.can->is_part) parts.push_back(one.can->faces(one.item, nodes_));
    return parts;
  }
  /// Makes the rigid bodies, whose nodes get their masses.
  void add_bodies() {
    for (const Item& one : listed_)
      if (one.can->add_body) one.can->add_body(one.item, nodes_);
  }
  /// Tells the items which elements the last step has deleted.
  void remove_deleted() {
    for (const Item& part : listed_)
      if (part.can->is_part && part.can->newly_deleted(part.item) > 0) {
        const std::vector<bool> alive = part.can->alive(part.item);
        for (const Item& one : listed_)
          if (one.can->remove) one.can->remove(one.item, part.can->number(part.item), alive);
      }
  }
  /// The internal energy of its parts at rest.
  double stored_energy() const {
    double sum = 0;
    for (const Item& one : listed_)
      if (one.can->is_part) sum += one.can->stored_energy(one.item);
    return sum;
  }
  /// At most one sentence on numbers of different units, with the number of steps to the end of the run.
  [[gnu::cold]] void add_unit_slip(std::vector<std::string>& warnings, double steps) const {
    for (const Item& one : listed_)
      if (one.can->is_part)
        if (std::string slip = unit_slip(one.can->number(one.item), one.can->wave_speed(one.item), steps);
            !slip.empty()) {
          warnings.push_back(std::move(slip));
          return;
        }
  }
  [[gnu::cold]] void print(const std::vector<std::string>& warnings) {
    prints_warnings_ = true;
    if (!this_process.is_first) return;
    for (const std::string& warning : warnings) std::fprintf(stderr, "strike: warning: %s\n", warning.c_str());
  }
  /// Prints those on plates that have stretched in the run, once, if warnings are printed.
  void print_stretch() {
    if (!prints_warnings_ || has_told_stretch_) return;
    const std::vector<std::string> warnings = stretch_warnings();
    has_told_stretch_ = !warnings.empty();
    print(warnings);
  }
  /// An element of a part with its place, for a message.
  [[gnu::cold]] std::string describe(const StableStep& stable) const {
    for (const Item& one : listed_)
      if (one.can->is_part && one.can->number(one.item) == stable.part)
        return one.can->describe(one.item, nodes_, stable.element);
    return {};
  }
  auto culprit(const Step& step, double time) {
    know_all_nodes();
    return Culprit(nodes_, listed_, step, time);
  }

  static constexpr bool has_ranks = !std::is_same_v<typename Nodes::Ranks, Alone>;
  /// The processes share the nodes too, if every part can and every item that acts names its own.
  void share_nodes() {
    const auto& ranks = nodes_.ranks();
    if (ranks.size() == 1) return;
    std::vector<Index> named;
    std::vector<std::size_t> first_named(ranks.size());
    for (const Item& one : listed_) {
      if (one.can->is_part) {
        if (!one.can->can_share_nodes(one.item)) return;
        for (std::size_t r = 0; r < ranks.size(); ++r) first_named[r] += one.can->deal(one.item).nodes_up_to(r);
      } else if (one.can->acts_on_nodes()) {
        if (!one.can->nodes_named) return;
        for (const Index i : one.can->nodes_named(one.item)) named.push_back(nodes_.place(i));
      }
    }
    named = ascending(std::move(named));
    if (2 * named.size() > nodes_.size()) return;
    const auto share = std::make_shared<NodeShare>(nodes_.size(), first_named, std::move(named), ranks.rank());
    for (const Item& one : listed_)
      if (one.can->is_part) one.can->add_needs(one.item, *share);
    share->finish();
    std::vector<Index> ghosts;
    for (const Item& one : listed_)
      if (one.can->is_part) one.can->share_nodes(one.item, share, ghosts);
    nodes_.share(share, ghosts);
    for (const Item& one : listed_)
      if (one.can->find_places) one.can->find_places(one.item, nodes_);
  }
  /// Brings the nodes of other processes.
  void know_all_nodes() const {
    if constexpr (has_ranks) const_cast<Nodes&>(nodes_).bring_others();
  }

  Nodes nodes_;
  std::vector<Item> listed_;

 private:
  std::vector<std::string> stretch_warnings() const {
    std::vector<std::string> all;
    for (const Item& one : listed_)
      if (one.can->is_part)
        if (std::string sentence = one.can->stretch_warning(one.item, nodes_); !sentence.empty())
          all.push_back(std::move(sentence));
    return all;
  }

  bool prints_warnings_ = false, has_told_stretch_ = false;
};

}  // namespace strike::detail
