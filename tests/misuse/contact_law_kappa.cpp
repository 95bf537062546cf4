// expect: the kappa of this normal law does not fit
#include <strike/strike.hpp>

using namespace strike;

struct Bounce {
  double press(std::vector<ContactPair>&, ContactNodes&, const Step&) const { return 0; }
  double kappa(const ContactPair& pair) const { return 1e9 * pair.inverse_effective_mass; }
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{
      Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, Contact{SelfContact{Surface{surface(mesh)}}, Bounce{}}}};
  run.until(1e-3, [&] { return run.item<1>().force().norm(); });
}
