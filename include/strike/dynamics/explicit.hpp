#pragma once
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/error.hpp>
#include <strike/motion/clock.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ledger.hpp>

namespace strike {

/// What the driver may be told.
struct ExplicitOptions {
  double step_factor = 0.9;                                       ///< of the stable step
  double step_growth = 1.05;                                      ///< largest ratio of a step to the one before
  double largest_step = std::numeric_limits<double>::infinity();  ///< [time]
  double smallest_step = 0;        ///< the run is given up below it; 0: below a millionth of the first [time]
  double energy_tolerance = 0.05;  ///< the run is given up if the balance is off by more
};

/// Explicit dynamics of a scene by central differences with a variable step (Belytschko, Liu, Moran 2000, box 6.1).
/// Between two steps it holds x, f at the time n and v half a step before. Policies, after the options and in any
/// order, choose what is not to be as usual: numbers (`in<Pack<float>>`), execution (`OpenMP{}`), what bounds the step
/// (`GlobalStep{}`), damping (`DynamicRelaxation{}`), and how often parts are advanced (`Subcycling{}`).
template <class Numbers, class Execution, class Bound, class Damping, class Cycle, class... Things>
class Explicit {
 public:
  using Real = typename Numbers::NodeReal;
  using Nodes = typename Numbers::template Nodes<Scene<Things...>::nodes_turn>;

  template <class... Policies>
  explicit Explicit(Scene<Things...> scene, ExplicitOptions options = {}, const Policies&... policies)
      : Explicit(std::move(scene), options, detail::pick<detail::IsExecution>(policies..., Serial{}),
                 detail::pick<detail::IsStepBound>(policies..., ElementStep{}),
                 detail::pick<detail::IsDamping>(policies..., NoDamping{}),
                 detail::pick<detail::IsCycle>(policies..., NoSubcycling{}), detail::arrange(scene)) {
    static_assert(
        (detail::is_policy<Policies> && ...),
        "strike: the policies of Explicit, after its options, are its numbers, such as in<Pack<float>>, its execution, "
        "such as OpenMP{}, the bound of its step, such as GlobalStep{}, its damping, such as DynamicRelaxation{}, and "
        "Subcycling{}.");
  }

  /// One step: from n to n + 1.
  void step() {
    choose_step();
    damp();
    kick();
    constrain();
    resolve_contact();
    close_balance();
    drift();
    compute_forces();
    apply_loads();
  }

  /// Steps until the time `end`, or until an observer `stops()` or a relaxation is at rest, and calls the observers
  /// before the first and after each step: `f()` or `f(run)`. The last step ends at `end` exactly. If the run has to be
  /// given up, observers with a `last(run)` get it before the Error leaves. An observer may also `save(run, observers)`
  /// after all have seen a step, and `resume(run, observers)`: whether it has put them where they once were.
  template <class... Observers>
  void until(double end, Observers&&... observers) {
    end_ = end;
    [[maybe_unused]] const auto all = std::tie(observers...);
    if (!(resumes(observers, all) || ...)) (observe(observers), ...);
    try {
      while (clock_.time() < end_ && !is_at_rest() && !(stops(observers) || ...)) {
        step();
        (observe(observers), ...);
        (save(observers, all), ...);
      }
    } catch (...) {
      (observe_last(observers), ...);
      throw;
    }
  }

  double time() const { return clock_.time(); }
  std::size_t steps() const { return step_.number; }
  double dt() const { return step_.dt; }
  /// The element that allows the least step, and that step before the factor.
  const StableStep& stable_step() const { return stable_; }
  /// The damping at work.
  const auto& damping() const { return damping_; }
  /// The cycle in which parts are advanced, at work.
  const auto& cycle() const { return cycle_; }
  /// What bounds the step, at work.
  const auto& step_bound() const { return bound_; }
  /// What the user should know before believing the results, a sentence each.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    std::apply(
        [&](const auto&... thing) {
          const auto ask = [&](const auto& t) {
            if constexpr (requires { t.warning(); })
              if (const std::string warning = t.warning(); !warning.empty()) all.push_back(warning);
          };
          (ask(thing), ...);
        },
        things_);
    if constexpr (Cycle::subcycles) cycle_.tell(things_, all);
    return all;
  }
  /// The energies at the last time at which both neighbouring velocities are known, one step back; with Subcycling at
  /// the start of the present cycle.
  const Energy& energy() const { return energy_; }
  Eigen::Vector3d momentum() const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes_.size(); ++i) p += nodes_.mass(i) * nodes_.v(i).template cast<double>();
    return p;
  }

  const Nodes& nodes() const { return nodes_; }
  Nodes& nodes() { return nodes_; }
  std::vector<Eigen::Vector3d> positions() const {
    std::vector<Eigen::Vector3d> x(nodes_.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = nodes_.x(i).template cast<double>();
    return x;
  }
  /// Whether all its things tell an archive what they remember.
  template <class Archive>
  static constexpr bool remembers() {
    return (detail::Serializes<typename detail::Running<Things, Numbers, Nodes, Bound>::type, Archive> && ...);
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(nodes_, bound_, damping_, ledger_, energy_, step_, stable_, bounded_, smallest_step_, clock_);
    if constexpr (Cycle::subcycles) archive(cycle_);
    each([&](auto& thing) {
      if constexpr (detail::Serializes<decltype(thing), Archive>) archive(thing);
    });
  }
  /// The i-th thing of the scene at work: a RunningPart, a load, a contact.
  template <std::size_t i>
  auto& thing() {
    return std::get<i>(things_);
  }
  template <std::size_t i>
  const auto& thing() const {
    return std::get<i>(things_);
  }

 private:
  using Running = std::tuple<typename detail::Running<Things, Numbers, Nodes, Bound>::type...>;

  Explicit(Scene<Things...>&& scene, const ExplicitOptions& options, const Execution& execution, const Bound& bound,
           const Damping& damping, const Cycle& cycle, detail::Arrangement arrangement)
      : options_(options),
        execution_(execution),
        bound_(bound),
        damping_(damping),
        cycle_(cycle),
        nodes_(scene.nodes, std::move(arrangement.nodes)),
        things_(start(std::move(scene.things), nodes_, std::move(arrangement.cells))),
        kinetic_(detail::chunks(nodes_.size())) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!(nodes_.mass(i) > 0))
        throw Error(detail::joined({"strike: node ", std::to_string(i), " at ", place(i),
                                    " has no mass, for it belongs to no element; remove it."}));
    if constexpr (Nodes::nodes_turn)
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (!(nodes_.inertia(i) > 0)) nodes_.add_inertia(i, nodes_.mass(i));  // nothing will turn it
    each([&](auto& thing) {
      if constexpr (requires { thing.begin(nodes_); }) thing.begin(nodes_);
    });
    double mass = 0, rounding = 0;
    ledger_.kinetic = motion_energy();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      mass += nodes_.mass(i);
      rounding = std::max(rounding, nodes_.resolution(i));
    }
    rounding_ = 0.5 * mass * rounding * rounding;
    each([&](auto& thing) {
      if constexpr (requires { thing.stored_energy(); }) ledger_.internal.book(thing.stored_energy());
    });
    ledger_.initial = ledger_.kinetic + ledger_.internal.settled();
    energy_ = ledger_.energy();
    compute_forces();
    if constexpr (Cycle::subcycles) {
      cycle_.begin(things_, nodes_);
      compute_forces();
    }
    apply_loads();
  }

  static Running start(std::tuple<Things...> things, Nodes& nodes, std::vector<std::vector<Index>> orders) {
    std::size_t number = 0;
    return std::apply(
        [&](auto&... thing) {
          return Running{
              detail::Running<Things, Numbers, Nodes, Bound>::start(std::move(thing), nodes, orders, number)...};
        },
        things);
  }

  template <class F>
  void each(F f) {
    std::apply([&](auto&... thing) { (f(thing), ...); }, things_);
  }

  template <class Observer>
  void observe(Observer& observer) {
    if constexpr (requires { observer(*this); })
      observer(*this);
    else
      observer();
  }
  template <class Observer, class All>
  bool resumes(Observer& observer, const All& all) {
    if constexpr (requires { observer.resume(*this, all); })
      return observer.resume(*this, all);
    else
      return false;
  }
  template <class Observer, class All>
  void save(Observer& observer, const All& all) {
    if constexpr (requires { observer.save(*this, all); }) observer.save(*this, all);
  }

  template <class Observer>
  static bool stops(const Observer& observer) {
    if constexpr (requires { observer.stops(); })
      return observer.stops();
    else
      return false;
  }
  template <class Observer>
  void observe_last(Observer& observer) {
    if constexpr (requires { observer.last(*this); }) observer.last(*this);
  }

  void choose_step() {
    const double before = step_.dt;
    if constexpr (Cycle::subcycles)
      if (!cycle_.is_complete()) {
        step_ = {step_.number + 1, clock_.time(), before, cycle_.next_step(before, end_ - clock_.time())};
        return;
      }
    if (std::isfinite(stable_.dt)) bounded_ = stable_.dt;  // and while nothing is left that resists, as before
    double dt = std::min(options_.step_factor * bounded_, options_.largest_step);
    if (!std::isfinite(dt)) stop("no element is left that bounds the step; give a `.largest_step`");
    if (step_.number == 0) smallest_step_ = options_.smallest_step > 0 ? options_.smallest_step : 1e-6 * dt;
    if (!(dt > smallest_step_))
      stop(detail::joined({"the time step has fallen to ", detail::text(dt), " because of ", culprit(),
                           "; refine the mesh there, let the material fail, or allow it by `.smallest_step`"}));
    if (before > 0) dt = std::min(dt, options_.step_growth * before);
    const double left = (end_ - clock_.time()) / static_cast<double>(cycle_.multiple());
    if (2 * dt > left) dt = dt < left ? 0.5 * left : left;
    step_ = {step_.number + 1, clock_.time(), before, dt};
  }

  bool is_at_rest() const {
    if constexpr (Damping::damps)
      return damping_.is_at_rest();
    else
      return false;
  }

  /// Stops all nodes where the damping says so; they go on as at the start, under half a kick.
  void damp() {
    if constexpr (Damping::damps) {
      if (!damping_.passes_peak(ledger_.kinetic, ledger_.internal.settled())) return;
      ledger_.damping.book(motion_energy() + 0.5 * step_.kick() * force_power());  // m v-.v+/2 had they gone on
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        nodes_.velocity()[i] = 0;
        if constexpr (Nodes::nodes_turn) nodes_.angular_velocity()[i] = 0;
      }
      step_.dt_before = 0;
    }
  }
  /// Of the velocities between two times.
  double motion_energy() const {
    double energy = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      energy += 0.5 * nodes_.mass(i) * nodes_.v(i).template cast<double>().squaredNorm();
      if constexpr (Nodes::nodes_turn)
        energy += 0.5 * nodes_.inertia(i) * nodes_.w(i).template cast<double>().squaredNorm();
    }
    return energy;
  }

  /// What the forces do at those velocities.
  double force_power() const {
    double power = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      power += static_cast<double>(nodes_.f(i).dot(nodes_.v(i)));
      if constexpr (Nodes::nodes_turn) power += static_cast<double>(nodes_.moment(i).dot(nodes_.w(i)));
    }
    return power;
  }

  /// v += kick f/m, and of nodes that turn w += kick moment/inertia. Collects the kinetic energy m v-.v+/2 but for the
  /// impulses of the constraints, which the ledger knows.
  void kick() {
    const auto kick = static_cast<RealOf<Real>>(step_.kick());
    detail::for_each_chunk(execution_, nodes_.size(), [&](std::size_t k, std::size_t first, std::size_t last) {
      Padded<double> kinetic = 0;
      const auto kicked = [&](RealOf<Real> m, const Padded<Real>& v, const Padded<Real>& f) {
        const Padded<Real> after = v + Padded<Real>(kick / m) * f;
        kinetic += Padded<double>(Padded<Real>(m) * v * after);
        return after;
      };
      for (std::size_t i = first; i < last; ++i) {
        auto& v = nodes_.velocity()[i];
        v = kicked(nodes_.mass()[i], v, nodes_.force()[i]);
        if constexpr (Nodes::nodes_turn) {
          auto& w = nodes_.angular_velocity()[i];
          w = kicked(nodes_.inertia()[i], w, nodes_.moment()[i]);
        }
      }
      kinetic_[k] = kinetic[0] + kinetic[1] + kinetic[2];
    });
    ledger_.kinetic = 0.5 * std::accumulate(kinetic_.begin(), kinetic_.end(), 0.0);
  }

  void constrain() {
    each([&](auto& thing) {
      if constexpr (requires { thing.constrain(nodes_, step_, ledger_); }) thing.constrain(nodes_, step_, ledger_);
    });
  }

  void resolve_contact() {
    each([&](auto& thing) {
      if constexpr (requires { thing.resolve_contact(nodes_, step_, ledger_); })
        thing.resolve_contact(nodes_, step_, ledger_);
    });
  }

  /// Closes the balance at the time n and begins the next.
  void close_balance() {
    if (step_.number == 1) begin_balance();
    ledger_.kinetic += ledger_.impulses_before();
    if (cycle_.is_complete()) {
      energy_ = ledger_.energy();
      if (step_.number > 1) check_balance();
    }
    ledger_.settle();
    if constexpr (Damping::damps)
      if (damping_.restarts())
        ledger_.damping.book(motion_energy());  // what central differences lack from rest, see below
    each([&](auto& thing) {
      if constexpr (requires { thing.power(nodes_); }) ledger_.external.book(0.5 * step_.dt * thing.power(nodes_));
    });
  }

  /// The kinetic energy with which central differences begin: less than m v.v/2 by f.(v+ - v) kick/2, for the first
  /// half step is one under the force f at its start alone. (From rest under a constant f they keep m v-.v+/2 - f x at
  /// -(kick f)^2/(2 m).)
  void begin_balance() {
    ledger_.kinetic -= 0.5 * step_.kick() * force_power();
    ledger_.initial += ledger_.kinetic - energy_.kinetic;
  }

  /// An unstable step keeps the balance while velocities change sign and grow from step to step, and with them a
  /// negative kinetic energy and the internal one. (A vibration of the energy E with w dt = 2 sin(a) has the kinetic
  /// energy -E tan^2(a) at its turning points: -4 E at 0.9 of the stable step, -49 E at 0.99.) What rounding does
  /// counts for nothing: in each step it may move the nodes by the spacing of the numbers.
  void check_balance() const {
    const double moves = static_cast<double>(step_.number) / (step_.dt * step_.dt);
    const double rounding = options_.energy_tolerance * rounding_ * moves;
    const double allowed = std::max(options_.energy_tolerance * energy_.scale(), rounding);
    if (!(energy_.kinetic >= -100 * std::max(energy_.initial, std::abs(energy_.external)) - rounding))
      stop(detail::joined({"the velocities grow from step to step with changing sign (kinetic energy ",
                           detail::text(energy_.kinetic),
                           "): the step is beyond stability; use a smaller step factor"}));
    if (!(std::abs(energy_.imbalance()) <= allowed))
      stop(detail::joined({"the energy balance is off by ", detail::text(100 * energy_.error()), " % of ",
                           detail::text(energy_.scale()), "; use a smaller step factor or look for what is wrong near ",
                           culprit()}));
  }

  void drift() {
    const auto dt = static_cast<RealOf<Real>>(step_.dt);
    detail::for_each_chunk(execution_, nodes_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) nodes_.position()[i] += Padded<Real>(dt) * nodes_.velocity()[i];
    });
    if constexpr (Cycle::subcycles) cycle_.drift(nodes_, step_.dt, execution_);
    if (step_.dt >= end_ - clock_.time())
      clock_.set(end_);
    else
      clock_.advance(step_.dt);
  }

  void compute_forces() {
    const StableStep before = std::exchange(stable_, {});
    each([&](auto& thing) {
      if constexpr (requires { thing.compute_forces(nodes_, step_.dt, ledger_, execution_); }) {
        StableStep mine;
        try {
          mine = cycle_.compute_forces(thing, nodes_, step_.dt, ledger_, execution_);
        } catch (const Error& error) {
          stop(error.what());
        }
        if (mine.dt < stable_.dt) stable_ = mine;
      }
    });
    tell_deleted();
    bound_.extend(stable_, nodes_, things_, execution_);
    each([&](auto& thing) {
      if constexpr (requires { thing.stable_step(stable_.dt); }) stable_.dt = thing.stable_step(stable_.dt);
    });
    if (!cycle_.is_complete()) stable_ = before;
  }

  /// Those who want to know learn which elements are left.
  void tell_deleted() {
    each([&](const auto& part) {
      if constexpr (requires { part.newly_deleted(); }) {
        if (part.newly_deleted() == 0) return;
        const std::vector<bool> alive = part.alive();
        each([&](auto& thing) {
          if constexpr (requires { thing.remove(part.number(), alive); }) thing.remove(part.number(), alive);
        });
      }
    });
  }

  void apply_loads() {
    each([&](auto& thing) {
      if constexpr (requires { thing.apply_loads(nodes_, clock_.time()); }) {
        thing.apply_loads(nodes_, clock_.time());
        ledger_.external.book(0.5 * step_.dt * thing.power(nodes_));
      }
    });
  }

  /// The element that allows the least step, with its place.
  [[gnu::cold]] std::string culprit() const {
    std::string text;
    std::apply(
        [&](const auto&... thing) {
          const auto ask = [&](const auto& part) {
            if constexpr (requires { part.number(); })
              if (part.number() == stable_.part) text = part.describe(nodes_, stable_.element);
          };
          (ask(thing), ...);
        },
        things_);
    return text;
  }
  [[noreturn]] void stop(const std::string& why) const {
    throw Error(detail::joined(
        {"strike: at t = ", detail::text(clock_.time()), ", step ", std::to_string(step_.number), ": ", why, "."}));
  }
  std::string place(std::size_t i) const { return detail::text(nodes_.x(i).template cast<double>()); }

  ExplicitOptions options_;
  Execution execution_;
  [[no_unique_address]] typename Bound::template Running<Nodes, Running> bound_;
  [[no_unique_address]] detail::RunningDamping<Damping> damping_;
  [[no_unique_address]] detail::RunningCycle<Cycle, Nodes> cycle_;
  Nodes nodes_;
  Running things_;
  std::vector<double> kinetic_;  // twice the kinetic energy of each chunk of nodes
  Ledger ledger_;
  Energy energy_;
  Step step_;
  StableStep stable_;
  double bounded_ = std::numeric_limits<double>::infinity();  // the last stable step of an element
  double smallest_step_ = 0;
  double rounding_ = 0;  // energy times time^2 of all nodes that move by the spacing of the numbers
  Clock clock_;
  double end_ = std::numeric_limits<double>::infinity();
};

/// A scene that the compiler complains about gets no second complaint.
template <class Numbers, class Execution, class Bound, class Damping, class Cycle, class... Things>
  requires(!Scene<Things...>::sound || !Numbers::is_scalar || !detail::is_available<Execution>() ||
           !detail::is_bounded<Bound, Things...> || !detail::can_cycle<Cycle, Bound, Damping>)
class Explicit<Numbers, Execution, Bound, Damping, Cycle, Things...> {
 public:
  explicit Explicit(Scene<Things...>, ExplicitOptions = {}, auto...) {
    static_assert(detail::is_available<Execution>(),
                  "strike: OpenMP{} needs a compiler with OpenMP: link strike::openmp.");
    static_assert(!Scene<Things...>::sound || detail::is_bounded<Bound, Things...>,
                  "strike: an element of this Scene lacks what the bound of the step needs: for GlobalStep{} give it "
                  "resistance(state, material, x, v, dt), as Hex8 has it, or leave the step to ElementStep{}.");
    static_assert(detail::can_cycle<Cycle, Bound, Damping>,
                  "strike: Subcycling{} needs the steps of the elements and true times: leave out GlobalStep{} and "
                  "DynamicRelaxation{}.");
  }
  void step() {}
  void until(auto&&...) {}
};

template <class... Things>
Explicit(Scene<Things...>) -> Explicit<detail::NumbersOf<>, detail::ExecutionOf<>, detail::StepBoundOf<>,
                                       detail::DampingOf<>, detail::CycleOf<>, Things...>;
template <class... Things, class... Policies>
Explicit(Scene<Things...>, ExplicitOptions, Policies...)
    -> Explicit<detail::NumbersOf<Policies...>, detail::ExecutionOf<Policies...>, detail::StepBoundOf<Policies...>,
                detail::DampingOf<Policies...>, detail::CycleOf<Policies...>, Things...>;

}  // namespace strike
