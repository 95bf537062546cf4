#include <string>

#include <strike/contact/contact.hpp>
#include <strike/contact/tied.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a Surface of a part that the scene does not have, or of other cells, is an error at the start") {
  Mesh mesh = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  const Cells<8> slab = mesh.hexahedra;
  append(mesh, box({.lower = {0, 0, 1}, .size = {1, 1, 1}, .cells = {1, 1, 1}}));
  const Cells<8> cube(mesh.hexahedra.begin() + 2, mesh.hexahedra.end());
  const auto above = nodes_where(mesh.nodes, on_plane(Axis::z, 2)), foot = std::vector<Index>{12};
  const Elastic stiff{.density = 1, .youngs_modulus = 1, .poissons_ratio = 0};
  const auto run = [&](auto contact) {
    Explicit{Scene{mesh.nodes, Part{Hex8{}, stiff, slab}, Part{Hex8{}, stiff, cube}, std::move(contact)}};
  };
  const std::string other_part = "strike: a Surface is of part 2, but the scene has 2 parts; count its parts from 0.",
                    other_cells =
                        "strike: a Surface of part 1 was made of 2 cells, but the part has 1; give it the "
                        "cells of the part and its place.";
  CHECK_THROWS_WITH(run(Contact{NodeToSurface{above, solid_surface(slab, 2)}}), other_part);
  CHECK_THROWS_WITH(run(Contact{TwoWay{solid_surface(cube, 1), solid_surface(slab, 1)}}), other_cells);
  CHECK_THROWS_WITH(run(Contact{SelfContact{solid_surface(slab, 1)}}), other_cells);
  CHECK_THROWS_WITH(run(Tied{foot, solid_surface(slab, 2)}), other_part);
  CHECK_NOTHROW(run(Contact{TwoWay{solid_surface(cube, 1), solid_surface(slab, 0)}}));
}
