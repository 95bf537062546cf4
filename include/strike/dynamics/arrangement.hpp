#pragma once
#include <string>
#include <type_traits>
#include <vector>

#include <strike/dynamics/scene.hpp>
#include <strike/each_of.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/order.hpp>
#include <strike/range.hpp>

namespace strike::detail {

/// How the elements and nodes of a scene lie in memory: neighbours together, whatever their numbers are.
struct Arrangement {
  std::vector<std::vector<Index>> cells;  ///< of each part, the numbers of its elements in order
  std::vector<Index> nodes;               ///< the numbers of the nodes in the order in which the elements name them
};

/// Errors: a node whose position is not finite; a number of an item out of its range; a part without elements; an
/// element that names a node that is not there.
template <class... Items>
Arrangement arrange(const Scene<Items...>& scene) {
  Arrangement arrangement;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (!scene.nodes[i].allFinite())
      throw Error(joined({"strike: node ", std::to_string(i), " is at ", text(scene.nodes[i]),
                          "; give it coordinates that are finite."}));
  std::vector<bool> named(scene.nodes.size(), false);
  const auto name = [&](Index node) {
    if (!named[node]) named[node] = true, arrangement.nodes.push_back(node);
  };
  const auto place = [&](const auto& item) {
    if constexpr (!is_part<std::decay_t<decltype(item)>>) {
      check_ranges(item);
    } else {
      const std::string part = std::to_string(arrangement.cells.size());
      check_ranges(item, joined({", in part ", part, ","}));
      if (item.cells.empty()) throw Error(joined({"strike: part ", part, " has no elements; give it cells."}));
      for (std::size_t e = 0; e < item.cells.size(); ++e)
        for (const Index node : item.cells[e])
          if (node >= scene.nodes.size())
            throw Error(
                joined({"strike: element ", std::to_string(e), " of part ", part, " names node ", std::to_string(node),
                        ", but there are ", std::to_string(scene.nodes.size()), " nodes; correct its connectivity."}));
      arrangement.cells.push_back(locality_order(scene.nodes, item.cells));
      for (const Index e : arrangement.cells.back())
        for (const Index node : item.cells[e]) name(node);
    }
  };
  each_of(scene.items, place);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) name(static_cast<Index>(i));
  return arrangement;
}

}  // namespace strike::detail
