#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <strike/dynamics/part_checks.hpp>
#include <strike/element/cell_shape.hpp>
#include <strike/mesh/check_cell.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The plates of a part whose thickness makes no sense beside their shortest edge; of other elements nothing.
/// Thicker than twice that edge: the mesh has waves shorter than the thickness, for the shortest spans two edges. There
/// modes across the thickness begin, which no plate has (Mindlin 1951). A warning alone: longer waves are right.
/// Thinner than 1e-4 of it: its stiffness in bending, (h/a)^2/12 of that in its plane, is below 1e-9.
template <class E, class M>
class PlateProportions {
 public:
  void add(const auto&...) {}
  std::string warning(std::size_t, std::size_t) const { return {}; }
};

template <class E, class M>
  requires requires(const M material) {
    requires HasCellShape<E>;
    requires E::shape == CellShape::quadrilateral || E::shape == CellShape::triangle;
    double{material.thickness()};
  }
class PlateProportions<E, M> {
 public:
  /// Plate e.
  template <class N, std::size_t n>
  void add(std::size_t e, const N& nodes, const std::array<Index, n>& cell, const M& section) {
    const CellCorners<n> x = corners_at(nodes, cell);
    double square = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i)
      if (const std::size_t next = (i + 1) % n; cell[i] != cell[next])
        square = std::min(square, (x[next] - x[i]).squaredNorm());
    const double edge = std::sqrt(square), thickness = section.thickness();
    if (thickness > 2 * edge) thick_.add(e, edge, thickness, edge < thick_.edge);
    if (thickness < 1e-4 * edge) thin_.add(e, edge, thickness, edge > thin_.edge);
  }

  /// Of a part with `plates`; empty: all make sense.
  [[gnu::cold]] std::string warning(std::size_t part, std::size_t plates) const {
    const auto told = [&](const Worst& some, const char* what, const char* advice) {
      if (some.count == 0) return std::string();
      return joined({std::to_string(some.count), " of ", std::to_string(plates), " plates of part ",
                     std::to_string(part), " are ", what, " their shortest edge, most of all element ",
                     std::to_string(some.element), " (thickness ", text(some.thickness), ", edge ", text(some.edge),
                     "): ", advice});
    };
    const std::string thick = told(thick_, "thicker than twice",
                                   "waves that short are beyond the theory of plates; take larger plates, or solids."),
                      thin = told(thin_, "thinner than 1e-4 of",
                                  "they do not bend; if that is not meant, look whether all lengths have one unit.");
    return thick + (thick.empty() || thin.empty() ? "" : " ") + thin;
  }

 private:
  struct Worst {
    double edge, thickness = 0;
    std::size_t element = 0, count = 0;

    void add(std::size_t e, double new_edge, double new_thickness, bool is_worse) {
      ++count;
      if (is_worse) element = e, edge = new_edge, thickness = new_thickness;
    }
  };
  Worst thick_{std::numeric_limits<double>::infinity()}, thin_{0};
};

}  // namespace strike::detail
