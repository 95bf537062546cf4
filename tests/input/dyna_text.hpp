#pragma once
#include <string>

#include <strike/input/dyna.hpp>

#include "support/catch.hpp"

// LS-DYNA decks as texts of tests.
namespace decks {

inline strike::DynaDeck read(const std::string& text) { return strike::read_dyna(text, "a.k"); }
inline void expect_refused(const std::string& text, const std::string& sentence) {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
}

}  // namespace decks
