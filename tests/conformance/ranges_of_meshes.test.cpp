// Wrong numbers of meshes and of what chooses in them, of pictures and charts, and of tables.
#include <cmath>
#include <string>
#include <vector>

#include <strike/draw.hpp>
#include <strike/mesh.hpp>
#include <strike/output/results.hpp>

#include "conformance/numbers.hpp"

using namespace strike;

namespace {

using Numbers = std::vector<double>;

const Mesh block = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
const Mesh square = rectangle({.size = {1, 1}, .cells = {2, 2}});

bool is_sound(const Mesh& mesh) {
  check(mesh);
  return extent(mesh.nodes) > 0 && std::isfinite(extent(mesh.nodes)) && mesh.nodes.size() < 10000;
}
Index count(double x) { return static_cast<Index>(x); }

/// No number in the text of a picture is infinite or NaN.
bool is_drawn(const std::string& svg) {
  return svg.find("nan") == svg.npos && svg.find("inf") == svg.npos && svg.find("e+") == svg.npos;
}

}  // namespace

TEST_CASE("conformance: wrong numbers of meshes are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& shape, Mesh (*mesh)(const std::decay_t<decltype(shape)>&)) {
    testing::refuses_wrong_numbers(shape, tried, [&](const auto& changed) { return is_sound(mesh(changed)); });
  };
  refuses(BoxShape{.lower = {1, 2, 3}, .size = {1, 2, 3}, .cells = {1, 2, 3}, .grading = {1, 2, 3}}, box);
  refuses(CylinderShape{.radius = 1, .length = 2, .cells = 2, .layers = 3, .grading = 2}, cylinder);
  refuses(SphereShape{.radius = 1, .cells = 2}, sphere);
  refuses(DiscShape{.radius = 1, .cells = 2}, disc);
  for (const BirdForm form : {BirdForm::cylinder, BirdForm::hemispherical_ends, BirdForm::ellipsoid})
    refuses(BirdShape{.mass = 1.8, .density = 950, .form = form, .cells = 2, .layers = 3}, bird);
  refuses(RectangleShape{.lower = {1, 2, 3}, .size = {1, 2}, .cells = {1, 2}}, rectangle);
  refuses(PanelShape{.radius = 1, .length = 2, .arc = {.1, .7}, .cells = {1, 2}}, panel);
  refuses(CanopyShape{.length = 80, .top = 50, .height = {5, 20, 15}, .half_width = {10, 20, 18}, .cells = {2, 3}},
          canopy);

  // Of a body in particles; its cells and layers have no say.
  refuses(BoxShape{.lower = {1, 2, 3}, .size = {1, 2, 3}, .cells = {1, 2, 3}}, particles);
  testing::refuses_wrong_numbers(BirdShape{.mass = 1.8, .density = 950}, tried,
                                 [](const auto& shape) { return is_sound(particles(shape, 4)); });

  const auto refuses_in = [&](const char* of, const std::vector<testing::Argument>& arguments, const auto& use) {
    testing::refuses_wrong_arguments(of, arguments, tried, use);
  };
  refuses_in("graded", {{"lower", 1}, {"upper", 3}, {"grading", 2}},
             [](const Numbers& x) { return std::isfinite(graded(x[0], x[1], 3, x[2])[1]); });
  refuses_in("translated", {{"displacement", 3}}, [](const Numbers& x) {
    return is_sound(translated(block, {x[0], 0, 0}));
  });
  refuses_in("rotated", {{"axis", 3}, {"angle", 2}}, [](const Numbers& x) {
    return is_sound(rotated(block, {0, x[0], 0}, x[1]));
  });
  refuses_in("scaled", {{"factor", 3}}, [](const Numbers& x) { return is_sound(scaled(block, {1, x[0], 1})); });
  refuses_in("mirrored", {{"normal", 3}}, [](const Numbers& x) { return is_sound(mirrored(block, {0, x[0], 0})); });
  refuses_in("merge_coincident_nodes", {{"tolerance", 1e-6}},
             [](const Numbers& x) { return is_sound(merge_coincident_nodes(block, x[0])); });
  refuses_in("extruded", {{"levels", -1}, {"levels", 1}, {"levels", 3}},
             [](const Numbers& x) { return is_sound(extruded(square, x)); });
  refuses_in("particles", {{"spacing", .25}}, [](const Numbers& x) { return is_sound(particles(block, x[0])); });
  refuses_in("nearest_node", {{"place", 1}}, [](const Numbers& x) {
    return nearest_node(block.nodes, {x[0], 0, 0}) == (x[0] > .5 ? 2 : 0);
  });
  // No predicate chooses other nodes than those that are there.
  const auto refuses_choice = [&](const char* of, const std::vector<testing::Argument>& arguments, const auto& choose) {
    refuses_in(of, arguments, [&](const Numbers& x) {
      const auto chosen = nodes_where(block.nodes, choose(x));
      return chosen.size() <= block.nodes.size();
    });
  };
  refuses_choice("on_plane", {{"normal", 3}, {"offset", 1}, {"tolerance", 1e-6}}, [](const Numbers& x) {
    return on_plane({0, 0, x[0]}, x[1], x[2]);
  });
  refuses_choice("on_cylinder", {{"centre", .5}, {"axis", 1}, {"radius", 1}, {"tolerance", 1e-6}},
                 [](const Numbers& x) {
                   return on_cylinder({x[0], 0, 0}, {0, 0, x[1]}, x[2], x[3]);
                 });
  refuses_choice("in_box", {{"lower", -1}, {"upper", .5}, {"tolerance", 1e-6}}, [](const Numbers& x) {
    return in_box({x[0], -1, -1}, {x[1], 2, 2}, x[2]);
  });
  refuses_choice("in_sphere", {{"centre", .5}, {"radius", 1}, {"tolerance", 1e-6}}, [](const Numbers& x) {
    return in_sphere({x[0], 0, 0}, x[1], x[2]);
  });
  tried.print("meshes");
}

TEST_CASE("a mesh of more nodes than there are numbers is refused, and so are cells without end") {
  const Index many = 2000000000;
  CHECK_THROWS_WITH(box({.size = {1, 1, 1}, .cells = {many, 1, 1}}),
                    "strike: the cells of a box have 8e+09 nodes; a mesh holds fewer than 2^32, so give fewer cells.");
  CHECK_THROWS_AS(cylinder({.radius = 1, .length = 1, .cells = 10000, .layers = 10000}), Error);
  CHECK_THROWS_AS(sphere({.radius = 1, .cells = many}), Error);
  CHECK_THROWS_AS(disc({.radius = 1, .cells = many}), Error);
  CHECK_THROWS_AS(rectangle({.size = {1, 1}, .cells = {many, 2}}), Error);
  CHECK_THROWS_AS(bird({.mass = 1, .density = 1, .form = BirdForm::ellipsoid, .cells = many}), Error);
  CHECK_THROWS_WITH(graded(0, 1, count(-1.0 + 4294967296.0)),
                    "strike: the cells of graded is 4.29497e+09; it must be at least 1 and at most 2.14748e+09.");
}

TEST_CASE("conformance: wrong numbers of pictures, charts and tables are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& options, const auto& use) {
    testing::refuses_wrong_numbers(options, tried, use);
  };
  const std::vector<double> values(8, 2.0), x{1, 2, 3}, y{2, 30, 500};
  refuses(PictureOptions{.quantity = "strain", .low = 1, .high = 5, .length_unit = "m"},
          [&](const PictureOptions& options) {
            Picture picture{options};
            picture.add(surface(block), block.nodes, values);
            return is_drawn(picture.svg());
          });
  refuses(colour_maps::ember, [&](const ColourMap& colours) {
    Picture picture{{.colours = colours}};
    picture.add(surface(block), block.nodes, values);
    return is_drawn(picture.svg());
  });
  const auto draws = [&](const ChartOptions& options, const Style& style = {}) {
    Chart chart{options};
    chart.curve("a", x, y, style);
    chart.reference(3, "b");
    return is_drawn(chart.svg());
  };
  refuses(ChartOptions{.x = {.lower = .5, .upper = 5}, .y = {.scale = Scale::logarithmic, .lower = 1, .upper = 1000}},
          [&](const ChartOptions& options) { return draws(options); });
  refuses(Style{.marker = Marker::circle, .colour = 3}, [&](const Style& style) { return draws({}, style); });
  testing::refuses_wrong_arguments("reference", {{"y", 3}}, tried, [&](const Numbers& level) {
    Chart chart{{}};
    chart.curve("a", x, y), chart.reference(level[0], "b");
    return is_drawn(chart.svg());
  });
  testing::refuses_wrong_arguments("mark", {{"place", 3}}, tried, [&](const Numbers& place) {
    Picture picture{{}};
    picture.add(surface(block), block.nodes), picture.mark({place[0], 0, 0});
    return is_drawn(picture.svg());
  });
  // A value that is not finite is a result that does not pass.
  refuses(Result{.quantity = "length", .value = 2, .reference = 2.1, .tolerance = .2}, [](const Result& result) {
    Results results;
    results.add(result);
    return std::isfinite(result.value) || !results.passed();
  });
  tried.print("pictures, charts and tables");
}
