#pragma once
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/particle.hpp>
#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/particles.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/triangulated.hpp>
#include <strike/section/layered.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"
#include "../support/stretched_sheet.hpp"

namespace prices {

using namespace strike;

/// A run on its way.
struct Trial {
  std::function<void()> step;
  double bytes;  ///< of an element: what its block stores, its nodes' numbers included
};

/// Steps are timed by the processor, which others on the machine do not disturb, or by the clock on the wall, where
/// threads work side by side.
enum class TimedBy { processor, wall };

/// A choice that differs from the usual in one thing.
struct Feature {
  std::string name;
  std::function<Trial()> start;
  int steps = 8;  ///< in each turn
  TimedBy timed_by = TimedBy::processor;
};

struct Group {
  std::string title;
  std::vector<Feature> features;
};

/// A run of a scene, shared by the functions that a Trial consists of.
template <class Scene, class... Policies>
auto started(const Scene& scene, const ExplicitOptions& options = {}, const Policies&... policies) {
  using Run = decltype(Explicit{scene, options, policies...});
  return std::make_shared<Run>(scene, options, policies...);
}

/// What one element of a run stores.
template <class Run>
double bytes(const Run& run) {
  using Part = std::decay_t<decltype(run.template part<0>())>;
  return static_cast<double>(sizeof(typename Part::Block)) / static_cast<double>(Part::width);
}

/// A feature by all of its run.
template <class Start>
Feature feature(std::string name, Start start) {
  return {std::move(name), [start]() -> Trial {
            const auto run = start();
            return {[run] { run->step(); }, bytes(*run)};
          }};
}

/// What is usual, and features by what differs: the material, the element, what stands in the scene, or the policies.
template <class E, class M, class Connectivity, class Motion>
struct Usual {
  std::vector<Eigen::Vector3d> nodes;
  Connectivity cells;
  E element;
  M material;
  Motion motion;

  template <class Element, class Material, class... Things>
  auto scene(const Element& e, const Material& m, const Things&... things) const {
    return Scene{nodes, Part{e, m, cells}, things..., motion};
  }
  auto scene() const { return scene(element, material); }

  Feature itself(std::string name) const {
    return feature(std::move(name), [this] { return started(scene()); });
  }
  template <class Material>
  Feature of_material(std::string name, const Material& m) const {
    return feature(std::move(name), [=, this] { return started(scene(element, m)); });
  }
  template <class Element>
  Feature of_element(std::string name, const Element& e) const {
    return feature(std::move(name), [=, this] { return started(scene(e, material)); });
  }
  template <class... Things>
  Feature with(std::string name, const Things&... things) const {
    return feature(std::move(name), [=, this] { return started(scene(element, material, things...)); });
  }
  template <class... Policies>
  Feature by(std::string name, const Policies&... policies) const {
    return feature(std::move(name), [=, this] { return started(scene(), {}, policies...); });
  }
};
template <class E, class M, class Connectivity, class Motion>
Usual(std::vector<Eigen::Vector3d>, Connectivity, E, M, Motion) -> Usual<E, M, Connectivity, Motion>;

inline const Solid copper{bench::linear, bench::hardening};

/// 100,000 hexahedra, squeezed.
inline const Mesh bar = bench::bar({40, 50, 50});
inline const Usual hexahedra{bar.nodes, bar.hexahedra, Hex8{ViscousHourglass{}}, copper, bench::Squeeze{}};

/// 101,400 tetrahedra, squeezed.
inline const Mesh split_bar = tetrahedralized(bench::bar({25, 26, 26}));
inline const Usual tetrahedra{split_bar.nodes, split_bar.tetrahedra, Tet4{}, copper, bench::Squeeze{}};

/// 100,000 plates, stretched and bent.
inline const Mesh sheet = bench::sheet({400, 250});
inline const Usual plates{sheet.nodes, sheet.quadrilaterals, Plate4{},
                          Homogeneous{PlaneStress{copper}, bench::sheet_thickness}, bench::Stretch{}};

/// 100,000 triangles, stretched and bent.
inline const Mesh split_sheet = triangulated(bench::sheet({250, 200}));
inline const Usual triangles{split_sheet.nodes, split_sheet.triangles, Plate3{},
                             Homogeneous{PlaneStress{copper}, bench::sheet_thickness}, bench::Stretch{}};

/// 24,000 particles of water, squeezed.
inline const Mesh drop = particles(BoxShape{.size = {0.02, 0.03, 0.04}, .cells = {20, 30, 40}});
inline const Usual cloud{drop.nodes, drop.particles, Particle{}, bench::water, bench::Squeeze{}};

// The groups, some to a file: of hexahedra, ...
Group strengths();
Group failures();
Group equations_of_state();
Group elements();
Group numbers();
Group conditions();
Group outputs();
Group ledger();

// ... of tetrahedra, ...
Group tetrahedron_elements();

// ... of particles, ...
Group particle_choices();

// ... and of plates.
Group plate_sections();
Group plate_shears();
Group plate_materials();
Group plate_laminates();
Group plate_elements();
Group plate_numbers();
Group triangle_choices();

}  // namespace prices
