#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/scalar/bisect.hpp>
#include <strike/section/transverse_shear.hpp>
#include <strike/text.hpp>

#include <unsupported/Eigen/MatrixFunctions>

namespace strike::verify {

/// A layer of an isotropic, linear-elastic solid.
struct ElasticLayer {
  double thickness;
  double youngs_modulus;
  double poissons_ratio;  ///< < 1/2
  double density = 0;     ///< for frequencies

  void ranges(const auto& number) const {
    number("thickness", thickness, range::positive);
    number("youngs_modulus", youngs_modulus, range::positive);
    number("poissons_ratio", poissons_ratio, Range{.low = -1, .high = 0.5});
    number("density", density, range::not_negative);
  }

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
  /// E/(1 - nu^2).
  double plane_modulus() const { return youngs_modulus / (1 - poissons_ratio * poissons_ratio); }
};

/// A half wave sin px at a height of a stack: u = U cos px, w = W sin px, sigma_z = S sin px,
/// tau_xz = T cos px, sigma_x = X sin px.
struct LaminateWave {
  double z;  ///< over the bottom
  std::size_t layer;
  double U, W, S, T, X;
};

/// Layers bonded to each other, bottom to top, by three-dimensional elasticity without any assumption (the state-vector
/// method; Bahar 1975): a reference for sections of plates. The edges are simply supported and the bottom is
/// free. A plate of isotropic layers responds to sin(m pi x/a) sin(n pi y/b) as a strip to sin px with
/// p^2 = (m pi/a)^2 + (n pi/b)^2, so that one number p serves strips and plates.
class Laminate {
 public:
  /// Errors: a layer without thickness or stiffness.
  explicit Laminate(std::vector<ElasticLayer> layers) : layers_(std::move(layers)) {
    for (std::size_t k = 0; k < layers_.size(); ++k)
      detail::check_ranges(layers_[k], detail::joined({", in layer ", std::to_string(k), " of a Laminate,"}));
    if (layers_.empty()) throw Error("strike: a Laminate has no layer: give at least one.");
  }

  const std::vector<ElasticLayer>& layers() const { return layers_; }
  double thickness() const {
    return sum([](const ElasticLayer& layer) { return layer.thickness; });
  }
  /// Mass per area.
  double density() const {
    return sum([](const ElasticLayer& layer) { return layer.density * layer.thickness; });
  }
  /// The transverse shear of these layers in the theory of plates.
  TransverseShear<double> transverse_shear() const {
    std::vector<ShearLayer<double>> all;
    for (const ElasticLayer& layer : layers_)
      all.push_back({layer.thickness, {layer.plane_modulus(), layer.shear_modulus()}});
    return strike::transverse_shear(all);
  }

  /// The wave at the height z over the bottom, under sigma_z = sin px on the top.
  LaminateWave at(double p, double z) const {
    Vector4 state = at_bottom(p);
    std::size_t k = 0;
    double bottom = 0;
    for (; k + 1 < layers_.size() && z > bottom + layers_[k].thickness; bottom += layers_[k++].thickness)
      state = transfer(layers_[k], layers_[k].thickness, p, 0) * state;
    return wave(k, z, p, transfer(layers_[k], z - bottom, p, 0) * state);
  }
  /// The wave at `count` equal steps through each layer, at both faces of each.
  std::vector<LaminateWave> profile(double p, std::size_t count = 20) const {
    std::vector<LaminateWave> waves;
    Vector4 state = at_bottom(p);
    double bottom = 0;
    for (std::size_t k = 0; k < layers_.size(); bottom += layers_[k++].thickness) {
      const double dz = layers_[k].thickness / static_cast<double>(count);
      const Matrix4 step = transfer(layers_[k], dz, p, 0);
      waves.push_back(wave(k, bottom, p, state));
      for (std::size_t i = 1; i <= count; ++i)
        waves.push_back(wave(k, bottom + static_cast<double>(i) * dz, p, state = step * state));
    }
    return waves;
  }
  /// The deflection of the middle surface.
  double deflection(double p) const { return at(p, 0.5 * thickness()).W; }

  /// The lowest natural frequency of a half wave [rad/time], which bends: det [S; T](U, W) = 0 on the free top.
  double angular_frequency(double p) const {
    const TransverseShear<double> plate = transverse_shear();
    const Bracket<double> all{0, 1.1 * p * p * p * p * plate.bending / density()};  // Kirchhoff's is above
    const auto at_free_top = [&](double omega2) { return determinant(traction(p, omega2)); };
    const bool positive = at_free_top(0) > 0;
    const auto is_below = [&](double omega2) { return (at_free_top(omega2) > 0) == positive; };
    return std::sqrt(bisect(all, is_below, 60).middle());
  }

 private:
  using Vector4 = Eigen::Vector4d;
  using Matrix4 = Eigen::Matrix4d;

  template <class F>
  double sum(F f) const {
    double s = 0;
    for (const ElasticLayer& layer : layers_) s += f(layer);
    return s;
  }

  /// The transfer matrix of (U, W, S, T) over the height h of a layer. With C11 = lambda + 2 G, C13 = lambda, and S and
  /// T in units of p C11
  ///   U' = C11/G T - W,    W' = S + C13/C11 U,    S' = T - Omega W,    T' = (1 - (C13/C11)^2 - Omega) U - C13/C11 S
  /// by p z, with Omega = rho omega^2/(p^2 C11): numbers near 1 for layers of any softness.
  static Matrix4 transfer(const ElasticLayer& layer, double h, double p, double omega2) {
    const double G = layer.shear_modulus(), ratio = layer.poissons_ratio / (1 - layer.poissons_ratio);
    const double C11 = 2 * G / (1 - ratio), Omega = layer.density * omega2 / (p * p * C11);
    Matrix4 A;
    A << 0, -1, 0, C11 / G,  //
        ratio, 0, 1, 0,      //
        0, -Omega, 0, 1,     //
        1 - ratio * ratio - Omega, 0, -ratio, 0;
    const Matrix4 E = exponential(p * h * A);
    const Vector4 unit(1, 1, p * C11, p * C11);
    return unit.asDiagonal() * E * unit.cwiseInverse().asDiagonal();
  }

  /// exp A = (exp A/2^n)^(2^n), by its series to 1e-17 where |A|/2^n < 1/2.
  static Matrix4 exponential(Matrix4 A) {
    int n = 0;
    for (; A.norm() > 0.5; ++n) A *= 0.5;
    Matrix4 E = Matrix4::Identity(), term = E;
    for (int k = 1; k <= 14; ++k) term = term * A / k, E += term;
    for (; n > 0; --n) E = E * E;
    return E;
  }

  /// Matrix from (U, W) at the bottom to (S, T) on top.
  Eigen::Matrix2d traction(double p, double omega2) const {
    Matrix4 M = Matrix4::Identity();
    for (const ElasticLayer& layer : layers_) M = transfer(layer, layer.thickness, p, omega2) * M;
    return M.bottomLeftCorner<2, 2>();
  }

  static double determinant(const Eigen::Matrix2d& M) { return M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0); }

  LaminateWave wave(std::size_t k, double z, double p, const Vector4& state) const {
    const double ratio = layers_[k].poissons_ratio / (1 - layers_[k].poissons_ratio);
    const double X = ratio * state(2) - layers_[k].plane_modulus() * p * state(0);
    return {z, k, state(0), state(1), state(2), state(3), X};
  }

  Vector4 at_bottom(double p) const {
    const Eigen::Matrix2d M = traction(p, 0);
    return Vector4(M(1, 1), -M(1, 0), 0, 0) / determinant(M);
  }

  std::vector<ElasticLayer> layers_;
};

/// A plate with shear deformation (Mindlin 1951), to compare with; with K infinite Kirchhoff's.
struct MindlinPlate {
  double bending;          ///< D [force length]
  double shear_stiffness;  ///< K [force/length]
  double density = 0, rotary_inertia = 0;

  void ranges(const auto& number) const {
    number("bending", bending, range::positive);
    number("shear_stiffness", shear_stiffness, range::or_infinite(range::positive));
    number("density", density, range::not_negative);
    number("rotary_inertia", rotary_inertia, range::not_negative);
  }

  /// Deflection under sin px.
  double deflection(double p) const {
    detail::check_ranges(*this);
    return 1 / (p * p * p * p * bending) + 1 / (p * p * shear_stiffness);
  }
  /// Lowest natural frequency [rad/time], the lower root of (K p^2 - m omega^2) (K + D p^2 - I omega^2) = K^2 p^2.
  double angular_frequency(double p) const {
    detail::check_ranges(*this);
    const double K = shear_stiffness, B = K + bending * p * p;
    const double a = density * rotary_inertia, b = density * B + rotary_inertia * K * p * p,
                 c = K * p * p * bending * p * p;
    return std::sqrt(2 * c / (b + std::sqrt(b * b - 4 * a * c)));
  }
};

/// The deflection in the middle of a rectangle a x b, simply supported, under the uniform pressure 1, from that under
/// sin px, w(p): Navier's series.
template <class W>
double rectangle_deflection(double a, double b, W w, int terms = 40) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int i = 0; i < terms; ++i)
    for (int j = 0; j < terms; ++j) {
      const int m = 2 * i + 1, n = 2 * j + 1;
      sum += ((i + j) % 2 == 0 ? 1 : -1) * 16 / (pi * pi * m * n) * w(std::hypot(m * pi / a, n * pi / b));
    }
  return sum;
}

}  // namespace strike::verify
