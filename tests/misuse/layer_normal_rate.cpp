// expect: the material of a Layer needs normal_rate(state, rate, dt, change)
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

struct Membrane : PlaneStress<Elastic> {
  void normal_rate() = delete;
};

int main() { const Layered section{Layer{Membrane{{steel}}, 3.0}}; }
