#pragma once
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/text.hpp>

#if __has_include(<mpi.h>)
#include <mpi.h>
#endif

namespace strike {

#if __has_include(<mpi.h>)

namespace detail {

/// The processes of a communicator; see strike/motion/ranks.hpp.
class MpiRanks {
 public:
  MpiRanks() = default;
  explicit MpiRanks(MPI_Comm communicator) : communicator_(communicator) {
    int is_running = 0;
    MPI_Initialized(&is_running);
    if (is_running == 0)
      throw Error("strike: Mpi{} needs MPI at work: make a strike::MpiSession first in main, or call MPI_Init.");
    int rank = 0, size = 1;
    MPI_Comm_rank(communicator, &rank), MPI_Comm_size(communicator, &size);
    rank_ = static_cast<std::size_t>(rank), size_ = static_cast<std::size_t>(size);
  }

  std::size_t rank() const { return rank_; }
  std::size_t size() const { return size_; }
  /// Error: a list of 2^31 numbers or more, which MPI cannot count.
  template <class T>
  void exchange(std::span<T> list, std::span<const std::size_t> ends) const {
    if (size_ == 1) return;
    if (list.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw Error(joined({"strike: a part has ", std::to_string(list.size()),
                          " numbers to exchange, which MPI cannot count; make two parts of it."}));
    std::vector<int> counts(size_), begins(size_);
    for (std::size_t r = 0, begin = 0; r < size_; begin = ends[r++])
      begins[r] = static_cast<int>(begin), counts[r] = static_cast<int>(ends[r] - begin);
    MPI_Datatype type;
    MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(MPI_IN_PLACE, 0, type, list.data(), counts.data(), begins.data(), type, communicator_);
    MPI_Type_free(&type);
  }
  /// Of pairs of lists and fields.
  template <class... ListsAndFields>
  void trade(ListsAndFields&&... all) const {
    if (size_ == 1) return;
    std::vector<std::string> sent(size_), got(size_);
    std::vector<MPI_Request> requests;
    const auto expect = [&]<class T>(const PlaceLists& lists, const std::vector<T>& field) {
      for (std::size_t r = 0; r < size_; ++r) {
        got[r].resize(got[r].size() + lists.from[r].size() * sizeof(T));
        for (const Index place : lists.to[r]) sent[r].append(reinterpret_cast<const char*>(&field[place]), sizeof(T));
      }
    };
    each_pair(expect, all...);
    const auto begin = [&](auto start, std::string& bytes, std::size_t r) {
      if (bytes.empty()) return;
      start(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, static_cast<int>(r), 0, communicator_,
            &requests.emplace_back());
    };
    for (std::size_t r = 0; r < size_; ++r) begin(&MPI_Irecv, got[r], r);
    for (std::size_t r = 0; r < size_; ++r) begin(&MPI_Isend, sent[r], r);
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    std::vector<std::size_t> taken(size_);
    const auto take = [&]<class T>(const PlaceLists& lists, std::vector<T>& field) {
      for (std::size_t r = 0; r < size_; ++r)
        for (const Index place : lists.from[r]) {
          std::memcpy(static_cast<void*>(&field[place]), &got[r][taken[r]], sizeof(T));
          taken[r] += sizeof(T);
        }
    };
    each_pair(take, all...);
  }

 private:
  template <class F, class Lists, class Field, class... More>
  static void each_pair(const F& f, const Lists& lists, Field& field, More&... more) {
    f(lists, field);
    if constexpr (sizeof...(more) > 0) each_pair(f, more...);
  }

  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::size_t rank_ = 0, size_ = 1;
};

}  // namespace detail

/// The processes of an MPI communicator, each of which works on a share of the elements, with threads of its own:
///   Explicit run{scene, {}, Mpi{}};   Explicit run{scene, {}, Mpi{MPI_COMM_WORLD, OpenMP{16}}};
/// All make the same run with the same results, bit for bit, for any number of processes and threads. What a run tells
/// of its elements (field, cells, alive, warnings, checkpoints) all processes ask for together, or none.
/// Programs make an MpiSession first and link the target strike::mpi.
template <Execution Threads = Serial>
struct Mpi {
  MPI_Comm communicator = MPI_COMM_WORLD;
  Threads threads{};

  static constexpr bool is_available = [] {
    if constexpr (requires { Threads::is_available; })
      return Threads::is_available;
    else
      return true;
  }();

  void ranges(const auto& number) const { number(threads); }

  template <class F>
  void for_each(std::size_t n, const F& f) const {
    threads.for_each(n, f);
  }
  template <class F>
  void for_each_unlike(std::size_t n, const F& f) const {
    detail::for_each_unlike(threads, n, f);
  }
  auto ranks() const { return detail::MpiRanks(communicator); }
};
Mpi() -> Mpi<>;
Mpi(MPI_Comm) -> Mpi<>;
template <class Threads>
Mpi(MPI_Comm, Threads) -> Mpi<Threads>;

#else

/// Fallback without MPI: a run with it says what is missing.
template <class...>
struct Mpi {
  static constexpr bool is_available = false;

  explicit Mpi(const auto&...) {}
  template <class F>
  void for_each(std::size_t, const F&) const {}
};
Mpi() -> Mpi<>;

#endif

}  // namespace strike
