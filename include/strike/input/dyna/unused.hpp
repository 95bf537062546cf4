#pragma once
#include <array>
#include <cstddef>

#include <strike/input/dyna/file.hpp>

// Fields of cards that have no counterpart.
namespace strike::detail::dyna {

/// A field that has no counterpart here; its default says nothing. Without a name it is passed.
struct UnusedField {
  const char* name = nullptr;
  double standard = 0;
};
/// Tells fields that are neither 0 nor their default.
template <std::size_t N>
void tell_fields(Card& card, const std::array<UnusedField, N>& fields, File& file) {
  for (const auto& [name, standard] : fields) {
    if (!name) {
      card.pass(1);
      continue;
    }
    const double value = card.number(name);
    file.ignore(value == standard ? 0 : value, name);
  }
}
template <std::size_t N>
void tell_card(const std::array<UnusedField, N>& fields, File& file) {
  Card card = file.card();
  tell_fields(card, fields, file);
}

}  // namespace strike::detail::dyna
