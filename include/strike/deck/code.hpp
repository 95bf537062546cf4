#pragma once
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/eos/tabulated.hpp>
#include <strike/material/explosive.hpp>
#include <strike/material/strength/cowper_symonds.hpp>
#include <strike/material/strength/prony.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

// Objects as the C++ that makes them: numbers by the shortest text that reads back as the same.
namespace strike::detail {

inline std::string code_of(double number) { return shortest(number); }
inline std::string code_of(const Eigen::Vector3d& v) {
  return joined({"{", shortest(v.x()), ", ", shortest(v.y()), ", ", shortest(v.z()), "}"});
}
inline std::string code_of(const std::vector<Eigen::Vector3d>& all) {
  std::string text;
  for (const Eigen::Vector3d& v : all) text += (text.empty() ? "" : ", ") + code_of(v);
  return joined({"{", text, "}"});
}

inline std::string code_of(const TabulatedHardening& law);
inline std::string code_of(const TabulatedEos& eos);
template <class Law>
std::string code_of(const CowperSymonds<Law>& law);
template <std::size_t n>
std::string code_of(const Prony<n>& law);
template <class Model>
std::string code_of(const Model& model);

/// Writes the numbers of an aggregate that are not its defaults, and the models in it, as its `ranges` visit them.
class Written {
 public:
  /// `usual` are the numbers of a model of defaults, in the same order.
  explicit Written(std::string& text, const std::vector<double>& usual) : text_(text), usual_(usual) {}

  template <class Number>
    requires std::convertible_to<Number, double> || std::is_arithmetic_v<Number>
  void operator()(std::string_view name, const Number& number, const Range&, std::string_view = {}) const {
    const auto value = static_cast<double>(number);
    const std::size_t place = place_++;
    const bool is_member = name.find(' ') == name.npos;
    if (!is_member || (place < usual_.size() && value == usual_[place])) return;
    text_ += joined({text_.empty() ? "." : ", .", name, " = ", shortest(value)});
  }
  template <class Model>
  void operator()(const Model& model, std::string_view = {}) const {
    if constexpr (!std::is_empty_v<Model>) text_ += joined({text_.empty() ? "" : ", ", code_of(model)});
  }

 private:
  std::string& text_;
  const std::vector<double>& usual_;
  mutable std::size_t place_ = 0;
};

/// An aggregate by its class and the names of its numbers.
template <class Model>
std::string code_of(const Model& model) {
  std::string numbers;
  std::vector<double> usual;
  if constexpr (std::is_default_constructible_v<Model>) usual = constants_of(Model{});
  if constexpr (answers<Ranges, const Model, const Written>) Ranges::call(model, Written(numbers, usual));
  return joined({class_name<Model>(), "{", numbers, "}"});
}
inline std::string code_of(const TabulatedHardening& law) {
  const std::vector<double> numbers =
      constants_of(law);  // G, strain and stress of the first point; then the stress twice
  std::string points;
  for (std::size_t i = 1; i + 1 < numbers.size(); i += i > 1 ? 3 : 2)
    points += joined({i > 1 ? ", {" : "{", shortest(numbers[i]), ", ", shortest(numbers[i + 1]), "}"});
  return joined({"TabulatedHardening{", shortest(law.shear_modulus), ", {", points, "}}"});
}
template <class Law>
std::string code_of(const CowperSymonds<Law>& law) {
  return joined({"CowperSymonds{", code_of(law.law), ", ", shortest(law.D), ", ", shortest(law.p), "}"});
}
/// Of the terms those that have a share, or one of none.
template <std::size_t n>
std::string code_of(const Prony<n>& law) {
  std::string terms;
  std::size_t count = 0;
  for (const auto& [share, time] : law.terms)
    if (share > 0) {
      terms += joined({count > 0 ? ", {" : "{", shortest(share), ", ", shortest(time), "}"});
      ++count;
    }
  if (count == 0) terms = "{0, 1}", count = 1;
  return joined({"Prony<", std::to_string(count), ">{.shear_modulus = ", shortest(law.shear_modulus), ", .terms = {",
                 terms, "}}"});
}
inline std::string code_of(const TabulatedEos& eos) {
  std::string points;
  for (const auto& [e, C, T] : eos.points())
    points += joined({points.empty() ? "{" : ", {", shortest(e), ", ", shortest(C), T != 0 ? ", " : "",
                      T != 0 ? shortest(T) : "", "}"});
  const bool is_cut_off = eos.pressure_cutoff != TabulatedEos::no_cutoff;
  return joined({"TabulatedEos{", shortest(eos.density), ", {", points, "}, ", shortest(eos.gamma), ", ",
                 shortest(eos.initial_energy), is_cut_off ? ", " : "", is_cut_off ? shortest(eos.pressure_cutoff) : "",
                 "}"});
}
inline std::string code_of(const DetonationPoints& ignition) {
  std::string points;
  for (const DetonationPoint& point : ignition.points())
    points += joined({points.empty() ? "{" : ", {", code_of(point.place), ", ", shortest(point.time), "}"});
  return points.empty() ? "DetonationPoints{}" : joined({"DetonationPoints{{", points, "}}"});
}
template <class Eos, class Start>
std::string code_of(const Explosive<Eos, Start>& law) {
  return joined({"Explosive{", code_of(law.products), ", ", code_of(law.ignition), ", ", code_of(law.burn), "}"});
}
/// An element by its first policy, where that is not the usual one, and its bulk viscosity, where its numbers are not.
template <class First, class Usual>
std::string code_of_element(const char* name, const First& first, const Usual&, const BulkViscosity& viscosity) {
  if (constants_of(viscosity) != constants_of(BulkViscosity{}))
    return joined({name, "{", code_of(first), ", HughesWinget{}, ", code_of(viscosity), "}"});
  return joined({name, "{", std::is_same_v<First, Usual> ? std::string{} : code_of(first), "}"});
}
template <class H>
std::string code_of(const Hex8<H>& element) {
  return code_of_element("Hex8", element.hourglass, PhysicalHourglass{}, element.bulk_viscosity);
}
inline std::string code_of(const Tet4<>& element) {
  return code_of_element("Tet4", element.pressure, NodalPressure{}, element.bulk_viscosity);
}
inline std::string code_of(const Plate4<>&) { return "Plate4{}"; }
inline std::string code_of(const Plate3<>&) { return "Plate3{}"; }

}  // namespace strike::detail
