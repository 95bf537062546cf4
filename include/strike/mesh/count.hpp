#pragma once
#include <limits>
#include <string_view>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Error: the cells of a mesh have more nodes than an Index can number.
inline void check_count(std::string_view cells, double nodes) {
  if (nodes > std::numeric_limits<Index>::max())
    throw Error(joined(
        {"strike: the ", cells, " have ", text(nodes), " nodes; a mesh holds fewer than 2^32, so give fewer cells."}));
}

}  // namespace strike::detail
