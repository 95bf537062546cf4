// What a scene stores, pinned: absent physics has no bytes. Listed in docs/tour.md.
#include <concepts>
#include <type_traits>

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
static_assert(sizeof(Solid<LinearEos, RateVonMises>::State<double>) == 7 * sizeof(double));
static_assert(sizeof(Solid<LinearEos, VonMises, FailureStrain>::State<double>) == 8 * sizeof(double));
static_assert(sizeof(Solid<PolynomialEos, VonMises>::State<double>) == 8 * sizeof(double));
static_assert(sizeof(Fluid<CubicEos, Newtonian>::State<double>) == 1 * sizeof(double));

// No plastic strain without plasticity, no temperature without a law that asks for it, no energy without an equation of
// state that does, no flag without a failure; and NoFailure is what there is without one.
template <class M>
concept HasPlasticStrain = requires(typename M::template State<double> state) { state.equivalent_plastic_strain; };
template <class M>
concept HasTemperature = requires(typename M::template State<double> state) { state.temperature_rise; };
template <class M>
concept HasEnergy = requires(typename M::template State<double> state) { state.internal_energy; };
template <class M>
concept HasFlag = requires(typename M::template State<double> state) { state.intact; };
static_assert(!HasPlasticStrain<Elastic> && !HasPlasticStrain<Solid<LinearEos, ElasticStrength>>);
static_assert(!HasTemperature<Metal> && !HasTemperature<Solid<LinearEos, RateVonMises>>);
static_assert(!HasEnergy<Elastic> && !HasEnergy<Metal> && !HasEnergy<Liquid>);
static_assert(!HasFlag<Elastic> && !HasFlag<Metal> && !HasFlag<Hot> && !HasFlag<Liquid>);
static_assert(HasPlasticStrain<Hot> && HasTemperature<Hot> && HasEnergy<Hot> && HasFlag<Brittle>);
static_assert(std::same_as<Solid<LinearEos, VonMises, NoFailure>, Metal>);

// Elements add 1/V0, what their bulk viscosity was, and the forces of a stiffness hourglass control.
using Plain = Hex8<NoHourglass, HughesWinget, NoBulkViscosity>;
static_assert(sizeof(Plain::State<Metal, D8>) == 8 * d8);
static_assert(sizeof(Hex8<ViscousHourglass>::State<Metal, D8>) == 9 * d8);
static_assert(sizeof(Hex8<ViscousHourglass, HughesWinget, NoBulkViscosity>::State<Metal, D8>) == 8 * d8);
static_assert(sizeof(Hex8<StiffnessHourglass>::State<Metal, D8>) == 21 * d8);
static_assert(sizeof(Hex8<PhysicalHourglass>::State<Metal, D8>) == 21 * d8);
static_assert(std::is_empty_v<NoHourglass::State<D8>> && std::is_empty_v<ViscousHourglass::State<D8>>);
static_assert(std::is_empty_v<NoBulkViscosity::State<D8>>);
static_assert(sizeof(Hex8<ViscousHourglass, Jaumann, BulkViscosity, EndStep>::State<Metal, D8>) == 9 * d8);
static_assert(sizeof(Hex8Full<>::State<Metal, D8>) == (2 + 8 * 7) * d8);

// A section has the points of its layers and a shear force; a plate adds 1/A0, five resistances against hourglass modes
// (or two linear stresses at each point, and two shears) and four against drilling, and a thickness that changes.
using Sheet = Homogeneous<PlaneStress<Metal>>;
static_assert(sizeof(PlaneStress<Metal>::State<double>) == 4 * sizeof(double));
static_assert(sizeof(Sheet::State<double>) == (5 * 4 + 2) * sizeof(double));
static_assert(sizeof(Homogeneous<PlaneStress<Elastic>, Gauss<3>, FiveSixthsShear, Offset>::State<double>) ==
              (3 * 3 + 2) * sizeof(double));
using Ply = Layer<PlaneStress<Elastic>, Gauss<3>>;
static_assert(sizeof(Layered<Ply, Ply>::State<double>) == (2 * 3 * 3 + 2) * sizeof(double));
static_assert(sizeof(Layered<Ply, Ply, InstantaneousShear>::State<double>) == (2 * (3 * 3 + 1) + 3) * sizeof(double));
static_assert(sizeof(Plate3<>::State<Sheet, D8>) == (1 + 3 + 22) * d8);
static_assert(sizeof(Plate3<ConstantThickness, FreeDrilling>::State<Sheet, D8>) == (1 + 22) * d8);
static_assert(sizeof(Plate4<>::State<Sheet, D8>) == (1 + 5 + 4 + 22) * d8);
static_assert(sizeof(Plate4<PhysicalHourglass>::State<Sheet, D8>) == (1 + 5 * 2 + 2 + 4 + 22) * d8);
static_assert(sizeof(Plate4<PlateHourglass, NoWarping, ThicknessChange, FreeDrilling>::State<Sheet, D8>) ==
              (1 + 1 + 5 + 22) * d8);
static_assert(sizeof(Plate4<NoPlateHourglass, RigidOffset, ConstantThickness, FreeDrilling>::State<Sheet, D8>) ==
              (1 + 22) * d8);

// Nodes turn, and have angular velocities and moments, where there are plates and nowhere else.
using Solids = Part<Hex8<>, Metal>;
using Plates = Part<Plate4<>, Sheet, 4>;
static_assert(!Scene<Solids, RigidWall, Symmetry>::nodes_turn && Scene<Solids, Plates>::nodes_turn);
static_assert(sizeof(Motion<double>) == 3 * sizeof(NodalField<double>));
static_assert(sizeof(Motion<double, true>) == 5 * sizeof(NodalField<double>));

// A block has its eight nodes in each lane: 32 bytes an element. A node has position, velocity and force of four
// numbers.
static_assert(sizeof(RunningPart<Hex8<ViscousHourglass>, Metal, D8>::Block) == 9 * d8 + 8 * 8 * sizeof(Index));
static_assert(sizeof(Padded<double>) == 32 && sizeof(Padded<float>) == 16);

// A thing in a scene takes its own bytes and no others.
template <class... Things>
using Run = Explicit<Method<>, Part<Hex8<>, Metal>, Things...>;
static_assert(sizeof(Run<RigidWall>) == sizeof(Run<>) + sizeof(RigidWall));
static_assert(sizeof(Run<Symmetry, BodyForce<>>) == sizeof(Run<>) + sizeof(Symmetry) + sizeof(BodyForce<>));
static_assert(sizeof(Run<InitialVelocity>) == sizeof(Run<>) + sizeof(InitialVelocity));

}  // namespace

TEST_CASE("a metal hexahedron takes 108 bytes in double, a node 112") {
  using Block = RunningPart<Hex8<ViscousHourglass>, Metal, D8>::Block;
  CHECK(sizeof(Block) / 8 + sizeof(Index) == 108);                                // with its number
  CHECK(3 * sizeof(Padded<double>) + sizeof(double) + 2 * sizeof(Index) == 112);  // with mass, number and place
}

TEST_CASE("nodes have moments of inertia where plates turn them, and nowhere else") {
  const Nodes<double> still({{0, 0, 0}}, {0});
  const Nodes<double, double, true> turned({{0, 0, 0}}, {0});
  CHECK(still.inertia().capacity() == 0);
  CHECK(turned.inertia().size() == 1);
}
