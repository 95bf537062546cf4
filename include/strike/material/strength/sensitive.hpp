#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>

#include <strike/error.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/range.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

template <class U>
constexpr std::size_t variables_of() {
  if constexpr (requires { U::variables(); })
    return U::variables();
  else
    return 0;
}

/// A number with derivatives by N variables as the number U of a formula: with these derivatives if U, or the number
/// inside it (a dual number of duals), carries them, else as a constant.
template <class U, std::size_t N>
U embedded(const Dual<double, N>& a) {
  constexpr bool nested = requires(U u) { u.value().value(); };
  if constexpr (nested) {
    return U(embedded<typename U::value_type>(a));
  } else if constexpr (variables_of<U>() == N) {
    std::array<typename U::value_type, N> derivatives;
    for (std::size_t k = 0; k < N; ++k) derivatives[k] = a.derivative(k);
    return {a.value(), derivatives};
  } else {
    return U(a.value());
  }
}

struct NoHeating {};
struct Heating {
  double initial_temperature, heating;
};
template <class Law>
auto heating_of(const Law& law) {
  if constexpr (ThermalFlow<Law>)
    return Heating{law.initial_temperature, law.heating};
  else
    return (void)law, NoHeating{};
}

}  // namespace detail

/// A strength law with derivatives of some parameters by N variables, so that all results of a run in dual numbers have
/// them too. The law stays as it is; its parameters are named by their members:
///   const std::array p{Dual<double, 2>::variable(0.4, 0), Dual<double, 2>::variable(0.1, 1)};
///   Sensitive{VonMises{.shear_modulus = 43.3}, p, &VonMises::yield_stress, &VonMises::hardening_modulus}
/// The members are plain numbers, so d sigma/dp at fixed strain, rate and temperature is the difference quotient of
/// fourth order of the law's own formula over 1e-3 p (Abramowitz and Stegun 1964, 25.3.6): exact to rounding where the
/// formula is linear in p, to some 1e-12 where it is smooth in it. In plain numbers Sensitive is the law with the
/// values of p. Errors: a parameter that is 0 and so has no scale, or that acts outside the flow stress.
template <class Law, std::size_t N, std::size_t M>
class Sensitive : public decltype(detail::heating_of(std::declval<Law>())) {
 public:
  double shear_modulus;

  template <class... Members>
  Sensitive(Law law, const std::array<Dual<double, N>, M>& parameters, Members... members)
      : decltype(detail::heating_of(law))(detail::heating_of(law)),
        shear_modulus(law.shear_modulus),
        law_(std::move(law)),
        parameters_(parameters) {
    constexpr bool named = sizeof...(Members) == M && (std::convertible_to<Members, double Law::*> && ...);
    static_assert(named,
                  "strike: after its parameters Sensitive names as many members of its law, such as "
                  "&VonMises::yield_stress.");
    if constexpr (named) {
      members_ = {members...};
      for (std::size_t i = 0; i < M; ++i) {
        check(i);
        law_.*members_[i] = parameters_[i].value();
      }
    }
  }

  /// The law in plain numbers.
  const Law& law() const { return law_; }

  void ranges(const auto& number) const {
    number(law_);
    number("shear_modulus", shear_modulus, range::positive);
  }
  std::string warning() const
    requires requires(Law law) { law.warning(); }
  {
    return law_.warning();
  }

  template <class T, class... More>
    requires requires(const Law law, T e, More... more) { law.flow_stress(e, more...); }
  T flow_stress(const T& e, const More&... more) const {
    T sigma = law_.flow_stress(e, more...);
    for (std::size_t i = 0; i < M; ++i) {
      const double p = parameters_[i].value(), h = 1e-3 * p;
      const auto at = [&](double value) -> T {
        Law other = law_;
        other.*members_[i] = value;
        return other.flow_stress(e, more...);
      };
      const T slope = (8.0 * (at(p + h) - at(p - h)) - (at(p + 2 * h) - at(p - 2 * h))) * (1 / (12 * h));
      sigma += slope * detail::embedded<T>(parameters_[i] - p);
    }
    return sigma;
  }

 private:
  void check(std::size_t i) const {
    const auto refuse = [&](const std::string& why) {
      throw Error(detail::joined({"strike: parameter ", std::to_string(i), " of Sensitive ", why}));
    };
    const double p = parameters_[i].value();
    if (!(std::abs(p) > 0 && std::isfinite(p)))
      refuse(detail::joined({"is ", detail::text(p), " and so has no scale; start with another value."}));
    bool outside = members_[i] == &Law::shear_modulus;
    if constexpr (ThermalFlow<Law>)
      outside = outside || members_[i] == &Law::heating || members_[i] == &Law::initial_temperature;
    if (outside)
      refuse(
          "is the shear modulus, the heating or the initial temperature, which act outside the flow stress; name "
          "parameters of that formula.");
  }

  Law law_;
  std::array<Dual<double, N>, M> parameters_;
  std::array<double Law::*, M> members_{};
};
template <class Law, std::size_t N, std::size_t M, class... Members>
Sensitive(Law, std::array<Dual<double, N>, M>, Members...) -> Sensitive<Law, N, M>;

}  // namespace strike
