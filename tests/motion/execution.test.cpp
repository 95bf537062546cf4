#include <vector>

#include <strike/dynamics/method.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/openmp.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(Execution<Serial> && Execution<OpenMP> && !Execution<int>);

// Policies are found in any order, and what is not told is as usual.
static_assert(std::is_same_v<Method<>::Execution, Serial>);
static_assert(std::is_same_v<Method<In<double>, OpenMP>::Execution, OpenMP>);
static_assert(std::is_same_v<Method<>::Numbers, In<Pack<double>>>);
static_assert(std::is_same_v<Method<OpenMP, In<Pack<float>, double>>::Numbers, In<Pack<float>, double>>);

namespace {

template <class E>
void calls_each_once(const E& execution) {
  for (const std::size_t n : std::vector<std::size_t>{0, 1, 2, 7, 100}) {
    std::vector<int> calls(n);
    execution.for_each(n, [&](std::size_t k) { ++calls[k]; });
    CHECK(calls == std::vector<int>(n, 1));
  }
}

}  // namespace

TEST_CASE("an execution calls each once") {
  calls_each_once(Serial{});
  for (const int threads : {0, 1, 3}) calls_each_once(OpenMP{threads});
}

TEST_CASE("chunks cover a range without a gap") {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, detail::chunk, 3 * detail::chunk + 1}) {
    std::size_t end = 0, count = 0;
    detail::for_each_chunk(Serial{}, n, [&](std::size_t k, std::size_t first, std::size_t last) {
      CHECK(k == count++);
      CHECK(first == end);
      end = last;
    });
    CHECK(end == n);
    CHECK(count == detail::chunks(n));
  }
}
