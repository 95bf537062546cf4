#pragma once
#include <algorithm>
#include <concepts>
#include <limits>

#include <strike/element/element.hpp>
#include <strike/material/elastic.hpp>

namespace strike {

/// The plastic flow of a solid point in one step, by which an hourglass control yields with its material.
template <class T>
struct PointFlow {
  SymmetricTensor<T> deviator;  ///< of the new stress, from the centre of the yield surface [stress]
  T equivalent{};               ///< its von Mises equivalent q, above 0 [stress]
  T relaxed{};                  ///< by which the trial q was more, 3 G times the plastic increment [stress]

  /// The share of the trial stress that the return has left.
  T kept() const { return equivalent / (equivalent + relaxed); }
};

namespace detail {

/// The deviator is elastic, whatever the strain.
template <class M>
constexpr bool never_flows() {
  using State = typename M::template State<double>;
  constexpr bool flows = requires(const State state) { state.equivalent_plastic_strain; };
  return std::same_as<M, Elastic> || (!flows && requires(const M material) { material.strength; });
}

/// Measures the flow of a point: by the plastic strain that the material tells, or, of a material that does not, by
/// what its deviator lacks of an elastic trial.
template <class M, class T>
class FlowMeter {
 public:
  using State = typename M::template State<T>;

  /// The state before the step, its tensors turned; G is the shear modulus.
  FlowMeter(const M& material, const State& state, const SolidKinematics::Rate<T>& rate, const T& G, double dt) {
    if constexpr (told)
      strain_before_ = state.equivalent_plastic_strain;
    else if constexpr (!never_flows<M>()) {
      const SymmetricTensor<T> s = deviator(material.stress(state));
      trial_ = s + T(2.0 * dt * G) * deviator(rate.rate_of_deformation);
      doubt_ = T(std::max(1e-7, 64.0 * epsilon)) * (double_dot(s, s) + double_dot(trial_, trial_));
    }
  }
  /// The flow, of the state after the step and its stress.
  PointFlow<T> operator()(const State& state, const SymmetricTensor<T>& sigma, const T& G) const {
    PointFlow<T> flow{deviator(sigma)};
    if constexpr (requires { state.back_stress; }) flow.deviator = flow.deviator - state.back_stress;
    flow.equivalent = sqrt(max(T(least_square<T>), 1.5 * double_dot(flow.deviator, flow.deviator)));
    if constexpr (told) {
      flow.relaxed = 3.0 * G * (state.equivalent_plastic_strain - strain_before_);
    } else if constexpr (!never_flows<M>()) {
      const SymmetricTensor<T> lacks = trial_ - flow.deviator;
      flow.relaxed = select(double_dot(lacks, trial_) > doubt_, equivalent_stress(lacks), T(0.0));
    }
    return flow;
  }

 private:
  static constexpr bool told = requires(const State state) { state.equivalent_plastic_strain; };
  static constexpr double epsilon = std::numeric_limits<RealOf<T>>::epsilon();
  struct Nothing {};
  [[no_unique_address]] std::conditional_t<told, T, Nothing> strain_before_{};
  static constexpr bool compares = !told && !never_flows<M>();
  [[no_unique_address]] std::conditional_t<compares, SymmetricTensor<T>, Nothing> trial_{};
  [[no_unique_address]] std::conditional_t<compares, T, Nothing> doubt_{};
};

/// The flow stress of a point at its plastic strain, by which an hourglass control is held where the mean stress does
/// not flow; beyond all bounds of a material that tells none.
template <class M, class T>
class Yield {
 public:
  using State = typename M::template State<T>;

  Yield(const M& material, const State& state, const SolidKinematics::Rate<T>& rate, const T& G)
      : material_(material), state_(state), rate_(rate), G_(G) {}

  /// `flows` marks where the mean stress flows at q; `squared` is the square of the equivalent of all stresses, and
  /// `hourglass_rate_squared` gives that of the elastic rates of the hourglass stresses. A stress that depends on the
  /// rate is asked for only where the quasi-static one is exceeded, at the rate of all strain.
  template <class Flows, class F>
  T operator()(const Flows& flows, const T& q, const T& squared, F hourglass_rate_squared) const {
    if constexpr (requires { material_.flow_stress(state_, G_); }) {
      T Y = material_.flow_stress(state_, T(0.0));
      if constexpr (!is_rate_independent) {
        if (any(!flows && squared > Y * Y)) {
          const SymmetricTensor<T> D = deviator(rate_.rate_of_deformation);
          const T hourglass = hourglass_rate_squared() / (9.0 * G_ * G_);
          Y = material_.flow_stress(state_, T(sqrt(T(2.0 / 3.0) * double_dot(D, D) + hourglass)));
        }
      }
      return select(flows, q, Y);
    } else {
      return select(flows, q, T(std::numeric_limits<RealOf<T>>::max()));
    }
  }

 private:
  static constexpr bool is_rate_independent = requires { requires M::flow_is_rate_independent; };
  const M& material_;
  const State& state_;
  const SolidKinematics::Rate<T>& rate_;
  const T& G_;
};

}  // namespace detail

}  // namespace strike
