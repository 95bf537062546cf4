// expect: write void see(std::span<const PartFaces> parts)
#include <strike/strike.hpp>

using namespace strike;

struct Pair : SelfContact {
  void see(const Mesh&) const {}
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, Contact{Pair{{Surface{surface(mesh)}}}}}};
  run.until(1e-3, [&] { return run.item<1>().force().norm(); });
}
