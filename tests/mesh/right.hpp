#pragma once
#include <strike/error.hpp>
#include <strike/mesh/check.hpp>

namespace strike::testing {

/// check(mesh) finds nothing wrong.
inline bool is_right(const Mesh& mesh) {
  try {
    check(mesh);
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace strike::testing
