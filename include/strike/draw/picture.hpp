#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/draw/back_to_front.hpp>
#include <strike/draw/colour.hpp>
#include <strike/draw/svg.hpp>
#include <strike/error.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/output/file.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// Sides of a face that are drawn.
enum class Sides { outer, both };

/// Options of a picture.
struct PictureOptions {
  std::string title = {}, caption = {};
  std::string quantity = {}, unit = {};  ///< head of the legend
  Eigen::Vector3d from = {2, -3, 1};     ///< direction to the eye, which is infinitely far
  Eigen::Vector3d up = {0, 0, 1};        ///< upward direction of the picture
  /// Planes x = 0, ... in which the model is mirrored; a plane of symmetry that is left out shows as a section.
  std::vector<Axis> mirror = {};
  double low = std::numeric_limits<double>::quiet_NaN();   ///< value at the lower end of the legend; NaN: the smallest
  double high = std::numeric_limits<double>::quiet_NaN();  ///< value at the upper end; NaN: the largest
  ColourMap colours = colour_maps::ember;
  std::string length_unit = {};  ///< if given, a bar of a round length is drawn to scale
  double size = 520;             ///< longer edge of the room for the model [px]

  void ranges(const auto& number) const {
    number("from", from, range::direction);
    number("up", up, range::direction);
    number("low", low, range::or_nan(range::finite));
    number("high", high, range::or_nan(range::finite));
    if (!std::isnan(low)) number("high", high, range::or_nan(range::above(low)));
    number(colours);
    number("size", size, range::positive);
  }
};

/// A picture of deformed surfaces coloured by a value per cell, as SVG:
/// `Picture picture{{.title = "Taylor bar", .quantity = "plastic strain", .mirror = {Axis::x, Axis::y}}};
///  picture.add(surface(mesh), positions, plastic_strain); picture.write("taylor.svg");`
/// Parallel projection; faces are drawn from the back to the front by the depth of their centres, particles as balls
/// between those behind them and those in front of them.
class Picture {
 public:
  [[gnu::cold]] explicit Picture(PictureOptions options) : options_(std::move(options)) {
    detail::check_ranges(options_);
    toward_ = detail::direction(options_.from);
    right_ = cross(options_.up, toward_);
    if (right_.norm() < 1e-6 * options_.up.norm()) {  // the eye is right above
      right_ = cross(unit(std::abs(toward_.x()) < 0.5 ? Axis::x : Axis::y), toward_);
    }
    right_ = detail::direction(right_);
    up_ = cross(toward_, right_);
  }

  /// Adds a surface with the positions of the nodes and `values[face.cell]`; without values it is plain grey.
  /// Error: a face whose node or cell is not there.
  [[gnu::cold]] void add(std::span<const Face> faces, std::span<const Eigen::Vector3d> positions,
                         std::span<const double> values = {}, Sides sides = Sides::outer) {
    for (const Face& face : faces) {
      if (*std::max_element(face.nodes.begin(), face.nodes.end()) >= positions.size())
        throw Error(detail::joined({"strike: a face of cell ", std::to_string(face.cell), " names a node beyond the ",
                                    std::to_string(positions.size()), " positions: give the positions of all nodes."}));
      if (!values.empty() && face.cell >= values.size())
        throw Error(detail::joined({"strike: cell ", std::to_string(face.cell), " has no value among ",
                                    std::to_string(values.size()), ": give one value for each cell."}));
    }
    for (const double value : values) note(value);
    const double on_plane = 1e-6 * extent(positions);
    add(faces, positions, values, sides, on_plane, {1, 1, 1}, 0);
  }

  /// Adds particles with the positions of the nodes and `values[e]` of particle e; without values they are plain grey.
  /// They are balls as wide as their spacing, the cube root of their volume at rest, as which they touch in contact.
  /// Of those that are left add `remaining(mesh, alive).particles` with `remaining(values, alive)`. Errors: another
  /// number of volumes or of values than of particles; a volume that is not positive; a node that is not there.
  [[gnu::cold]] void add(const Particles& particles, std::span<const Eigen::Vector3d> positions,
                         std::span<const double> values = {}) {
    detail::check_particles(positions, particles);
    if (!values.empty() && values.size() != particles.size())
      throw Error(detail::joined({"strike: there are ", std::to_string(values.size()), " values of ",
                                  std::to_string(particles.size()), " particles: give one value for each particle."}));
    for (const double value : values) note(value);
    for (std::size_t e = 0; e < particles.size(); ++e)
      add_ball(positions[particles[e][0]], 0.5 * std::cbrt(particles.volumes[e]), values.empty() ? nullptr : &values[e],
               {1, 1, 1}, 0);
  }

  /// Adds nodes whose elements are all deleted, as small circles.
  void add_particles(std::span<const Eigen::Vector3d> positions) {
    for (const Eigen::Vector3d& x : positions) add_ball(x, 0, nullptr, {1, 1, 1}, 0);
  }

  /// Marks a place with a dot, on top of everything, and a label beside it. Error: a place that is not finite.
  void mark(const Eigen::Vector3d& place, std::string label = {}) {
    detail::RangeCheck("mark", "")("place", place, range::point);
    marks_.push_back({place, std::move(label)});
  }

  /// Writes the SVG file. Errors: nothing to draw; a file that cannot be written.
  void write(const std::string& path) const { detail::replace_file(path, svg()); }

  /// The SVG text.
  [[gnu::cold]] std::string svg() const {
    if (figures_.empty())
      throw Error(detail::joined({"strike: the Picture '", options_.title, "' shows no face: add a surface first."}));
    const bool legend = low_ <= high_;  // something has a value
    const double low = std::isnan(options_.low) ? low_ : options_.low;
    const double high = std::isnan(options_.high) ? high_ : options_.high;

    Frame frame = bounds();
    constexpr double margin = 40, legend_room = 190;
    const double right = legend ? legend_room : margin;
    const double width =
        std::max({margin + frame.width() + right, 2 * margin + detail::text_width(options_.title, 21), 420.0});
    frame.left = margin + (width - margin - frame.width() - right) / 2;
    frame.top = options_.title.empty() ? margin : 84;

    detail::Svg svg;
    if (!options_.title.empty()) svg.text(margin, 46, options_.title, {.size = 21, .fill = "#1a1a1a", .weight = "600"});
    draw_figures(svg, frame, low, high);
    draw_marks(svg, frame);
    double foot = frame.top + frame.height();
    if (legend) foot = std::max(foot, draw_legend(svg, width - 138, frame.top, low, high));
    if (!options_.length_unit.empty()) foot = draw_scale_bar(svg, margin, foot + 30, frame);
    foot += 36;
    if (!options_.caption.empty())
      foot = svg.paragraph(margin, foot, options_.caption, width - 2 * margin, {.fill = "#595959"}) + 10;
    return svg.file(width, foot);
  }

 private:
  struct Mark {
    Eigen::Vector3d place;
    std::string label;
  };
  /// Place and scale of the model on the sheet.
  struct Frame {
    Eigen::Vector3d lower, upper;  // ends of the projected model
    double scale;                  // [px / length]
    double left = 0, top = 0;      // [px]

    double width() const { return scale * (upper[0] - lower[0]); }
    double height() const { return scale * (upper[1] - lower[1]); }
    double x(const Eigen::Vector3d& p) const { return left + scale * (p[0] - lower[0]); }
    double y(const Eigen::Vector3d& p) const { return top + scale * (upper[1] - p[1]); }
  };

  [[gnu::cold]] Frame bounds() const {
    Eigen::Vector3d lower = figures_[0].corners[0], upper = lower;
    for (const detail::Figure& figure : figures_)
      for (std::size_t i = 0; i < figure.size; ++i) {
        for (int c = 0; c < 2; ++c) {
          lower(c) = std::min(lower(c), figure.corners[i](c) - figure.radius);
          upper(c) = std::max(upper(c), figure.corners[i](c) + figure.radius);
        }
      }
    return {lower, upper, options_.size / std::max(upper[0] - lower[0], upper[1] - lower[1])};
  }

  void note(double value) {
    if (!std::isfinite(value)) return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }

  /// x and y in the picture, and depth toward the eye.
  Eigen::Vector3d projected(const Eigen::Vector3d& x) const { return {right_.dot(x), up_.dot(x), toward_.dot(x)}; }

  static Eigen::Vector3d reflected(const Eigen::Vector3d& x, const Eigen::Vector3d& sign) {
    return {x[0] * sign[0], x[1] * sign[1], x[2] * sign[2]};
  }

  /// Adds the faces reflected by the signs, and the images in the remaining planes of symmetry.
  [[gnu::cold]] void add(std::span<const Face> faces, std::span<const Eigen::Vector3d> positions,
                         std::span<const double> values, Sides sides, double on_plane, const Eigen::Vector3d& sign,
                         std::size_t first_plane) {
    using namespace detail;
    for (const Face& face : faces) {
      if (is_cut(face, positions, on_plane)) continue;
      Eigen::Vector3d normal = reflected(direction(area_vector(positions, face)), sign);
      if (sides == Sides::both && normal.dot(toward_) < 0) normal = -normal;
      if (!(normal.dot(toward_) > 1e-3)) continue;
      Figure figure;
      figure.size = face.is_triangle() ? 3 : 4;
      for (std::size_t i = 0; i < figure.size; ++i)
        figure.corners[i] = projected(reflected(positions[face.nodes[i]], sign));
      figure.depth = projected(reflected(centroid(positions, face), sign))[2];
      // Light from the upper left behind the eye; never dark, so that colours can be compared with the legend.
      const Eigen::Vector3d lamp = direction(toward_ + 0.5 * up_ - 0.5 * right_);
      figure.light = 0.87 + 0.13 * std::max(0.0, normal.dot(lamp));
      figure.plain = values.empty();
      figure.value = figure.plain ? 0 : values[face.cell];
      figures_.push_back(figure);
    }
    for (std::size_t plane = first_plane; plane < options_.mirror.size(); ++plane) {
      Eigen::Vector3d image = sign;
      image[static_cast<Eigen::Index>(options_.mirror[plane])] *= -1;
      add(faces, positions, values, sides, on_plane, image, plane + 1);
    }
  }

  /// Adds a ball, or a dot if its radius is 0, reflected by the signs, and its images in the remaining planes of
  /// symmetry.
  [[gnu::cold]] void add_ball(const Eigen::Vector3d& x, double radius, const double* value, const Eigen::Vector3d& sign,
                              std::size_t first_plane) {
    detail::Figure figure{};
    figure.corners[0] = projected(reflected(x, sign));
    figure.size = 1;
    figure.depth = figure.corners[0][2];
    figure.light = 1;
    figure.plain = value == nullptr;
    figure.value = value ? *value : 0;
    figure.radius = radius;
    figures_.push_back(figure);
    for (std::size_t plane = first_plane; plane < options_.mirror.size(); ++plane) {
      Eigen::Vector3d image = sign;
      image[static_cast<Eigen::Index>(options_.mirror[plane])] *= -1;
      add_ball(x, radius, value, image, plane + 1);
    }
  }

  /// True of a face in a plane of symmetry, which is inside the whole body.
  bool is_cut(const Face& face, std::span<const Eigen::Vector3d> positions, double on_plane) const {
    return std::any_of(options_.mirror.begin(), options_.mirror.end(), [&](Axis axis) {
      return std::all_of(face.nodes.begin(), face.nodes.end(), [&](Index node) {
        return std::abs(positions[node][static_cast<Eigen::Index>(axis)]) <= on_plane;
      });
    });
  }

  /// A radius in hundredths of a pixel, as rounded in the file.
  static long rounded_radius(const detail::Figure& ball, const Frame& frame) {
    return std::lround(100 * frame.scale * ball.radius);
  }
  static std::string ball_name(long radius) { return "ball" + std::to_string(radius); }

  /// Balls of each radius, shaded toward the rim with a highlight from where the lamp of the faces is, around the
  /// colour of what uses them.
  [[gnu::cold]] void define_balls(detail::Svg& svg, const Frame& frame) const {
    std::set<long> radii;
    for (const detail::Figure& figure : figures_)
      if (figure.radius > 0) radii.insert(rounded_radius(figure, frame));
    if (radii.empty()) return;
    svg.open("defs");
    svg.open("radialGradient", {{"id", "sphere"}, {"cx", .35}, {"cy", .33}, {"r", .7}});
    svg.element("stop", {{"offset", 0}, {"stop-color", "#fff"}, {"stop-opacity", .55}});
    svg.element("stop", {{"offset", .4}, {"stop-color", "#fff"}, {"stop-opacity", 0}});
    svg.element("stop", {{"offset", .5}, {"stop-color", "#000"}, {"stop-opacity", 0}});
    svg.element("stop", {{"offset", 1}, {"stop-color", "#000"}, {"stop-opacity", .5}});
    svg.close();
    for (const long radius : radii) {
      const double r = 0.01 * static_cast<double>(radius);
      svg.open("g", {{"id", ball_name(radius)}});
      svg.element("circle", {{"r", r}});
      svg.element("circle", {{"r", r}, {"fill", "url(#sphere)"}, {"stroke", "none"}});
      svg.close();
    }
    svg.close();
  }

  [[gnu::cold]] void draw_figures(detail::Svg& svg, const Frame& frame, double low, double high) const {
    const auto tenths = [](double x) { return std::round(10 * x) / 10; };
    define_balls(svg, frame);
    svg.open("g",
             {{"stroke", "#000000"}, {"stroke-opacity", ".28"}, {"stroke-width", ".5"}, {"stroke-linejoin", "round"}});
    for (const detail::Figure* figure : detail::back_to_front(figures_)) {
      const Colour colour = figure->plain ? Colour{0.86, 0.01, 250}
                                          : options_.colours(high > low ? (figure->value - low) / (high - low) : 0);
      const std::string fill = colour.in_light(figure->light).hex();
      double x = tenths(frame.x(figure->corners[0])), y = tenths(frame.y(figure->corners[0]));
      if (figure->is_ball() && figure->radius == 0) {
        svg.element("circle", {{"cx", x}, {"cy", y}, {"r", 1.6}, {"fill", "#ffffff"}});
        continue;
      }
      if (figure->is_ball()) {
        const std::string name = "#" + ball_name(rounded_radius(*figure, frame));
        svg.element("use", {{"href", name}, {"x", x}, {"y", y}, {"fill", fill}});
        continue;
      }
      std::string path = detail::joined({"M", detail::pixels(x), " ", detail::pixels(y)});
      for (std::size_t i = 1; i < figure->size; ++i) {  // relative to what is rounded in the file, so as not to drift
        const double next_x = tenths(frame.x(figure->corners[i])), next_y = tenths(frame.y(figure->corners[i]));
        path += detail::joined({"l", detail::pixels(next_x - x), " ", detail::pixels(next_y - y)});
        x = next_x;
        y = next_y;
      }
      svg.element("path", {{"fill", fill}, {"d", path += 'z'}});
    }
    svg.close();
  }

  [[gnu::cold]] void draw_marks(detail::Svg& svg, const Frame& frame) const {
    for (const Mark& mark : marks_) {
      const Eigen::Vector3d p = projected(mark.place);
      const double x = frame.x(p), y = frame.y(p);
      svg.element(
          "circle",
          {{"cx", x}, {"cy", y}, {"r", 4}, {"fill", "#ffffff"}, {"stroke", "#1a1a1a"}, {"stroke-width", "1.5"}});
      svg.text(x + 9, y + 4.5, mark.label, {.fill = "#1a1a1a", .halo = "#ffffff"});
    }
  }

  /// The bar of colours from y downward; gives the y of its foot.
  [[gnu::cold]] double draw_legend(detail::Svg& svg, double x, double y, double low, double high) const {
    constexpr double bar_width = 16, bar_height = 240;
    const double range = high > low ? high - low : std::max(std::abs(high), 1.0);
    const auto ticks = detail::Ticks::between(low, low + range, 5);
    y = svg.paragraph(x, y + 6, options_.quantity + ticks.unit_label(options_.unit), 118, {.fill = "#1a1a1a"}) + 2;
    svg.open("linearGradient", {{"id", "legend"}, {"x1", 0}, {"y1", 1}, {"x2", 0}, {"y2", 0}});
    for (int i = 0; i <= 24; ++i)
      svg.element("stop", {{"offset", i / 24.0}, {"stop-color", options_.colours(i / 24.0).hex()}});
    svg.close();
    svg.element("rect", {{"x", x}, {"y", y}, {"width", bar_width}, {"height", bar_height}, {"fill", "url(#legend)"}});
    for (const double mark : ticks.in(low, low + range)) {
      const double at = y + bar_height * (1 - (mark - low) / range);
      svg.line(x + bar_width, at, x + bar_width + 5, at, "#595959", 1);
      svg.text(x + bar_width + 10, at + 4.5, ticks.label(mark));
    }
    return y + bar_height;
  }

  /// A bar of a round length; gives the y of its foot.
  [[gnu::cold]] double draw_scale_bar(detail::Svg& svg, double x, double y, const Frame& frame) const {
    const double length = detail::Ticks::between(0, frame.width() / frame.scale, 3).step;
    const double end = x + frame.scale * length;
    svg.line(x, y, end, y, "#595959", 1.5);
    svg.line(x, y - 4, x, y + 4, "#595959", 1.5);
    svg.line(end, y - 4, end, y + 4, "#595959", 1.5);
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", length);
    svg.text(end + 10, y + 4.5, detail::joined({text, " ", options_.length_unit}), {.fill = "#595959"});
    return y + 6;
  }

  PictureOptions options_;
  Eigen::Vector3d toward_, right_, up_;
  std::vector<detail::Figure> figures_;
  std::vector<Mark> marks_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace strike
