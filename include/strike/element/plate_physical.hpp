#pragma once
#include <strike/element/physical_hourglass.hpp>
#include <strike/element/plate4_modes.hpp>
#include <strike/section/linear_stress.hpp>

// PhysicalHourglass in a plate: docs/theory.md.
namespace strike::detail {

/// A section whose points have linear stresses.
template <class Section>
concept HasLinearStress = requires { typename Section::template LinearState<double>; };

/// Linear resultants of a section that has no points: elastic.
template <class T>
struct LinearForces {
  AlongEdges<T> force{}, moment{};
};
template <class Section, class T>
struct LinearStateOf {
  using type = LinearForces<T>;
};
template <HasLinearStress Section, class T>
struct LinearStateOf<Section, T> {
  using type = typename Section::template LinearState<T>;
};

/// Memory of the control: the linear stresses of the section's points, and the transverse shear forces that are linear
/// over the plane, contravariant [force/length^2].
template <class Section, class T>
struct PhysicalPlateState {
  typename LinearStateOf<Section, T>::type linear{};
  AlongEdges<T> shear{};

  template <class F>
  void visit_numbers(const PhysicalPlateState& other, const F& f) {
    strike::visit_numbers<T>(linear, other.linear, f), strike::visit_numbers<T>(shear, other.shear, f);
  }
};

/// Memory of the control of a plate.
template <class Control, class Section, class T>
struct PlateControlState {
  using type = typename Control::template State<T>;
};
template <class Section, class T>
struct PlateControlState<PhysicalHourglass, Section, T> {
  using type = PhysicalPlateState<Section, T>;
};

/// Stiffness of a section in plane stress along one direction, from that in all: E = 4 G (1 - G/Q).
template <class T>
T uniaxial(const PlaneModuli<T>& m) {
  return 4.0 * m.shear * (1.0 - m.shear / m.normal);
}

/// Advances the linear stresses, and all others, by a step.
template <class Section, class T, class Linear>
PlateKinematics::Stress<T> stress(const Section& section, typename Section::template State<T>& state, Linear& linear,
                                  const PlateKinematics::Rate<T>& rate, const LinearRate<T>& linear_rate, double dt,
                                  LinearResultants<T>& resultants) {
  if constexpr (HasLinearStress<Section>) {
    return section.stress(state, linear, rate, linear_rate, dt, resultants);
  } else {
    const PlateKinematics::Moduli<T> moduli = section.moduli(state, rate);
    resultants.power_before = dot(linear.force, linear_rate.membrane) + dot(linear.moment, linear_rate.curvature);
    linear.force = linear.force + T(dt * uniaxial(moduli.extension)) * linear_rate.membrane;
    linear.moment = linear.moment + T(dt * uniaxial(moduli.bending)) * linear_rate.curvature;
    resultants.force = linear.force, resultants.moment = linear.moment;
    return section.stress(state, rate, dt);
  }
}

/// The mean edges of a plate: the tangents m_k of its middle, four times, and their metric.
template <class T>
class PlateEdges {
 public:
  explicit PlateEdges(const Plate4Frame<T>& f)
      : xi_(dot(f.m_xi, f.m_xi)), eta_(dot(f.m_eta, f.m_eta)), mixed_(dot(f.m_xi, f.m_eta)) {
    const T both = 1.0 / (xi_ * eta_);
    per_xi_ = both * eta_, per_eta_ = both * xi_;
  }

  /// a_k/|m_k|^2.
  AlongEdges<T> per_square(const T& xi, const T& eta) const { return {per_xi_ * xi, per_eta_ * eta}; }
  AlongEdges<T> per_square(const AlongEdges<T>& a) const { return per_square(a.xi, a.eta); }
  /// Squares t (x) t of the unit vectors along the edges, in the frame.
  PlaneTensor<T> square_xi(const Plate4Frame<T>& f) const { return square(f.turned(xi_, mixed_), per_xi_); }
  PlaneTensor<T> square_eta(const Plate4Frame<T>& f) const { return square(f.turned(mixed_, eta_), per_eta_); }
  /// The part of the spin about the normal that is linear in the plane, in the modes of Plate4Drilling, of linear
  /// strains e without shear: its gradient is the curvature of the edges.
  AlongEdges<T> spin(const AlongEdges<T>& e, const T& A) const {
    return T(1.0 / A) * AlongEdges<T>{mixed_ * e.eta - xi_ * e.xi, eta_ * e.eta - mixed_ * e.xi};
  }
  /// The transpose: the forces on e of moments on the spin.
  AlongEdges<T> strain_of_spin(const AlongEdges<T>& D, const T& A) const {
    return T(1.0 / A) * AlongEdges<T>{-xi_ * D.xi - mixed_ * D.eta, mixed_ * D.xi + eta_ * D.eta};
  }
  /// g^kk of the inverse metric, over the area A.
  AlongEdges<T> inverse(const T& A) const { return T(1.0 / (16.0 * A * A)) * AlongEdges<T>{eta_, xi_}; }
  /// The larger eigenvalue of sum m_k (x) m_k/|m_k|^4.
  T stiffest() const {
    const T both = mixed_ * per_xi_ * per_eta_;
    return strike::largest_eigenvalue<T>(per_xi_, per_eta_, both * both);
  }
  /// |m_xi - p_xi h|^2 + p_eta^2 |h|^2 and the same along eta, of a vector h = p_k m_k.
  AlongEdges<T> beside(const Vector2<T>& p) const {
    const T h_xi = xi_ * p(0) + mixed_ * p(1), h_eta = mixed_ * p(0) + eta_ * p(1);
    const T both = (p(0) * p(0) + p(1) * p(1)) * (p(0) * h_xi + p(1) * h_eta);
    return {xi_ - 2.0 * p(0) * h_xi + both, eta_ - 2.0 * p(1) * h_eta + both};
  }

 private:
  static PlaneTensor<T> square(const Vector2<T>& a, const T& c) {
    return {c * a(0) * a(0), c * a(1) * a(1), c * a(0) * a(1)};
  }
  T xi_, eta_, mixed_, per_xi_, per_eta_;
};

/// Rates of the control: of the linear strains of the section, and of the covariant transverse shears that are linear
/// over the plane.
template <class T>
struct PhysicalPlateRate {
  LinearRate<T> linear;
  AlongEdges<T> shear, inverse;  ///< inverse: g^kk
};

}  // namespace strike::detail
