#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <numbers>
#include <string>

#include <strike/material/kinematics.hpp>
#include <strike/material/plane_stiffness.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike {

// Transverse shear of a plate of isotropic layers (Whitney 1973; Rohwer 1988; Abaqus Theory 3.6.8): bending in one
// direction, the shear stress of equilibrium, and the stiffness that stores its energy. In bending an isotropic layer
// has div sigma = Q (z - z0) grad laplace w in all directions, so that Q = E/(1 - nu^2) and G of a layer suffice,
// Poisson's ratios may differ, and K is equal in x and y.

/// A layer in transverse shear.
template <class T>
struct ShearLayer {
  T thickness;            ///< [length]
  PlaneModuli<T> moduli;  ///< Q = E/(1 - nu^2) and G [stress]
};

/// g = tau/V in a layer, the shear stress per shear force [1/length]: a parabola from its value at the bottom to that
/// at the top, and its bulge over the straight line between them.
template <class T>
struct ShearFlow {
  T bottom{}, top{}, bulge{};

  /// At xi from 0, the bottom of the layer, to 1, its top.
  T operator()(double xi) const { return (1 - xi) * bottom + xi * top + (4 * xi * (1 - xi)) * bulge; }
  /// The mean of g^2 over the layer, from that of a quartic.
  T mean_square() const {
    return (1.0 / 3.0) * (bottom * bottom + bottom * top + top * top) + (2.0 / 3.0) * bulge * (bottom + top) +
           (8.0 / 15.0) * (bulge * bulge);
  }
};

/// Transverse shear of all layers together.
template <class T>
struct TransverseShear {
  T bending{};       ///< D* = int Q (z - z0)^2 dz [force length]
  T neutral_axis{};  ///< z0 over the bottom
  T stiffness{};     ///< K, 1/K = int g^2/G dz [force/length]
  T own_bending{};   ///< Df, the rest of D* when the layers slide [force length]
  T layer_sum{};     ///< int G dz, a bound of K [force/length]
  T thickness{};     ///< [length]

  /// s_k, the share of a layer with the flow g in 1/K = int g^2/G dz.
  T share_of_flexibility(const ShearLayer<T>& layer, const ShearFlow<T>& g) const {
    return stiffness * flexibility(layer, g);
  }
  /// The part of a layer in 1/K [length/force]. No layer counts as softer than 1e-12 of the mean, so that K is never
  /// zero.
  T flexibility(const ShearLayer<T>& layer, const ShearFlow<T>& g) const {
    return layer.thickness * g.mean_square() / max(layer.moduli.shear, T(1e-12) * layer_sum / thickness);
  }

  /// phi = Df/D0, D* = D0 + Df.
  T own_share() const { return own_bending / (bending - own_bending); }

  /// s = p^2 D0/Kc with p = pi/length and K = Kc (1 + phi)^2: the sliding of the layers over a half wave of this
  /// length.
  T slip(double length) const {
    const T c = 1.0 + own_share();
    return square(std::numbers::pi / length) * (bending - own_bending) * (c * c / stiffness);
  }
  /// Relative excess of the deflection with K over a half wave of this length: phi s^2/((1 + phi)^2 (1 + s)).
  T error(double length) const {
    const T phi = own_share(), s = slip(length), c = s / (1.0 + phi);
    return phi * c * c / (1.0 + s);
  }
  /// Stiffness of a plate without sliding layers that deflects as far over a half wave of this length:
  /// K + (1 + phi) p^2 Df.
  T effective_stiffness(double length) const {
    return stiffness + (1.0 + own_share()) * square(std::numbers::pi / length) * own_bending;
  }

 private:
  static double square(double p) { return p * p; }
};

/// f(layer, flow) for every layer, bottom to top: from equilibrium,
///   g(z) = 1/D* int_z^top Q (z' - z0) dz'.
template <class T, class Layers, class F>
void each_shear_flow(const TransverseShear<T>& shear, const Layers& each_layer, F f) {
  T z = -shear.neutral_axis, g = T(0.0);
  const T per_D = 1.0 / shear.bending;
  each_layer([&](const ShearLayer<T>& layer) {
    const T& h = layer.thickness;
    const T Qh = layer.moduli.normal * h * per_D;
    const T top = g - Qh * (z + 0.5 * h);
    f(layer, ShearFlow<T>{g, top, 0.125 * (Qh * h)});
    z += h, g = top;
  });
}

/// The closed form of a TransverseShear; `each_layer(f)` calls f(ShearLayer) for every layer, bottom to top. A layer
/// without thickness counts for nothing.
///
/// Df = sum (1 - s_k) Q_k h_k^3/12, s_k the share of layer k in 1/K: a layer that does the sliding keeps no normal of
/// its own. Of one layer Df is zero; of two faces and a soft core it is the faces' own bending, as in sandwich theory
/// (Allen 1969).
template <class T, class Layers>
TransverseShear<T> transverse_shear(const Layers& each_layer) {
  TransverseShear<T> shear;
  T A = T(0.0), B = T(0.0), z = T(0.0);
  each_layer([&](const ShearLayer<T>& layer) {
    const T& h = layer.thickness;
    const T Qh = layer.moduli.normal * h;
    A += Qh, B += Qh * (z + 0.5 * h), z += h;
    shear.layer_sum += layer.moduli.shear * h;
  });
  shear.thickness = z, shear.neutral_axis = B / A;

  z = -shear.neutral_axis;
  each_layer([&](const ShearLayer<T>& layer) {
    const T& h = layer.thickness;
    const T middle = z + 0.5 * h;
    shear.bending += layer.moduli.normal * h * (middle * middle + (1.0 / 12.0) * (h * h));
    z += h;
  });

  T H = T(0.0), own = T(0.0), slid = T(0.0);
  each_shear_flow(shear, each_layer, [&](const ShearLayer<T>& layer, const ShearFlow<T>& g) {
    const T& h = layer.thickness;
    const T H_k = shear.flexibility(layer, g);
    const T D_k = (1.0 / 12.0) * (layer.moduli.normal * h * h * h);
    H += H_k, own += D_k, slid += H_k * D_k;
  });
  shear.stiffness = 1.0 / H;
  shear.own_bending = max(T(0.0), own - slid / H);
  return shear;
}

/// The TransverseShear of a list of layers: transverse_shear(std::vector<ShearLayer<double>>{{3, {7e4, 2.9e4}}, ...}).
template <class Layers>
  requires requires(const Layers& layers) { std::begin(layers)->thickness; }
auto transverse_shear(const Layers& layers) {
  using T = decltype(std::begin(layers)->thickness);
  return transverse_shear<T>([&](auto f) {
    for (const ShearLayer<T>& layer : layers) f(layer);
  });
}

/// Transverse shear of a laminate with fibres, in its axes (strike/section/laminate_stiffness.hpp): matrices from
/// (gamma_xz, gamma_yz) to (Q_x, Q_y).
struct LaminateShear {
  Matrix2 stiffness = Matrix2::Zero();  ///< K, symmetric and positive definite [force/length]
  Matrix2 layer_sum = Matrix2::Zero();  ///< int G dz [force/length]
};

namespace detail {
/// A warning where the error of K exceeds 5 %.
[[gnu::cold]] inline std::string shear_warning(const TransverseShear<double>& shear, double length) {
  if (!(length > 0) || !(shear.error(length) > 0.05)) return {};
  return joined({"The layers of a section slide on each other: over a half wave of ", text(length),
                 " its shear stiffness K = ", text(shear.stiffness), " deflects ", text(100 * shear.error(length)),
                 " % too far; give the section EffectiveShear{.length = ", text(length), "}."});
}
}  // namespace detail

/// The stiffness K that stores the energy of the exact shear stress to leading order in thickness per length.
struct EnergyShear {
  double length = 0;  ///< half wave in which an error above 5 % is a warning [length]; 0: that of the caller

  void ranges(const auto& number) const { number("length", length, range::not_negative); }

  double stiffness(const TransverseShear<double>& shear) const { return shear.stiffness; }
  Matrix2 stiffness(const LaminateShear& shear) const { return shear.stiffness; }
  std::string warning(const TransverseShear<double>& shear, double known_length) const {
    return detail::shear_warning(shear, length > 0 ? length : known_length);
  }
};

/// K + (1 + phi) p^2 Df: exact for soft layers between stiff ones over half waves of one length.
struct EffectiveShear {
  double length;  ///< pi/p, the half wave [length]

  void ranges(const auto& number) const { number("length", length, range::positive); }

  double stiffness(const TransverseShear<double>& shear) const { return shear.effective_stiffness(length); }
  /// Where layers slide, the shear force that couples them, V D0/D* with K alone, is (1 + phi)/(1 + phi (1 + s)) of
  /// that; the rest bends each layer by itself.
  ShearFlow<double> flow(const TransverseShear<double>& shear, const ShearLayer<double>& layer,
                         const ShearFlow<double>& g) const {
    const double phi = shear.own_share(), s = shear.slip(length);
    const double coupling = (1 + phi) / (1 + phi * (1 + s)), own = (1 + s) * coupling;
    const double slides = shear.share_of_flexibility(layer, g);
    return {coupling * g.bottom, coupling * g.top, (slides * coupling + (1 - slides) * own) * g.bulge};
  }
};

/// 5/6 of the sum of G h, exact for one layer alone.
struct FiveSixthsShear {
  double stiffness(const TransverseShear<double>& shear) const { return 5.0 / 6.0 * shear.layer_sum; }
  Matrix2 stiffness(const LaminateShear& shear) const { return 5.0 / 6.0 * shear.layer_sum; }
  [[gnu::cold]] std::string warning(const TransverseShear<double>& shear, double) const {
    const double ratio = stiffness(shear) / shear.stiffness;
    if (ratio < 1.05) return {};
    return detail::joined({"The shear stiffness 5/6 sum G h of a section is ", detail::text(ratio),
                           " times what its layers have together; give it EnergyShear{} instead."});
  }
};

/// K from the instantaneous moduli as layers yield or fail. The share of its elastic moduli that a layer has left is
/// d sigma : d eps / d eps : C : d eps of its last strains.
struct InstantaneousShear {
  double length = 0;    ///< as in EnergyShear
  double floor = 1e-3;  ///< least share of the elastic moduli
  double change = 0.1;  ///< largest relative change of K in a step

  void ranges(const auto& number) const {
    number("length", length, range::not_negative);
    number("floor", floor, Range{.low = 0, .high = 1, .without_high = false});
    number("change", change, Range{.low = 0, .high = 100});
  }

  template <class T>
  struct State {
    T shear_stiffness{};  ///< K as it stands [force/length]
  };
  template <class T>
  struct LayerState {
    T share{1.0};  ///< of its elastic moduli
  };

  double stiffness(const TransverseShear<double>& shear) const { return shear.stiffness; }
  std::string warning(const TransverseShear<double>& shear, double known_length) const {
    return EnergyShear{length}.warning(shear, known_length);
  }

  /// The share after a step in which the strains did `work`, and would have done `elastic_work` in elastic layers.
  template <class T>
  T share(const T& before, const T& work, const T& elastic_work) const {
    const auto strained = elastic_work > 0.0;
    return select(strained, max(T(floor), min(T(1.0), work / select(strained, elastic_work, T(1.0)))), before);
  }
  template <class T>
  T limited(const T& K_old, const T& K) const {
    return max(T(1.0 / (1.0 + change)) * K_old, min(T(1.0 + change) * K_old, K));
  }
};

}  // namespace strike
