#pragma once
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include <strike/element/plate3_motion.hpp>
#include <strike/element/plate3_resistance.hpp>
#include <strike/element/plate_point.hpp>
#include <strike/element/plate_thickness.hpp>
#include <strike/element/plate_warping.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>

namespace strike {

namespace detail {
/// The memory of the drilling of a triangle: the resistance to it.
template <class Drilling, class T>
struct Plate3DrillingState {
  using type = Plate3Drilling<T>;
};
template <class T>
struct Plate3DrillingState<FreeDrilling, T> {
  struct type {};
};
/// The resistance to the drilling of a triangle that is given none.
template <class Drilling>
constexpr Drilling usual_triangle_drilling() {
  if constexpr (std::same_as<Drilling, DrillingStiffness>)
    return DrillingStiffness{1e-2};
  else
    return Drilling{};
}
}  // namespace detail

/// The three-node C0 plate of Belytschko, Stolarski and Carpenter (1984) with one point in its plane and three
/// rotations at a node, written in the modes of an equilateral triangle: strike/element/plate3_motion.hpp. Strain is
/// measured in the middle of the step, so that a rotation strains nothing; the stresses live in the plate's frame. Its
/// material is a section, as of Plate4. No motion of two triangles or more is without strain but those of a rigid body
/// and, with FreeDrilling, the drilling, so that it has no hourglass control; of one alone the rotation of its nodes
/// about the lines to its middle strains nothing. In its plane its strain is uniform: it bends there too stiffly.
/// Policies: change of the thickness, and resistance to the drilling (of which `stiffness` alone is used),
/// DrillingStiffness{1e-2} unless another is given: ten times that of Plate4, for triangles of curved surfaces meet at
/// an angle along every edge.
///   Plate3{}   Plate3{ThicknessChange{}}   Plate3{ConstantThickness{}, FreeDrilling{}}
template <class Thickness = ConstantThickness, class Drilling = DrillingStiffness>
struct Plate3 {
  static constexpr bool has_thickness = PlateThickness<Thickness>, has_drilling = PlateDrilling<Drilling>,
                        sound = has_thickness && has_drilling;
  static_assert(has_thickness,
                "strike: the first policy of Plate3 is its thickness: ConstantThickness or ThicknessChange.");
  static_assert(!has_thickness || has_drilling,
                "strike: the second policy of Plate3 is what resists the drilling of its nodes: DrillingStiffness or "
                "FreeDrilling.");

  [[no_unique_address]] Thickness thickness{};
  [[no_unique_address]] Drilling drilling = detail::usual_triangle_drilling<Drilling>();

  void ranges(const auto& number) const { number(thickness), number(drilling); }

  using Kinematics = PlateKinematics;
  static constexpr int nodes = 3;
  static constexpr CellShape shape = CellShape::triangle;
  static constexpr bool turns_nodes = true, projects_shear = true;

  template <class Section, class T>
  struct State {
    T inverse_area{};  ///< 1/A0
    [[no_unique_address]] typename Thickness::template State<T> thickness{};
    [[no_unique_address]] typename detail::Plate3DrillingState<Drilling, T>::type drilling{};
    [[no_unique_address]] typename Section::template State<T> material{};

    /// All its numbers beside those of another, where its section holds lists.
    template <class F>
    void visit_numbers(const State& other, const F& f) {
      const auto visit = [&](auto& own, const auto& others) { strike::visit_numbers<T>(own, others, f); };
      f(std::span<T, 1>(&inverse_area, 1), std::span<const T, 1>(&other.inverse_area, 1));
      visit(thickness, other.thickness), visit(drilling, other.drilling), visit(material, other.material);
    }
    template <class F>
    void each_point(F f) const {
      if constexpr (requires { material.each_point(f); })
        material.each_point(f);
      else
        f(material);
    }
    /// f(point) for the points of layer k.
    template <class F>
    void each_point(std::size_t k, F f) const
      requires requires(const typename Section::template State<T> layered) { layered.each_point(k, f); }
    {
      material.each_point(k, f);
    }
  };

  template <class Section, class T>
  NodalInertia<T> begin(State<Section, T>& state, const Section& material, const Nodal<T, 3>& x) const {
    if constexpr (requires { material.begin(state.material); }) material.begin(state.material);
    const Plate3Modes<T> m = to_triangle_modes<T>(x);
    const Plate4Frame<T> frame(m.xi, m.eta);
    if constexpr (requires { material.align(state.material, m.xi, m.eta); })
      material.align(state.material, frame.e1(), frame.e2());
    state.inverse_area = 1.0 / frame.area;
    const T mass = (density_of(material) / 3) * frame.area;
    return {mass, mass / per_gyration(material, state.inverse_area)};
  }

  /// `v`: the velocities of the three nodes, and behind them their angular velocities.
  template <class Section, class T>
  Response<T, 6> advance(State<Section, T>& state, const Section& material, const Nodal<T, 3>& x, const Nodal<T, 6>& v,
                         double dt) const {
    const Plate3Modes<T> m = to_triangle_modes<T>(x), u = to_triangle_modes<T>(v), w = to_triangle_modes<T>(v, 3);
    const Vector3<T> old_normal = cross<T>(m.xi - T(dt) * u.xi, m.eta - T(dt) * u.eta);
    const T back = T(-0.5 * dt);
    const Plate4Frame<T> middle(m.xi + back * u.xi, m.eta + back * u.eta), frame(m.xi, m.eta);
    PlateKinematics::Rate<T> rate = detail::triangle_strain(middle, u, w);
    rate.relative_thickness = thickness.relative(state.thickness);

    const T& A = frame.area;
    const T dA = volume_increment<T>(A, dt * trace(rate.membrane));
    const PlateKinematics::Stress<T> before = detail::remembered(material, state.material, rate.relative_thickness);
    const PlateKinematics::Stress<T> stress = material.stress(state.material, rate, dt);
    thickness.advance(state.thickness, stress.normal_rate, dt);

    Response<T, 6> response;
    response.volume = select(dot(old_normal, frame.normal) > 0.0, A, -A);
    response.internal_work = 0.5 * dt * (T(A - dA) * detail::power(before, rate) + A * detail::power(stress, rate));
    response.bulk_viscosity_work = response.hourglass_work = T(0.0);

    Plate3Modes<T> F, G;
    detail::triangle_forces(frame, stress, F, G);
    const typename PlateKinematics::Moduli<T> moduli = material.moduli(state.material, rate);
    T drilling_stiffness = T(0.0);
    if constexpr (drills) {
      drilling_stiffness = drilling.stiffness(moduli.extension.shear, A);
      response.hourglass_work = resist(state.drilling, drilling_stiffness, Plate3Drilling<T>(middle, u, w), dt);
      state.drilling.add_forces(frame, F, G);
    }
    to_triangle_nodes(F, response.force);
    to_triangle_nodes(G, response.force, 3);

    response.critical_rate = critical_rate(material, state, moduli, drilling_stiffness, frame);
    if constexpr (requires { material.intact(state.material); })
      zero_if_failed(material.intact(state.material) > 0.0, response);
    return response;
  }

  template <class T>
  using Resistance = Plate3Resistance<T, !std::same_as<Drilling, FreeDrilling>>;

  /// Resistance to a small motion in a step dt from here; v are the velocities and angular velocities of the nodes.
  template <class Section, class T>
  Resistance<T> resistance(const State<Section, T>& state, const Section& material, const Nodal<T, 3>& x,
                           const Nodal<T, 6>& v, double dt) const {
    const Plate3Modes<T> m = to_triangle_modes<T>(x);
    const Plate4Frame<T> frame(m.xi, m.eta);
    PlateKinematics::Rate<T> rate = detail::triangle_strain(frame, to_triangle_modes<T>(v), to_triangle_modes<T>(v, 3));
    rate.relative_thickness = thickness.relative(state.thickness);
    Resistance<T> resistance;
    resistance.mass = density_of(material) / (3.0 * state.inverse_area);
    resistance.inertia = resistance.mass / per_gyration(material, state.inverse_area);
    resistance.section = material.moduli(state.material, rate);
    if constexpr (drills) resistance.drilling = drilling.stiffness(resistance.section.extension.shear, frame.area);
    resistance *= T(0.25 * dt * dt) * intact_share<T>(material, state.material);
    return resistance;
  }

  /// The area over that at rest, of a plate whose thickness does not follow.
  template <class Section, class T>
    requires std::same_as<Thickness, ConstantThickness>
  T stretch(const State<Section, T>& state, const Nodal<T, 3>& x) const {
    const Plate3Modes<T> m = to_triangle_modes<T>(x);
    return state.inverse_area * Plate4Frame<T>(m.xi, m.eta).area;
  }

 private:
  static constexpr bool drills = !std::same_as<Drilling, FreeDrilling>;

  /// m/I: at most 4/A, which is that of the quadrilaterals of twice the area that Plate4 would have in place of two.
  template <class Section, class T>
  static T per_gyration(const Section& material, const T& inverse_area) {
    return detail::mass_per_gyration(material, T(4.0 * inverse_area));
  }

  /// Advances the resistance R to the drilling and returns the work done against it.
  template <class T>
  static T resist(Plate3Drilling<T>& R, const T& stiffness, const Plate3Drilling<T>& rates, double dt) {
    const Plate3Drilling<T> shares = Plate3Drilling<T>::shares();
    T work = T(0.0);
    for (T Plate3Drilling<T>::*mode : {&Plate3Drilling<T>::s, &Plate3Drilling<T>::xi, &Plate3Drilling<T>::eta})
      work += detail::resist<T>(R.*mode, stiffness * (shares.*mode), rates.*mode, dt);
    return work;
  }

  /// One over the largest stable step. Membrane, bending and transverse shear are groups of motions, each with the
  /// bound of its own stiffness, and each two with one of their coupling; the matrix of the bounds has the larger
  /// eigenvalue. For nodal masses m = mu A0/3 and moments of inertia I those of the membrane and of bending are, as of
  /// a solid,
  ///   w^2 <= (A/m) (lambda tr S + 2 G L1(S)),   S_ij = b_iI b_jI = squares U^-2,
  /// with 1/sqrt(m I) for their coupling and 1/I for bending; that of the transverse shear, which moves nodes across
  /// and turns them alike, is
  ///   w^2 <= A K (L1(S)/m + 1/(3 I)).
  /// The rest of the shear along the edges turns nodes as bending does: by a row B of gamma along the tangents
  /// with B B^T = kappa^2 squares tr C 1, tr C = 16 A^2 tr S/squares, which adds A K L1(S) kappa^2 tr C/I to bending.
  /// The drilling of the nodes, of which the spin of the plane is half a curl, adds k (1/I + 3/4 tr S/m).
  template <class Section, class T>
  T critical_rate(const Section& material, const State<Section, T>& state, const PlateKinematics::Moduli<T>& moduli,
                  const T& drilling_stiffness, const Plate4Frame<T>& frame) const {
    constexpr double squares = Plate3Modes<T>::squares, kappa = detail::triangle_kappa;
    const T& A = frame.area;
    const PlaneTensor<T> S = T(0.25 * squares) * frame.gradient_squared();
    const T per_mass = (3.0 / density_of(material)) * state.inverse_area;
    const T per_gyration = Plate3::per_gyration(material, state.inverse_area);  // m/I
    const T L1 = largest_eigenvalue(S), trace_S = trace(S), &K = moduli.transverse_shear;
    const auto bound = [&](const PlaneModuli<T>& k) -> T {
      return abs(k.normal - 2.0 * k.shear) * trace_S + 2.0 * abs(k.shear) * L1;
    };
    const T membrane = bound(moduli.extension), mixed = bound(moduli.coupling), bending = bound(moduli.bending);
    const T across = K * (L1 + (1.0 / 3.0) * per_gyration),
            edges = (16 * kappa * kappa / squares) * K * L1 * (A * A * trace_S) * per_gyration;
    const T turning = largest_eigenvalue<T>(across, per_gyration * bending + edges, across * edges);
    const T w2 = (A * per_mass) * largest_eigenvalue<T>(membrane, turning, per_gyration * mixed * mixed);
    return 0.5 * sqrt(w2 + drilling_stiffness * per_mass * (per_gyration + 0.75 * trace_S));
  }
};

Plate3() -> Plate3<>;
template <class Th>
Plate3(Th) -> Plate3<Th>;
template <class Th, class D>
Plate3(Th, D) -> Plate3<Th, D>;

}  // namespace strike
