#pragma once
#include <strike/element/element.hpp>
#include <strike/element/solid_resistance.hpp>
#include <strike/element/tet4_gradient.hpp>

namespace strike {

/// Resistance of a tetrahedron to a small motion p of its nodes in a step dt: the forces (K dt^2/4 + C dt/2) p of its
/// stiffness K and its damping C. A stable step keeps their largest eigenvalue over the mass at or below 1.
///
/// The pressure from volumes at nodes answers the mean of sum dV/sum V over the nodes of the element. Where the bulk
/// modulus k varies, sqrt(k_e k_f) stands for k_e in what element f does to element e, so that the matrix is symmetric:
///   p_e = sqrt(k_e) mean_a r_a,   r_a = sum_f sqrt(k_f) dV_f/sum_f V_f.
template <class T, bool averages_volume>
struct Tet4Resistance;

template <class T>
struct Tet4Resistance<T, false> {
  T mass{};  ///< of each node
  SolidResistance<T> own{};

  Tet4Resistance& operator*=(const T& share) {
    own *= share;
    return *this;
  }
  Nodal<T, 4> operator()(const Nodal<T, 4>& x, const Nodal<T, 4>& p) const {
    const Tet4Gradient<T> g(x);
    return g.forces_of(own.stress(g.gradient_of(p, 1.0 / g.volume)));
  }
};

template <class T>
struct Tet4Resistance<T, true> {
  T mass{};  ///< of each node
  SolidResistance<T> own{};
  T root_bulk{};  ///< sqrt(k)

  Tet4Resistance& operator*=(const T& share) {
    own *= share, root_bulk *= sqrt(share);
    return *this;
  }
  /// V, and sqrt(k) dV.
  struct Volume {
    T present, change;
  };
  Volume volume(const Nodal<T, 4>& x, const Nodal<T, 4>& p) const {
    const Tet4Gradient<T> g(x);
    return {g.volume, root_bulk * g.gradient_of(p, T(1.0)).trace()};
  }
  /// `r`: the mean of r_a over the nodes; by itself that of its own volume.
  Nodal<T, 4> operator()(const Nodal<T, 4>& x, const Nodal<T, 4>& p, const T& r) const {
    const Tet4Gradient<T> g(x);
    return g.forces_of(own.stress(g.gradient_of(p, 1.0 / g.volume)) + SymmetricTensor<T>::isotropic(root_bulk * r));
  }
  Nodal<T, 4> operator()(const Nodal<T, 4>& x, const Nodal<T, 4>& p) const {
    const Volume V = volume(x, p);
    return (*this)(x, p, T(V.change / V.present));
  }
};

}  // namespace strike
