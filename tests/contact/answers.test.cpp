#include "conformance/answers.hpp"

#include <strike/contact.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
template <class... Policies>
auto two_way(const Policies&... policies) {
  return [=](const Surface& one, const Surface& other) { return Contact{TwoWay{one, other}, policies...}; };
}
template <class... Policies>
auto everything(const Policies&... policies) {
  return [=](const Surface&, const Surface&) { return Contact{Everything{}, policies...}; };
}
const testing::Allowed soft{.depth = 0.02};
}  // namespace

TEST_CASE("conformance: TwoWay answers alike however its scene lies and is numbered") {
  testing::answers_alike(two_way());
}
TEST_CASE("conformance: TwoWay, Coulomb") { testing::answers_alike(two_way(Coulomb{0.3})); }
TEST_CASE("conformance: TwoWay, Penalty") { testing::answers_alike(two_way(Penalty{}), soft); }
TEST_CASE("conformance: TwoWay, Penalty, Coulomb") { testing::answers_alike(two_way(Penalty{}, Coulomb{0.3}), soft); }
TEST_CASE("conformance: SelfContact") {
  testing::answers_alike([](const Surface& one, const Surface& other) { return Contact{SelfContact{one + other}}; });
}
TEST_CASE("conformance: Everything") { testing::answers_alike(everything()); }
TEST_CASE("conformance: Everything, Penalty, Coulomb") {
  testing::answers_alike(everything(Penalty{}, Coulomb{0.3}), soft);
}
TEST_CASE("conformance: NodeToSurface") {
  testing::answers_alike(
      [](const Surface& one, const Surface& other) {
        return Contact{NodeToSurface{one.nodes(), other, one.pieces()[0].thickness}};
      },
      {.has_edges = false, .two_way = false});
}
