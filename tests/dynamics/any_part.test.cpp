// Items that are chosen when the run starts: the same as if they stood in the scene, under every policy.
#include <bit>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/section/layered.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

using Lead = Solid<LinearEos, VonMises>;
const Lead lead{LinearEos{.density = 1e-6, .bulk_modulus = 2.2},
                VonMises{.shear_modulus = 0.5, .yield_stress = 0.02, .hardening_modulus = 0.01}};
const Elastic rubber{.density = 1e-6, .youngs_modulus = 1, .poissons_ratio = 0.4};
const Homogeneous skin{PlaneStress{lead}, 0.2};

/// A plastic block that erodes, above it one of tetrahedra, both on a plate, which lies on one line of supports.
struct Pieces {
  Mesh mesh = box({.size = {3, 3, 2}, .cells = {3, 3, 2}});
  Cells<4> tetrahedra, plates;

  Pieces() {
    const Mesh upper = tetrahedralized(translated(box({.size = {2, 2, 2}, .cells = {2, 2, 2}}), {0.3, 0.4, 2.05}));
    const Mesh sheet = translated(rectangle({.size = {4, 4}, .cells = {4, 4}}), {-0.4, -0.6, -0.2});
    append(mesh, upper), append(mesh, sheet);
    tetrahedra = mesh.tetrahedra, plates = mesh.quadrilaterals;
  }
  Part<Hex8<>, Lead, 8, Erosion> block() const { return {Hex8{}, lead, mesh.hexahedra, Erosion{.strain = 0.3}}; }
  InitialVelocity flight() const {
    return {{10, 0, -400}, nodes_where(mesh.nodes, [](const auto& x) { return x.z() > -0.1; })};
  }
  Support line(double x) const {
    return {nodes_where(mesh.nodes, [&](const auto& p) { return p.z() < -0.1 && std::abs(p.x() - x) < 0.1; }),
            {{1, 0, 0}, {0, 0, 1}}};
  }
  auto spelled() const {
    return Scene{mesh.nodes, block(),   Part{Tet4{}, rubber, tetrahedra},   Part{Plate4{}, skin, plates}, flight(),
                 line(-0.4), line(3.6), Contact{Everything{}, Coulomb{0.2}}};
  }
};

using Block = decltype(Pieces{}.block());
using Any =
    AnyPart<PartOf<Plate4<>, Homogeneous<PlaneStress<Lead>>>, PartOf<Hex8<>, Lead>, Block, PartOf<Tet4<>, Elastic>>;
using Pressing = std::variant<RigidWall, Contact<Everything, Kinematic, Coulomb>>;

auto listed(const Pieces& p) {
  return Scene{p.mesh.nodes,
               std::vector<Any>{p.block(), Part{Tet4{}, rubber, p.tetrahedra}, Part{Plate4{}, skin, p.plates}},
               std::vector{p.flight()}, std::vector<Support>{p.line(-0.4), p.line(3.6)},
               std::vector<Pressing>{Contact{Everything{}, Coulomb{0.2}}}};
}

/// Of all that a run knows after so many steps.
template <class Run>
std::uint64_t hash_of(Run& run, int steps = 25) {
  for (int i = 0; i < steps; ++i) run.step();
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto mix = [&](double x) { hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; };
  for (const auto& vectors : {run.positions(), run.velocities()})
    for (const Eigen::Vector3d& a : vectors)
      for (const double component : a) mix(component);
  const Energy& e = run.energy();
  for (const double energy : {e.kinetic, e.internal, e.hourglass, e.contact, e.eroded, run.dt()}) mix(energy);
  run.each_part([&](const auto& part) {
    for (const double strain : part.field(PlasticStrain{})) mix(strain);
    mix(static_cast<double>(part.number()));
  });
  return hash;
}

template <class... Policies>
void check_same(const Policies&... policies) {
  const Pieces pieces;
  Explicit one{pieces.spelled(), {}, policies...};
  Explicit other{listed(pieces), {}, policies...};
  CHECK(hash_of(one) == hash_of(other));
  CHECK(one.energy().eroded > 0);
  CHECK(one.warnings() == other.warnings());
}

}  // namespace

TEST_CASE("items chosen at the start give the bits of a scene that names them") {
  SECTION("with subcycling") { check_same(Subcycling{}); }
  SECTION("with the bound of the whole mesh, threads and mixed numbers") {
#ifdef _OPENMP
    check_same(GlobalStep{}, OpenMP{2}, In<Pack<float>, double>{});
#endif
  }
}

TEST_CASE("kinds of plates that no part has change no bit of a scene of solids") {
  const Pieces pieces;
  const Mesh brick = box({.size = {3, 3, 2}, .cells = {3, 3, 2}});
  Explicit bare{
      Scene{brick.nodes, pieces.block(), InitialVelocity{{10, 0, -100}}, RigidWall{{0, 0, 0}, {0, 0, 1}, 0.2}}};
  Explicit any{Scene{brick.nodes, std::vector<Any>{pieces.block()}, InitialVelocity{{10, 0, -100}},
                     RigidWall{{0, 0, 0}, {0, 0, 1}, 0.2}}};
  CHECK(hash_of(bare) == hash_of(any));
}

TEST_CASE("a run of chosen items goes on from a checkpoint to the bit, and no other goes on from it") {
  const ScratchFolder folder("any_part");
  const Pieces pieces;
  Explicit first{listed(pieces), {}, Subcycling{}};
  hash_of(first);
  write_checkpoint(folder / "half", first);
  Explicit second{listed(pieces), {}, Subcycling{}};
  read_checkpoint(folder / "half", second);
  CHECK(hash_of(first) == hash_of(second));

  auto fewer = listed(pieces);
  std::get<2>(fewer.items).pop_back();
  auto another = listed(pieces);
  another.items = {
      {Part{Hex8{}, lead, pieces.mesh.hexahedra}, std::get<0>(another.items)[1], std::get<0>(another.items)[2]},
      std::get<1>(another.items),
      std::get<2>(another.items),
      std::get<3>(another.items)};
  for (const auto* scene : {&fewer, &another}) {
    Explicit run{*scene, {}, Subcycling{}};
    CHECK_THROWS_WITH(read_checkpoint(folder / "half", run), ContainsSubstring("checkpoint"));
  }
}

TEST_CASE("faults of chosen items are told as those of others") {
  const Pieces pieces;
  auto scene = listed(pieces);
  std::get<Block>(std::get<0>(scene.items)[0]).material.strength.shear_modulus = -1;
  CHECK_THROWS_WITH((Explicit{scene, {}, Subcycling{}}),
                    ContainsSubstring("shear_modulus") && ContainsSubstring("in part 0"));
  scene = listed(pieces);
  std::get<0>(scene.items).pop_back();
  CHECK_THROWS_WITH((Explicit{scene, {}, Subcycling{}}),
                    ContainsSubstring("has no mass, for it belongs to no element"));
  scene = listed(pieces);
  std::get<PartOf<Tet4<>, Elastic>>(std::get<0>(scene.items)[1]).cells.clear();
  CHECK_THROWS_WITH((Explicit{scene, {}, Subcycling{}}), ContainsSubstring("part 1 has no elements"));
}
