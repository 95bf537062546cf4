#pragma once
#include <concepts>

#include <strike/material/report.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/protocol.hpp>

namespace strike::detail {

struct FlowStress {
  struct Decoy {
    int flow_stress;
  };
  template <class Model>
  using Member = decltype(&Model::flow_stress);
};
struct DeviatoricStress {
  struct Decoy {
    int deviatoric_stress;
  };
  template <class Model>
  using Member = decltype(&Model::deviatoric_stress);
};
struct PlasticIncrement {
  struct Decoy {
    int plastic_increment;
  };
  template <class Model>
  using Member = decltype(&Model::plastic_increment);
  template <class T>
  static auto call(const auto& law, const T& q) -> decltype(T(law.plastic_increment(q, q, 1.0))) {
    return law.plastic_increment(q, q, 1.0);
  }
};
struct FlowCurveName {
  struct Decoy {
    int flow_curve;
  };
  template <class Model>
  using Member = decltype(&Model::flow_curve);
  template <class Model>
  using Specialised = decltype(&Model::template flow_curve<double>);
};

/// The class of a pointer to a member.
template <class Class, class Function>
Class declaring_class(Function Class::*);
/// The flow stress is of another class than the function that finds its increment: that of a base does not know it.
template <class S>
concept InheritsIncrement = requires {
  requires !std::same_as<decltype(declaring_class(&S::template flow_stress<double>)),
                         decltype(declaring_class(&S::template plastic_increment<double>))>;
} || requires {
  requires !std::same_as<decltype(declaring_class(&S::template flow_stress<double>)),
                         decltype(declaring_class(&S::template flow_curve<double>))>;
};

struct Stiffness {
  struct Decoy {
    int stiffness;
  };
  template <class Model>
  using Member = decltype(&Model::stiffness);
  template <class T>
  static auto call(const auto& law, const auto& state, const T& J) -> decltype(T(law.stiffness(state, J))) {
    return law.stiffness(state, J);
  }
};

/// Flaws of a strength, in the order in which they are reported.
enum class StrengthFlaw { none, absent, flow, deviator, in_double, increment, curve, inherited, stiffness, warning };
template <class S>
constexpr StrengthFlaw strength_flaw() {
  constexpr bool has_modulus = requires(const S strength) { double(strength.shear_modulus); };
  if constexpr (!Strength<S>) {
    if constexpr (has_modulus && HasName<FlowStress, S>)
      return StrengthFlaw::flow;
    else if constexpr (has_modulus && HasName<DeviatoricStress, S>)
      return StrengthFlaw::deviator;
    else
      return StrengthFlaw::absent;
  } else if constexpr (!Strength<S, TrialLanes>)
    return StrengthFlaw::in_double;
  else if constexpr (nearly<PlasticIncrement, const S, const TrialLanes>)
    return StrengthFlaw::increment;
  else if constexpr (FlowLaw<S> && HasName<FlowCurveName, S> && !HasFlowCurve<S, TrialLanes>)
    return StrengthFlaw::curve;
  else if constexpr (FlowLaw<S> && InheritsIncrement<S>)
    return StrengthFlaw::inherited;
  else if constexpr (nearly<Stiffness, const S, const StrengthState<S, TrialLanes>, const TrialLanes>)
    return StrengthFlaw::stiffness;
  else if constexpr (misfits<Warning, const S>)
    return StrengthFlaw::warning;
  else
    return StrengthFlaw::none;
}

/// Reports what is nearly a strength.
template <class S>
struct StrengthReport {
  static constexpr StrengthFlaw flaw = strength_flaw<S>();
  static_assert(flaw != StrengthFlaw::flow,
                "strike: flow_stress of a strength takes (strain), (strain, rate), or (strain, rate, temperature) with "
                "the members initial_temperature and heating, and returns the stress.");
  static_assert(flaw != StrengthFlaw::deviator,
                "strike: deviatoric_stress of a strength takes (s, d), or with a State<T> of its own (state, s, d, J, "
                "dt), and returns a SymmetricTensor<T>.");
  static_assert(flaw != StrengthFlaw::in_double,
                "strike: a formula of this strength takes double alone: make it a template over the number, such as "
                "template <class T> T flow_stress(const T& strain) const.");
  static_assert(flaw != StrengthFlaw::increment,
                "strike: plastic_increment of a strength is template <class T> T plastic_increment(const T& q, const "
                "T& strain, double dt) const; this one has other arguments or another result.");
  static_assert(flaw != StrengthFlaw::curve,
                "strike: flow_curve of a strength takes (const T& strain, double dt), or (const T& strain, const T& "
                "temperature, double dt), and returns a curve; this one has other arguments.");
  static_assert(flaw != StrengthFlaw::inherited,
                "strike: this strength has a flow_stress of its own, but the plastic_increment or flow_curve of its "
                "base, which does not know it: give it its own, or keep the base as a member.");
  static_assert(flaw != StrengthFlaw::stiffness,
                "strike: stiffness of a strength is template <class T> T stiffness(const State<T>& state, const T& J) "
                "const; this one has other arguments or another result.");
  static_assert(flaw != StrengthFlaw::warning,
                "strike: warning of a strength is std::string warning() const; this one has other arguments or another "
                "result.");

  static void try_on_lanes([[maybe_unused]] const S& law) {
    [[maybe_unused]] const TrialLanes x = 1.0;
    [[maybe_unused]] const SymmetricTensor<TrialLanes> s{};
    if constexpr (flaw != StrengthFlaw::none) {
    } else if constexpr (RateIndependentFlow<S>) {
      (void)law.flow_stress(x);
    } else if constexpr (RateDependentFlow<S>) {
      (void)law.flow_stress(x, x);
    } else if constexpr (ThermalFlow<S>) {
      (void)law.flow_stress(x, x, x);
    } else if constexpr (StrengthWithMemory<S>) {
      typename S::template State<TrialLanes> state{};
      (void)law.deviatoric_stress(state, s, s, x, 1.0);
    } else {
      (void)law.deviatoric_stress(s, s);
    }
    if constexpr (requires { law.plastic_increment(x, x, 1.0); }) (void)law.plastic_increment(x, x, 1.0);
  }
  using OnLanes = Tried<&StrengthReport::try_on_lanes>;
};

}  // namespace strike::detail
