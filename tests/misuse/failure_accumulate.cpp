// expect: accumulate of a failure law is template <class T, class S> void accumulate
#include <strike/strike.hpp>

using namespace strike;

struct Brittle {
  double limit;
  template <class T>
  struct State {
    T intact{1.0}, damage{};
  };
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S&) const {
    return equivalent_stress >= limit;
  }
  template <class T, class S>
  void accumulate(S& state, const T& equivalent_stress, double dt) const {
    state.damage += dt * equivalent_stress;
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, ElasticStrength{.shear_modulus = 29e9},
                       Brittle{60e6}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
