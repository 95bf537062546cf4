#pragma once
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/ill_formed_run.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/last_steps.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/dynamics/observer.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/dynamics/running_scene.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/motion/step.hpp>

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
    this->choose_step();
    this->damp();
    this->kick();
    this->constrain();
    this->resolve_contact();
    this->move_bodies();
    this->close_balance();
    this->drift();
    compute_forces();
    this->apply_loads();
  }

  /// Steps until exactly the time `end`, until an observer `stops()` or a relaxation is at rest; where the end is now,
  /// nothing is done after the start. Observers (strike/dynamics/observer.hpp) see the state before the first step and
  /// after each. Errors: an end that is past; called by an observer; the run is given up, whose last state they see.
  template <class... Observers>
  void until(double end, Observers&&... observers) {
    using All = std::tuple<std::remove_reference_t<Observers>&...>;
    using namespace detail::observer;
    if constexpr ((report<fault<std::remove_reference_t<Observers>, Explicit, All>()>() && ...)) {
      const detail::Goal goal(this->goal_, end, this->clock_.time());
      if (end == this->clock_.time() && this->steps() > 0) return;
      this->end_ = end;
      if (std::exchange(this->options_.print_warnings, false)) this->print(warnings());
      const All all(observers...);
      if (!(resumes(observers, *this, all) || ...)) (observe(observers, *this), ...);
      goal.check(end, this->clock_.time());
      const auto steps = [&] {
        while (this->clock_.time() < end && !this->damping_.is_at_rest() && !(stops(observers) || ...)) {
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

  /// The bound of the step at work.
  const auto& step_bound() const { return bound_; }
  /// Sentences that the user should read before the results.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all = RunningScene::warnings();
    this->cycle_.add_warnings(this->items_, all);
    this->add_warnings_of_method(all);
    return all;
  }
  /// All its items tell an archive what they remember.
  template <class Archive>
  static constexpr bool remembers() {
    return detail::every_kind<Items...>([]<class Kind>() {
      return detail::Serializable<typename detail::RunningItem<Kind, Method, Nodes>::type, Archive>;
    });
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(this->nodes_, bound_, this->damping_, this->ledger_, this->energy_, this->step_, this->stable_,
            this->bounded_, this->smallest_step_, this->reached_, this->clock_, this->cycle_);
    if constexpr ((detail::is_chosen_late<Items> || ...)) archive.same(this->chosen_late());
    this->each([&](auto& item) {
      archive.same(detail::constants_of(item));
      if constexpr (requires { item.serialize(archive); }) archive(item);
    });
  }

 private:
  Explicit(Scene<Items...>& scene, const ExplicitOptions& options, const Method& method,
           detail::Arrangement arrangement)
      : RunningScene(scene, std::move(arrangement), options, method), bound_(method.bound) {
    this->begin();
    compute_forces();
    if (this->cycle_.begin(this->items_, this->nodes_)) compute_forces();
    this->apply_loads();
    this->keep_own();
    if constexpr (RunningScene::has_ranks && std::is_same_v<typename Method::Bound, ElementStep> &&
                  std::is_same_v<typename Method::Damping, NoDamping> &&
                  std::is_same_v<typename Method::Cycle, NoSubcycling>)
      this->share_nodes();
  }

  void compute_forces() {
    const StableStep before = this->stable_;
    if constexpr (RunningScene::has_debris)
      this->advance_parts([&](std::size_t part) { this->take_debris(part, this->step_.dt, this->ledger_); });
    else
      this->advance_parts(detail::NothingBefore{});
    bound_.extend(this->stable_, this->nodes_, this->items_, this->execution_);
    this->bound_by_items();
    if (!this->cycle_.is_complete()) this->stable_ = before;
    detail::move_with_bodies(this->nodes_);
  }

  [[no_unique_address]] typename Method::Bound::template Running<Nodes, RunningItems> bound_;
};

template <class... Items>
Explicit(Scene<Items...>) -> Explicit<Method<>, Items...>;
template <class... Items, class... Policies>
Explicit(Scene<Items...>, ExplicitOptions, Policies...) -> Explicit<Method<Policies...>, Items...>;
template <class... Items, class First, class... Policies>
  requires(!std::convertible_to<First, ExplicitOptions>)
Explicit(Scene<Items...>, First, Policies...) -> Explicit<Method<First, Policies...>, Items...>;

}  // namespace strike
