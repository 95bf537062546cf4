// The ends of ranges that conformance/ranges_of_scenes does not reach, and the place of a number in a scene.
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/element/hex8.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("ends of the ranges of options and policies") {
  const auto refused = [](const ExplicitOptions& options, const std::string& sentence) {
    CHECK_THROWS_WITH(detail::check_ranges(options), "strike: the " + sentence);
  };
  refused({.step_factor = 1.1}, "step_factor of ExplicitOptions is 1.1; it must be positive and at most 1.");
  refused({.step_growth = 0.9}, "step_growth of ExplicitOptions is 0.9; it must be at least 1.");
  CHECK_NOTHROW(detail::check_ranges(ExplicitOptions{.step_factor = 1.1, .largest_step = 1}));
  CHECK_THROWS_WITH(Method(GlobalStep{.failure = 1}),
                    "strike: the failure of GlobalStep is 1; it must be positive and below 1.");
  CHECK_THROWS_WITH(Method(Serial{}, DynamicRelaxation{.tolerance = 1}),
                    "strike: the tolerance of DynamicRelaxation is 1; it must be positive and below 1.");
  CHECK_THROWS_WITH(Method(Subcycling{.largest = 1001}),
                    "strike: the largest of Subcycling is 1001; it must be at least 1 and at most 1000.");
}

TEST_CASE("the sentence names the part") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic rubber{.density = 1000, .youngs_modulus = 1e6};
  const Erosion erosion{.strain = -0.3};
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra, erosion}}, in<double>}),
                    "strike: the strain of Erosion, in part 0, is -0.3; it must be positive.");
}
