#pragma once
#include <string>
#include <utility>

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

  /// The flow stress of a step, flow_curve.hpp: that of the law times the factor.
  template <class T>
  class Curve {
    using LawCurve = decltype(std::declval<Law>().flow_curve(std::declval<T>(), 1.0));

   public:
    Curve(const CowperSymonds& law, const T& e, double dt)
        : law_(law.law.flow_curve(e, dt)), per_dt_(1 / dt / law.D), rate_(1 / law.p) {}

    T at_rest() const { return law_.at_rest(); }
    void start_at(const T& dl) {
      law_.start_at(dl);
      rate_.start_at(T(dl * per_dt_));
    }
    void move_to(const T& dl, const T& u) {
      law_.move_to(dl, u);
      rate_.move(u);
    }
    LogSeries<T> series(const T& dl) const { return law_.series(dl) * (1.0 + rate_.series()); }
    auto is_smooth(const T& dl, const T& u) const
      requires detail::HasKinks<LawCurve, T>
    {
      return law_.is_smooth(dl, u);
    }

   private:
    LawCurve law_;
    double per_dt_;
    detail::RatePower<T> rate_;
  };
  template <class T>
    requires detail::HasFlowCurve<Law, T>
  Curve<T> flow_curve(const T& e, double dt) const {
    return {*this, e, dt};
  }
};
template <class Law>
CowperSymonds(Law, double, double) -> CowperSymonds<Law>;

}  // namespace strike
