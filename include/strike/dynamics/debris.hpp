#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/erosion.hpp>
#include <strike/element/element.hpp>
#include <strike/element/solid_point.hpp>
#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Particles that the eroding elements of another part become, at their nodes: they take over the volume and the state
/// that these elements leave there, and are absent before. Nodes keep their masses and velocities, so that momentum,
/// angular momentum and kinetic energy do not change; the energy that an element held goes over with it. A cube of
/// eight particles has the forces of the hexahedron of a solid that it was.
///   const Particles debris = particles_at_nodes(mesh.nodes, mesh.hexahedra);
///   Scene{mesh.nodes, Part{Hex8{}, bird, mesh.hexahedra, Erosion{.strain = 2}},
///                     Part{Particle{}, bird, debris, Debris{.of = 0}}}
/// With the material of its source debris goes on from its state; with another, such as the fluid that a broken pane
/// becomes, from its volume, and from its internal energy, temperature and plastic strain where both know them.
struct Debris {
  std::size_t of = 0;  ///< the part that erodes, counted from 0; it stands before its debris
  Erosion erosion{};   ///< by which the particles are deleted in their turn; their least volume is a share of V0

  void ranges(const auto& number) const {
    number("of", of, range::between(0, 1000));
    number(erosion);
  }

  auto keeps(const auto& state, const auto& particle) const { return erosion.keeps(state, particle); }
};

namespace detail {

/// The elements of a part are absent until those of another have been deleted.
template <class Removal>
inline constexpr bool is_born = std::same_as<Removal, Debris>;

/// The share of the volume of particles that they have taken over in this step.
template <class T>
struct Birth {
  T fresh{};
};
struct NoBirth {};

/// The particle of debris at each node, and which elements of its source have gone over.
class Births {
 public:
  template <class Elements, class Nodes>
  void begin(const Elements& debris, const Nodes& nodes) {
    particle_at_.assign(nodes.size(), none);
    for (std::size_t p = 0; p < debris.size; ++p) particle_at_[debris.cell(nodes, p)[0]] = p;
  }

  /// Prepares to take the elements of a source, and returns the spacing of its nodes. Errors: it has plates, or
  /// elements that are never deleted; one of its nodes is no particle.
  template <class Elements, class Source, class Nodes>
  [[gnu::cold]] double follow(const Elements& debris, const Source& source, const Nodes& nodes) {
    const std::string part = std::to_string(debris.number), of = std::to_string(source.number());
    if constexpr (!has_volume<Source>)
      throw Error(joined({"strike: part ", part, " is Debris of part ", of,
                          ", which has neither hexahedra nor tetrahedra; only these become particles."}));
    if constexpr (!Source::erodes)
      throw Error(joined({"strike: part ", part, " is Debris of part ", of,
                          ", whose elements are never deleted; give that part an Erosion."}));
    taken_.assign(source.size(), false);
    double largest = 0;
    if constexpr (has_volume<Source>)
      for (const auto& cell : source.cells(nodes)) {
        std::array<Eigen::Vector3d, Source::n> x;
        for (std::size_t i = 0; i < Source::n; ++i) {
          x[i] = nodes.x(cell[i]).template cast<double>();
          if (particle_at_[cell[i]] == none)
            throw Error(joined({"strike: node ", std::to_string(cell[i]), " of part ", of, " is no particle of part ",
                                part, ", its Debris; make these by particles_at_nodes of the same cells."}));
        }
        // Within a mesh there are as many nodes as hexahedra, and a fifth to a sixth as many as tetrahedra; half as
        // many as wedges, and a third as many as pyramids.
        const std::size_t corners = count_different(cell);
        largest = std::max(largest, (corners == 8 ? 1 : corners == 6 ? 2 : corners == 5 ? 3 : 6) * volume(x));
      }
    return std::cbrt(largest);
  }

  /// Gives the particles the elements that have been deleted since the last call, at the end of the step dt, and books
  /// the energy that they held.
  template <class Elements, class Source, class Nodes>
  void take([[maybe_unused]] Elements& debris, [[maybe_unused]] const Source& source,
            [[maybe_unused]] const Nodes& nodes, [[maybe_unused]] double dt, [[maybe_unused]] Ledger& ledger) {
    if constexpr (Source::erodes && has_volume<Source>) {
      if (source.deleted() == count_) return;
      double energy = 0;
      for (std::size_t place = 0; place < source.size(); ++place) {
        const auto& block = source.blocks()[place / Source::width];
        const std::size_t l = place % Source::width;
        if (taken_[place] || lane(block.removal.alive, l) > 0) continue;
        taken_[place] = true, ++count_;
        energy += static_cast<double>(lane(block.removal.energy, l));
        take(debris, source, block, l, nodes, dt);
      }
      ledger.internal.book(energy), ledger.eroded.book(-energy);
    }
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(taken_, count_);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr double least_relative_volume = 0.05;
  template <class Source>
  static constexpr bool has_volume =
      std::same_as<typename Source::Element::Kinematics, SolidKinematics> && (Source::n == 8 || Source::n == 4);

  template <std::size_t n>
  static double volume(const std::array<Eigen::Vector3d, n>& x) {
    std::array<Index, n> corners;
    std::iota(corners.begin(), corners.end(), Index(0));
    return solid_volume(x, corners);
  }

  /// Of lane l of a block. The state is that before the step in which the element was deleted, and so is the volume.
  template <class Elements, class Source, class Nodes>
  void take(Elements& debris, const Source& source, const typename Source::Block& block, std::size_t l,
            const Nodes& nodes, double dt) const {
    constexpr std::size_t n = Source::n;
    using Number = RealOf<typename Source::Number>;
    std::array<std::size_t, n> particle;
    std::array<Index, n> cell;
    std::array<Eigen::Vector3d, n> x;
    for (std::size_t i = 0; i < n; ++i) {
      const Index node = cell[i] = nodes.number(block.nodes[i][l]);
      particle[i] = particle_at_[node];
      x[i] = nodes.x(node).template cast<double>() - dt * nodes.v(node).template cast<double>();
    }
    const double ratio = density_of(source.material()) / density_of(debris.material),
                 V0 = ratio * static_cast<double>(lane(block.removal.initial_volume, l));
    const double J = std::max(volume(x) / V0, least_relative_volume),
                 energy = static_cast<double>(lane(block.removal.energy, l));
    double points = 0;
    block.state.each_point([&](const auto&) { points += 1; });
    const std::array<double, n> shares = corner_shares(cell);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p = particle[i];
      auto& to = debris.blocks[p / Elements::width];
      const std::size_t k = p % Elements::width;
      auto& state = to.state;
      if (!(lane(to.removal.alive, k) > 0)) {
        set_lane(to.removal.alive, k, Number(1)), set_lane(to.removal.energy, k, Number(0));
        set_lane(state.reference_volume, k, Number(0)), set_lane(to.birth.fresh, k, Number(0));
      }
      set_lane(to.removal.energy, k, lane(to.removal.energy, k) + static_cast<Number>(shares[i] * energy / n));
      block.state.each_point([&](const auto& point) {
        const double before = static_cast<double>(lane(state.reference_volume, k)),
                     more = shares[i] * V0 / (n * points), share = more / (before + more);
        const auto mix = [&](auto& number, double value) {
          const auto old = static_cast<double>(lane(number, k));
          set_lane(number, k, static_cast<Number>(share < 1 ? old + share * (value - old) : value));
        };
        mix(state.relative_volume, J), mix(state.diffusion, 0), mix(to.birth.fresh, 1);
        mix_in<typename Source::Number>(debris.material, x[i], state.material, k, point, l, ratio, share);
        set_lane(state.reference_volume, k, static_cast<Number>(before + more));
      });
      to.removal.initial_volume = state.reference_volume;
    }
  }

  template <class T, class M, class State, class Point>
  static void mix_in(const M& material, const Eigen::Vector3d& x, State& state, std::size_t k, const Point& point,
                     std::size_t l, double ratio, double share) {
    if constexpr (std::same_as<State, Point>) {
      mix_lanes<T>(state, k, point, l, share);
    } else {
      State other{};
      begin_point(material, other, Nodal<T, 1>(x.cast<T>()));
      if constexpr (requires { other.internal_energy, point.internal_energy; })
        other.internal_energy = T(1 / ratio) * point.internal_energy;
      if constexpr (requires { other.temperature_rise, point.temperature_rise; })
        other.temperature_rise = point.temperature_rise;
      if constexpr (requires { other.equivalent_plastic_strain, point.equivalent_plastic_strain; })
        other.equivalent_plastic_strain = point.equivalent_plastic_strain;
      mix_lanes<T>(state, k, other, l, share);
    }
  }
  /// Lane l of the state of a point becomes a share of lane k of that of a particle.
  template <class T, class State, class Point>
  static void mix_lanes(State& state, std::size_t k, const Point& point, std::size_t l, double share) {
    visit_numbers<T>(state, point, [&](auto kept, auto more) {
      for (std::size_t i = 0; i < kept.size(); ++i) {
        const auto old = lane(kept[i], k), value = lane(more[i], l);
        set_lane(kept[i], k, share < 1 && value != old ? old + static_cast<RealOf<T>>(share) * (value - old) : value);
      }
    });
  }

  std::vector<std::size_t> particle_at_;  // by the number of the node
  std::vector<char> taken_;               // of the elements of the source as they lie in memory
  std::size_t count_ = 0;
};

struct NoBirths {
  void serialize(auto&) {}
};

}  // namespace detail

}  // namespace strike
