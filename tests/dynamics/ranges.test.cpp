// Options, policies and items of a run are checked when it begins.
#include <limits>

#include <strike/dynamics/every.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/mesh/box.hpp>
#include <strike/motion/openmp.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double nan_number = std::numeric_limits<double>::quiet_NaN();
const Elastic rubber{.density = 1000, .youngs_modulus = 1e6};
const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});

template <class... Items>
auto scene(Items... items) {
  return Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, items...};
}
void refused(const ExplicitOptions& options, const std::string& sentence) {
  CHECK_THROWS_WITH((Explicit{scene(), options, in<double>}), "strike: " + sentence);
}

}  // namespace

TEST_CASE("options of a run") {
  for (const double factor : {2.0, -1.0, 0.0, nan_number})
    refused({.step_factor = factor},
            "the step_factor of ExplicitOptions is " + detail::text(factor) + "; it must be positive and at most 1.");
  for (const double growth : {0.9, nan_number})
    refused({.step_growth = growth},
            "the step_growth of ExplicitOptions is " + detail::text(growth) + "; it must be at least 1.");
  refused({.largest_step = nan_number}, "the largest_step of ExplicitOptions is nan; it must be positive.");
  refused({.smallest_step = -1}, "the smallest_step of ExplicitOptions is -1; it must be zero or positive.");
  refused({.energy_tolerance = nan_number}, "the energy_tolerance of ExplicitOptions is nan; it must be positive.");
}

TEST_CASE("policies of a run") {
  CHECK_THROWS_WITH(Method(GlobalStep{.failure = 0}),
                    "strike: the failure of GlobalStep is 0; it must be positive and below 1.");
  CHECK_THROWS_WITH(Method(Serial{}, GlobalStep{.deviation = nan_number}),
                    "strike: the deviation of GlobalStep is nan; it must be positive and below 1.");
  for (const double tolerance : {0.0, -1.0, 1.0, nan_number})
    CHECK_THROWS_WITH(Method(DynamicRelaxation{.tolerance = tolerance}),
                      "strike: the tolerance of DynamicRelaxation is " + detail::text(tolerance) +
                          "; it must be positive and below 1.");
  CHECK_THROWS_WITH(Method(Subcycling{.largest = 0}),
                    "strike: the largest of Subcycling is 0; it must be at least 1 and at most 1000.");
  CHECK_THROWS_AS(OpenMP(detail::in_range(OpenMP{.threads = -2})), Error);
  CHECK_THROWS_WITH((Explicit{scene(), in<double>, DynamicRelaxation{.tolerance = 0}}),
                    "strike: the tolerance of DynamicRelaxation is 0; it must be positive and below 1.");
}

TEST_CASE("intervals, limits of erosion and items") {
  CHECK_THROWS_WITH((Every{nan_number, [] {}}), "strike: the interval of Every is nan; it must be positive.");
  CHECK_THROWS_WITH(
      (Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra, Erosion{.strain = -0.3}}}, {}, in<double>}),
      "strike: the strain of Erosion, in part 0, is -0.3; it must be positive.");
  CHECK_THROWS_WITH((Explicit{scene(NodalForce{{nan_number, 0, 0}, {0}}), in<double>}),
                    "strike: the force of NodalForce is (nan, 0, 0); it must be finite.");
}
