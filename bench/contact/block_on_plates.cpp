// The cost of contact where all of a surface strikes at once: a block of 32 x 32 x 16 hexahedra on 64 x 64 plates,
// flat, from the first pairs on. Runs take turns of ten steps; of each turn the quickest of the repeats counts.
//
//   build/bench/bench/block_on_plates [repeats=7]
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <strike/motion/openmp.hpp>
#include <strike/strike.hpp>

#include "../support/clock.hpp"
#include "../support/materials.hpp"
#include "../support/table.hpp"
#include "support/options.hpp"

namespace {

using namespace strike;
using namespace bench;

/// A contact that measures its own time.
template <class Law, class Friction>
class Timed : public Contact<Everything, Law, Friction> {
 public:
  using Contact<Everything, Law, Friction>::Contact;

  void resolve_contact(auto&... arguments) {
    seconds_ += wall_seconds([&] { Contact<Everything, Law, Friction>::resolve_contact(arguments...); });
  }
  double stable_step(double dt, const auto& nodes) {
    double step = 0;
    seconds_ += wall_seconds([&] { step = Contact<Everything, Law, Friction>::stable_step(dt, nodes); });
    return step;
  }
  double take_seconds() { return std::exchange(seconds_, 0.0); }

 private:
  double seconds_ = 0;
};

constexpr std::size_t per_turn = 10, turns = 40;  // steps of a turn, turns of a run

/// The least time of each turn over the repeats [s].
class Quickest {
 public:
  Quickest() { seconds_.fill(std::numeric_limits<double>::infinity()); }
  void take(std::size_t turn, double seconds) { seconds_[turn] = std::min(seconds_[turn], seconds); }
  /// That of a step, the mean over the first turns [s].
  double of_step(std::size_t first_turns) const {
    double sum = 0;
    for (std::size_t t = 0; t < first_turns; ++t) sum += seconds_[t];
    return sum / static_cast<double>(first_turns * per_turn);
  }

 private:
  std::array<double, turns> seconds_;
};
struct Price {
  Quickest contact, rest;
  std::array<std::size_t, turns> pairs{};
};

template <class Law, class Friction>
auto strike_plates(int threads, const Law& law, const Friction& friction) {
  constexpr double h = 1e-3;
  Mesh mesh = rectangle({.size = {64 * h, 64 * h}, .cells = {64, 64}});
  const Index first = append(
      mesh, translated(box({.size = {33 * h, 33 * h, 16 * h}, .cells = {32, 32, 16}}), {15.3 * h, 15.7 * h, 0.52 * h}));
  std::vector<Index> block;
  for (Index i = first; i < mesh.nodes.size(); ++i) block.push_back(i);
  Explicit run{
      Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{Solid{linear, hardening}}, h}, mesh.quadrilaterals},
            Part{Hex8{ViscousHourglass{}}, Solid{linear, hardening}, mesh.hexahedra},
            InitialVelocity{{0.3, 0.2, -20}, block}, Timed<Law, Friction>(Everything{}, law, friction)},
      ExplicitOptions{.print_warnings = false}, OpenMP{.threads = threads}};
  while (run.template contact<0>().pairs().size() < 10) run.step();
  run.template contact<0>().take_seconds();
  return run;
}

void take_turn(auto& run, std::size_t turn, Price& price) {
  price.pairs[turn] = 0;
  const double all = wall_seconds([&] {
    for (std::size_t i = 0; i < per_turn; ++i)
      run.step(), price.pairs[turn] += run.template contact<0>().pairs().size();
  });
  const double contact = run.template contact<0>().take_seconds();
  price.contact.take(turn, contact), price.rest.take(turn, all - contact);
}

template <class Law, class Friction>
std::array<Price, 2> measure(std::size_t repeats, const Law& law, const Friction& friction) {
  std::array<Price, 2> prices;  // on one thread and on two
  for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
    auto one = strike_plates(1, law, friction), two = strike_plates(2, law, friction);
    for (std::size_t turn = 0; turn < turns; ++turn) take_turn(one, turn, prices[0]), take_turn(two, turn, prices[1]);
  }
  return prices;
}

void print(const char* name, const std::array<Price, 2>& prices) {
  const auto& [one, two] = prices;
  for (const std::size_t first_turns : {std::size_t{2}, turns}) {
    double pairs = 0;
    for (std::size_t t = 0; t < first_turns; ++t) pairs += static_cast<double>(one.pairs[t]);
    const double steps = static_cast<double>(first_turns * per_turn), contact = one.contact.of_step(first_turns),
                 rest = one.rest.of_step(first_turns), contact_of_two = two.contact.of_step(first_turns),
                 rest_of_two = two.rest.of_step(first_turns);
    std::fputs(row({name, formatted("%.0f", steps), formatted("%.0f", pairs / steps), formatted("%.2f", 1e3 * rest),
                    formatted("%.2f", 1e3 * contact), formatted("%.2f", contact / rest),
                    formatted("%.2f x", contact / contact_of_two), formatted("%.2f x", rest / rest_of_two),
                    formatted("%.2f x", (contact + rest) / (contact_of_two + rest_of_two))})
                   .c_str(),
               stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::size_t repeats = options.count("repeats", 7);
    options.check();
    std::fputs(head({"", "steps", "pairs", "rest of a step [ms]", "contact [ms]", "contact / rest",
                     "contact on two threads", "rest on two", "step on two"})
                   .c_str(),
               stdout);
    print("`Kinematic`", measure(repeats, Kinematic{}, Frictionless{}));
    print("`Penalty`", measure(repeats, Penalty{}, Frictionless{}));
    print("`Kinematic`, friction", measure(repeats, Kinematic{}, Coulomb{0.3}));
  });
}
