#pragma once
#include <array>
#include <cstddef>

#include <Eigen/Core>

#include <strike/mesh/box.hpp>

// The scene whose step is measured.
namespace bench {

/// Cubes of a millimetre.
inline strike::Mesh bar(const std::array<strike::Index, 3>& cells) {
  const double h = 1e-3;
  return strike::box({.size = {h * cells[0], h * cells[1], h * cells[2]}, .cells = cells});
}

/// Begins as a bar that is squeezed and swells, so that every element yields.
struct Squeeze {
  double rate = 5e3;  ///< [1/s]

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes.set_velocity(i, rate * nodes.x(i).cwiseProduct(Eigen::Vector3d(.5, .5, -1)));
  }
};

}  // namespace bench
