#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/any_run.hpp>
#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/ill_formed_run.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/each_of.hpp>
#include <strike/error.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Before a part of a scene without debris there is nothing to do.
struct NothingBefore {
  void operator()(std::size_t) const {}
};

/// A scene at work: its nodes in the numbers of a run and its items with their types, and the ways to reach them.
template <class Method, class... Items>
class RunningScene : public AnyRun<Method, typename Method::template Nodes<Scene<Items...>::nodes_turn>> {
  using Base = AnyRun<Method, typename Method::template Nodes<Scene<Items...>::nodes_turn>>;

 public:
  using typename Base::Nodes;

  /// The items at work, in the order of the scene: `auto& [bar, wall] = run.items()`.
  auto& items() { return items_; }
  const auto& items() const { return items_; }
  /// Item i of the scene at work: a RunningPart, a load, a contact.
  template <std::size_t i>
  auto& item() {
    return chosen<i, sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& item() const {
    return chosen<i, sizeof...(Items)>(*this);
  }
  /// Part i of the scene, counted among the parts from 0.
  template <std::size_t i>
  auto& part() {
    return chosen<place_of(i, is_part<Items>...), sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& part() const {
    return chosen<place_of(i, is_part<Items>...), sizeof...(Items)>(*this);
  }
  /// f(part) for each RunningPart.
  template <class F>
  void each_part(const F& f) const {
    each([&](const auto& item) {
      if constexpr (is_running_part<std::remove_cvref_t<decltype(item)>>) f(item);
    });
  }
  /// The time that the busiest process has taken for the elements since the start, in times of the mean. All processes
  /// ask together.
  double imbalance() const {
    double mine = 0;
    each_part([&](const auto& part) { mine += part.seconds(); });
    const std::vector<double> all = of_all_ranks(this->nodes_.ranks(), mine);
    const double sum = std::accumulate(all.begin(), all.end(), 0.0);
    return sum > 0 ? *std::max_element(all.begin(), all.end()) * static_cast<double>(all.size()) / sum : 1;
  }
  /// f(body) for each RigidBody.
  template <class F>
  void each_body(const F& f) const {
    each(of_bodies(f));
  }
  /// Contact i of the scene, counted among the items that resolve contact from 0, walls and ties among them.
  template <std::size_t i>
  auto& contact() {
    return chosen<place_of(i, is_contact<Items, Nodes>...), sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& contact() const {
    return chosen<place_of(i, is_contact<Items, Nodes>...), sizeof...(Items)>(*this);
  }

 protected:
  template <class Item>
  static constexpr bool is_debris = requires { requires std::remove_cvref_t<Item>::is_born; };
  using RunningItems = std::tuple<typename RunningItem<Items, Method, Nodes>::type...>;

  static constexpr bool has_debris =
      any_kind<Items...>([]<class Kind>() { return is_debris<typename RunningItem<Kind, Method, Nodes>::type>; });

  RunningScene(Scene<Items...>& scene, Arrangement arrangement, const ExplicitOptions& options = {},
               const Method& method = Method())
      : Base(scene.nodes, std::move(arrangement.nodes), options, method),
        items_(start(scene.items, this->nodes_, arrangement)) {
    list_items();
    if constexpr (has_debris) begin_debris();
  }
  RunningScene(const RunningScene& other) : Base(other), items_(other.items_) { list_items(); }
  RunningScene(RunningScene&& other) : Base(std::move(other)), items_(std::move(other.items_)) { list_items(); }
  RunningScene& operator=(const RunningScene& other) {
    if (this != &other) *this = RunningScene(other);
    return *this;
  }
  RunningScene& operator=(RunningScene&& other) {
    Base::operator=(std::move(other));
    items_ = std::move(other.items_);
    list_items();
    return *this;
  }
  ~RunningScene() = default;

  template <class F>
  static auto of_bodies(const F& f) {
    return [&](auto& item) {
      if constexpr (is_rigid_body<std::remove_cvref_t<decltype(item)>>) f(item);
    };
  }
  template <class F>
  void each(const F& f) {
    each_item(items_, f);
  }
  template <class F>
  void each(const F& f) const {
    each_item(items_, f);
  }
  /// Each process keeps the states of its own elements.
  void keep_own() {
    each([](auto& item) {
      if constexpr (is_running_part<std::remove_cvref_t<decltype(item)>>) item.keep_own();
    });
  }
  /// The sizes of its lists and the numbers of its alternatives, in their order.
  std::vector<std::size_t> chosen_late() const {
    std::vector<std::size_t> all;
    each_of(items_, [&](const auto& item) { add_chosen(item, all); });
    return all;
  }
  /// Errors: debris of a part that is not before it, that has debris already, or whose elements cannot become
  /// particles.
  void begin_debris() {
    std::vector<std::size_t> sources;
    each([&](auto& part) {
      if constexpr (is_debris<decltype(part)>) {
        const std::size_t of = part.source();
        const auto refuse = [&](const char* why) {
          throw Error(joined({"strike: part ", std::to_string(part.number()), " is Debris of part ", std::to_string(of),
                              ", which ", why}));
        };
        if (of >= part.number()) refuse("is not before it in the scene; put it there.");
        if (std::count(sources.begin(), sources.end(), of) > 0) refuse("has debris already; give a part one debris.");
        sources.push_back(of);
        each_part([&](const auto& source) {
          if (source.number() == of) part.follow(source, this->nodes_);
        });
      }
    });
  }
  /// Gives the debris that is part `number` the elements that its source has lost in the step dt.
  void take_debris(std::size_t number, double dt, Ledger& ledger) {
    each([&](auto& part) {
      if constexpr (is_debris<decltype(part)>)
        if (part.number() == number)
          each_part([&](const auto& source) {
            if (source.number() == part.source()) part.take(source, this->nodes_, dt, ledger);
          });
    });
  }

  RunningItems items_;

 private:
  void list_items() {
    this->list_none();
    std::size_t place = 0;
    each_of(items_, [&](auto& item) {
      each_within(item, [&](auto& one) { this->list(one, place); });
      ++place;
    });
  }
  static RunningItems start(std::tuple<Items...>& items, Nodes& nodes, Arrangement& arrangement) {
    std::size_t part = 0;
    return std::apply(
        [&](auto&... item) {
          if constexpr (!has_debris)  // which needs the states of what it comes from
            (RunningItem<Items, Method, Nodes>::place(item, arrangement), ...);
          return RunningItems{RunningItem<Items, Method, Nodes>::start(item, nodes, arrangement, part)...};
        },
        items);
  }

  template <std::size_t place, std::size_t count, class Run>
  static auto& chosen(Run& run) {
    static_assert(place < count,
                  "strike: the scene of this run has no such item: item<i>() counts all items from 0, part<i>() the "
                  "parts, contact<i>() the contacts.");
    if constexpr (place < count)
      return std::get<place>(run.items_);
    else
      return ill_formed_item;
  }
};

}  // namespace strike::detail
