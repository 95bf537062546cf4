#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>

#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// Linear viscoelasticity of the deviator, by Maxwell's elements beside a spring: the shear modulus relaxes as
///   G(t) = G0 [1 - sum g_k (1 - exp(-t/t_k))]
/// and the part of each element is integrated exactly for a constant rate in the step, at any dt/t_k (Taylor, Pister
/// and Goudreau 1970): h <- exp(-dt/t_k) h + 2 G0 g_k (1 - exp(-dt/t_k))/(dt/t_k) d. Recovery: after a quick load and
/// unload the stress at rest grows towards that of the spring. A term without a share changes no bit.
///   Prony<2> pvb{.shear_modulus = G0, .terms = {{.share = .9, .time = 1e-3}, {.share = .09, .time = 1}}};
template <std::size_t n>
struct Prony {
  struct Term {
    double share;  ///< g_k of G0, their sum at most 1 [1]
    double time;   ///< t_k > 0, of relaxation [time]
  };

  double shear_modulus;  ///< G0, instantaneous [stress]
  Term terms[n];

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    double left = 1 + 1e-12;  // for the rounding of the sum
    for (std::size_t k = 0; k < n; ++k) {
      const std::string term = detail::joined({"terms[", std::to_string(k), "]."});
      number(term + "share", terms[k].share, range::between(0, left), "all shares together are at most 1");
      number(term + "time", terms[k].time, range::positive);
      left -= terms[k].share;
    }
  }

  template <class T>
  struct State {
    std::array<SymmetricTensor<T>, n> overstress{};  ///< h_k, still to relax [stress]

    auto spatial_tensors() {
      return std::apply([](auto&... h) { return std::tie(h...); }, overstress);
    }
  };

  /// G(t).
  double relaxation(double t) const {
    double share = 1;
    for (const auto& [g, time] : terms) share += g * std::expm1(-t / time);
    return shear_modulus * share;
  }

  template <class T>
  SymmetricTensor<T> deviatoric_stress(State<T>& state, const SymmetricTensor<T>& s, const SymmetricTensor<T>& d,
                                       const T&, double dt) const {
    const double G2 = 2 * shear_modulus;
    SymmetricTensor<T> next = s + T(G2) * d;
    for (std::size_t k = 0; k < n; ++k) {
      const auto [g, time] = terms[k];
      if (!(g > 0)) continue;
      const double x = dt / time, lost = -std::expm1(-x), mean = x > 0 ? lost / x : 1;
      SymmetricTensor<T>& h = state.overstress[k];
      const SymmetricTensor<T> relaxed = T(lost) * h + T((1 - mean) * G2 * g) * d;
      next = next - relaxed;
      h = h + T(G2 * g) * d - relaxed;
    }
    return next;
  }
};

}  // namespace strike
