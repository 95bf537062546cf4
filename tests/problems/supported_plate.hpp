#pragma once
// The simply supported square plate of Belytschko, Lin and Tsay (1984) under a step of pressure [in, lbf, s], a quarter
// of it.
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/curve.hpp>
#include <strike/load/pressure.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "problems/plate_cells.hpp"

namespace strike::supported_plate {

/// How far the middle goes, and when.
struct Swing {
  double largest = 0, time = 0;
};

/// n elements along half an edge. A hard support lets no node turn across its edge.
enum class Edges { hard, soft };
template <class Element = Plate4<>>
Swing swing(Index n, double pressure, Edges edges = Edges::hard, const Element& element = {}) {
  constexpr double half = 5;
  const Mesh plate = testing::for_element<Element>(rectangle({.size = {half, half}, .cells = {n, n}}));
  const auto on = [&](Axis axis, double at) { return nodes_where(plate.nodes, on_plane(axis, at)); };
  const Homogeneous section{PlaneStress{Elastic{.density = 2.588e-4, .youngs_modulus = 1e7, .poissons_ratio = 0.3}},
                            0.5};
  using Axes = std::vector<Eigen::Vector3d>;
  const bool hard = edges == Edges::hard;
  Explicit run{Scene{plate.nodes, Part{element, section, testing::plate_cells<Element>(plate)},
                     Pressure{surface(plate), Constant{pressure}}, Symmetry{Axis::x, on(Axis::x, 0)},
                     Symmetry{Axis::y, on(Axis::y, 0)},
                     Support{on(Axis::x, half), {unit(Axis::z)}, hard ? Axes{unit(Axis::x)} : Axes{}},
                     Support{on(Axis::y, half), {unit(Axis::z)}, hard ? Axes{unit(Axis::y)} : Axes{}}}};
  Swing found;
  run.until(6e-4, [&] {
    if (const double w = -run.nodes().x(0).z(); w > found.largest) found = {w, run.time()};
  });
  return found;
}

}  // namespace strike::supported_plate
