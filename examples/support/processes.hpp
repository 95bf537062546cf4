#pragma once
#include <cstdio>

#include <strike/motion/execution.hpp>
#include <strike/mpi.hpp>

// The processes of an example, if it is built with MPI: bash examples/run NAME ranks=2
namespace examples {

#if __has_include(<mpi.h>)
using Session = strike::MpiSession;
using Processes = strike::Mpi<>;
#else
struct Session {
  Session(int&, char**&) {}
};
using Processes = strike::Serial;
#endif

/// Tells how evenly the processes have shared the elements of a run, if they are several. All of them ask together.
template <class Run>
void print_imbalance(const Run& run) {
  const double imbalance = run.imbalance();
  if (run.nodes().ranks().size() > 1)
    std::printf("The busiest of %zu processes took %.2f of their mean time for the elements.\n",
                run.nodes().ranks().size(), imbalance);
}

}  // namespace examples
