#pragma once
#include <concepts>
#include <type_traits>

#include <strike/element/hex8_modes.hpp>
#include <strike/element/plate4_modes.hpp>
#include <strike/protocol.hpp>
#include <strike/tensor/rotation.hpp>

// The policies of the elements. Each may be replaced by a user's own that fulfils its requirements; all functions are
// templates over the number T, and `State<T>` is an aggregate of numbers T that starts at rest, empty if there is
// nothing to remember. The rotation of tensors is said in strike/tensor/rotation.hpp.
namespace strike {

struct NoHourglass;
struct PhysicalHourglass;
struct NoPlateHourglass;
struct FreeDrilling;
struct ElementPressure;
struct NodalPressure;

/// A solid element as its hourglass control sees it.
template <class T>
struct HourglassElement {
  T density, volume, edge, per_mass;  ///< edge: V^(1/3); per_mass: 1/(rho V)
  T wave_modulus, shear_modulus;      ///< rho c^2 and G [stress]
  T dt;                               ///< of the step [time]
  SymmetricTensor<T> gradient;        ///< S_ij = B_iI B_jI/V^2 [1/length^2]
  T gradient_squared;                 ///< tr S
  T gradient_eigenvalue;              ///< the largest of S
};

/// Hourglass control of a hexahedron with one point.
///
/// Requirements
/// 1. `State<T>`.
/// 2. `resistance(state, element, rates)`: the resistance to the four hourglass modes [force].
/// 3. `work(element, resistance, rates)`: done against it in the step [energy].
/// 4. `critical_rate(element)`: one over the largest step that the control alone allows [1/time].
/// Optional
/// 5. `State::spatial_tensors()`: a tuple of references to what the element turns.
/// 6. `stiffness(element)`: of a control by stiffness; one without is viscous.
/// Laws: no work on linear fields, where the rates vanish; no energy is created.
/// Models: ViscousHourglass, StiffnessHourglass; NoHourglass is the absence of one. PhysicalHourglass, which flows with
/// the material, is known to Hex8.
template <class H>
concept HourglassControl = std::same_as<H, NoHourglass> || std::same_as<H, PhysicalHourglass> ||
                           requires(const H control, typename H::template State<double> state,
                                    const HourglassElement<double> e, const HourglassModes<double> q) {
                             { control.resistance(state, e, q) } -> std::convertible_to<HourglassModes<double>>;
                             { control.work(e, q, q) } -> std::convertible_to<double>;
                             { control.critical_rate(e) } -> std::convertible_to<double>;
                           };

namespace detail {
struct ControlStiffness {
  struct Decoy {
    int stiffness;
  };
  template <class Model>
  using Member = decltype(&Model::stiffness);
  template <class T>
  static auto call(const auto& control, const HourglassElement<T>& e) -> decltype(T(control.stiffness(e))) {
    return control.stiffness(e);
  }
};
}  // namespace detail

/// Bulk viscosity: the pressure by which a solid element spreads a shock.
///
/// Requirements
/// 1. `State<T>`.
/// 2. `pressure(wave_modulus, tau, rate)`: q of the rho c^2 [stress], of the time tau in which a wave crosses the
///    element and of tr D [1/time]; positive in compression.
/// 3. `coefficient(wave_modulus, tau, rate)`: dq/d|tr D| [stress time], which the stable step takes into account.
/// 4. `work(state, q, dV)`: dissipated in a step to the pressure q that changes the volume by dV [energy].
/// Laws: no energy is created.
/// Models: BulkViscosity, BulkViscosityBothWays; NoBulkViscosity is the absence of one.
template <class V>
concept ShockViscosity = requires(const V viscosity, typename V::template State<double> state, const double x) {
  { viscosity.pressure(x, x, x) } -> std::convertible_to<double>;
  { viscosity.coefficient(x, x, x) } -> std::convertible_to<double>;
  { viscosity.work(state, x, x) } -> std::convertible_to<double>;
};

/// Instant of a step at which a solid element measures the motion.
///
/// Requirements
/// 1. `instant(L, dt)`: the velocity gradient there from that at the end of the step, L [1/time].
/// 2. `to_end(w)`: a function that carries tensors and vectors measured there to the end of the step; w is the axial
///    vector of the step's spin, skew(L) dt.
/// Laws: a motion without rotation is carried as it is.
/// Models: MidStep, EndStep.
template <class I>
concept MeasuringInstant =
    requires(const I instant, const Matrix3<double> L, const Vector3<double> w, const SymmetricTensor<double> D) {
      { instant(L, 1.0) } -> std::convertible_to<Matrix3<double>>;
      { instant.to_end(w)(D) } -> std::convertible_to<SymmetricTensor<double>>;
      { instant.to_end(w)(w) } -> std::convertible_to<Vector3<double>>;
    };

/// Volume from which the pressure of a tetrahedron follows: its own or a mean over its nodes. Known to the driver,
/// which averages. Models: NodalPressure, ElementPressure.
template <class P>
concept TetrahedralPressure = std::same_as<P, NodalPressure> || std::same_as<P, ElementPressure>;

/// A plate as its hourglass control sees it: its area, thickness and b_iI b_iI, and the stiffness of its section.
template <class T, class Moduli>
struct PlateHourglassElement {
  T area, thickness, gradient_squared;
  Moduli moduli;
};

/// Rates of the hourglass modes of a plate in its frame, or the resistance to them: in the plane, of the rotations, and
/// across.
template <class T>
struct PlateHourglassModes {
  Vector2<T> membrane = Vector2<T>::Zero(), bending = Vector2<T>::Zero();
  T shear{};
};

/// Stiffness of the control of each family [force/length, and force length for the rotations].
template <class T>
struct PlateHourglassStiffness {
  T membrane, bending, shear;
};

/// Hourglass control of a plate, by stiffness.
///
/// Requirements
/// 1. `State<T>`: PlateHourglassModes<T>, the resistance.
/// 2. `stiffness(element)`: a PlateHourglassStiffness<T>.
/// Laws: the stiffness is not negative.
/// Models: PlateHourglass; NoPlateHourglass is the absence of one. PhysicalHourglass, which flows with the section, is
/// known to Plate4.
template <class H>
concept PlateHourglassControl =
    std::same_as<H, NoPlateHourglass> || std::same_as<H, PhysicalHourglass> ||
    requires(const H control, const PlateHourglassElement<double, PlateKinematics::Moduli<double>> e) {
      requires std::derived_from<typename H::template State<double>, PlateHourglassModes<double>>;
      { control.stiffness(e) } -> std::same_as<PlateHourglassStiffness<double>>;
    };

/// Treatment of a warped plate, whose nodes stand at the heights z_I = h_I z/4 over the mean plane: the rates of the
/// plane from those of the nodes, and the nodes' forces from those of the plane.
///
/// Requirements
/// 1. `rates(frame, z, d, u, w)`: changes the modes of velocities u and angular velocities w to those of the plane; d
///    is the drilling of the nodes.
/// 2. `forces(frame, z, F, G, D)`: the transpose: changes the modes of the plane's forces F and moments G to those at
///    the nodes, and gives the moment D on the drilling.
/// 3. `lever(z)`: by which a rotation moves the plane [length].
/// 4. `stiffening(z, per_gyration, S)`: factor on the squares of frequencies beyond that [1]; per_gyration is m/I of a
///    node, and S = b b^T.
/// 5. `drills`: the drilling is used.
/// 6. `projects_shear`: the transverse shear is the mean of that along opposite edges, in which a rotation that grows
///    along the plate adds nothing in pure bending, whatever the shape; false: that of the mean rotation.
/// Laws: a rigid motion of the nodes moves the plane rigidly, so that forces and moments balance.
/// Models: BelytschkoWongChiang, NoWarping, RigidOffset.
template <class W>
concept PlateWarping = requires(const W warping, const Plate4Frame<double> frame, Plate4Modes<double> modes,
                                Plate4Drilling<double> drilling, const PlaneTensor<double> S, const double x) {
  { W::drills } -> std::convertible_to<bool>;
  { W::projects_shear } -> std::convertible_to<bool>;
  warping.rates(frame, x, std::as_const(drilling), modes, modes);
  warping.forces(frame, x, modes, modes, drilling);
  { warping.lever(x) } -> std::convertible_to<double>;
  { warping.stiffening(x, x, S) } -> std::convertible_to<double>;
};

/// Thickness of a plate in the course of a run.
///
/// Requirements
/// 1. `State<T>`.
/// 2. `relative(state)`: h/h0 [1].
/// 3. `advance(state, normal_rate, dt)`: over a step in which the thickness grows at the rate normal_rate [1/time].
/// Models: ConstantThickness, ThicknessChange.
template <class P>
concept PlateThickness = requires(const P thickness, typename P::template State<double> state, const double x) {
  { thickness.relative(std::as_const(state)) } -> std::convertible_to<double>;
  thickness.advance(state, x, 1.0);
};

/// Resistance to the drilling of a plate's nodes, their rotation about the normal beyond that of the plate.
///
/// Requirements
/// 1. `State<T>` with `resistance`, a Plate4Drilling<T>.
/// 2. `stiffness(in_plane_shear, area)`: of each node, from A66 of the section [force/length] and the area [moment].
/// Laws: the stiffness is not negative.
/// Models: DrillingStiffness; FreeDrilling is the absence of one. Plate3 asks for the stiffness alone.
template <class D>
concept PlateDrilling = std::same_as<D, FreeDrilling> ||
                        requires(const D drilling, typename D::template State<double> state, const double x) {
                          { state.resistance } -> std::convertible_to<Plate4Drilling<double>>;
                          { drilling.stiffness(x, x) } -> std::convertible_to<double>;
                        };

}  // namespace strike
