// expect: the material of a Layer needs normal_rate(state, rate, dt, change)
#include <strike/strike.hpp>

#include "../support/plane_elastic.hpp"

using namespace strike;

struct Membrane : testing::PlaneElastic {
  void normal_rate() = delete;
};

int main() { const Layered section{Layer{Membrane{{200e9, 0.3}}, 3.0}}; }
