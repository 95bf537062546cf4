#pragma once
#include <array>
#include <numbers>
#include <vector>

#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>
#include <strike/verify/laminate.hpp>

namespace strike::testing {

using namespace strike::verify;

/// Two faces and a core whose modulus is a share of theirs, as a strip under half a wave; mm, MPa, t.
struct Sandwich {
  const char* name;
  std::array<double, 3> thickness;
  double youngs_modulus, face_ratio, core_ratio, length, face_density = 0, core_density = 0;

  double p() const { return std::numbers::pi / length; }
  Laminate laminate(double softness) const {
    const auto& [bottom, core, top] = thickness;
    return Laminate({{bottom, youngs_modulus, face_ratio, face_density},
                     {core, youngs_modulus / softness, core_ratio, core_density},
                     {top, youngs_modulus, face_ratio, face_density}});
  }
  template <class... Options>
  auto section(double softness, const Options&... options) const {
    const auto layer = [](double h, double E, double nu, double rho) {
      return Layer{PlaneStress{Elastic{rho, E, nu}}, h};
    };
    const auto& [bottom, core, top] = thickness;
    return Layered{layer(bottom, youngs_modulus, face_ratio, face_density),
                   layer(core, youngs_modulus / softness, core_ratio, core_density),
                   layer(top, youngs_modulus, face_ratio, face_density), options...};
  }
};

inline const Sandwich glass{"A", {3, .76, 3}, 70000, .22, .45, 300, 2500e-12, 1070e-12};
inline const Sandwich acrylic{"B", {3.2, 1.3, 12.7}, 2400, .35, .45, 300};
inline const Sandwich thin_faces{"C", {1, 10, 1}, 70000, .3, .3, 300};
inline const Sandwich thick{"D", {1, 1, 1}, 70000, .3, .3, 30, 2700e-12, 2700e-12};

/// A row of reference values of such strips, by an independent code: the exact deflection of the middle surface under
/// sin px, what it is of Kirchhoff's, and that of plates with K and with 5/6 sum G h in its units.
struct SandwichRow {
  const Sandwich& strip;
  double softness, deflection, by_kirchhoff, fsdt, five_sixths, error, shear_stiffness;
};
inline const std::vector<SandwichRow> sandwiches{{glass, 1, 43.95408, 1.0012, 1.0001, 1.0001, 2e-8, 1.5545e5},
                                                 {glass, 1e2, 45.38706, 1.0321, 1.0003, .9703, 2e-4, 6389.97},
                                                 {glass, 1e3, 56.97097, 1.2956, 1.0153, .7730, .0152, 657.657},
                                                 {glass, 1e4, 126.9247, 2.886, 1.4357, .3470, .4358, 65.9583},
                                                 {glass, 1e5, 224.2253, 5.099, 6.360, .1964, 5.361, 6.59776},
                                                 {glass, 1e6, 248.1864, 5.644, 55.86, .1774, 54.87, .659796},
                                                 {acrylic, 1e2, 82.98741, 1.0714, 1.0040, .9427, .0032, 1555.36},
                                                 {acrylic, 1e3, 112.1400, 1.4465, 1.1616, .6983, .1623, 172.938},
                                                 {acrylic, 1e4, 160.6020, 2.0714, 3.729, .4876, 2.743, 17.4894},
                                                 {thin_faces, 1e2, 20.36281, 1.158, 1.0004, .8727, 6e-5, 3264.18},
                                                 {thin_faces, 1e3, 45.51180, 2.558, 1.0029, .3954, .0026, 327.451},
                                                 {thin_faces, 1e4, 284.6661, 15.98, 1.0406, .0633, .0404, 32.7555},
                                                 {thin_faces, 1e5, 1963.520, 110.2, 1.4269, .0092, .4265, 3.27565},
                                                 {thick, 1, .04924540, 1.025, 1.0031, 1.0031, 2e-5, 67307.7},
                                                 {thick, 1e2, .1147519, 2.301, 1.0693, .4522, .0679, 1252.13}};

}  // namespace strike::testing
