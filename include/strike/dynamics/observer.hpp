#pragma once
#include <concepts>
#include <exception>
#include <string>
#include <type_traits>

#include <strike/error.hpp>
#include <strike/protocol.hpp>
#include <strike/text.hpp>

// An observer of a run: run.until(end, observer, ...).
//
// Requirements. An observer has function 1 and may have the others; all observers see one moment before any sees the
// next, in the order in which they are given.
//  1. f() or f(run)                     called before the first step and after each; returns nothing
//  2. stops() -> bool                   asked after each step: true ends the run
//  3. last(run)                         called when the run has to be given up, before the Error leaves; of all
//                                       observers, even if that of another throws
//  4. save(run, observers)              called after a step that all observers have seen
//  5. resume(run, observers) -> bool    called before the run begins: true if it has put the run and all observers
//                                       where they once were, so that none is called before the first step
//     keeps<Run>                        static constexpr bool, false if an item of the run has no serialize; or none
//  6. Action, Condition                 the types of what it calls as f() or f(run), and of what it asks so for a bool
//  7. serialize(archive)                its memory, for a Checkpoint; see strike/output/archive.hpp
//
// Laws. An observer changes nothing of the run; what it has written is whole when it returns.
//
// Models: Every, StopWhen (strike/dynamics/), Progress, Checkpoint (strike/output/); any lambda.

namespace strike::detail::observer {

struct Stops {
  struct Decoy {
    int stops;
  };
  template <class Observer>
  using Member = decltype(&Observer::stops);
  static auto call(auto& observer) -> decltype(bool(observer.stops())) { return observer.stops(); }
};
struct Last {
  struct Decoy {
    int last;
  };
  template <class Observer>
  using Member = decltype(&Observer::last);
  static auto call(auto& observer, auto& run) -> decltype(observer.last(run)) { return observer.last(run); }
};
struct Save {
  struct Decoy {
    int save;
  };
  template <class Observer>
  using Member = decltype(&Observer::save);
  static auto call(auto& observer, auto& run, auto& all) -> decltype(observer.save(run, all)) {
    return observer.save(run, all);
  }
};
struct Resume {
  struct Decoy {
    int resume;
  };
  template <class Observer>
  using Member = decltype(&Observer::resume);
  static auto call(auto& observer, auto& run, auto& all) -> decltype(bool(observer.resume(run, all))) {
    return observer.resume(run, all);
  }
};

template <class Observer, class Run>
concept CalledWithRun = requires(Observer& observer, Run& run) { observer(run); };
template <class Observer>
concept CalledAlone = requires(Observer& observer) { observer(); };

/// The first fault of an observer, in the order of the requirements; `All` is the tuple of all observers.
enum class Fault { none, not_callable, returns_bool, condition, stops, last, save, resume, forgetful };

/// The fault of what is called as f(run) or f().
template <class Action, class Run>
constexpr Fault call_fault() {
  if constexpr (CalledWithRun<Action, Run>)
    return std::same_as<std::remove_cvref_t<std::invoke_result_t<Action&, Run&>>, bool> ? Fault::returns_bool
                                                                                        : Fault::none;
  else if constexpr (CalledAlone<Action>)
    return std::same_as<std::remove_cvref_t<std::invoke_result_t<Action&>>, bool> ? Fault::returns_bool : Fault::none;
  else
    return Fault::not_callable;
}

/// The condition is asked as f(run) or f().
template <class Condition, class Run>
constexpr bool is_condition() {
  if constexpr (CalledWithRun<Condition, Run>)
    return std::convertible_to<std::invoke_result_t<Condition&, Run&>, bool>;
  else
    return requires(Condition& condition) {
      { condition() } -> std::convertible_to<bool>;
    };
}

template <class Observer, class Run, class All>
constexpr Fault fault() {
  if constexpr (call_fault<Observer, Run>() != Fault::none) return call_fault<Observer, Run>();
  if constexpr (requires { typename Observer::Action; })
    if constexpr (call_fault<typename Observer::Action, const Run>() != Fault::none)
      return call_fault<typename Observer::Action, const Run>();
  if constexpr (requires { typename Observer::Condition; })
    if constexpr (!is_condition<typename Observer::Condition, const Run>()) return Fault::condition;
  if constexpr (nearly<Stops, Observer>) return Fault::stops;
  if constexpr (nearly<Last, Observer, Run>) return Fault::last;
  if constexpr (nearly<Save, Observer, Run, const All>) return Fault::save;
  if constexpr (nearly<Resume, Observer, Run, const All>) return Fault::resume;
  if constexpr (requires { Observer::template keeps<Run>; })
    if constexpr (!Observer::template keeps<Run>) return Fault::forgetful;
  return Fault::none;
}

/// Reports a fault in one sentence; true if there is none.
template <Fault found>
constexpr bool report() {
  static_assert(found != Fault::not_callable,
                "strike: an observer of a run is called as f() or f(run), such as [&] { film.write(run); } or "
                "Every{1e-3, [&] { ... }}.");
  static_assert(found != Fault::returns_bool,
                "strike: an observer returns a bool, which a run does not read: end a run by StopWhen{condition}, or "
                "return nothing.");
  static_assert(
      found != Fault::condition,
      "strike: the condition of a StopWhen is called as f() or f(run) and returns a bool, such as [&] { return "
      "run.energy().kinetic < 1e-3; }.");
  static_assert(found != Fault::stops, "strike: stops of an observer is called as stops() and returns a bool.");
  static_assert(found != Fault::last, "strike: last of an observer is called as last(run).");
  static_assert(found != Fault::save, "strike: save of an observer is called as save(run, observers).");
  static_assert(found != Fault::resume,
                "strike: resume of an observer is called as resume(run, observers) and returns a bool.");
  static_assert(found != Fault::forgetful,
                "strike: an item of this Scene has no function serialize for a checkpoint: give it template <class "
                "Archive> void serialize(Archive& archive) { archive(...); }, with empty braces if it has no state.");
  return found == Fault::none;
}
/// Calls f(run), or else f().
template <class Observer, class Run>
void observe(Observer& observer, Run&) {
  observer();
}
template <class Observer, class Run>
  requires CalledWithRun<Observer, Run>
void observe(Observer& observer, Run& run) {
  observer(run);
}
template <class Observer>
bool stops(const Observer&) {
  return false;
}
template <class Observer>
  requires answers<Stops, const Observer>
bool stops(const Observer& observer) {
  return observer.stops();
}
template <class Observer, class Run, class All>
bool resumes(Observer&, Run&, const All&) {
  return false;
}
template <class Observer, class Run, class All>
  requires answers<Resume, Observer, Run, const All>
bool resumes(Observer& observer, Run& run, const All& all) {
  return observer.resume(run, all);
}

/// Calls f; if it throws, `last` of all observers before the error leaves, to which what one of them throws is added.
template <class F, class Run, class... Observers>
void call_with_last(const F& f, Run& run, Observers&... observers) {
  std::string added;
  [[maybe_unused]] const auto last = [&](auto& observer) {
    try {
      call_if_present<Last>(observer, run);
    } catch (const std::exception& error) {
      added += joined({" Then an observer has failed too: ", error.what()});
    } catch (...) {
      added += " Then an observer has failed too.";
    }
  };
  try {
    f();
  } catch (const Error& error) {
    (last(observers), ...);
    if (added.empty()) throw;
    throw Error(error.what() + added);
  } catch (...) {
    (last(observers), ...);
    throw;
  }
}

}  // namespace strike::detail::observer
