// A program of a user, quick to compile.
#include <strike/material/elastic.hpp>
#include <strike/version.hpp>

int main(int, char** arguments) {
  const strike::Elastic steel{.density = 7.85e-6, .youngs_modulus = 210, .poissons_ratio = 0.3};
  return strike::Material<strike::Elastic> && steel.shear_modulus() > 80 && arguments ? 0 : 1;
}
