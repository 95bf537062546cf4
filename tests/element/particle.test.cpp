#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>

#include <strike/element/particle.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/fluid.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr CubicEos water{.density = 1, .C1 = 2.2, .C2 = 9.5, .C3 = 14.6};

/// Particles of unit spacing, unit density and if not told otherwise unit volumes, and what an element of them
/// computes.
template <class M>
struct Cloud {
  M material;
  std::vector<Eigen::Vector3d> x;
  Particle<> element{};
  std::vector<double> volume = std::vector<double>(x.size(), 1.0);

  detail::Wendland kernel() const { return {element.smoothing.length}; }
  ParticleSums<double> sums(std::size_t i, const std::vector<Eigen::Vector3d>& v) const {
    ParticleSums<double> sums;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Eigen::Vector3d d = x[j] - x[i];
      sums.add(d, volume[j] * kernel().slope(d.norm()), v[j] - v[i]);
    }
    sums *= kernel().factor();
    return sums;
  }
  using State = typename Particle<>::template State<M, double>;
  State at_rest(std::size_t i, double J) const {
    State state;
    Nodal<double, 1> at;
    set_column(at, 0, x[i]);
    element.begin(state, material, at, volume[i]);
    state.relative_volume = J;
    return state;
  }
  /// Forces on the particles, by the answers of all.
  std::vector<Eigen::Vector3d> forces(const std::vector<Eigen::Vector3d>& v, const std::vector<State>& states,
                                      const std::vector<ParticleAnswer<double>>& answers, double dt) const {
    std::vector<Eigen::Vector3d> f(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      ParticleForces<double> sums;
      for (std::size_t j = 0; j < x.size(); ++j) {
        const Eigen::Vector3d d = x[j] - x[i];
        sums.add(d, d.squaredNorm(), volume[j] * kernel().slope(d.norm()), v[j] - v[i],
                 1 / states[j].relative_volume - 1 / states[i].relative_volume, answers[i], answers[j]);
      }
      sums *= kernel().factor();
      State state = states[i];
      double work = 0;
      f[i] = -column(element.force(state, material, sums, answers[i], kernel(), volume[i], v[i], dt, work), 0);
    }
    return f;
  }
};

std::vector<Eigen::Vector3d> lattice(int nx, int ny, int nz, double noise, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-noise, noise);
  std::vector<Eigen::Vector3d> x;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        x.push_back(Eigen::Vector3d(i, j, k) + Eigen::Vector3d(unit(random), unit(random), unit(random)));
  return x;
}

/// The largest eigenvalue of (K dt^2/4 + C dt/2)/m at the claimed dt, which is stable below 1: stiffness and damping by
/// all particles, with no part of the hourglass viscosity taken off as linear. By power iteration from noise.
template <class M>
double claimed_over_exact(const Cloud<M>& cloud, double J) {
  const std::size_t n = cloud.x.size();
  const std::vector<Eigen::Vector3d> none(n, Eigen::Vector3d::Zero());
  double dt = 1e30;
  std::vector<Matrix3<double>> inverse(n);
  std::vector<double> impedance(n);
  double wave = 0, shear = 0;
  for (std::size_t i = 0; i < n; ++i) {
    auto state = cloud.at_rest(i, J);
    const ParticleStep<double> step =
        cloud.element.advance(state, cloud.material, cloud.sums(i, none), cloud.kernel(), 0.0, cloud.volume[i]);
    dt = std::min(dt, 1 / step.response.critical_rate);
    impedance[i] = step.answer.impedance;
    // The inverse of the moment, from the rate that the answer tells of a unit motion.
    for (int c = 0; c < 3; ++c) {
      ParticleSums<double> sums = cloud.sums(i, none);
      sums.velocity.setZero();
      for (int r = 0; r < 3; ++r) {
        sums.velocity.setZero();
        sums.velocity(r, c) = 1;
        auto copy = cloud.at_rest(i, J);
        const auto D =
            cloud.element.advance(copy, cloud.material, sums, cloud.kernel(), 0.0, cloud.volume[i]).answer.half_rate;
        const double on[] = {D.xx, D.yy, D.zz};
        inverse[i](c, r) = 2 * on[r];
      }
    }
    SolidKinematics::Rate<double> rate;
    rate.relative_volume = J;
    const auto moduli = cloud.material.moduli(state.material, rate);
    wave = moduli.wave(), shear = moduli.shear;
  }
  const double lambda = wave - 2 * shear, h = cloud.element.smoothing.length;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> u(n);
  for (auto& a : u) a = {normal(random), normal(random), normal(random)};
  std::vector<std::vector<std::pair<std::size_t, double>>> near(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (const double g = cloud.kernel().slope((cloud.x[j] - cloud.x[i]).norm()); g > 0 && i != j)
        near[i].push_back({j, cloud.kernel().factor() * g});
  double mu = 0;
  for (int k = 0; k < 150; ++k) {
    std::vector<Eigen::Vector3d> f(n, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      for (const auto& [j, g] : near[i])
        H += (u[j] - u[i]) * (cloud.volume[j] * g * (cloud.x[j] - cloud.x[i])).transpose();
      const Eigen::Matrix3d L = H * inverse[i], e = 0.5 * (L + L.transpose());
      const Eigen::Matrix3d s = J * (lambda * e.trace() * Eigen::Matrix3d::Identity() + 2 * shear * e) * inverse[i];
      for (const auto& [j, g] : near[i]) {
        const Eigen::Vector3d d = cloud.x[j] - cloud.x[i], F = dt * dt / 4 * (s * (g * d));
        f[i] -= cloud.volume[j] * F, f[j] += cloud.volume[i] * F;
        const double c = 0.25 * cloud.element.smoothing.hourglass * h * g * (impedance[i] + impedance[j]) /
                         d.squaredNorm() * d.dot(u[j] - u[i]);
        f[i] -= cloud.volume[j] * dt / 2 * c * d, f[j] += cloud.volume[i] * dt / 2 * c * d;
      }
    }
    double square = 0;
    for (const auto& a : f) square += a.squaredNorm();
    mu = std::sqrt(square);
    for (std::size_t i = 0; i < n; ++i) u[i] = f[i] / mu;
  }
  return mu;
}

}  // namespace

TEST_CASE("particle: its step is never beyond the exact one, in the mass, at faces, in sheets, lines and small groups",
          "[particle]") {
  const auto spread = [](std::vector<Eigen::Vector3d> x, double factor) {
    for (Eigen::Vector3d& a : x) a *= factor;
    return x;
  };
  const auto check = [](const std::vector<Eigen::Vector3d>& x, double J = 1, Smoothing smoothing = {}) {
    const Particle<> particle{smoothing};
    const double of_water = claimed_over_exact(Cloud<Fluid<CubicEos>>{Fluid{water}, x, particle}, J);
    CHECK(of_water < 1);
    CHECK(of_water > 0.04);
    CHECK(claimed_over_exact(Cloud<Elastic>{Elastic{1, 1, 0.0}, x, particle}, J) < 1);
  };
  check(lattice(6, 6, 6, 0));
  check(lattice(6, 6, 6, 0.5));
  check(spread(lattice(6, 6, 6, 0), 0.9), 0.729);
  check(spread(lattice(6, 6, 6, 0), 1.2));
  check(lattice(8, 8, 2, 0)), check(lattice(8, 8, 1, 0)), check(lattice(20, 1, 1, 0)), check(lattice(2, 1, 1, 0));
  for (unsigned seed = 0; seed < 20; ++seed) check(lattice(2, 2, 2, 0.1, seed));
  check(lattice(6, 6, 6, 0), 1, {.length = 1.2, .hourglass = 10});
  check(lattice(6, 6, 6, 0.3), 1, {.length = 1.6, .hourglass = 0});
}

TEST_CASE("particle: nor of what some cells leave at their corners, which fill but shares, with and without viscosity",
          "[particle]") {
  const Elastic solid{1, 1, 0.0};
  const auto check = [&](const std::vector<Eigen::Vector3d>& x, const std::vector<double>& shares) {
    for (const double linear : {0.0, 0.06, 0.15, 0.3, 0.5}) {
      const Particle<> particle{Smoothing{}, Mirrors{}, HughesWinget{}, BulkViscosity{.linear = linear}};
      CHECK(claimed_over_exact(Cloud<Fluid<CubicEos>>{Fluid{water}, x, particle, shares}, 1) < 1);
      CHECK(claimed_over_exact(Cloud<Elastic>{solid, x, particle, shares}, 1) < 1);
    }
  };
  // A cube, one that is flat or long, a slab and a bar of cubes; and cubes here and there.
  for (const double width : {0.5, 1.0, 1.5}) {
    std::vector<Eigen::Vector3d> x = lattice(2, 2, 2, 0.05);
    for (Eigen::Vector3d& a : x) a.x() *= width;
    check(x, std::vector<double>(8, 0.125));
  }
  const auto cells = [&](int nx, int ny, int nz, double probability, double noise) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit;
    const std::vector<Eigen::Vector3d> all = lattice(nx, ny, nz, noise);
    std::vector<double> volume(all.size(), 0.0), shares;
    for (int k = 0; k + 1 < nz; ++k)
      for (int j = 0; j + 1 < ny; ++j)
        for (int i = 0; i + 1 < nx; ++i)
          if (unit(random) < probability)
            for (int c = 0; c < 8; ++c)
              volume[static_cast<std::size_t>(i + (c & 1) + nx * (j + (c >> 1 & 1) + ny * (k + (c >> 2))))] += 0.125;
    std::vector<Eigen::Vector3d> x;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (volume[i] > 0) x.push_back(all[i]), shares.push_back(volume[i]);
    check(x, shares);
  };
  cells(4, 4, 2, 1, 0), cells(6, 2, 2, 1, 0), cells(4, 4, 4, 1, 0);
  cells(5, 5, 5, 0.3, 0.15), cells(5, 5, 5, 0.6, 0.15);
}

TEST_CASE("particle: its forces sum to zero with their moments, and are dual to its rates", "[particle]") {
  const auto x = lattice(5, 4, 3, 0.3);
  const Cloud<Elastic> cloud{Elastic{1, 1, 0.3}, x, Particle<>{Smoothing{.hourglass = 0}}};
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> v(x.size());
  for (auto& a : v) a = {normal(random), normal(random), normal(random)};
  std::vector<Cloud<Elastic>::State> states;
  std::vector<ParticleAnswer<double>> answers;
  double power = 0;
  const double dt = 1e-8;  // J stays 1
  for (std::size_t i = 0; i < x.size(); ++i) {
    states.push_back(cloud.at_rest(i, 1));
    states[i].material.stress = {normal(random), normal(random), normal(random),
                                 normal(random), normal(random), normal(random)};
    const auto step = cloud.element.advance(states[i], cloud.material, cloud.sums(i, v), cloud.kernel(), dt);
    power += step.end_work * 2 / dt;
    answers.push_back(step.answer);
  }
  const auto f = cloud.forces(v, states, answers, dt);
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  double size = 0, given = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    force += f[i], moment += x[i].cross(f[i]), size += f[i].norm(), given -= f[i].dot(v[i]);
  CHECK(force.norm() < 1e-13 * size);
  CHECK(moment.norm() < 1e-12 * size);
  CHECK(given == Approx(power).epsilon(1e-6));  // the rate is that of the middle of the step
}

TEST_CASE("particle: the viscosity against hourglass modes does no work on a linear field and takes energy from others",
          "[particle]") {
  const auto x = lattice(5, 4, 3, 0.3);
  const Cloud<Elastic> cloud{Elastic{1, 1, 0.3}, x};
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  Eigen::Matrix3d L;
  for (double& a : L.reshaped()) a = normal(random);
  for (const bool linear : {true, false}) {
    std::vector<Eigen::Vector3d> v;
    for (const auto& a : x) v.push_back(L * a + (linear ? 0 : 1) * Eigen::Vector3d(normal(random), 0, normal(random)));
    std::vector<Cloud<Elastic>::State> states;
    std::vector<ParticleAnswer<double>> answers;
    for (std::size_t i = 0; i < x.size(); ++i) {
      states.push_back(cloud.at_rest(i, 1));
      auto step = cloud.element.advance(states[i], cloud.material, cloud.sums(i, v), cloud.kernel(), 0.0);
      step.answer.stress.setZero();  // bulk viscosity apart
      answers.push_back(step.answer);
    }
    const auto f = cloud.forces(v, states, answers, 0);
    double power = 0, size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) power += f[i].dot(v[i]), size += f[i].norm() * v[i].norm();
    if (linear)
      CHECK(size < 1e-12);
    else
      CHECK(power < -0.1 * size);
  }
}
