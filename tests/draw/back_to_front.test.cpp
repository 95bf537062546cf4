// The order of faces and balls in a picture, against what a ray through each point of a ball meets.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <strike/draw/back_to_front.hpp>

#include "support/catch.hpp"

using strike::detail::back_to_front;
using strike::detail::Figure;

namespace {

/// A slanting plate of squares, whose depth is `a x + b y`, as it stands in the picture.
struct Plate {
  double a, b;
  static constexpr int cells = 8;

  double depth(double x, double y) const { return a * x + b * y; }
  std::vector<Figure> faces() const {
    std::vector<Figure> all;
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) {
        Figure face{};
        face.size = 4;
        const auto corner = [&](double x, double y) { return Eigen::Vector3d(x, y, depth(x, y)); };
        face.corners = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
        face.depth = depth(i + 0.5, j + 0.5);
        all.push_back(face);
      }
    return all;
  }
};

Figure ball(const Eigen::Vector3d& place, double radius) {
  Figure figure{};
  figure.size = 1, figure.corners[0] = place, figure.depth = place[2], figure.radius = radius;
  return figure;
}

/// Balls that do not touch the plate, on the side of the eye (1), on the other side (-1), or on both (0).
std::vector<Figure> balls_beside(const Plate& plate, int side, std::mt19937& random) {
  std::uniform_real_distribution<double> along(-0.5, Plate::cells + 0.5), away(0.3, 3), sign(-1, 1);
  std::vector<Figure> all;
  const double normal = std::sqrt(1 + plate.a * plate.a + plate.b * plate.b);
  for (int i = 0; i < 200; ++i) {
    const double x = along(random), y = along(random), toward = side == 0 ? sign(random) : side;
    all.push_back(ball({x, y, plate.depth(x, y) + (toward > 0 ? 1 : -1) * normal * away(random)}, 0.25));
  }
  return all;
}

/// Whether the disc of a ball and a square have more in common than a touch: the square's nearest point is in the disc.
bool overlap(const Figure& of_ball, const Figure& face) {
  const Eigen::Vector3d& x = of_ball.corners[0];
  const auto beyond = [&](int c) { return std::max({face.corners[0][c] - x[c], 0.0, x[c] - face.corners[2][c]}); };
  return std::hypot(beyond(0), beyond(1)) < (1 - 1e-9) * of_ball.radius;
}

}  // namespace

TEST_CASE("back to front: balls beside a slanting plate are before or after each face that they overlap") {
  std::mt19937 random(1);
  for (const Plate& plate : {Plate{0, 0}, Plate{1, 0}, Plate{-0.5, 2}, Plate{-3, -4}})
    for (const int side : {1, -1, 0}) {
      std::vector<Figure> figures = plate.faces();
      const std::vector<Figure> balls = balls_beside(plate, side, random);
      figures.insert(figures.end(), balls.begin(), balls.end());
      std::shuffle(figures.begin(), figures.end(), random);
      const auto order = back_to_front(figures);
      REQUIRE(order.size() == figures.size());
      std::size_t wrong = 0, wrong_balls = 0, overlaps = 0;
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
          const Figure &first = *order[i], &second = *order[j];
          if (first.is_ball() && second.is_ball()) wrong_balls += first.depth > second.depth;
          if (first.is_ball() == second.is_ball()) continue;
          const Figure &round = first.is_ball() ? first : second, &face = first.is_ball() ? second : first;
          if (!overlap(round, face)) continue;
          ++overlaps;
          const Eigen::Vector3d& x = round.corners[0];
          wrong += (x[2] > plate.depth(x[0], x[1])) == first.is_ball();
        }
      INFO("plate " << plate.a << " " << plate.b << ", side " << side);
      CHECK(overlaps > 200);
      CHECK(wrong == 0);
      if (side != 0) CHECK(wrong_balls == 0);  // with both sides, those of one may have to pass those of the other
    }
}

TEST_CASE("back to front: the order does not depend on how figures are numbered") {
  std::mt19937 random(2);
  const Plate plate{-0.51, 2.07};  // no two centres are equally deep
  std::vector<Figure> figures = plate.faces();
  const std::vector<Figure> balls = balls_beside(plate, 0, random);
  figures.insert(figures.end(), balls.begin(), balls.end());
  const auto depths = [&] {
    std::vector<double> all;
    for (const Figure* figure : back_to_front(figures)) all.push_back(figure->depth);
    return all;
  };
  const std::vector<double> before = depths();
  std::shuffle(figures.begin(), figures.end(), random);
  CHECK(depths() == before);
}

TEST_CASE("back to front: nothing, faces alone and balls alone") {
  CHECK(back_to_front({}).empty());
  std::vector<Figure> faces = Plate{1, 0}.faces();
  const auto order = back_to_front(faces);
  CHECK(std::is_sorted(order.begin(), order.end(), [](auto* a, auto* b) { return a->depth < b->depth; }));
  const std::vector<Figure> balls{ball({0, 0, 2}, 1), ball({0, 0, 1}, 1), ball({0, 0, 3}, 0)};
  const auto of_balls = back_to_front(balls);
  CHECK(of_balls == std::vector{&balls[1], &balls[0], &balls[2]});
}
