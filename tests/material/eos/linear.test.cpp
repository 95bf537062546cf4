#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/linear.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;

static_assert(EquationOfState<LinearEos> && !ThermalEquationOfState<LinearEos>);

namespace {
constexpr LinearEos copper{.density = 8930, .bulk_modulus = 130e9};
struct {
} nothing;
}  // namespace

TEST_CASE("linear EOS: p = K mu, K (1 + mu) against its change") {
  for (const double J : {0.5, 0.9, 1.0, 1.1, 2.0}) {
    const double p = advance_pressure(copper, nothing, J, 0.0, 0.0, 0.0);
    CHECK(p == Approx(130e9 * (1 / J - 1)).epsilon(1e-15));
    const double K = bulk_modulus(copper, nothing, J, p);
    CHECK(K == Approx(130e9 / J).epsilon(1e-15));
    CHECK(K == Approx(testing::isentropic_bulk_modulus(copper, J, 0)).epsilon(1e-8));
  }
}

TEST_CASE("linear EOS: shock speed c sqrt(1 + mu)") {
  // p = rho0 c^2 mu = rho0 U v and mu/(1 + mu) = v/U give U^2 = c^2 (1 + mu), v^2 (1 + mu) = c^2 mu^2
  for (const double v : {1.0, 100.0, 1000.0}) {
    const auto s = testing::shock(copper, v);
    CHECK(s.speed == Approx(std::sqrt(130e9 / 8930 * (1 + s.mu))).epsilon(1e-12));
    CHECK(130e9 / 8930 * s.mu * s.mu == Approx(v * v * (1 + s.mu)).epsilon(1e-12));
  }
}
