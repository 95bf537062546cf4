// expect: strike: the headers need C++20, compile with -std=c++20
// flags: -std=c++17
#include <strike/strike.hpp>

int main() {}
