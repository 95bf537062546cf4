// Memory that the runtime of clang's OpenMP keeps when its teams change their size, which is not ours to give back.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libomp"; }
