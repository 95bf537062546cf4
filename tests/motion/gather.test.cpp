#include <strike/motion/gather.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// 40 nodes whose components say who they are, and a block that meets them in a scattered order, some twice.
template <class T>
void moves_every_lane() {
  using Real = RealOf<T>;
  std::vector<Padded<Real>> field(40);
  for (std::size_t i = 0; i < field.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) field[i].set(c, static_cast<Real>(10 * i + c));
  BlockNodes<8, lanes<T>> nodes;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t l = 0; l < lanes<T>; ++l) nodes[i][l] = static_cast<Index>((7 * i + 11 * l + 3) % 40);

  const auto a = gather<T, 8>(field, nodes);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (int c = 0; c < 3; ++c)
        REQUIRE(lane(a(c, static_cast<int>(i)), l) == field[nodes[i][l]][static_cast<std::size_t>(c)]);

  std::vector<Padded<Real>> second(field);
  for (auto& a_i : second) a_i += Padded<Real>(1000);
  const auto both = gather<T, 8>(field, second, nodes);
  for (int i = 0; i < 8; ++i)
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (int c = 0; c < 3; ++c) {
        REQUIRE(lane(both(c, i), l) == lane(a(c, i), l));
        REQUIRE(lane(both(c, 8 + i), l) == lane(a(c, i), l) + 1000);
      }

  for (std::size_t count = 0; count <= lanes<T>; ++count) {  // all blocks but the last are full
    std::vector<Padded<Real>> forces(40, Padded<Real>(0)), expected(forces);
    scatter_subtract<T, 8>(a, forces, nodes, count);
    std::vector<Padded<Real>> moments(40, Padded<Real>(0));
    scatter_subtract<T, 8>(both, moments, nodes, count, 8);  // the columns behind
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t l = 0; l < count; ++l) {
        expected[nodes[i][l]] -= field[nodes[i][l]];
        moments[nodes[i][l]] += second[nodes[i][l]];
      }
    for (std::size_t i = 0; i < 40; ++i)
      for (std::size_t c = 0; c < 3; ++c) {  // whole numbers: exact in any order
        REQUIRE(forces[i][c] == expected[i][c]);
        REQUIRE(moments[i][c] == 0);
      }
  }
}

}  // namespace

TEST_CASE("gather and scatter move every lane of a double") { moves_every_lane<double>(); }
TEST_CASE("gather and scatter move every lane of 2 doubles") { moves_every_lane<Pack<double, 2>>(); }
TEST_CASE("gather and scatter move every lane of 4 doubles") { moves_every_lane<Pack<double, 4>>(); }
TEST_CASE("gather and scatter move every lane of 8 doubles") { moves_every_lane<Pack<double, 8>>(); }
TEST_CASE("gather and scatter move every lane of 16 doubles") { moves_every_lane<Pack<double, 16>>(); }
TEST_CASE("gather and scatter move every lane of 4 floats") { moves_every_lane<Pack<float, 4>>(); }
TEST_CASE("gather and scatter move every lane of 8 floats") { moves_every_lane<Pack<float, 8>>(); }
TEST_CASE("gather and scatter move every lane of 16 floats") { moves_every_lane<Pack<float, 16>>(); }
