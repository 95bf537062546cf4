#include <strike/mpi.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main(int count, char** arguments) {
  const MpiSession session(count, arguments);  // first: starts MPI, and ends it
  const Mesh bar = box({.size = {1, 1, 6}, .cells = {10, 10, 60}});
  const Elastic steel{.density = 7.8e-6, .youngs_modulus = 210, .poissons_ratio = 0.3};  // mm, ms, kg
  Explicit run{Scene{bar.nodes, Part{Hex8{}, steel, bar.hexahedra}, InitialVelocity{{0, 0, -10}},
                     RigidWall{{0, 0, 0}, {0, 0, 1}}},
               {},
               Mpi{}};  // or Mpi{MPI_COMM_WORLD, OpenMP{16}}: threads in each process
  History history{"history.csv", {{"time", "ms"}, {"length", "mm"}}};
  run.until(1e-2, Every{1e-3, [&] { history.row(run.time(), run.positions().back().z()); }});
}
