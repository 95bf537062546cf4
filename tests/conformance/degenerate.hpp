#pragma once
// Wedges and pyramids: hexahedra with corners in the same node, as elements of 6 and of 5 nodes.
#include <array>
#include <cmath>
#include <cstddef>

#include <strike/element/merged_corners.hpp>
#include <strike/verify/single_element.hpp>

namespace strike::testing {

/// An element of hexahedra on the n nodes of a wedge or a pyramid. Its mass of each node is the mean one.
template <class E, int n>
struct Degenerate : E {
  static_assert(n == 6 || n == 5);
  static constexpr int nodes = n;
  /// The node of each corner, and the shares of the nodes in the mass.
  static constexpr std::array<int, 8> node_of =
      n == 6 ? std::array<int, 8>{0, 1, 2, 2, 3, 4, 5, 5} : std::array<int, 8>{0, 1, 2, 3, 4, 4, 4, 4};
  static constexpr double share(int node) { return n == 6 ? 1.0 / 6 : node == 4 ? 1.0 / 4 : 3.0 / 16; }

  template <class M, class T>
  using State = typename E::template State<M, T>;

  template <class T>
  static Nodal<T, 8> at_corners(const Nodal<T, n>& x) {
    Nodal<T, 8> corners;
    for (int i = 0; i < 8; ++i) corners.col(i) = x.col(node_of[static_cast<std::size_t>(i)]);
    return corners;
  }
  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, n>& x) const {
    return T(8.0 / n) * E::begin(state, material, at_corners<T>(x));
  }
  template <class M, class T>
  Response<T, n> advance(State<M, T>& state, const M& material, const Nodal<T, n>& x, const Nodal<T, n>& v,
                         double dt) const {
    MergedCorners<T> corners;
    (n == 6 ? corners.wedge : corners.pyramid) = T(1.0);
    const MergedGradient<T> merged(corners, at_corners<T>(x));
    VibrationSources<T> sources;
    const Response<T, 8> r = E::advance(state, material, at_corners<T>(x), at_corners<T>(v), dt, &sources);
    const T own = E::merged_rate(state, material, merged, r.volume, sources);
    Response<T, n> response{{},
                            r.volume,
                            select(r.critical_rate > 0.0, own, r.critical_rate),
                            r.internal_work,
                            r.hourglass_work,
                            r.bulk_viscosity_work};
    response.force.setConstant(T(0.0));
    for (int i = 0; i < 8; ++i) response.force.col(node_of[static_cast<std::size_t>(i)]) += r.force.col(i);
    return response;
  }
};

/// The free vibrations of an element, in coordinates by which the masses of all its nodes are the mean one.
template <class E, class M>
verify::ElementVibration<> vibration_of(const verify::SingleElement<E, M>& single,
                                        const Nodal<double, motions<E>>& v = Nodal<double, motions<E>>::Zero()) {
  auto vibration = single.vibration(v);
  if constexpr (requires { E::share(0); })
    for (int i = 0; i < 3 * E::nodes; ++i)
      for (int j = 0; j < 3 * E::nodes; ++j) {
        const double scale = 1 / (E::nodes * std::sqrt(E::share(i / 3) * E::share(j / 3)));
        vibration.stiffness(i, j) *= scale, vibration.damping(i, j) *= scale;
      }
  return vibration;
}

/// Corners of a prism over an equilateral triangle and of a pyramid over a square, of edges 1.
inline Nodal<double, 6> unit_wedge() {
  Nodal<double, 6> x;
  x << 0, 1, 0.5, 0, 1, 0.5,                         //
      0, 0, std::sqrt(0.75), 0, 0, std::sqrt(0.75),  //
      0, 0, 0, 1, 1, 1;
  return x;
}
inline Nodal<double, 5> unit_pyramid() {
  Nodal<double, 5> x;
  x << 0, 1, 1, 0, 0.5,  //
      0, 0, 1, 1, 0.5,   //
      0, 0, 0, 0, 0.7;
  return x;
}

}  // namespace strike::testing
