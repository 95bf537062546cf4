#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/range.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/text.hpp>

namespace strike {

/// A VUMAT, the user material of Abaqus/Explicit, that was compiled for numbers Real (Abaqus User Subroutines Guide,
/// "VUMAT"). By this type a routine is declared in one line, whether Fortran or C wrote it:
///   extern "C" strike::VumatRoutine<double> vumat_;
/// Arrays run over the points of a block first; symmetric tensors are 11 22 33 12 23 31, shears not doubled. The last
/// argument is the length of cmname, which Fortran passes unseen.
template <class Real>
using VumatRoutine = void(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
                          const int* nprops, const int* lanneal, const Real* stepTime, const Real* totalTime,
                          const Real* dt, const char* cmname, const Real* coordMp, const Real* charLength,
                          const Real* props, const Real* density, const Real* strainInc, const Real* relSpinInc,
                          const Real* tempOld, const Real* stretchOld, const Real* defgradOld, const Real* fieldOld,
                          const Real* stressOld, const Real* stateOld, const Real* enerInternOld,
                          const Real* enerInelasOld, const Real* tempNew, const Real* stretchNew,
                          const Real* defgradNew, const Real* fieldNew, Real* stressNew, Real* stateNew,
                          Real* enerInternNew, Real* enerInelasNew, std::size_t cmname_length);

/// Options of a Vumat.
template <class Real>
struct VumatOptions {
  VumatRoutine<Real>* routine;
  double density;                         ///< in the undeformed configuration
  std::vector<Real> properties{};         ///< props
  std::vector<Real> initial_variables{};  ///< stateOld at rest; zero unless given
  std::string_view name = "STRIKE";       ///< cmname, of which 80 characters count
  Eigen::Vector3d axis_1{1, 0, 0};        ///< of the routine's frame, at rest
  Eigen::Vector3d axis_2{0, 1, 0};        ///< in the plane of its axes 1 and 2
  Real temperature = 0;                   ///< tempOld and tempNew
  Real characteristic_length = 0;  ///< charLength of every element, if the routine uses it; 0: it gets NaN [length]
  double stiffening = 1;           ///< largest ratio of later moduli to the first

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("properties", properties, range::finite);
    number("initial_variables", initial_variables, range::finite);
    number("axis_1", axis_1, range::direction);
    number("axis_2", axis_2, range::direction);
    number("sine of the angle from axis_1 to axis_2", axis_1.normalized().cross(axis_2.normalized()).norm(),
           range::at_least(1e-6), "turn one of them");
    number("temperature", temperature, range::finite);
    number("characteristic_length", characteristic_length, range::not_negative);
    number("stiffening", stiffening, range::at_least(1));
  }
};

namespace detail {

/// n times the same number.
template <class Real, std::size_t n>
constexpr std::array<Real, n> repeated(Real value) {
  std::array<Real, n> numbers{};
  for (Real& number : numbers) number = value;
  return numbers;
}

/// Largest eigenvalue of a symmetric matrix from above, to 3e-5: lambda^p <= tr A^p with p = 2^16, of six eigenvalues.
template <class Matrix>
double largest_eigenvalue_of(Matrix A) {
  double root = 1, p = 1;
  for (int i = 0; i < 16; ++i, p *= 2) {
    const double scale = A.norm();
    if (!(scale > 0)) return scale;
    A = (A / scale).eval();
    A = (A * A).eval();
    root *= std::pow(scale, 1 / p);
  }
  return root * std::pow(A.trace(), 1 / p);
}

/// Moduli that bound the stiffness C (symmetric tensors by 11 22 33 and sqrt(2) times 12 23 31), of any symmetry:
///   D.C D <= (K - 2 G/3) tr(D)^2 + 2 G D:D   for every D.
/// With C_v of the volume v = (1 1 1 0 0 0)/sqrt(3), C_d of the deviators and c = C_d v between the two,
/// 3 K = C_v + |c| and 2 G = lambda_max(C_d) + |c| do; if C is isotropic c = 0, and they are its own.
template <class Matrix>
Moduli<double> bounding_moduli(const Matrix& C) {
  using Vector = Eigen::Matrix<typename Matrix::Scalar, 6, 1>;
  const Vector v = Vector{1, 1, 1, 0, 0, 0} / std::sqrt(3.0);
  const Matrix P = Matrix::Identity() - v * v.transpose(), S = 0.5 * (C + C.transpose());
  const double coupling = (P * S * v).norm();
  return {(v.dot(S * v) + coupling) / 3, 0.5 * (largest_eigenvalue_of<Matrix>(P * S * P) + coupling)};
}

}  // namespace detail

/// A user material of the field: a routine in the shape of a VUMAT, with `states` state variables, that runs on blocks
/// of the lanes of a Pack, or on one point.
///   const Vumat<2> copper{{.routine = vumat_, .density = 8930, .properties = {130e9, 43.3e9, 400e6, 100e6}}};
/// The routine gets stress, strain increment and state variables in a frame that turns with the spin of the material
/// (so relSpinInc is 0) and starts at `axis_1`, `axis_2`, and the density in the middle of the step. stretchOld/New,
/// defgradOld/New and coordMp are NaN, because a material knows neither; nfieldv is 0. The moduli of the stable step,
/// of hourglass control and of bulk viscosity are those of the routine's first call, at stepTime = totalTime = 0 with
/// small strains, times `stiffening`. A routine that runs in threads must not keep anything in static memory. Errors:
/// no routine; no elastic stress from the first call.
template <int states, class Real = double>
class Vumat {
  static_assert(states >= 0, "strike: the number of state variables of a Vumat must not be negative.");
  static_assert(std::is_floating_point_v<Real>, "strike: a Vumat is compiled for double or for float.");

  static constexpr std::size_t variables = states > 0 ? states : 1;

  /// Variables that the routine advances.
  template <class T>
  struct Point {
    SymmetricTensor<T> stress{};          ///< Cauchy
    std::array<T, variables> variable{};  ///< stateOld, stateNew
    T specific_internal_energy{};         ///< enerInternOld, enerInternNew, per mass
    T specific_inelastic_energy{};        ///< enerInelasOld, enerInelasNew
  };

 public:
  using Kinematics = SolidKinematics;

  template <class T>
  struct State : Point<T> {
    Vector3<T> axis_1 = Vector3<T>::Unit(0), axis_2 = Vector3<T>::Unit(1);  ///< of the routine's frame, in space
    T time{};  ///< since the start, the largest of the lanes [time]

    auto spatial_tensors() { return std::tie(this->stress, axis_1, axis_2); }
  };

  explicit Vumat(VumatOptions<Real> options) : options_(std::move(options)) {
    if (!options_.routine) throw Error("strike: a Vumat has no routine; give it one, such as .routine = vumat_.");
    detail::check_ranges(options_);
    name_.fill(' ');
    std::copy_n(options_.name.begin(), std::min(options_.name.size(), name_.size()), name_.begin());
    options_.initial_variables.resize(variables);
    const Moduli<double> elastic = first_call();
    if (!(elastic.wave() > 0 && std::isfinite(elastic.wave())))
      throw Error(detail::joined({"strike: the first call of the VUMAT '", options_.name,
                                  "', with strains of 1e-6, gives the wave modulus K + 4/3 G = ",
                                  detail::text(elastic.wave()), "; correct its properties."}));
    moduli_ = {options_.stiffening * elastic.bulk, options_.stiffening * elastic.shear};
  }

  double density() const { return options_.density; }

  template <class T>
  void begin(State<T>& state) const {
    state = {};
    for (std::size_t i = 0; i < variables; ++i) state.variable[i] = T(options_.initial_variables[i]);
    state.axis_1 = options_.axis_1.template cast<T>();
    state.axis_2 = options_.axis_2.template cast<T>();
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    static_assert(std::is_floating_point_v<LaneOf<T>>, "strike: a Vumat runs on plain numbers, not on dual ones.");
    if (!(dt > 0)) return state.stress;  // it may divide by dt
    using Number = std::conditional_t<lanes<T> == 1, Real, Pack<Real, lanes<T>>>;
    const SymmetricTensor<T> strain = T(dt) * rate.rate_of_deformation;
    const T& J = rate.relative_volume;
    const T J_mid = J - 0.5 * volume_increment<T>(J, trace(strain));
    state.time = T(reduce_max(state.time) + static_cast<RealOf<T>>(dt));

    const Matrix3<T> to_space = frame(state), to_frame = to_space.transpose();
    Point<T> in_frame = state;
    in_frame.stress = rotated(to_frame, state.stress);
    const Point<Number> now =
        called<Number>(as<Number>(in_frame), as<Number>(rotated(to_frame, strain)), Number(options_.density / J_mid),
                       static_cast<Real>(lane(state.time, 0)), static_cast<Real>(dt));
    static_cast<Point<T>&>(state) = as<T>(now);
    return state.stress = rotated(to_space, state.stress);
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }

  template <class T>
  Moduli<T> moduli(const State<T>&, const SolidKinematics::Rate<T>&) const {
    return {T(moduli_.bulk), T(moduli_.shear)};
  }

 private:
  /// The numbers of an aggregate as another kind of number.
  template <class To, template <class> class Aggregate, class From>
  static Aggregate<To> as(const Aggregate<From>& from) {
    Aggregate<To> to;
    const auto source = numbers_of<From>(from);
    const auto target = numbers_of<To>(to);
    for (std::size_t i = 0; i < target.size(); ++i) target[i] = static_cast<To>(source[i]);
    return to;
  }

  /// The axes as columns, made orthonormal again after a rotation.
  template <class T>
  static Matrix3<T> frame(State<T>& state) {
    const Vector3<T> a = rsqrt(dot(state.axis_1, state.axis_1)) * state.axis_1;
    const Vector3<T> across = state.axis_2 - dot(a, state.axis_2) * a, b = rsqrt(dot(across, across)) * across;
    state.axis_1 = a, state.axis_2 = b;
    return columns(a, b, cross(a, b));
  }

  /// A Pack of numbers, or several, as the routine's array.
  template <class Numbers>
  static Real* array(Numbers& numbers) {
    return reinterpret_cast<Real*>(&numbers);
  }
  template <class Numbers>
  static const Real* array(const Numbers& numbers) {
    return reinterpret_cast<const Real*>(&numbers);
  }

  template <class Number>
  Point<Number> called(const Point<Number>& old, const SymmetricTensor<Number>& strain, const Number& density,
                       Real time, Real dt) const {
    constexpr std::size_t width = lanes<Number>;
    static constexpr auto unknown = detail::repeated<Real, 9 * width>(std::numeric_limits<Real>::quiet_NaN());
    static constexpr auto spin = detail::repeated<Real, 3 * width>(0);
    const int nblock = width, ndir = 3, nshr = 3, nstatev = states, none = 0;
    const int nprops = static_cast<int>(options_.properties.size());
    const Number temperature(options_.temperature),
        length(options_.characteristic_length > 0 ? options_.characteristic_length
                                                  : std::numeric_limits<Real>::quiet_NaN());
    Point<Number> now = old;
    options_.routine(&nblock, &ndir, &nshr, &nstatev, &none, &nprops, &none, &time, &time, &dt, name_.data(),
                     unknown.data(), array(length), options_.properties.data(), array(density), array(strain),
                     spin.data(), array(temperature), unknown.data(), unknown.data(), unknown.data(), array(old.stress),
                     array(old.variable), array(old.specific_internal_energy), array(old.specific_inelastic_energy),
                     array(temperature), unknown.data(), unknown.data(), unknown.data(), array(now.stress),
                     array(now.variable), array(now.specific_internal_energy), array(now.specific_inelastic_energy),
                     name_.size());
    return now;
  }

  /// The moduli of the answer to six strains, one a lane.
  Moduli<double> first_call() const {
    using Number = Pack<Real, 8>;
    constexpr Real e = Real(1e-6);
    Point<Number> old;
    for (std::size_t i = 0; i < variables; ++i) old.variable[i] = Number(options_.initial_variables[i]);
    SymmetricTensor<Number> strain{};
    const auto strains = numbers_of<Number>(strain);
    for (std::size_t c = 0; c < 6; ++c) strains[c].set(c, e);
    const Number density = options_.density * (1.0 - 0.5 * trace(strain));
    const Point<Number> now = called<Number>(old, strain, density, 0, 1);

    Eigen::Matrix<double, 6, 6> C;
    const auto stresses = numbers_of<Number>(now.stress);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) {
        const double shears = (i < 3 ? 1 : std::sqrt(2.0)) / (j < 3 ? 1 : std::sqrt(2.0));
        C(static_cast<int>(i), static_cast<int>(j)) = shears * static_cast<double>(stresses[i][j] / e);
      }
    return detail::bounding_moduli(C);
  }

  VumatOptions<Real> options_;
  std::array<char, 80> name_;
  Moduli<double> moduli_{};
};

}  // namespace strike
