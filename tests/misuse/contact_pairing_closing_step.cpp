// expect: write double closing_step(const ContactNodes& nodes, double moved, double dt)
#include <strike/strike.hpp>

using namespace strike;

struct OwnMeeting : detail::SurfaceMeeting<true> {
  explicit OwnMeeting(detail::SurfaceMeeting<true> meeting) : SurfaceMeeting(std::move(meeting)) {}
  double closing_step(double dt) const { return 0.5 * dt; }
};
struct Pair : SelfContact {
  OwnMeeting start(const ContactNodes& nodes) const { return OwnMeeting(SelfContact::start(nodes)); }
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, Contact{Pair{{Surface{surface(mesh)}}}}}};
  run.until(1e-3, [&] { return run.item<1>().force().norm(); });
}
