#pragma once
// Jets of particles on a rigid wall at z = 0, and the pressure that they give it. mm, ms, kg; so kN, GPa and J.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/particle.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/fluid.hpp>
#include <strike/mesh/bird.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::particle_jet {

/// The water of birds, without tension.
inline constexpr CubicEos water{.density = 0.95e-6, .C1 = 2.06, .C2 = 6.19, .C3 = 10.3, .pressure_cutoff = 0};

/// The pressure that brings a jet to rest, of the integral of dp/rho = v^2/2 [stress].
inline double stagnation_pressure(double speed) {
  constexpr double step = 1e-6;
  double p = 0, mu = 0;
  for (double head = 0; head < 0.5 * speed * speed; mu += step) {
    const double next = water.A(mu + step);
    head += (next - p) / (water.density * (1 + mu + 0.5 * step));
    p = next;
  }
  return p;
}

/// The points (i + 1/2, j + 1/2, k + 1/2) a of a lattice that lie inside, with equal shares of the volume.
template <class Inside>
Mesh filled(const Eigen::Vector3i& first, const Eigen::Vector3i& last, double a, double volume, const Inside& inside) {
  Mesh mesh;
  for (int k = first.z(); k < last.z(); ++k)
    for (int j = first.y(); j < last.y(); ++j)
      for (int i = first.x(); i < last.x(); ++i)
        if (const Eigen::Vector3d x = a * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5); inside(x)) {
          mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())});
          mesh.nodes.push_back(x);
        }
  mesh.particles.volumes.assign(mesh.nodes.size(), volume / static_cast<double>(mesh.nodes.size()));
  return mesh;
}

/// A jet towards -z whose nose touches the wall: round, or plane, 1 wide along y.
struct Jet {
  double across;  ///< particles to the width
  double speed = 180;
  double aspect = 2;  ///< length over width
  bool is_plane = false, has_round_nose = false, is_quarter = true;
  double mass = 1.81436948;

  double width() const { return size_of({.mass = mass, .density = water.density}).diameter; }
  double length() const { return aspect * width(); }
  double spacing() const { return width() / across; }
  /// The share of the jet in the mesh: of one that is plane, half a slice of four particles.
  double share() const { return is_plane ? 0.5 : is_quarter ? 0.25 : 1; }
  double depth() const { return 4 * spacing(); }
  double area() const { return is_plane ? width() * depth() : std::numbers::pi / 4 * width() * width(); }
  double volume() const {
    const double R = width() / 2, nose = has_round_nose ? std::numbers::pi / 3 * R * R * R : 0;
    return area() * length() - nose;
  }
  bool contains(const Eigen::Vector3d& x) const {
    const double R = width() / 2, r = is_plane ? std::abs(x.x()) : std::hypot(x.x(), x.y());
    return r < R && x.z() < length() && (!has_round_nose || x.z() > R || std::hypot(r, R - x.z()) < R);
  }
  Mesh mesh() const {
    const int n = static_cast<int>(std::ceil(across / 2)) + 1, whole = is_quarter || is_plane ? 0 : -n,
              layers = static_cast<int>(std::ceil(across * aspect)) + 1;
    return filled({whole, whole, 0}, {n, is_plane ? 4 : n, layers}, spacing(), share() * volume(),
                  [&](const Eigen::Vector3d& x) { return contains(x); });
  }
  Mirrors mirrors() const {
    const Mirror x{{1, 0, 0}}, y{{0, 1, 0}};
    if (is_plane) return Mirrors{x, y, Mirror{{0, 1, 0}, {0, depth(), 0}}};
    return is_quarter ? Mirrors{x, y} : Mirrors{};
  }
};

/// The whole of a round jet on a lattice that is turned and shifted about its axis by chance.
inline Mesh by_chance(const Jet& jet, unsigned seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const Eigen::AngleAxisd turn(unit() * std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d shift = jet.spacing() * Eigen::Vector3d(unit(), unit(), 0);
  const int n = static_cast<int>(0.8 * jet.across) + 2, layers = static_cast<int>(std::lround(jet.across * jet.aspect));
  Mesh mesh = filled({-n, -n, 0}, {n, n, layers}, jet.spacing(), jet.volume(),
                     [&](const Eigen::Vector3d& x) { return jet.contains(turn * (x + shift)); });
  for (Eigen::Vector3d& x : mesh.nodes) x = turn * (x + shift);
  return mesh;
}

template <class... Policies>
auto on_wall(const Jet& jet, const Mesh& mesh, const Policies&... policies) {
  return Explicit{Scene{mesh.nodes, Part{Particle{Smoothing{}, jet.mirrors()}, Fluid{water}, mesh.particles},
                        InitialVelocity{{0, 0, -jet.speed}}, RigidWall{{0, 0, 0}, {0, 0, 1}}},
                  policies...};
}

/// The pressure of a wall at z = 0 on nodes, over the stagnation pressure: of its impulses, which are what changes the
/// momentum of the nodes beside their forces.
class Gauge {
 public:
  Gauge(const Jet& jet, double from, double to) : jet_(jet), from_(from), to_(to) {}

  template <class Run>
  void see(const Run& run) {
    const auto& nodes = run.nodes();
    const std::size_t n = nodes.size();
    const double tau = run.time() * jet_.speed / jet_.length(), reach = 0.3 * jet_.width();
    if (tau <= from_ || tau >= to_) return;
    if (!v_.empty()) {
      double centre = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double J = nodes.mass(i) * (nodes.v(i).z() - v_[i]) - 0.5 * (dt_ + run.dt()) * f_[i];
        const double r = jet_.is_plane ? std::abs(x_[i].x()) : std::hypot(x_[i].x(), x_[i].y());
        centre += std::max(0.0, 1 - r * r / (reach * reach)) * J;
        force_ += J;
        if (const auto ring = static_cast<std::size_t>(10 * r / jet_.width()); ring < rings_.size()) rings_[ring] += J;
      }
      time_ += run.dt();
      centre_ += centre;
      if (const auto bin = static_cast<std::size_t>(50 * tau); bin >= signal_.size())
        signal_.resize(bin + 1), times_.resize(bin + 1);
      signal_.back() += centre, times_.back() += run.dt();
    }
    x_.resize(n), v_.resize(n), f_.resize(n);
    for (std::size_t i = 0; i < n; ++i) x_[i] = nodes.x(i), v_[i] = nodes.v(i).z(), f_[i] = nodes.f(i).z();
    dt_ = run.dt();
  }

  /// Mean with the weight 1 - (r/.3D)^2.
  double centre() const { return centre_ / (time_ * weight()); }
  /// Means over every fiftieth of L/v.
  std::vector<double> signal() const {
    std::vector<double> means;
    for (std::size_t b = 0; b < signal_.size(); ++b)
      if (times_[b] > 0) means.push_back(signal_[b] / (times_[b] * weight()));
    return means;
  }
  /// Mean of a ring of .1 D.
  double ring(std::size_t k) const {
    const double D = jet_.width(), area = jet_.is_plane
                                              ? 0.2 * D * jet_.depth()
                                              : std::numbers::pi * 0.01 * D * D * (2 * static_cast<double>(k) + 1);
    return rings_[k] / (time_ * jet_.share() * area * stagnation_pressure(jet_.speed));
  }
  /// Force over rho A v^2.
  double force() const {
    return force_ / (time_ * jet_.share() * water.density * jet_.area() * jet_.speed * jet_.speed);
  }

 private:
  double weight() const {
    const double reach = 0.3 * jet_.width();
    const double area = jet_.is_plane ? 4.0 / 3 * reach * jet_.depth() : std::numbers::pi / 2 * reach * reach;
    return jet_.share() * area * stagnation_pressure(jet_.speed);
  }

  Jet jet_;
  double from_, to_;
  std::vector<Eigen::Vector3d> x_;
  std::vector<double> v_, f_;
  double dt_ = 0, time_ = 0, centre_ = 0, force_ = 0;
  std::array<double, 12> rings_{};
  std::vector<double> signal_, times_;
};

}  // namespace strike::particle_jet
