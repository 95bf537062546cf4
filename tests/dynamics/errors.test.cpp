// What a user is told when a scene cannot run, word for word.
#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

const Elastic rubber{.density = 1000, .youngs_modulus = 1e6};
Mesh cube() { return box({.size = {1, 1, 1}, .cells = {1, 1, 1}}); }

template <class F>
std::string told(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

std::string told_at_start(const Mesh& mesh) {
  return told([&] { Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, {}, in<double>}; });
}

}  // namespace

TEST_CASE("a node without mass is named with its place") {
  Mesh mesh = cube();
  mesh.nodes.push_back({5, 6, 7});
  CHECK(told_at_start(mesh) == "strike: node 8 at (5, 6, 7) has no mass, for it belongs to no element; remove it.");
}

TEST_CASE("an element inside out is named with its place") {
  Mesh mesh = cube();
  std::swap_ranges(mesh.hexahedra[0].begin(), mesh.hexahedra[0].begin() + 4, mesh.hexahedra[0].begin() + 4);
  CHECK(told_at_start(mesh) ==
        "strike: element 0 of part 0 at (0.5, 0.5, 0.5) has no positive mass; its corners are in the wrong order or "
        "coincide.");
}

TEST_CASE("connectivity beyond the nodes is named") {
  Mesh mesh = cube();
  mesh.hexahedra[0][3] = 77;
  CHECK(told_at_start(mesh) ==
        "strike: element 0 of part 0 names node 77, but there are 8 nodes; correct its connectivity.");
}

TEST_CASE("a part without elements is refused") {
  Mesh mesh = cube();
  mesh.hexahedra.clear();
  CHECK(told_at_start(mesh) == "strike: part 0 has no elements; give it cells.");
}

TEST_CASE("a step below the smallest is refused with the element that asks for it") {
  const Mesh mesh = cube();
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, {.smallest_step = 1}, in<double>};
  CHECK_THAT(told([&] { run.until(10); }),
             ContainsSubstring("the time step has fallen to") && ContainsSubstring("element 0 of part 0"));
}

TEST_CASE("constants from which no wave follows are refused") {
  const Mesh mesh = cube();
  const Elastic nothing{.density = 1000, .youngs_modulus = -1};
  CHECK_THAT(told([&] {
               Explicit{Scene{mesh.nodes, Part{Hex8{}, nothing, mesh.hexahedra}}, {}, in<double>};
             }),
             ContainsSubstring("the youngs_modulus of Elastic, in part 0, is -1; it must be positive"));
}

TEST_CASE("float far from the origin is refused, double is not") {  // D21: spacing 0.06 at 1e6
  const Mesh mesh = box({.lower = {1e6, 0, 0}, .size = {1, 1, 1}, .cells = {1, 1, 1}});
  CHECK_THAT(told([&] {
               Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, {}, in<Pack<float, 4>>};
             }),
             ContainsSubstring("move the mesh to the origin or compute in double"));
  CHECK(told([&] { Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, {}, in<double>}; }) == "nothing");
}

TEST_CASE("softening is noticed") {
  const Mesh mesh = cube();
  const auto warnings = [&](double hardening) {
    const Solid metal{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                      VonMises{.shear_modulus = 80e9, .yield_stress = 4e8, .hardening_modulus = hardening}};
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, metal, mesh.hexahedra}}, {}, in<double>}.warnings().size();
  };
  CHECK(warnings(0) == 0);
  CHECK(warnings(-1e9) == 1);
}
