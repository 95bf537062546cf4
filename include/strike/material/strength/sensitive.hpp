#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>

#include <strike/error.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

/// A number that has derivatives by N variables, as the number U of a formula: with those derivatives if U carries
/// them, be it deep inside (a dual number of duals), else a constant.
template <class U, std::size_t N>
struct Embedding {
  static U of(const Dual<double, N>& a) { return U(a.value()); }
};
template <class V, std::size_t N>
struct Embedding<Dual<V, N>, N> {
  static Dual<V, N> of(const Dual<double, N>& a) {
    std::array<V, N> derivatives;
    for (std::size_t k = 0; k < N; ++k) derivatives[k] = V(a.derivative(k));
    return {V(a.value()), derivatives};
  }
};
template <class V, std::size_t N, std::size_t K, std::size_t M>
struct Embedding<Dual<Dual<V, N>, K>, M> {
  static Dual<Dual<V, N>, K> of(const Dual<double, M>& a) { return Embedding<Dual<V, N>, M>::of(a); }
};

}  // namespace detail

/// A strength law whose parameters are dual numbers: a run in dual numbers then knows how everything that it computes
/// depends on them. The law stays as it is, its parameters plain numbers of which some are named by their members:
///   const std::array<Dual<double, 2>, 2> p = ...;
///   Sensitive{VonMises{.shear_modulus = 43.3}, p, &VonMises::yield_stress, &VonMises::hardening_modulus}
/// d sigma/dp at fixed strain, rate and temperature is the difference quotient of fourth order of the law's own
/// formula, over 1e-3 p: exact to rounding where p stands linearly, else to 1e-12 of a smooth formula. In a run without
/// derivatives it is the law with the values of p.
/// Errors: a parameter that is 0, for then it has no scale; one that acts outside the flow stress.
template <class Law, std::size_t N, std::size_t M>
class Sensitive : public Law {
  static constexpr bool is_flow_law = FlowLaw<Law>;
  static_assert(is_flow_law, "strike: Sensitive needs a strength law with a flow_stress, such as VonMises.");

 public:
  template <std::same_as<double Law::*>... Member>
  requires(sizeof...(Member) == M) Sensitive(const Law& law, const std::array<Dual<double, N>, M>& parameters,
                                             Member... members)
      : Law(law), parameters_(parameters), members_{members...} {
    for (std::size_t m = 0; m < M; ++m) {
      check(m);
      this->*members_[m] = parameters_[m].value();
    }
  }

  template <class T, class... More>
  requires requires(const Law law, T x, More... more) { law.flow_stress(x, more...); }
  T flow_stress(const T& e, const More&... more) const {
    const Law& law = *this;
    T sigma = law.flow_stress(e, more...);
    for (std::size_t m = 0; m < M; ++m) {
      const double value = parameters_[m].value(), h = 1e-3 * value;
      const auto at = [&](double steps) -> T {
        Law other = law;
        other.*members_[m] = value + steps * h;
        return other.flow_stress(e, more...);
      };
      const T slope = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) * (1 / (12 * h));
      sigma += slope * detail::Embedding<T, N>::of(parameters_[m] - value);
    }
    return sigma;
  }

  /// The law's own way to its increment does not know the parameters.
  void plastic_increment() const = delete;

 private:
  void check(std::size_t m) const {
    const auto refuse = [&](const std::string& why) {
      throw Error(detail::joined({"strike: parameter ", std::to_string(m), " of a Sensitive law ", why}));
    };
    const double value = parameters_[m].value();
    if (!(std::abs(value) > 0 && std::isfinite(value)))
      refuse(detail::joined({"is ", detail::text(value), ", which has no scale; begin with another value."}));
    bool outside = members_[m] == &Law::shear_modulus;
    if constexpr (ThermalFlow<Law>)
      outside = outside || members_[m] == &Law::heating || members_[m] == &Law::initial_temperature;
    if (outside)
      refuse("acts outside its flow_stress, as the shear modulus and the heating do; name parameters of that formula.");
  }

  std::array<Dual<double, N>, M> parameters_;
  std::array<double Law::*, M> members_;
};
template <class Law, std::size_t N, std::size_t M, class... Member>
Sensitive(Law, std::array<Dual<double, N>, M>, Member...) -> Sensitive<Law, N, M>;

}  // namespace strike
