// A clamped round plate under the blast of a charge above its middle, against the modes of a thin plate. The deck
// examples/deck/decks/blast_plate.k is this plate.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/air_blast.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/select.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

// 40 g of TNT 2 m above steel, 10 mm thick, of 1 m diameter.
constexpr double radius = 0.5, thickness = 0.01, E = 210e9, nu = 0.3, density = 7850, end = 0.01;
const Charge charge{.mass = 0.04, .centre = {0, 0, 2}};

/// How far the middle goes, when, and where it is at the end.
struct Swing {
  double largest = 0, time = 0, last = 0;
};

/// Kirchhoff's plate: w = sum of q_n(t) phi_n(r), phi = J0(kr) - J0(ka)/I0(ka) I0(kr) with J0 I1 + J1 I0 = 0 at ka
/// (Leissa 1969, NASA SP-160, eq. 2.2), q'' + omega^2 q = (p, phi)/(rho h (phi, phi)), omega = k^2 sqrt(D/(rho h)).
Swing modal(int modes) {
  const double D = E * thickness * thickness * thickness / (12 * (1 - nu * nu)), m = density * thickness;
  const auto J = [](int n, double x) { return std::cyl_bessel_j(n, x); };
  const auto I = [](int n, double x) { return std::cyl_bessel_i(n, x); };
  const auto condition = [&](double x) { return J(0, x) * I(1, x) + J(1, x) * I(0, x); };
  constexpr int rings = 200, times = 10000;
  std::vector<BlastWave> waves;
  std::vector<double> cosine, r;
  for (int i = 0; i < rings; ++i) {
    r.push_back((i + 0.5) / rings * radius);
    const double range = std::hypot(r.back(), charge.centre.z());
    waves.push_back(charge.wave(range)), cosine.push_back(charge.centre.z() / range);
  }
  const auto pressure = [&](std::size_t i, double t) {
    const BlastWave& wave = waves[i];
    const double s = (t - wave.arrival) / wave.duration, c = cosine[i];
    if (s < 0) return 0.0;
    return (1 - s) * (wave.reflected_pressure * std::exp(-wave.reflected_decay * s) * c * c +
                      wave.incident_pressure * std::exp(-wave.incident_decay * s) * (1 + c - 2 * c * c));
  };
  std::vector<double> w(times + 1, 0.0);
  double low = 1;
  for (int n = 0; n < modes; ++n) {
    double a = low + 1, b = a + 0.1;  // roots are about pi apart, the first at 3.196
    while (condition(a) * condition(b) > 0) a = b, b += 0.1;
    for (int i = 0; i < 60; ++i) (condition(a) * condition(0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
    low = a;
    const double k = a / radius, omega = k * k * std::sqrt(D / m), ratio = J(0, a) / I(0, a), dt = end / times;
    std::vector<double> weight;
    double norm = 0;
    for (const double at : r) {
      const double phi = J(0, k * at) - ratio * I(0, k * at);
      weight.push_back(at * phi), norm += at * phi * phi;
    }
    // Exact for a force that stays over a step, taken at its middle: the error is that of the pulse, in 1 us of 600.
    const double c = std::cos(omega * dt), s = std::sin(omega * dt);
    double q = 0, v = 0;
    for (int j = 0; j < times; ++j) {
      double force = 0;
      for (std::size_t i = 0; i < r.size(); ++i) force += weight[i] * pressure(i, (j + 0.5) * dt);
      const double rest = force / (m * norm) / (omega * omega), off = q - rest;
      q = rest + off * c + v / omega * s, v = v * c - off * omega * s;
      w[static_cast<std::size_t>(j) + 1] += q * (1 - ratio);
    }
  }
  const auto peak = std::max_element(w.begin(), w.end());
  return {*peak, end / times * static_cast<double>(peak - w.begin()), w.back()};
}

/// A quarter of the plate with n cells to an edge of a block.
Swing quarter(Index n) {
  const Mesh mesh = disc({.radius = radius, .cells = n, .sector = Sector::quarter});
  const std::vector<Index> rim =
      nodes_where(mesh.nodes, [](const Eigen::Vector3d& x) { return x.norm() > radius * (1 - 1e-9); });
  Explicit run{Scene{
      mesh.nodes,
      Part{Plate4{},
           Homogeneous{PlaneStress{Elastic{.density = density, .youngs_modulus = E, .poissons_ratio = nu}}, thickness},
           mesh.quadrilaterals},
      AirBlast{quadrilateral_surface(mesh.quadrilaterals), charge}, Clamped{rim},
      Symmetry{Axis::x, nodes_where(mesh.nodes, on_plane(Axis::x, 0))},
      Symmetry{Axis::y, nodes_where(mesh.nodes, on_plane(Axis::y, 0))}}};
  const Index middle = nearest_node(mesh.nodes, {0, 0, 0});
  Swing found;
  run.until(end, [&] {
    found.last = -run.nodes().x(middle).z();
    if (found.last > found.largest) found.largest = found.last, found.time = run.time();
  });
  CHECK(std::abs(run.energy().error()) < 1e-3);
  return found;
}

}  // namespace

TEST_CASE("blast on a clamped round plate: displacement of the middle and its time are those of the modes") {
  const Swing exact = modal(10);
  // The modes know neither shear, 16 D/(5/6 G h a^2) = 0.2 % of the displacement, nor the stretch, 0.47 (w/h)^2 = 0.3
  // %.
  REQUIRE(exact.largest < 0.085 * thickness);
  const Swing coarse = quarter(5), fine = quarter(10);  // the error of a mesh falls with n^2
  CHECK(coarse.largest == Approx(exact.largest).epsilon(0.02));
  CHECK(fine.largest == Approx(exact.largest).epsilon(0.005));
  CHECK(fine.time == Approx(exact.time).epsilon(0.01));  // where the peak is flat
  CHECK(fine.last == Approx(exact.last).epsilon(0.005));
  CHECK(modal(5).largest == Approx(exact.largest).epsilon(1e-3));
}
