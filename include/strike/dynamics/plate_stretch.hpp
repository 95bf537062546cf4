#pragma once
#include <algorithm>
#include <cstddef>
#include <string>

#include <Eigen/Core>

#include <strike/element/cell_shape.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The largest area over that at rest of the intact plates of a part whose thickness does not follow it; of other parts
/// 1.
template <class Part, class Nodes>
double largest_stretch(const Part& part, const Nodes& nodes) {
  using T = typename Part::Number;
  double largest = 1;
  using Positions = Eigen::Matrix<T, 3, static_cast<int>(Part::n)>;
  if constexpr (requires(const Positions x) { part.element().stretch(part.blocks().begin()->state, x); }) {
    for (std::size_t b = part.blocks().first(); b < part.blocks().last(); ++b) {
      const auto& block = part.blocks()[b];
      Positions x = Positions::Zero();
      for (std::size_t k = 0; k < Part::n; ++k)
        for (std::size_t l = 0; l < part.count(b); ++l) {
          const auto corner = nodes.x(nodes.number(block.nodes[k][l]));
          for (int axis = 0; axis < 3; ++axis)
            set_lane(x(axis, static_cast<int>(k)), l, static_cast<LaneOf<T>>(corner(axis)));
        }
      const T stretch = part.element().stretch(block.state, x);
      for (std::size_t l = 0; l < part.count(b); ++l) {
        bool counts = true;
        if constexpr (requires { block.removal.alive; }) counts = lane(block.removal.alive, l) > 0;
        if constexpr (requires { part.material().intact(block.state.material); })
          counts = counts && lane(part.material().intact(block.state.material), l) > 0;
        if (counts) largest = std::max(largest, static_cast<double>(lane(stretch, l)));
      }
    }
  }
  return part.deal().is_dealt() ? largest_of_ranks(part.ranks(), largest) : largest;
}

/// A sentence on plates that are 5 % larger than at rest, or more, and as thick as ever; empty: there are none.
template <class Part, class Nodes>
[[gnu::cold]] std::string stretch_warning(const Part& part, const Nodes& nodes) {
  const double largest = largest_stretch(part, nodes);
  if (!(largest > 1.05)) return {};
  return joined({"Plates of part ", std::to_string(part.number()), " have stretched to up to ", text(largest),
                 " times their area and keep their thickness: if they should thin, take ",
                 Part::n == 3 ? "Plate3{ThicknessChange{}}."
                              : "Plate4{PlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}}."});
}

}  // namespace strike::detail
