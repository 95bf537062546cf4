#pragma once
// The one-point hexahedron by the nodal formulas of Flanagan and Belytschko (1981), against which its modes are
// checked.
#include <Eigen/Dense>

namespace nodal_hex8 {

using Nodes = Eigen::Matrix<double, 3, 8>;
using Patterns = Eigen::Matrix<double, 4, 8>;

/// B_iI = dV/dx_iI: node 0, and the others by permutation.
inline Nodes gradient(const Nodes& X) {
  constexpr int order[8][8] = {{0, 1, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 0, 5, 6, 7, 4}, {2, 3, 0, 1, 6, 7, 4, 5},
                               {3, 0, 1, 2, 7, 4, 5, 6}, {4, 7, 6, 5, 0, 3, 2, 1}, {5, 4, 7, 6, 1, 0, 3, 2},
                               {6, 5, 4, 7, 2, 1, 0, 3}, {7, 6, 5, 4, 3, 2, 1, 0}};
  Nodes B;
  for (int I = 0; I < 8; ++I)
    for (int i = 0; i < 3; ++i) {
      const auto y = [&](int k) { return X((i + 1) % 3, order[I][k]); };
      const auto z = [&](int k) { return X((i + 2) % 3, order[I][k]); };
      B(i, I) =
          (y(1) * ((z(5) - z(2)) - (z(3) - z(4))) + y(2) * (z(1) - z(3)) + y(3) * ((z(2) - z(7)) - (z(4) - z(1))) +
           y(4) * ((z(7) - z(5)) - (z(1) - z(3))) + y(5) * (z(4) - z(1)) + y(7) * (z(3) - z(4))) /
          12;
    }
  return B;
}

inline double volume(const Nodes& x) { return gradient(x).row(0).dot(x.row(0)); }

/// Gamma_aI, the hourglass base vectors.
inline Patterns patterns() {
  Patterns gamma;
  gamma << 1, 1, -1, -1, -1, -1, 1, 1,  //
      1, -1, -1, 1, -1, 1, 1, -1,       //
      1, -1, 1, -1, 1, -1, 1, -1,       //
      -1, 1, -1, 1, 1, -1, 1, -1;
  return gamma;
}

/// gamma_aI = Gamma_aI - (Gamma_aJ x_jJ) B_jI/V, the hourglass shape vectors.
inline Patterns hourglass_vectors(const Nodes& x) {
  return patterns() - (patterns() * x.transpose()) * gradient(x) / volume(x);
}

}  // namespace nodal_hex8
