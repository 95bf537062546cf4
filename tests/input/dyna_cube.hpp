#pragma once
#include <string>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

// A deck of LS-DYNA with one element, to which tests add the cards of its material.

/// A cube of part 1, of material 1 and the equation of state 1.
inline const std::string dyna_cube = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
*PART
cube
1,1,1,1
)";
inline strike::DynaDeck read_cube(const std::string& text) { return decks::read(dyna_cube + text); }
/// Its sentence, after the name of the file and the line.
inline void refuses_cube(const std::string& text, const std::string& sentence) {
  INFO(text);
  decks::expect_refused(dyna_cube + text, sentence);
}
