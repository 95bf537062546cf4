#pragma once
#include <cmath>

#include <strike/material/material.hpp>
#include <strike/material/plane_stiffness.hpp>
#include <strike/range.hpp>

namespace strike {

/// A ply of fibres along its axis 1, linear elastic and orthotropic, in plane stress (Jones 1975, chapter 2):
///   sigma_1 = Q11 eps_1 + Q12 eps_2,   sigma_2 = Q12 eps_1 + Q22 eps_2,   tau_12 = G12 gamma_12
///   Q11 = E1/(1 - nu12 nu21),   Q22 = E2/(1 - nu12 nu21),   Q12 = nu12 Q22,   nu21 = nu12 E2/E1
/// It answers in its own axes; a section turns them by `angle` from its FibreDirection, about the normal of the plate.
///   OrthotropicPly carbon{.density = 1.6e-9, .E1 = 140e3, .E2 = 9e3, .nu12 = 0.3, .G12 = 5e3, .G13 = 5e3, .G23 = 3e3};
struct OrthotropicPly {
  double density;        ///< [mass/volume]
  double E1, E2;         ///< Young's moduli along and across the fibres [stress]
  double nu12;           ///< -eps_2/eps_1 of a pull along 1; nu12^2 < E1/E2
  double G12, G13, G23;  ///< shear moduli [stress]
  double angle = 0;      ///< [degrees]
  double nu23 = 0.4;     ///< -eps_3/eps_2 of a pull along 2, of which the thickness alone depends; nu13 = nu12

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("E1", E1, range::positive);
    number("E2", E2, range::positive);
    const double most = std::sqrt(E1 / E2);
    number("nu12", nu12, Range{.low = -most, .high = most}, "its square is below E1/E2");
    number("G12", G12, range::positive);
    number("G13", G13, range::positive);
    number("G23", G23, range::positive);
    number("angle", angle, range::finite);
    number("nu23", nu23, Range{.low = -1, .high = 1});
  }

  using Kinematics = PlaneStressKinematics;
  template <class T>
  struct State {
    PlaneTensor<T> stress{};  ///< sigma_1, sigma_2, tau_12
  };

  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    state.stress += T(dt) * elastic(rate.rate_of_deformation);
    return state.stress;
  }
  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }
  /// Q eps.
  template <class T>
  PlaneTensor<T> elastic(const PlaneTensor<T>& strain) const {
    const double Q11 = this->Q11(), Q22 = this->Q22(), Q12 = nu12 * Q22;
    return {Q11 * strain.xx + Q12 * strain.yy, Q12 * strain.xx + Q22 * strain.yy, (2 * G12) * strain.xy};
  }
  /// The isotropic moduli that bound Q.
  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>&) const {
    const PlaneModuli<double> bound = detail::isotropic_bound(plane_stiffness());
    return {T(bound.normal), T(bound.shear)};
  }
  /// d_zz of the step: -(nu12/E1 d sigma_1 + nu23/E2 d sigma_2).
  template <class T>
  T normal_rate(const State<T>&, const PlaneStressKinematics::Rate<T>&, double dt, const PlaneTensor<T>& change) const {
    return T(-nu12 / (E1 * dt)) * change.xx - T(nu23 / (E2 * dt)) * change.yy;
  }

  // For a section with fibres.
  /// Q [stress].
  PlaneStiffness plane_stiffness() const {
    const double Q22 = this->Q22(), Q12 = nu12 * Q22;
    PlaneStiffness Q;
    Q << Q11(), Q12, 0, Q12, Q22, 0, 0, 0, G12;
    return Q;
  }
  /// diag(G13, G23) [stress].
  Matrix2 transverse_stiffness() const {
    Matrix2 G;
    G << G13, 0, 0, G23;
    return G;
  }
  /// [degrees]
  double fibre_angle() const { return angle; }

 private:
  double Q11() const { return E1 / (1 - nu12 * nu12 * (E2 / E1)); }
  double Q22() const { return E2 / (1 - nu12 * nu12 * (E2 / E1)); }
};

}  // namespace strike
