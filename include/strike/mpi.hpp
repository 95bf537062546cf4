#pragma once
// Runs on several machines, or several processes of one. Programs that include it link the target strike::mpi.
#include <strike/mpi/mpi.hpp>
#include <strike/mpi/session.hpp>
