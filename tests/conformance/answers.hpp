#pragma once
// Laws of a contact that need no reference, as one suite: what must leave the answer of a scene as it is.
//   TEST_CASE("conformance: my law") {
//     testing::answers_alike([](const Surface& one, const Surface& other) { return Contact{TwoWay{one, other},
//     MyLaw{}}; });
//     testing::answers_alike_on_rigid(testing::nodes_on(RigidSphere{{0, 0, -2}, 2}, MyLaw{}));
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

#include <Eigen/Geometry>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/archive.hpp>
#include <strike/section.hpp>

#include "contact/bodies.hpp"
#include "support/catch.hpp"

namespace strike::testing {

/// Any contact behind one type, so that one run is compiled for all.
class AnyContact {
  using N = Nodes<double, double, true>;

 public:
  template <class C>
  explicit AnyContact(C contact) : made_(std::make_unique<Model<C>>(std::move(contact))) {}
  AnyContact(const AnyContact& other) : made_(other.made_->copy()) {}

  void begin(N& nodes, std::span<const PartFaces> parts) { made_->begin(nodes, parts); }
  double stable_step(double dt, const N& nodes) { return made_->stable_step(dt, nodes); }
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const OpenMP& execution) {
    made_->resolve_contact(nodes, step, ledger, execution);
  }
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const Serial& execution) {
    made_->resolve_contact(nodes, step, ledger, execution);
  }
  void remove(std::size_t part, const std::vector<bool>& alive) { made_->remove(part, alive); }
  void serialize(Archive& archive) { made_->serialize(archive); }

 private:
  struct Base {
    virtual ~Base() = default;
    virtual std::unique_ptr<Base> copy() const = 0;
    virtual void begin(N&, std::span<const PartFaces>) = 0;
    virtual double stable_step(double, const N&) = 0;
    virtual void resolve_contact(N&, const Step&, Ledger&, const Serial&) = 0;
    virtual void resolve_contact(N&, const Step&, Ledger&, const OpenMP&) = 0;
    virtual void remove(std::size_t, const std::vector<bool>&) = 0;
    virtual void serialize(Archive&) = 0;
  };
  template <class C>
  struct Model final : Base {
    explicit Model(C made) : contact(std::move(made)) {}
    std::unique_ptr<Base> copy() const override { return std::make_unique<Model>(contact); }
    void begin(N& nodes, std::span<const PartFaces> parts) override {
      detail::call_if_present<detail::item::Begin>(contact, nodes, parts);
    }
    double stable_step(double dt, const N& nodes) override { return contact.stable_step(dt, nodes); }
    void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const Serial& execution) override {
      detail::item::ResolveContact::call(contact, nodes, step, ledger, execution);
    }
    void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const OpenMP& execution) override {
      detail::item::ResolveContact::call(contact, nodes, step, ledger, execution);
    }
    void remove(std::size_t part, const std::vector<bool>& alive) override {
      detail::call_if_present<detail::item::Remove>(contact, part, alive);
    }
    void serialize(Archive& archive) override { contact.serialize(archive); }

    C contact;
  };
  std::unique_ptr<Base> made_;
};

/// The state of a run, as bytes that a checkpoint holds.
class Memory final : public Archive {
 public:
  /// Writes to the bytes, or reads from them.
  Memory(std::string& all, bool reads) : Archive(reads), all_(all) {}

 private:
  void bytes(void* at, std::size_t count) override {
    if (reads())
      all_.copy(static_cast<char*>(at), count, place_), place_ += count;
    else
      all_.append(static_cast<const char*>(at), count);
  }

  std::string& all_;
  std::size_t place_ = 0;
};

/// A removal law that deletes what has grown.
struct Grown {
  double most;
  template <class State, class Condition>
  auto keeps(const State&, const Condition& element) const {
    return element.relative_volume() < most;
  }
};

/// Where a scene lies and in which unit of length.
struct Placement {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();  ///< after the turn
  double unit = 1;

  Eigen::Vector3d point(const Eigen::Vector3d& x) const { return unit * (turn * x + moved); }
  Eigen::Vector3d direction(const Eigen::Vector3d& a) const { return turn * a; }
  double length(double l) const { return unit * l; }
  Eigen::Vector3d back(const Eigen::Vector3d& x) const { return turn.transpose() * (x / unit - moved); }
};

/// Any rigid body with a formula, in its place.
template <RigidObstacle Body>
struct Placed {
  Body body;
  Placement at;

  Clearance clearance(const Eigen::Vector3d& x) const {
    const auto [gap, normal] = body.clearance(at.back(x));
    return {at.length(gap), at.direction(normal)};
  }
};
template <RigidObstacle Body>
Placed<Body> placed(const Body& body, const Placement& at) {
  return {body, at};
}
inline RigidPlane placed(const RigidPlane& plane, const Placement& at) {
  return {at.point(plane.point), at.direction(plane.normal)};
}
inline RigidSphere placed(const RigidSphere& sphere, const Placement& at) {
  return {at.point(sphere.centre), at.length(sphere.radius)};
}
inline RigidCylinder placed(const RigidCylinder& cylinder, const Placement& at) {
  return {at.point(cylinder.point), at.direction(cylinder.axis), at.length(cylinder.radius),
          at.length(cylinder.length)};
}
inline RigidSurface placed(RigidSurface surface, const Placement& at) {
  for (Eigen::Vector3d& x : surface.points) x = at.point(x);
  return surface;
}

/// A contact of the surfaces of the bodies of an encounter, which lies there.
using MakeContact = std::function<AnyContact(std::span<const Surface>, const Placement&)>;

/// The cells of a mesh on the positive sides of planes through the origin.
inline Mesh cut(Mesh mesh, const std::vector<Axis>& planes) {
  for (const Axis axis : planes) {
    const auto cut_off = [&]<std::size_t n>(Cells<n>& cells) {
      std::erase_if(cells, [&](const auto& cell) { return centroid<n>(mesh.nodes, cell)(int(axis)) < 0; });
    };
    cut_off(mesh.hexahedra), cut_off(mesh.tetrahedra), cut_off(mesh.quadrilaterals);
  }
  return remove_orphan_nodes(std::move(mesh));
}

/// How the bodies of an encounter lie: askew; or symmetric about the planes x = 0 and y = 0, where nodes of one may be
/// over edges of the other (centred), or nodes meet nodes or a rigid body alone (flush).
enum class Lies { askew, centred, flush };

/// A body that flies at another, or at a rigid one, and far from both an element of each kind that grows.
struct Encounter {
  std::string name;
  Mesh first, second;      ///< bodies; the second has no nodes where a rigid one takes its place
  Eigen::Vector3d flight;  ///< the first's velocity
  Lies lies;
  Mesh mesh;  ///< the nodes of the bodies come first
  std::vector<Eigen::Vector3d> velocity;
  std::size_t nodes = 0;                             ///< of both bodies
  std::array<std::size_t, 3> first_cells{}, last{};  ///< hexahedra, tetrahedra and plates of the first, and of both
  double thickness = 0.1;                            ///< of plates [length]
  double until = 0.2507;                             ///< [time]

  Encounter(std::string title, const Mesh& one, const Mesh& other, const Eigen::Vector3d& v, Lies how = Lies::askew)
      : name(std::move(title)), first(one), second(other), flight(v), lies(how), mesh(first) {
    first_cells = counts();
    append(mesh, second);
    last = counts(), nodes = mesh.nodes.size();
    velocity.assign(nodes, Eigen::Vector3d::Zero());
    std::fill_n(velocity.begin(), first.nodes.size(), flight);
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
  bool is_on_rigid() const { return second.nodes.empty(); }
};

/// A change of a scene, which is undone in its answer.
struct Change {
  std::string name;
  double tolerance = 0;  ///< of the answer, in sizes of a body, 1
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), moved = Eigen::Vector3d::Zero(), aside = Eigen::Vector3d::Zero();
  double length = 1, mass = 1;  ///< units
  unsigned seed = 0;            ///< of new numbers of nodes and cells
  bool flips = false, swaps = false, ends_only = false, far_goes = false;
  std::vector<Axis> cuts{};  ///< planes of symmetry
  double step = 2e-3;        ///< [time]
  int threads = 0;
  int interrupted = 0;  ///< each time after so many steps
};

/// The positions of the nodes of both bodies after a while, in their numbers and as before the change.
inline std::vector<Eigen::Vector3d> answer(const Encounter& whole, const MakeContact& make, const Change& change) {
  Encounter scene(whole.name, cut(whole.first, change.cuts), cut(whole.second, change.cuts), whole.flight);
  const std::size_t count = scene.mesh.nodes.size();
  Placement at{.moved = change.moved, .unit = change.length};
  if (const double angle = change.turn.norm(); angle > 0)
    at.turn = Eigen::AngleAxisd(angle, change.turn / angle).toRotationMatrix();
  std::mt19937 random(change.seed);
  if (change.flips)
    for (auto& cell : scene.mesh.quadrilaterals)
      if (random() % 2 == 0) cell = {cell[0], cell[3], cell[2], cell[1]};

  // In new numbers node i is number[i]; cells are shuffled within their body.
  std::vector<Index> number(count);
  std::iota(number.begin(), number.end(), Index{0});
  if (change.seed > 0) std::shuffle(number.begin(), number.end(), random);
  std::vector<Eigen::Vector3d> nodes(count), velocity(count);
  std::array<std::vector<Index>, 2> on_plane;  // x = 0 and y = 0, where it is cut
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = scene.mesh.nodes[i];
    nodes[number[i]] = at.point(i < scene.first.nodes.size() ? Eigen::Vector3d(x + change.aside) : x);
    velocity[number[i]] = at.direction(scene.velocity[i]);
    for (const Axis axis : change.cuts)
      if (i < scene.nodes && std::abs(x(int(axis))) < 1e-9) on_plane.at(std::size_t(axis)).push_back(number[i]);
  }
  const auto rename = [&](auto& cells, std::size_t first, std::size_t last) {
    for (auto& cell : cells)
      for (Index& i : cell) i = number[i];
    if (change.seed == 0) return;
    const auto place = [&](std::size_t k) { return cells.begin() + static_cast<std::ptrdiff_t>(k); };
    std::shuffle(place(0), place(first), random), std::shuffle(place(first), place(last), random);
  };
  Mesh& mesh = scene.mesh;
  rename(mesh.hexahedra, scene.first_cells[0], scene.last[0]);
  rename(mesh.tetrahedra, scene.first_cells[1], scene.last[1]);
  rename(mesh.quadrilaterals, scene.first_cells[2], scene.last[2]);

  // The surfaces of the bodies.
  const double h = at.length(scene.thickness);
  const auto surface_of = [&](const std::array<std::size_t, 3>& begin, const std::array<std::size_t, 3>& end,
                              double towards) {
    const auto some = [&]<std::size_t n>(const Cells<n>& cells, std::size_t kind) {
      return Cells<n>(cells.begin() + static_cast<std::ptrdiff_t>(begin[kind]),
                      cells.begin() + static_cast<std::ptrdiff_t>(end[kind]));
    };
    const auto facing = [&](std::vector<Face> faces) {
      if (change.ends_only)
        std::erase_if(faces, [&](const Face& face) {
          const Eigen::Vector3d area = area_vector(nodes, face);
          return towards * at.direction({0, 0, 1}).dot(area) < 0.5 * area.norm();
        });
      return faces;
    };
    if (begin[0] < end[0]) return Surface{facing(hexahedron_surface(some(mesh.hexahedra, 0)))};
    if (begin[1] < end[1]) return Surface{facing(tetrahedron_surface(some(mesh.tetrahedra, 1)))};
    return Surface{quadrilateral_surface(some(mesh.quadrilaterals, 2)), h};
  };
  std::vector<Surface> surfaces{surface_of({0, 0, 0}, scene.first_cells, -1)};
  if (!scene.is_on_rigid()) surfaces.push_back(surface_of(scene.first_cells, scene.last, 1));
  if (change.swaps) std::swap(surfaces.front(), surfaces.back());

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
      Symmetry{at.direction(unit(Axis::x)), on_plane[0]},
      Symmetry{at.direction(unit(Axis::y)), on_plane[1]},
      make(surfaces, at)};
  // A step that no far element bounds.
  const ExplicitOptions options{
      .largest_step = change.length * change.step, .energy_tolerance = 0.2, .print_warnings = false};
  const double end = change.length * whole.until;
  const auto after = [&](const auto& execution) {
    auto run = std::make_unique<decltype(Explicit{parts, options, execution})>(parts, options, execution);
    for (;;) {
      const std::size_t last = run->steps() + static_cast<std::size_t>(change.interrupted);
      run->until(end, StopWhen{[&] { return change.interrupted > 0 && run->steps() >= last; }});
      if (!(run->time() < end)) break;
      std::string bytes;
      Memory writer(bytes, false), reader(bytes, true);
      writer(*run);
      run = std::make_unique<typename decltype(run)::element_type>(parts, options, execution);
      reader(*run);
    }
    CHECK((run->template part<0>().deleted() > 0) == change.far_goes);
    std::vector<Eigen::Vector3d> back;
    const std::vector<Eigen::Vector3d> x = run->positions();
    for (std::size_t i = 0; i < scene.nodes; ++i) {
      back.push_back(at.back(x[number[i]]));
      if (i < scene.first.nodes.size()) back.back() -= change.aside;
    }
    return back;
  };
  return change.threads > 0 ? after(OpenMP{change.threads}) : after(Serial{});
}

/// Solids on solids, plates on plates, tetrahedra on plates, plates on solids, askew and centred; exactly flush ones.
inline std::vector<Encounter> encounters() {
  const Mesh slab = box({.size = {2, 2, 0.6}, .cells = {3, 3, 1}}), pane = rectangle({.size = {2, 2}, .cells = {4, 4}});
  const auto above = [](const Mesh& body, double gap) {
    return translated(rotated(body, {0.1, 0.2, 1}, 0.3), {0.61, 0.37, gap});
  };
  const Mesh block = box({.size = {0.9, 0.9, 0.6}, .cells = {2, 2, 1}}),
             sheet_above = rectangle({.size = {1.1, 1.1}, .cells = {3, 3}});
  const Eigen::Vector3d down(0.2, -0.1, -2), straight(0, 0, -2);
  std::vector<Encounter> all;
  all.emplace_back("solids on solids", above(block, 0.75), slab, down);
  all.emplace_back("plates on plates", above(sheet_above, 0.25), pane, down);
  all.emplace_back("tetrahedra on plates", above(tetrahedralized(block), 0.2), pane, down);
  all.emplace_back("plates on solids", above(sheet_above, 0.8), slab, down);

  const auto centred = [](Mesh quarter) {
    for (const Axis axis : {Axis::x, Axis::y}) {
      append(quarter, mirrored(quarter, unit(axis)));
      quarter = merge_coincident_nodes(std::move(quarter), 1e-6);
    }
    return quarter;
  };
  const Mesh quarter_block = box({.size = {0.45, 0.45, 0.6}}), centred_block = centred(quarter_block),
             centred_tetrahedra = centred(tetrahedralized(quarter_block)),
             centred_sheet = centred(rectangle({.size = {0.55, 0.55}})),
             centred_slab = centred(box({.size = {1, 1, 0.6}, .cells = {2, 2, 1}})),
             centred_pane = translated(pane, {-1, -1, 0});
  const auto onto = [&](const std::string& name, const Mesh& body, double gap, const Mesh& other) {
    all.emplace_back(name, translated(body, {0, 0, gap}), other, straight, Lies::centred);
  };
  onto("centred solids on solids", centred_block, 0.75, centred_slab);
  onto("centred plates on plates", centred_sheet, 0.25, centred_pane);
  onto("centred tetrahedra on plates", centred_tetrahedra, 0.2, centred_pane);
  onto("centred plates on solids", centred_sheet, 0.8, centred_slab);

  const Mesh cube = box({.lower = {-0.5, -0.5, 0}, .size = {1, 1, 0.6}, .cells = {2, 2, 1}});
  all.emplace_back("flush cubes", translated(cube, {0, 0, 0.605}), cube, Eigen::Vector3d(0, 0, -1), Lies::flush);
  all.back().until = 0.1507;  // it has stopped, and the other has taken its velocity
  return all;
}

/// Solids, plates and tetrahedra that fall askew, and solids and plates that fall flat, on the origin, the top of a
/// rigid body.
inline std::vector<Encounter> encounters_on_rigid() {
  const Mesh block = box({.lower = {-0.45, -0.45, 0.1}, .size = {0.9, 0.9, 0.6}, .cells = {2, 2, 1}}),
             sheet_above = rectangle({.lower = {-0.55, -0.55, 0.1}, .size = {1.1, 1.1}, .cells = {4, 4}}), none;
  const auto askew = [](const Mesh& body) { return translated(rotated(body, {0.1, 0.2, 1}, 0.3), {0.03, 0.05, 0.1}); };
  const Eigen::Vector3d down(0.2, -0.1, -2), straight(0, 0, -2);
  std::vector<Encounter> all;
  all.emplace_back("solids on a rigid body", askew(block), none, down);
  all.emplace_back("plates on a rigid body", askew(sheet_above), none, down);
  all.emplace_back("tetrahedra on a rigid body", askew(tetrahedralized(block)), none, down);
  all.emplace_back("solids flat on a rigid body", block, none, straight, Lies::flush);
  all.emplace_back("plates flat on a rigid body", sheet_above, none, straight, Lies::flush);
  return all;
}

/// Limits of a contact, by which its answers may differ [size of a body].
struct Allowed {
  double depth = 0;       ///< of springs, which changes with the number of nodes that meet faces
  bool has_edges = true;  ///< edges touch edges
  bool two_way = true;    ///< both surfaces are alike
  double order = 0;       ///< by which the order of pairs counts, of a law that takes each pair once
  double cut = 3e-4;  ///< at a plane of symmetry, over which a node has one of two faces as near: a thousandth of how
                      ///< far the bodies push each other; springs take m* from it
};

/// The changes that an encounter has to bear.
inline std::vector<Change> changes_of(const Encounter& scene, const Allowed& allowed) {
  const bool flush = scene.lies == Lies::flush, rigid = scene.is_on_rigid();
  const double rounding = 1e-11, settled = rigid ? rounding : 1e-6 + allowed.order;  // on a rigid body a node is alone
  const Eigen::Vector3d askew(0.3, -1.1, 0.7);
  std::vector<Change> changes;
  if (scene.lies != Lies::askew) {
    const double cut = flush ? rounding : allowed.cut + allowed.order;
    changes.push_back({.name = "a half", .tolerance = cut, .turn = askew, .cuts = {Axis::x}});
    changes.push_back({.name = "a quarter", .tolerance = cut, .turn = askew, .cuts = {Axis::x, Axis::y}});
  }
  if (scene.lies == Lies::centred) return changes;
  const auto add = [&](Change change) { changes.push_back(std::move(change)); };
  add({.name = "turned", .tolerance = rounding, .turn = askew});
  add({.name = "moved", .tolerance = rounding, .moved = {12, -7, 5}});
  add({.name = "renumbered", .tolerance = settled, .seed = 1});
  if (scene.last[2] > 0) add({.name = "plates from behind", .tolerance = rounding, .flips = true});
  add({.name = "millimetres", .tolerance = rounding, .length = 1000});
  add({.name = "tonnes", .tolerance = rounding, .mass = 1e-3});
  add({.name = "a far element deleted", .tolerance = 1e-12, .far_goes = true});
  add({.name = "three threads", .tolerance = 0, .threads = 3});
  add({.name = "half the step", .tolerance = 1e-2 + allowed.order, .step = 1e-3});
  add({.name = "interrupted", .tolerance = 0, .interrupted = 11});
  add({.name = "aside by 1e-12", .tolerance = 1e-9, .aside = {1e-12, 0, 0}});
  if (rigid || !flush || allowed.has_edges) {
    // Beside the top of a curved body by d = 1.4e-3 a square L that jumps turns by 2 (6/L^2) v t d = 0.01.
    const double curved = rigid ? 8e-3 : 2e-3;
    add({.name = "aside by 1e-3", .tolerance = curved + allowed.depth + allowed.order, .aside = {-1e-3, 1e-3, 0}});
  }
  if (allowed.two_way) {
    if (!rigid) add({.name = "swapped", .tolerance = settled, .swaps = true});
    add({.name = "faces that meet", .tolerance = settled, .ends_only = true});
  }
  return changes;
}

/// The laws of one encounter. Tolerances are in sizes of a body.
inline void answers_alike_in(const Encounter& scene, const MakeContact& make, const Allowed& allowed) {
  CAPTURE(scene.name);
  const auto as_it_is = answer(scene, make, {});
  std::vector<Eigen::Vector3d> untouched;
  for (std::size_t i = 0; i < scene.nodes; ++i)
    untouched.emplace_back(scene.mesh.nodes[i] + scene.until * scene.velocity[i]);
  CHECK(apart(as_it_is, untouched) > 0.02);
  for (const Change& change : changes_of(scene, allowed)) {
    CAPTURE(change.name);
    std::vector<Eigen::Vector3d> expected;  // of the nodes that are left
    for (std::size_t i = 0; i < scene.nodes; ++i)
      if (std::all_of(change.cuts.begin(), change.cuts.end(),
                      [&](Axis axis) { return scene.mesh.nodes[i](int(axis)) > -1e-9; }))
        expected.push_back(as_it_is[i]);
    CHECK(apart(answer(scene, make, change), expected) <= change.tolerance);
  }
}

/// `make` gives a contact from the surfaces of the body that flies and of the other.
template <class Make>
void answers_alike(const Make& make, const Allowed& allowed = {}) {
  const MakeContact contact = [&](std::span<const Surface> surfaces, const Placement&) {
    return AnyContact{make(surfaces[0], surfaces[1])};
  };
  for (const Encounter& scene : encounters()) answers_alike_in(scene, contact, allowed);
}

/// `make` gives a contact of nodes, of plates of that thickness, with a rigid body in its place: one whose top is the
/// origin and which is symmetric about the planes x = 0 and y = 0.
template <class Make>
void answers_alike_on_rigid(const Make& make, const Allowed& allowed = {}) {
  const MakeContact contact = [&](std::span<const Surface> surfaces, const Placement& at) {
    return AnyContact{make(surfaces[0].nodes(), surfaces[0].pieces()[0].thickness, at)};
  };
  for (const Encounter& scene : encounters_on_rigid()) answers_alike_in(scene, contact, allowed);
}

/// Makes a contact with a rigid body, for `answers_alike_on_rigid`.
template <class Body, class... Policies>
auto nodes_on(const Body& body, const Policies&... policies) {
  return [=](const std::vector<Index>& nodes, double thickness, const Placement& at) {
    return Contact{NodeToRigid{nodes, placed(body, at), thickness}, policies...};
  };
}

}  // namespace strike::testing
