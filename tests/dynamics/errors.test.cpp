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
        "strike: element 0 of part 0 at (0.5, 0.5, 0.5) is flat or inside out at corner 0 (volume -1); order its "
        "corners 0-3 around the bottom and 4-7 above them, right-handed.");
}

TEST_CASE("wrong cells in the middle of a part are named, in double and in lanes of float") {
  const Mesh sound = box({.size = {1, 1, 1}, .cells = {10, 10, 10}});
  const std::size_t middle = 555;
  const auto both_told = [&](const Mesh& mesh) {
    const std::string in_double = told_at_start(mesh);
    CHECK(told([&] {
            Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, {}, in<Pack<float, 4>>};
          }).substr(0, 60) == in_double.substr(0, 60));
    return in_double;
  };
  CHECK(both_told(sound) == "nothing");
  const std::string named = "strike: element 555 of part 0 at (0.55, 0.55, 0.55) ";
  Mesh mesh = sound;
  auto& cell = mesh.hexahedra[middle];
  std::swap(cell[4], cell[5]);
  CHECK_THAT(both_told(mesh), ContainsSubstring(named + "is flat or inside out at corner "));
  for (const double size : {1e-9, 1e9}) {  // whose sixth power is no float
    Mesh scaled = mesh;
    for (auto& x : scaled.nodes) x *= size;
    CHECK_THAT(both_told(scaled),
               ContainsSubstring("element 555 of part 0") && ContainsSubstring("flat or inside out"));
  }
  mesh = sound;
  std::rotate(&cell[4], &cell[5], &cell[7] + 1);  // the volume stays positive
  CHECK_THAT(both_told(mesh),
             ContainsSubstring(named + "is twisted: corners 4 5 6 7 are turned against 0 1 2 3 by 90"));
  mesh = sound;
  cell[6] = cell[5];
  CHECK_THAT(both_told(mesh), ContainsSubstring("element 555 of part 0 at (0.542857, 0.542857, 0.542857) names node " +
                                                std::to_string(cell[5]) + " twice; give it 8 different corners"));
  mesh = sound;
  mesh.nodes[cell[6]] -= Eigen::Vector3d(0.04, 0.04, 0.04);  // by more than a third of a diagonal
  CHECK_THAT(both_told(mesh), ContainsSubstring("element 555 of part 0 at (0.545, 0.545, 0.545) is flat or inside out "
                                                "at corner 6 (volume 0.0007"));
}

TEST_CASE("of several parts the one with the wrong cell is named, by its own numbers") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 1, 1}});
  const Mesh plates = rectangle({.lower = {2, 0, 0}, .size = {2, 1}, .cells = {2, 1}}),
             wedges = tetrahedralized(box({.lower = {5, 0, 0}, .size = {1, 1, 1}}));
  append(mesh, plates), append(mesh, wedges);
  std::reverse(mesh.nodes.begin(), mesh.nodes.end());
  const auto renumber = [&](auto& cells) {
    for (auto& cell : cells)
      for (Index& node : cell) node = static_cast<Index>(mesh.nodes.size()) - 1 - node;
  };
  renumber(mesh.hexahedra), renumber(mesh.tetrahedra), renumber(mesh.quadrilaterals);
  const Homogeneous skin{PlaneStress{rubber}, 0.1};
  const auto start = [&](const Mesh& scene) {
    return Explicit{Scene{scene.nodes, Part{Hex8{}, rubber, scene.hexahedra}, Part{Tet4{}, rubber, scene.tetrahedra},
                          Part{Plate4{}, skin, scene.quadrilaterals}},
                    {},
                    in<double>};
  };
  const auto told_of = [&](const Mesh& scene) { return told([&] { start(scene); }); };
  REQUIRE(told_of(mesh) == "nothing");

  Mesh wrong = mesh;
  std::swap(wrong.tetrahedra[3][0], wrong.tetrahedra[3][1]);
  CHECK_THAT(told_of(wrong),
             ContainsSubstring("strike: element 3 of part 1 at (5.") &&
                 ContainsSubstring("is flat or inside out (volume -0.166667); order its corners so that"));
  wrong = mesh;
  std::swap(wrong.quadrilaterals[1][1], wrong.quadrilaterals[1][2]);
  CHECK_THAT(told_of(wrong), ContainsSubstring("strike: element 1 of part 2 at (3.5, 0.5, 0) is crossed, concave or "
                                               "flat at corner "));
  wrong = mesh;
  wrong.nodes[wrong.quadrilaterals[1][2]] = {3.2, 0.2, 0};
  CHECK_THAT(told_of(wrong), ContainsSubstring("of part 2") && ContainsSubstring("is crossed, concave or flat"));
  wrong = mesh;
  wrong.quadrilaterals[1][3] = wrong.quadrilaterals[1][1];
  CHECK_THAT(told_of(wrong), ContainsSubstring("twice; give it 4 different corners, or 3"));

  const auto run = start(mesh);
  const auto strain = [](const auto& point) { return point.stress.xx; };
  CHECK(run.part<2>().field(0, strain).size() == 2);
  for (const int layer : {1, -1})
    CHECK(told([&] { run.part<2>().field(static_cast<std::size_t>(layer), strain); }) ==
          "strike: part 2 has no layer " + std::to_string(layer) + "; count its 1 layer from 0 at the bottom.");
  CHECK(told([&] { run.part<1>().describe(run.nodes(), 6); }) ==
        "strike: part 1 has no element 6; count its 6 elements from 0.");
}

namespace {

/// Somebody's element of eight nodes, which says nothing of their order.
struct Eight {
  using Kinematics = SolidKinematics;
  static constexpr int nodes = 8;
  template <class M, class T>
  using State = Hex8<>::State<M, T>;

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 8>& x) const {
    return Hex8{}.begin(state, material, x);
  }
  template <class M, class T>
  Response<T, 8> advance(State<M, T>& state, const M& material, const Nodal<T, 8>& x, const Nodal<T, 8>& v,
                         double dt) const {
    return Hex8{}.advance(state, material, x, v, dt);
  }
};

}  // namespace

TEST_CASE("cells of an element that tells no shape are not taken for hexahedra") {
  Mesh mesh = cube();
  std::rotate(&mesh.hexahedra[0][4], &mesh.hexahedra[0][5], &mesh.hexahedra[0][7] + 1);
  CHECK(told([&] { Explicit{Scene{mesh.nodes, Part{Eight{}, rubber, mesh.hexahedra}}, {}, in<double>}; }) == "nothing");
  CHECK_THAT(told_at_start(mesh), ContainsSubstring("is twisted"));
}

TEST_CASE("plates thicker than twice an edge, or thinner than 1e-4 of all, are noticed") {
  const auto warnings = [](double thickness, Index cells) {
    const Mesh mesh = rectangle({.size = {1, 1}, .cells = {cells, 1}});
    const Homogeneous skin{PlaneStress{rubber}, thickness};
    return Explicit{Scene{mesh.nodes, Part{Plate4{}, skin, mesh.quadrilaterals}}, {}, in<double>}.warnings();
  };
  for (const double thickness : {1e-3, 0.1, 0.49}) CHECK(warnings(thickness, 4).empty());
  CHECK(warnings(0.6, 4) == std::vector<std::string>{"4 of 4 plates of part 0 are thicker than twice their shortest "
                                                     "edge, most of all element 0 (thickness 0.6, edge 0.25): waves "
                                                     "that short are beyond the theory of plates; take larger plates, "
                                                     "or solids."});
  CHECK(warnings(1e-5, 1) == std::vector<std::string>{"1 of 1 plates of part 0 are thinner than 1e-4 of their shortest "
                                                      "edge, most of all element 0 (thickness 1e-05, edge 1): they do "
                                                      "not bend; if that is not meant, look whether all lengths have "
                                                      "one unit."});
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
