#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <strike/material/failing_ply.hpp>
#include <strike/material/point_values.hpp>

#include "support/catch.hpp"
#include "support/plies.hpp"

using namespace strike;
using testing::carbon, testing::carbon_chang, testing::carbon_hashin, testing::carbon_maximum;

namespace {

using Rate = PlaneStressKinematics::Rate<double>;

/// A pull or push s along x of fibres at an angle, in their axes.
PlaneTensor<double> off_axis(double s, double degrees) {
  const double a = degrees * std::numbers::pi / 180, c = std::cos(a), n = std::sin(a);
  return {s * c * c, s * n * n, -s * n * c};
}
/// The strains of a ply under that stress.
PlaneTensor<double> strains(const PlaneTensor<double>& s) {
  return {(s.xx - carbon.nu12 * s.yy) / carbon.E1, s.yy / carbon.E2 - carbon.nu12 * s.xx / carbon.E1,
          s.xy / (2 * carbon.G12)};
}

/// The ply bears a stress of 1 - 1e-9 of the strength, and not of 1 + 1e-9, along the whole curve.
template <class Criterion, class Strength>
void follows(const Criterion& criterion, double sign, Strength strength) {
  const FailingPly ply{carbon, criterion};
  for (double angle = 0; angle <= 90; angle += 2.5) {
    CAPTURE(angle);
    const double s = sign * strength(angle);
    for (const double share : {1 - 1e-9, 1 + 1e-9}) {
      typename FailingPly<Criterion>::template State<double> state;
      for (int i = 0; i < 4; ++i) ply.stress(state, Rate{0.25 * strains(off_axis(share * s, angle))}, 1.0);
      CHECK((state.intact == 1 && state.matrix == 1) == (share < 1));
    }
  }
}
/// The least of two strengths, infinite where a denominator is zero.
double least(double a, double b) { return std::min(a, b); }
double per_root(double square) { return square > 0 ? 1 / std::sqrt(square) : std::numeric_limits<double>::infinity(); }
struct Angle {
  double c2, s2, cs;
  explicit Angle(double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    c2 = std::cos(a) * std::cos(a), s2 = std::sin(a) * std::sin(a), cs = std::cos(a) * std::sin(a);
  }
};
/// The positive root of a s^2 + b s = 1.
double root(double a, double b) { return 2 / (b + std::sqrt(b * b + 4 * a)); }

}  // namespace

TEST_CASE("failing ply: strength off the axis by maximum stress") {
  const auto& [Xt, Xc, Yt, Yc, S] = carbon_maximum;
  const auto curve = [S = S](double X, double Y) {
    return [=](double degrees) {
      const Angle a(degrees);
      return 1 / std::max({a.c2 / X, a.s2 / Y, a.cs / S});
    };
  };
  follows(carbon_maximum, 1, curve(Xt, Yt));
  follows(carbon_maximum, -1, curve(Xc, Yc));
}

TEST_CASE("failing ply: strength off the axis by Hashin and by Chang and Chang") {
  const auto tension = [](double degrees, double Xt, double Yt, double S) {
    const Angle a(degrees);
    const double shear = a.cs * a.cs / (S * S);
    return least(per_root(a.c2 * a.c2 / (Xt * Xt) + shear), per_root(a.s2 * a.s2 / (Yt * Yt) + shear));
  };
  const auto compression = [](double degrees, double Xc, double Yc, double S, double St) {
    const Angle a(degrees);
    const double matrix =
        root(a.s2 * a.s2 / (4 * St * St) + a.cs * a.cs / (S * S), -(Yc * Yc / (4 * St * St) - 1) * a.s2 / Yc);
    return least(a.c2 > 0 ? Xc / a.c2 : std::numeric_limits<double>::infinity(), matrix);
  };
  const auto& h = carbon_hashin;
  follows(h, 1, [&](double angle) { return tension(angle, h.Xt, h.Yt, h.SL); });
  follows(h, -1, [&](double angle) { return compression(angle, h.Xc, h.Yc, h.SL, h.ST); });
  const auto& c = carbon_chang;
  follows(c, 1, [&](double angle) { return tension(angle, c.Xt, c.Yt, c.S); });
  follows(c, -1, [&](double angle) { return compression(angle, c.Xc, c.Yc, c.S, c.S); });
  ChangChang without_shear = carbon_chang;
  without_shear.beta = 0;
  const auto index = without_shear.index(PlaneTensor<double>{c.Xt, 0, 10 * c.S});
  CHECK(index.fibre == Approx(1).epsilon(1e-14));
}

TEST_CASE("failing ply: a ply bears its strengths, across in compression exactly Yc") {
  for (const double sign : {1., -1.}) {
    const double Y = sign > 0 ? 50 : -200;
    CHECK(carbon_hashin.index(PlaneTensor<double>{0, Y, 0}).matrix == Approx(1).epsilon(1e-14));
    CHECK(carbon_chang.index(PlaneTensor<double>{0, Y, 0}).matrix == Approx(1).epsilon(1e-14));
    CHECK(carbon_maximum.index(PlaneTensor<double>{0, Y, 0}).matrix == Approx(1).epsilon(1e-14));
    CHECK(carbon_hashin.index(PlaneTensor<double>{0, 0, sign * 90}).matrix == Approx(1).epsilon(1e-14));
  }
  CHECK(carbon_hashin.index(PlaneTensor<double>{}).matrix == 0);
}

TEST_CASE("failing ply: without its matrix the fibres go on by E1 of the strain, and without fibres nothing") {
  const FailingPly ply{carbon, carbon_hashin};
  FailingPly<Hashin>::State<double> state;
  const PlaneTensor<double> e{4e-3, 8e-3, 1e-3};  // breaks the matrix
  ply.stress(state, Rate{e}, 1.0);
  CHECK(MatrixFailed{}(state) == 1);
  CHECK(Failed{}(state) == 0);
  CHECK(state.stress.xx == Approx(carbon.E1 * e.xx).epsilon(1e-14));
  CHECK(state.stress.yy == 0);
  CHECK(state.stress.xy == 0);
  ply.stress(state, Rate{PlaneTensor<double>{2e-3, 1, 1}}, 1.0);
  CHECK(state.stress.xx == Approx(carbon.E1 * 6e-3).epsilon(1e-14));
  CHECK(state.stress.yy == 0);
  ply.stress(state, Rate{PlaneTensor<double>{1e-2, 0, 0}}, 1.0);
  CHECK(Failed{}(state) == 1);
  CHECK(MatrixFailed{}(state) == 1);
  ply.stress(state, Rate{PlaneTensor<double>{-3e-2, 1, 1}}, 1.0);
  CHECK(state.stress.xx == 0);
  CHECK(ply.intact(state) == 0);
}

// By any path no more can be got back than was put in: the work less what the strain still stores never falls.
TEST_CASE("failing ply: no energy comes of failure") {
  const FailingPly ply{carbon, carbon_hashin};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  int matrix = 0, fibres = 0;
  for (int path = 0; path < 200; ++path) {
    FailingPly<Hashin>::State<double> state;
    PlaneTensor<double> strain{}, before{};
    double work = 0, lost = 0;
    const PlaneTensor<double> trend{0.05 * unit(random), unit(random), unit(random)};
    for (int i = 0; i < 400; ++i) {
      const PlaneTensor<double> d =
          1e-4 * (trend + PlaneTensor<double>{0.3 * unit(random), unit(random), unit(random)});
      const bool had_matrix = state.matrix == 1, had_fibres = state.intact == 1;
      const PlaneTensor<double> s = ply.stress(state, Rate{d}, 1.0);
      work += 0.5 * double_dot(before + s, d);
      strain += d, before = s;
      const double stored = 0.5 * double_dot(s, strain), size = 0.5 * double_dot(carbon.elastic(strain), strain);
      const double drop = had_matrix != (state.matrix == 1) || had_fibres != (state.intact == 1)
                              ? 0.5 * std::abs(double_dot(carbon.elastic(d), d + strain))  // of the step that breaks
                              : 0;
      CHECK(work - stored >= lost - 1e-12 * size - 0.01 * drop);
      lost = work - stored;
    }
    matrix += state.matrix == 0 && state.intact == 1, fibres += state.intact == 0;
  }
  CHECK(matrix > 50);
  CHECK(fibres > 20);
}
