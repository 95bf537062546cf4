// The ends of ranges that conformance/ranges_of_scenes does not reach.
#include <strike/contact.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("the fraction of a Penalty is at most 2") {
  const NodeToSurface pairing{{0, 1}, Surface{surface(box({.size = {1, 1, 1}, .cells = {1, 1, 1}}))}};
  CHECK_NOTHROW(Contact{pairing, Penalty{.fraction = 2}});
  CHECK_THROWS_WITH((Contact{pairing, Penalty{.fraction = 2.1}}),
                    "strike: the fraction of Penalty is 2.1; it must be positive and at most 2.");
}
