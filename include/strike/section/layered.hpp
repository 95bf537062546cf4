#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/section/thickness_rule.hpp>
#include <strike/section/transverse_shear.hpp>
#include <strike/text.hpp>

namespace strike {

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
template <class State>
concept HasPlasticStrain = requires(const State state) { state.equivalent_plastic_strain; };
template <class M>
concept Begins = requires(const M m, typename M::template State<double> state) { m.begin(state); };
template <class P>
concept TellsOfShear = requires(const P policy, const TransverseShear<double> shear) { policy.warning(shear, 1.0); };
template <class P>
concept RecoversFlow = requires(const P policy, const TransverseShear<double> shear, const ShearLayer<double> layer,
                                const ShearFlow<double> flow) { policy.flow(shear, layer, flow); };
template <class M>
concept Tells = requires(const M m) { m.warning(); };
template <class M>
concept CanFail = requires(const M m, const typename M::template State<double> state) { m.intact(state); };
}  // namespace detail

/// A layer of a plate: a plane material, its thickness, and the rule by which its stress is summed over that.
template <class M, class R = Simpson<5>>
struct Layer {
  static constexpr bool sound_material = detail::is_plane_material<M>(), sound_rule = ThicknessRule<R>,
                        sound_normal_rate = sound_material && detail::KnowsNormalRate<M>,
                        sound = sound_rule && sound_normal_rate;
  static_assert(sound_material || detail::is_reported<M>(),
                "strike: the material of a Layer answers in plane stress: wrap a solid in PlaneStress{...} or "
                "ZeroNormalStress{...}.");
  static_assert(!sound_material || sound_normal_rate,
                "strike: the material of a Layer needs normal_rate(state, rate, dt, change), the d_zz of a step that "
                "changed its stress so; see strike/material/material.hpp.");
  static_assert(sound_rule || !sound_material,
                "strike: the third piece of a Layer is the rule over its thickness: Simpson<5>{}, Gauss<3>{}, "
                "Lobatto<5>{} or one of your own with points and weights on [-1, 1].");

  M material;
  double thickness;  ///< [length]
  [[no_unique_address]] R rule{};

  using Material = M;
  using Rule = R;
};
template <class M>
Layer(M, double) -> Layer<M>;
template <class M, class R>
Layer(M, double, R) -> Layer<M, R>;

/// As many like layers as are known when the program runs. Their state is allocated when a plate begins.
template <class L>
struct Plies {
  L layer;
  std::size_t count;
};
template <class L>
Plies(L, std::size_t) -> Plies<L>;

/// The height of a section's middle over the surface of the nodes [length].
struct Offset {
  double height;
};

namespace detail {

/// Values of different types, told apart by their places: a tuple that is copied as plain memory.
template <std::size_t i, class A>
struct Slot {
  [[no_unique_address]] A value{};
};
template <class Indices, class... A>
struct Slots;
template <std::size_t... i, class... A>
struct Slots<std::index_sequence<i...>, A...> : Slot<i, A>... {};
template <class... A>
using List = Slots<std::index_sequence_for<A...>, A...>;

template <std::size_t i, class A>
A& get(Slot<i, A>& slot) {
  return slot.value;
}
template <std::size_t i, class A>
const A& get(const Slot<i, A>& slot) {
  return slot.value;
}

/// What a section computes of each layer beforehand.
template <std::size_t n>
struct LayerNumbers {
  std::array<double, n> z,
      weight;  ///< heights over the surface of the nodes and shares of the thickness, of the points
  ShearLayer<double> elastic;
  ShearFlow<double> flow;
};

// Where there is nothing to remember, each of a type of its own: two of one type could not share an address.
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

/// What a layer remembers: the states of its points, and what the shear policy needs.
template <class Shear, class L, class T>
struct LayerState : ShearLayerState<Shear, T> {
  std::array<typename L::Material::template State<T>, point_count<typename L::Rule>> points{};
};

/// A piece of a section is a layer, some plies, or an option without layers.
template <class P>
struct Piece {
  static constexpr bool is_shear = ShearPolicy<P>, is_offset = std::same_as<P, Offset>;
  static constexpr bool is_layer = false, is_plies = false, is_known = is_shear || is_offset, is_sound = true;
  static constexpr bool begins = false, can_fail = false, has_plastic_strain = false;
  struct Numbers {};
  template <class Shear, class T>
  struct State {};
};
template <class M, class R>
struct Piece<Layer<M, R>> {
  static constexpr bool is_shear = false, is_offset = false;
  static constexpr bool is_layer = true, is_plies = false, is_known = true, is_sound = Layer<M, R>::sound;
  static constexpr bool begins = Begins<M>, can_fail = CanFail<M>,
                        has_plastic_strain = HasPlasticStrain<typename M::template State<double>>;
  template <class T>
  using PointState = typename M::template State<T>;
  using Numbers = std::array<LayerNumbers<point_count<R>>, 1>;
  template <class Shear, class T>
  using State = std::array<LayerState<Shear, Layer<M, R>, T>, 1>;
  static const Layer<M, R>& layer(const Layer<M, R>& layer) { return layer; }
  static std::size_t count(const Layer<M, R>&) { return 1; }
};
template <class M, class R>
struct Piece<Plies<Layer<M, R>>> : Piece<Layer<M, R>> {
  static constexpr bool is_plies = true, begins = true;
  using Numbers = std::vector<LayerNumbers<point_count<R>>>;
  template <class Shear, class T>
  using State = std::vector<LayerState<Shear, Layer<M, R>, T>>;
  static const Layer<M, R>& layer(const Plies<Layer<M, R>>& plies) { return plies.layer; }
  static std::size_t count(const Plies<Layer<M, R>>& plies) { return plies.count; }
};

/// The first piece that has points.
template <class P, class... Rest>
struct FirstLayer : FirstLayer<Rest...> {};
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

}  // namespace detail

/// The section of a plate: layers from the bottom to the top, each with its own model and rule, or Plies of them; then,
/// if wanted, an Offset and where the transverse shear stiffness comes from.
///   Layered{Layer{glass, 3.0}, Layer{interlayer, 0.76, Simpson<3>{}}, Layer{glass, 3.0}, EffectiveShear{.length =
///   300}}
/// A point at the height z is strained by membrane + z curvature; N, M = int sigma (1, z) dz; dQ = K gamma dt. With the
/// thickness of the plate the heights grow. Layers fail on their own; one that has failed carries no stress.
/// Errors: a thickness below zero, or none.
template <class... Pieces>
class Layered {
  static constexpr bool known = (detail::Piece<Pieces>::is_known && ...),
                        has_layers = (detail::Piece<Pieces>::is_layer || ...),
                        unique = (detail::Piece<Pieces>::is_shear + ... + 0) <= 1 &&
                                 (detail::Piece<Pieces>::is_offset + ... + 0) <= 1;
  static_assert(known,
                "strike: a Layered is made of Layer{material, thickness}, bottom first, or Plies{layer, count}; then "
                "an Offset{height} and one of EnergyShear, EffectiveShear, FiveSixthsShear and InstantaneousShear.");
  static_assert(!known || has_layers, "strike: a Layered needs at least one Layer{material, thickness}.");
  static_assert(unique, "strike: a Layered takes one shear policy and one Offset at most.");

  using Shear = decltype(detail::shear_of(std::declval<Pieces>()...));
  static constexpr bool instantaneous = requires { typename Shear::template State<double>; };
  static constexpr bool begins = instantaneous || (detail::Piece<Pieces>::begins || ...);
  static constexpr bool can_fail = (detail::Piece<Pieces>::can_fail || ...);

  static constexpr std::array<bool, sizeof...(Pieces)> is_layer{detail::Piece<Pieces>::is_layer...},
      is_plies{detail::Piece<Pieces>::is_plies...};
  /// f(i) for the places i of the pieces that have layers.
  template <class F>
  static void each_piece(F f) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      const auto visit = [&](auto place) {
        if constexpr (is_layer[place]) f(place);
      };
      (visit(std::integral_constant<std::size_t, i>{}), ...);
    }(std::index_sequence_for<Pieces...>{});
  }

 public:
  static constexpr bool sound = known && has_layers && unique && (detail::Piece<Pieces>::is_sound && ...);
  using Kinematics = PlateKinematics;
  /// Points of some layer can flow.
  static constexpr bool has_plastic_strain = (detail::Piece<Pieces>::has_plastic_strain || ...);
  /// The state of the points in the lowest layer.
  template <class T>
  using PointState = typename detail::FirstLayer<Pieces...>::template PointState<T>;

  /// Per layer what its points remember, the shear force, and what the shear policy needs.
  template <class T>
  struct State : detail::ShearState<Shear, T> {
    detail::List<typename detail::Piece<Pieces>::template State<Shear, T>...> pieces;
    Vector2<T> shear = Vector2<T>::Zero();  ///< Q

    /// f(k, layer) for every layer, from k = 0 at the bottom; layer.points are the states of its material.
    template <class F>
    void each_layer(F f) const {
      std::size_t k = 0;
      each_piece([&](auto i) {
        for (const auto& layer : detail::get<i>(pieces)) f(k++, layer);
      });
    }
    /// f(point) for all points.
    template <class F>
    void each_point(F f) const {
      each_layer([&](std::size_t, const auto& layer) {
        for (const auto& point : layer.points) f(point);
      });
    }
    /// f(point) for the points of layer k.
    template <class F>
    void each_point(std::size_t k, F f) const {
      each_layer([&](std::size_t layer_k, const auto& layer) {
        if (layer_k == k)
          for (const auto& point : layer.points) f(point);
      });
    }
  };

  explicit Layered(const Pieces&... pieces) : pieces_{{pieces}...}, shear_(detail::shear_of(pieces...)) {
    if constexpr (sound) measure(detail::offset_of(pieces...));
  }

  double density() const { return mass_; }
  double thickness() const { return thickness_; }
  double rotary_inertia() const { return rotary_inertia_; }
  std::size_t layers() const { return layers_; }
  /// The closed form of its elastic layers, and the stiffness that the policy makes of it.
  const TransverseShear<double>& transverse_shear() const { return elastic_shear_; }
  double shear_stiffness() const { return shear_stiffness_; }

  /// What the user should know, if anything: of the materials, and of the shear over half waves of a length, such as
  /// four elements.
  [[gnu::cold]] std::string warning(double length = 0) const {
    std::string all;
    const auto tell = [&](const std::string& warning) {
      if (!warning.empty() && all.find(warning) == std::string::npos) all += (all.empty() ? "" : " ") + warning;
    };
    each_piece([&](auto i) {
      const auto& material = layer<i>().material;
      if constexpr (detail::Tells<std::remove_cvref_t<decltype(material)>>) tell(material.warning());
    });
    if constexpr (detail::TellsOfShear<Shear>) tell(shear_.warning(elastic_shear_, length));
    return all;
  }

  /// The state before the first step.
  template <class T>
    requires begins
  void begin(State<T>& state) const {
    state = {};
    each_piece([&](auto i) {
      auto& layers = detail::get<i>(state.pieces);
      if constexpr (is_plies[i]) layers.resize(detail::get<i>(numbers_).size());
      const auto& material = layer<i>().material;
      if constexpr (detail::Begins<std::remove_cvref_t<decltype(material)>>)
        for (auto& own : layers)
          for (auto& point : own.points) material.begin(point);
    });
    if constexpr (instantaneous) state.shear_stiffness = T(shear_stiffness_);
  }

  template <class T>
  PlateKinematics::Stress<T> stress(State<T>& state, const PlateKinematics::Rate<T>& rate, double dt) const {
    if (dt == 0) return stress(std::as_const(state), rate.relative_thickness);  // the start of a run, without rates
    const T& stretch = rate.relative_thickness;
    const PlaneTensor<T> curvature = stretch * rate.curvature;  // per height in the reference configuration
    Resultants<T> sum;
    each_layer(state, [&](const auto& material, const auto& numbers, auto& own) {
      [[maybe_unused]] T work = T(0.0), elastic_work = T(0.0);
      constexpr std::size_t n = std::tuple_size_v<std::remove_cvref_t<decltype(own.points)>>;
      std::array<PlaneStressKinematics::Rate<T>, n> strained;
      std::array<PlaneTensor<T>, n> before;
      for (std::size_t i = 0; i < n; ++i) {
        strained[i] = {rate.membrane + T(numbers.z[i]) * curvature};
        before[i] = material.stress(std::as_const(own.points[i]));
      }
      const std::array<PlaneTensor<T>, n> after = stresses(material, own.points, strained, dt);
      for (std::size_t i = 0; i < n; ++i) {
        const auto& point = own.points[i];
        const T z = T(numbers.z[i]), weight = T(numbers.weight[i]);
        const PlaneTensor<T>& sigma = after[i];
        const PlaneTensor<T> change = sigma - before[i];
        sum.add(z, weight, sigma);
        sum.normal_rate += weight * material.normal_rate(point, strained[i], dt, change);
        if constexpr (instantaneous) {
          const PlaneTensor<T> e = T(dt) * strained[i].rate_of_deformation;
          const double Q = numbers.elastic.moduli.normal, G = numbers.elastic.moduli.shear;
          work += weight * double_dot(change, e);
          elastic_work += weight * ((Q - 2 * G) * (trace(e) * trace(e)) + (2 * G) * double_dot(e, e));
        }
      }
      if constexpr (instantaneous) own.share = shear_.share(own.share, work, elastic_work);
    });

    if constexpr (instantaneous) {
      const TransverseShear<T> now = strike::transverse_shear<T>([&](auto f) {
        each_layer(state, [&](const auto&, const auto& numbers, const auto& own) {
          const auto& [h, moduli] = numbers.elastic;
          f(ShearLayer<T>{T(h), {own.share * T(moduli.normal), own.share * T(moduli.shear)}});
        });
      });
      state.shear_stiffness = shear_.limited(state.shear_stiffness, now.stiffness);
    }
    state.shear += (T(dt) * stretch * stiffness(state)) * rate.shear;
    if constexpr (can_fail) state.shear = T(select(intact(state) > 0.0, T(1.0), T(0.0))) * state.shear;
    return sum.stress(stretch, state.shear, 1 / thickness_);
  }

  /// The resultants of what is remembered.
  template <class T>
  PlateKinematics::Stress<T> stress(const State<T>& state, const T& relative_thickness = T(1.0)) const {
    Resultants<T> sum;
    each_layer(state, [&](const auto& material, const auto& numbers, const auto& own) {
      for (std::size_t i = 0; i < own.points.size(); ++i)
        sum.add(T(numbers.z[i]), T(numbers.weight[i]), material.stress(own.points[i]));
    });
    return sum.stress(relative_thickness, state.shear, 0);
  }

  /// Those of the elastic layers.
  template <class T>
  PlateKinematics::Moduli<T> moduli(const State<T>& state, const PlateKinematics::Rate<T>& rate) const {
    const T& t = rate.relative_thickness;
    const auto scaled = [](const T& c, const PlaneModuli<double>& m) -> PlaneModuli<T> {
      return {c * T(m.normal), c * T(m.shear)};
    };
    return {scaled(t, extension_), scaled(t * t, coupling_), scaled(t * t * t, bending_), t * stiffness(state)};
  }

  /// 1 while any point is intact.
  template <class T>
    requires can_fail
  T intact(const State<T>& state) const {
    T intact = T(0.0);
    each_layer(state, [&](const auto& material, const auto&, const auto& own) {
      if constexpr (detail::CanFail<std::remove_cvref_t<decltype(material)>>)
        for (const auto& point : own.points) intact = max(intact, T(material.intact(point)));
      else
        intact = T(1.0);
    });
    return intact;
  }

  /// The transverse shear stress (tau_xz, tau_yz) in layer k at xi of its thickness, from 0 at its bottom to 1 at its
  /// top: so between layers k and k + 1 it is that of (k, 1). By the flow of elastic layers, over the length of an
  /// EffectiveShear.
  template <class T>
  Vector2<T> shear_stress(const State<T>& state, std::size_t k, double xi) const {
    Vector2<T> tau = Vector2<T>::Zero();
    std::size_t layer_k = 0;
    each_piece([&](auto i) {
      for (const auto& numbers : detail::get<i>(numbers_))
        if (layer_k++ == k) tau = T(numbers.flow(xi)) * state.shear;
    });
    return tau;
  }

 private:
  /// N, M and d_zz on the way: int sigma (1, z) dz in the reference thickness.
  template <class T>
  struct Resultants {
    PlaneTensor<T> force{}, moment{};
    T normal_rate = T(0.0);

    void add(const T& z, const T& weight, const PlaneTensor<T>& sigma) {
      const PlaneTensor<T> share = weight * sigma;
      force += share, moment += z * share;
    }
    PlateKinematics::Stress<T> stress(const T& stretch, const Vector2<T>& shear, double per_thickness) const {
      return {stretch * force, (stretch * stretch) * moment, shear, per_thickness * normal_rate};
    }
  };

  /// Of the points of a layer, at once where its material can.
  template <class M, class P, class T, std::size_t n>
  static std::array<PlaneTensor<T>, n> stresses(const M& material, std::array<P, n>& points,
                                                const std::array<PlaneStressKinematics::Rate<T>, n>& rates, double dt) {
    if constexpr (requires { material.stresses(points, rates, dt); }) {
      return material.stresses(points, rates, dt);
    } else {
      std::array<PlaneTensor<T>, n> stresses;
      for (std::size_t i = 0; i < n; ++i) stresses[i] = material.stress(points[i], rates[i], dt);
      return stresses;
    }
  }

  template <std::size_t i>
  const auto& layer() const {
    const auto& piece = detail::get<i>(pieces_);
    return detail::Piece<std::remove_cvref_t<decltype(piece)>>::layer(piece);
  }
  /// f(material, numbers, state) for every layer, bottom to top.
  template <class S, class F>
  void each_layer(S& state, F f) const {
    each_piece([&](auto i) {
      const auto& numbers = detail::get<i>(numbers_);
      auto& own = detail::get<i>(state.pieces);
      for (std::size_t p = 0; p < numbers.size(); ++p) f(layer<i>().material, numbers[p], own[p]);
    });
  }

  template <class T>
  T stiffness(const State<T>& state) const {
    if constexpr (instantaneous)
      return state.shear_stiffness;
    else
      return (void)state, T(shear_stiffness_);
  }

  /// Heights, weights and integrals over the thickness.
  [[gnu::cold]] void measure(double offset) {
    each_piece([&](auto i) {
      const auto& piece = detail::get<i>(pieces_);
      const std::size_t count = detail::Piece<std::remove_cvref_t<decltype(piece)>>::count(piece);
      if constexpr (is_plies[i]) detail::get<i>(numbers_).resize(count);
      const double h = layer<i>().thickness;
      if (!(h >= 0))
        throw Error(detail::joined({"strike: layer ", std::to_string(layers_), " of a section has the thickness ",
                                    detail::text(h), ": give 0 or more."}));
      layers_ += count, thickness_ += static_cast<double>(count) * h;
    });
    if (!(thickness_ > 0)) throw Error("strike: a section has no thickness: give one of its layers more than 0.");

    double bottom = offset - 0.5 * thickness_;
    each_piece([&](auto i) {
      using L = std::remove_cvref_t<decltype(layer<i>())>;
      const auto& [material, h, rule] = layer<i>();
      const PlaneModuli<double> moduli = at_rest(material);
      for (auto& numbers : detail::get<i>(numbers_)) {
        const double z = bottom + 0.5 * h, z2 = z * z + h * h / 12;
        for (std::size_t p = 0; p < numbers.z.size(); ++p) {
          numbers.z[p] = z + 0.5 * h * L::Rule::points[p];
          numbers.weight[p] = 0.5 * h * L::Rule::weights[p];
        }
        numbers.elastic = {h, moduli};
        const auto integrate = [&](PlaneModuli<double>& sum, double weight) {
          sum.normal += weight * moduli.normal, sum.shear += weight * moduli.shear;
        };
        integrate(extension_, h), integrate(coupling_, h * z), integrate(bending_, h * z2);
        mass_ += h * density_of(material), rotary_inertia_ += h * z2 * density_of(material);
        bottom += h;
      }
    });

    const auto layers = [&](auto f) {
      each_piece([&](auto i) {
        for (const auto& numbers : detail::get<i>(numbers_)) f(numbers.elastic);
      });
    };
    elastic_shear_ = strike::transverse_shear<double>(layers);
    shear_stiffness_ = shear_.stiffness(elastic_shear_);
    std::vector<ShearFlow<double>> flows;
    each_shear_flow(elastic_shear_, layers, [&](const ShearLayer<double>& layer, const ShearFlow<double>& flow) {
      if constexpr (detail::RecoversFlow<Shear>)
        flows.push_back(shear_.flow(elastic_shear_, layer, flow));
      else
        flows.push_back(flow);
    });
    std::size_t k = 0;
    each_piece([&](auto i) {
      for (auto& numbers : detail::get<i>(numbers_)) numbers.flow = flows[k++];
    });
  }

  template <class M>
  static PlaneModuli<double> at_rest(const M& material) {
    typename M::template State<double> state{};
    if constexpr (detail::Begins<M>) material.begin(state);
    return material.moduli(state, PlaneStressKinematics::Rate<double>{});
  }

  detail::List<Pieces...> pieces_;
  detail::List<typename detail::Piece<Pieces>::Numbers...> numbers_;
  [[no_unique_address]] Shear shear_;
  TransverseShear<double> elastic_shear_;
  PlaneModuli<double> extension_{}, coupling_{}, bending_{};
  double mass_ = 0, thickness_ = 0, rotary_inertia_ = 0, shear_stiffness_ = 0;
  std::size_t layers_ = 0;
};

/// The section of one layer: Homogeneous{material, thickness}, then a rule, a shear policy, an Offset.
template <class M, ThicknessRule R = Simpson<5>, class... Options>
struct Homogeneous : Layered<Layer<M, R>, Options...> {
  Homogeneous(const M& material, double thickness, const R& rule, const Options&... options)
      : Layered<Layer<M, R>, Options...>(Layer<M, R>{material, thickness, rule}, options...) {}
  Homogeneous(const M& material, double thickness, const Options&... options)
      : Homogeneous(material, thickness, R{}, options...) {}
};
template <class M, class... Options>
Homogeneous(M, double, Options...) -> Homogeneous<M, Simpson<5>, Options...>;
template <class M, ThicknessRule R, class... Options>
Homogeneous(M, double, R, Options...) -> Homogeneous<M, R, Options...>;

}  // namespace strike
