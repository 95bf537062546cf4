// expect: a misuse is refused in one sentence
static_assert(sizeof(char) == 2, "a misuse is refused in one sentence");
#pragma message("one")
#pragma message("two")
#pragma message("three")
#pragma message("four")
#pragma message("five")
