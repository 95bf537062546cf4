// Runs of plates with fibres and of Plies: to the bit by any number of threads and from a checkpoint, near in other
// numbers and cycles, and with erosion.
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/subcycling.hpp>
#include <strike/element/plate4.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/point_values.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/plies.hpp"

using namespace strike;
using testing::carbon, testing::carbon_hashin;

namespace {

struct Blow {
  template <class N>
  void begin(N& nodes) const {
    for (const std::size_t i : {52u, 53u, 62u, 63u}) nodes.set_velocity(i, {1e4, -1e4, 3e5});
  }
  template <class Archive>
  void serialize(Archive&) {}
};

template <class Section, class... Policies>
auto struck_to(double strain, const Section& section, const Policies&... policies) {
  const Mesh mesh = rectangle({.size = {36, 40}, .cells = {9, 10}});
  return Explicit{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals, Erosion{.strain = strain}}, Blow{}},
                  ExplicitOptions{}, policies...};
}
template <class Section, class... Policies>
auto struck(const Section& section, const Policies&... policies) {
  return struck_to(0.02, section, policies...);
}
auto laminate() { return testing::of_four(FailingPly{carbon, carbon_hashin}, 0.25, {0, 45, -45, 90}); }
constexpr double end = 2e-5;

/// How far the middle has gone, and what has failed.
template <class Run>
std::pair<double, double> outcome(Run&& run) {
  run.until(end);
  double fibres = 0;
  for (const double x : run.template part<0>().field(Failed{})) fibres += x;
  CHECK(run.template part<0>().deleted() > 0);
  CHECK(std::abs(run.energy().error()) < 0.01);
  return {run.nodes().x(75).z(), fibres};
}

template <class Make>
void goes_on_to_the_bit(const Make& make) {
  const ScratchFolder folder("fibres");
  const auto content = [&](const std::string& name) {
    std::ifstream file(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  auto whole = make();
  whole.until(end);
  write_checkpoint(folder / "whole", whole);
  CHECK(whole.template part<0>().deleted() > 0);
  auto first = make();
  first.until(end / 2);
  write_checkpoint(folder / "half", first);
  auto second = make();
  read_checkpoint(folder / "half", second);
  auto other = make();  // stops where the first did, for the last step to it is shorter
  other.until(end / 2), other.until(end);
  second.until(end);
  write_checkpoint(folder / "second", second);
  write_checkpoint(folder / "other", other);
  CHECK(content("second") == content("other"));
}

}  // namespace

TEST_CASE("fibres: the same bits by one thread and by three") {
  auto one = struck(laminate(), in<Pack<double, 4>>, OpenMP{.threads = 1}),
       three = struck(laminate(), in<Pack<double, 4>>, OpenMP{.threads = 3});
  one.until(end), three.until(end);
  for (std::size_t i = 0; i < one.nodes().size(); ++i) CHECK(one.nodes().x(i) == three.nodes().x(i));
  CHECK(one.part<0>().field(MatrixFailed{}) == three.part<0>().field(MatrixFailed{}));
}

// Which ply fails first depends on rounding, and what follows on that.
TEST_CASE("fibres: near the same in single precision, and with cycles of their own") {
  const auto [z, fibres] = outcome(struck(laminate()));
  CHECK(fibres > 0.5);
  const auto near = [z = z, fibres = fibres](const std::pair<double, double>& other) {
    CHECK(other.first == Approx(z).epsilon(0.05));
    CHECK(other.second == Approx(fibres).epsilon(0.1));
  };
  near(outcome(struck(laminate(), in<Pack<float>, double>)));
  near(outcome(struck(laminate(), in<Pack<float>>)));
  near(outcome(struck(laminate(), Subcycling{})));
}

TEST_CASE("fibres: a run with erosion goes on from a checkpoint to the bit") {
  goes_on_to_the_bit([] { return struck(laminate()); });
}
TEST_CASE("plies whose number is known when the program runs go on from a checkpoint and are eroded") {
  const PlaneStress glass{Elastic{.density = 2.5e-9, .youngs_modulus = 70e3, .poissons_ratio = .22}};
  goes_on_to_the_bit([&] {
    return struck_to(0.001, Layered{Plies{Layer{glass, 0.25, Gauss<2>{}}, 4}, InstantaneousShear{}});
  });
  goes_on_to_the_bit([&] {
    const FailingPly ply{carbon, carbon_hashin};
    return struck(Layered{PlyStack{{Ply{ply, 0.25, -45}, Ply{ply, 0.2}, Ply{ply, 0.3, 90}, Ply{ply, 0.25, 45}}},
                          FibreDirection{{1, 1, 0}}});
  });
}
