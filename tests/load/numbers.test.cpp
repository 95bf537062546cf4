// Loads, conditions and walls that name a node that is not there say so at the start.
#include <strike/contact/rigid_wall.hpp>
#include <strike/load.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("whatever names a node that is not there is refused in one sentence") {
  using Catch::Matchers::ContainsSubstring;
  const auto refuses = [](auto thing) {
    Nodes<double> nodes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 3});
    CHECK_THROWS_WITH(thing.begin(nodes), ContainsSubstring("names node 7, but there are 4 nodes; count them from 0."));
  };
  refuses(NodalForce{{1, 0, 0}, {0, 7}});
  refuses(Pressure{{{.nodes = {0, 1, 2, 7}, .cell = 0}}, Constant{}});
  refuses(AirBlast{{{.nodes = {0, 1, 2, 7}, .cell = 0}}, Charge{.mass = 1, .centre = {0, 0, 2}}});
  refuses(InitialVelocity{{1, 0, 0}, {7}});
  refuses(Clamped{{7}});
  refuses(PrescribedVelocity{Axis::x, {7}, Constant{}});
  refuses(RigidWall{{0, 0, 0}, {0, 0, 1}, std::vector<Index>{7}});
}
