// One formula on every number: the same element step on a double, on the lanes of a Pack, and on a Dual that
// differentiates it.
//
//   bash examples/run same_formula
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                  VonMises{.shear_modulus = 80e9, .yield_stress = 400e6, .hardening_modulus = 1e9}};
const Hex8 brick;

/// The axial force with which a unit cube resists when its top moves up at `speed` for a microsecond [N].
template <Scalar T>
T axial_force(const T& speed) {
  constexpr double dt = 1e-6;
  Nodal<T, 8> X = Nodal<T, 8>::Zero(), v = Nodal<T, 8>::Zero();
  for (const int i : {1, 2, 5, 6}) X(0, i) = T(1.0);
  for (const int i : {2, 3, 6, 7}) X(1, i) = T(1.0);
  for (const int i : {4, 5, 6, 7}) X(2, i) = T(1.0), v(2, i) = speed;

  Hex8<>::State<std::remove_const_t<decltype(steel)>, T> state;
  brick.begin(state, steel, X);
  Nodal<T, 8> x = X;
  for (int i = 0; i < 8; ++i) x(2, i) += dt * v(2, i);
  const auto response = brick.advance(state, steel, x, v, dt);
  return response.force(2, 4) + response.force(2, 5) + response.force(2, 6) + response.force(2, 7);
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    options.check();

    std::puts("A number:");
    std::printf("  100 m/s      %14.6e N\n\n", axial_force(100.0));

    std::puts("Eight numbers at once, of which those above 2500 m/s yield:");
    const auto speeds = Pack<double, 8>::generate([](std::size_t i) { return 1000.0 * static_cast<double>(i); });
    const auto forces = axial_force(speeds);
    double worst = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const double alone = axial_force(speeds[i]);
      std::printf("  %4.0f m/s     %14.6e N, alone %14.6e N\n", speeds[i], forces[i], alone);
      worst = std::max(worst, std::abs(forces[i] - alone) / 1e9);
    }

    std::puts("\nA number with its derivative, the tangent of the step:");
    const Dual<double, 1> force = axial_force(Dual<double, 1>::variable(100.0, 0));
    const double h = 1e-3, quotient = (axial_force(100.0 + h) - axial_force(100.0 - h)) / (2 * h);
    std::printf("  100 m/s      %14.6e N, d force/d speed %14.6e, by differences %14.6e N s/m\n", force.value(),
                force.derivative(0), quotient);

    Results results;
    results.add({"eight forces together from each alone", worst, "GN", 0, 1e-15, "the same formula on double"});
    results.add({"d force/d speed", force.derivative(0), "N s/m", quotient, 1e-6 * std::abs(quotient), "differences"});
    results.write("results.csv");
  });
}
