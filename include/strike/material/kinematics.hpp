#pragma once
#include <strike/tensor/plane.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

// Conjugate pairs of a measure of motion and a stress. The product of a rate and a stress is a power: an element
// measures the rate, its material answers with the stress, and the moduli bound the tangent, from which a stable step
// follows.

/// Bulk and shear modulus of a material in its present state [stress]: they bound its tangent, rho c^2 = K + 4/3 G.
template <class T>
struct Moduli {
  T bulk, shear;

  /// rho c^2 = K + 4/3 G.
  T wave() const { return bulk + T(4.0 / 3.0) * shear; }
};

/// The pair of the solids.
struct SolidKinematics {
  template <class T>
  struct Rate {
    SymmetricTensor<T> rate_of_deformation;  ///< D = sym(L) at mid-step [1/time]
    T relative_volume{1.0};                  ///< V/V0 at the end of the step

    template <class Condition>
    friend Rate select(const Condition& c, const Rate& a, const Rate& b) {
      return {select(c, a.rate_of_deformation, b.rate_of_deformation), select(c, a.relative_volume, b.relative_volume)};
    }
  };
  template <class T>
  using Stress = SymmetricTensor<T>;  ///< Cauchy stress, tension positive
  template <class T>
  using Moduli = strike::Moduli<T>;
};

/// The change of a volume v in a step of volumetric strain theta = tr(D) dt at mid-step: v_new - v_old, exact to third
/// order.
template <class T>
T volume_increment(const T& v_new, const T& theta) {
  return v_new * (theta / (1.0 + 0.5 * theta));
}

/// Stiffness of an isotropic material in plane stress, or of a section per width: `normal` E/(1 - nu^2), `shear` G.
template <class T>
struct PlaneModuli {
  T normal, shear;

  /// rho c^2 of the wave in a plate.
  T wave() const { return normal; }
};

/// The pair of a point in the thickness of a plate, in the frame of the plate, so that no tensor is turned; the stress
/// across is zero.
struct PlaneStressKinematics {
  template <class T>
  struct Rate {
    PlaneTensor<T> rate_of_deformation;  ///< D in the plane, at mid-step [1/time]

    template <class Condition>
    friend Rate select(const Condition& c, const Rate& a, const Rate& b) {
      return {select(c, a.rate_of_deformation, b.rate_of_deformation)};
    }
  };
  template <class T>
  using Stress = PlaneTensor<T>;  ///< Cauchy stress, tension positive
  template <class T>
  using Moduli = PlaneModuli<T>;
};

/// The pair of the plates, in the frame of the plate. A point at the height z over the reference surface is strained by
/// membrane + z curvature; its stress counts by resultants per width.
struct PlateKinematics {
  template <class T>
  struct Rate {
    PlaneTensor<T> membrane;    ///< rate of deformation of the reference surface, at mid-step [1/time]
    PlaneTensor<T> curvature;   ///< [1/(time length)]
    Vector2<T> shear;           ///< gamma_xz, gamma_yz, twice the tensor's components [1/time]
    T relative_thickness{1.0};  ///< h/h0
  };
  template <class T>
  struct Stress {
    PlaneTensor<T> force{};                 ///< N = int sigma dz [force/length]
    PlaneTensor<T> moment{};                ///< M = int sigma z dz [force]
    Vector2<T> shear = Vector2<T>::Zero();  ///< Q_x, Q_y [force/length]
    T normal_rate{};                        ///< d_zz, the mean rate of growth of the thickness [1/time]
  };
  /// Bounds of the section's tangent, per width: int (1, z, z^2) of E/(1 - nu^2) and G, and the transverse shear.
  template <class T>
  struct Moduli {
    PlaneModuli<T> extension, coupling, bending;
    T transverse_shear;  ///< the larger eigenvalue of K [force/length]

    T wave() const { return extension.wave(); }
  };
};

}  // namespace strike
