#pragma once
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/deal.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/order.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// How the elements and nodes of a scene lie in memory: neighbours together, whatever their numbers are.
struct Arrangement {
  std::vector<std::vector<Index>> cells;  ///< of each part, the numbers of its elements in order
  std::vector<PlaceInScene> places{};     ///< of each part; none: each process works on all elements
  std::vector<Index> nodes;               ///< the numbers of the nodes in the order in which the elements name them

  /// Places a part of some blocks behind the others.
  void place(std::size_t blocks, std::size_t bytes_of_block) {
    const std::size_t before = places.empty() ? 0 : places.back().all;
    places.push_back({before, bytes_of_block, 0});
    for (PlaceInScene& each : places) each.all = before + blocks * bytes_of_block;
  }
};

/// Error: a node whose position is not finite.
[[gnu::cold]] inline void check_positions(const std::vector<Eigen::Vector3d>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].allFinite())
      throw Error(joined(
          {"strike: node ", std::to_string(i), " is at ", text(nodes[i]), "; give it coordinates that are finite."}));
}

/// Makes an arrangement part by part.
class Arranger {
 public:
  explicit Arranger(const std::vector<Eigen::Vector3d>& nodes) : nodes_(nodes), named_(nodes.size(), false) {}

  /// Errors: a part without elements; an element that names a node that is not there.
  template <class Cells>
  void add(const Cells& cells) {
    const std::string part = number_of_next_part();
    if (cells.empty()) throw Error(joined({"strike: part ", part, " has no elements; give it cells."}));
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const Index node : cells[e])
        if (node >= nodes_.size()) refuse(part, e, node);
    made_.cells.push_back(locality_order(nodes_, connectivity(cells)));
    for (const Index e : made_.cells.back())
      for (const Index node : cells[e]) name(node);
  }
  std::string number_of_next_part() const { return std::to_string(made_.cells.size()); }
  /// With the nodes behind that no element names.
  Arrangement finished() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) name(static_cast<Index>(i));
    return std::move(made_);
  }

 private:
  void name(Index node) {
    if (!named_[node]) named_[node] = true, made_.nodes.push_back(node);
  }
  [[noreturn, gnu::cold]] void refuse(const std::string& part, std::size_t element, Index node) const {
    throw Error(
        joined({"strike: element ", std::to_string(element), " of part ", part, " names node ", std::to_string(node),
                ", but there are ", std::to_string(nodes_.size()), " nodes; correct its connectivity."}));
  }

  const std::vector<Eigen::Vector3d>& nodes_;
  std::vector<bool> named_;
  Arrangement made_;
};

/// Errors: those of check_positions and Arranger; a number of an item out of its range.
template <class... Items>
Arrangement arrange(const Scene<Items...>& scene) {
  check_positions(scene.nodes);
  Arranger arranger(scene.nodes);
  each_item(scene.items, [&](const auto& item) {
    if constexpr (is_part<std::decay_t<decltype(item)>>) {
      check_ranges(item, joined({", in part ", arranger.number_of_next_part(), ","}));
      arranger.add(item.cells);
    } else {
      check_ranges(item);
    }
  });
  return arranger.finished();
}

}  // namespace strike::detail
