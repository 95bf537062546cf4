// What a scene stores, pinned: absent physics has no bytes. Listed in docs/tour.md.
#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using D8 = Pack<double, 8>;
constexpr std::size_t d8 = sizeof(D8);

using Metal = Solid<LinearEos, VonMises>;
using Brittle = Solid<LinearEos, VonMises, UltimateStress>;
using Hot = Solid<GruneisenEos, JohnsonCook>;
using Liquid = Fluid<CubicEos>;
using Gas = Fluid<IdealGas>;

// Material points, in numbers: a stress is six, a plastic strain, an energy, a flag and a pressure one each.
static_assert(sizeof(Elastic::State<double>) == 6 * sizeof(double));
static_assert(sizeof(Metal::State<double>) == 7 * sizeof(double));
static_assert(sizeof(Solid<LinearEos, ElasticStrength>::State<double>) == 6 * sizeof(double));
static_assert(sizeof(Brittle::State<double>) == 8 * sizeof(double));
static_assert(sizeof(Hot::State<double>) == 9 * sizeof(double));  // stress, plastic strain, temperature, energy
static_assert(sizeof(Liquid::State<double>) == 1 * sizeof(double));
static_assert(sizeof(Gas::State<double>) == 2 * sizeof(double));
static_assert(sizeof(Metal::State<D8>) == 7 * d8);

// Elements add 1/V0, what their bulk viscosity was, and the forces of a stiffness hourglass control.
using Plain = Hex8<NoHourglass, HughesWinget, NoBulkViscosity>;
static_assert(sizeof(Plain::State<Metal, D8>) == 8 * d8);
static_assert(sizeof(Hex8<>::State<Metal, D8>) == 9 * d8);
static_assert(sizeof(Hex8<ViscousHourglass, HughesWinget, NoBulkViscosity>::State<Metal, D8>) == 8 * d8);
static_assert(sizeof(Hex8<StiffnessHourglass>::State<Metal, D8>) == 21 * d8);

// A block has its eight nodes in each lane: 32 bytes an element. A node has position, velocity and force of four
// numbers.
static_assert(sizeof(RunningPart<Hex8<>, Metal, D8>::Block) == 9 * d8 + 8 * 8 * sizeof(Index));
static_assert(sizeof(Padded<double>) == 32 && sizeof(Padded<float>) == 16);

}  // namespace

TEST_CASE("a metal hexahedron takes 108 bytes in double, a node 112") {
  using Block = RunningPart<Hex8<>, Metal, D8>::Block;
  CHECK(sizeof(Block) / 8 + sizeof(Index) == 108);                                // with its number
  CHECK(3 * sizeof(Padded<double>) + sizeof(double) + 2 * sizeof(Index) == 112);  // with mass, number and place
}
