#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/material/material.hpp>
#include <strike/range.hpp>
#include <strike/section/fibres.hpp>
#include <strike/section/integrals.hpp>
#include <strike/section/linear_stress.hpp>
#include <strike/section/thickness_rule.hpp>
#include <strike/section/transverse_shear.hpp>

// The pieces of a section: layers from the bottom to the top, each a Layer, some Plies, a LayUp or a PlyStack; then at
// most one shear policy and one Offset, and of fibres their FibreDirection.
namespace strike {

/// Rule of integration over the thickness of a layer.
///
/// Requirements
/// 1. `points`, `weights`: arrays of the same size, known to the compiler, on [-1, 1] from bottom to top.
/// Laws: the points rise; the weights are positive and their sum is 2.
/// Models: Simpson, Gauss, Lobatto.
template <class R>
concept ThicknessRule = requires {
  { R::points[0] } -> std::convertible_to<double>;
  { R::weights[0] } -> std::convertible_to<double>;
  requires R::points.size() == R::weights.size();
};

/// Transverse shear stiffness of a section.
///
/// Requirements
/// 1. `stiffness(shear)`: K at the start of a run from a TransverseShear [force/length].
/// Optional
/// 2. `warning(shear, length)`: a text for the user, empty if there is nothing to say; `length` is the half wave of
///    interest, 0 if none is known.
/// 3. `flow(shear, layer, flow)`: the shear flow of a layer from that of elastic layers.
/// 4. A memory, all or none of: `State<T>` with `shear_stiffness`, K; `LayerState<T>` with `share`, of its elastic
///    moduli that a layer has left; `share(before, work, elastic_work)`, that after a step; and `limited(K_old, K)`, K
///    after a step in which the layers have K.
/// 5. Of plies with fibres, which else it does not serve: `stiffness(shear)` of a LaminateShear, a Matrix2.
/// Laws: K is positive and at most int G dz.
/// Models: EnergyShear, EffectiveShear, FiveSixthsShear; InstantaneousShear has the memory.
template <class P>
concept ShearPolicy = requires(const P policy, const TransverseShear<double> shear) {
  { policy.stiffness(shear) } -> std::convertible_to<double>;
};

/// One that serves plies with fibres.
template <class P>
concept FibreShearPolicy = ShearPolicy<P> && requires(const P policy, const LaminateShear shear) {
  { policy.stiffness(shear) } -> std::convertible_to<Matrix2>;
};

namespace detail {

template <class R>
inline constexpr std::size_t point_count = 0;
template <ThicknessRule R>
inline constexpr std::size_t point_count<R> = R::points.size();

template <class M>
constexpr bool is_plane_material() {
  if constexpr (is_reported<M>())
    return false;
  else
    return PlaneMaterial<M>;
}
template <class M>
concept KnowsNormalRate = requires(const M m, const typename M::template State<double> state,
                                   typename M::Kinematics::template Rate<double> rate,
                                   typename M::Kinematics::template Stress<double> change) {
  { m.normal_rate(state, rate, 1.0, change) } -> std::convertible_to<double>;
};
template <class M>
concept Begins = requires(const M m, typename M::template State<double> state) { m.begin(state); };
template <class M>
concept Warns = requires(const M m) { m.warning(); };
template <class M>
concept CanFail = requires(const M m, const typename M::template State<double> state) { m.intact(state); };

struct ShearWarning : Warning {
  static auto call(const auto& policy, const TransverseShear<double>& shear, const double& length)
      -> decltype(std::string(policy.warning(shear, length))) {
    return policy.warning(shear, length);
  }
};
struct RecoveredFlow {
  struct Decoy {
    int flow;
  };
  template <class Model>
  using Member = decltype(&Model::flow);
  static auto call(const auto& policy, const TransverseShear<double>& shear, const ShearLayer<double>& layer,
                   const ShearFlow<double>& flow) -> decltype(ShearFlow<double>(policy.flow(shear, layer, flow))) {
    return policy.flow(shear, layer, flow);
  }
};
template <class P>
inline constexpr bool warns_of_shear = answers<ShearWarning, const P, const TransverseShear<double>, const double>;
template <class P>
concept HasShearMemory =
    requires { typename P::template State<double>; } || requires { typename P::template LayerState<double>; } ||
    requires(const P policy) { policy.share(1.0, 1.0, 1.0); } || requires(const P policy) { policy.limited(1.0, 1.0); };
template <class P>
concept RemembersShear = requires(const P policy, typename P::template State<double> state,
                                  typename P::template LayerState<double> layer, const double x) {
  { state.shear_stiffness } -> std::convertible_to<double>;
  { layer.share } -> std::convertible_to<double>;
  { policy.share(x, x, x) } -> std::convertible_to<double>;
  { policy.limited(x, x) } -> std::convertible_to<double>;
};

/// Flaws of a shear policy, in the order in which they are reported.
enum class ShearFlaw { none, warning, flow, memory };
template <class P>
constexpr ShearFlaw shear_flaw() {
  if constexpr (!ShearPolicy<P>)
    return ShearFlaw::none;
  else if constexpr (nearly<ShearWarning, const P, const TransverseShear<double>, const double>)
    return ShearFlaw::warning;
  else if constexpr (nearly<RecoveredFlow, const P, const TransverseShear<double>, const ShearLayer<double>,
                            const ShearFlow<double>>)
    return ShearFlaw::flow;
  else if constexpr (HasShearMemory<P> && !RemembersShear<P>)
    return ShearFlaw::memory;
  else
    return ShearFlaw::none;
}
/// Reports what is nearly a shear policy.
template <class P>
struct ShearReport {
  static constexpr ShearFlaw flaw = shear_flaw<P>();
  static_assert(flaw != ShearFlaw::warning,
                "strike: warning of a shear policy is std::string warning(const TransverseShear<double>& shear, double "
                "length) const; this one has other arguments or another result.");
  static_assert(
      flaw != ShearFlaw::flow,
      "strike: flow of a shear policy is ShearFlow<double> flow(const TransverseShear<double>&, const "
      "ShearLayer<double>&, const ShearFlow<double>&) const; this one has other arguments or another result.");
  static_assert(flaw != ShearFlaw::memory,
                "strike: a shear policy that remembers needs all of State<T> with shear_stiffness, LayerState<T> with "
                "share, share(before, work, elastic_work) and limited(K_old, K).");
};

}  // namespace detail

/// A layer of a plate: a plane material, its thickness, and the rule of integration over that.
template <class M, class R = Simpson<5>>
struct Layer {
  static_assert(instantiates(static_cast<detail::Report<M>*>(nullptr)));
  static constexpr bool sound_material = detail::is_plane_material<M>(), sound_rule = ThicknessRule<R>,
                        sound_normal_rate = sound_material && detail::KnowsNormalRate<M>,
                        sound_fibres = detail::HasFibres<M> || !detail::HasSomeFibres<M>,
                        sound = sound_rule && sound_normal_rate && sound_fibres;
  static_assert(sound_material || detail::is_reported<M>(),
                "strike: the material of a Layer answers in plane stress: wrap a solid in PlaneStress{...} or "
                "ZeroNormalStress{...}.");
  static_assert(!sound_material || sound_normal_rate,
                "strike: the material of a Layer needs normal_rate(state, rate, dt, change), the d_zz of a step that "
                "changed its stress so; see strike/material/material.hpp.");
  static_assert(sound_rule || !sound_material,
                "strike: the third piece of a Layer is the rule over its thickness: Simpson<5>{}, Gauss<3>{}, "
                "Lobatto<5>{} or one of your own with points and weights on [-1, 1].");

  static_assert(!sound_normal_rate || sound_fibres,
                "strike: a plane material with fibres has all of PlaneStiffness plane_stiffness(), Matrix2 "
                "transverse_stiffness() and double fibre_angle(), const.");

  M material;
  double thickness;  ///< [length]
  [[no_unique_address]] R rule{};

  void ranges(const auto& number) const {
    number(material), number(rule);
    number("thickness", thickness, range::not_negative);
  }

  using Material = M;
  using Rule = R;
};
template <class M>
Layer(M, double) -> Layer<M>;
template <class M, class R>
Layer(M, double, R) -> Layer<M, R>;

/// Equal layers whose number is known when the program runs. Their state is allocated when a plate begins.
template <class L>
struct Plies {
  L layer;
  std::size_t count;

  void ranges(const auto& number) const {
    number(layer);
    number("count", count, range::between(1, 100000));
  }
};
template <class L>
Plies(L, std::size_t) -> Plies<L>;

/// Plies of one material and thickness at angles, bottom first [degrees], from the FibreDirection of the section about
/// the normal of the plate, beside the material's own:
///   LayUp{carbon, 0.125, {0, 45, -45, 90, 90, -45, 45, 0}}
template <class M, std::size_t n, class R = Gauss<2>>
struct LayUp {
  static_assert(
      detail::HasFibres<M> || detail::is_reported<M>() || !detail::is_plane_material<M>(),
      "strike: the material of a LayUp has fibres, such as OrthotropicPly; of any other write Plies{Layer{...}, "
      "count}.");

  Layer<M, R> layer;
  std::array<double, n> angles;  ///< [degrees]

  LayUp(const M& material, double thickness, const double (&angles_bottom_first)[n], const R& rule = {})
      : layer{material, thickness, rule} {
    for (std::size_t k = 0; k < n; ++k) angles[k] = angles_bottom_first[k];
  }

  void ranges(const auto& number) const {
    number(layer);
    number("angles", angles, range::finite);
  }
};

/// A ply of a PlyStack.
template <class M>
struct Ply {
  M material;
  double thickness;  ///< [length]
  double angle = 0;  ///< as of a LayUp [degrees]

  void ranges(const auto& number) const {
    number(material);
    number("thickness", thickness, range::not_negative);
    number("angle", angle, range::finite);
  }
};
template <class M>
Ply(M, double) -> Ply<M>;
template <class M>
Ply(M, double, double) -> Ply<M>;

/// Plies whose number, thicknesses and angles, and the numbers of whose material, are known when the program runs,
/// bottom first. Their state is allocated when a plate begins.
///   Layered{PlyStack{{Ply{carbon, 0.125, 45}, Ply{carbon, 0.125, -45}, Ply{glass, 0.2}}}, FibreDirection{{1, 0, 0}}}
template <class M, class R = Gauss<2>>
struct PlyStack {
  static_assert(detail::HasFibres<M> || detail::is_reported<M>() || !detail::is_plane_material<M>(),
                "strike: the material of a PlyStack has fibres, such as OrthotropicPly; of any other write Layers, or "
                "Plies{Layer{...}, count}.");

  std::vector<Layer<M, R>> layers;
  std::vector<double> angles;  ///< [degrees]

  explicit PlyStack(const std::vector<Ply<M>>& bottom_first, const R& rule = {}) {
    for (const Ply<M>& ply : bottom_first)
      layers.push_back({ply.material, ply.thickness, rule}), angles.push_back(ply.angle);
  }

  void ranges(const auto& number) const {
    number("count", layers.size(), range::between(1, 100000));
    for (std::size_t k = 0; k < layers.size(); ++k) number(layers[k], detail::joined({"ply ", std::to_string(k)}));
    number("angles", angles, range::finite);
  }
};
template <class M>
PlyStack(std::initializer_list<Ply<M>>) -> PlyStack<M>;
template <class M, class R>
PlyStack(std::initializer_list<Ply<M>>, R) -> PlyStack<M, R>;

/// Offset of the middle of a section from the surface of the nodes.
struct Offset {
  double height;  ///< [length]

  void ranges(const auto& number) const { number("height", height, range::finite); }
};

namespace detail {

// Each instance a type of its own, for two empty members of one type could not share an address.
template <class Shear, class T>
struct ShearLayerState {};
template <class Shear, class T>
  requires requires { typename Shear::template LayerState<T>; }
struct ShearLayerState<Shear, T> : Shear::template LayerState<T> {};
template <class Shear, class T>
struct ShearState {};
template <class Shear, class T>
  requires requires { typename Shear::template State<T>; }
struct ShearState<Shear, T> : Shear::template State<T> {};

/// State of a layer: of its points, and of the shear policy.
template <class Shear, class L, class T>
struct LayerState : ShearLayerState<Shear, T> {
  std::array<typename L::Material::template State<T>, point_count<typename L::Rule>> points{};
};

/// A piece of a section: a layer, some plies, or an option without layers.
template <class P>
struct Piece {
  static constexpr bool is_shear = ShearPolicy<P>, is_offset = std::same_as<P, Offset>,
                        is_direction = std::same_as<P, FibreDirection>, has_fibres = false;
  static constexpr bool is_layer = false, is_plies = false, is_known = is_shear || is_offset || is_direction;
  static constexpr bool is_sound = shear_flaw<P>() == ShearFlaw::none;
  static constexpr bool begins = false, can_fail = false, has_plastic_strain = false;
  template <class Flow>
  struct Measured {};
  template <class Shear, class T>
  struct State {};
  template <class T>
  struct LinearState {};
};
template <class M, class R>
struct Piece<Layer<M, R>> {
  static constexpr bool is_shear = false, is_offset = false, is_direction = false, has_fibres = HasFibres<M>;
  static constexpr bool is_layer = true, is_plies = false, is_known = true, is_sound = Layer<M, R>::sound;
  static constexpr bool differ = false;  ///< its layers may
  static constexpr bool begins = Begins<M>, can_fail = CanFail<M>;
  static constexpr bool has_plastic_strain =
      requires(const typename M::template State<double> state) { state.equivalent_plastic_strain; };
  template <class T>
  using PointState = typename M::template State<T>;
  template <class Flow>
  using Measured = std::array<MeasuredLayer<point_count<R>, Flow, has_fibres>, 1>;
  template <class Shear, class T>
  using State = std::array<LayerState<Shear, Layer<M, R>, T>, 1>;
  template <class T>
  using LinearState = std::array<std::array<AlongEdges<T>, point_count<R>>, 1>;
  static const Layer<M, R>& layer(const Layer<M, R>& layer, std::size_t) { return layer; }
  static std::size_t count(const Layer<M, R>&) { return 1; }
  /// Of layer k beside that of its material [degrees].
  static double angle(const Layer<M, R>&, std::size_t) { return 0; }
};
template <class M, class R>
struct Piece<Plies<Layer<M, R>>> : Piece<Layer<M, R>> {
  static constexpr bool is_plies = true, begins = true;
  template <class Flow>
  using Measured = std::vector<MeasuredLayer<point_count<R>, Flow, HasFibres<M>>>;
  template <class Shear, class T>
  using State = std::vector<LayerState<Shear, Layer<M, R>, T>>;
  template <class T>
  using LinearState = std::vector<std::array<AlongEdges<T>, point_count<R>>>;
  static const Layer<M, R>& layer(const Plies<Layer<M, R>>& plies, std::size_t) { return plies.layer; }
  static std::size_t count(const Plies<Layer<M, R>>& plies) { return plies.count; }
  static double angle(const Plies<Layer<M, R>>&, std::size_t) { return 0; }
};
template <class M, class R>
struct Piece<PlyStack<M, R>> : Piece<Plies<Layer<M, R>>> {
  static constexpr bool differ = true;
  static const Layer<M, R>& layer(const PlyStack<M, R>& plies, std::size_t k) { return plies.layers[k]; }
  static std::size_t count(const PlyStack<M, R>& plies) { return plies.layers.size(); }
  static double angle(const PlyStack<M, R>& plies, std::size_t k) { return plies.angles[k]; }
};
template <class M, std::size_t n, class R>
struct Piece<LayUp<M, n, R>> : Piece<Layer<M, R>> {
  template <class Flow>
  using Measured = std::array<MeasuredLayer<point_count<R>, Flow, HasFibres<M>>, n>;
  template <class Shear, class T>
  using State = std::array<LayerState<Shear, Layer<M, R>, T>, n>;
  template <class T>
  using LinearState = std::array<std::array<AlongEdges<T>, point_count<R>>, n>;
  static const Layer<M, R>& layer(const LayUp<M, n, R>& plies, std::size_t) { return plies.layer; }
  static std::size_t count(const LayUp<M, n, R>&) { return n; }
  static double angle(const LayUp<M, n, R>& plies, std::size_t k) { return plies.angles[k]; }
};

/// The first piece that has points; of a section without layers nothing.
template <class... Pieces>
struct FirstLayer {
  template <class T>
  using PointState = T;
};
template <class P, class... Rest>
struct FirstLayer<P, Rest...> : FirstLayer<Rest...> {};
template <class P, class... Rest>
  requires Piece<P>::is_layer
struct FirstLayer<P, Rest...> : Piece<P> {};

constexpr EnergyShear shear_of() { return {}; }
template <class P, class... Rest>
constexpr auto shear_of(const P& piece, const Rest&... rest) {
  if constexpr (Piece<P>::is_shear)
    return piece;
  else
    return shear_of(rest...);
}
constexpr double offset_of() { return 0; }
template <class P, class... Rest>
constexpr double offset_of(const P& piece, const Rest&... rest) {
  if constexpr (Piece<P>::is_offset)
    return piece.height;
  else
    return offset_of(rest...);
}

/// The stresses of the points of a layer, at once where its material can.
template <class M, class P, class T, std::size_t n>
std::array<PlaneTensor<T>, n> stresses_of(const M& material, std::array<P, n>& points,
                                          const std::array<PlaneStressKinematics::Rate<T>, n>& rates, double dt) {
  if constexpr (requires { material.stresses(points, rates, dt); }) {
    return material.stresses(points, rates, dt);
  } else {
    std::array<PlaneTensor<T>, n> stresses;
    for (std::size_t i = 0; i < n; ++i) stresses[i] = material.stress(points[i], rates[i], dt);
    return stresses;
  }
}

/// The FibreDirection among the pieces; without one zero.
inline Eigen::Vector3d direction_of() { return Eigen::Vector3d::Zero(); }
template <class P, class... Rest>
Eigen::Vector3d direction_of(const P& piece, const Rest&... rest) {
  if constexpr (Piece<P>::is_direction)
    return piece.direction;
  else
    return direction_of(rest...);
}

/// f(i) for the places i of the pieces that have layers, bottom to top.
template <class... Pieces, class F>
void each_layered_piece(F f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    const auto visit = [&](auto place, auto is_layer) {
      if constexpr (is_layer) f(place);
    };
    (visit(std::integral_constant<std::size_t, i>{}, std::bool_constant<Piece<Pieces>::is_layer>{}), ...);
  }(std::index_sequence_for<Pieces...>{});
}

}  // namespace detail

}  // namespace strike
