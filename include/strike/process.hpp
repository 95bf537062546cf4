#pragma once
#include <string>

#include <strike/error.hpp>

namespace strike::detail {

/// This process among those that MPI has started together, if it has: the first one writes files and messages.
struct Process {
  bool is_first = true;
  /// The text of the first process, for all that ask together; null: there are no others.
  std::string (*text_of_first)(std::string) = nullptr;
};
inline constinit Process this_process{};

/// f() by the first process. Error, in all: that with which f ends.
template <class F>
void by_first(const F& f) {
  if (!this_process.text_of_first) return f();
  std::string error;
  if (this_process.is_first) {
    try {
      f();
    } catch (const Error& of_first) {
      error = of_first.what();
    }
  }
  error = this_process.text_of_first(error);
  if (!error.empty()) throw Error(error);
}
/// The answer f() of the first process.
template <class F>
bool first_says(const F& f) {
  if (!this_process.text_of_first) return f();
  return !this_process.text_of_first(this_process.is_first && f() ? "yes" : "").empty();
}

}  // namespace strike::detail
