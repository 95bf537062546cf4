// That wrong numbers are refused, conformance/ranges_of_scenes tests. Here: what has none, and the numbers of nodes.
#include <strike/load.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a condition without numbers and a history that is a function are in range") {
  CHECK_NOTHROW(detail::check_ranges(Clamped{{0}}));
  CHECK_NOTHROW(detail::check_ranges(Pressure{{}, [](double t) { return t; }}));
}

TEST_CASE("what writes to a node that is not there is refused, by any number") {
  Nodes<double> nodes({{0, 0, 0}, {1, 0, 0}}, {0, 1});
  const auto refuses = [](const auto& f) {
    CHECK_THROWS_WITH(f(), "strike: a condition names node 999, but there are 2 nodes; count them from 0.");
  };
  refuses([&] { nodes.add_force(999, {1, 0, 0}); });
  refuses([&] { nodes.set_velocity(999, {1, 0, 0}); });
  refuses([&] { nodes.set_position(999, {1, 0, 0}); });
  refuses([&] { nodes.add_mass(999, 1); });
}
