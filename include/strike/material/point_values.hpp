#pragma once
#include <type_traits>

#include <strike/scalar/scalar.hpp>
#include <strike/tensor/plane.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

// Values of a point of any material, equal in name for layers of different materials:
//   part.field(PlasticStrain{}), and of the lowest layer of a plate part.field(0, Failed{})

/// The equivalent plastic strain; 0 of materials without plasticity.
struct PlasticStrain {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.equivalent_plastic_strain; })
      return point.equivalent_plastic_strain;
    else
      return 0.0;
  }
};

/// 1 of a failed point, or else 0.
struct Failed {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.intact; })
      return 1.0 - point.intact;
    else
      return 0.0;
  }
};

/// 1 of a ply whose matrix has failed, with its fibres or without, or else 0.
struct MatrixFailed {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.matrix; })
      return 1.0 - point.matrix;
    else
      return 0.0;
  }
};

/// Von Mises' equivalent stress.
struct EquivalentStress {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.stress.zz; })
      return equivalent_stress(deviator(point.stress));
    else
      return equivalent_stress(point.stress);
  }
};

/// The stress as a tensor: of a point in a plate by its components in the frame of the plate, of a ply along and
/// across its fibres, of a bar along its axis as xx, of a fluid its pressure; 0 of a point without any.
struct StressTensor {
  template <class State>
  auto operator()(const State& point) const {
    if constexpr (requires { point.stress.zz; })
      return point.stress;
    else if constexpr (requires { point.stress.xx; })
      return of_plane(point.stress.xx, point.stress.yy, point.stress.xy);
    else if constexpr (requires { requires Scalar<std::remove_cvref_t<decltype(point.stress)>>; })
      return of_plane(point.stress);
    else if constexpr (requires { point.pressure; })
      return SymmetricTensor<std::remove_cvref_t<decltype(point.pressure)>>::isotropic(-point.pressure);
    else
      return SymmetricTensor<double>{};
  }

 private:
  template <class T>
  static SymmetricTensor<T> of_plane(const T& xx, const T& yy = T(0.0), const T& xy = T(0.0)) {
    return {xx, yy, T(0.0), xy, T(0.0), T(0.0)};
  }
};

}  // namespace strike
