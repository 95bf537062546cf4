#pragma once
#include <cstddef>
#include <vector>

#include <strike/mesh/surface.hpp>

namespace strike {

/// The cells of a part of a scene, as far as its other items may know them.
struct PartFaces {
  std::size_t cells = 0;  ///< their number
  std::vector<Face>
      faces{};           ///< of all cells, inner ones too; a plate is one; none of cells that are no solids or plates
  double thickness = 0;  ///< of plates at the start, 0 of solids, of particles their spacing [length]
  double wave_modulus = 0;         ///< rho c^2 of the material at rest [stress], of plates times their thickness
  double offset = 0;               ///< of a plate's middle from its nodes, to the side that its faces look to [length]
  bool erodes = false;             ///< its cells may be deleted
  std::vector<Index> particles{};  ///< the nodes of a part of particles
};

}  // namespace strike
