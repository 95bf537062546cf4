#pragma once
// An element with two nodes and a material for it, by a pair of measure and stress of their own.
#include <strike/dynamics.hpp>
#include <strike/element.hpp>

namespace strike {

/// The pair of the bars, per volume: the rate at which the length grows, l'/l, and the stress along the bar.
struct AxialKinematics {
  template <class T>
  struct Rate {
    T stretching;  ///< in the middle of the step [1/time]
  };
  template <class T>
  using Stress = T;
  template <class T>
  struct Moduli {
    T youngs;
    T wave() const { return youngs; }  // rho c^2
  };
};

/// A wire that yields, with the stress that it has at rest.
struct Wire {
  double density, youngs_modulus, yield_stress, initial_stress = 0;

  using Kinematics = AxialKinematics;

  template <class T>
  struct State {
    T stress{};
  };

  template <class T>
  void begin(State<T>& state) const {
    state.stress = T(initial_stress);
  }
  template <class T>
  T stress(State<T>& state, const AxialKinematics::Rate<T>& rate, double dt) const {
    const T trial = state.stress + youngs_modulus * dt * rate.stretching;
    return state.stress = max(T(-yield_stress), min(T(yield_stress), trial));
  }
  template <class T>
  T stress(const State<T>& state) const {
    return state.stress;
  }
  template <class T>
  AxialKinematics::Moduli<T> moduli(const State<T>&, const AxialKinematics::Rate<T>&) const {
    return {T(youngs_modulus)};
  }
};

/// The straight bar between two nodes, which keeps its volume, as metals do when they flow.
struct Truss {
  double area;  ///< of the cross-section, at rest

  using Kinematics = AxialKinematics;
  static constexpr int nodes = 2;

  template <class M, class T>
  struct State {
    T volume;
    typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 2>& x) const {
    if constexpr (requires { material.begin(state.material); }) material.begin(state.material);
    const Vector3<T> d = column(x, 1) - column(x, 0);
    state.volume = area * sqrt(dot(d, d));
    return 0.5 * density_of(material) * state.volume;
  }

  template <class M, class T>
  Response<T, 2> advance(State<M, T>& state, const M& material, const Nodal<T, 2>& x, const Nodal<T, 2>& v,
                         double dt) const {
    const Vector3<T> d = column(x, 1) - column(x, 0), w = column(v, 1) - column(v, 0);
    const Vector3<T> d_mid =
        d - (0.5 * dt) * w;  // w.d_mid dt is exactly the growth of d.d/2: a rotation strains nothing
    const AxialKinematics::Rate<T> rate{dot(w, d_mid) / dot(d_mid, d_mid)};

    const T before = material.stress(std::as_const(state.material));
    const T sigma = material.stress(state.material, rate, dt);
    const T per_length = rsqrt(dot(d, d));
    const Vector3<T> f = (state.volume * sigma * per_length * per_length) * d;  // sigma V/l along d/l

    Response<T, 2> response;
    set_column<T>(response.force, 0, -f), set_column<T>(response.force, 1, f);
    response.volume = state.volume;
    response.critical_rate =
        sqrt(material.moduli(state.material, rate).wave() / density_of(material)) * per_length;  // c/l
    response.internal_work = state.volume * (0.5 * dt) * (before + sigma) * rate.stretching;
    response.hourglass_work = response.bulk_viscosity_work = T(0.0);
    return response;
  }
};

}  // namespace strike
