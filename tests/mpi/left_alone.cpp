// An error of one process alone: the others, which wait for it in a step, end with it.
#include <strike/mpi.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main(int count, char** arguments) try {
  const MpiSession session(count, arguments);
  const Mesh block = box({.size = {1, 1, 1}, .cells = {8, 8, 8}});
  Explicit run{Scene{block.nodes, Part{Hex8{}, Elastic{1000, 1e6, .3}, block.hexahedra}, InitialVelocity{{1, 0, 0}}},
               Mpi{}};
  for (int n = 0; n < 1000000; ++n) {
    if (n == 20 && session.rank() == 1) throw Error("strike: the second process has no memory left.");
    run.step();
  }
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
