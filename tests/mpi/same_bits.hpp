#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <strike/mpi.hpp>
#include <strike/output/archive.hpp>
#include <strike/strike.hpp>

#include "support/catch.hpp"

namespace strike::testing {

/// All that a checkpoint keeps of a run, and all that must be equal where it goes on.
class Bytes final : public strike::Archive {
 public:
  Bytes() : Archive(false) {}

  std::string kept, same;

 private:
  void bytes(void* at, std::size_t count) override { kept.append(static_cast<const char*>(at), count); }
  void note(const void* at, std::size_t count) override { same.append(static_cast<const char*>(at), count); }
};
template <class Run>
Bytes bytes_of(Run& run) {
  Bytes bytes;
  bytes(run);
  return bytes;
}

inline std::uint64_t hash_of(const std::string& bytes) {
  strike::detail::Hash hash;
  hash.add(bytes.data(), bytes.size());
  return hash.value();
}

/// True if it is in all processes, which so fail together and wait for none.
inline bool everywhere(bool here) {
  const auto there = strike::detail::of_all_ranks(strike::Mpi{}.ranks(), static_cast<char>(here));
  return std::find(there.begin(), there.end(), false) == there.end();
}
/// True if all processes have the same bytes.
inline bool all_have(const std::string& bytes) {
  const auto hashes = strike::detail::of_all_ranks(strike::Mpi{}.ranks(), hash_of(bytes));
  return std::count(hashes.begin(), hashes.end(), hashes[0]) == static_cast<std::ptrdiff_t>(hashes.size());
}

/// The scene, a function that makes it, has the same bytes after some steps on all processes, with threads, as on each
/// alone. Returns both runs.
template <class MakeScene, class... Policies>
auto runs_alike(const MakeScene& scene, int steps, const Policies&... policies) {
  using strike::Mpi, strike::OpenMP;
  const strike::ExplicitOptions options{.step_factor = .8, .energy_tolerance = .5, .print_warnings = false};
  strike::Explicit alone{scene(), options, Mpi{MPI_COMM_SELF, OpenMP{1}}, policies...};
  strike::Explicit together{scene(), options, Mpi{MPI_COMM_WORLD, OpenMP{2}}, policies...};
  for (int n = 0; n < steps; ++n) {
    alone.step(), together.step();
    REQUIRE(everywhere(together.dt() == alone.dt()));
    REQUIRE(everywhere(together.energy().held() == alone.energy().held()));
    if (n % 20 > 0 && n + 1 < steps) continue;
    const Bytes bytes = bytes_of(together), of_alone = bytes_of(alone);
    REQUIRE(everywhere(bytes.kept == of_alone.kept));
    REQUIRE(everywhere(bytes.same == of_alone.same));
    REQUIRE(all_have(bytes.kept));
  }
  CHECK(together.positions() == alone.positions());
  CHECK(together.warnings() == alone.warnings());
  together.each_part([&](const auto& part) {
    alone.each_part([&](const auto& other) {
      if (part.number() == other.number()) CHECK(part.alive() == other.alive());
    });
  });
  return std::pair(std::move(together), std::move(alone));
}

}  // namespace strike::testing
