// expect: a misuse is refused in one sentence
static_assert(sizeof(char) == 2, "a misuse is refused in another sentence");
