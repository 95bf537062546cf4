#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <strike/material/kinematics.hpp>
#include <strike/material/plane_stiffness.hpp>
#include <strike/section/transverse_shear.hpp>

// Integrals over the thickness of a section, as functions of numbers.
namespace strike::detail {

/// The turn of a layer's own axes from those of its section.
template <bool has_fibres>
struct MeasuredFibres {};
template <>
struct MeasuredFibres<true> {
  PlaneTurn<double> turn;
};

/// A layer of a section as measured at its construction: heights of its n points over the surface of the nodes
/// [length], their weights [length], its elastic moduli and its shear flow.
template <std::size_t n, class Flow, bool has_fibres>
struct MeasuredLayer : MeasuredFibres<has_fibres> {
  std::array<double, n> z, weight;
  ShearLayer<double> elastic;
  Flow flow;

  /// Places the points of a rule in a layer of the thickness h with its middle at z_middle.
  template <class Rule>
  void place(double z_middle, double h) {
    for (std::size_t p = 0; p < n; ++p) {
      z[p] = z_middle + 0.5 * h * Rule::points[p];
      weight[p] = 0.5 * h * Rule::weights[p];
    }
  }
};

/// int (1, z, z^2) of the elastic moduli and of the density over the thickness.
struct SectionIntegrals {
  PlaneModuli<double> extension{}, coupling{}, bending{};
  double mass = 0, rotary_inertia = 0;  ///< per area

  /// Adds a layer of the thickness h with its middle at z.
  void add(double h, double z, const PlaneModuli<double>& moduli, double density) {
    const double z2 = z * z + h * h / 12;
    const auto integrate = [&](PlaneModuli<double>& sum, double weight) {
      sum.normal += weight * moduli.normal, sum.shear += weight * moduli.shear;
    };
    integrate(extension, h), integrate(coupling, h * z), integrate(bending, h * z2);
    mass += h * density, rotary_inertia += h * z2 * density;
  }

  /// The bounds of the tangent at the relative thickness t with the transverse shear stiffness K.
  template <class T>
  PlateKinematics::Moduli<T> moduli(const T& t, const T& K) const {
    const auto scaled = [](const T& c, const PlaneModuli<double>& m) -> PlaneModuli<T> {
      return {c * T(m.normal), c * T(m.shear)};
    };
    return {scaled(t, extension), scaled(t * t, coupling), scaled(t * t * t, bending), t * K};
  }
};

/// int sigma (1, z) dz in the reference thickness, and the sum of d_zz.
template <class T>
struct Resultants {
  PlaneTensor<T> force{}, moment{};
  T normal_rate = T(0.0);

  void add(const T& z, const T& weight, const PlaneTensor<T>& sigma) {
    const PlaneTensor<T> share = weight * sigma;
    force += share, moment += z * share;
  }
  /// The resultants in the present thickness; `stretch` is h/h0.
  PlateKinematics::Stress<T> stress(const T& stretch, const Vector2<T>& shear, double per_thickness) const {
    return {stretch * force, (stretch * stretch) * moment, shear, per_thickness * normal_rate};
  }
};

/// Work of the strains of a layer in a step, with its stress and with its elastic moduli.
template <class T>
struct LayerWork {
  T work = T(0.0), elastic = T(0.0);

  /// Adds a point that was strained by e while its stress changed by `change`.
  void add(const T& weight, const PlaneTensor<T>& e, const PlaneTensor<T>& change, const PlaneModuli<double>& moduli) {
    const double Q = moduli.normal, G = moduli.shear;
    work += weight * double_dot(change, e);
    elastic += weight * ((Q - 2 * G) * (trace(e) * trace(e)) + (2 * G) * double_dot(e, e));
  }
};

/// The shear flow of every layer, bottom to top, as the policy has it.
template <class Policy, class Layers>
std::vector<ShearFlow<double>> shear_flows(const Policy& policy, const TransverseShear<double>& shear,
                                           const Layers& each_layer) {
  std::vector<ShearFlow<double>> flows;
  each_shear_flow(shear, each_layer, [&](const ShearLayer<double>& layer, const ShearFlow<double>& flow) {
    if constexpr (requires { policy.flow(shear, layer, flow); })
      flows.push_back(policy.flow(shear, layer, flow));
    else
      flows.push_back(flow);
  });
  return flows;
}

}  // namespace strike::detail
