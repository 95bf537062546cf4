#pragma once
// Carbon fibres in epoxy [mm, t, s, MPa], and lay-ups.
#include <vector>

#include <strike/material/failing_ply.hpp>
#include <strike/material/orthotropic_ply.hpp>
#include <strike/section/layered.hpp>

namespace strike::testing {

inline constexpr OrthotropicPly carbon{
    .density = 1.6e-9, .E1 = 140e3, .E2 = 9e3, .nu12 = 0.3, .G12 = 5e3, .G13 = 5e3, .G23 = 3e3};
inline constexpr Hashin carbon_hashin{.Xt = 2000, .Xc = 1200, .Yt = 50, .Yc = 200, .SL = 90, .ST = 70};
inline constexpr MaximumStress carbon_maximum{.Xt = 2000, .Xc = 1200, .Yt = 50, .Yc = 200, .S = 90};
inline constexpr ChangChang carbon_chang{.Xt = 2000, .Xc = 1200, .Yt = 50, .Yc = 200, .S = 90};

/// Plies with the ratios of Pagano (1970) and of most tables since: E2 = 1.
inline constexpr OrthotropicPly pagano_ply{
    .density = 1, .E1 = 25, .E2 = 1, .nu12 = 0.25, .G12 = 0.5, .G13 = 0.5, .G23 = 0.2, .nu23 = 0.25};

/// Lay-ups of four plies: unidirectional, cross-ply and angle-ply, symmetric and not, and without any order.
inline const std::vector<std::vector<double>> four_plies{{0, 0, 0, 0},       {0, 90, 90, 0},     {0, 90, 0, 90},
                                                         {45, -45, -45, 45}, {30, -30, 30, -30}, {0, 45, -45, 90},
                                                         {10, 70, -20, 35}};
template <class M>
auto of_four(const M& ply, double h, const std::vector<double>& angles, const Eigen::Vector3d& along = {1, 0, 0}) {
  return Layered{LayUp{ply, h, {angles[0], angles[1], angles[2], angles[3]}}, FibreDirection{along}};
}

}  // namespace strike::testing
