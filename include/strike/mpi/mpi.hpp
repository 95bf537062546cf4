#pragma once
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <tuple>
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

/// Numbers at places of fields on their way between processes: those to others have been read, those of others come at
/// the end. `ListsAndFields` are a PlaceLists and the field at whose places it looks, and so on.
template <class... ListsAndFields>
class MpiTrade {
 public:
  MpiTrade(MPI_Comm communicator, std::size_t ranks, ListsAndFields&... all)
      : messages_(std::make_unique<Messages>(ranks)), all_(all...) {
    Messages& m = *messages_;
    each_field([&]<class T>(const PlaceLists& lists, const std::vector<T>& field) {
      for (std::size_t r = 0; r < lists.to.size(); ++r) {
        m.got[r].resize(m.got[r].size() + lists.from[r].size() * sizeof(T));
        for (const Index place : lists.to[r]) m.sent[r].append(reinterpret_cast<const char*>(&field[place]), sizeof(T));
      }
    });
    const auto begin = [&](auto start, std::string& bytes, std::size_t r) {
      if (bytes.empty()) return;
      start(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, static_cast<int>(r), 0, communicator,
            &m.requests.emplace_back());
    };
    for (std::size_t r = 0; r < ranks; ++r) begin(&MPI_Irecv, m.got[r], r);
    for (std::size_t r = 0; r < ranks; ++r) begin(&MPI_Isend, m.sent[r], r);
  }
  MpiTrade(MpiTrade&&) = default;
  /// One that an error leaves unfinished keeps its messages, for MPI works on them until the process ends.
  ~MpiTrade() { (void)messages_.release(); }

  void finish() {
    Messages& m = *messages_;
    MPI_Waitall(static_cast<int>(m.requests.size()), m.requests.data(), MPI_STATUSES_IGNORE);
    std::vector<std::size_t> taken(m.got.size());
    each_field([&]<class T>(const PlaceLists& lists, std::vector<T>& field) {
      for (std::size_t r = 0; r < lists.from.size(); ++r)
        for (const Index place : lists.from[r]) {
          std::memcpy(static_cast<void*>(&field[place]), &m.got[r][taken[r]], sizeof(T));
          taken[r] += sizeof(T);
        }
    });
    messages_.reset();
  }

 private:
  struct Messages {
    explicit Messages(std::size_t ranks) : sent(ranks), got(ranks) {}
    std::vector<std::string> sent, got;
    std::vector<MPI_Request> requests{};
  };

  template <class F>
  void each_field(const F& f) {
    std::apply([&](auto&... all) { each_pair(f, all...); }, all_);
  }
  template <class F, class Lists, class Field, class... More>
  static void each_pair(const F& f, const Lists& lists, Field& field, More&... more) {
    f(lists, field);
    if constexpr (sizeof...(more) > 0) each_pair(f, more...);
  }

  std::unique_ptr<Messages> messages_;
  std::tuple<ListsAndFields&...> all_;
};

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
  /// Of lists and fields in turn, which must outlive it.
  template <class... ListsAndFields>
  MpiTrade<ListsAndFields...> start_trade(ListsAndFields&... all) const {
    return {communicator_, size_, all...};
  }
  template <class... ListsAndFields>
  void trade(ListsAndFields&... all) const {
    start_trade(all...).finish();
  }

 private:
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
