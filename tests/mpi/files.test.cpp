// Files that several processes write have the bytes that one alone gives them, and a run goes on from a checkpoint on
// another number of processes.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "conformance/numbers.hpp"
#include "mpi/same_bits.hpp"

using namespace strike;

namespace {

const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                   VonMises{.shear_modulus = 43, .yield_stress = .4, .hardening_modulus = .1}};
const Mesh bar = box({.size = {2, 2, 8}, .cells = {8, 8, 32}});

auto scene() {
  return Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra, Erosion{.strain = .3}},
               Part{Plate4{}, Homogeneous{PlaneStress{copper}, .05}, Cells<4>{{0, 1, 10, 9}, {1, 2, 11, 10}}},
               InitialVelocity{{0, 0, -250}}, RigidWall{{0, 0, 0}, {0, 0, 1}}};
}
/// An item of a user that gives a node a velocity, and does not tell the work.
struct Thrown {
  double speed;

  template <class N>
  void constrain(N& nodes, const Step&, Ledger&) const {
    nodes.set_velocity(1300, {0, 0, speed});
  }
  void serialize(auto&) {}
};
std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
/// A run to some time with everything that it writes.
template <class Run>
void written(Run& run, double end, const std::string& name) {
  History history{name + ".csv", {{"time", "ms"}, {"length", "mm"}}};
  VtuSeries film{name};
  run.until(end, Every{end / 7, [&] { history.row(run.time(), run.positions().back().z()); }},
            Every{end / 3, [&] {
                    film.write(run.time(), bar, run.positions(), {{"velocity", run.velocities()}},
                               {{"strain", run.template part<0>().field(
                                               [](const auto& s) { return s.equivalent_plastic_strain; })}});
                  }});
  write_checkpoint(name + ".checkpoint", run, history, film);
}
auto alone() { return Explicit{scene(), {.print_warnings = false}, Mpi{MPI_COMM_SELF}}; }
auto together() { return Explicit{scene(), {.print_warnings = false}, Mpi{}}; }

}  // namespace

TEST_CASE("files have the same bytes, and runs go on from them on any number of processes") {
  constexpr double end = 2e-3;
  auto one = alone();
  written(one, end, "alone");
  auto all = together();
  written(all, end, "together");
  for (const char* extension : {".csv", ".checkpoint", "_0000.vtu", "_0003.vtu"}) {
    INFO(extension);
    const std::string by_one = content("alone" + std::string(extension));
    CHECK(testing::everywhere(by_one.size() > 20));
    CHECK(testing::everywhere(by_one == content("together" + std::string(extension))));
  }
  auto from_one = together(), from_all = together();
  auto by_one = alone();
  write_checkpoint("run_alone.checkpoint", one), write_checkpoint("run_together.checkpoint", all);
  read_checkpoint("run_alone.checkpoint", from_one), read_checkpoint("run_together.checkpoint", from_all);
  read_checkpoint("run_together.checkpoint", by_one);
  for (int n = 0; n < 30; ++n) one.step(), from_one.step(), from_all.step(), by_one.step();
  CHECK(one.template part<0>().deleted() > 0);
  for (const std::string& bytes :
       {testing::bytes_of(from_one).kept, testing::bytes_of(from_all).kept, testing::bytes_of(by_one).kept})
    CHECK(testing::everywhere(bytes == testing::bytes_of(one).kept));
}

TEST_CASE("a disk without room ends all processes with the same sentence") {
  const auto refused = [](const auto& f) {
    std::string sentence;
    try {
      f();
    } catch (const Error& error) {
      sentence = error.what();
    }
    return testing::everywhere(sentence.find("strike: the file '") == 0) && testing::all_have(sentence);
  };
  History history{"/dev/full", {{"time", "ms"}}};
  CHECK(refused([&] { history.row(1.0); }));
  CHECK(refused([&] { detail::replace_file("/dev/full", "some text"); }));
  CHECK(refused([&] { History{"/proc/none/history.csv", {{"time", "ms"}}}; }));
}

TEST_CASE("an element that is inverted, and a balance that is lost, end all processes with the same sentence") {
  const auto refused = [](double speed, const char* words) {
    std::string sentence;
    try {
      Explicit run{
          Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra}, Thrown{speed}}, {.print_warnings = false}, Mpi{}};
      for (int n = 0; n < 50; ++n) run.step();
    } catch (const Error& error) {
      sentence = error.what();
    }
    INFO(sentence);
    CHECK(testing::everywhere(sentence.find(words) != std::string::npos));
    CHECK(testing::all_have(sentence));
  };
  refused(1e6, "inverted");
  refused(10, "energy balance");
}

TEST_CASE("wrong numbers of threads are refused") {
  testing::WrongNumbers tried;
  testing::refuses_wrong_numbers(Mpi{MPI_COMM_WORLD, OpenMP{1}}, tried,
                                 [](const auto& changed) { return Method(changed).execution.ranks().size() > 0; });
}
