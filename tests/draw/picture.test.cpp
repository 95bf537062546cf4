#include <limits>

#include <strike/draw/picture.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/cylinder.hpp>

#include "drawing.hpp"
#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("picture: the faces toward the eye, each once") {
  const Mesh mesh = box({.size = {2, 3, 4}, .cells = {2, 3, 4}});
  Picture corner{{.from = {1, 1, 1}}};
  corner.add(surface(mesh), mesh.nodes);
  CHECK(well_formed(corner.svg()));
  CHECK(count_of(corner.svg(), "<path") == 2 * 3 + 3 * 4 + 4 * 2);
  Picture above{{.from = {0, 0, 1}}};  // along the upward direction
  above.add(surface(mesh), mesh.nodes);
  CHECK(count_of(above.svg(), "<path") == 2 * 3);
}

TEST_CASE("picture: a quadrilateral is seen from behind only if both sides are asked for") {
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Face> faces = quadrilateral_surface({{0, 1, 2, 3}});
  Picture behind{{.from = {0, 0, -1}}};
  behind.add(faces, nodes);
  CHECK_THROWS_WITH(behind.svg(), "strike: the Picture '' shows no face: add a surface first.");
  behind.add(faces, nodes, {}, Sides::both);
  CHECK(count_of(behind.svg(), "<path") == 1);
}

TEST_CASE("picture: a mirrored quarter shows the faces of the whole") {
  const CylinderShape quarter{.radius = 3, .length = 10, .cells = 3, .layers = 5};
  CylinderShape full = quarter;
  full.sector = Sector::full;
  const Mesh part = cylinder(quarter), whole = cylinder(full);
  Picture mirrored{{.from = {2, -3, 1}, .mirror = {Axis::x, Axis::y}}}, direct{{.from = {2, -3, 1}}};
  mirrored.add(surface(part), part.nodes);
  direct.add(surface(whole), whole.nodes);
  CHECK(count_of(mirrored.svg(), "<path") == count_of(direct.svg(), "<path"));
}

TEST_CASE("picture: what is nearer is drawn later") {
  Picture picture{{.from = {0, 0, 1}, .low = 0, .high = 1, .colours = {{1, 0, 0}, {0, 0, 0}, 0}}};
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
                                           {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  picture.add(quadrilateral_surface({{0, 1, 2, 3}, {4, 5, 6, 7}}), nodes,
              std::vector<double>{0, 1});  // white above black
  const std::string svg = picture.svg();
  const std::size_t black = svg.find("<path fill=\"#0"), white = svg.find("<path fill=\"#", black + 1);
  REQUIRE(black != std::string::npos);
  CHECK(white > black);
}

TEST_CASE("picture: the legend spans the values, or what was asked for, and shows round marks") {
  const Mesh mesh = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  Picture picture{{.title = "A & B", .quantity = "strain", .unit = "%"}};
  picture.add(surface(mesh), mesh.nodes, std::vector<double>{0.3, 2.9});
  const std::string svg = picture.svg();
  CHECK(well_formed(svg));
  CHECK(svg.find(">A &amp; B<") != std::string::npos);
  CHECK(svg.find(">strain [%]<") != std::string::npos);
  for (const char* mark : {">0.5<", ">1.0<", ">1.5<", ">2.0<", ">2.5<"}) CHECK(svg.find(mark) != std::string::npos);
  CHECK(svg.find(">3.0<") == std::string::npos);

  Picture equal{{}};
  equal.add(surface(mesh), mesh.nodes, std::vector<double>{0, 0});  // no range at all
  CHECK(well_formed(equal.svg()));
  Picture broken{{}};
  broken.add(surface(mesh), mesh.nodes, std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()});
  CHECK(well_formed(broken.svg()));
}

TEST_CASE("picture: the whole Taylor bar of 1350 hexahedra takes less than 100 KiB, with marks and a scale") {
  const ScratchFolder folder("picture");
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});
  std::vector<double> height;
  for (const auto& cell : bar.hexahedra) height.push_back(centroid<8>(bar.nodes, cell)[2]);
  Picture picture{{.title = "Bar",
                   .caption = "A caption of some length that has to be broken into several lines below the picture.",
                   .quantity = "height",
                   .unit = "mm",
                   .mirror = {Axis::x, Axis::y},
                   .length_unit = "mm"}};
  picture.add(surface(bar), bar.nodes, height);
  picture.mark({0, -3.2, 0}, "foot");
  picture.write(folder / "bar.svg");
  const std::string svg = content_of(folder / "bar.svg");
  CHECK(well_formed(svg));
  CHECK(svg.size() < 100 * 1024);
  CHECK(svg.find(">foot<") != std::string::npos);
  CHECK(svg.find(">2 mm<") != std::string::npos);
}

TEST_CASE("picture: values and positions that do not fit are errors") {
  const Mesh mesh = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  Picture picture{{}};
  CHECK_THROWS_WITH(picture.add(surface(mesh), mesh.nodes, std::vector<double>{1}),
                    "strike: cell 1 has no value among 1: give one value for each cell.");
  CHECK_THROWS_WITH(picture.add(surface(mesh), std::span(mesh.nodes).first(4)),
                    "strike: a face of cell 0 names a node beyond the 4 positions: give the positions of all nodes.");
}
