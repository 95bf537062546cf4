#pragma once
// Wrong numbers in a model (strike/range.hpp) as one suite:
//   testing::refuses_wrong_numbers(my_model, tried, [](const auto& model) { return is_finite(run(model)); });
// Every number that its `ranges` visit becomes NaN, its negative, 0, -0, infinite and 1e300; a count the least and the
// largest of its type. What uses the model refuses it by a sentence that names the number, or the number means
// something: then the results are finite and no energy is created. NaN is always refused, but where the range says that
// it stands for a number that is not given. Constructors and functions are told of by the names of their arguments:
//   testing::refuses_wrong_arguments("graded", {{"lower", 0.}, {"cells", 3}}, tried, [](const auto& x) { ... });
// That `ranges` visit every number is tested by tests/cheat_sheet/check.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

#include "support/catch.hpp"

namespace strike::testing {

/// The classes and numbers of models that were tried, and what became of them.
struct WrongNumbers {
  std::set<std::string> classes, numbers;
  std::size_t injected = 0, refused = 0, silent = 0;

  void print(const char* of) const {
    std::printf("%s: %zu classes, %zu numbers, %zu wrong ones: %zu refused, %zu have a meaning, %zu silent\n", of,
                classes.size(), numbers.size(), injected, refused, injected - refused - silent, silent);
  }
};

namespace detail {
using namespace strike::detail;

/// A number that is stored in a model.
struct StoredNumber {
  std::string model, name;
  std::variant<double*, float*, int*, Index*, std::size_t*> place;
  bool may_be_nan;
};
template <class Number>
inline constexpr bool is_stored = std::is_constructible_v<decltype(StoredNumber::place), Number*>;

/// Collects the numbers of a model that is not constant; numbers that `ranges` compute are no members.
class Collect {
 public:
  Collect(std::vector<StoredNumber>& found, std::string model) : found_(&found), model_(std::move(model)) {}

  template <class Number>
  void operator()(std::string_view name, Number&& number, const Range& range, std::string_view = {}) const {
    if constexpr (requires { number.size(); }) {
      decltype(number.size()) i = 0;
      for (const auto& one : number) add(joined({name, "[", std::to_string(i++), "]"}), one, range.may_be_nan);
    } else if constexpr (std::is_lvalue_reference_v<Number>) {
      add(std::string(name), number, range.may_be_nan);
    }
  }
  template <class Vector>
  void operator()(std::string_view name, const Vector& vector, VectorRange, std::string_view = {}) const {
    if constexpr (requires { vector.data(); })
      for (Eigen::Index i = 0; i < vector.size(); ++i) add(std::string(name), vector.data()[i], false);
  }
  template <class Model>
  void operator()(const Model& model, std::string_view = {}) const {
    if constexpr (answers<Ranges, const Model, const Collect>)
      Ranges::call(model, Collect(*found_, class_name<Model>()));
  }

 private:
  template <class Number>
  void add(const std::string& name, const Number& number, bool may_be_nan) const {
    if constexpr (is_stored<Number>) {
      decltype(StoredNumber::place) place = const_cast<Number*>(&number);
      for (const StoredNumber& known : *found_)
        if (known.place == place) return;
      found_->push_back({model_, name, place, may_be_nan});
    }
  }

  std::vector<StoredNumber>* found_;
  std::string model_;
};

template <class Number>
std::vector<Number> wrong_for(Number right) {
  using Limits = std::numeric_limits<Number>;
  if constexpr (std::is_floating_point_v<Number>)
    return {Limits::quiet_NaN(), -right, 0, -Number(0), Limits::infinity(), -Limits::infinity(), Number(1e300)};
  else
    return {static_cast<Number>(Number(0) - right), 0, Limits::min(), Limits::max()};
}

/// Gives each number its wrong values, one after the other. `use` makes use of the numbers; it tells whether the
/// results make sense, or throws the Error that refuses them.
inline void try_wrong_numbers(const std::vector<StoredNumber>& numbers, WrongNumbers& tried,
                              const std::function<bool()>& use) {
  CHECK(use());
  for (const StoredNumber& number : numbers) {
    tried.classes.insert(number.model), tried.numbers.insert(number.model + "." + number.name);
    std::visit(
        [&](auto* place) {
          const auto right = *place;
          for (const auto wrong : wrong_for(right)) {
            if (wrong == right) continue;
            *place = wrong;
            ++tried.injected;
            std::string sentence;
            bool is_told = false;
            try {
              is_told = use() && (!std::isnan(double(wrong)) || number.may_be_nan);
            } catch (const Error& error) {
              sentence = error.what();
              is_told = sentence.find(number.name) != sentence.npos;
            }
            if (!sentence.empty()) ++tried.refused;
            if (!is_told) ++tried.silent;
            CAPTURE(number.model, number.name, wrong, sentence);
            CHECK(is_told);
            *place = right;
          }
        },
        number.place);
  }
}

}  // namespace detail

/// `use(model)` makes use of the model and says whether the results make sense.
template <class Model, class Use>
void refuses_wrong_numbers(const Model& model, WrongNumbers& tried, const Use& use) {
  Model changed = model;
  std::vector<detail::StoredNumber> numbers;
  detail::Collect(numbers, "")(changed);
  detail::try_wrong_numbers(numbers, tried, [&] { return use(changed); });
}
/// An argument of a constructor or a function.
struct Argument {
  std::string name;
  double value;
};
/// The numbers that a constructor, or a function, checks itself: `use(values)` calls it.
inline void refuses_wrong_arguments(const std::string& of, const std::vector<Argument>& arguments, WrongNumbers& tried,
                                    const std::function<bool(const std::vector<double>&)>& use) {
  std::vector<double> values;
  for (const Argument& argument : arguments) values.push_back(argument.value);
  std::vector<detail::StoredNumber> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) numbers.push_back({of, arguments[i].name, &values[i], false});
  detail::try_wrong_numbers(numbers, tried, [&] { return use(values); });
}

}  // namespace strike::testing
