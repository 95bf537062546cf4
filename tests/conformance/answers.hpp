#pragma once
// Laws of a contact that need no reference, as one suite: what must leave the answer of a scene as it is.
//   TEST_CASE("conformance: my law") {
//     testing::answers_alike([](const Surface& one, const Surface& other) { return Contact{TwoWay{one, other},
//     MyLaw{}}; });
//   }
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/section.hpp>

#include "support/catch.hpp"

namespace strike::testing {

/// Any contact behind one type, so that one run is compiled for all.
class AnyContact {
  using N = Nodes<double, double, true>;

 public:
  template <class C>
  explicit AnyContact(C contact) : made_(std::make_unique<Model<C>>(std::move(contact))) {}
  AnyContact(const AnyContact& other) : made_(other.made_->copy()) {}

  void begin(const N& nodes, std::span<const PartFaces> parts) { made_->begin(nodes, parts); }
  double stable_step(double dt, const N& nodes) { return made_->stable_step(dt, nodes); }
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger) { made_->resolve_contact(nodes, step, ledger); }
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const OpenMP& execution) {
    made_->resolve_contact(nodes, step, ledger, execution);
  }
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const Serial&) {
    made_->resolve_contact(nodes, step, ledger);
  }
  void remove(std::size_t part, const std::vector<bool>& alive) { made_->remove(part, alive); }

 private:
  struct Base {
    virtual ~Base() = default;
    virtual std::unique_ptr<Base> copy() const = 0;
    virtual void begin(const N&, std::span<const PartFaces>) = 0;
    virtual double stable_step(double, const N&) = 0;
    virtual void resolve_contact(N&, const Step&, Ledger&) = 0;
    virtual void resolve_contact(N&, const Step&, Ledger&, const OpenMP&) = 0;
    virtual void remove(std::size_t, const std::vector<bool>&) = 0;
  };
  template <class C>
  struct Model final : Base {
    explicit Model(C made) : contact(std::move(made)) {}
    std::unique_ptr<Base> copy() const override { return std::make_unique<Model>(contact); }
    void begin(const N& nodes, std::span<const PartFaces> parts) override { contact.begin(nodes, parts); }
    double stable_step(double dt, const N& nodes) override { return contact.stable_step(dt, nodes); }
    void resolve_contact(N& nodes, const Step& step, Ledger& ledger) override {
      contact.resolve_contact(nodes, step, ledger);
    }
    void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const OpenMP& execution) override {
      contact.resolve_contact(nodes, step, ledger, execution);
    }
    void remove(std::size_t part, const std::vector<bool>& alive) override { contact.remove(part, alive); }

    C contact;
  };
  std::unique_ptr<Base> made_;
};

struct NoContact {
  void begin(const auto&, std::span<const PartFaces>) {}
  double stable_step(double dt, const auto&) { return dt; }
  void resolve_contact(auto&, const Step&, Ledger&) {}
  void resolve_contact(auto&, const Step&, Ledger&, const auto&) {}
  void remove(std::size_t, const std::vector<bool>&) {}
};

/// A removal law that deletes what has grown.
struct Grown {
  double most;
  template <class State, class Condition>
  auto keeps(const State&, const Condition& element) const {
    return element.relative_volume() < most;
  }
};

/// Two bodies, the first of which flies at the second, and far from both an element of each kind that grows.
struct Encounter {
  std::string name;
  Mesh mesh;
  std::vector<Eigen::Vector3d> velocity;
  std::size_t first_nodes = 0, nodes = 0;            ///< of the first body, which come first, and of both
  std::array<std::size_t, 3> first_cells{}, last{};  ///< hexahedra, tetrahedra and plates of the first, and of both
  double thickness = 0.1;                            ///< of plates [length]

  Encounter(std::string title, const Mesh& first, const Mesh& second, const Eigen::Vector3d& v)
      : name(std::move(title)), mesh(first), first_nodes(first.nodes.size()) {
    first_cells = counts();
    append(mesh, second);
    last = counts(), nodes = mesh.nodes.size();
    velocity.assign(mesh.nodes.size(), Eigen::Vector3d::Zero());
    std::fill(velocity.begin(), velocity.begin() + static_cast<std::ptrdiff_t>(first_nodes), v);
    const Mesh cube = box({.lower = {30, 0, 0}, .size = {2, 2, 2}});
    for (const Mesh& far : {cube, translated(tetrahedralized(cube), {9, 0, 0}),
                            rectangle({.lower = {50, 0, 0}, .size = {2, 2}, .cells = {1, 1}})}) {
      const Eigen::Vector3d middle =
          std::accumulate(far.nodes.begin(), far.nodes.end(), Eigen::Vector3d(Eigen::Vector3d::Zero())) /
          static_cast<double>(far.nodes.size());
      append(mesh, far);
      for (const Eigen::Vector3d& x : far.nodes) velocity.push_back(2 * (x - middle));
    }
  }
  std::array<std::size_t, 3> counts() const {
    return {mesh.hexahedra.size(), mesh.tetrahedra.size(), mesh.quadrilaterals.size()};
  }
};

/// A change of a scene, which is undone in its answer.
struct Change {
  std::string name;
  double tolerance = 0;  ///< of the answer, in sizes of a body, 1
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), moved = Eigen::Vector3d::Zero(), aside = Eigen::Vector3d::Zero();
  double length = 1, mass = 1;  ///< units
  unsigned seed = 0;            ///< of new numbers of nodes and cells
  bool flips = false, swaps = false, ends_only = false, far_goes = false;
  double step = 2e-3;  ///< [time]
  int threads = 0;
  double until = 0.2507;
};

/// The positions of the nodes of both bodies after a while, in their numbers and as before the change.
template <class Make>
std::vector<Eigen::Vector3d> answer(Encounter scene, const Make& make, const Change& change) {
  const std::size_t count = scene.mesh.nodes.size();
  const double angle = change.turn.norm();
  const Eigen::Matrix3d Q =
      angle > 0 ? Eigen::AngleAxisd(angle, change.turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d& x = scene.mesh.nodes[i];
    if (i < scene.first_nodes) x += change.aside;
    x = change.length * (Q * x + change.moved);
    scene.velocity[i] = Q * scene.velocity[i];
  }
  std::mt19937 random(change.seed);
  if (change.flips)
    for (auto& cell : scene.mesh.quadrilaterals)
      if (random() % 2 == 0) cell = {cell[0], cell[3], cell[2], cell[1]};

  // In new numbers node i is number[i]; cells are shuffled within their body.
  std::vector<Index> number(count);
  std::iota(number.begin(), number.end(), Index{0});
  std::vector<std::vector<Index>> order;
  if (change.seed > 0) std::shuffle(number.begin(), number.end(), random);
  std::vector<Eigen::Vector3d> nodes(count), velocity(count);
  for (std::size_t i = 0; i < count; ++i)
    nodes[number[i]] = scene.mesh.nodes[i], velocity[number[i]] = scene.velocity[i];
  const auto rename = [&](auto& cells, std::size_t first, std::size_t last) {
    for (auto& cell : cells)
      for (Index& i : cell) i = number[i];
    if (change.seed == 0) return;
    const auto at = [&](std::size_t k) { return cells.begin() + static_cast<std::ptrdiff_t>(k); };
    std::shuffle(at(0), at(first), random), std::shuffle(at(first), at(last), random);
  };
  Mesh& mesh = scene.mesh;
  rename(mesh.hexahedra, scene.first_cells[0], scene.last[0]);
  rename(mesh.tetrahedra, scene.first_cells[1], scene.last[1]);
  rename(mesh.quadrilaterals, scene.first_cells[2], scene.last[2]);

  // The surfaces of both bodies.
  const double h = change.length * scene.thickness;
  const auto surface_of = [&](const std::array<std::size_t, 3>& begin, const std::array<std::size_t, 3>& end,
                              double towards) {
    const auto some = [&]<std::size_t n>(const Cells<n>& cells, std::size_t kind) {
      return Cells<n>(cells.begin() + static_cast<std::ptrdiff_t>(begin[kind]),
                      cells.begin() + static_cast<std::ptrdiff_t>(end[kind]));
    };
    const auto facing = [&](std::vector<Face> faces) {
      if (change.ends_only)
        std::erase_if(faces, [&](const Face& face) {
          const Eigen::Vector3d area = Q.transpose() * area_vector(nodes, face);
          return towards * area.z() < 0.5 * area.norm();
        });
      return faces;
    };
    if (begin[0] < end[0]) return Surface{facing(hexahedron_surface(some(mesh.hexahedra, 0)))};
    if (begin[1] < end[1]) return Surface{facing(tetrahedron_surface(some(mesh.tetrahedra, 1)))};
    return Surface{quadrilateral_surface(some(mesh.quadrilaterals, 2)), h};
  };
  Surface one = surface_of({0, 0, 0}, scene.first_cells, -1), other = surface_of(scene.first_cells, scene.last, 1);
  if (change.swaps) std::swap(one, other);

  const double rho = change.mass / std::pow(change.length, 3), E = 1000 * rho;  // velocities stay as they are
  const Elastic stiff{.density = rho, .youngs_modulus = E, .poissons_ratio = 0.3};
  const Solid soft{LinearEos{.density = rho, .bulk_modulus = E / 1.2}, ElasticStrength{E / 2.6}};
  const Grown grown{change.far_goes ? 1.08 : 1e9};
  const Scene parts{
      nodes,
      Part{Hex8{}, stiff, mesh.hexahedra, grown},
      Part{Tet4{}, stiff, mesh.tetrahedra, grown},
      Part{Plate4{}, Homogeneous{PlaneStress{soft}, h}, mesh.quadrilaterals, grown},
      InitialVelocityField{[&](const Eigen::Vector3d& x) {
        return velocity[static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), x) - nodes.begin())];
      }},
      AnyContact{make(one, other)}};
  // A step that no far element bounds.
  const ExplicitOptions options{
      .largest_step = change.length * change.step, .energy_tolerance = 0.2, .print_warnings = false};
  const auto after = [&](auto run) {
    run.until(change.length * change.until);
    CHECK((run.template part<0>().deleted() > 0) == change.far_goes);
    std::vector<Eigen::Vector3d> x = run.positions(), back;
    for (std::size_t i = 0; i < scene.nodes; ++i)
      back.push_back(Q.transpose() * (x[number[i]] / change.length - change.moved));
    return back;
  };
  return change.threads > 0 ? after(Explicit{parts, options, OpenMP{change.threads}}) : after(Explicit{parts, options});
}

/// The largest distance between the same nodes, less what the first body has been moved aside.
inline double apart(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b,
                    std::size_t first_nodes, const Eigen::Vector3d& aside) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, (a[i] - b[i] - (i < first_nodes ? aside : Eigen::Vector3d(0, 0, 0))).norm());
  return most;
}

/// Solids on solids, plates on plates, tetrahedra on plates, plates on solids; exactly flush ones last.
inline std::vector<Encounter> encounters() {
  const Mesh slab = box({.size = {2, 2, 0.6}, .cells = {3, 3, 1}}), pane = rectangle({.size = {2, 2}, .cells = {4, 4}});
  const auto above = [](const Mesh& body, double gap) {
    return translated(rotated(body, {0.1, 0.2, 1}, 0.3), {0.61, 0.37, gap});
  };
  const Mesh block = box({.size = {0.9, 0.9, 0.6}, .cells = {2, 2, 1}}),
             sheet_above = rectangle({.size = {1.1, 1.1}, .cells = {3, 3}});
  const Eigen::Vector3d down(0.2, -0.1, -2);
  std::vector<Encounter> all;
  all.emplace_back("solids on solids", above(block, 0.75), slab, down);
  all.emplace_back("plates on plates", above(sheet_above, 0.25), pane, down);
  all.emplace_back("tetrahedra on plates", above(tetrahedralized(block), 0.2), pane, down);
  all.emplace_back("plates on solids", above(sheet_above, 0.8), slab, down);
  all.emplace_back("flush cubes", translated(box({.size = {1, 1, 0.6}, .cells = {2, 2, 1}}), {0, 0, 0.605}),
                   box({.size = {1, 1, 0.6}, .cells = {2, 2, 1}}), Eigen::Vector3d(0, 0, -1));
  return all;
}

/// Limits of a contact, by which its answers may differ.
struct Allowed {
  double depth = 0;       ///< of springs, which changes with the number of nodes that meet faces [size of a body]
  bool has_edges = true;  ///< edges touch edges
  bool two_way = true;    ///< both surfaces are alike
  double order = 0;       ///< by which the order of pairs counts, of a law that takes each pair once [size of a body]
};

/// `make` gives a contact from the surfaces of the body that flies and of the other. Tolerances are in sizes of a body.
template <class Make>
void answers_alike(const Make& make, const Allowed& allowed = {}) {
  for (const Encounter& scene : encounters()) {
    const bool flush = scene.name.starts_with("flush");
    const double rounding = 1e-11, settled = 1e-6 + allowed.order;
    std::vector<Change> changes{
        {.name = "turned", .tolerance = rounding, .turn = {0.3, -1.1, 0.7}},
        {.name = "moved", .tolerance = rounding, .moved = {12, -7, 5}},
        {.name = "renumbered", .tolerance = settled, .seed = 1},
        {.name = "plates from behind", .tolerance = rounding, .flips = true},
        {.name = "millimetres", .tolerance = rounding, .length = 1000},
        {.name = "tonnes", .tolerance = rounding, .mass = 1e-3},
        {.name = "a far element deleted", .tolerance = 1e-12, .far_goes = true},
        {.name = "three threads", .tolerance = 0, .threads = 3},
        {.name = "half the step", .tolerance = 1e-2 + allowed.order, .step = 1e-3},
        {.name = "aside by 1e-12", .tolerance = 1e-9, .aside = {1e-12, 0, 0}},
    };
    if (!flush || allowed.has_edges)
      changes.push_back(
          {.name = "aside by 1e-3", .tolerance = 2e-3 + allowed.depth + allowed.order, .aside = {-1e-3, 1e-3, 0}});
    if (allowed.two_way) {
      changes.push_back({.name = "swapped", .tolerance = settled, .swaps = true});
      changes.push_back({.name = "faces that meet", .tolerance = settled, .ends_only = true});
    }
    const auto as_it_is = answer(scene, make, {});
    const auto untouched = answer(scene, [](const Surface&, const Surface&) { return NoContact{}; }, {});
    CAPTURE(scene.name);
    CHECK(apart(as_it_is, untouched, 0, {}) > 0.02);
    for (const Change& change : changes) {
      CAPTURE(change.name);
      CHECK(apart(answer(scene, make, change), as_it_is, scene.first_nodes, change.aside) <= change.tolerance);
    }
  }
}

}  // namespace strike::testing
