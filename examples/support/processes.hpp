#pragma once
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

}  // namespace examples
