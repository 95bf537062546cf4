#pragma once
#include <stdexcept>

#include <strike/cxx20.hpp>

namespace strike {

/// What a user did wrong or what went wrong in a run, as one sentence: what, which thing (its number and place), what
/// to do.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace strike
