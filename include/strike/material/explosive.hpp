#pragma once
#include <algorithm>
#include <concepts>
#include <limits>
#include <utility>
#include <vector>

#include <strike/material/eos/eos.hpp>
#include <strike/material/material.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Start of a detonation.
///
/// Requirements
/// 1. `time`: of the start [time].
/// 2. `distance(x)`: from where it starts to the place x, not negative [length]; or `arrival(x, D)`: when the front,
///    which runs at D, is there [time]. A template over the number.
/// Models: DetonationPoint, DetonationPlane, DetonationPoints.
template <class I>
concept Ignition =
    requires(const I ignition) {
      { ignition.time } -> std::convertible_to<double>;
    } &&
    (
        requires(const I ignition, const Vector3<double> x) {
          { ignition.distance(x) } -> std::convertible_to<double>;
        } ||
        requires(const I ignition, const Vector3<double> x) {
          { ignition.arrival(x, 1.0) } -> std::convertible_to<double>;
        });

/// A detonation that starts at a point.
struct DetonationPoint {
  Eigen::Vector3d place;
  double time = 0;  ///< of the start

  void ranges(const auto& number) const {
    number("place", place, range::point);
    number("time", time, range::finite);
  }

  template <class T>
  T distance(const Vector3<T>& x) const {
    const Vector3<T> r{x(0) - place(0), x(1) - place(1), x(2) - place(2)};
    return sqrt(max(dot(r, r), T(std::numeric_limits<RealOf<T>>::min())));
  }
};

/// A detonation that starts on a plane and runs away from it on both sides.
struct DetonationPlane {
  Eigen::Vector3d place, normal;
  double time = 0;  ///< of the start

  void ranges(const auto& number) const {
    number("place", place, range::point);
    number("normal", normal, range::direction);
    number("time", time, range::finite);
  }

  template <class T>
  T distance(const Vector3<T>& x) const {
    const Eigen::Vector3d n = detail::direction(normal);
    return abs((x(0) - place(0)) * n(0) + (x(1) - place(1)) * n(1) + (x(2) - place(2)) * n(2));
  }
};

/// Detonations that start at several points: the front that comes first counts. Without points all of the explosive is
/// lit at the time 0, as by LS-DYNA where a deck has no *INITIAL_DETONATION.
///   DetonationPoints{{{{0, 0, 0}}, {{0, 0, 0.1}, 2e-6}}}
class DetonationPoints {
 public:
  double time = 0;  ///< of the first start

  DetonationPoints() = default;
  explicit DetonationPoints(std::vector<DetonationPoint> points) : points_(std::move(points)) {
    if (!points_.empty()) time = points_.front().time;
    for (const DetonationPoint& point : points_) time = std::min(time, point.time);
  }

  void ranges(const auto& number) const {
    number("time", time, range::finite);
    for (const DetonationPoint& point : points_) number(point);
  }
  const std::vector<DetonationPoint>& points() const { return points_; }

  /// The least t + |x - place|/D of the points.
  template <class T>
  T arrival(const Vector3<T>& x, double D) const {
    if (points_.empty()) return T(0.0);
    const auto by = [&](const DetonationPoint& point) -> T { return point.time + (1 / D) * point.distance(x); };
    T first = by(points_.front());
    for (const DetonationPoint& point : points_) first = min(first, by(point));
    return first;
  }

 private:
  std::vector<DetonationPoint> points_;
};

/// Programmed burn.
struct Burn {
  double detonation_velocity;  ///< D [length/time]
  double front_width;          ///< w of the burning front, 3 to 6 elements [length]
  double pressure_CJ = 0;      ///< p_CJ of Chapman and Jouguet [stress]; 0: no burning by compression

  void ranges(const auto& number) const {
    number("detonation_velocity", detonation_velocity, range::positive);
    number("front_width", front_width, range::positive);
    number("pressure_CJ", pressure_CJ, range::not_negative);
  }
};

/// An explosive (Wilkins 1964; LS-DYNA *MAT_HIGH_EXPLOSIVE_BURN): the pressure is F times that of its products,
///   F = max(D (t - t0)/w, (1 - V)/(1 - V_CJ)),  V_CJ = 1 - p_CJ/(rho0 D^2),  from 0 to 1 and never back.
/// t0 is the arrival of the front from where it starts; the second term is burning by compression. Explosive that is
/// not lit yet resists nothing.
///   Explosive{tnt, DetonationPoint{{0, 0, 0}}, Burn{.detonation_velocity = 6930, .front_width = 0.01}}
template <class Eos, class Start>
struct Explosive {
  static constexpr bool has_products = ThermalEquationOfState<Eos>,
                        sound_products = has_products && detail::eos_flaw<Eos>() == detail::EosFlaw::none,
                        has_ignition = Ignition<Start>, sound = sound_products && has_ignition;
  static_assert(has_products,
                "strike: the first piece of an Explosive is the equation of state of its products, with A(mu) and "
                "B(mu), such as Jwl.");
  static_assert(!sound_products || has_ignition,
                "strike: the second piece of an Explosive is where its detonation starts: DetonationPoint, "
                "DetonationPlane, DetonationPoints, or one of your own with time and distance(x) or arrival(x, D).");
  static_assert(instantiates(static_cast<detail::EosReport<Eos>*>(nullptr)));

  Eos products;
  Start ignition;
  Burn burn;

  void ranges(const auto& number) const {
    number(products), number(ignition), number(burn);
    detail::ranges_at_rest(products, number);
    const double D = burn.detonation_velocity;
    number("burn.pressure_CJ", burn.pressure_CJ, range::below(products.density * D * D));
  }

  using Kinematics = SolidKinematics;
  static constexpr bool has_shear_modulus = false;

  template <class T>
  struct State : EosState<Eos, T> {
    T pressure{};        ///< F (A + B E) [stress]
    T burnt{};           ///< F
    T time_since_lit{};  ///< t - t0 [time]
  };

  double density() const { return products.density; }
  /// The state at rest where the detonation starts, ...
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    begin_eos(products, state);
    state.time_since_lit = T(-ignition.time);
  }
  /// ... and at a place.
  template <class T>
  void begin(State<T>& state, const Vector3<T>& place) const {
    begin(state);
    if constexpr (requires { ignition.arrival(place, burn.detonation_velocity); })
      state.time_since_lit = -ignition.arrival(place, burn.detonation_velocity);
    else
      state.time_since_lit -= (1 / burn.detonation_velocity) * ignition.distance(place);
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const T& J = rate.relative_volume;
    const T dv = volume_increment<T>(J, dt * trace(rate.rate_of_deformation)), mu = 1.0 / J - 1.0;
    state.time_since_lit += dt;
    T burnt = max(state.burnt, (burn.detonation_velocity / burn.front_width) * state.time_since_lit);
    if (burn.pressure_CJ > 0) burnt = max(burnt, burn_by_compression() * (1.0 - J));
    state.burnt = min(T(1.0), burnt);

    state.pressure = detail::advance_energy<Eos, T>(products, state.internal_energy, state.burnt * products.A(mu),
                                                    state.burnt * products.B(mu), dv, state.pressure, T(0.0));
    return stress(std::as_const(state));
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return SymmetricTensor<T>::isotropic(-state.pressure);
  }

  /// Bounds of the products, whether burnt or not, and of the burning by compression, J p/(1 - V_CJ).
  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    const T& J = rate.relative_volume;
    const T mu = 1.0 / J - 1.0, p = products.A(mu) + products.B(mu) * state.internal_energy;
    const T K = strike::bulk_modulus(products, state, J, p);
    const double burning = burn.pressure_CJ > 0 ? burn_by_compression() : 0;
    return {K + select(state.burnt < 1.0, burning * J * max(p, T(0.0)), T(0.0)), T(0.0)};
  }

 private:
  /// 1/(1 - V_CJ).
  double burn_by_compression() const {
    const double D = burn.detonation_velocity;
    return products.density * D * D / burn.pressure_CJ;
  }
};
template <class Eos, class Start>
Explosive(Eos, Start, Burn) -> Explosive<Eos, Start>;

}  // namespace strike
