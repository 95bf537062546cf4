#pragma once
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>

#include <strike/mpi/mpi.hpp>
#include <strike/output/wall_clock.hpp>
#include <strike/process.hpp>

namespace strike {

#if __has_include(<mpi.h>)

/// MPI from its start to its end, first in `main`:
///   const MpiSession session(count, arguments);
/// Of all processes the first one alone writes files, and its messages are the ones that are seen. An error that leaves
/// the session in all processes ends them as without MPI; one that leaves it in some ends the others at once.
class MpiSession {
 public:
  MpiSession(int& count, char**& arguments) : MpiSession(&count, &arguments) {}
  MpiSession() : MpiSession(nullptr, nullptr) {}
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  ~MpiSession() {
    detail::this_process = {is_first(), nullptr};
    if (std::uncaught_exceptions() > uncaught_ && size_ > 1 && !all_arrive()) {
      std::fprintf(stderr, "strike: an error has left process %zu alone; the others are ended with it.\n", rank_);
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
    if (begins_) MPI_Finalize();
  }

  std::size_t rank() const { return rank_; }
  std::size_t size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

 private:
  MpiSession(int* count, char*** arguments) {
    int is_running = 0;
    MPI_Initialized(&is_running);
    begins_ = is_running == 0;
    int level = 0;
    if (begins_) MPI_Init_thread(count, arguments, MPI_THREAD_FUNNELED, &level);
    const detail::MpiRanks all(MPI_COMM_WORLD);
    rank_ = all.rank(), size_ = all.size();
    if (size_ == 1) return;
    detail::this_process = {is_first(), [](std::string text) {
                              return detail::of_rank(detail::MpiRanks(MPI_COMM_WORLD), 0, std::move(text));
                            }};
    if (!is_first() && !std::freopen("/dev/null", "w", stdout)) MPI_Abort(MPI_COMM_WORLD, 1);
  }
  /// All processes are here, or come within some seconds.
  static bool all_arrive() {
    MPI_Request barrier;
    MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
    int done = 0;
    for (const double start = detail::wall_clock(); done == 0 && detail::wall_clock() < start + 2;)
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
    return done != 0;
  }

  std::size_t rank_ = 0, size_ = 1;
  bool begins_ = true;
  int uncaught_ = std::uncaught_exceptions();
};

#endif

}  // namespace strike
