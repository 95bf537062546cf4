#pragma once
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <strike/element/element.hpp>
#include <strike/protocol.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

// A removal law: the fourth piece of a Part, which says when its elements are deleted.
//
// Requirements.
//  1. keeps(state, element)      a comparison of lanes, true where an element stays. `state` is that of the element
//                                after the step, with each_point(f) over the states of its material points; `element`
//                                is an ElementCondition
//  2. needs_geometric_strain     static constexpr bool, optional: true gives element.geometric_strain() and costs nine
//                                numbers per element; or needs_geometric_strain_of<M>, the same for each material M
//
// Laws. A deleted element gives no force and bounds no step; its mass stays with its nodes, and the energy that it held
// leaves with it (Energy::eroded). An element whose volume is not positive or not a number is not kept. Lane by lane
// the answer is that of a double.
//
// Models: Erosion, NoErosion.

namespace detail {

/// Edges of an element from which its deformation is measured: the mean edges of a hexahedron along its three axes, the
/// edges of a tetrahedron at its first corner, the mean edges of a plate and its unit normal;
/// of a triangle two of its own.
template <class E, class T>
Matrix3<T> element_axes(const Nodal<T, E::nodes>& x) {
  const auto at = [&](int i) { return column(x, static_cast<std::size_t>(i)); };
  if constexpr (E::nodes == 8) {
    return columns<T>(T(0.25) * Vector3<T>((at(1) + at(2) + at(5) + at(6)) - (at(0) + at(3) + at(4) + at(7))),
                      T(0.25) * Vector3<T>((at(2) + at(3) + at(6) + at(7)) - (at(0) + at(1) + at(4) + at(5))),
                      T(0.25) * Vector3<T>((at(4) + at(5) + at(6) + at(7)) - (at(0) + at(1) + at(2) + at(3))));
  } else if constexpr (turns_nodes<E>()) {
    if constexpr (E::nodes == 3) {
      const Vector3<T> a = at(1) - at(0), b = at(2) - at(0), n = cross(a, b);
      return columns<T>(a, b, T(rsqrt(dot(n, n))) * n);
    } else {
      const Vector3<T> a = T(0.5) * Vector3<T>((at(1) + at(2)) - (at(0) + at(3))),
                       b = T(0.5) * Vector3<T>((at(2) + at(3)) - (at(0) + at(1))), n = cross(a, b);
      return columns<T>(a, b, T(rsqrt(dot(n, n))) * n);
    }
  } else {
    static_assert(E::nodes == 4,
                  "strike: the geometric strain is known of elements with 8 or 4 nodes: limit this Part by .volume or "
                  ".step, or by a removal law of your own.");
    return columns<T>(at(1) - at(0), at(2) - at(0), at(3) - at(0));
  }
}

template <class T>
Matrix3<T> inverse_of_columns(const Matrix3<T>& A) {
  const Vector3<T> a = column(A, 0), b = column(A, 1), c = column(A, 2), bc = cross(b, c), ca = cross(c, a),
                   ab = cross(a, b);
  const T per_volume = 1.0 / dot(a, bc);
  Matrix3<T> inverse;
  for (int j = 0; j < 3; ++j)
    inverse(0, j) = per_volume * bc(j), inverse(1, j) = per_volume * ca(j), inverse(2, j) = per_volume * ab(j);
  return inverse;
}

/// sqrt(2/3 e:e) of the deviator e of Hencky's strain ln U, of the deformation gradient F = U R [1].
template <class T>
T equivalent_hencky_strain(const Matrix3<T>& F) {
  const Vector3<T> a = column(F, 0), b = column(F, 1), c = column(F, 2);
  const SymmetricTensor<T> C{dot(a, a), dot(b, b), dot(c, c), dot(a, b), dot(b, c), dot(c, a)};
  const T least = T(1e-30), first = largest_principal(C), third = -largest_principal(T(-1.0) * C);
  const auto stretch = [&](const T& square) { return 0.5 * log(max(least, square)); };
  const T h1 = stretch(first), h2 = stretch(T(trace(C) - first - third)), h3 = stretch(third),
          mean = (1.0 / 3.0) * (h1 + h2 + h3);
  return sqrt((2.0 / 3.0) * ((h1 - mean) * (h1 - mean) + (h2 - mean) * (h2 - mean) + (h3 - mean) * (h3 - mean)));
}

/// The inverse of an element's axes at rest.
template <class T>
struct ReferenceAxes {
  Matrix3<T> inverse = Matrix3<T>::Zero();
};
struct NoReferenceAxes {};

template <class Law, class M, int nodes = 0>
constexpr bool needs_geometric_strain() {
  if constexpr (nodes == 1) return false;  // a particle has no shape
  if constexpr (requires { Law::template needs_geometric_strain_of<M>; })
    return Law::template needs_geometric_strain_of<M>;
  else if constexpr (requires { Law::needs_geometric_strain; })
    return Law::needs_geometric_strain;
  else
    return false;
}

}  // namespace detail

/// The condition of elements after a step, as a removal law sees it. E is the element, M its material.
template <class E, class M, class T, bool has_geometry>
struct ElementCondition {
  const T& volume;          ///< of a plate its area
  const T& initial_volume;  ///< at the start of the run
  const T& critical_rate;   ///< one over the stable step of the element alone, before the factor [1/time]
  const Nodal<T, E::nodes>& position;
  const std::conditional_t<has_geometry, detail::ReferenceAxes<T>, detail::NoReferenceAxes>& reference;

  /// V/V0.
  T relative_volume() const { return volume / initial_volume; }
  /// The equivalent strain of its shape: sqrt(2/3 e:e), e the deviator of Hencky's strain of its mean deformation; of a
  /// plate in its surface.
  T geometric_strain() const {
    static_assert(has_geometry,
                  "strike: a removal law that reads geometric_strain() says static constexpr bool "
                  "needs_geometric_strain = true.");
    const Matrix3<T> axes = detail::element_axes<E, T>(position);
    Matrix3<T> F;
    for (std::size_t j = 0; j < 3; ++j) set_column(F, j, times(axes, column(reference.inverse, j)));
    return detail::equivalent_hencky_strain(F);
  }
};

/// Elements stay whatever becomes of them: failed material gives no force, and the run ends where another is inverted.
struct NoErosion {};

namespace detail {

struct Keeps {
  struct Decoy {
    int keeps;
  };
  template <class Law>
  using Member = decltype(&Law::keeps);
};

/// The law may be asked: it answers an element and its condition with a comparison.
template <class Law, class E, class M>
concept RemovalLaw =
    requires(const Law law, const typename E::template State<M, double> state,
             const ElementCondition<E, M, double, needs_geometric_strain<Law, M, E::nodes>()> condition) {
      { law.keeps(state, condition) } -> std::convertible_to<bool>;
    };

/// The memory of a block of elements that may be deleted, beside their state.
template <class T, bool has_geometry>
struct RemovalState {
  T alive{1.0};  ///< 1, or 0 once deleted
  T initial_volume{};
  T energy{};  ///< held by the element
  [[no_unique_address]] std::conditional_t<has_geometry, ReferenceAxes<T>, NoReferenceAxes> reference{};
};

/// The deleted elements of a step.
struct Deletions {
  std::size_t count = 0;
  double energy = 0;  ///< that they held

  void add(const Deletions& more) { count += more.count, energy += more.energy; }
};

}  // namespace detail

}  // namespace strike
