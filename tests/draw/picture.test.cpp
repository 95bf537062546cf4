#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <strike/draw/picture.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate3.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/remaining.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/triangulated.hpp>
#include <strike/section/layered.hpp>

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

namespace {

const ColourMap black_to_white{{0, 0, 0}, {1, 0, 0}, 0};

/// A square of 10 x 10 in the plane z = 0, which gives the picture its scale: seen from above, 52 px for 1.
const std::vector<Eigen::Vector3d> square{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
const std::vector<Face> square_face = quadrilateral_surface({{0, 1, 2, 3}});

/// Particles of unit volume, numbered as their places are.
Particles unit_particles(const std::vector<Eigen::Vector3d>& places) {
  Particles particles;
  for (Index i = 0; i < places.size(); ++i) particles.cells.push_back({i});
  particles.volumes.assign(places.size(), 1);
  return particles;
}

/// The text of an attribute of the k-th element with a tag.
std::string attribute(const std::string& svg, const std::string& tag, std::size_t k, const std::string& name) {
  std::size_t at = svg.find("<" + tag + " ");
  while (k-- > 0) at = svg.find("<" + tag + " ", at + 1);
  REQUIRE(at != std::string::npos);
  const std::string element = svg.substr(at, svg.find('>', at) - at);
  const std::size_t first = element.find(" " + name + "=\"") + name.size() + 3;
  return element.substr(first, element.find('"', first) - first);
}

}  // namespace

TEST_CASE("picture: a particle is a ball as wide as the cube root of its volume, in the scale of the picture") {
  const std::vector<Eigen::Vector3d> places{{0, 0, 1}, {2, -1, 1}, {0, 0, 3}};
  Particles particles = unit_particles(places);
  particles.volumes = {1, 8, 1};
  Picture picture{{.from = {0, 0, 1}, .up = {0, 1, 0}}};
  picture.add(square_face, square, {}, Sides::both);
  picture.add(particles, places);
  const std::string svg = picture.svg();
  CHECK(well_formed(svg));
  CHECK(count_of(svg, "<use ") == 3);
  CHECK(count_of(svg, "<g id=\"ball") == 2);  // one for each radius
  CHECK(count_of(svg, "<circle r=\"26\"") == 2);
  CHECK(count_of(svg, "<circle r=\"52\"") == 2);
  // By depth, the lower of equal ones first: the second and the third are 2 to the right and 1 below each other.
  CHECK(attribute(svg, "use", 1, "href") == "#ball5200");
  CHECK(std::stod(attribute(svg, "use", 1, "x")) - std::stod(attribute(svg, "use", 2, "x")) == Approx(2 * 52));
  CHECK(std::stod(attribute(svg, "use", 1, "y")) - std::stod(attribute(svg, "use", 2, "y")) == Approx(1 * 52));

  Picture alone{{}};  // all of the ball is in the picture
  const std::vector<Eigen::Vector3d> origin{{0, 0, 0}};
  alone.add(Particles{{{0}}, {7}}, origin);
  CHECK(count_of(alone.svg(), "<circle r=\"260\"") == 2);
}

TEST_CASE("picture: a ball in front of a face is seen and one behind it is hidden, also where it is slanting") {
  // The far edge of the square is farther away than its centre is; so is the ball in front of that edge.
  for (const Eigen::Vector3d& from : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 1), Eigen::Vector3d(-2, 1, .5)})
    for (const double turn : {1.0, -1.0})  // the eye above and below
      for (const double side : {1.0, -1.0})
        for (const Eigen::Vector3d& corner : square) {
          const std::vector<Eigen::Vector3d> place{0.9 * corner + side * from};
          Picture picture{{.from = turn * from}};
          picture.add(unit_particles(place), place);
          picture.add(square_face, square, {}, Sides::both);
          const std::string svg = picture.svg();
          CHECK((svg.find("<use ") > svg.find("<path ")) == (turn * side > 0));
        }
}

TEST_CASE("picture: balls and nodes without elements inside a box are hidden, and those before its faces are seen") {
  const Mesh mesh = box({.size = {2, 2, 2}});
  const Eigen::Vector3d from{1, 1.2, 0.8};  // by their centres the upper face is the farthest, then those of x and of y
  struct Case {
    Eigen::Vector3d place;
    std::size_t faces;  // drawn before it
  };
  // All are farther from the eye than the centre of each face.
  for (const auto& [place, faces] :
       {Case{{1, 1, 1}, 0}, Case{{0.3, 0.3, 2.6}, 1}, Case{{2.6, 0.3, 0.3}, 2}, Case{{0.3, 2.6, 0.3}, 3}}) {
    REQUIRE(place.dot(from) < Eigen::Vector3d(1, 1, 2).dot(from));
    const std::vector<Eigen::Vector3d> places{place};
    Picture picture{{.from = from}};
    picture.add(surface(mesh), mesh.nodes);
    picture.add(unit_particles(places), places), picture.add_particles(places);
    const std::string svg = picture.svg();
    CHECK(count_of(svg.substr(0, svg.find("<use ")), "<path ") == faces);
    CHECK(count_of(svg.substr(0, svg.find("<circle cx")), "<path ") == faces);
  }
}

TEST_CASE("picture: balls have the colours of their values, on one legend with the faces") {
  const std::vector<Eigen::Vector3d> places{{0, 0, 1}, {1, 0, 2}, {2, 0, 3}, {2, 0, 4}};
  Picture picture{{.from = {0, 0, 1}, .colours = black_to_white}};
  picture.add(square_face, square, std::vector<double>{2}, Sides::both);
  picture.add(unit_particles(places), places, std::vector<double>{4, 3, 2, std::numeric_limits<double>::quiet_NaN()});
  const std::string svg = picture.svg();
  CHECK(well_formed(svg));
  CHECK(attribute(svg, "path", 0, "fill") == "#000000");
  CHECK(attribute(svg, "use", 0, "fill") == "#ffffff");
  CHECK(attribute(svg, "use", 1, "fill") == black_to_white(0.5).hex());
  CHECK(attribute(svg, "use", 2, "fill") == "#000000");
  CHECK(attribute(svg, "use", 3, "fill") == black_to_white(std::numeric_limits<double>::quiet_NaN()).hex());
  CHECK(count_of(svg, "<linearGradient") == 1);

  Picture plain{{.from = {0, 0, 1}}};  // without values there is no legend
  plain.add(unit_particles(places), places);
  CHECK(count_of(plain.svg(), "<linearGradient") == 0);
}

TEST_CASE("picture: deleted particles are not drawn, and the colours of the others stay theirs") {
  Mesh mesh{.nodes = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}};
  mesh.particles = unit_particles(mesh.nodes);
  const std::vector<bool> alive{true, false, true};
  Picture picture{{.from = {0, -1, 0}, .low = 0, .high = 2, .colours = black_to_white}};
  picture.add(remaining(mesh, alive).particles, mesh.nodes, remaining(std::vector<double>{0, 1, 2}, alive));
  const std::string svg = picture.svg();
  CHECK(count_of(svg, "<use ") == 2);
  const bool first_is_left = std::stod(attribute(svg, "use", 0, "x")) < std::stod(attribute(svg, "use", 1, "x"));
  CHECK(attribute(svg, "use", first_is_left ? 0 : 1, "fill") == "#000000");
  CHECK(attribute(svg, "use", first_is_left ? 1 : 0, "fill") == "#ffffff");
}

TEST_CASE("picture: balls are mirrored with the rest") {
  const std::vector<Eigen::Vector3d> quarter{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}};
  std::vector<Eigen::Vector3d> whole;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const Eigen::Vector3d& place : quarter) whole.emplace_back(x * place[0], y * place[1], place[2]);
  Picture mirrored{{.mirror = {Axis::x, Axis::y}}}, direct{{}};
  mirrored.add(unit_particles(quarter), quarter, std::vector<double>{1, 2, 3});
  direct.add(unit_particles(whole), whole, std::vector<double>{1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3});
  const auto uses = [](const std::string& svg) {
    std::vector<std::array<std::string, 4>> all;
    for (std::size_t k = 0; k < count_of(svg, "<use "); ++k)
      all.push_back({attribute(svg, "use", k, "x"), attribute(svg, "use", k, "y"), attribute(svg, "use", k, "fill"),
                     attribute(svg, "use", k, "href")});
    return all;
  };
  CHECK(uses(mirrored.svg()).size() == 12);
  auto of_mirrored = uses(mirrored.svg()), of_direct = uses(direct.svg());
  std::sort(of_mirrored.begin(), of_mirrored.end()), std::sort(of_direct.begin(), of_direct.end());
  CHECK(of_mirrored == of_direct);
}

TEST_CASE("picture: 2688 particles take less than 200 KiB") {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 2688; ++i) places.emplace_back(i % 14, i / 14 % 12, i / 168);
  std::vector<double> values;
  for (int i = 0; i < 2688; ++i) values.push_back(i);
  Picture picture{{}};
  picture.add(unit_particles(places), places, values);
  const std::string svg = picture.svg();
  CHECK(count_of(svg, "<use ") == 2688);
  CHECK(svg.size() < 200 * 1024);  // 70 bytes for each ball
}

TEST_CASE("picture: particles without a node, a volume or a value are errors") {
  const std::vector<Eigen::Vector3d> places{{0, 0, 0}, {1, 0, 0}};
  Picture picture{{}};
  CHECK_THROWS_WITH(picture.add(unit_particles(places), places, std::vector<double>{1}),
                    "strike: there are 1 values of 2 particles: give one value for each particle.");
  CHECK_THROWS_WITH(picture.add(Particles{{{0}, {1}}, {1}}, places),
                    "strike: a mesh has 2 particles, but 1 volumes of particles; give one for each.");
  CHECK_THROWS_AS(picture.add(Particles{{{0}, {1}}, {1, 0}}, places), Error);
  CHECK_THROWS_AS(picture.add(Particles{{{0}, {2}}, {1, 1}}, places), Error);
  CHECK_THROWS_AS(picture.svg(), Error);  // nothing of them is there
}

TEST_CASE("picture: triangles of a running scene, at their places and in the colours of their field") {
  const Mesh mesh = triangulated(rectangle({.size = {2, 1}, .cells = {2, 1}}));  // four triangles in the plane z = 0
  const Homogeneous section{PlaneStress{Elastic{.density = 1, .youngs_modulus = 1, .poissons_ratio = 0}}, 0.1};
  Explicit run{
      Scene{mesh.nodes, Part{Plate3{}, section, mesh.triangles}, InitialVelocity{{1, 0, 0}, all_nodes(mesh.nodes)}}};
  const auto drawn = [&] {
    Picture picture{{.from = {0, 0, 1}, .low = 0, .high = 4, .colours = {{1, 0, 0}, {0, 0, 0}, 0}}};
    picture.add(surface(mesh), run.positions(), std::vector<double>{0, 1, 2, 3});
    return picture.svg();
  };
  const std::string before = drawn();
  run.until(3);  // it flies without strain, so the picture is the same about its middle
  CHECK(run.positions()[0].x() == Approx(mesh.nodes[0].x() + 3).epsilon(1e-12));
  const std::string after = drawn();
  CHECK(well_formed(after));
  CHECK(count_of(after, "<path") == 4);
  std::set<std::string> colours;
  for (std::size_t at = after.find("<path fill="); at != std::string::npos; at = after.find("<path fill=", at + 1)) {
    colours.insert(after.substr(at + 12, 7));
    const std::string outline = after.substr(at, after.find("\"/>", at) - at);
    CHECK(std::count(outline.begin() + 20, outline.end(), 'l') == 2);  // from the first corner to two others
    CHECK(outline.back() == 'z');
  }
  CHECK(colours.size() == 4);
  CHECK(count_of(before, "<path") == 4);
}
