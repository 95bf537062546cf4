#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/particle.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/particles.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/output/vtu.hpp>
#include <strike/section/layered.hpp>

#include "examples/own_element/truss.hpp"
#include "scratch.hpp"
#include "support/catch.hpp"
#include <sys/wait.h>

using namespace strike;

namespace {

const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1},
                  VonMises{.shear_modulus = 0.4, .yield_stress = 0.02, .hardening_modulus = 0.01}};
const Wire wire{.density = 1, .youngs_modulus = 1, .yield_stress = 0.5, .initial_stress = 0.1};

/// Bytes from base64 (RFC 4648).
std::string decoded(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;
    word = word << 6 | static_cast<std::uint32_t>(digit);
    if ((bits += 6) >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 255);
  }
  return bytes;
}

/// The numbers of an array of a VTU file, by its name.
template <class Number>
std::vector<Number> array_of(const std::string& file, const std::string& name) {
  const std::size_t head = file.find("Name=\"" + name + "\"");
  REQUIRE(head != std::string::npos);
  const std::size_t first = file.find('>', head) + 1;
  const std::string bytes = decoded(std::string_view(file).substr(first, file.find('<', first) - first));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  REQUIRE(bytes.size() == size + sizeof size);
  std::vector<Number> numbers(size / sizeof(Number));
  if (size > 0) std::memcpy(numbers.data(), bytes.data() + sizeof size, size);
  return numbers;
}

/// A torn bar of cubes, a bar of tetrahedra, a plate and two wires, in one scene. Erosion starts at a plastic strain.
struct Bodies {
  Mesh cubes = box({.size = {8, 1, 1}, .cells = {8, 1, 1}}), mesh = cubes;
  Cells<4> tetrahedra, plates;
  Cells<2> wires;
  std::vector<Index> moving;

  Bodies() {
    const Mesh solid = tetrahedralized(box({.size = {2, 1, 1}, .cells = {2, 1, 1}}));
    const Mesh plate = sheet({2, 2}, [](double s, double t) { return Eigen::Vector3d(2 * s, 2 * t, 0); });
    append(mesh, translated(solid, {0, 5, 0}));
    append(mesh, translated(plate, {0, 10, 0}));
    tetrahedra = mesh.tetrahedra, plates = mesh.quadrilaterals;
    const auto first = static_cast<Index>(mesh.nodes.size());
    for (int i = 0; i < 3; ++i) mesh.nodes.emplace_back(i, 20, 0);
    wires = {{first, first + 1}, {first + 1, first + 2}};
    for (Index i = 0; i < mesh.nodes.size(); ++i)
      if (mesh.nodes[i].x() > 4) moving.push_back(i);
  }

  template <class... Policies>
  auto run(const Erosion& erosion, const Policies&... policies) const {
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{}, metal, cubes.hexahedra, erosion}, InitialVelocity{{0.3, 0.02, 0}, moving},
              Part{Tet4{}, metal, tetrahedra}, Part{Plate4{}, Homogeneous{PlaneStress{metal}, 0.1}, plates},
              Part{Truss{.area = 0.1}, wire, wires}},
        ExplicitOptions{.step_factor = 0.3}, policies...};
  }
};

/// Compares a file with the run that has written it.
template <class Run>
void check_file(const std::string& file, const Run& run) {
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> kinds;
  std::vector<double> parts, stresses, strains;
  constexpr std::uint8_t kind_of_part[] = {12, 10, 9, 3};  // VTK_HEXAHEDRON, VTK_TETRA, VTK_QUAD, VTK_LINE
  run.each_part([&]<class Part>(const Part& part) {
    const auto alive = part.alive();
    const auto cells = part.cells(run.nodes());
    const auto strain = part.field(PlasticStrain{});
    const auto stress = part.field([](const auto& s) {
      using T = typename Part::Number;
      if constexpr (requires { s.stress.zz; })
        return SymmetricTensor<T>(s.stress);
      else if constexpr (requires { s.stress.xx; })
        return SymmetricTensor<T>{.xx = s.stress.xx, .yy = s.stress.yy, .zz = T(0.0), .xy = s.stress.xy};
      else if constexpr (requires { T(s.stress); })
        return SymmetricTensor<T>{.xx = T(s.stress)};
      else
        return SymmetricTensor<T>::isotropic(T(0.0));
    });
    for (std::size_t e = 0; e < cells.size(); ++e) {
      if (!alive[e]) continue;
      for (const Index node : cells[e]) connectivity.push_back(static_cast<std::int32_t>(node));
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
      kinds.push_back(kind_of_part[part.number()]);
      parts.push_back(static_cast<double>(part.number()));
      const SymmetricTensor<double>& s = stress[e];
      stresses.insert(stresses.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
      strains.push_back(strain[e]);
    }
  });
  std::vector<double> positions, velocities;
  for (const Eigen::Vector3d& x : run.positions()) positions.insert(positions.end(), {x.x(), x.y(), x.z()});
  for (const Eigen::Vector3d& v : run.velocities()) velocities.insert(velocities.end(), {v.x(), v.y(), v.z()});
  CHECK(array_of<std::int32_t>(file, "connectivity") == connectivity);
  CHECK(array_of<std::int32_t>(file, "offsets") == offsets);
  CHECK(array_of<std::uint8_t>(file, "types") == kinds);
  CHECK(array_of<double>(file, "part") == parts);
  CHECK(array_of<double>(file, "stress") == stresses);
  CHECK(array_of<double>(file, "equivalent plastic strain") == strains);
  CHECK(array_of<double>(file, "Points") == positions);
  CHECK(array_of<double>(file, "velocity") == velocities);
  CHECK(array_of<double>(file, "TimeValue") == std::vector{run.time()});
}

}  // namespace

TEST_CASE("film: the state of a run of hexahedra, tetrahedra, plates and own elements, without deleted cells") {
  const ScratchFolder folder("vtu-run");
  const Bodies bodies;
  auto run = bodies.run(Erosion{.strain = 0.2});
  VtuSeries film(folder / "film");
  film.write(run);
  CHECK(array_of<std::uint8_t>(content_of(folder / "film_0000.vtu"), "types").size() ==
        8 + bodies.tetrahedra.size() + 4 + 2);
  check_file(content_of(folder / "film_0000.vtu"), run);
  run.until(5);
  film.write(run);
  const auto& cubes = run.part<0>();
  CHECK((cubes.deleted() > 0 && cubes.deleted() < 8));
  const std::string file = content_of(folder / "film_0001.vtu");
  CHECK(array_of<std::uint8_t>(file, "types").size() == 8 - cubes.deleted() + bodies.tetrahedra.size() + 4 + 2);
  check_file(file, run);
  CHECK(film.times() == std::vector{0.0, run.time()});
}

TEST_CASE("film: a foreign reader finds particles beside hexahedra, each with its place and fields, none deleted") {
  const ScratchFolder folder("vtu-particles");
  const Mesh cubes = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  Mesh mesh = cubes;
  const Index first = append(mesh, translated(particles(BoxShape{.size = {6, 2, 2}, .cells = {6, 2, 2}}), {0, 5, 0}));
  std::vector<Index> right;  // the right half of the particles flies into the left
  for (Index i = first; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i].x() > 3) right.push_back(i);
  const auto& of_particles = mesh.particles;
  Explicit run{Scene{mesh.nodes, Part{Particle{}, metal, of_particles, Erosion{.strain = 0.1}},
                     Part{Hex8{}, metal, cubes.hexahedra}, InitialVelocity{{-0.3, 0, 0}, right},
                     InitialVelocity{{0.1, 0, 0}, {0, 3, 6, 9}}},
               ExplicitOptions{.step_factor = 0.3}};
  const auto& cloud = run.part<0>();
  while (cloud.deleted() < 5 && run.time() < 20) run.step();
  REQUIRE((cloud.deleted() >= 5 && cloud.deleted() < cloud.size()));

  write_vtu(folder / "a.vtu", run);
  const std::string script = (std::filesystem::path(__FILE__).parent_path() / "list_vtu.py").string();
  const std::string command =
      "/usr/bin/python3 '" + script + "' '" + folder / "a.vtu" + "' > '" + folder / "list" + "' 2> /dev/null";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == 77 || code == 127) {
    WARN("No meshio in Python: values not compared.");
    return;
  }
  REQUIRE(code == 0);
  std::istringstream list(content_of(folder / "list"));
  run.each_part([&](const auto& part) {
    const auto alive = part.alive();
    const auto cells = part.cells(run.nodes());
    const auto strain = part.field(PlasticStrain{});
    const auto stress = part.field(StressTensor{});
    for (std::size_t e = 0; e < cells.size(); ++e) {
      if (!alive[e]) continue;
      std::string kind;
      std::vector<double> found(3 + 3 * cells[e].size()), wanted{double(part.number()), strain[e], stress[e].xx};
      list >> kind;
      for (double& number : found) list >> number;
      for (const Index node : cells[e])
        for (int c = 0; c < 3; ++c) wanted.push_back(run.nodes().x(node)[c]);
      CHECK(kind == (cells[e].size() == 1 ? "vertex" : "hexahedron"));
      CHECK(found == wanted);  // to the last bit
    }
  });
  std::string more;
  CHECK(list);
  CHECK_FALSE(list >> more);
}

TEST_CASE("film: a part whose elements are all deleted leaves the others") {
  const ScratchFolder folder("vtu-deleted");
  const Bodies bodies;
  auto run = bodies.run(Erosion{.step = 100});  // far above their stable step
  run.step();
  CHECK(run.part<0>().deleted() == 8);
  write_vtu(folder / "a.vtu", run);
  check_file(content_of(folder / "a.vtu"), run);
}

TEST_CASE("film: no cell at all") {
  const ScratchFolder folder("vtu-empty");
  const Mesh cube = box({.size = {1, 1, 1}});
  Explicit run{Scene{cube.nodes, Part{Hex8{}, metal, cube.hexahedra, Erosion{.step = 100}}},
               ExplicitOptions{.largest_step = 0.01}};
  run.step();
  CHECK(run.part<0>().deleted() == 1);
  write_vtu(folder / "a.vtu", run);
  check_file(content_of(folder / "a.vtu"), run);
}

TEST_CASE("film: single precision, and numbers with derivatives, are written as doubles") {
  const ScratchFolder folder("vtu-numbers");
  const Mesh cube = box({.size = {1, 1, 1}});
  const auto check_in = [&](auto number) {
    Explicit run{Scene{cube.nodes, Part{Hex8{}, metal, cube.hexahedra, Erosion{.strain = 5}},
                       InitialVelocity{{0, 0, 0.1}, {4, 5, 6, 7}}},
                 ExplicitOptions{.step_factor = 0.3}, number};
    run.until(1);
    write_vtu(folder / "a.vtu", run);
    check_file(content_of(folder / "a.vtu"), run);
  };
  check_in(in<Pack<float>>);
  check_in(in<Dual<Pack<double>, 2>>);
}

TEST_CASE("film: a frame that cannot be written is not in the lists") {
  const ScratchFolder folder("vtu-failed");
  const Mesh cube = box({.size = {1, 1, 1}});
  VtuSeries film(folder / "film");
  film.write(0, cube, cube.nodes);
  CHECK_THROWS(film.write(1, cube, cube.nodes, {{"too few", std::vector<double>{1}}}));
  CHECK(film.times() == std::vector{0.0});
}

TEST_CASE("vtu of a run: rigid bodies follow the parts, where they have moved to") {
  Mesh both = box({.size = {1, 1, 1}, .cells = {1, 1, 2}});
  const Cells<8> elastic{both.hexahedra[0]}, rigid{both.hexahedra[1]};
  Explicit run{Scene{both.nodes, Part{Hex8{}, metal, elastic}, RigidBody{Mesh{both.nodes, rigid}, 1},
                     InitialVelocity{{0, 0, 1}}}};
  run.until(0.5);
  const ScratchFolder folder("vtu_bodies");
  write_vtu(folder / "run.vtu", run);
  const std::string file = content_of(folder / "run.vtu");
  CHECK(array_of<double>(file, "part") == std::vector<double>{0, 1});
  CHECK(array_of<double>(file, "Points").at(2) == Approx(0.5));
}
