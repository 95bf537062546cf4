#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include <strike/element/element.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/error.hpp>
#include <strike/output/history.hpp>
#include <strike/range.hpp>
#include <strike/scalar/dual.hpp>

namespace strike::verify {

/// One element after a step [consistent units]. Energies are those since the start; that of the prescribed motion is
/// the sum of the other three but for the error of the step.
template <class E>
struct ElementRecord {
  double time = 0;
  typename E::Kinematics::template Stress<double> stress{};  ///< in the material, the mean over its points
  double volume = 0;                                         ///< of a plate the area
  double stable_step = 0;                                    ///< that the element claims
  Nodal<double, E::nodes> x;
  Nodal<double, motions<E>> force;  ///< external ones on the element's nodes, then the moments
  double internal = 0;              ///< work of the stresses
  double hourglass = 0;             ///< work against the hourglass control
  double bulk_viscosity = 0;        ///< dissipated by the bulk viscosity
  double external = 0;  ///< work of the prescribed motion, by the mean of the forces before and after a step
};

/// Linearised forces of an element on its coordinates, node after node: f = K x + C v, with the mass m at each node.
/// Rotations are lengths, the radius of gyration times the angle, so that their mass is m too.
template <class T = double>
struct ElementVibration {
  using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix stiffness, damping;
  T mass = 0;

  /// Angular frequencies without damping, ascending.
  Eigen::Matrix<T, Eigen::Dynamic, 1> frequencies() const {
    const Eigen::SelfAdjointEigenSolver<Matrix> modes(stiffness, Eigen::EigenvaluesOnly);
    return (modes.eigenvalues() / mass).cwiseMax(0).cwiseSqrt();
  }

  /// The largest stable step of central differences whose damping lags half a step,
  ///   m (v+ - v)/dt = -K x - C v,   x+ = x + dt v+.
  /// A motion phi l^n with k = dt^2 phi.K phi/m and c = dt phi.C phi/m has l^2 + (k + c - 2) l + 1 - c = 0, which is
  /// stable for k/4 + c/2 <= 1. The step at which the first phi gets there is found from below by Newton's method: phi
  /// is the highest mode of K/4 + C/(2 dt) at the step of the phi before.
  double critical_step() const {
    double rate = 0;
    for (int i = 0; i < 30; ++i) {
      const Matrix both = 0.25 * stiffness + 0.5 * rate * damping;
      const Eigen::SelfAdjointEigenSolver<Matrix> modes(both);
      const auto phi = modes.eigenvectors().col(stiffness.rows() - 1);
      const double k = phi.dot(stiffness * phi) / mass, c = phi.dot(damping * phi) / mass;
      const double before = std::exchange(rate, Vibration<double>{k, c}.critical_rate());
      if (rate <= before * (1 + 1e-14)) break;
    }
    return 1 / rate;
  }

  /// The largest |l| of the same scheme by its amplification matrix: above 1 the step dt is unstable.
  double spectral_radius(double dt) const {
    const Eigen::Index n = stiffness.rows();
    const auto one = Matrix::Identity(n, n);
    Matrix amplification(2 * n, 2 * n);  // of (x, dt v)
    const Matrix k = dt * dt / mass * stiffness, c = dt / mass * damping;
    amplification << one - k, one - c, -k, one - c;
    return amplification.eigenvalues().cwiseAbs().maxCoeff();
  }
};

/// One element under a prescribed motion of its nodes: for verifying an element, or a material in an element.
///   SingleElement cube{Hex8{}, copper, unit_cube()};
///   const auto history = cube.run(motion::homogeneous(L), dt, 100);
///   write("shear.csv", history);
template <class E, class M>
class SingleElement {
 public:
  static constexpr int n = E::nodes;
  using Vectors = Nodal<double, motions<E>>;  ///< a column per node, and per node that turns
  using Positions = Nodal<double, n>;
  using Record = ElementRecord<E>;

  /// At rest at the positions X. Errors: no positive mass.
  SingleElement(E element, M material, const Positions& X)
      : element_(std::move(element)), material_(std::move(material)) {
    detail::check_ranges(element_), detail::check_ranges(material_);
    record_.x = X;
    weigh(element_.begin(state_, material_, X));
    if (!(mass_ > 0))
      throw Error("strike: the SingleElement has no positive mass: give its corners in the right order, none twice.");
    if constexpr (requires { material_.is_aligned(state_.material, std::size_t{}); })
      if (!material_.is_aligned(state_.material, 0))
        throw Error("strike: the FibreDirection is normal to the plate of the SingleElement; choose another.");
    const auto response = element_.advance(state_, material_, X, Vectors::Zero().eval(), 0.0);
    record_.stress = mean_stress();
    record_.force = response.force;
    record_.volume = response.volume;
    record_.stable_step = 1 / response.critical_rate;
  }

  /// Moves the nodes at the velocities v for the time dt.
  const Record& step(const Vectors& v, double dt) {
    record_.time += dt;
    record_.x += dt * v.template leftCols<n>();
    const auto response = element_.advance(state_, material_, record_.x, v, dt);
    record_.stress = mean_stress();
    record_.volume = response.volume;
    record_.stable_step = 1 / response.critical_rate;
    record_.internal += response.internal_work;
    record_.hourglass += response.hourglass_work;
    record_.bulk_viscosity += response.bulk_viscosity_work;
    record_.external += 0.5 * dt * (record_.force + response.force).cwiseProduct(v).sum();
    record_.force = response.force;
    return record_;
  }

  /// Takes steps of dt with the nodes at the velocities motion(x, t), a column per node, of the middle of each step, so
  /// that a rotation is exact. Nodes that turn have angular velocities in further columns, else
  /// motion.angular_velocity(), else none. Returns the record of every step, the present one first.
  template <class VelocityField>
  std::vector<Record> run(const VelocityField& motion, double dt, std::size_t steps) {
    std::vector<Record> history{record_};
    for (std::size_t i = 0; i < steps; ++i) {
      Vectors v = all_velocities(motion, record_.x, record_.time + 0.5 * dt);
      for (int k = 0; k < 100; ++k) {
        const Vectors before = v;
        v = all_velocities(motion, record_.x + 0.5 * dt * v.template leftCols<n>(), record_.time + 0.5 * dt);
        if ((v - before).norm() <= 1e-16 * v.norm()) break;
      }
      history.push_back(step(v, dt));
    }
    return history;
  }

  /// Its free vibrations about where it stands, from the exact derivatives of its forces by dual numbers. Bulk
  /// viscosity, which acts in compression only, shows if the nodes move, at `velocities`.
  ElementVibration<> vibration(const Vectors& velocities = Vectors::Zero()) const {
    const double dt = 1e-6 * record_.stable_step;
    const Eigen::MatrixXd one = slope(velocities, dt), two = slope(velocities, 2 * dt);  // dt K + C
    const auto symmetric = [](const Eigen::MatrixXd& A) -> Eigen::MatrixXd { return 0.5 * (A + A.transpose()); };
    return {.stiffness = symmetric((two - one) / dt), .damping = symmetric(2 * one - two), .mass = mass_};
  }

  const Record& now() const { return record_; }
  const M& material() const { return material_; }
  const auto& state() const { return state_; }
  double nodal_mass() const { return mass_; }
  double nodal_inertia() const { return mass_ * gyration_squared_; }

 private:
  using State = typename E::template State<M, double>;

  template <class VelocityField>
  static Vectors all_velocities(const VelocityField& motion, const Positions& x, double time) {
    const auto given = motion(x, time);
    if constexpr (motions<E> == n || std::decay_t<decltype(given)>::ColsAtCompileTime == motions<E>) {
      return given;
    } else {
      Vectors v = Vectors::Zero();
      v.template leftCols<n>() = given;
      if constexpr (requires { motion.angular_velocity(); })
        v.template rightCols<n>().colwise() = motion.angular_velocity();
      return v;
    }
  }

  void weigh(double mass) { mass_ = mass; }
  void weigh(const NodalInertia<double>& given) {
    mass_ = given.mass;
    gyration_squared_ = given.inertia / given.mass;
  }

  typename E::Kinematics::template Stress<double> mean_stress() const {
    if constexpr (requires { material_.stress(state_.material); }) {
      return material_.stress(state_.material);
    } else {
      typename E::Kinematics::template Stress<double> sum{};
      double points = 0;
      state_.each_point([&](const auto& state) { sum += material_.stress(state), points += 1; });
      return (1 / points) * sum;
    }
  }

  /// df/dv over a step dt that ends where the element stands, but for what v changes.
  Eigen::MatrixXd slope(const Vectors& velocities, double dt) const {
    using D = Dual<double, 3>;
    constexpr int m = motions<E>;
    Eigen::MatrixXd A(3 * m, 3 * m);
    for (int node = 0; node < m; ++node) {
      typename E::template State<M, D> state;
      std::ranges::copy(numbers_of<double>(state_), numbers_of<D>(state).begin());
      Nodal<D, n> x = record_.x.template cast<D>();
      Nodal<D, m> v = velocities.template cast<D>();
      for (int i = 0; i < 3; ++i) {
        const D change = D::variable(0, static_cast<std::size_t>(i));
        if (node < n) x(i, node) += dt * change;
        v(i, node) += change;
      }
      const Nodal<D, m> force = element_.advance(state, material_, x, v, dt).force;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3 * m; ++k) A(k, 3 * node + i) = force(k).derivative(static_cast<std::size_t>(i));
    }
    if constexpr (m > n) {
      A.bottomRows(3 * n) *= 1 / std::sqrt(gyration_squared_);
      A.rightCols(3 * n) *= 1 / std::sqrt(gyration_squared_);
    }
    return A;
  }

  E element_;
  M material_;
  State state_{};
  double mass_ = 0, gyration_squared_ = 0;
  Record record_;
};

namespace detail {
using namespace strike::detail;

/// A stress component in a table.
struct Component {
  const char* name;
  double value;
};
inline std::vector<Component> components(const SymmetricTensor<double>& s) {
  return {{"stress xx", s.xx}, {"stress yy", s.yy}, {"stress zz", s.zz},
          {"stress xy", s.xy}, {"stress yz", s.yz}, {"stress zx", s.zx}};
}
inline std::vector<Component> components(const PlateKinematics::Stress<double>& s) {
  return {{"force xx", s.force.xx},   {"force yy", s.force.yy},   {"force xy", s.force.xy}, {"moment xx", s.moment.xx},
          {"moment yy", s.moment.yy}, {"moment xy", s.moment.xy}, {"shear x", s.shear(0)},  {"shear y", s.shear(1)}};
}

}  // namespace detail

/// Writes the records as CSV: time, Cauchy stress (of a plate the resultants), volume, stable step, energies, and the
/// force on each node, and the moment if it turns.
template <class E>
void write(const std::string& path, const std::vector<ElementRecord<E>>& history) {
  std::vector<Column> columns{{"time"}};
  for (const auto& component : detail::components(ElementRecord<E>{}.stress)) columns.push_back({component.name});
  for (const char* quantity :
       {"volume", "stable step", "internal energy", "hourglass energy", "bulk viscosity energy", "external energy"})
    columns.push_back({quantity});
  for (int i = 0; i < motions<E>; ++i)
    for (const char* axis : {" x", " y", " z"})
      columns.push_back({detail::joined({i < E::nodes ? "force " : "moment ", std::to_string(i % E::nodes), axis})});

  History file(path, columns);
  for (const ElementRecord<E>& r : history) {
    std::vector<double> row{r.time};
    for (const auto& component : detail::components(r.stress)) row.push_back(component.value);
    row.insert(row.end(), {r.volume, r.stable_step, r.internal, r.hourglass, r.bulk_viscosity, r.external});
    row.insert(row.end(), r.force.data(), r.force.data() + r.force.size());
    file.row(row);
  }
}

/// Velocities of the nodes of a SingleElement: functions of their positions, a column per node, and the time.
namespace motion {

/// v = L x; nodes that turn do so with its spin.
struct Homogeneous {
  Eigen::Matrix3d L;

  template <class Positions>
  Positions operator()(const Positions& x, double) const {
    return L * x;
  }
  Eigen::Vector3d angular_velocity() const { return axial_vector<double>(L); }
};
inline Homogeneous homogeneous(const Eigen::Matrix3d& L) { return {L}; }

/// v = w cross x.
inline auto rotation(const Eigen::Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return homogeneous(W);
}

/// v = f(x), any function of a position.
template <class F>
auto field(F f) {
  return [f](const auto& x, double) {
    auto v = x.eval();
    for (Eigen::Index i = 0; i < x.cols(); ++i) v.col(i) = f(Eigen::Vector3d(x.col(i)));
    return v;
  };
}

/// A mode of the hexahedron's corners: +-a by the sign of eta zeta (k = 0), zeta xi (1), xi eta (2) or xi eta zeta (3).
inline auto hourglass(int k, const Eigen::Vector3d& a) {
  Eigen::Matrix<double, 4, 8> signs;
  signs << 1, 1, -1, -1, -1, -1, 1, 1,  //
      1, -1, -1, 1, -1, 1, 1, -1,       //
      1, -1, 1, -1, 1, -1, 1, -1,       //
      -1, 1, -1, 1, 1, -1, 1, -1;
  return [v = (a * signs.row(k)).eval()](const auto&, double) { return v; };
}

}  // namespace motion

/// Corners of the cube [0, 1]^3.
inline Nodal<double, 8> unit_cube() {
  Nodal<double, 8> x;
  x << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,   //
      0, 0, 0, 0, 1, 1, 1, 1;
  return x;
}

/// Corners of the square [0, 1]^2 in the plane z = 0.
inline Nodal<double, 4> unit_square() { return unit_cube().leftCols<4>(); }

/// Corners of the triangle with two unit edges along x and y.
inline Nodal<double, 3> unit_triangle() {
  Nodal<double, 3> x;
  x << 0, 1, 0,  //
      0, 0, 1,   //
      0, 0, 0;
  return x;
}

/// Corners of the tetrahedron with three unit edges along the axes.
inline Nodal<double, 4> unit_tetrahedron() {
  Nodal<double, 4> x;
  x << 0, 1, 0, 0,  //
      0, 0, 1, 0,   //
      0, 0, 0, 1;
  return x;
}

/// The undistorted corners of an element of unit size, for kinds and numbers of nodes with known corners.
template <class E>
Nodal<double, E::nodes> unit_corners() {
  constexpr bool plate = std::same_as<typename E::Kinematics, PlateKinematics>;
  static_assert(E::nodes == 4 || (E::nodes == 8 && !plate) || (E::nodes == 3 && plate),
                "strike: the undistorted shape of this element is not known: give its corners.");
  if constexpr (E::nodes == 8)
    return unit_cube();
  else if constexpr (E::nodes == 3)
    return unit_triangle();
  else if constexpr (plate)
    return unit_square();
  else
    return unit_tetrahedron();
}

}  // namespace strike::verify
