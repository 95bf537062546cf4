#pragma once
#include <stdexcept>

#include <strike/cxx20.hpp>

namespace strike {

/// A mistake of the user or a fault of a run, in one sentence: what is wrong, where (by number and place), what to do.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace strike
