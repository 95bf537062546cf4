#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include <strike/element/hex8.hpp>
#include <strike/element/mass_scaled.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material.hpp>
#include <strike/section.hpp>
#include <strike/verify.hpp>

#include "conformance/element.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

constexpr Elastic law{.density = 2, .youngs_modulus = 8, .poissons_ratio = 0};  // c = 2

/// The critical step without damping, from the exact derivatives of the forces.
template <class E, class M>
double exact_step(const SingleElement<E, M>& element) {
  return 2 / element.vibration().frequencies().maxCoeff();
}

}  // namespace

TEST_CASE("mass scaling gives an element the step that is asked for, no less and no more") {
  testing::Shapes<8> shapes(41);
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, 8> x = shapes();
    const SingleElement bare{Hex8{}, law, x};
    const double own = bare.now().stable_step;
    for (const double ratio : {0.5, 1.5, 10.0}) {
      const SingleElement scaled{MassScaled{Hex8{}, ratio * own}, law, x};
      const double factor = std::max(1.0, ratio * ratio);
      CHECK(scaled.nodal_mass() == Approx(factor * bare.nodal_mass()).epsilon(1e-12));
      CHECK(scaled.now().stable_step == Approx(std::max(1.0, ratio) * own).epsilon(1e-12));
      CHECK(exact_step(scaled) == Approx(std::sqrt(factor) * exact_step(bare)).epsilon(1e-6));  // of dual numbers
      CHECK(scaled.now().stable_step <= exact_step(scaled));
    }
  }
}

TEST_CASE("mass scaling of a plate scales its moment of inertia alike") {
  Nodal<double, 4> x;
  x << 0, 1, 1.2, 0, 0, 0, 0.9, 1, 0, 0, 0, 0;
  const Homogeneous section{
      PlaneStress{Solid{LinearEos{.density = 2, .bulk_modulus = 8}, VonMises{.shear_modulus = 3, .yield_stress = 1}}},
      0.1};
  const SingleElement bare{Plate4{}, section, x};
  const SingleElement scaled{MassScaled{Plate4{}, 3 * bare.now().stable_step}, section, x};
  CHECK(scaled.nodal_mass() == Approx(9 * bare.nodal_mass()).epsilon(1e-12));
  CHECK(scaled.nodal_inertia() == Approx(9 * bare.nodal_inertia()).epsilon(1e-12));
  CHECK(scaled.now().stable_step == Approx(3 * bare.now().stable_step).epsilon(1e-12));
}

// A checkpoint and a deletion of plates of Plies, whose states hold lists, visit what the wrapper adds too.
TEST_CASE("a scaled plate of plies: its numbers are those of the plate and the factor of its mass") {
  const Layered section{Plies{Layer{PlaneStress{law}, 1.0}, 2}};
  using Plate = MassScaled<Plate4<>>;
  using State = Plate::State<std::remove_const_t<decltype(section)>, double>;
  State own, other;
  section.begin(own.material), section.begin(other.material);
  other.mass_factor = 3, other.inverse_area = 5, other.material.shear = {7, 11};
  visit_numbers<double>(own, other, [](auto to, auto from) { std::copy(from.begin(), from.end(), to.begin()); });
  CHECK(own.mass_factor == 3);
  CHECK(own.inverse_area == 5);
  CHECK(own.material.shear == other.material.shear);
}
