// expect: a misuse is refused in one sentence
static_assert(sizeof(char) == 1, "a misuse is refused in one sentence");
