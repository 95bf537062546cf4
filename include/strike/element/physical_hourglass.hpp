#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <type_traits>

#include <strike/element/hourglass.hpp>
#include <strike/element/point_flow.hpp>
#include <strike/tensor/plane.hpp>

namespace strike {

namespace detail {

/// f(k, i, j) of the three directions of an element, each with the other two in cyclic order, as constants.
template <class F>
void each_direction(F f) {
  const std::integral_constant<std::size_t, 0> x;
  const std::integral_constant<std::size_t, 1> y;
  const std::integral_constant<std::size_t, 2> z;
  f(x, y, z), f(y, z, x), f(z, x, y);
}

/// The parallelepiped of the mean edges a_i of a hexahedron, in which stresses beside the mean are plane stresses: for
/// each direction one in the plane of the other two edges, linear along it.
template <class T>
class MeanEdges {
 public:
  using Planes = std::array<PlaneTensor<T>, 3>;

  explicit MeanEdges(const Hex8Modes<T>& m)
      : a_{m.a1, m.a2, m.a3}, squares_{dot(m.a1, m.a1), dot(m.a2, m.a2), dot(m.a3, m.a3)} {
    each_direction([&](auto k, auto i, auto j) {
      const T ij = dot(a_[i], a_[j]), determinant = squares_[i] * squares_[j] - ij * ij, w = 1.0 / determinant;
      planes_[k] = {{w * squares_[j], w * squares_[i], -w * ij}, determinant, ij};
    });
  }

  /// Covariant components of the strains linear along each direction from the hourglass rates q, to which these
  /// edges belong: those of sym(q_bj (x) a^i + q_bi (x) a^j).
  Planes strain(const HourglassModes<T>& q) const { return strain(q, a_); }
  static Planes strain(const HourglassModes<T>& q, const std::array<Vector3<T>, 3>& a) {
    const auto half = [&](std::size_t i) -> T { return 0.5 * dot(q[i], a[i]); };
    const std::array<T, 3> shear{half(0), half(1), half(2)};
    Planes D;
    each_direction([&](auto k, auto i, auto j) { D[k] = {dot(q[j], a[i]), dot(q[i], a[j]), shear[i] + shear[j]}; });
    return D;
  }
  /// Of a tensor A its covariant components a_i . A a_j in each plane.
  Planes covariant(const SymmetricTensor<T>& A) const {
    const std::array<Vector3<T>, 3> Aa{A * a_[0], A * a_[1], A * a_[2]};
    Planes n;
    each_direction([&](auto k, auto i, auto j) { n[k] = {dot(a_[i], Aa[i]), dot(a_[j], Aa[j]), dot(a_[i], Aa[j])}; });
    return n;
  }
  /// Contravariant components of the plane stresses per 2 G of strains with the covariant components D,
  /// mu tr(g D) g + g D g with the inverse g of each plane's metric; mu = lambda/(lambda + 2 G).
  Planes stress(const T& mu, const Planes& D) const {
    Planes S;
    each_direction([&](auto k, auto, auto) {
      const auto& [g, determinant, mixed] = planes_[k];
      const T ii = g.xx * D[k].xx + g.xy * D[k].xy, ij = g.xx * D[k].xy + g.xy * D[k].yy;  // g D
      const T ji = g.xy * D[k].xx + g.yy * D[k].xy, jj = g.xy * D[k].xy + g.yy * D[k].yy;
      S[k] =
          T(mu * (ii + jj)) * g + PlaneTensor<T>{ii * g.xx + ij * g.xy, ji * g.xy + jj * g.yy, ii * g.xy + ij * g.yy};
    });
    return S;
  }
  /// Sum of the squares of the von Mises equivalents of plane stresses, tr^2 - 3 det each.
  T equivalent_squared(const Planes& S) const {
    T sum = T(0.0);
    each_direction([&](auto k, auto i, auto j) {
      const auto& [g, determinant, mixed] = planes_[k];
      const T trace = squares_[i] * S[k].xx + squares_[j] * S[k].yy + 2.0 * (mixed * S[k].xy);
      sum += trace * trace - 3.0 * (determinant * (S[k].xx * S[k].yy - S[k].xy * S[k].xy));
    });
    return sum;
  }
  /// The resistance of the modes b to the strains by stresses S over the volume V: V/3 times the derivative of D : S,
  /// for the mean of the square of a coordinate is 1/3.
  HourglassModes<T> resistance(const T& V, const Planes& S) const {
    const Vector3<T> none = Vector3<T>::Zero();
    HourglassModes<T> Q{none, none, none, none};
    const T third = T(1.0 / 3.0) * V;
    each_direction([&](auto k, auto i, auto j) {
      const PlaneTensor<T> F = third * S[k];
      Q[i] = Q[i] + F.yy * a_[j] + F.xy * a_[i];
      Q[j] = Q[j] + F.xx * a_[i] + F.xy * a_[j];
    });
    return Q;
  }

  /// Traces of the inverse metrics of the planes: their sum, in a brick twice the sum of 1/|a_i|^2, and the largest.
  struct Traces {
    T sum, largest;
  };
  Traces traces() const {
    Traces t{T(0.0), T(0.0)};
    each_direction([&](auto k, auto, auto) {
      const T trace_k = trace(planes_[k].inverse);
      t.sum += trace_k, t.largest = max(t.largest, trace_k);
    });
    return t;
  }

  /// The sum of a_k : b_k.
  static T contracted(const Planes& a, const Planes& b) {
    return double_dot(a[0], b[0]) + double_dot(a[1], b[1]) + double_dot(a[2], b[2]);
  }
  /// a + x b.
  static Planes sum(const Planes& a, const T& x, const Planes& b) {
    return {a[0] + x * b[0], a[1] + x * b[1], a[2] + x * b[2]};
  }

 private:
  struct Plane {
    PlaneTensor<T> inverse;  ///< of the metric G_ij = a_i . a_j
    T determinant, mixed;    ///< det G and a_i . a_j
  };
  std::array<Vector3<T>, 3> a_;
  std::array<T, 3> squares_;
  std::array<Plane, 3> planes_;
};

}  // namespace detail

/// Hourglass control by the stresses that the material itself has beside their mean, so that one layer bends and yields
/// as it should. It has no coefficient.
///
/// On the parallelepiped of the mean edges a_i, the stresses of the hybrid element of Pian and Tong (1986) are the
/// mean; for each direction k a plane stress S_k of the plane of the other edges i and j, linear along k; and bilinear
/// ones, here one vector b. The components of S_k are contravariant, S_k^ij a_i (x) a_j: they go with the edges, so
/// that they need not be turned and the numbering of the corners does not count. The rates q of the hourglass modes
/// strain by
///   D_ii = q_bj . a_i,   D_jj = q_bi . a_j,   2 D_ij = q_bi . a_i + q_bj . a_j
/// along k, to which an elastic step answers by 2 G dt [mu tr(g D) g + g D g], mu = lambda/(lambda + 2 G), with g the
/// inverse of the metric G_ij = a_i . a_j of the plane. In a brick that is the control of Belytschko and Bindeman
/// (1993) and of Puso (2000).
///
/// They flow together with the mean deviator s, radially to the joint yield surface
///   q^2 + 4/9 (q_1^2 + q_2^2 + q_3^2) = Y^2,   q_k the equivalent of S_k,
/// by which a layer has its exact plastic moment; the material hardens by the work that this takes. Of their part along
/// n_ij = a_i . s a_j, which makes the yield function linear along k, is taken moreover as much as a multiplier of the
/// flow can that is linear along k and not negative at the points -+1/sqrt(3).
///
/// A plate has the stresses of the hybrid element of Pian and Sumihara (1984) at each point of its section, and the
/// transverse shears of Dvorkin and Bathe (1984): strike/element/plate_physical.hpp.
///
/// A material without shear modulus, a fluid or what has become one, gets ViscousHourglass.
struct PhysicalHourglass {
  void ranges(const auto&) const {}

  template <class T>
  struct State {
    std::array<PlaneTensor<T>, 3> linear{};    ///< S_k [stress/length^2]
    Vector3<T> bilinear = Vector3<T>::Zero();  ///< b [stress/length]

    auto spatial_tensors() { return std::tie(bilinear); }
  };

  /// Answer to a step.
  template <class T>
  struct Answer {
    HourglassModes<T> resistance;
    T critical_rate;      ///< one over the largest step that this alone allows [1/time]
    T work;               ///< done against it in the step [energy]
    T kept;               ///< share of the mean deviator that the joint return leaves
    T plastic_increment;  ///< of the equivalent plastic strain, beside the flow of the mean
    T flow_stress;        ///< at which that is
  };

  /// Resistance to the rates of the modes beside the stresses, a qdot: in a fluid that of ViscousHourglass. In a solid
  /// whose nodes have the speed s in these modes it is shock viscosity, of the pressure 2 rho s^2 as much as exceeds
  /// the flow stress: where stresses are far beyond it nothing else holds the modes. `overlap` is that of the hourglass
  /// vectors with the gradient, |P gamma|^2/8, by which they are longer than those of a parallelepiped.
  template <class T>
  T damping(const HourglassElement<T>& e, const HourglassModes<T>& rates, const T& overlap,
            const T& flow_stress) const {
    const T per_length_squared = 1.0 / (1.0 + overlap);
    const T speed_squared = T(1.0 / 64.0) * per_length_squared * squared_norm(rates);
    const T excess = max(T(0.0), 2.0 * e.density * speed_squared - flow_stress);
    const T solid =
        0.25 * e.edge * e.edge * per_length_squared * excess * rsqrt(max(T(detail::least_square<T>), speed_squared));
    return select(e.shear_modulus > 0.0, solid, ViscousHourglass{}.damping(e));
  }

  /// Advances the state over the step in which the modes moved to m at the velocities u; d_rate is that of the mode d,
  /// turned to the end of the step; `overlap` as for the damping. `flow` is that of the mean; `yield` gives the flow
  /// stress (point_flow.hpp).
  template <class T, class Yield>
  Answer<T> advance(State<T>& state, const HourglassElement<T>& e, const Hex8Modes<T>& m, const Hex8Modes<T>& u,
                    const HourglassModes<T>& rates, const Vector3<T>& d_rate, const T& overlap,
                    const PointFlow<T>& flow, const Yield& yield) const {
    const T G2 = 2.0 * e.shear_modulus, mu = plane_ratio(e);
    const detail::MeanEdges<T> edges(m);
    const T half_w = half_frequency(e, edges), delay = delay_at(half_w);  // stress += delay dS/dt
    const auto strain_rate = edges.strain(rates, {m.a1 - e.dt * u.a1, m.a2 - e.dt * u.a2, m.a3 - e.dt * u.a3});
    auto stress_rate = edges.stress(mu, strain_rate);
    for (PlaneTensor<T>& rate : stress_rate) rate = G2 * rate;
    const Vector3<T> bilinear_rate = bilinear_modulus(e) * (e.gradient * d_rate);

    auto& [S, b] = state;
    T linear_power = edges.contracted(strain_rate, S), bilinear_power = dot(d_rate, b);  // before the step and after
    S = edges.sum(S, e.dt, stress_rate), b = b + e.dt * bilinear_rate;

    const auto flows = flow.relaxed > 0.0, solid = e.shear_modulus > 0.0;
    const T left = flow.kept(), q_squared = T(4.0 / 9.0) * left * left * edges.equivalent_squared(S);
    const T mean_squared = flow.equivalent * flow.equivalent, all_squared = mean_squared + q_squared;
    const T Y = yield(flows, flow.equivalent, all_squared,
                      [&]() -> T { return T(4.0 / 9.0) * edges.equivalent_squared(stress_rate); });
    const T per_all = rsqrt(all_squared), joint = select(solid, min(T(1.0), Y * per_all), T(1.0));
    const T kept = select(solid, left * joint, T(0.0));
    for (PlaneTensor<T>& S_k : S) S_k = kept * S_k;
    b = kept * b;
    if (any(solid && kept < 1.0)) {
      const auto n = edges.covariant(flow.deviator), C_n = edges.stress(mu, n);
      const T least = T(detail::least_square<T>), most = std::numbers::sqrt3 * (1.0 / max(least, kept) - 1.0);
      for (std::size_t k = 0; k < 3; ++k) {
        const T along = double_dot(n[k], S[k]) / max(least, double_dot(n[k], C_n[k]));
        S[k] = S[k] - T(max(T(-most), min(most, along))) * C_n[k];
      }
    }

    linear_power += edges.contracted(strain_rate, S) + 2.0 * delay * edges.contracted(strain_rate, stress_rate);
    bilinear_power += dot(d_rate, b) + 2.0 * delay * dot(d_rate, bilinear_rate);
    const T M = e.wave_modulus, G = e.shear_modulus, per_E = (M - G) / (G * (3.0 * M - 4.0 * G));
    const T released = (1.0 - joint) * (0.75 * per_E * q_squared + mean_squared / (3.0 * G));  // energy per volume
    const T a = damping(e, rates, overlap, Y);
    Answer<T> answer{
        .resistance = edges.resistance(e.volume, edges.sum(S, delay, stress_rate)),
        .critical_rate = critical_rate(e, half_w) + ViscousHourglass::critical_rate(e, a),
        .work = 0.5 * e.dt * e.volume * (T(1.0 / 3.0) * linear_power + bilinear_power) + e.dt * a * squared_norm(rates),
        .kept = joint,
        .plastic_increment = select(solid, released * per_all, T(0.0)),
        .flow_stress = Y};
    answer.resistance[3] = e.volume * (b + delay * bilinear_rate);
    for (std::size_t k = 0; k < 4; ++k) answer.resistance[k] = answer.resistance[k] + a * rates[k];
    return answer;
  }

  /// Resistance to a small motion, for GlobalStep: of the elastic stresses and their damping in the step, which flow
  /// only lessens.
  template <class T>
  struct Resistance {
    T shear{}, mu{}, bilinear{};  ///< 2 G, mu and the modulus of the mode d [force/length^2], times dt^2/4 and more

    HourglassModes<T> operator()(const Hex8Modes<T>& m, const T& V, const SymmetricTensor<T>& gradient,
                                 const HourglassModes<T>& q) const {
      const detail::MeanEdges<T> edges(m);
      HourglassModes<T> Q = edges.resistance(shear * V, edges.stress(mu, edges.strain(q)));
      Q[3] = (bilinear * V) * (gradient * q[3]);
      return Q;
    }
    Resistance& operator*=(const T& share) {
      shear *= share, bilinear *= share;
      return *this;
    }
  };
  template <class T>
  Resistance<T> resistance(const HourglassElement<T>& e, const Hex8Modes<T>& m) const {
    const T delay = delay_at(half_frequency(e, detail::MeanEdges<T>(m)));
    const T factor = 0.25 * e.dt * e.dt + 0.5 * e.dt * delay;
    return {2.0 * factor * e.shear_modulus, plane_ratio(e), factor * bilinear_modulus(e)};
  }

 private:
  /// The highest frequency of the modes is damped by this share of its critical damping; less and noise in a rotation
  /// would grow.
  static constexpr double damping_ratio = 0.01;

  template <class T>
  static T plane_ratio(const HourglassElement<T>& e) {
    return 1.0 - 2.0 * e.shear_modulus / e.wave_modulus;  // lambda/(lambda + 2 G)
  }
  template <class T>
  static T bilinear_modulus(const HourglassElement<T>& e) {
    return T(1.0 / 36.0) * e.shear_modulus * (1.0 + 0.5 * plane_ratio(e));
  }
  template <class T>
  static T delay_at(const T& half_w) {
    return damping_ratio / max(T(detail::least_square<T>), half_w);
  }
  template <class T>
  static T critical_rate(const HourglassElement<T>& e, const T& half_w) {
    const double xi = damping_ratio;
    return select(e.shear_modulus > 0.0, T((xi + std::sqrt(1 + xi * xi)) * half_w), T(0.0));
  }
  /// Bound of half the highest frequency: w^2/4 <= E/(1 - nu^2) (tr S + L1(S))/(3 rho), found over random shapes. Where
  /// a shape is so distorted that the planes of its mean edges are stiffer than its gradient S, they count.
  template <class T>
  static T half_frequency(const HourglassElement<T>& e, const detail::MeanEdges<T>& edges) {
    const T G = e.shear_modulus, plane_modulus = 4.0 * G * (1.0 - G / e.wave_modulus);
    const auto [sum, largest] = edges.traces();
    const T both = max(e.gradient_squared, 4.0 * sum) + max(e.gradient_eigenvalue, 8.0 * largest);
    return sqrt(T(1.0 / 3.0) * plane_modulus * both / e.density);
  }
};

}  // namespace strike
