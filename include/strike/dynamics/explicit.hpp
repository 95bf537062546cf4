#pragma once
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/balance.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/ill_formed_run.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/last_steps.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/dynamics/not_finite.hpp>
#include <strike/dynamics/observer.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/dynamics/running_scene.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/clock.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/step.hpp>
#include <strike/text.hpp>

namespace strike {

/// Explicit dynamics of a scene by central differences with a variable step (Belytschko, Liu, Moran 2000, box 6.1).
/// Between two steps it holds x, f at the time n and v half a step before.
///   Explicit run{scene};  Explicit run{scene, {.step_factor = 0.5}, GlobalStep{}};  Explicit run{scene, OpenMP{}};
/// Policies follow the options, or the scene, in any order; see Method. Errors: those of its items; wrong cells, as
/// check(mesh) finds them; a node without mass.
template <class Method, class... Items>
class Explicit : public detail::RunningScene<Method, Items...> {
  using RunningScene = detail::RunningScene<Method, Items...>;
  using typename RunningScene::RunningItems;
  template <class Item>
  static constexpr bool is_running_part = detail::is_running_part<std::remove_cvref_t<Item>>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr bool damps = !std::is_same_v<typename Method::Damping, NoDamping>;

 public:
  using typename RunningScene::Nodes;

  template <class... Policies>
  explicit Explicit(Scene<Items...> scene, const ExplicitOptions& options = {}, const Policies&... policies)
      : Explicit(scene, options, Method(policies...), detail::arrange(scene)) {}
  template <class First, class... Policies>
    requires(!std::convertible_to<First, ExplicitOptions>)
  explicit Explicit(Scene<Items...> scene, const First& first, const Policies&... policies)
      : Explicit(std::move(scene), ExplicitOptions{}, first, policies...) {}

  /// One step: from n to n + 1.
  void step() {
    choose_step();
    damp();
    kick();
    constrain();
    resolve_contact();
    this->move_bodies(step_, ledger_);
    close_balance();
    drift();
    compute_forces();
    apply_loads();
  }

  /// Steps until exactly the time `end`, until an observer `stops()` or a relaxation is at rest; where the end is now,
  /// nothing is done after the start. Observers (strike/dynamics/observer.hpp) see the state before the first step and
  /// after each. Errors: an end that is past; called by an observer; the run is given up, whose last state they see.
  template <class... Observers>
  void until(double end, Observers&&... observers) {
    using All = std::tuple<std::remove_reference_t<Observers>&...>;
    using namespace detail::observer;
    if constexpr ((report<fault<std::remove_reference_t<Observers>, Explicit, All>()>() && ...)) {
      const detail::Goal goal(goal_, end, clock_.time());
      if (end == clock_.time() && steps() > 0) return;
      end_ = end;
      if (std::exchange(options_.print_warnings, false)) this->print(warnings());
      const All all(observers...);
      if (!(resumes(observers, *this, all) || ...)) (observe(observers, *this), ...);
      goal.check(end, clock_.time());
      const auto steps = [&] {
        while (clock_.time() < end && !damping_.is_at_rest() && !(stops(observers) || ...)) {
          step();
          (observe(observers, *this), ...);
          (detail::call_if_present<Save>(observers, *this, all), ...);
        }
        this->print_stretch();
      };
      call_with_last(steps, *this, observers...);
    }
  }

  /// Fallback for observers without an end: its static_assert is the one message.
  template <class First, class... Observers>
    requires(!std::convertible_to<First, double>)
  void until(const First&, const Observers&...) {
    static_assert(sizeof(First) == 0,
                  "strike: until takes the end of the run before its observers, such as run.until(1e-3, observer).");
  }

  double time() const { return clock_.time(); }
  /// The time until which the run goes, as `until` has been told last.
  double end() const { return end_; }
  /// Number of steps so far.
  std::size_t steps() const { return step_.number; }
  double dt() const { return step_.dt; }
  /// The element that allows the least step, and that step before the factor.
  const StableStep& stable_step() const { return stable_; }
  /// The damping, the cycle of parts and the bound of the step at work.
  const auto& damping() const { return damping_; }
  const auto& cycle() const { return cycle_; }
  const auto& step_bound() const { return bound_; }
  /// Sentences that the user should read before the results.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all = RunningScene::warnings();
    cycle_.add_warnings(this->items_, all);
    this->each_part([&](const auto& part) { damping_.add_warning(part, all); });
    this->add_unit_slip(all, (end_ - clock_.time()) / (options_.step_factor * stable_.dt));
    return all;
  }
  /// The energies at the last time at which both neighbouring velocities are known, one step back; with Subcycling at
  /// the start of the present cycle.
  const Energy& energy() const { return energy_; }
  /// All its items tell an archive what they remember.
  template <class Archive>
  static constexpr bool remembers() {
    return detail::every_kind<Items...>([]<class Kind>() {
      return detail::Serializable<typename detail::RunningItem<Kind, Method, Nodes>::type, Archive>;
    });
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(this->nodes_, bound_, damping_, ledger_, energy_, step_, stable_, bounded_, smallest_step_, clock_, cycle_);
    if constexpr ((detail::is_chosen_late<Items> || ...)) archive.same(this->chosen_late());
    this->each([&](auto& item) {
      archive.same(detail::constants_of(item));
      if constexpr (requires { item.serialize(archive); }) archive(item);
    });
  }

 private:
  Explicit(Scene<Items...>& scene, const ExplicitOptions& options, Method method, detail::Arrangement arrangement)
      : RunningScene(scene, std::move(arrangement)),
        options_(detail::in_range(options)),
        execution_(std::move(method.execution)),
        bound_(method.bound),
        damping_(method.damping),
        cycle_(method.cycle),
        kinetic_(detail::chunks(this->nodes_.size())) {
    this->add_bodies();
    detail::check_masses(this->nodes_);
    detail::complete_inertia(this->nodes_);
    moved_by_rounding_ = detail::moved_by_rounding(this->nodes_);
    this->begin_items();
    ledger_.kinetic = detail::kinetic_energy(this->nodes_);
    ledger_.internal.book(this->stored_energy());
    ledger_.initial = ledger_.kinetic + ledger_.internal.settled();
    energy_ = ledger_.energy();
    compute_forces();
    if (cycle_.begin(this->items_, this->nodes_)) compute_forces();
    apply_loads();
  }

  void choose_step() {
    const double before = step_.dt, left_of_run = goal_.value_or(infinity) - clock_.time();
    if (!cycle_.is_complete()) {
      step_ = {step_.number + 1, clock_.time(), before, cycle_.next_step(before, left_of_run), step_.stable_dt};
      return;
    }
    if (std::isfinite(stable_.dt)) bounded_ = stable_.dt;  // and while nothing is left that resists, as before
    double dt = std::min(options_.step_factor * bounded_, options_.largest_step);
    if (!std::isfinite(dt)) give_up("no element is left that bounds the step; give a `.largest_step`");
    if (step_.number == 0) smallest_step_ = options_.smallest_step > 0 ? options_.smallest_step : 1e-6 * dt;
    if (!(dt > smallest_step_))
      give_up(detail::joined({"the time step has fallen to ", detail::text(dt), " because of ", this->describe(stable_),
                              "; refine the mesh there, let the material fail, or allow it by `.smallest_step`"}));
    if (before > 0) dt = std::min(dt, options_.step_growth * before);
    dt = detail::step_to_end(dt, left_of_run / static_cast<double>(cycle_.multiple()));
    step_ = {step_.number + 1, clock_.time(), before, dt,
             std::isfinite(stable_.of_elements) ? stable_.of_elements : dt};
  }

  /// Stops all nodes where the damping says so; they go on as at the start, under half a kick.
  void damp() {
    if constexpr (damps) {
      const double kinetic = detail::kinetic_energy(this->nodes_) +
                             0.5 * step_.kick() * detail::force_power(this->nodes_);  // m v-.v+/2 if they go on
      if (!damping_.passes_peak(kinetic, ledger_.internal.settled())) return;
      ledger_.damping.book(kinetic);
      detail::stop(this->nodes_);
      step_.dt_before = 0;
    }
  }

  void kick() { ledger_.kinetic = detail::kick(this->nodes_, step_.kick(), execution_, kinetic_); }

  void constrain() {
    this->each(
        [&](auto& item) { detail::call_if_present<detail::item::Constrain>(item, this->nodes_, step_, ledger_); });
  }

  void resolve_contact() {
    this->each([&](auto& item) {
      detail::call_if_present<detail::item::ResolveContact>(item, this->nodes_, step_, ledger_, execution_);
    });
  }

  /// Closes the balance at the time n and starts the next.
  void close_balance() {
    if (step_.number == 1) {
      ledger_.kinetic =
          detail::kinetic_energy_at_start(ledger_.kinetic, step_.kick(), detail::force_power(this->nodes_));
      ledger_.initial += ledger_.kinetic - energy_.kinetic;
    }
    ledger_.kinetic += ledger_.impulses_before();
    if (cycle_.is_complete()) {
      energy_ = ledger_.energy();
      check_balance();
    }
    ledger_.settle();
    if (damping_.restarts()) ledger_.damping.book(detail::kinetic_energy(this->nodes_));  // see kinetic_energy_at_start
    book_loads();
  }
  void check_balance() {
    if (!std::isfinite(energy_.imbalance()))
      if (const std::string nan = culprit().of_nan(); !nan.empty()) give_up(nan);
    if (step_.number == 1) return;
    const double tolerance = options_.energy_tolerance;
    const double rounding = detail::energy_of_rounding(tolerance, moved_by_rounding_, step_.number, step_.dt);
    if (detail::grows_beyond_stability(energy_, rounding)) give_up(detail::beyond_stability(energy_));
    if (!detail::is_balanced(energy_, tolerance, rounding))
      give_up(detail::out_of_balance(energy_, this->describe(stable_), culprit().of_power()));
  }
  auto culprit() { return detail::Culprit(this->nodes_, this->items_, step_, clock_.time()); }

  void drift() {
    detail::drift(this->nodes_, step_.dt, execution_);
    cycle_.drift(this->nodes_, step_.dt, execution_);
    if (goal_ && step_.dt >= *goal_ - clock_.time())
      clock_.set(*goal_);
    else
      clock_.advance(step_.dt);
  }

  void compute_forces() {
    const StableStep before = std::exchange(stable_, {});
    this->nodes_.clear_bare_forces();
    this->each([&](auto& part) {
      if constexpr (is_running_part<decltype(part)>) {
        this->take_debris(part, step_.dt, ledger_);
        StableStep mine;
        try {
          mine = cycle_.compute_forces(part, this->nodes_, step_.dt, ledger_, execution_);
        } catch (const Error& error) {
          const std::string nan = culprit().of_lost_position();
          give_up(nan.empty() ? error.what() : nan);
        }
        if (mine.dt < stable_.dt) stable_ = mine;
      }
    });
    this->remove_deleted();
    bound_.extend(stable_, this->nodes_, this->items_, execution_);
    stable_.of_elements = stable_.dt;
    this->each([&](auto& item) {
      if constexpr (detail::answers<detail::item::StableStep, decltype(item), double, const Nodes>)
        stable_.dt = detail::item::StableStep::call(item, stable_.dt, std::as_const(this->nodes_));
    });
    if (!cycle_.is_complete()) stable_ = before;
    detail::move_with_bodies(this->nodes_);
  }

  void apply_loads() {
    this->each(
        [&](auto& item) { detail::call_if_present<detail::item::ApplyLoads>(item, this->nodes_, clock_.time()); });
    book_loads();
  }
  /// Half a step's work of the loads.
  void book_loads() {
    this->each([&](auto& item) {
      if constexpr (detail::answers<detail::item::Power, decltype(item), const Nodes>)
        ledger_.external.book(0.5 * step_.dt * item.power(std::as_const(this->nodes_)));
    });
  }

  [[noreturn, gnu::cold]] void give_up(const std::string& why) const {
    throw Error(detail::joined(
        {"strike: at t = ", detail::text(clock_.time()), ", step ", std::to_string(step_.number), ": ", why, "."}));
  }

  ExplicitOptions options_;
  [[no_unique_address]] typename Method::Execution execution_;
  [[no_unique_address]] typename Method::Bound::template Running<Nodes, RunningItems> bound_;
  [[no_unique_address]] typename Method::Damping::Running damping_;
  [[no_unique_address]] typename Method::Cycle::template Running<Nodes> cycle_;
  std::vector<double> kinetic_;  // twice the kinetic energy of each chunk of nodes
  Ledger ledger_;
  Energy energy_;
  Step step_;
  StableStep stable_;
  double bounded_ = infinity;  // the last stable step of an element
  double smallest_step_ = 0;
  double moved_by_rounding_ = 0;  // sum of m spacing^2/2 [energy time^2]
  Clock clock_;
  double end_ = infinity;         // as told last
  std::optional<double> goal_{};  // as long as the run is on its way to it
};

template <class... Items>
Explicit(Scene<Items...>) -> Explicit<Method<>, Items...>;
template <class... Items, class... Policies>
Explicit(Scene<Items...>, ExplicitOptions, Policies...) -> Explicit<Method<Policies...>, Items...>;
template <class... Items, class First, class... Policies>
  requires(!std::convertible_to<First, ExplicitOptions>)
Explicit(Scene<Items...>, First, Policies...) -> Explicit<Method<First, Policies...>, Items...>;

}  // namespace strike
