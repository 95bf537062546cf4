#include <algorithm>
#include <cstdio>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/section.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using detail::item::Fault;
using N = Nodes<double>;
template <class Item>
constexpr Fault fault = detail::item::fault<Item, N>();

struct Nothing {};
struct Load {
  template <class Nodes>
  void apply_loads(Nodes&, double) {}
  template <class Nodes>
  double power(const Nodes&) const {
    return 0;
  }
};
struct WithoutTime {
  template <class Nodes>
  void apply_loads(Nodes&) {}
};
struct WithoutPower {
  template <class Nodes>
  void apply_loads(Nodes&, double) {}
};
struct PowerOfNothing : WithoutPower {
  double power() const { return 0; }
};
struct Pushes {
  template <class Nodes>
  void push(Nodes&, double) {}
  template <class Nodes>
  void begin(Nodes&) {}
};
/// Numbers may have the names of functions.
struct Pulse : Load {
  double begin = 0, stable_step = 1;
};
/// A helper of one's own is no misspelt function.
struct Helper : Load {
  void push(int) {}
};
struct Hidden {
 private:
  template <class Nodes>
  void begin(Nodes&) {}
};
struct FloatNodes {
  void begin(Nodes<float>&) {}
};
struct OtherStep {
  template <class Nodes, class Ledger>
  void constrain(Nodes&, double, Ledger&) {}
};
struct Sealed final {
  template <class Nodes>
  void begin(Nodes&) {}
};
static_assert(fault<Load> == Fault::none && fault<Sealed> == Fault::none && fault<RigidWall> == Fault::none);
static_assert(fault<Pulse> == Fault::none && fault<Helper> == Fault::none);
static_assert(fault<Nothing> == Fault::no_function && fault<int> == Fault::no_function);
static_assert(fault<WithoutTime> == Fault::apply_loads && fault<Pushes> == Fault::apply_loads);
static_assert(fault<WithoutPower> == Fault::power_missing && fault<PowerOfNothing> == Fault::power);
static_assert(fault<Hidden> == Fault::begin && fault<FloatNodes> == Fault::begin);
static_assert(fault<OtherStep> == Fault::constrain);
using Remembers = decltype([last = 0.0](double t) mutable { return last = t; });
using Timeless = decltype([] { return 1.0; });
using Silent = decltype([](double) {});
static_assert(fault<Pressure<Curve>> == Fault::none && fault<NodalForce<double (*)(double)>> == Fault::none);
static_assert(fault<AirBlast> == Fault::none);
static_assert(fault<BodyForce<Remembers>> == Fault::none && fault<PrescribedVelocity<Remembers>> == Fault::none);
static_assert(fault<Pressure<double>> == Fault::history && fault<BodyForce<Timeless>> == Fault::history);
static_assert(fault<NodalForce<Silent>> == Fault::history && fault<PrescribedDisplacement<double>> == Fault::history);

// A method knows its policies in any order, and each kind once.
using detail::MethodFault;
static_assert(detail::method_fault<>() == MethodFault::none);
static_assert(detail::method_fault<GlobalStep, In<double>, Serial>() == MethodFault::none);
static_assert(detail::method_fault<GlobalStep, ElementStep>() == MethodFault::twice);
static_assert(detail::method_fault<In<double>, In<double>>() == MethodFault::twice);
static_assert(detail::method_fault<int>() == MethodFault::unknown);
static_assert(detail::method_fault<Subcycling, GlobalStep>() == MethodFault::unfit_cycle);
static_assert(detail::method_fault<DynamicRelaxation, Subcycling>() == MethodFault::unfit_cycle);

const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                  VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};

}  // namespace

TEST_CASE("item: reached among all, among the parts, among the contacts, and all at once") {
  const Mesh mesh = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  const Cells<8> lower{mesh.hexahedra[0]}, upper{mesh.hexahedra[1]};
  const std::vector<Index> foot = nodes_where(mesh.nodes, on_plane(Axis::z, 0));
  Explicit run{Scene{mesh.nodes, InitialVelocity{{0, 0, -1}}, Part{Hex8{}, steel, lower},
                     RigidWall{{0, 0, 0}, {0, 0, 1}}, Part{Hex8{}, steel, upper},
                     Contact{NodeToRigid{foot, RigidSphere{{0, 0, -9}, 1}}}}};
  CHECK(&run.item<1>() == &run.part<0>());
  CHECK(&run.item<3>() == &run.part<1>());
  CHECK(&run.item<2>() == &run.contact<0>());
  CHECK(&run.item<4>() == &run.contact<1>());
  CHECK(run.part<1>().number() == 1);
  auto& [velocity, first, wall, second, sphere] = run.items();
  CHECK(&first == &run.part<0>());
  CHECK(&sphere == &run.contact<1>());
  std::size_t parts = 0;
  run.each_part([&](const auto& part) { CHECK(part.number() == parts++); });
  CHECK(parts == 2);
  CHECK(first.cells(run.nodes()) == lower);
  CHECK(second.cells(run.nodes()) == upper);
}

TEST_CASE("item: a run that is copied, moved or assigned goes on with its own items") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const std::vector<PartOf<Hex8<>, std::remove_const_t<decltype(steel)>>> parts{Part{Hex8{}, steel, mesh.hexahedra}};
  const auto start = [&] {
    return Explicit{Scene{mesh.nodes, parts, InitialVelocity{{0, 0, -1}}, RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  };
  auto run = start();
  run.until(1e-4);
  auto copy = run, assigned = start();
  assigned = run;
  run.until(3e-4);
  const auto expected = run.positions();
  const double force = run.contact<0>().force().z();
  CHECK(copy.positions() != expected);  // nothing of it has moved with the other
  copy.until(3e-4), assigned.until(3e-4);
  CHECK(copy.positions() == expected);
  CHECK(copy.contact<0>().force().z() == force);
  CHECK(assigned.positions() == expected);
  auto moved = std::move(copy);
  assigned = std::move(run);
  moved.until(4e-4), assigned.until(4e-4);
  CHECK(moved.positions() == assigned.positions());
  CHECK(moved.energy().internal == assigned.energy().internal);
}

TEST_CASE("item: policies stand after the options or after the scene") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const auto scene = [&] {
    return Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, InitialVelocity{{0, 0, -1}},
                 RigidWall{{0, 0, 0}, {0, 0, 1}}};
  };
  const auto end_of = [](auto&& run) {
    run.until(3e-4);
    return run.positions();
  };
  const auto expected = end_of(Explicit{scene()});
  CHECK(end_of(Explicit{scene(), {}, Serial{}}) == expected);
  CHECK(end_of(Explicit{scene(), Serial{}, ElementStep{}}) == expected);
  CHECK(end_of(Explicit{scene(), NoSubcycling{}, ExplicitOptions{}.step_factor > 0 ? Serial{} : Serial{}}) == expected);
}

TEST_CASE("item: a field takes tensors, whose components are the fields of the components") {
  const Mesh mesh = box({.size = {1, 1, 2}, .cells = {2, 3, 4}});
  Explicit run{Scene{mesh.nodes, Part{Hex8Full{}, steel, mesh.hexahedra}, InitialVelocity{{3, 0, -20}},
                     RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  run.until(2e-4);
  const auto tensor = run.part<0>().field([](const auto& s) { return s.stress; });
  const auto zz = run.part<0>().field([](const auto& s) { return s.stress.zz; }),
             yz = run.part<0>().field([](const auto& s) { return s.stress.yz; });
  const auto deviators = run.part<0>().field([](const auto& s) { return deviator(s.stress); });
  REQUIRE(tensor.size() == mesh.hexahedra.size());
  for (std::size_t e = 0; e < tensor.size(); ++e) {
    CHECK(tensor[e].zz == zz[e]);
    CHECK(tensor[e].yz == yz[e]);
    CHECK(trace(deviators[e]) == Approx(0).margin(1e-6 * 4e8));
  }
  CHECK(*std::min_element(zz.begin(), zz.end()) < -1e7);

  const Mesh sheet = rectangle({.size = {4, 4}, .cells = {2, 2}});
  const Layered section{Layer{PlaneStress{steel}, 0.1}, Layer{PlaneStress{Elastic{7850, 200e9, 0.3}}, 0.2}};
  Explicit plates{Scene{sheet.nodes, Part{Plate4{}, section, sheet.quadrilaterals}, InitialVelocity{{0, 0, -1}},
                        Clamped{nodes_where(sheet.nodes, on_plane(Axis::x, 0))}}};
  plates.until(1e-3);
  const auto bottom = plates.part<0>().field(0, [](const auto& s) { return s.stress; });
  const auto xx = plates.part<0>().field(0, [](const auto& s) { return s.stress.xx; });
  for (std::size_t e = 0; e < xx.size(); ++e) CHECK(bottom[e].xx == xx[e]);
  CHECK(plates.part<0>().field(1, PlasticStrain{}) == std::vector<double>(4, 0.0));
}

TEST_CASE("item: the stress of a point is a tensor in each number of a run") {
  const Mesh mesh = box({.size = {1, 1, 2}, .cells = {2, 3, 4}});
  const Mesh sheet = rectangle({.size = {4, 4}, .cells = {2, 2}});
  const Homogeneous section{PlaneStress{steel}, 0.1};
  const auto check_in = [&](auto number) {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, InitialVelocity{{3, 0, -20}},
                       RigidWall{{0, 0, 0}, {0, 0, 1}}},
                 number};
    run.until(2e-4);
    const std::vector<SymmetricTensor<double>> stress = run.template part<0>().field(StressTensor{});
    const auto zz = run.template part<0>().field([](const auto& s) { return s.stress.zz; });
    for (std::size_t e = 0; e < zz.size(); ++e) CHECK(stress[e].zz == zz[e]);
    CHECK(*std::min_element(zz.begin(), zz.end()) < -1e7);
    // a tensor of doubles is the same in all lanes
    for (const auto& unit : run.template part<0>().field([](const auto&) { return SymmetricTensor<double>{.xy = 2}; }))
      CHECK((unit.xx == 0 && unit.xy == 2));

    Explicit plates{Scene{sheet.nodes, Part{Plate4{}, section, sheet.quadrilaterals}, InitialVelocity{{0, 0, -1}},
                          Clamped{nodes_where(sheet.nodes, on_plane(Axis::x, 0))}},
                    number};
    plates.until(1e-3);
    const auto bottom = plates.template part<0>().field(0, StressTensor{});
    const auto xx = plates.template part<0>().field(0, [](const auto& s) { return s.stress.xx; });
    for (std::size_t e = 0; e < xx.size(); ++e) CHECK((bottom[e].xx == xx[e] && bottom[e].zz == 0));

    Explicit water{Scene{mesh.nodes, Part{Hex8{}, Fluid{CubicEos{.density = 1000, .C1 = 2e9}}, mesh.hexahedra},
                         InitialVelocity{{0, 0, -20}}, RigidWall{{0, 0, 0}, {0, 0, 1}}},
                   number};
    water.until(2e-4);
    const auto spherical = water.template part<0>().field(StressTensor{});
    const auto p = water.template part<0>().field([](const auto& s) { return s.pressure; });
    for (std::size_t e = 0; e < p.size(); ++e) CHECK((spherical[e].yy == -p[e] && spherical[e].yz == 0));
  };
  check_in(in<double>);
  check_in(in<Pack<double>>);
  check_in(in<Pack<float>>);
  check_in(in<Pack<float>, double>);
}

TEST_CASE("item: the balance is that of loads whose power is told, and items that do nothing change no bit") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const auto end_of = [&](auto... more) {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, BodyForce{{0, 0, -1e4}},
                       RigidWall{{0, 0, -0.01}, {0, 0, 1}}, more...}};
    run.until(2e-3);
    CHECK(std::abs(run.energy().error()) < 1e-2);
    return std::tuple(run.positions(), run.energy().external);
  };
  CHECK(end_of() == end_of(Load{}, InitialVelocity{{1, 0, 0}, {}}));
}
