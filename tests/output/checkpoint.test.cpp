#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/output/history.hpp>
#include <strike/output/vtu.hpp>
#include <strike/section.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include <sys/wait.h>
#include <unistd.h>

using namespace strike;

namespace {

const LinearEos copper_eos{.density = 8.93e-6, .bulk_modulus = 130};
const VonMises copper_strength{.shear_modulus = 43.3, .yield_stress = 0.4, .hardening_modulus = 0.1};

/// Everything at once: a body of tetrahedra that erodes strikes a layered plate on supports, with springs and friction.
auto bird_strike(Index cells = 5) {
  Mesh plate = rectangle({.size = {40, 40}, .cells = {cells, cells}});
  const Mesh body = translated(tetrahedralized(box({.size = {10, 10, 10}, .cells = {2, 2, 2}})), {14, 15, 1.2});
  const Index first = append(plate, body);
  std::vector<Index> bird;
  for (Index i = 0; i < body.nodes.size(); ++i) bird.push_back(first + i);
  const Solid soft{CubicEos{.density = 1e-6, .C1 = 2, .C2 = 6, .C3 = 10},
                   VonMises{.shear_modulus = 0.02, .yield_stress = 2e-3}, FailureStrain{0.8}};
  const Solid layer{copper_eos, copper_strength};
  return Scene{plate.nodes,
               Part{Plate4{}, Homogeneous{PlaneStress{layer}, 1.0}, plate.quadrilaterals},
               Part{Tet4{}, soft, plate.tetrahedra, Erosion{.strain = 0.7}},
               InitialVelocity{{0, 5, -150}, bird},
               Clamped{nodes_where(plate.nodes, [](const auto& x) { return x.x() < 1e-9 && x.z() == 0; })},
               Contact{NodeToSurface{bird, plate_surface(plate.quadrilaterals, 1.0, 0)}, Penalty{.fraction = 0.2},
                       Coulomb{0.3}}};
}

/// A bar on a wall, elements in single precision, under the step of the mesh.
template <class... Policies>
auto bar(Index layers, const Policies&... policies) {
  const Mesh mesh = box({.size = {2, 2, 6}, .cells = {2, 2, layers}});
  const auto top = nodes_where(mesh.nodes, on_plane(Axis::z, 6));
  return Explicit{Scene{mesh.nodes, Part{Hex8{}, Solid{copper_eos, copper_strength}, mesh.hexahedra},
                        InitialVelocity{{0, 0, -227}}, Symmetry{Axis::x, nodes_where(mesh.nodes, on_plane(Axis::x, 0))},
                        RigidWall{{0, 0, 0}, {0, 0, 1}, 0.1}, NodalForce{{0, 0, -0.1}, top, Curve{{{0, 0}, {1, 1}}}}},
                  ExplicitOptions{}, in<Pack<float>, double>, policies...};
}
auto bar(Index layers = 6) { return bar(layers, GlobalStep{}); }

constexpr std::size_t none = std::string::npos;
/// Where two files differ first.
std::size_t first_difference(const std::string& a, const std::string& b) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return at == a.end() && other == b.end() ? none : static_cast<std::size_t>(at - a.begin());
}

/// What a run has become after so many steps, as the bytes of a checkpoint, and of another that went on from one that
/// was written on the way. Returns the first.
template <class Make>
auto goes_on_to_the_bit(const Make& make, double end) {
  const ScratchFolder folder("checkpoint");
  auto whole = make();
  whole.until(end);
  const std::size_t steps = whole.steps();
  INFO(steps << " steps");
  CHECK(steps > 60);
  write_checkpoint(folder / "whole", whole);
  const std::string whole_content = content_of(folder / "whole");
  for (const std::size_t k : {steps / 7, steps / 2, steps - 1}) {
    auto first = make();
    first.until(end, StopWhen{[&] { return first.steps() == k; }});
    write_checkpoint(folder / "half", first);
    auto second = make();
    read_checkpoint(folder / "half", second);
    CHECK(second.steps() == k);
    CHECK(second.energy().error() == first.energy().error());
    second.until(end);
    CHECK(second.steps() == steps);
    write_checkpoint(folder / "second", second);
    CHECK(first_difference(content_of(folder / "second"), whole_content) == none);
  }
  return whole;
}

struct Own {
  int a;
  std::vector<std::vector<double>> rows;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(a, rows);
  }
  bool operator==(const Own&) const = default;
};

struct Moving {
  std::vector<Eigen::Vector3d> x = {};
  const std::vector<Eigen::Vector3d>& positions() const { return x; }
  const std::vector<Eigen::Vector3d>& velocities() const { return x; }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(x);
  }
};

}  // namespace

TEST_CASE("checkpoint: a strike with plates, eroding tetrahedra, springs and friction goes on to the bit") {
  const auto run = goes_on_to_the_bit([] { return Explicit{bird_strike()}; }, 0.12);
  CHECK(run.item<1>().deleted() > 0);
  CHECK(run.item<4>().impulse().z() > 0);
  CHECK(run.energy().friction > 0);
}

TEST_CASE("checkpoint: the same under subcycling, plates slow, goes on to the bit within a cycle") {
  const auto run = goes_on_to_the_bit([] { return Explicit{bird_strike(3), {}, Subcycling{}}; }, 0.12);
  CHECK(run.cycle().multiple() > 1);
  CHECK(run.item<1>().deleted() > 0);
}

TEST_CASE("checkpoint: the same under the step of the mesh goes on to the bit, and is the same on two threads") {
  const GlobalStep bound{.price = 0.05};  // so cheap that it is estimated again and again
  const auto run = goes_on_to_the_bit([&] { return Explicit{bird_strike(), {}, bound}; }, 0.12);
  CHECK(run.step_bound().estimates() > 2);
  CHECK(run.item<1>().deleted() > 0);
  Explicit threads{bird_strike(), {}, bound, OpenMP{2}};
  threads.until(0.12);
  CHECK(threads.steps() == run.steps());
  CHECK(threads.positions() == run.positions());
}

TEST_CASE("checkpoint: a bar in mixed precision under the step of the mesh goes on to the bit") {
  const auto run = goes_on_to_the_bit([] { return bar(); }, 0.02);
  CHECK(run.step_bound().estimates() > 1);
}

TEST_CASE("checkpoint: cubes that touch by nodes and by edges, in the middle of touches, go on to the bit") {
  const auto make = [](const auto& law) {
    Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
    const Mesh upper = rotated(box({.lower = {0.2, 0.1, 1.01}, .size = {1, 1, 1}, .cells = {2, 2, 2}}), {0, 0, 1}, 0.3);
    append(mesh, upper);
    const Cells<8> one(mesh.hexahedra.begin(), mesh.hexahedra.begin() + 1),
        other(mesh.hexahedra.begin() + 1, mesh.hexahedra.end());
    const std::vector<Index> falling = nodes_where(mesh.nodes, [](const auto& x) { return x.z() > 1.005; });
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{}, Elastic{1, 1000, 0.3}, mesh.hexahedra}, InitialVelocity{{0.5, 0.2, -1}, falling},
              Contact{TwoWay{Surface{hexahedron_surface(one)}, Surface{hexahedron_surface(other)}}, law, Coulomb{0.3}}},
        ExplicitOptions{.step_factor = 0.3, .energy_tolerance = 1}};
  };
  const auto run = goes_on_to_the_bit([&] { return make(Kinematic{}); }, 0.6);
  CHECK(run.item<2>().impulse().norm() > 0.1);
  CHECK(run.energy().friction > 0);
  goes_on_to_the_bit([&] { return make(Penalty{}); }, 0.6);
}

TEST_CASE("checkpoint: an archive takes numbers, lists, tuples and what serializes itself") {
  const ScratchFolder folder("checkpoint");
  double number = 0.1;
  std::string text = "text";
  std::vector<Own> own{{1, {{1, 2}, {}}}, {2, {}}};
  std::tuple<float, std::array<Eigen::Vector3d, 2>> both{2.5f, {{{1, 2, 3}, {4, 5, 6}}}};
  const auto before = std::tuple(number, text, own, both);
  write_checkpoint(folder / "c", number, text, own, both);
  number = 0, text = "", own = {}, both = {};
  read_checkpoint(folder / "c", number, text, own, both);
  CHECK(std::tuple(number, text, own, both) == before);
}

TEST_CASE("checkpoint: what is not whole, foreign or of another scene is refused in a sentence, and changes nothing") {
  using Catch::Matchers::ContainsSubstring;
  const ScratchFolder folder("checkpoint");
  const std::string path = folder / "c";
  std::vector<double> numbers(300000, 1.5);  // more than a piece
  write_checkpoint(path, numbers);
  const std::string whole = content_of(path);
  const auto put = [&](const std::string& content) { std::ofstream(path, std::ios::binary) << content; };
  const auto refusal = [&] {
    std::vector<double> other{7};
    try {
      read_checkpoint(path, other);
    } catch (const Error& error) {
      CHECK(other == std::vector<double>{7});
      return std::string(error.what());
    }
    return std::string("none");
  };
  CHECK(refusal() == "none");
  for (const std::size_t size : {std::size_t{24}, std::size_t{30}, std::size_t{1} << 20, whole.size() - 1}) {
    put(whole.substr(0, size));
    CHECK_THAT(refusal(), ContainsSubstring("is cut short or damaged; take an older one, or start anew."));
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] ^= 1;
  put(damaged);
  CHECK_THAT(refusal(), ContainsSubstring("is cut short or damaged"));
  put("time [ms],length [mm]\n");
  CHECK_THAT(refusal(), ContainsSubstring("is none; give the path of a file that a Checkpoint has written."));
  std::string later = whole;
  later[8] = 9;
  put(later);
  CHECK_THAT(refusal(), ContainsSubstring("has the format 9 but this version of strike reads 1"));
  std::string turned = whole;
  std::reverse(turned.begin() + 12, turned.begin() + 16);
  put(turned);
  CHECK_THAT(refusal(), ContainsSubstring("is of another kind of machine"));
  CHECK_THROWS_WITH(read_checkpoint(folder / "none", numbers), ContainsSubstring("cannot be opened"));

  auto run = bar();
  write_checkpoint(path, run);
  auto another = bar(5);
  CHECK_THROWS_WITH(read_checkpoint(path, another), ContainsSubstring("is of another scene"));

  auto relaxed = bar(6, GlobalStep{}, DynamicRelaxation{});
  auto plain = bar(6);
  CHECK_THROWS_WITH(read_checkpoint(path, relaxed), ContainsSubstring("is of another scene"));
  write_checkpoint(folder / "relaxed", relaxed);
  CHECK_THROWS_WITH(read_checkpoint(folder / "relaxed", plain), ContainsSubstring("is of another scene"));

  const std::string before = content_of(path);
  Moving lost{.x = {{0, 0, 0}, {0, std::nan(""), 0}}};
  CHECK_THROWS_WITH(write_checkpoint(path, lost),
                    "strike: the position of node 1 is not finite, so that the checkpoint '" + path +
                        "' is not written: go on from the one before.");
  CHECK(content_of(path) == before);

  detail::replace_file(path, [&](detail::OutputFile& file) {  // as a program that does not look would leave it
    detail::CheckpointWriter archive(file);
    archive(lost);
    archive.finish();
  });
  Moving found;
  CHECK_THROWS_WITH(read_checkpoint(path, found), "strike: the position of node 1 is not finite in the checkpoint '" +
                                                      path + "': take an older one, or start anew.");
}

TEST_CASE("checkpoint: another constant, node, face or place of an item is another scene, and changes nothing") {
  struct Given {
    double yield_stress = 0.4, friction = 0.1, plane = 0.1, wall = 0, pressed = 6;
    Index layer = 6;  // of the nodes that a force acts on
  };
  const ScratchFolder folder("checkpoint_of_another");
  const std::string path = folder / "a";
  const Mesh mesh = box({.size = {2, 2, 6}, .cells = {2, 2, 6}});
  const auto faces_at = [&](double z) {
    std::vector<Face> faces = surface(mesh);
    std::erase_if(faces, [&](const Face& face) { return std::abs(centroid(mesh.nodes, face).z() - z) > 1e-9; });
    return faces;
  };
  const auto made = [&](const Given& is) {
    const VonMises strength{.shear_modulus = 43.3, .yield_stress = is.yield_stress, .hardening_modulus = 0.1};
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{}, Solid{copper_eos, strength}, mesh.hexahedra},
              RigidWall{{0, 0, is.wall}, {0, 0, 1}, is.friction},
              Contact{NodeToRigid{nodes_where(mesh.nodes, on_plane(Axis::z, 0)), RigidPlane{{0, 0, -1}, {0, 0, 1}}},
                      Coulomb{is.plane}},
              NodalForce{{0, 0, -0.1}, nodes_where(mesh.nodes, on_plane(Axis::z, is.layer))},
              Pressure{faces_at(is.pressed), Curve{{{0, 0}, {1, 1}}}}}};
  };
  auto run = made({});
  for (int n = 0; n < 3; ++n) run.step();
  write_checkpoint(path, run);
  for (const Given& other : {Given{.yield_stress = 0.5}, Given{.friction = 0.2}, Given{.plane = 0.2}, Given{.wall = -1},
                             Given{.pressed = 0}, Given{.layer = 5}}) {
    auto another = made(other);
    CHECK_THROWS_WITH(read_checkpoint(path, another), Catch::Matchers::ContainsSubstring("is of another scene"));
    CHECK(another.positions() == mesh.nodes);
    CHECK(another.time() == 0);
  }
  auto same = made({});
  read_checkpoint(path, same);
  CHECK(same.positions() == run.positions());
}

TEST_CASE("checkpoint: a run that is killed at any moment, again and again, leaves the files of one that was not") {
  const ScratchFolder folder("checkpoint");
  const auto go = [&](const std::string& name) {
    auto run = bar();
    const Mesh mesh = box({.size = {2, 2, 6}, .cells = {2, 2, 6}});
    History history{folder / (name + ".csv"), {{"time", "ms"}, {"kinetic", "J"}, {"rows before", ""}}};
    VtuSeries film{folder / name};
    double rows = 0;
    Checkpoint checkpoint{
        folder / (name + ".checkpoint"), {.interval = 2e-4, .restart = Restart::if_there}, history, film, rows};
    run.until(0.02, checkpoint,  //
              Every{1.1e-4, [&] { history.row(run.time(), run.energy().kinetic, rows++); }},
              Every{0.003, [&] { film.write(run.time(), mesh, run.positions()); }});
  };
  const auto survives = [&](int microseconds) {
    const pid_t child = ::fork();
    if (child == 0) {
      go("bar");
      std::_Exit(0);
    }
    ::usleep(static_cast<unsigned>(microseconds));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status);
  };
  std::filesystem::create_directory(folder / "whole");
  go("whole/bar");
  int deaths = 0;
  const int later = testing::is_sanitized() ? 4000 : 500;  // microseconds: all takes the longer there
  while (!survives(later * deaths)) ++deaths;              // later and later, so that it ends
  CHECK(deaths > 3);
  std::ofstream(folder / "bar.checkpoint.part") << "half a checkpoint";
  go("bar");  // from the last checkpoint to the end, where none is due
  for (const std::string file :
       {"bar.csv", "bar.pvd", "bar.vtu.series", "bar_0000.vtu", "bar_0003.vtu", "bar_0006.vtu"})
    CHECK(first_difference(content_of(folder / file), content_of(folder / ("whole/" + file))) == none);
  for (const auto& file : std::filesystem::directory_iterator(folder.path())) CHECK(file.path().extension() != ".part");
}
