#include <string>
#include <vector>

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

TEST_CASE("inside a solid that never erodes no node is named, and what erodes on it uncovers its skin") {
  Mesh mesh = box({.size = {4, 4, 4}, .cells = {4, 4, 4}});
  const Cells<8> block = mesh.hexahedra;
  append(mesh, box({.lower = {1, 1, 4}, .size = {2, 2, 2}, .cells = {2, 2, 2}}));
  mesh = merge_coincident_nodes(mesh, 1e-9);
  const Cells<8> lump(mesh.hexahedra.begin() + 64, mesh.hexahedra.end());
  const auto faces_of = [](const Cells<8>& cells) {
    std::vector<Face> all;
    detail::append_faces(all, cells, detail::hexahedron_faces, 0);
    return all;
  };
  const std::vector<PartFaces> parts{{.cells = 64, .faces = faces_of(block)},
                                     {.cells = 8, .faces = faces_of(lump), .erodes = true}};
  Everything everything;
  everything.see(parts);
  CHECK(everything.numbers().size() == 125 - 27 + 27 - 9);
  Surface& surface = *everything.surface;
  CHECK(surface.faces().size() == 6 * 16 - 4 + 5 * 4);
  std::vector<bool> alive(8, true);
  alive[0] = false;  // on the block, at a corner
  CHECK(surface.remove(1, alive));
  CHECK(surface.faces().size() == 6 * 16 - 4 + 5 * 4 - 2 + 4);
  CHECK(surface.remove(1, std::vector<bool>(8, false)));
  CHECK(surface.faces().size() == 6 * 16);
}
