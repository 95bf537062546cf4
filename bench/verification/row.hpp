#pragma once
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

namespace verification {

/// A part of the names of the problems to run.
inline std::string_view& wanted() {
  static std::string_view name;
  return name;
}
inline bool is_wanted(std::string_view name) { return name.find(wanted()) != std::string_view::npos; }

struct Band {
  double reference, tolerance;
};
/// Where nothing is known beforehand.
constexpr Band unknown{std::numeric_limits<double>::quiet_NaN(), 0};

inline void row(const char* problem, const char* quantity, const Band& band, double ours, const char* unit) {
  if (std::isnan(band.reference))
    std::printf("| %s | %s | | | %.5g | %s | |\n", problem, quantity, ours, unit);
  else
    std::printf("| %s | %s | %g | %g | %.5g | %s | %s |\n", problem, quantity, band.reference, band.tolerance, ours,
                unit, std::abs(ours - band.reference) <= band.tolerance ? "yes" : "**no**");
  std::fflush(stdout);
}

/// The rows of plates and of particles, see plates.cpp and particles.cpp.
void plates();
void particles();

}  // namespace verification
