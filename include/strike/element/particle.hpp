#pragma once
#include <cmath>
#include <concepts>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// Smoothing of particles, and the damping of what their smoothed gradients do not see.
struct Smoothing {
  double length = 1.3;     ///< h in spacings; a particle sees neighbours within 2h, 80 of them on a cubic lattice
  double hourglass = 0.3;  ///< chi, of the viscosity between neighbours against what is not linear in their motion
  double diffusion = 0.1;  ///< delta, of the diffusion of density in fluids (Molteni and Colagrossi 2009)

  void ranges(const auto& number) const {
    number("length", length, range::between(1, 3));
    number("hourglass", hourglass, range::between(0, 10));
    number("diffusion", diffusion, range::between(0, 1));
  }
};

/// A plane of symmetry of particles, which see their mirror images behind it.
struct Mirror {
  Eigen::Vector3d normal;                           ///< of any length but zero
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< in the plane [length]

  void ranges(const auto& number) const {
    number("normal", normal, range::direction);
    number("point", point, range::point);
  }
};

/// Planes of symmetry at right angles or parallel to each other: Mirrors{Mirror{unit(Axis::x)}, Mirror{unit(Axis::y)}}.
/// Particles lie half a spacing off them, and between two that are parallel. Error: two that are neither; and when the
/// run begins two that are parallel and so near to each other that a particle sees beyond both.
class Mirrors {
 public:
  Mirrors() = default;
  template <std::same_as<Mirror>... More>
  explicit Mirrors(const Mirror& first, const More&... more) : planes_{first, more...} {
    for (std::size_t k = 0; k < planes_.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (const double cosine = planes_[k].normal.normalized().dot(planes_[l].normal.normalized());
            !(std::abs(cosine) < 1e-12 || std::abs(cosine) > 1 - 1e-12))
          throw Error(
              detail::joined({"strike: the cosine between mirrors ", std::to_string(l), " and ", std::to_string(k),
                              " of a Particle is ", detail::text(cosine), "; put them at right angles or parallel."}));
  }
  const std::vector<Mirror>& planes() const { return planes_; }
  void ranges(const auto& number) const {
    for (const Mirror& plane : planes_) number(plane);
  }

 private:
  std::vector<Mirror> planes_;
};

namespace detail {

/// The function of Wendland (1995), C2, about a particle, W = 21/(16 pi h^3) (1 - r/2h)^4 (1 + 2 r/h), within r < 2h.
struct Wendland {
  double h;  ///< smoothing length

  double reach() const { return 2 * h; }
  double factor() const { return 105 / (16 * std::numbers::pi * h * h * h * h * h); }
  /// g in the gradient G = g d with respect to the place from which d leads to a neighbour, less factor(); r = |d|.
  template <class T>
  T slope(const T& r) const {
    const T w = max(T(0.0), 1.0 - (0.5 / h) * r);
    return w * w * w;
  }
};

}  // namespace detail

/// Sums of a particle over its neighbours j, of reference volume V_j, at d = x_j - x; G = g d.
template <class T>
struct ParticleSums {
  SymmetricTensor<T> moment{};               ///< A = sum V_j d (x) G [1]
  Matrix3<T> velocity = Matrix3<T>::Zero();  ///< sum V_j (v_j - v) (x) G [1/time]

  /// Adds neighbour j; `g` is V_j g.
  void add(const Vector3<T>& d, const T& g, const Vector3<T>& relative_velocity) {
    const Vector3<T> G = g * d;
    moment.xx += d(0) * G(0), moment.yy += d(1) * G(1), moment.zz += d(2) * G(2);
    moment.xy += d(0) * G(1), moment.yz += d(1) * G(2), moment.zx += d(2) * G(0);
    add_outer(velocity, relative_velocity, G);
  }
  ParticleSums& operator*=(const T& c) {
    moment = c * moment, velocity = c * velocity;
    return *this;
  }
};

/// The answer of a particle to a step that its neighbours see.
template <class T>
struct ParticleAnswer {
  Matrix3<T> stress = Matrix3<T>::Zero();  ///< tau M: the Kirchhoff stress times the inverse of the moment
  SymmetricTensor<T> half_rate{};          ///< D/2 [1/time]
  T impedance{};                           ///< rho0 c V/V0, 0 where the material has failed [stress time/length]
};

/// A particle after its material has advanced: what is known before its neighbours have answered.
template <class T>
struct ParticleStep {
  Response<T, 1> response;
  ParticleAnswer<T> answer;
  T end_work;  ///< the half of the work that the stress at the end of the step does
};

/// Sums of a particle over the answers of its neighbours.
template <class T>
struct ParticleForces {
  Vector3<T> gradient = Vector3<T>::Zero();   ///< sum V_j G [1/length]
  Vector3<T> stress = Vector3<T>::Zero();     ///< sum V_j tau_j M_j G [stress/length]
  Vector3<T> hourglass = Vector3<T>::Zero();  ///< sum V_j (z + z_j) e d.G/r^2 of the impedances z
  T diffusion{};                              ///< sum V_j g (m_j - m) of the relative densities m = rho/rho0

  /// Adds neighbour j; `g` is V_j g, the other arguments differences from here to there.
  void add(const Vector3<T>& d, const T& square, const T& g, const Vector3<T>& relative_velocity, const T& denser,
           const ParticleAnswer<T>& here, const ParticleAnswer<T>& there) {
    const Vector3<T> G = g * d;
    gradient = gradient + G;
    stress = stress + times(there.stress, G);
    const T rate = dot(relative_velocity, d), linear = quadratic_form(here.half_rate + there.half_rate, d);
    const T c = (here.impedance + there.impedance) / max(square, T(1e-30));
    hourglass = hourglass + (c * beyond(linear, rate)) * G;
    diffusion += g * denser;
  }
  ParticleForces& operator*=(const T& c) {
    gradient = c * gradient, stress = c * stress, hourglass = c * hourglass, diffusion *= c;
    return *this;
  }

 private:
  /// The part of a difference that is not linear, of its sign and no larger than it: what damps it dissipates.
  static T beyond(const T& linear, const T& difference) {
    return max(min(T(0.0), difference), min(max(T(0.0), difference), difference - linear));
  }
};

/// A particle of matter that flows as far as it likes, an element of one node: total-mass smoothed particle
/// hydrodynamics whose gradients are exact for linear fields on any arrangement (Bonet and Lok 1999), and whose forces
/// are dual to them, so that momentum is exact and, where no gradient is lifted, angular momentum too:
///   L = [sum V_j (v_j - v) (x) G_j] M,   M = A^-1,   f = V sum V_j (tau M + tau_j M_j) G_j,
/// with reference volumes V and Kirchhoff stresses tau. Particles of one part see each other and no others.
/// Policies: its smoothing, planes of symmetry, rotation of the tensors, bulk viscosity, and the instant of the step at
/// which the motion is measured.
///   Part{Particle{}, water, bird.particles}     Particle{Smoothing{1.3}, Mirrors{Mirror{unit(Axis::x)}}}
template <class Spin = HughesWinget, class Viscosity = BulkViscosity, class Instant = MidStep>
struct Particle {
  static constexpr bool has_rotation = Rotation<Spin>, has_viscosity = has_rotation && ShockViscosity<Viscosity>,
                        sound = has_viscosity && MeasuringInstant<Instant>;
  static_assert(has_rotation,
                "strike: the third policy of Particle is the rotation of its tensors: HughesWinget or Jaumann.");
  static_assert(!has_rotation || has_viscosity,
                "strike: the fourth policy of Particle is its bulk viscosity: BulkViscosity, BulkViscosityBothWays or "
                "NoBulkViscosity.");
  static_assert(!has_viscosity || sound,
                "strike: the fifth policy of Particle is the instant at which it measures: MidStep or EndStep.");

  Smoothing smoothing{};
  Mirrors mirrors{};
  [[no_unique_address]] Spin rotation{};
  [[no_unique_address]] Viscosity bulk_viscosity = calming();
  [[no_unique_address]] Instant instant{};

  void ranges(const auto& number) const {
    number(smoothing), number(mirrors), number(rotation), number(bulk_viscosity), number(instant);
  }

  using Kinematics = SolidKinematics;
  static constexpr int nodes = 1;
  static constexpr bool sees_neighbours = true;

  template <class M, class T>
  struct State {
    T reference_volume{};    ///< V0 [length^3]
    T relative_volume{1.0};  ///< J = V/V0
    T diffusion{};           ///< rate of the relative density by diffusion, of the next step [1/time]
    Vector3<T> hourglass = Vector3<T>::Zero();  ///< force of the hourglass viscosity
    [[no_unique_address]] typename Viscosity::template State<T> viscosity{};
    [[no_unique_address]] typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  /// Sets a particle of this volume at rest and returns its mass.
  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 1>& x, const T& volume) const {
    begin_point(material, state.material, x);
    state.reference_volume = volume;
    return density_of(material) * volume;
  }

  /// Advances the material over the step dt that ended at the places and velocities of these sums; the forces follow
  /// when the neighbours have answered. A wave crosses the particle where it crosses a spacing, of whose cube it fills
  /// the share `fill`.
  template <class M, class T>
  ParticleStep<T> advance(State<M, T>& state, const M& material, const ParticleSums<T>& sums,
                          const detail::Wendland& kernel, double dt, const T& fill = T(1.0)) const {
    const T J_before = state.relative_volume, rho0 = T(density_of(material));
    const SymmetricTensor<T> A = J_before * sums.moment;
    // A corner has the moment 1/8, an edge 1/4, a face 1/2, and as many times less as particles are smaller than their
    // spacing. The forces of a fluid turn nothing where moments are lifted, which spares steps of its spray.
    const double spacing = kernel.h / smoothing.length;
    const T least = fill * (0.25 - 0.15 * solidity(material, state.material, J_before));
    const SymmetricTensor<T> M_ = J_before * inverse(lifted(A, least));
    const Matrix3<T> L = product(sums.velocity, M_);

    const Matrix3<T> L_mid = instant(L, dt);
    const Vector3<T> spin = T(dt) * axial_vector(L_mid);
    SolidKinematics::Rate<T> rate{instant.to_end(spin)(symmetric_part(L_mid))};
    const T theta = trace(rate.rate_of_deformation);
    const T J = relative_volume(state, L, dt);
    const T diffused = dt > 0 ? T((2.0 / dt) * ((J - J_before) / (J + J_before)) - theta) : T(0.0);
    rate.rate_of_deformation += SymmetricTensor<T>::isotropic((1.0 / 3.0) * diffused);
    rate.relative_volume = state.relative_volume = J;

    const T V = J * state.reference_volume, dV = V - J_before * state.reference_volume;
    const Moduli<T> before = material.moduli(state.material, rate);
    turn_tensors(rotation.turn(spin), state.material);
    const T mean_before = (1.0 / 3.0) * trace(material.stress(state.material));
    const auto is_spray = J > 1.02 && abs(mean_before) <= 1e-3 * before.bulk;

    ParticleStep<T> step;
    auto& [response, answer, end_work] = step;
    response.force = Nodal<T, 1>::Zero();
    response.volume = V;
    const auto crossing_time = [&](const T& wave) { return T(spacing * sqrt(rho0 / (J * wave))); };
    const T compression = select(is_spray, T(0.0), theta);
    const T q = bulk_viscosity.pressure(before.wave(), crossing_time(before.wave()), compression);
    response.bulk_viscosity_work = bulk_viscosity.work(state.viscosity, q, volume_increment<T>(V, dt * theta));
    heat(state.material, response.bulk_viscosity_work / state.reference_volume);

    const auto [sigma, work] = advance_point(material, state.material, rate, dt, V, dV);
    response.internal_work = work;
    const SymmetricTensor<T> end = sigma - SymmetricTensor<T>::isotropic(q);
    response.hourglass_work = T(-0.5 * dt) * (V * (1.0 / 3.0) * trace(sigma) + (V - dV) * mean_before) * diffused;
    end_work = T(0.5 * dt) * V * (double_dot(end, rate.rate_of_deformation) - (1.0 / 3.0) * diffused * trace(end));

    const Moduli<T> after = material.moduli(state.material, rate);
    const T tau = crossing_time(after.wave());
    const T zeta = bulk_viscosity.coefficient(after.wave(), tau, compression);
    const T c = spacing / tau, moment = fill * T(1.0 / 3.0) * trace(M_) / J_before;
    const double factor = frequency_factor() / kernel.h;
    const T frequency_squared = (factor * factor) * c * c * moment;
    T viscosity = zeta;
    if constexpr (requires { material.viscosity(); }) viscosity += 2.0 * material.viscosity();
    const T rubbing = (decay_factor * smoothing.hourglass / kernel.h) * c * J_before * trace(sums.moment);
    const Vibration<T> vibration{frequency_squared, frequency_squared * viscosity / after.wave() + rubbing};
    response.critical_rate = select(is_spray, T(0.5), T(1.0)) * vibration.critical_rate();

    answer.stress = product((J * end).matrix(), M_);
    answer.half_rate = T(0.5) * symmetric_part(L);
    answer.impedance = rho0 * J * c;
    if constexpr (requires { material.intact(state.material); }) {
      const auto intact = material.intact(state.material) > 0.0;
      zero_if_failed(intact, response);
      for (int i = 0; i < 9; ++i) answer.stress(i) = select(intact, answer.stress(i), T(0.0));
      answer.impedance = select(intact, answer.impedance, T(0.0));
    }
    return step;
  }

  /// The force by which a particle of the volume V0 resists, as Response::force; adds to the hourglass work of the step
  /// dt through which it moved at v. One that has been deleted has no volume.
  template <class M, class T>
  Nodal<T, 1> force(State<M, T>& state, const M& material, const ParticleForces<T>& forces,
                    const ParticleAnswer<T>& answer, const detail::Wendland& kernel, const T& V0, const Vector3<T>& v,
                    double dt, T& hourglass_work) const {
    const Vector3<T> hourglass = (-0.5 * smoothing.hourglass * kernel.h * V0) * forces.hourglass;
    hourglass_work += T(0.5 * dt) * dot<T>(state.hourglass + hourglass, v);
    state.hourglass = hourglass;
    const T fluid = 1.0 - solidity(material, state.material, state.relative_volume);
    state.diffusion =
        fluid * (2.0 * smoothing.diffusion * kernel.h / density_of(material)) * answer.impedance * forces.diffusion;
    return hourglass - V0 * (times(answer.stress, forces.gradient) + forces.stress);
  }

  /// Of the stable step, found by exact eigenvalues of lattices, sheets, lines, clouds and cubes
  /// (tests/element/particle): w <= a (c/h) sqrt(tr M/3), d <= 0.6 chi (c/h) tr A. Where the linear bulk viscosity is
  /// 0.3, a = 1.8 is enough for groups of few, whose frequencies are the highest; without, these need 2.4.
  double frequency_factor() const {
    if constexpr (requires { bulk_viscosity.linear; })
      return 2.4 - 2 * std::min(bulk_viscosity.linear, 0.3);
    else
      return 2.4;
  }
  static constexpr double decay_factor = 0.6;

 private:
  /// Five times the linear term that elements need takes the ringing of a bird from the pressure under it.
  static Viscosity calming() {
    if constexpr (requires(Viscosity v) { v.linear; })
      return {.linear = 0.3};
    else
      return {};
  }
  /// 1 where the material resists shear, 0 where it is a fluid.
  template <class M, class S, class T>
  static T solidity([[maybe_unused]] const M& material, [[maybe_unused]] const S& state, [[maybe_unused]] const T& J) {
    if constexpr (requires { requires !M::has_shear_modulus; })
      return T(0.0);
    else
      return select(material.moduli(state, SolidKinematics::Rate<T>{{}, J}).shear > 0.0, T(1.0), T(0.0));
  }
  /// The moment of a particle with few neighbours, or with all in a plane, is lifted until the harmonic mean of its
  /// eigenvalues is at least `least`.
  template <class T>
  static SymmetricTensor<T> lifted(const SymmetricTensor<T>& A, const T& least) {
    const T I1 = trace(A), I2 = A.xx * A.yy + A.yy * A.zz + A.zz * A.xx - A.xy * A.xy - A.yz * A.yz - A.zx * A.zx;
    const T mean = 3.0 * determinant(A) / (I2 + 1e-4 * I1 * I1 + 1e-30);  // beyond rounding where I2 vanishes
    return A + SymmetricTensor<T>::isotropic(max(T(0.0), least - mean));
  }
  template <class T>
  static Matrix3<T> product(const Matrix3<T>& A, const SymmetricTensor<T>& B) {
    return columns<T>(times<T>(A, {B.xx, B.xy, B.zx}), times<T>(A, {B.xy, B.yy, B.yz}),
                      times<T>(A, {B.zx, B.yz, B.zz}));
  }
  /// By the motion of the step, exact in a homogeneous one, J/J_before = 1/det(I - dt L), and by diffusion.
  template <class S, class T>
  static T relative_volume(const S& state, const Matrix3<T>& L, double dt) {
    const T h = T(-dt);
    const T closing =
        dot<T>(Vector3<T>(1.0 + h * L(0, 0), h * L(1, 0), h * L(2, 0)),
               cross<T>({h * L(0, 1), 1.0 + h * L(1, 1), h * L(2, 1)}, {h * L(0, 2), h * L(1, 2), 1.0 + h * L(2, 2)}));
    return state.relative_volume / (closing + dt * state.diffusion * state.relative_volume);
  }
};

Particle() -> Particle<>;
Particle(Smoothing) -> Particle<>;
Particle(Smoothing, Mirrors) -> Particle<>;
template <class R>
Particle(Smoothing, Mirrors, R) -> Particle<R>;
template <class R, class V>
Particle(Smoothing, Mirrors, R, V) -> Particle<R, V>;
template <class R, class V, class I>
Particle(Smoothing, Mirrors, R, V, I) -> Particle<R, V, I>;

}  // namespace strike
