// A contact of your own, law, friction and rigid body: a pane that falls flat on a ring, slides and jumps.
//
//   bash examples/run own_contact
#include "own_contact.hpp"

#include <cstdio>
#include <vector>

#include <strike/strike.hpp>

#include "../support/options.hpp"

using namespace strike;

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    options.check();
    // Millimetres, milliseconds, kilograms; so kN, GPa and J.
    const Solid glass{LinearEos{.density = 2.5e-6, .bulk_modulus = 40},
                      VonMises{.shear_modulus = 29, .yield_stress = 1}};
    const double radius = 15, tube = 5, touching = tube + 1e-3;
    const std::vector<Eigen::Vector3d> corners{
        {radius, 0, touching}, {0, radius, touching}, {-radius, 0, touching}, {0, -radius, touching}};

    Explicit run{Scene{corners, Part{Plate4{}, Homogeneous{PlaneStress{glass}, 3.0}, Cells<4>{{0, 1, 2, 3}}},
                       InitialVelocity{{2, 0, -1}},
                       Contact{NodeToRigid{std::vector<Index>{0, 1, 2, 3}, RigidTorus{radius, tube}}, Restitution{0.7},
                               LimitedFriction{.coefficient = 0.3, .largest = 1}}}};
    run.until(0.01);

    const Eigen::Vector3d v = run.nodes().v(0);
    const Energy energy = run.energy();
    std::printf("jumps at               %.3f of 0.700 m/s\n", v.z());
    std::printf("slides at              %.3f of 2 - 0.3 (1 + 0.7) = 1.490 m/s\n", v.x());
    std::printf("taken by the law       %.1f %% of 5, by friction %.1f %%\n", 100 * energy.contact / energy.initial,
                100 * energy.friction / energy.initial);

    Results results;
    results.add({"speed of the jump", v.z(), "mm/ms", 0.7, 1e-3, "restitution"});
    results.add({"speed of sliding", v.x(), "mm/ms", 1.49, 1e-3, "Coulomb"});
    results.add({"energy error", energy.error(), "1", 0, 1e-9, "balance"});
    results.write("results.csv");
  });
}
