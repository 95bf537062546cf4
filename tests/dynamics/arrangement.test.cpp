// How a scene lies in memory and who computes it does not show: neither the numbers of the elements, nor those of the
// nodes, nor how many threads are at work change a bit of its results.
#include <algorithm>
#include <bit>
#include <numeric>
#include <random>

#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

std::vector<Index> random_order(std::size_t size, unsigned seed) {
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), Index{0});
  if (seed > 0) std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

/// Two blocks, one of plastic copper and one elastic, that share a face and strike a wall, and plates that may cover
/// two sides of them; numbered anew by seeds other than 0.
struct Numbered {
  Mesh mesh = box({.size = {2, 2, 4}, .cells = {6, 6, 12}});
  std::vector<Index> node, element;  // the numbers of what is node i and element e by nature
  Cells<8> metal, rubber;
  Cells<4> skin;

  Numbered(unsigned node_seed, unsigned element_seed)
      : node(random_order(mesh.nodes.size(), node_seed)), element(random_order(mesh.hexahedra.size(), element_seed)) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.02, 0.02);
    std::vector<Eigen::Vector3d> nodes(mesh.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes[node[i]] = mesh.nodes[i] + Eigen::Vector3d(shift(random), shift(random), shift(random));
    Cells<8> cells(mesh.hexahedra.size());
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (std::size_t i = 0; i < 8; ++i) cells[element[e]][i] = node[mesh.hexahedra[e][i]];
    for (const Face& face : surface(mesh))
      if (const Eigen::Vector3d x = centroid(mesh.nodes, face.nodes); x.x() > 1.9 || x.z() > 3.9)
        skin.push_back({node[face.nodes[0]], node[face.nodes[1]], node[face.nodes[2]], node[face.nodes[3]]});
    if (element_seed > 0) std::shuffle(skin.begin(), skin.end(), std::mt19937(element_seed));
    mesh.nodes = nodes, mesh.hexahedra = cells;
    for (const auto& cell : cells) (centroid(nodes, cell).z() < 1.5 ? metal : rubber).push_back(cell);
  }
};

/// Mixes the bits of a number into a hash (Fowler, Noll and Vo).
void mix(std::uint64_t& hash, double x) { hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; }

const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                   VonMises{.shear_modulus = 43, .yield_stress = 0.04, .hardening_modulus = 0.1}};

template <class... More>
auto scene_of(const Numbered& numbered, More... more) {
  const Elastic rubber{.density = 1e-6, .youngs_modulus = 1, .poissons_ratio = 0.4};
  return Scene{numbered.mesh.nodes,
               Part{Hex8{}, copper, numbered.metal},
               Part{Hex8{StiffnessHourglass{}}, rubber, numbered.rubber},
               InitialVelocity{{3, 0, -20}},
               RigidWall{{0, 0, -0.05}, {0, 0, 1}, 0.2},
               std::move(more)...};
}

constexpr auto bare = [](const Numbered& numbered) { return scene_of(numbered); };
constexpr auto covered = [](const Numbered& numbered) {
  return scene_of(numbered, Part{Plate4{}, Homogeneous{PlaneStress{copper}, 0.1}, numbered.skin});
};

/// Of positions, velocities, energies and the step after 500 steps.
template <class SceneOf, class... Policies>
std::uint64_t hash_of(const SceneOf& scene, const Numbered& numbered, Policies... policies) {
  Explicit run{scene(numbered), {}, policies...};
  for (int i = 0; i < 500; ++i) run.step();
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Index i : numbered.node)
    for (const Eigen::Vector3d& a : {run.nodes().x(i), run.nodes().v(i)})
      for (const double component : a) mix(hash, component);
  if constexpr (std::decay_t<decltype(run.nodes())>::nodes_turn)
    for (const Index i : numbered.node)
      for (const double component : run.nodes().w(i)) mix(hash, component);
  for (const double energy : {run.energy().kinetic, run.energy().internal, run.energy().hourglass}) mix(hash, energy);
  mix(hash, run.dt());
  return hash;
}

}  // namespace

using Mixed = In<Pack<float>, double>;

// In single precision elements lie as in mixed; one lane has threads as many have.
TEMPLATE_TEST_CASE("neither numbers nor threads change a bit of the results", "", In<double>, In<Pack<double>>, Mixed) {
  const TestType numbers;
  const std::uint64_t natural = hash_of(covered, Numbered(0, 0), numbers);
  CHECK(hash_of(covered, Numbered(0, 1), numbers) == natural);
  CHECK(hash_of(covered, Numbered(1, 0), numbers) == natural);
  CHECK(hash_of(covered, Numbered(2, 3), numbers) == natural);
#ifdef _OPENMP
  if constexpr (!std::is_same_v<TestType, In<double>>) {
    for (const int threads : {1, 2, 3, 4}) CHECK(hash_of(covered, Numbered(0, 0), numbers, OpenMP{threads}) == natural);
    CHECK(hash_of(covered, Numbered(2, 3), OpenMP{3}, numbers) == natural);
  }
#endif
}

TEST_CASE("nor do they with the bound of the whole mesh") {
  const std::uint64_t natural = hash_of(bare, Numbered(0, 0), GlobalStep{});
  CHECK(hash_of(bare, Numbered(2, 3), GlobalStep{}) == natural);
#ifdef _OPENMP
  CHECK(hash_of(bare, Numbered(0, 0), GlobalStep{}, OpenMP{2}) == natural);
  CHECK(hash_of(bare, Numbered(2, 3), OpenMP{3}, GlobalStep{}) == natural);
#endif
}

TEST_CASE("elements are told by the numbers that they were given") {
  const Numbered natural(0, 0), numbered(2, 3);
  const auto middles = [](const Numbered& n) {
    Explicit run{Scene{n.mesh.nodes, Part{Hex8{}, Elastic{1, 1}, n.mesh.hexahedra}}};
    run.step();
    return std::pair{run.stable_step().element,
                     run.template part<0>().field([](const auto& s) { return s.stress.xx; })};
  };
  const auto [slowest, stress] = middles(natural);
  const auto [slowest_numbered, stress_numbered] = middles(numbered);
  CHECK(slowest_numbered == numbered.element[slowest]);
  for (std::size_t e = 0; e < stress.size(); ++e) CHECK(stress_numbered[numbered.element[e]] == stress[e]);
}
