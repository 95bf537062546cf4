#pragma once
#include <concepts>

#include <strike/material/material.hpp>
#include <strike/material/orthotropic_ply.hpp>
#include <strike/material/plane_stiffness.hpp>
#include <strike/range.hpp>
#include <strike/scalar/math.hpp>

namespace strike {

/// The left sides of a criterion of failure: 1 and more fails.
template <class T>
struct PlyIndex {
  T fibre, matrix;
};

/// Criterion of failure of a ply in plane stress.
///
/// Requirements
/// 1. `index(stress)`: a PlyIndex of (sigma_1, sigma_2, tau_12), a template over the number.
/// Laws: both are zero without stress, and do not depend on the sign of tau_12.
/// Models: MaximumStress, Hashin, ChangChang.
template <class C, class T = double>
concept PlyCriterion = requires(const C criterion, const PlaneTensor<T> stress) {
  { criterion.index(stress) } -> std::same_as<PlyIndex<T>>;
};

namespace detail {
/// (s/strength)^2 in tension or in compression.
template <class T>
T squared_ratio(const T& s, double tension, double compression) {
  const T ratio = s * select(s > 0.0, T(1 / tension), T(1 / compression));
  return ratio * ratio;
}
/// Of sigma_2 on the matrix: (s/Yt)^2 in tension, in compression (s/(2 St))^2 + [(Yc/(2 St))^2 - 1] s/Yc with the
/// strength St in transverse shear (Hashin 1980).
template <class T>
T matrix_index(const T& s, double Yt, double Yc, double St) {
  const double t = 1 / (2 * St), linear = (Yc * t * Yc * t - 1) / Yc;
  return select(s > 0.0, T(s * s * (1 / (Yt * Yt))), T(s * (s * (t * t) + linear)));
}
}  // namespace detail

/// Maximum stress (Jones 1975, chapter 2): fibres fail at sigma_1 = Xt or -Xc, the matrix at sigma_2 = Yt or -Yc or
/// |tau_12| = S.
struct MaximumStress {
  double Xt, Xc;  ///< strengths along the fibres, in tension and compression [stress]
  double Yt, Yc;  ///< across [stress]
  double S;       ///< in shear [stress]

  void ranges(const auto& number) const {
    number("Xt", Xt, range::positive), number("Xc", Xc, range::positive);
    number("Yt", Yt, range::positive), number("Yc", Yc, range::positive);
    number("S", S, range::positive);
  }

  template <class T>
  PlyIndex<T> index(const PlaneTensor<T>& s) const {
    return {max(T(s.xx * (1 / Xt)), T(s.xx * (-1 / Xc))),
            max(max(T(s.yy * (1 / Yt)), T(s.yy * (-1 / Yc))), T(abs(s.xy) * (1 / S)))};
  }
};

/// Hashin (1980) in plane stress:
///   fibres:  (sigma_1/Xt)^2 + (tau_12/SL)^2 = 1 in tension,   sigma_1 = -Xc in compression
///   matrix:  (sigma_2/Yt)^2 + (tau_12/SL)^2 = 1 in tension,
///            (sigma_2/(2 ST))^2 + [(Yc/(2 ST))^2 - 1] sigma_2/Yc + (tau_12/SL)^2 = 1 in compression
struct Hashin {
  double Xt, Xc;  ///< strengths along the fibres, in tension and compression [stress]
  double Yt, Yc;  ///< across [stress]
  double SL, ST;  ///< in shear along the fibres and across them [stress]

  void ranges(const auto& number) const {
    number("Xt", Xt, range::positive), number("Xc", Xc, range::positive);
    number("Yt", Yt, range::positive), number("Yc", Yc, range::positive);
    number("SL", SL, range::positive), number("ST", ST, range::positive);
  }

  template <class T>
  PlyIndex<T> index(const PlaneTensor<T>& s) const {
    const T shear = (s.xy * s.xy) * (1 / (SL * SL));
    return {detail::squared_ratio(s.xx, Xt, Xc) + select(s.xx > 0.0, shear, T(0.0)),
            detail::matrix_index(s.yy, Yt, Yc, ST) + shear};
  }
};

/// Chang and Chang (1987) with linear shear, so that their share of the shear energy is (tau_12/S)^2:
///   fibres:  (sigma_1/Xt)^2 + beta (tau_12/S)^2 = 1 in tension;  in compression, which they leave open, sigma_1 = -Xc
///   matrix:  (sigma_2/Yt)^2 + (tau_12/S)^2 = 1 in tension,
///            (sigma_2/(2 S))^2 + [(Yc/(2 S))^2 - 1] sigma_2/Yc + (tau_12/S)^2 = 1 in compression
struct ChangChang {
  double Xt, Xc;    ///< strengths along the fibres, in tension and compression [stress]
  double Yt, Yc;    ///< across [stress]
  double S;         ///< in shear [stress]
  double beta = 1;  ///< weight of the shear in the failure of fibres; theirs is 1

  void ranges(const auto& number) const {
    number("Xt", Xt, range::positive), number("Xc", Xc, range::positive);
    number("Yt", Yt, range::positive), number("Yc", Yc, range::positive);
    number("S", S, range::positive), number("beta", beta, range::share);
  }

  template <class T>
  PlyIndex<T> index(const PlaneTensor<T>& s) const {
    const T shear = (s.xy * s.xy) * (1 / (S * S));
    return {detail::squared_ratio(s.xx, Xt, Xc) + select(s.xx > 0.0, T(beta * shear), T(0.0)),
            detail::matrix_index(s.yy, Yt, Yc, S) + shear};
  }
};

/// An OrthotropicPly that fails, point by point, at once and for ever (the reductions of stiffness of Chang and Chang
/// 1987): where the matrix fails, E2, nu12 and G12 become zero, and the fibres go on with E1; where fibres fail, all.
///   FailingPly ply{carbon, Hashin{.Xt = 2000, .Xc = 1200, .Yt = 50, .Yc = 200, .SL = 90, .ST = 70}};
/// The strain stays as the stiffness falls, so that sigma_1 becomes E1 eps_1 = sigma_1 - nu12 sigma_2: the energy
/// eps.Q eps/2 falls, never rises. What falls is lost, and stays in the balance as internal energy.
template <class Criterion>
struct FailingPly {
  static constexpr bool sound = PlyCriterion<Criterion>;
  static_assert(
      sound,
      "strike: the second piece of a FailingPly is its criterion: MaximumStress, Hashin, ChangChang or one of "
      "your own with PlyIndex<T> index(const PlaneTensor<T>& stress) const, a template over the number T.");

  OrthotropicPly ply;
  Criterion criterion;

  void ranges(const auto& number) const { number(ply), number(criterion); }

  using Kinematics = PlaneStressKinematics;
  template <class T>
  struct State {
    PlaneTensor<T> stress{};  ///< sigma_1, sigma_2, tau_12
    T intact{1.0};            ///< 0 where the fibres have failed
    T matrix{1.0};            ///< 0 where the matrix has failed
  };

  double density() const { return ply.density; }

  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    const PlaneTensor<T> d = T(dt) * select(state.intact > 0.0, rate.rate_of_deformation, PlaneTensor<T>{});
    const auto matrix = state.matrix > 0.0;
    state.stress += select(matrix, ply.elastic(d), PlaneTensor<T>{ply.E1 * d.xx, T(0.0), T(0.0)});

    const PlyIndex<T> index = criterion.index(state.stress);
    const auto matrix_fails = matrix && index.matrix >= 1.0, fibre_fails = index.fibre >= 1.0;
    state.stress = select(matrix_fails, PlaneTensor<T>{state.stress.xx - ply.nu12 * state.stress.yy, T(0.0), T(0.0)},
                          state.stress);
    state.intact = select(fibre_fails, T(0.0), state.intact);
    state.matrix = select(matrix_fails || fibre_fails, T(0.0), state.matrix);
    state.stress = select(state.intact > 0.0, state.stress, PlaneTensor<T>{});
    return state.stress;
  }
  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }
  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>& rate) const {
    return ply.moduli(OrthotropicPly::State<T>{}, rate);
  }
  template <class T>
  T normal_rate(const State<T>&, const PlaneStressKinematics::Rate<T>& rate, double dt,
                const PlaneTensor<T>& change) const {
    return ply.normal_rate(OrthotropicPly::State<T>{}, rate, dt, change);
  }
  template <class T>
  T intact(const State<T>& state) const {
    return state.intact;
  }

  PlaneStiffness plane_stiffness() const { return ply.plane_stiffness(); }
  Matrix2 transverse_stiffness() const { return ply.transverse_stiffness(); }
  double fibre_angle() const { return ply.fibre_angle(); }
};
template <class Criterion>
FailingPly(OrthotropicPly, Criterion) -> FailingPly<Criterion>;

}  // namespace strike
