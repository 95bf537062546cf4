#pragma once
#include <stdexcept>
#include <string>
#include <type_traits>

namespace strike {

/// What a user did wrong or what went wrong in a run, as one sentence: what, which thing (its number and place), what
/// to do.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

/// Words and whole numbers, one after the other.
template <class... Parts>
std::string say(const Parts&... parts) {
  std::string text;
  const auto add = [&](const auto& part) {
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(part)>>)
      text.append(std::to_string(part));
    else
      text.append(part);
  };
  (add(parts), ...);
  return text;
}

}  // namespace detail

}  // namespace strike
