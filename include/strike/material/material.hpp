#pragma once
#include <concepts>
#include <tuple>
#include <type_traits>

#include <strike/material/kinematics.hpp>
#include <strike/material/report.hpp>
#include <strike/protocol.hpp>

namespace strike {

/// The density of a material in its reference configuration, a member `density` or the function `density()`: mass per
/// volume, of a plate's section per area.
template <class M>
  requires requires(const M m) {
    { m.density() } -> std::convertible_to<double>;
  }
double density_of(const M& material) {
  return material.density();
}
template <class M>
  requires requires(const M m) {
    { m.density } -> std::convertible_to<double>;
  }
double density_of(const M& material) {
  return material.density;
}
namespace detail {
/// Bounds of the tangent of a material that has not moved.
template <class M>
auto moduli_at_rest(const M& material) {
  typename M::template State<double> state{};
  if constexpr (requires { material.begin(state); }) material.begin(state);
  typename M::Kinematics::template Rate<double> rate{};
  if constexpr (requires { rate.shear.setZero(); }) rate.shear.setZero();
  return material.moduli(state, rate);
}
}  // namespace detail

/// A material: the rate of deformation in, the stress out. It knows no rotation, no mesh and no time loop.
///
/// Requirements
/// 1. `Kinematics`: its pair of measure and stress (strike/material/kinematics.hpp).
/// 2. `State<T>`: its memory, an aggregate of numbers T that starts at rest.
/// 3. `density`: a number or a function without arguments, see density_of.
/// 4. `stress(state, rate, dt)`: advances the state over dt and returns the stress at its end.
/// 5. `stress(state)`: the part of the stress that the state remembers.
/// 6. `moduli(state, rate)`: bounds of the tangent, as the pair names them.
/// All are templates over the number T.
/// Of a section also
/// 7. `thickness()` [length] and `rotary_inertia()`, int rho z^2 dz [mass].
/// Of a plane material in a Layer also
/// 8. `normal_rate(state, rate, dt, change)`: d_zz of the step dt > 0 in which the stress changed by `change` [1/time].
/// Optional
///  9. `begin(state)`: the state at rest, where it is not zero; of solids also `begin(state, place)` beside it, at a
///     place [length].
/// 10. `intact(state)`: 1, or 0 where the point has failed; it then counts no more.
/// 11. `viscosity()`: eta of the part of the stress that is not remembered, 2 eta dev(D) [stress time].
/// 12. `warning()`: a text for the user, empty if there is nothing to say.
/// 13. `State::spatial_tensors()`: a tuple of references to the tensors and vectors that the element turns.
/// 14. `State::internal_energy`: per reference volume; the element adds what shock viscosity dissipates.
/// 15. `stresses(points, rates, dt)` of a plane material: stress(...) of an array of points at once.
/// 16. `ranges(number)`: what its numbers may be (strike/range.hpp).
/// 17. Of a solid or plane material that flows, by which PhysicalHourglass yields: `equivalent_plastic_strain` in its
///     State; `flow_stress(state, rate)` [stress] of the rate of plastic strain [1/time], and
///     `flow_is_rate_independent`; `flow(state, kept, increment, flow_stress)`, flow beyond that of the mean stress
///     (strike/material/solid.hpp).
/// 18. `has_shear_modulus`: false, if the shear modulus is always 0, so that no hourglass control looks for one.
/// 19. Of a section, by which the linear stresses of PhysicalHourglass follow its points: `LinearState<T>` and
///     stress(state, linear, rate, linear_rate, dt, resultants) (strike/section/linear_stress.hpp).
/// 20. Of a plane material with fibres, which answers in axes of its own: `plane_stiffness()`, `transverse_stiffness()`
///     and `fibre_angle()`, by which a section turns it (strike/material/orthotropic_ply.hpp).
/// 21. Of a section, whose plates have a direction: `align(state, e1, e2)` after begin, of the axes of their frame, and
///     `is_aligned(state, lane)`, false if that direction is normal to the plate (strike/section/fibres.hpp).
/// Laws (tests/conformance): at rest the stress does not grow (but where a viscoelastic one recovers); lane i of a pack
/// gives what a double gives; a closed cycle of strain gives no energy back; rho c^2 + 2 viscosity/dt bounds the
/// tangent; in a step without time, dt = 0, the remembered stress stays and a section's normal_rate is finite.
/// Models: Elastic, Solid, Fluid, Explosive, Vumat (solids); PlaneStress, ZeroNormalStress, OrthotropicPly, FailingPly
/// (planes); Layered, Homogeneous (sections).
template <class M, class T = double>
concept Material =
    requires(const M m, typename M::template State<T> state, typename M::Kinematics::template Rate<T> rate, double dt) {
      { density_of(m) } -> std::convertible_to<double>;
      { m.stress(state, rate, dt) } -> std::same_as<typename M::Kinematics::template Stress<T>>;
      { m.stress(state) } -> std::convertible_to<typename M::Kinematics::template Stress<T>>;
      { m.moduli(state, rate) } -> std::same_as<typename M::Kinematics::template Moduli<T>>;
    };

/// Materials of solid elements.
template <class M>
concept SolidMaterial = Material<M> && std::same_as<typename M::Kinematics, SolidKinematics>;
/// Materials of the layers of a plate.
template <class M>
concept PlaneMaterial = Material<M> && std::same_as<typename M::Kinematics, PlaneStressKinematics>;
/// Sections, the materials of plates.
template <class M>
concept PlateSection = Material<M> && std::same_as<typename M::Kinematics, PlateKinematics> && requires(const M m) {
  { m.thickness() } -> std::convertible_to<double>;
  { m.rotary_inertia() } -> std::convertible_to<double>;
};

/// The shear modulus of the material may be above 0.
template <class M>
constexpr bool has_shear_modulus() {
  if constexpr (requires { M::has_shear_modulus; })
    return M::has_shear_modulus;
  else
    return true;
}

namespace detail {

struct Begin {
  struct Decoy {
    int begin;
  };
  template <class Model>
  using Member = decltype(&Model::begin);
  template <class Model>
  using Specialised = decltype(&Model::template begin<double>);
  static auto call(const auto& material, auto& state) -> decltype(material.begin(state)) {
    return material.begin(state);
  }
};
struct BeginAtPlace : Begin {
  static auto call(const auto& material, auto& state, const auto& place) -> decltype(material.begin(state, place)) {
    return material.begin(state, place);
  }
};
struct IntactFlag {
  struct Decoy {
    int intact;
  };
  template <class Model>
  using Member = decltype(&Model::intact);
  template <class Model>
  using Specialised = decltype(&Model::template intact<double>);
  static auto call(const auto& material, const auto& state) -> decltype(double(material.intact(state))) {
    return material.intact(state);
  }
};
struct ViscosityNumber {
  struct Decoy {
    int viscosity;
  };
  template <class Model>
  using Member = decltype(&Model::viscosity);
  template <class Model>
  using Specialised = decltype(&Model::template viscosity<double>);
  static auto call(const auto& material) -> decltype(double(material.viscosity())) { return material.viscosity(); }
};
template <class Tuple>
inline constexpr bool are_references = false;
template <class... Tensors>
inline constexpr bool are_references<std::tuple<Tensors&...>> = !(std::is_const_v<Tensors> || ...);
struct SpatialTensors {
  struct Decoy {
    int spatial_tensors;
  };
  template <class State>
  using Member = decltype(&State::spatial_tensors);
  template <class State>
  static auto call(State& state) -> std::enable_if_t<are_references<decltype(state.spatial_tensors())>> {}
};

/// Flaws of what a material of a user's own has beside its requirements, in the order in which they are reported.
enum class MaterialFlaw { none, in_double, section, begin, intact, viscosity, warning, tensors };
template <class M>
constexpr MaterialFlaw material_flaw() {
  if constexpr (!Material<M>)
    return MaterialFlaw::none;  // to be reported by what takes a material
  else {
    using State = typename M::template State<double>;
    if constexpr (!Material<M, TrialLanes>)
      return MaterialFlaw::in_double;
    else if constexpr (std::same_as<typename M::Kinematics, PlateKinematics> && !PlateSection<M>)
      return MaterialFlaw::section;
    else if constexpr (misfits<Begin, const M, State> &&
                       !answers<BeginAtPlace, const M, State, const Eigen::Matrix<double, 3, 1>>)
      return MaterialFlaw::begin;
    else if constexpr (misfits<IntactFlag, const M, const State>)
      return MaterialFlaw::intact;
    else if constexpr (misfits<ViscosityNumber, const M>)
      return MaterialFlaw::viscosity;
    else if constexpr (misfits<Warning, const M>)
      return MaterialFlaw::warning;
    else if constexpr (misfits<SpatialTensors, State>)
      return MaterialFlaw::tensors;
    else
      return MaterialFlaw::none;
  }
}

/// Reports what a piece of a scene, a material or an element, has nearly right; `flawless` says whether there is a
/// flaw.
template <class Piece>
struct Report {};
template <class Piece>
inline constexpr bool flawless = true;

/// A piece that is composed of others, and has reported on them.
template <class Piece>
concept Composed = requires { requires std::same_as<decltype(Piece::sound), const bool>; };
template <Composed Piece>
inline constexpr bool flawless<Piece> = Piece::sound;

template <class M>
concept OwnMaterial = Material<M> && !Composed<M> && !requires { M::nodes; };
template <OwnMaterial M>
inline constexpr bool flawless<M> = material_flaw<M>() == MaterialFlaw::none;
template <OwnMaterial M>
struct Report<M> {
  static constexpr MaterialFlaw flaw = material_flaw<M>();
  static_assert(flaw != MaterialFlaw::in_double,
                "strike: a function of this material takes double alone: make stress, moduli and State templates over "
                "the number T.");
  static_assert(flaw != MaterialFlaw::section,
                "strike: a section needs thickness() and rotary_inertia() beside the functions of a material.");
  static_assert(flaw != MaterialFlaw::begin,
                "strike: begin of a material is template <class T> void begin(State<T>& state) const, or that with a "
                "place; this one has other arguments.");
  static_assert(flaw != MaterialFlaw::intact,
                "strike: intact of a material is template <class T> T intact(const State<T>& state) const; this one "
                "has other arguments or another result.");
  static_assert(flaw != MaterialFlaw::viscosity,
                "strike: viscosity of a material is double viscosity() const; this one has other arguments or another "
                "result.");
  static_assert(flaw != MaterialFlaw::warning,
                "strike: warning of a material is std::string warning() const; this one has other arguments or another "
                "result.");
  static_assert(flaw != MaterialFlaw::tensors,
                "strike: spatial_tensors of a State is auto spatial_tensors() { return std::tie(...); }, not const; "
                "this one returns no references that an element could turn.");

  static void try_on_lanes([[maybe_unused]] const M& material) {
    if constexpr (flaw == MaterialFlaw::none) {
      typename M::template State<TrialLanes> state{};
      const typename M::Kinematics::template Rate<TrialLanes> rate{};
      (void)material.stress(state, rate, 1.0);
      (void)material.moduli(state, rate);
    }
  }
  using OnLanes = Tried<&Report::try_on_lanes>;
};

/// The piece has a flaw, which it has reported.
template <class Piece>
constexpr bool is_reported() {
  return !(instantiates(static_cast<Report<Piece>*>(nullptr)) && flawless<Piece>);
}

/// The rate of an intact point; zero, at the reference volume, of a failed one, so that distorted cells give no NaN.
template <class M, class State, class Rate>
decltype(auto) rate_if_intact(const M& material, const State& state, const Rate& rate) {
  if constexpr (requires { material.intact(state); })
    return select(material.intact(state) > 0.0, rate, Rate{});
  else
    return (rate);
}

}  // namespace detail

}  // namespace strike
