#pragma once
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include <strike/element/plate4_resistance.hpp>
#include <strike/element/plate_hourglass.hpp>
#include <strike/element/plate_physical.hpp>
#include <strike/element/plate_point.hpp>
#include <strike/element/plate_thickness.hpp>
#include <strike/element/plate_warping.hpp>
#include <strike/element/policies.hpp>
#include <strike/element/solid_point.hpp>

namespace strike {

/// The four-node Mindlin plate of Belytschko, Lin and Tsay (1984) with one point in its plane and three rotations at a
/// node, written in its own modes. Strain is measured in the middle of the step, so that a rotation strains nothing;
/// the stresses live in the plate's frame, which does not depend on the numbering. Its material is a section. Policies:
/// hourglass control, treatment of a warp, change of the thickness, and resistance to the drilling.
///   Plate4{}   Plate4{PlateHourglass{.membrane = 0.01}}   Plate4{PlateHourglass{}, NoWarping{}, ThicknessChange{}}
template <class Hourglass = PlateHourglass, class Warping = BelytschkoWongChiang, class Thickness = ConstantThickness,
          class Drilling = DrillingStiffness>
struct Plate4 {
  static constexpr bool has_hourglass = PlateHourglassControl<Hourglass>, has_warping = PlateWarping<Warping>,
                        has_thickness = PlateThickness<Thickness>, has_drilling = PlateDrilling<Drilling>,
                        sound = has_hourglass && has_warping && has_thickness && has_drilling;
  static_assert(has_hourglass,
                "strike: the first policy of Plate4 is its hourglass control: PlateHourglass, PhysicalHourglass or "
                "NoPlateHourglass.");
  static_assert(!has_hourglass || has_warping,
                "strike: the second policy of Plate4 is what it makes of a warp: BelytschkoWongChiang, NoWarping or "
                "RigidOffset.");
  static_assert(!has_hourglass || !has_warping || has_thickness,
                "strike: the third policy of Plate4 is its thickness: ConstantThickness or ThicknessChange.");
  static_assert(!has_hourglass || !has_warping || !has_thickness || has_drilling,
                "strike: the fourth policy of Plate4 is what resists the drilling of its nodes: DrillingStiffness or "
                "FreeDrilling.");

  [[no_unique_address]] Hourglass hourglass{};
  [[no_unique_address]] Warping warping{};
  [[no_unique_address]] Thickness thickness{};
  [[no_unique_address]] Drilling drilling{};

  void ranges(const auto& number) const { number(hourglass), number(warping), number(thickness), number(drilling); }

  using Kinematics = PlateKinematics;
  static constexpr int nodes = 4;
  static constexpr CellShape shape = CellShape::quadrilateral;
  static constexpr bool physical = std::same_as<Hourglass, PhysicalHourglass>;
  static constexpr bool turns_nodes = true, projects_shear = Warping::projects_shear || physical;

  template <class Section, class T>
  struct State {
    T inverse_area{};  ///< 1/A0
    [[no_unique_address]] typename Thickness::template State<T> thickness{};
    [[no_unique_address]] typename detail::PlateControlState<Hourglass, Section, T>::type hourglass{};
    [[no_unique_address]] typename Drilling::template State<T> drilling{};
    [[no_unique_address]] typename Section::template State<T> material{};

    /// All its numbers beside those of another, where its section holds lists.
    template <class F>
    void visit_numbers(const State& other, const F& f) {
      const auto visit = [&](auto& own, const auto& others) { strike::visit_numbers<T>(own, others, f); };
      f(std::span<T, 1>(&inverse_area, 1), std::span<const T, 1>(&other.inverse_area, 1));
      visit(thickness, other.thickness), visit(hourglass, other.hourglass), visit(drilling, other.drilling);
      visit(material, other.material);
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
  NodalInertia<T> begin(State<Section, T>& state, const Section& material, const Nodal<T, 4>& x) const {
    if constexpr (requires { material.begin(state.material); }) material.begin(state.material);
    if constexpr (physical && requires { material.begin(state.hourglass.linear); })
      material.begin(state.hourglass.linear);
    const Plate4Modes<T> m = to_plate_modes<T>(x);
    const Plate4Frame<T> frame(m.xi, m.eta);
    const T A = frame.area;
    if constexpr (requires { material.align(state.material, m.xi, m.eta); })
      material.align(state.material, frame.e1(), frame.e2());
    state.inverse_area = 1.0 / A;
    const T mass = (0.25 * density_of(material)) * A;
    return {mass, mass / per_gyration(material, state.inverse_area)};
  }

  /// `v`: the velocities of the four nodes, and behind them their angular velocities.
  template <class Section, class T>
  Response<T, 8> advance(State<Section, T>& state, const Section& material, const Nodal<T, 4>& x, const Nodal<T, 8>& v,
                         double dt) const {
    const Plate4Modes<T> m = to_plate_modes<T>(x);
    Plate4Modes<T> u = to_plate_modes<T>(v), w = to_plate_modes<T>(v, 4);
    const Vector3<T> old_normal = cross<T>(m.xi - T(dt) * u.xi, m.eta - T(dt) * u.eta);
    const auto [rate, control_rate, drilling_rates] = measure(m, u, w, dt);

    const Plate4Frame<T> frame(m.xi, m.eta);
    const T& A = frame.area;
    const T dA = volume_increment<T>(A, dt * trace(rate.membrane));
    const T h = material.thickness() * thickness.relative(state.thickness);
    const PlateKinematics::Rate<T> given{rate.membrane, rate.curvature, rate.shear,
                                         thickness.relative(state.thickness)};
    const PlateKinematics::Stress<T> before = detail::remembered(material, state.material, given.relative_thickness);
    [[maybe_unused]] LinearResultants<T> linear;
    PlateKinematics::Stress<T> stress;
    if constexpr (physical)
      stress = detail::stress<Section, T>(material, state.material, state.hourglass.linear, given, control_rate.linear,
                                          dt, linear);
    else
      stress = material.stress(state.material, given, dt);
    thickness.advance(state.thickness, stress.normal_rate, dt);

    Response<T, 8> response;
    response.volume = select(dot(old_normal, frame.normal) > 0.0, A, -A);
    response.internal_work = 0.5 * dt * (T(A - dA) * detail::power(before, rate) + A * detail::power(stress, rate));
    response.bulk_viscosity_work = T(0.0);
    response.hourglass_work = T(0.0);

    // Forces on the modes: N acts on the tangents, M on the tangents turned by a right angle, Q on both.
    const Vector3<T>& e3 = frame.normal;
    const PlaneTensor<T> N = A * frame.turned(stress.force), M = A * frame.turned(stress.moment);
    const Vector2<T> Q = frame.turned(stress.shear(0), stress.shear(1));
    const T Q_xi = A * Q(0), Q_eta = A * Q(1);
    const Vector3<T> c_xi = cross(e3, m.xi), c_eta = cross(e3, m.eta), c_h = cross(e3, m.h);
    Plate4Modes<T> F, G;
    F.xi = N.xx * m.xi + N.xy * m.eta + Q_xi * e3;
    F.eta = N.xy * m.xi + N.yy * m.eta + Q_eta * e3;
    G.xi = M.xx * c_xi + M.xy * c_eta;
    G.eta = M.xy * c_xi + M.yy * c_eta;
    G.s = (0.25 * Q_xi) * c_xi + (0.25 * Q_eta) * c_eta;
    F.s = F.h = G.h = Vector3<T>{T(0.0), T(0.0), T(0.0)};
    if constexpr (projects_shear) G.eta = G.eta + (0.25 * Q_xi) * c_h, G.xi = G.xi + (0.25 * Q_eta) * c_h;

    const typename PlateKinematics::Moduli<T> moduli = material.moduli(state.material, given);
    const PlaneTensor<T> bb = frame.gradient_squared();
    const T z = dot(e3, m.h);
    const Vector2<T> h_local = frame.in_plane(m.h), p = frame.turned(h_local(0), h_local(1));
    T drilling_stiffness = T(0.0);
    Plate4Drilling<T> moment;
    if constexpr (drilling_controlled) {
      drilling_stiffness = drilling.stiffness(moduli.extension.shear, A);
      response.hourglass_work += resist(state.drilling.resistance, drilling_stiffness, drilling_rates, dt, moment);
    }
    PlateHourglassStiffness<T> control{T(0.0), T(0.0), T(0.0)};
    if constexpr (physical) {
      const detail::PlateEdges<T> edges(frame);
      AlongEdges<T>& R = state.hourglass.shear;
      const T power_before = linear.power_before + dot(R, control_rate.shear);
      const T K = moduli.transverse_shear;
      R = R + T(dt * K) * AlongEdges<T>{control_rate.inverse.xi * control_rate.shear.xi,
                                        control_rate.inverse.eta * control_rate.shear.eta};
      const T power = dot(linear.force, control_rate.linear.membrane) +
                      dot(linear.moment, control_rate.linear.curvature) + dot(R, control_rate.shear);
      response.hourglass_work += (dt / 6) * (T(A - dA) * power_before + A * power);
      const T third = (1.0 / 3.0) * A;
      AlongEdges<T> on_strain = third * linear.force;
      if constexpr (drilling_controlled) on_strain = on_strain + edges.strain_of_spin({moment.xi, moment.eta}, A);
      const AlongEdges<T> n = edges.per_square(on_strain), k = edges.per_square(third * linear.moment),
                          across = third * R;
      const T R_across = across.xi + across.eta;
      const Vector3<T> R_u = n.xi * m.xi + n.eta * m.eta + R_across * e3, R_w = k.xi * c_xi + k.eta * c_eta;
      F.h = R_u, F.xi = F.xi - p(0) * R_u, F.eta = F.eta - p(1) * R_u;
      G.h = R_w, G.xi = G.xi - p(0) * R_w, G.eta = G.eta - p(1) * R_w;
      G.eta = G.eta + (0.25 * across.xi) * c_xi - (0.25 * R_across * p(0)) * c_h;
      G.xi = G.xi + (0.25 * across.eta) * c_eta - (0.25 * R_across * p(1)) * c_h;
    } else if constexpr (controlled) {
      control = hourglass.stiffness(PlateHourglassElement<T, PlateKinematics::Moduli<T>>{A, h, trace(bb), moduli});
      response.hourglass_work += resist(state.hourglass, control, control_rate, dt);
      const auto& R = state.hourglass;
      const Vector3<T> e1 = frame.e1(), e2 = frame.e2();
      const Vector3<T> R_u = R.membrane(0) * e1 + R.membrane(1) * e2 + R.shear * e3,
                       R_w = R.bending(0) * e1 + R.bending(1) * e2;
      F.h = R_u, F.xi = F.xi - p(0) * R_u, F.eta = F.eta - p(1) * R_u;
      G.h = R_w, G.xi = G.xi - p(0) * R_w, G.eta = G.eta - p(1) * R_w;
      if constexpr (projects_shear) {
        G.eta = G.eta + (0.125 * R.shear) * c_xi - (0.25 * R.shear * p(0)) * c_h;
        G.xi = G.xi + (0.125 * R.shear) * c_eta - (0.25 * R.shear * p(1)) * c_h;
      }
    }
    warping.forces(frame, z, F, G, moment);
    if constexpr (drills) moment.add_forces(frame, F, G);
    to_plate_nodes(F, response.force);
    to_plate_nodes(G, response.force, 4);

    if constexpr (physical)
      response.critical_rate = physical_rate(material, state, moduli, drilling_stiffness, frame, z, h_local, p);
    else
      response.critical_rate =
          critical_rate(material, state, moduli, control, drilling_stiffness, bb, A, z, h_local, p);
    if constexpr (requires { material.intact(state.material); })
      zero_if_failed(material.intact(state.material) > 0.0, response);
    return response;
  }

  template <class T>
  struct ResistanceOf {
    using type = Plate4Resistance<T, Warping, Warping::drills || !std::is_same_v<Drilling, FreeDrilling>, physical>;
  };
  template <class T>
  using Resistance = typename ResistanceOf<T>::type;

  /// Resistance to a small motion in a step dt from here; v are the velocities and angular velocities of the nodes.
  template <class Section, class T>
  Resistance<T> resistance(const State<Section, T>& state, const Section& material, const Nodal<T, 4>& x,
                           const Nodal<T, 8>& v, double dt) const {
    const Plate4Modes<T> m = to_plate_modes<T>(x);
    Plate4Modes<T> u = to_plate_modes<T>(v), w = to_plate_modes<T>(v, 4);
    PlateKinematics::Rate<T> rate = measure(m, u, w, 0.0).rate;
    rate.relative_thickness = thickness.relative(state.thickness);
    const Plate4Frame<T> frame(m.xi, m.eta);
    Resistance<T> resistance;
    resistance.mass = 0.25 * density_of(material) / state.inverse_area;
    resistance.inertia = resistance.mass / per_gyration(material, state.inverse_area);
    resistance.section = material.moduli(state.material, rate);
    static_cast<Warping&>(resistance) = warping;
    if constexpr (physical)
      resistance.linear = detail::linear_moduli<Section>(resistance.section);
    else if constexpr (controlled)
      resistance.hourglass = hourglass.stiffness(PlateHourglassElement<T, PlateKinematics::Moduli<T>>{
          frame.area, material.thickness() * rate.relative_thickness, trace(frame.gradient_squared()),
          resistance.section});
    if constexpr (drilling_controlled)
      resistance.drilling = 0.25 * drilling.stiffness(resistance.section.extension.shear, frame.area);
    resistance *= T(0.25 * dt * dt) * intact_share<T>(material, state.material);
    return resistance;
  }

  /// The area over that at rest, of a plate whose thickness does not follow.
  template <class Section, class T>
    requires std::same_as<Thickness, ConstantThickness>
  T stretch(const State<Section, T>& state, const Nodal<T, 4>& x) const {
    const Plate4Modes<T> m = to_plate_modes<T>(x);
    return state.inverse_area * Plate4Frame<T>(m.xi, m.eta).area;
  }

 private:
  static constexpr bool controlled = !std::is_same_v<Hourglass, NoPlateHourglass>,
                        drilling_controlled = !std::is_same_v<Drilling, FreeDrilling>,
                        drills = Warping::drills || drilling_controlled;

  /// Mass per moment of inertia [1/length^2]: that of the section, at most 8/A, so that the membrane and not the
  /// rotations limits the step (after Hughes, Cohen and Haroun 1978).
  template <class Section, class T>
  static T per_gyration(const Section& material, const T& inverse_area) {
    return detail::mass_per_gyration(material, T(8.0 * inverse_area));
  }

  template <class T>
  struct Measure {
    PlateKinematics::Rate<T> rate;
    std::conditional_t<physical, detail::PhysicalPlateRate<T>, PlateHourglassModes<T>> hourglass;
    Plate4Drilling<T> drilling;
  };

  /// The rates in the middle of the step, from the modes at its end.
  template <class T>
  Measure<T> measure(const Plate4Modes<T>& m, Plate4Modes<T>& u, Plate4Modes<T>& w, double dt) const {
    const T back = T(-0.5 * dt);
    const Plate4Frame<T> frame(m.xi + back * u.xi, m.eta + back * u.eta);
    const Vector3<T> m_h = m.h + back * u.h;
    const Vector3<T>& e3 = frame.normal;
    const T z = dot(e3, m_h);

    const Vector3<T>&m_xi = frame.m_xi, &m_eta = frame.m_eta;
    const Vector3<T> c_xi = cross(e3, m_xi), c_eta = cross(e3, m_eta), c_h = cross(e3, m_h);
    Measure<T> measure;
    if constexpr (drills) measure.drilling = Plate4Drilling<T>(frame, u, w);
    warping.rates(frame, z, measure.drilling, u, w);
    PlateKinematics::Rate<T>& rate = measure.rate;
    rate.membrane = frame.turned({dot(m_xi, u.xi), dot(m_eta, u.eta), 0.5 * (dot(m_xi, u.eta) + dot(m_eta, u.xi))});
    rate.curvature = frame.turned({dot(c_xi, w.xi), dot(c_eta, w.eta), 0.5 * (dot(c_xi, w.eta) + dot(c_eta, w.xi))});
    T gamma_xi = dot(e3, u.xi) + 0.25 * dot(c_xi, w.s), gamma_eta = dot(e3, u.eta) + 0.25 * dot(c_eta, w.s);
    if constexpr (projects_shear) gamma_xi += 0.25 * dot(c_h, w.eta), gamma_eta += 0.25 * dot(c_h, w.xi);
    rate.shear = frame.turned(gamma_xi, gamma_eta);
    if constexpr (controlled) {
      // gamma.f = f_h - p.(f_xi, f_eta), p the components of m_h along the tangents
      const Vector2<T> h_local = frame.in_plane(m_h), p = frame.turned(h_local(0), h_local(1));
      const Vector3<T> q_u = u.h - p(0) * u.xi - p(1) * u.eta, q_w = w.h - p(0) * w.xi - p(1) * w.eta;
      T q_across = dot(e3, q_u);
      if constexpr (physical) {
        const detail::PlateEdges<T> edges(frame);
        const T turned = q_across - 0.25 * dot<T>(c_h, p(0) * w.eta + p(1) * w.xi);
        const AlongEdges<T> membrane = edges.per_square(dot(m_xi, q_u), dot(m_eta, q_u));
        if constexpr (drilling_controlled) {  // the nodes against the spin of the plate where they are
          const AlongEdges<T> spin = edges.spin(membrane, frame.area);
          measure.drilling.xi += spin.xi, measure.drilling.eta += spin.eta;
        }
        measure.hourglass = {{membrane, edges.per_square(dot(c_xi, q_w), dot(c_eta, q_w)), edges.square_xi(frame),
                              edges.square_eta(frame)},
                             {turned + 0.25 * dot(c_xi, w.eta), turned + 0.25 * dot(c_eta, w.xi)},
                             edges.inverse(frame.area)};
      } else {
        if constexpr (projects_shear)  // the difference of the shears along opposite edges, zero in pure bending
          q_across += 0.125 * (dot(c_xi, w.eta) + dot(c_eta, w.xi)) - 0.25 * dot<T>(c_h, p(0) * w.eta + p(1) * w.xi);
        measure.hourglass = {frame.in_plane(q_u), frame.in_plane(q_w), q_across};
      }
    }
    return measure;
  }

  /// Advances the resistance to all hourglass modes, ...
  template <class T>
  static T resist(PlateHourglassModes<T>& R, const PlateHourglassStiffness<T>& stiffness,
                  const PlateHourglassModes<T>& rates, double dt) {
    T work = T(0.0);
    for (int i = 0; i < 2; ++i) {
      work += detail::resist(R.membrane(i), stiffness.membrane, rates.membrane(i), dt);
      work += detail::resist(R.bending(i), stiffness.bending, rates.bending(i), dt);
    }
    return work + detail::resist(R.shear, stiffness.shear, rates.shear, dt);
  }
  /// ... and to the drilling, of which each mode has a quarter of the nodes' stiffness; adds R to the moment on it.
  template <class T>
  static T resist(Plate4Drilling<T>& R, const T& stiffness, const Plate4Drilling<T>& rates, double dt,
                  Plate4Drilling<T>& moment) {
    const T k = 0.25 * stiffness;
    T work = T(0.0);
    const auto advance = [&](T Plate4Drilling<T>::*mode) {
      work += detail::resist(R.*mode, k, rates.*mode, dt);
      moment.*mode += R.*mode;
    };
    using Modes = Plate4Drilling<T>;
    advance(&Modes::s), advance(&Modes::xi), advance(&Modes::eta), advance(&Modes::h);
    return work;
  }

  /// One over the largest stable step. For nodal masses m = mu A0/4 and moments of inertia I the frequencies of the
  /// membrane and of bending are bounded as those of a solid (stable_step.hpp) with the section's stiffness,
  ///   w^2 <= (A/m) (lambda tr S + 2 G L1(S)),   S_ij = b_iI b_jI,
  /// where both together take the larger eigenvalue of [extension/m, coupling/sqrt(m I); ., bending/I], in which the
  /// warp may give rotations a lever on the membrane; those of the transverse shear, which moves other modes, by
  ///   w^2 <= A K (L1(S)/m + 1/(4 I)),
  /// but for what a shear along the edges shares with bending, A K L1(S) |h|^2/(16 I), h the part of m_h in the plane.
  /// Control adds 4 k/m in h and what its vectors share with the others: gamma = h - p_i Lambda_i, and of the membrane,
  /// where a warp gives the mean rotation a lever on them, z/4 sqrt(m/I) of that.
  template <class Section, class T>
  T critical_rate(const Section& material, const State<Section, T>& state, const PlateKinematics::Moduli<T>& moduli,
                  const PlateHourglassStiffness<T>& control, const T& drilling_stiffness, const PlaneTensor<T>& S,
                  const T& A, const T& z, const Vector2<T>& h, const Vector2<T>& p) const {
    const T per_mass = (4.0 / density_of(material)) * state.inverse_area;
    const T per_gyration = this->per_gyration(material, state.inverse_area);  // m/I
    const T L1 = largest_eigenvalue(S), trace_S = trace(S);
    const T l = warping.lever(z);
    const auto both = [&](const T& a, const T& b, const T& c) -> T {
      const T coupled = l * a + abs(b);
      return largest_eigenvalue<T>(a, per_gyration * (l * (coupled + abs(b)) + c), per_gyration * coupled * coupled);
    };
    const auto lambda = [](const PlaneModuli<T>& k) -> T { return k.normal - 2.0 * k.shear; };
    const T normal = both(lambda(moduli.extension), lambda(moduli.coupling), lambda(moduli.bending)),
            shear = both(moduli.extension.shear, moduli.coupling.shear, moduli.bending.shear);
    const T strain = max(T(0.0), normal) * trace_S + 2.0 * shear * L1;
    const T across = moduli.transverse_shear * (L1 + 0.25 * per_gyration);
    T bound = max(strain, across);
    if constexpr (projects_shear) {
      const T both_move = T(1.0 / 16.0) * moduli.transverse_shear * L1 * (h(0) * h(0) + h(1) * h(1)) * per_gyration;
      bound = largest_eigenvalue<T>(across, strain + both_move, across * both_move);
    }
    const T w2 = (A * per_mass) * (warping.stiffening(z, per_gyration, S) * bound);

    const T shared = p(0) * p(0) + p(1) * p(1) + 0.0625 * z * z * per_gyration;
    const T c = (4.0 * per_mass) * max(max(control.membrane, control.shear), control.bending * per_gyration);
    T d = drilling_stiffness * per_mass * (per_gyration + 2.0 * L1);
    if constexpr (projects_shear) {  // e^2: what rotations give to the vector across, |c_xi/8|^2 + ... twice
      const T e2 = T(1.0 / 8.0) * per_gyration * (A * A * trace_S + (h(0) * h(0) + h(1) * h(1)) * shared);
      d += (4.0 * per_mass * control.shear) * (e2 + 2.0 * sqrt(e2 * (1.0 + shared)));
    }
    return 0.5 * sqrt(largest_eigenvalue<T>(w2 + c * shared, c, c * c * shared) + d);
  }

  /// The same with PhysicalHourglass. Membrane, bending and transverse shear are groups of motions, each with the bound
  /// of its own stiffness, and each two with one of their coupling; the matrix of the bounds has the larger eigenvalue.
  /// The control adds A K g^kk/3 times the squares of its shears across, which share the rotations with bending, and,
  /// in h, A/3 times the section's stiffness by the edges.
  template <class Section, class T>
  T physical_rate(const Section& material, const State<Section, T>& state, const PlateKinematics::Moduli<T>& moduli,
                  const T& drilling_stiffness, const Plate4Frame<T>& frame, const T& z, const Vector2<T>& h,
                  const Vector2<T>& p) const {
    const T& A = frame.area;
    const PlaneTensor<T> S = frame.gradient_squared();
    const detail::PlateEdges<T> edges(frame);
    const T per_mass = (4.0 / density_of(material)) * state.inverse_area;
    const T per_gyration = this->per_gyration(material, state.inverse_area);  // m/I
    const T L1 = largest_eigenvalue(S), trace_S = trace(S), scale = A * per_mass;
    const T l = warping.lever(z), stiffening = warping.stiffening(z, per_gyration, S);
    const auto bound = [&](const PlaneModuli<T>& k) -> T {
      return scale * (abs(k.normal - 2.0 * k.shear) * trace_S + 2.0 * abs(k.shear) * L1);
    };
    const T a = bound(moduli.extension), b = bound(moduli.coupling), c = bound(moduli.bending),
            K = moduli.transverse_shear;
    const T pp = p(0) * p(0) + p(1) * p(1), hh = h(0) * h(0) + h(1) * h(1);
    const T mixed = sqrt(per_gyration) * (l * a + b), bending = per_gyration * (l * (l * a + 2.0 * b) + c);

    // shears across: of the mean, and of the control, whose rotations have the squares r of their lengths
    const T across = scale * K * (L1 + 0.25 * per_gyration);
    const T both_move = scale * K * T(1.0 / 16.0) * L1 * hh * per_gyration;
    const AlongEdges<T> k = T(T(4.0 / 3.0) * scale * K) * edges.inverse(A);
    const T lever = T(1.0 / 16.0) * per_gyration;
    const AlongEdges<T> r = lever * edges.beside(p);
    const T k_all = k.xi + k.eta;
    const T rotations = max(k.xi * r.xi, k.eta * r.eta) + sqrt(k.xi * k.eta) * lever * hh * abs(1.0 - pp);
    const T shared_rotations =
        sqrt((1.0 + pp) * (k.xi * k.xi * r.xi + k.eta * k.eta * r.eta)) + sqrt(across * both_move);
    const T transverse = largest_eigenvalue<T>(across + k_all * pp, k_all, k_all * k_all * pp);
    const T turning =
        largest_eigenvalue<T>(bending + both_move + rotations, transverse, shared_rotations * shared_rotations);
    const T w2 = stiffening * largest_eigenvalue<T>(a, turning, mixed * mixed);

    const T shared = pp + 0.0625 * z * z * per_gyration;
    const T in_h = T(4.0 / 3.0) * scale * stiffening * edges.stiffest() *
                   largest_eigenvalue<T>(moduli.extension.normal, per_gyration * moduli.bending.normal,
                                         per_gyration * moduli.coupling.normal * moduli.coupling.normal);
    const T d = drilling_stiffness * per_mass * (per_gyration + (6.0 + 4.0 * shared) * L1);
    return 0.5 * sqrt(largest_eigenvalue<T>(w2 + in_h * shared, in_h, in_h * in_h * shared) + d);
  }
};

Plate4() -> Plate4<>;
template <class H>
Plate4(H) -> Plate4<H>;
template <class H, class W>
Plate4(H, W) -> Plate4<H, W>;
template <class H, class W, class Th>
Plate4(H, W, Th) -> Plate4<H, W, Th>;
template <class H, class W, class Th, class D>
Plate4(H, W, Th, D) -> Plate4<H, W, Th, D>;

}  // namespace strike
