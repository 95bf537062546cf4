#pragma once
#include <concepts>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

#include <strike/material/elastic.hpp>
#include <strike/material/kinematics.hpp>

// Stresses of the points of a section that are linear over the plane of a plate, for its PhysicalHourglass.
namespace strike {

/// Values along the two mean edges of a plate, its tangents in the middle.
template <class T>
struct AlongEdges {
  T xi{}, eta{};

  friend AlongEdges operator+(const AlongEdges& a, const AlongEdges& b) { return {a.xi + b.xi, a.eta + b.eta}; }
  friend AlongEdges operator*(const T& c, const AlongEdges& a) { return {c * a.xi, c * a.eta}; }
};
template <class T>
T dot(const AlongEdges<T>& a, const AlongEdges<T>& b) {
  return a.xi * b.xi + a.eta * b.eta;
}

/// Rates of strains that are linear over the plane of a plate: along each mean edge, at the end of the other. A point
/// at the height z is strained by membrane + z curvature.
template <class T>
struct LinearRate {
  AlongEdges<T> membrane, curvature;  ///< [1/time] and [1/(time length)]
  PlaneTensor<T> xi, eta;             ///< squares t (x) t of the unit vectors along the edges, in the frame
};

/// Resultants of the linear stresses, int s (1, z) dz, and their power per area before the step, int s.(membrane + z
/// curvature) dz.
template <class T>
struct LinearResultants {
  AlongEdges<T> force, moment;  ///< [force/length] and [force]
  T power_before{};

  void add(double z, double weight, const AlongEdges<T>& s) {
    const AlongEdges<T> share = T(weight) * s;
    force = force + share, moment = moment + T(z) * share;
  }
};

namespace detail {

/// The deviator of a plane stress from the centre of the yield surface, in the plane.
template <class State, class T>
PlaneTensor<T> from_centre(const State& state, const PlaneTensor<T>& stress) {
  PlaneTensor<T> s = stress - PlaneTensor<T>::isotropic(T(1.0 / 3.0) * trace(stress));
  if constexpr (requires { state.back_stress; }) {
    const auto& a = state.back_stress;
    s = s - PlaneTensor<T>{a.xx, a.yy, a.xy};
  } else {
    (void)state;
  }
  return s;
}
/// 3/2 s:s of a deviator whose components are zero across the plane but for s_zz.
template <class T>
T equivalent_squared(const PlaneTensor<T>& s) {
  return 3.0 * (s.xx * s.xx + s.yy * s.yy + s.xx * s.yy + s.xy * s.xy);
}

/// A plane material without a plastic strain that is made of a solid: elastic, whatever the strain.
template <class M>
concept PlaneElastic = requires(const M material) { material.solid.strength; } || requires(const M material) {
  { material.solid } -> std::convertible_to<Elastic>;
};

/// Measures the flow of a point in plane stress: by the plastic strain that the material tells, or, of a material that
/// does not, by what its stress lacks of an elastic trial.
template <class M, class T>
class PlaneFlowMeter {
 public:
  using State = typename M::template State<T>;
  static constexpr bool told = requires(const State state) { state.equivalent_plastic_strain; },
                        never = !told && PlaneElastic<M>, compares = !told && !never;

  /// The state before the step.
  void start(const State& state, [[maybe_unused]] const PlaneTensor<T>& stress,
             [[maybe_unused]] const PlaneTensor<T>& D, [[maybe_unused]] const PlaneModuli<double>& moduli,
             [[maybe_unused]] double dt) {
    if constexpr (told)
      strain_before_ = state.equivalent_plastic_strain;
    else if constexpr (compares)
      trial_ = stress + T(2 * dt * moduli.shear) * D +
               PlaneTensor<T>::isotropic(T(dt * (moduli.normal - 2 * moduli.shear)) * trace(D));
    (void)state;
  }
  /// E times the plastic increment over the equivalent stress q, of the state after the step.
  T relaxed(const State& state, const PlaneTensor<T>& stress, double E, const T& per_q) const {
    if constexpr (told) {
      return (E * (state.equivalent_plastic_strain - strain_before_)) * per_q;
    } else if constexpr (compares) {
      const PlaneTensor<T> lacks = trial_ - stress;
      const T all = double_dot(stress, stress) + double_dot(trial_, trial_);
      return select(double_dot(lacks, trial_) > doubt * all, equivalent_stress(lacks) * per_q, T(0.0));
    } else {
      return (void)state, (void)stress, (void)E, (void)per_q, T(0.0);
    }
  }

 private:
  static constexpr double epsilon = std::numeric_limits<RealOf<T>>::epsilon();
  static constexpr double doubt = epsilon < 1e-9 ? 1e-7 : 64.0 * epsilon;
  struct Nothing {};
  [[no_unique_address]] std::conditional_t<told, T, Nothing> strain_before_{};
  [[no_unique_address]] std::conditional_t<compares, PlaneTensor<T>, Nothing> trial_{};
};

/// Advances the linear stresses s of a point by the strains e of a step, elastic with Young's modulus E, and lets them
/// flow with the stress of the point, sigma, which is at its end:
/// 1. by the multiplier of the flow of sigma, s/(1 + rho), rho = E dl/q;
/// 2. by a multiplier that is linear along the edge and not negative at the points -+1/sqrt(3), which takes what of s
///    makes the yield function linear, at most 3/2 sqrt(3) rho |t.s t|;
/// 3. radially, together with sigma, to q^2 + 4/9 (s_xi^2 + s_eta^2) = Y^2, by which a layer has its plastic moment.
template <class M, class T>
void advance_linear(const M& material, typename M::template State<T>& state, const PlaneFlowMeter<M, T>& meter,
                    AlongEdges<T>& s, PlaneTensor<T>& sigma, const AlongEdges<T>& e, const LinearRate<T>& rate,
                    const PlaneTensor<T>& D, const PlaneModuli<double>& moduli, double dt) {
  using Meter = PlaneFlowMeter<M, T>;
  const double G = moduli.shear, E = 4 * G * (1 - G / moduli.normal);
  s = s + T(E) * e;
  if constexpr (requires { material.intact(state); }) s = T(select(material.intact(state) > 0.0, T(1.0), T(0.0))) * s;
  if constexpr (!Meter::never) {
    const PlaneTensor<T> centred = from_centre(state, sigma);
    const T q2 = max(T(least_square<T>), equivalent_squared(centred)), per_q = rsqrt(q2), q = q2 * per_q;
    const T rho = meter.relaxed(state, sigma, E, per_q);
    const auto flows = rho > 0.0;
    if (any(flows)) {
      const double most = 1.5 * std::numbers::sqrt3;
      const auto relaxed = [&](const T& s_k, const PlaneTensor<T>& tt) -> T {
        const T left = s_k / (1.0 + rho), bound = most * rho * abs(double_dot(centred, tt));
        return left - max(T(-bound), min(bound, left));
      };
      s = {relaxed(s.xi, rate.xi), relaxed(s.eta, rate.eta)};
    }
    if constexpr (requires { material.flow_stress(state, q); }) {
      const T linear2 = T(4.0 / 9.0) * dot(s, s), all2 = q2 + linear2;
      T Y = q;
      if (any(!flows)) {
        Y = material.flow_stress(state, T(0.0));
        if constexpr (!M::flow_is_rate_independent) {
          if (any(!flows && all2 > Y * Y)) {
            const T mean = T(4.0 / 3.0) * (D.xx * D.xx + D.yy * D.yy + D.xx * D.yy + D.xy * D.xy),
                    linear = T(4.0 / 9.0 / (dt * dt)) * dot(e, e);
            Y = material.flow_stress(state, T(sqrt(mean + linear)));
          }
        }
        Y = select(flows, q, Y);
      }
      if (any(all2 > Y * Y)) {
        const T per_all = rsqrt(all2), kept = min(T(1.0), Y * per_all);
        const T released = (1.0 - kept) * ((0.75 / E) * linear2 + (1 / (3 * G)) * q2);  // energy per volume
        s = kept * s;
        material.flow(state, kept, T(released * per_all), Y);
        sigma = material.stress(std::as_const(state));
      }
    }
  }
}

}  // namespace detail

}  // namespace strike
