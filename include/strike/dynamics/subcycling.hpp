#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

// The cycle in which parts are advanced, a policy of Explicit.
//
// Requirements.
//  1. Running<Nodes>                                  the cycle at work, constructed from the model, with
//     multiple()                                      steps of a cycle
//     is_complete() -> bool                           all parts are where the nodes are
//     begin(items, nodes) -> bool                     called once after the first forces: true if they are to be
//                                                     computed again, since parts have changed their pace
//     next_step(before, left) -> double               the step within a cycle that is not complete
//     drift(nodes, dt, execution)                     called after the nodes have moved
//     compute_forces(part, nodes, dt, ledger, execution) -> StableStep
//     add_warnings(items, warnings), serialize(archive)
//  2. needs_element_steps                             static constexpr bool: it works with ElementStep alone
//
// Models: NoSubcycling, Subcycling.
template <class C>
concept Cycle = std::copyable<C> && requires {
  typename C::template Running<Nodes<double>>;
  { C::needs_element_steps } -> std::convertible_to<bool>;
};

/// All parts are advanced in each step: the default.
struct NoSubcycling {
  static constexpr bool needs_element_steps = false;

  template <class Nodes>
  struct Running {
    explicit Running(NoSubcycling) {}
    static constexpr std::size_t multiple() { return 1; }
    static constexpr bool is_complete() { return true; }
    static constexpr bool begin(const auto&, const Nodes&) { return false; }
    static constexpr double next_step(double before, double) { return before; }
    static void drift(const Nodes&, double, const auto&) {}
    template <class Part, class Execution>
    static StableStep compute_forces(Part& part, Nodes& nodes, double dt, Ledger& ledger, const Execution& execution) {
      return part.compute_forces(nodes, dt, ledger, execution);
    }
    static void add_warnings(const auto&, std::vector<std::string>&) {}
    void serialize(auto&) {}
  };
};

/// Parts whose elements allow steps `multiple` times as large as the least are advanced in every `multiple`-th step
/// alone, over the whole cycle, and their forces act as impulses at its start and end (Tuckerman, Berne and Martyna
/// 1992). Such impulses set fast vibrations into resonance if these reach them (Biesiadecki and Skeel 1993), so that
/// those elements of a slow part that are near a fast one are advanced in each step too: what is too fast for a slow
/// part dies out there. The step is the same for a cycle, and the energies are those of the last one that is complete.
///   Explicit run{scene, options, Subcycling{}};
struct Subcycling {
  std::size_t largest = 8;  ///< multiple; which one saves most is found from the steps of the parts at the start
  std::size_t layers = 2;   ///< of elements of a slow part, from a fast one on, that are advanced in each step

  void ranges(const auto& number) const {
    number("largest", largest, range::between(1, 1000));
    number("layers", layers, range::between(0, 1000));
  }

  static constexpr bool needs_element_steps = true;
  template <class Nodes>
  class Running;
};

/// The cycle at work.
template <class Nodes>
class Subcycling::Running {
 public:
  explicit Running(const Subcycling& policy) : policy_(policy) {}

  /// Number of steps of a cycle.
  std::size_t multiple() const { return multiple_; }
  /// All parts are where the nodes are.
  bool is_complete() const { return done_ == 0; }

  /// Chooses the slow parts from the steps of all, and their elements that are near fast ones.
  template <class Items>
  bool begin(const Items& items, const Nodes& nodes) {
    choose(items);
    if (multiple_ == 1) return true;
    mean_.velocity.assign(nodes.places(), mean_.zero());
    if constexpr (Nodes::nodes_turn) mean_.angular_velocity = mean_.velocity;

    std::vector<bool> fast(nodes.size());
    each_part(items, [&](const auto& part, const Pace& pace) {
      if (pace.slow.empty())
        for_each_element(part, nodes, [&](std::size_t, const auto& corners) { mark(corners, fast); });
    });
    for (std::size_t layer = 0; layer < policy_.layers; ++layer) {
      const std::vector<bool> before = fast;
      each_part(items, [&](const auto& part, Pace& pace) {
        if (pace.slow.empty()) return;
        for_each_element(part, nodes, [&](std::size_t b, const auto& corners) {
          if (std::none_of(corners.begin(), corners.end(), [&](Index i) { return before[i]; })) return;
          pace.slow[b] = false;
          mark(corners, fast);
        });
      });
    }

    std::vector<bool> slow(nodes.size());
    each_part(items, [&](const auto& part, const Pace& pace) {
      for_each_element(part, nodes, [&](std::size_t b, const auto& corners) {
        if (!pace.slow.empty() && pace.slow[b]) mark(corners, slow);
      });
    });
    for (Index i = 0; i < nodes.size(); ++i)
      if (slow[i]) places_.push_back(i);
    return true;
  }

  /// The next step of a cycle that is not complete: as those before, but for the end of the run.
  double next_step(double before, double left) const {
    const double even = left / static_cast<double>(multiple_ - done_);
    return even < (1 + 1e-9) * before ? even : before;
  }

  /// Adds a step to the mean velocities of the nodes of slow parts.
  template <class Execution>
  void drift(const Nodes& nodes, double dt, const Execution& execution) {
    if (multiple_ == 1) return;
    const bool begins = is_complete();
    duration_ = begins ? dt : duration_ + dt;
    done_ = (done_ + 1) % multiple_;
    const Vector dt_ = static_cast<RealOf<Vector>>(dt),
                 per_duration = static_cast<RealOf<Vector>>(is_complete() ? 1 / duration_ : 1);
    detail::for_each_chunk(execution, places_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      const auto add = [&](const auto& v, auto& mean) {
        for (std::size_t k = first; k < last; ++k) {
          const Index i = places_[k];
          const Vector before = begins ? mean_.zero() : mean[i];
          mean[i] = per_duration * (before + dt_ * Vector(v[i]));
        }
      };
      add(nodes.velocity(), mean_.velocity);
      if constexpr (Nodes::nodes_turn) add(nodes.angular_velocity(), mean_.angular_velocity);
    });
  }

  template <class Part, class Execution>
  StableStep compute_forces(Part& part, Nodes& nodes, double dt, Ledger& ledger, const Execution& execution) {
    paces_.resize(std::max(paces_.size(), part.number() + 1));
    Pace& pace = paces_[part.number()];
    const StableStep stable = [&] {
      if constexpr (can_wait<Part>)
        return part.compute_forces(nodes, ledger, execution, Schedule{*this, pace, dt});
      else
        return part.compute_forces(nodes, dt, ledger, execution);
    }();
    pace.own_step = stable.dt;
    return stable;
  }

  /// Number of elements of a part that are advanced once in a cycle.
  template <class Part>
  std::size_t slow(const Part& part) const {
    const Pace& pace = paces_[part.number()];
    std::size_t count = 0;
    for (std::size_t b = 0; b < pace.slow.size(); ++b) count += pace.slow[b] ? part.count(b) : 0;
    return count;
  }
  /// A sentence for each slow part.
  template <class Items>
  void add_warnings(const Items& items, std::vector<std::string>& warnings) const {
    each_part(items, [&](const auto& part, const Pace& pace) {
      if (pace.slow.empty()) return;
      std::string text = detail::joined(
          {"part ", std::to_string(part.number()), " is advanced once in ", std::to_string(multiple_), " steps"});
      if (const std::size_t near = part.size() - slow(part); near > 0)
        text += detail::joined({", but for ", std::to_string(near), " of its ", std::to_string(part.size()),
                                " elements, which are near faster ones"});
      warnings.push_back(text + ".");
    });
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(multiple_);
    for (const Pace& pace : paces_) archive.same(pace.slow);
    archive(done_, duration_);
    const auto keep = [&](auto& field) {
      for (const Index i : places_) archive(field[i]);
    };
    keep(mean_.velocity);
    if constexpr (Nodes::nodes_turn) keep(mean_.angular_velocity);
  }

 private:
  using Motion = std::decay_t<decltype(std::declval<Nodes&>().motion())>;
  using Vector = typename decltype(Motion::velocity)::value_type;

  struct Pace {
    std::vector<char> slow;  // of each block of a slow part
    double own_step = 0;
  };

  /// The blocks that are advanced after a step, see EveryStep.
  class Schedule {
   public:
    Schedule(Running& cycle, const Pace& pace, double dt) : cycle_(cycle), pace_(pace), dt_(dt) {}

    void load(const detail::Patches& patches, const detail::Patch& patch) const {
      if (pace_.slow.empty() || !cycle_.is_complete()) return;
      patches.refresh(patch, cycle_.mean_.velocity);
      if constexpr (Nodes::nodes_turn) patches.refresh(patch, cycle_.mean_.angular_velocity);
    }
    bool is_due(std::size_t b) const { return cycle_.is_complete() || !is_slow(b); }
    double dt(std::size_t b) const { return is_slow(b) ? cycle_.duration_ : dt_; }
    const Motion& velocities(std::size_t b, const Motion& motion) const { return is_slow(b) ? cycle_.mean_ : motion; }
    template <class T, class A>
    A times_multiple(std::size_t b, const A& a) const {
      return T(is_slow(b) ? static_cast<double>(cycle_.multiple_) : 1.0) * a;
    }

   private:
    bool is_slow(std::size_t b) const { return !pace_.slow.empty() && pace_.slow[b]; }

    Running& cycle_;
    const Pace& pace_;
    double dt_;
  };

  /// Nodes that have a pressure of their own need it from all their elements, and particles see each other.
  template <class Part>
  static constexpr bool can_wait = !Part::averages_volume && !Part::sees_neighbours;

  /// f(part, its pace).
  template <class Items, class F>
  void each_part(const Items& items, const F& f) {
    each_part(items, paces_, f);
  }
  template <class Items, class F>
  void each_part(const Items& items, const F& f) const {
    each_part(items, paces_, f);
  }
  template <class Items, class Paces, class F>
  static void each_part(const Items& items, Paces& paces, const F& f) {
    const auto visit = [&](const auto& item) {
      if constexpr (requires { item.patches(); }) f(item, paces[item.number()]);
    };
    detail::each_item(items, visit);
  }

  /// The multiple with which the fewest elements are advanced, and the parts that allow it.
  template <class Items>
  void choose(const Items& items) {
    double least = std::numeric_limits<double>::infinity();
    for (const Pace& pace : paces_) least = std::min(least, pace.own_step);
    const auto allows = [&](const auto& part, const Pace& pace, std::size_t multiple) {
      return can_wait<std::decay_t<decltype(part)>> && multiple > 1 &&
             (1 + 1e-9) * pace.own_step >= static_cast<double>(multiple) * least;  // but for rounding
    };
    double fewest = std::numeric_limits<double>::infinity();
    for (std::size_t multiple = 1; multiple <= policy_.largest; ++multiple) {
      double advanced = 0;
      each_part(items, [&](const auto& part, const Pace& pace) {
        const auto size = static_cast<double>(part.size());
        advanced += allows(part, pace, multiple) ? size / static_cast<double>(multiple) : size;
      });
      if (advanced < fewest) fewest = advanced, multiple_ = multiple;
    }
    each_part(items, [&](const auto& part, Pace& pace) {
      if (allows(part, pace, multiple_)) pace.slow.assign(part.blocks().size(), true);
    });
  }

  /// f(its block, the places of its nodes) for each element.
  template <class Part, class F>
  static void for_each_element(const Part& part, const Nodes& nodes, const F& f) {
    std::array<Index, Part::n> corners;
    for (std::size_t b = 0; b < part.blocks().size(); ++b)
      for (std::size_t l = 0; l < part.count(b); ++l) {
        for (std::size_t i = 0; i < Part::n; ++i) corners[i] = nodes.place(nodes.number(part.blocks()[b].nodes[i][l]));
        f(b, corners);
      }
  }
  template <class Corners>
  static void mark(const Corners& corners, std::vector<bool>& marks) {
    for (const Index i : corners) marks[i] = true;
  }

  Subcycling policy_;
  std::size_t multiple_ = 1, done_ = 0;  // steps of a cycle, and of the present one
  double duration_ = 0;                  // of these
  std::vector<Index> places_;            // of the nodes of what is slow
  Motion mean_;                          // their velocities over the cycle; until it is complete, paths
  std::vector<Pace> paces_;              // of the parts
};

}  // namespace strike
