// Processes beside threads: the step of hexahedra of copper with linear hardening as in step.bench, alone,
// with as many threads as there are processes, by Mpi on one process and on all, in turns.
//
//   mpirun --bind-to none -n 2 build/bench/bench/ranks
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/material/solid.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/mpi.hpp>

#include "support/clock.hpp"
#include "support/materials.hpp"
#include "support/squeezed_bar.hpp"
#include "support/table.hpp"
#include <unistd.h>

namespace {

using namespace strike;
using namespace bench;

const Solid copper{linear, hardening};

template <class... Policies>
auto squeezed(const Mesh& mesh, Policies... policies) {
  return Explicit{
      Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, copper, mesh.hexahedra}, Squeeze{1e3}}, {}, policies...};
}

/// All processes come here; those that wait leave their cores to others.
void meet() {
  MPI_Request barrier;
  MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
  for (int done = 0; done == 0; usleep(100)) MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
}

/// Of a step [s], by the clock on the wall.
template <class Run>
double of_step(Run& run, std::size_t steps) {
  return wall_seconds([&] {
           for (std::size_t i = 0; i < steps; ++i) run.step();
         }) /
         static_cast<double>(steps);
}

}  // namespace

int main(int count, char** arguments) {
  const MpiSession session(count, arguments);
  const int cores = static_cast<int>(session.size());
  std::fputs(head({"hexahedra", "alone [ms]", "threads", "Mpi on one", "Mpi on all"}).c_str(), stdout);
  for (const Index n : {24u, 48u}) {
    const Mesh mesh = bar({n, n, 3 * n});
    const std::size_t steps = std::max<std::size_t>(4, 2000000 / mesh.hexahedra.size());
    auto alone = squeezed(mesh);
    auto threads = squeezed(mesh, OpenMP{cores});
    auto on_one = squeezed(mesh, Mpi{MPI_COMM_SELF});
    auto on_all = squeezed(mesh, Mpi{});
    std::vector<double> times, of_threads, of_one, of_all;
    for (int repeat = 0; repeat < 7; ++repeat) {
      if (session.is_first()) {
        times.push_back(of_step(alone, steps));
        of_threads.push_back(times.back() / of_step(threads, steps));
        of_one.push_back(times.back() / of_step(on_one, steps));
      }
      meet();
      const double all = of_step(on_all, steps);
      if (session.is_first()) of_all.push_back(times.back() / all);
    }
    if (!session.is_first()) continue;
    std::fputs(row({std::to_string(mesh.hexahedra.size()), formatted("%.2f", 1e3 * median(times)),
                    formatted("%.2f x", median(of_threads)), formatted("%.2f x", median(of_one)),
                    formatted("%.2f x", median(of_all))})
                   .c_str(),
               stdout);
  }
}
