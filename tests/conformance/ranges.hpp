#pragma once
// Wrong numbers in a model (strike/range.hpp) as one suite:
//   TEST_CASE("conformance: wrong numbers of my law") { testing::refuses_wrong_numbers(my_law); }
// Every number that its `ranges` visit becomes NaN, its negative, 0, infinite and 1e300. Each is refused by a sentence
// that names class and member, or means something: then the model runs to finite results and creates no energy. NaN is
// always refused. That `ranges` visit every number is tested by tests/cheat_sheet/check.
#include <array>
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
#include <vector>

#include <strike/element.hpp>
#include <strike/error.hpp>
#include <strike/material.hpp>
#include <strike/range.hpp>
#include <strike/section.hpp>
#include <strike/verify/single_element.hpp>

#include "conformance/material.hpp"

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
  const void* place;
  double value;
  std::function<void(double)> set;
};

/// Collects the numbers of a model that is not constant; numbers that `ranges` compute are no members.
class Collect {
 public:
  Collect(std::vector<StoredNumber>& found, std::string model) : found_(&found), model_(std::move(model)) {}

  template <class Number>
  void operator()(std::string_view name, Number&& number, const Range&, std::string_view = {}) const {
    if constexpr (requires { number.size(); })
      for (std::size_t i = 0; i < number.size(); ++i) add(joined({name, "[", std::to_string(i), "]"}), number[i]);
    else if constexpr (std::is_lvalue_reference_v<Number>)
      add(std::string(name), number);
  }
  template <class Vector>
  void operator()(std::string_view name, const Vector& vector, VectorRange, std::string_view = {}) const {
    if constexpr (requires { vector.data(); })
      for (Eigen::Index i = 0; i < vector.size(); ++i) add(std::string(name), vector.data()[i]);
  }
  template <class Model>
  void operator()(const Model& model, std::string_view = {}) const {
    if constexpr (answers<Ranges, const Model, const Collect>)
      Ranges::call(model, Collect(*found_, class_name<Model>()));
  }

 private:
  template <class Number>
  void add(const std::string& name, const Number& number) const {
    for (const StoredNumber& known : *found_)
      if (known.place == &number) return;
    if constexpr (std::is_floating_point_v<Number>)
      found_->push_back({model_, name, &number, static_cast<double>(number),
                         [at = const_cast<Number*>(&number)](double x) { *at = static_cast<Number>(x); }});
  }

  std::vector<StoredNumber>* found_;
  std::string model_;
};

/// Two closed cycles of strain: finite stresses, and but for a small part no energy comes back.
template <class M>
bool cycles(const M& material) {
  constexpr double amplitude = 1e-3;
  constexpr auto components = component<Tensor<M>>;
  constexpr std::array A{1., .5, -.3, .2, -.7, .8}, B{-.4, .9, .2, -.8, .6, -.1};
  constexpr int cycle[6][2] = {{1, 0}, {0, 1}, {-1, -1}, {0, 1}, {-1, 0}, {1, -1}};
  Point<M, double> point(material);
  double work = 0, turnover = 0;
  for (const auto& [a, b] : cycle) {
    Tensor<M> strain{};
    for (std::size_t c = 0; c < components.size(); ++c) strain.*components[c] = amplitude / 10 * (a * A[c] + b * B[c]);
    for (int i = 0; i < 10; ++i) {
      const Tensor<M> before = point.stress;
      point.step(strain, 1e-6);
      const double done = 0.5 * point.J * double_dot(before + point.stress, strain);
      work += done, turnover += std::abs(done);
      if (!std::isfinite(norm(point.stress))) return false;
    }
  }
  constexpr bool burns = requires { material.burn; };
  return burns || work >= -4 * amplitude * turnover;
}

/// An element that is strained, bent out of shape and brought back.
template <class E, class M>
bool cycles(const E& element, const M& material) {
  verify::SingleElement single{element, material, verify::unit_corners<E>()};
  const double dt = 0.1 * single.now().stable_step;
  if (!(dt > 0 && std::isfinite(dt))) return false;
  Nodal<double, motions<E>> v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = std::sin(1 + 2.3 * static_cast<double>(i * i));
  double turnover = 0;
  for (int i = 0; i < 40; ++i) {
    const double before = single.now().external;
    const auto& now = single.step((i < 10 || i >= 30 ? 1 : -1) * (1e-4 / dt) * v, dt);
    turnover += std::abs(now.external - before);
    if (!now.force.allFinite() || !std::isfinite(now.internal + now.hourglass + now.bulk_viscosity)) return false;
  }
  return single.now().internal + single.now().hourglass + single.now().bulk_viscosity >= -1e-2 * turnover;
}

inline const Elastic soft_metal{.density = 2700, .youngs_modulus = 70e9, .poissons_ratio = .3};

/// Runs what a model is made for.
template <class Model>
bool works(const Model& model) {
  constexpr LinearEos eos{.density = 2700, .bulk_modulus = 71e9};
  if constexpr (requires { Model::nodes; }) {
    if constexpr (turns_nodes<Model>())
      return cycles(model, Homogeneous{PlaneStress{soft_metal}, 0.1});
    else
      return cycles(model, soft_metal);
  } else if constexpr (SolidMaterial<Model>) {
    return cycles(model);
  } else if constexpr (PlaneMaterial<Model>) {
    return cycles(model);
  } else if constexpr (PlateSection<Model>) {
    return cycles(Plate4{}, model);
  } else if constexpr (EquationOfState<Model>) {
    return cycles(Hex8{}, Fluid{model}) && works(Solid{model, ElasticStrength{1e9}});
  } else if constexpr (Strength<Model>) {
    return works(Solid{eos, model});
  } else {
    return works(Solid{eos, VonMises{.shear_modulus = 27e9, .yield_stress = 1e6}, model});
  }
}

}  // namespace detail

/// The sentence by which a model is refused; empty if it is not.
template <class Model>
std::string refusal(const Model& model) {
  try {
    detail::check_ranges(model);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// `works(model)` runs the model and says whether the results make sense; an Error that names the member does, too.
template <class Model, class Works>
void refuses_wrong_numbers(const Model& model, WrongNumbers& tried, const Works& works) {
  Model changed = model;
  std::vector<detail::StoredNumber> numbers;
  detail::Collect(numbers, "")(changed);
  CHECK(refusal(changed) == "");
  for (const detail::StoredNumber& number : numbers) {
    tried.classes.insert(number.model), tried.numbers.insert(number.model + "." + number.name);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), -number.value, 0.0, infinity, -infinity, 1e300}) {
      if (wrong == number.value) continue;
      number.set(wrong);
      ++tried.injected;
      CAPTURE(number.model, number.name, wrong);
      std::string sentence = refusal(changed);
      bool is_named = sentence.find(number.model) != sentence.npos && sentence.find(number.name) != sentence.npos;
      if (sentence.empty() && !std::isnan(wrong)) try {
          is_named = works(changed);
        } catch (const Error& error) {
          sentence = error.what();
          is_named = sentence.find(number.name) != sentence.npos;
        }
      if (!sentence.empty()) ++tried.refused;
      if (!is_named) ++tried.silent;
      CAPTURE(sentence);
      CHECK(is_named);
      number.set(number.value);
    }
  }
}
template <class Model>
void refuses_wrong_numbers(const Model& model, WrongNumbers& tried) {
  refuses_wrong_numbers(model, tried, [](const Model& changed) { return detail::works(changed); });
}
template <class Model>
void refuses_wrong_numbers(const Model& model) {
  WrongNumbers tried;
  refuses_wrong_numbers(model, tried);
}

}  // namespace strike::testing
