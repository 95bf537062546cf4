// A program of a user, quick to compile.
#include <strike/material/elastic.hpp>
#include <strike/version.hpp>

/// Functions that Eigen declares in one of its headers and defines in another link.
template <class T>
bool is_right_handed(const T& one) {
  const Eigen::Matrix<T, 3, 1> x{one, T(0), T(0)}, y{T(0), one, T(0)}, z = x.cross(y);
  Eigen::Matrix<T, 3, 3> A;
  A << x, y, z;
  using strike::all;
  return all(A.determinant() == one && (A.inverse() * z).norm() == one && (A.transpose() * z).dot(z) == one);
}

int main(int, char** arguments) {
  if (!is_right_handed(strike::Pack<double>(1)) || !is_right_handed(strike::Dual<double, 2>(1))) return 1;
  const strike::Elastic steel{.density = 7.85e-6, .youngs_modulus = 210, .poissons_ratio = 0.3};
  return strike::Material<strike::Elastic> && steel.shear_modulus() > 80 && arguments ? 0 : 1;
}
