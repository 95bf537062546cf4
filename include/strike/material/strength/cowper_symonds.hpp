#pragma once
#include <string>

#include <strike/material/strength/strength.hpp>
#include <strike/range.hpp>

namespace strike {

/// A rate-independent flow law times the rate factor of Cowper and Symonds (1957), sigma(e) [1 + (r/D)^(1/p)]:
///   CowperSymonds{TabulatedHardening{...}, 40.4, 5}
/// RateVonMises is the cheaper form for linear hardening.
template <RateIndependentFlow Law>
struct CowperSymonds {
  Law law;
  double D;  ///< rate that doubles the flow stress [1/time]
  double p;
  double shear_modulus = law.shear_modulus;

  void ranges(const auto& number) const {
    number(law);
    number("D", D, range::positive);
    number("p", p, Range{.low = 0, .high = 100});
    number("shear_modulus", shear_modulus, range::positive);
  }

  std::string warning() const
    requires requires(Law l) { l.warning(); }
  {
    return law.warning();
  }

  template <class T>
  T flow_stress(const T& e, const T& rate) const {
    return law.flow_stress(e) * (1.0 + pow(T(rate * (1.0 / D)), 1.0 / p));
  }
};
template <class Law>
CowperSymonds(Law, double, double) -> CowperSymonds<Law>;

}  // namespace strike
