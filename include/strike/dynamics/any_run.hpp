#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/balance.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/items_at_work.hpp>
#include <strike/dynamics/last_steps.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/error.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/clock.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Gives nodes that no element turns a moment of inertia.
template <class Nodes>
void complete_inertia(Nodes& nodes) {
  if constexpr (Nodes::nodes_turn)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!(nodes.inertia(i) > 0)) nodes.add_inertia(i, nodes.mass(i));
}

/// sum of m spacing^2/2, of nodes that move by the largest spacing of the numbers [energy time^2].
template <class Nodes>
double moved_by_rounding(const Nodes& nodes) {
  double mass = 0, spacing = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mass += nodes.mass(i);
    spacing = std::max(spacing, nodes.resolution(i));
  }
  return 0.5 * mass * spacing * spacing;
}

/// The step of a run, but for its bound: whatever the scene is, it is this.
template <class Method, class NodesOfRun>
class AnyRun : public ItemsAtWork<Method, NodesOfRun> {
  using Items = ItemsAtWork<Method, NodesOfRun>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr bool damps = !std::is_same_v<typename Method::Damping, NoDamping>;

 public:
  using typename Items::Nodes;

  double time() const { return clock_.time(); }
  /// The time until which the run goes, as `until` has been told last.
  double end() const { return end_; }
  /// Number of steps so far.
  std::size_t steps() const { return step_.number; }
  double dt() const { return step_.dt; }
  /// The element that allows the least step, and that step before the factor.
  const StableStep& stable_step() const { return stable_; }
  /// The damping and the cycle of parts at work.
  const auto& damping() const { return damping_; }
  const auto& cycle() const { return cycle_; }
  /// The energies at the last time at which both neighbouring velocities are known, one step back; with Subcycling at
  /// the start of the present cycle.
  const Energy& energy() const { return energy_; }

 protected:
  using typename Items::Item;

  AnyRun(const std::vector<Eigen::Vector3d>& positions, std::vector<Index> order, const ExplicitOptions& options,
         const Method& method)
      : Items(positions, std::move(order), ranks_of(method.execution)),
        options_(in_range(options)),
        execution_(method.execution),
        damping_(method.damping),
        cycle_(method.cycle),
        kinetic_(chunks(this->nodes_.size())) {}

  /// The masses, the items and the energies at the start.
  void begin() {
    this->add_bodies();
    check_masses(this->nodes_);
    complete_inertia(this->nodes_);
    moved_by_rounding_ = moved_by_rounding(this->nodes_);
    this->begin_items();
    ledger_.kinetic = kinetic_energy(this->nodes_);
    ledger_.internal.book(this->stored_energy());
    ledger_.initial = ledger_.kinetic + ledger_.internal.settled();
    energy_ = ledger_.energy();
  }

  void add_warnings_of_method(std::vector<std::string>& all) const {
    for (const Item& one : this->listed_)
      if (one.can->is_part) one.can->add_damping_warning(one.item, damping_, all);
    this->add_unit_slip(all, (end_ - clock_.time()) / (options_.step_factor * stable_.dt));
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
      give_up(joined({"the time step has fallen to ", text(dt), " because of ", this->describe(stable_),
                      "; refine the mesh there, let the material fail, or allow it by `.smallest_step`"}));
    if (before > 0) dt = std::min(dt, options_.step_growth * before);
    dt = step_to_end(dt, left_of_run / static_cast<double>(cycle_.multiple()));
    step_ = {step_.number + 1, clock_.time(), before, dt,
             std::isfinite(stable_.of_elements) ? stable_.of_elements : dt};
  }

  /// Stops all nodes where the damping says so; they go on as at the start, under half a kick.
  void damp() {
    if constexpr (damps) {
      const double kinetic =
          kinetic_energy(this->nodes_) + 0.5 * step_.kick() * force_power(this->nodes_);  // m v-.v+/2 if they go on
      if (!damping_.passes_peak(kinetic, ledger_.internal.settled())) return;
      ledger_.damping.book(kinetic);
      stop(this->nodes_);
      step_.dt_before = 0;
    }
  }

  void kick() {
    if constexpr (Items::has_ranks)
      if (this->nodes_.node_share()) return kick_shared();
    ledger_.kinetic = detail::kick(this->nodes_, step_.kick(), execution_, kinetic_);
  }

  /// Each process its own nodes, and all those that items name.
  void kick_shared() {
    auto& nodes = this->nodes_;
    nodes.leave_others();
    const NodeShare& share = *nodes.node_share();
    const Places own = share.own();
    for_each_chunk(execution_, own.last - own.first, [&](std::size_t k, std::size_t first, std::size_t last) {
      kinetic_[share.first_chunk() + k] = detail::kick(nodes, step_.kick(), own.first + first, own.first + last);
    });
    for (const auto& [first, last] : share.named_of_others()) detail::kick(nodes, step_.kick(), first, last);
    share.exchange_chunks(nodes.ranks(), kinetic_);
    ledger_.kinetic = 0.5 * std::accumulate(kinetic_.begin(), kinetic_.end(), 0.0);
  }
  void drift_nodes() {
    if constexpr (Items::has_ranks)
      if (this->nodes_.node_share()) return drift_shared();
    detail::drift(this->nodes_, step_.dt, execution_);
  }
  /// And copies of those that its elements name.
  void drift_shared() {
    auto& nodes = this->nodes_;
    nodes.leave_others();
    const NodeShare& share = *nodes.node_share();
    const PlaceLists& lent = share.lent();
    auto trade = [&] {
      if constexpr (Nodes::nodes_turn)
        return nodes.ranks().start_trade(lent, nodes.velocity(), lent, nodes.angular_velocity());
      else
        return nodes.ranks().start_trade(lent, nodes.velocity());
    }();
    const Places own = share.own();
    for_each_chunk(execution_, own.last - own.first, [&](std::size_t, std::size_t first, std::size_t last) {
      detail::drift(nodes, step_.dt, own.first + first, own.first + last);
    });
    trade.finish();
    for (const auto& [first, last] : share.others()) detail::drift(nodes, step_.dt, first, last);
    place_bodies(nodes);
  }

  void constrain() {
    for (const Item& one : this->listed_)
      if (one.can->constrain) one.can->constrain(one.item, this->nodes_, step_, ledger_);
  }

  void resolve_contact() {
    for (const Item& one : this->listed_)
      if (one.can->resolve_contact) one.can->resolve_contact(one.item, this->nodes_, step_, ledger_, execution_);
  }

  /// After contacts have pushed them.
  void move_bodies() {
    for (const Item& one : this->listed_)
      if (one.can->move_body) one.can->move_body(one.item, this->nodes_, step_, ledger_);
  }

  /// Closes the balance at the time n and starts the next.
  void close_balance() {
    if (step_.number == 1) {
      this->know_all_nodes();
      ledger_.kinetic = kinetic_energy_at_start(ledger_.kinetic, step_.kick(), force_power(this->nodes_));
      ledger_.initial += ledger_.kinetic - energy_.kinetic;
    }
    ledger_.kinetic += ledger_.impulses_before();
    if (cycle_.is_complete()) {
      energy_ = ledger_.energy();
      check_balance();
    }
    ledger_.settle();
    if (damping_.restarts()) ledger_.damping.book(kinetic_energy(this->nodes_));  // see kinetic_energy_at_start
    book_loads();
  }
  void check_balance() {
    if (!std::isfinite(energy_.imbalance()))
      if (const std::string nan = culprit().of_nan(); !nan.empty()) give_up(nan);
    reached_ = std::max({reached_, energy_.initial, std::abs(energy_.external)});
    if (step_.number == 1) return;
    const double tolerance = options_.energy_tolerance;
    const double rounding = energy_of_rounding(tolerance, moved_by_rounding_, step_.number, step_.dt);
    if (grows_beyond_stability(energy_, reached_, rounding)) give_up(beyond_stability(energy_));
    if (!is_balanced(energy_, reached_, tolerance, rounding))
      give_up(out_of_balance(energy_, this->describe(stable_), culprit().of_power()));
  }
  auto culprit() { return Items::culprit(step_, clock_.time()); }

  void drift() {
    drift_nodes();
    cycle_.drift(this->nodes_, step_.dt, execution_);
    if (goal_ && step_.dt >= *goal_ - clock_.time())
      clock_.set(*goal_);
    else
      clock_.advance(step_.dt);
  }

  /// Advances the elements of all parts, before each of which it calls before(its number), and takes the least of their
  /// steps for the run's.
  template <class F>
  void advance_parts(const F& before) {
    stable_ = {};
    this->nodes_.clear_bare_forces();
    for (const Item& one : this->listed_) {
      if (!one.can->is_part) continue;
      before(one.can->number(one.item));
      StableStep mine;
      try {
        mine = one.can->compute_forces(one.item, cycle_, this->nodes_, step_.dt, ledger_, execution_);
      } catch (const Error& error) {
        const std::string nan = culprit().of_lost_position();
        give_up(nan.empty() ? error.what() : nan);
      }
      if (mine.dt < stable_.dt) stable_ = mine;
    }
    if constexpr (Items::has_ranks)
      if (const NodeShare* share = this->nodes_.node_share()) {
        share->exchange_named(this->nodes_.ranks(), this->nodes_.force());
        if constexpr (Nodes::nodes_turn) share->exchange_named(this->nodes_.ranks(), this->nodes_.moment());
      }
    this->remove_deleted();
  }
  /// The step that items leave of that of the elements.
  void bound_by_items() {
    stable_.of_elements = stable_.dt;
    for (const Item& one : this->listed_)
      if (one.can->stable_step) stable_.dt = one.can->stable_step(one.item, stable_.dt, this->nodes_);
  }

  void apply_loads() {
    for (const Item& one : this->listed_)
      if (one.can->apply_loads) one.can->apply_loads(one.item, this->nodes_, clock_.time());
    book_loads();
  }
  /// Half a step's work of the loads.
  void book_loads() {
    for (const Item& one : this->listed_)
      if (one.can->power) ledger_.external.book(0.5 * step_.dt * one.can->power(one.item, this->nodes_));
  }

  [[noreturn, gnu::cold]] void give_up(const std::string& why) const {
    throw Error(
        joined({"strike: at t = ", text(clock_.time()), ", step ", std::to_string(step_.number), ": ", why, "."}));
  }

  ExplicitOptions options_;
  [[no_unique_address]] typename Method::Execution execution_;
  [[no_unique_address]] typename Method::Damping::Running damping_;
  [[no_unique_address]] typename Method::Cycle::template Running<Nodes> cycle_;
  std::vector<double> kinetic_;  // twice the kinetic energy of each chunk of nodes
  Ledger ledger_;
  Energy energy_;
  Step step_;
  StableStep stable_;
  double bounded_ = infinity;  // the last stable step of an element
  double smallest_step_ = 0;
  double reached_ = 0;            // the largest of the initial energy and the external work so far
  double moved_by_rounding_ = 0;  // sum of m spacing^2/2 [energy time^2]
  Clock clock_;
  double end_ = infinity;         // as told last
  std::optional<double> goal_{};  // as long as the run is on its way to it
};

}  // namespace strike::detail
