#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/range.hpp>
#include <strike/section/fibres.hpp>
#include <strike/section/laminate_stiffness.hpp>
#include <strike/section/linear_stress.hpp>
#include <strike/section/piece.hpp>
#include <strike/section/slots.hpp>
#include <strike/text.hpp>

namespace strike {

/// The section of a plate: layers from the bottom to the top, each with its own model and rule, or Plies of them; then,
/// if wanted, an Offset and the source of the transverse shear stiffness.
///   Layered{Layer{glass, 3.0}, Layer{interlayer, 0.76, Simpson<3>{}}, Layer{glass, 3.0}, EffectiveShear{.length =
///   300}}
/// A point at the height z is strained by membrane + z curvature; N, M = int sigma (1, z) dz; dQ = K gamma dt. The
/// heights grow with the thickness of the plate. Layers fail on their own; a failed one carries no stress.
///   Layered{LayUp{carbon, 0.125, {0, 45, -45, 90, 90, -45, 45, 0}}, FibreDirection{{1, 0, 0}}}
/// With fibres it works in the axes of their FibreDirection, and turns what it is told and answers: stresses are those
/// along and across the fibres of a ply, shear forces those along and across the direction.
/// Errors: a thickness below zero, or none.
template <class... Pieces>
class Layered {
  static constexpr bool known = (detail::Piece<Pieces>::is_known && ...),
                        has_layers = (detail::Piece<Pieces>::is_layer || ...),
                        unique = (detail::Piece<Pieces>::is_shear + ... + 0) <= 1 &&
                                 (detail::Piece<Pieces>::is_offset + ... + 0) <= 1;

 public:
  /// Some layer has fibres.
  static constexpr bool has_fibres = (detail::Piece<Pieces>::has_fibres || ...);

 private:
  using Shear = decltype(detail::shear_of(std::declval<Pieces>()...));
  static constexpr bool directed = (detail::Piece<Pieces>::is_direction + ... + 0) == (has_fibres ? 1 : 0),
                        shear_serves = !has_fibres || FibreShearPolicy<Shear>;
  static_assert(known,
                "strike: a Layered is made of Layer{material, thickness}, bottom first, Plies{layer, count}, "
                "LayUp{ply, thickness, {angles}} or PlyStack{{Ply{...}, ...}}; then an Offset{height}, one of "
                "EnergyShear, EffectiveShear, "
                "FiveSixthsShear and InstantaneousShear, and of plies with fibres a FibreDirection{vector}.");
  static_assert(!known || has_layers, "strike: a Layered needs at least one Layer{material, thickness}.");
  static_assert(unique, "strike: a Layered takes one shear policy and one Offset at most.");
  static_assert(!known || !has_layers || !unique || directed || !has_fibres,
                "strike: the fibres of a Layered have one direction from which their angles count: add one "
                "FibreDirection{{x, y, z}} after its layers.");
  static_assert(!known || !has_layers || !unique || directed || has_fibres,
                "strike: no layer of this Layered has fibres: leave out its FibreDirection.");
  static_assert(!known || !has_layers || !unique || !directed || shear_serves,
                "strike: the shear policy of plies with fibres is EnergyShear{}, which is there without a word, or "
                "FiveSixthsShear{}; this one knows isotropic layers alone.");
  static_assert((instantiates(static_cast<detail::ShearReport<Pieces>*>(nullptr)) && ...));

  using Flow = ShearFlow<std::conditional_t<has_fibres, Matrix2, double>>;
  static constexpr bool instantaneous = requires { typename Shear::template State<double>; };
  static constexpr bool begins = instantaneous || (detail::Piece<Pieces>::begins || ...);
  static constexpr bool can_fail = (detail::Piece<Pieces>::can_fail || ...);
  static constexpr std::array<bool, sizeof...(Pieces)> is_plies{detail::Piece<Pieces>::is_plies...};

 public:
  static constexpr bool sound =
      known && has_layers && unique && directed && shear_serves && (detail::Piece<Pieces>::is_sound && ...);
  using Kinematics = PlateKinematics;
  /// Points of some layer can flow.
  static constexpr bool has_plastic_strain = (detail::Piece<Pieces>::has_plastic_strain || ...);
  /// The state of the points in the lowest layer.
  template <class T>
  using PointState = typename detail::FirstLayer<Pieces...>::template PointState<T>;

  /// Per layer the states of its points and that of the shear policy; the shear force.
  template <class T>
  struct State : detail::ShearState<Shear, T>, detail::Heading<has_fibres, T> {
    detail::List<typename detail::Piece<Pieces>::template State<Shear, T>...> pieces;
    Vector2<T> shear = Vector2<T>::Zero();  ///< Q [force/length], with fibres in the axes of their direction

    /// f(k, layer) for every layer, from k = 0 at the bottom; layer.points are the states of its material.
    template <class F>
    void each_layer(F f) const {
      std::size_t k = 0;
      detail::each_layered_piece<Pieces...>([&](auto i) {
        for (const auto& layer : detail::get<i>(pieces)) f(k++, layer);
      });
    }
    /// All its numbers beside those of another, where Plies make it a list.
    template <class F>
    void visit_numbers(const State& other, const F& f) {
      const auto visit = [&]<class A>(A& own, const A& others) { strike::visit_numbers<T>(own, others, f); };
      visit.template operator()<detail::ShearState<Shear, T>>(*this, other);
      visit.template operator()<detail::Heading<has_fibres, T>>(*this, other);
      detail::each_layered_piece<Pieces...>([&](auto i) {
        auto& layers = detail::get<i>(pieces);
        for (std::size_t p = 0; p < layers.size(); ++p) visit(layers[p], detail::get<i>(other.pieces)[p]);
      });
      visit(shear, other.shear);
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
    if constexpr (sound) {
      if constexpr (has_fibres) fibres_.direction = detail::direction_of(pieces...);
      measure(detail::offset_of(pieces...));
    }
  }

  void ranges(const auto& number) const {
    std::size_t k = 0;
    const auto visit = [&](const auto& piece) {
      using P = detail::Piece<std::remove_cvref_t<decltype(piece)>>;
      if constexpr (P::is_layer)
        number(piece, detail::joined({"layer ", std::to_string(k)})), k += P::count(piece);
      else
        number(piece);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (visit(detail::get<i>(pieces_)), ...);
    }(std::index_sequence_for<Pieces...>{});
  }

  double density() const { return integrals_.mass; }
  double thickness() const { return thickness_; }
  /// Of its middle from the surface of the nodes [length].
  double offset() const { return offset_; }
  double rotary_inertia() const { return integrals_.rotary_inertia; }
  std::size_t layers() const { return layers_; }
  /// The closed form of its elastic layers, and the stiffness that the policy makes of it; with fibres a LaminateShear
  /// and a Matrix2.
  const auto& transverse_shear() const {
    if constexpr (has_fibres)
      return fibres_.shear;
    else
      return elastic_shear_;
  }
  auto shear_stiffness() const {
    if constexpr (has_fibres)
      return fibres_.shear_stiffness;
    else
      return shear_stiffness_;
  }
  /// A, B and D at the start, in the axes of the FibreDirection.
  const LaminateStiffness& laminate_stiffness() const
    requires has_fibres
  {
    return fibres_.stiffness;
  }

  /// Sets the FibreDirection of a plate whose frame has the axes e1 and e2, at the start.
  template <class T>
    requires has_fibres
  void align(State<T>& state, const Vector3<T>& e1, const Vector3<T>& e2) const {
    state.align(fibres_.direction, e1, e2);
  }
  /// False if that direction is normal to the plate in this lane.
  template <class T>
    requires has_fibres
  bool is_aligned(const State<T>& state, std::size_t l) const {
    return lane(state.heading.cosine, l) != 0 || lane(state.heading.sine, l) != 0;
  }

  /// A text for the user, empty if there is nothing to say: of the materials, and of the shear over half waves of a
  /// length, such as four elements.
  [[gnu::cold]] std::string warning(double length = 0) const {
    std::string all;
    const auto add = [&](const std::string& warning) {
      if (!warning.empty() && all.find(warning) == std::string::npos) all += (all.empty() ? "" : " ") + warning;
    };
    each_piece([&](auto i) {
      if constexpr (detail::Warns<std::remove_cvref_t<decltype(layer<i>(0).material)>>)
        for (std::size_t p = 0; p < detail::get<i>(measured_).size(); ++p) add(layer<i>(p).material.warning());
    });
    if constexpr (detail::warns_of_shear<Shear> && !has_fibres) add(shear_.warning(elastic_shear_, length));
    return all;
  }

  /// The stresses of its points that are linear over the plane of a plate, for PhysicalHourglass.
  template <class T>
  struct LinearState {
    detail::List<typename detail::Piece<Pieces>::template LinearState<T>...> pieces;

    template <class F>
    void visit_numbers(const LinearState& other, const F& f) {
      detail::each_layered_piece<Pieces...>([&](auto i) {
        auto& layers = detail::get<i>(pieces);
        for (std::size_t p = 0; p < layers.size(); ++p)
          strike::visit_numbers<T>(layers[p], detail::get<i>(other.pieces)[p], f);
      });
    }
  };
  template <class T>
  void begin(LinearState<T>& linear) const {
    linear = {};
    each_piece([&](auto i) {
      if constexpr (is_plies[i]) detail::get<i>(linear.pieces).resize(detail::get<i>(measured_).size());
    });
  }

  /// The state at rest.
  template <class T>
    requires begins
  void begin(State<T>& state) const {
    state = {};
    each_piece([&](auto i) {
      auto& layers = detail::get<i>(state.pieces);
      if constexpr (is_plies[i]) layers.resize(detail::get<i>(measured_).size());
      if constexpr (detail::Begins<std::remove_cvref_t<decltype(layer<i>(0).material)>>)
        for (std::size_t p = 0; p < layers.size(); ++p)
          for (auto& point : layers[p].points) layer<i>(p).material.begin(point);
    });
    if constexpr (instantaneous) state.shear_stiffness = T(shear_stiffness_);
  }

  template <class T>
  PlateKinematics::Stress<T> stress(State<T>& state, const PlateKinematics::Rate<T>& rate, double dt) const {
    const auto none = [](auto...) { return NoLinear{}; };
    if constexpr (has_fibres)
      return state.back(advance(state, state.into(rate), dt, none));
    else
      return advance(state, rate, dt, none);
  }
  /// The same with the linear stresses, which flow together with the others; gives their resultants too.
  template <class T>
  PlateKinematics::Stress<T> stress(State<T>& state, LinearState<T>& linear, const PlateKinematics::Rate<T>& rate,
                                    const LinearRate<T>& linear_rate, double dt, LinearResultants<T>& resultants) const
    requires(!has_fibres)
  {
    const T& stretch = rate.relative_thickness;
    resultants = {};
    const auto stress = advance(state, rate, dt, [&](auto i, std::size_t p) {
      return Linear<T, std::remove_reference_t<decltype(detail::get<i>(linear.pieces)[p])>>{
          detail::get<i>(linear.pieces)[p], linear_rate, stretch * linear_rate.curvature, resultants};
    });
    if (dt == 0)
      each_piece([&](auto i) {
        const auto& measured = detail::get<i>(measured_);
        for (std::size_t p = 0; p < measured.size(); ++p)
          for (std::size_t k = 0; k < measured[p].z.size(); ++k)
            resultants.add(measured[p].z[k], measured[p].weight[k], detail::get<i>(linear.pieces)[p][k]);
      });
    resultants.force = stretch * resultants.force, resultants.moment = (stretch * stretch) * resultants.moment;
    resultants.power_before = stretch * resultants.power_before;
    return stress;
  }

  /// The resultants of the remembered stresses.
  template <class T>
  PlateKinematics::Stress<T> stress(const State<T>& state, const T& relative_thickness = T(1.0)) const {
    if constexpr (has_fibres)
      return state.back(remembered(state, relative_thickness));
    else
      return remembered(state, relative_thickness);
  }

  /// Bounds of the tangent, those of the elastic layers.
  template <class T>
  PlateKinematics::Moduli<T> moduli(const State<T>& state, const PlateKinematics::Rate<T>& rate) const {
    return integrals_.moduli<T>(rate.relative_thickness, stiffness(state));
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
  /// top; between layers k and k + 1 it is that of (k, 1). By the flow of elastic layers, over the length of an
  /// EffectiveShear; with fibres in the axes of their direction.
  template <class T>
  Vector2<T> shear_stress(const State<T>& state, std::size_t k, double xi) const {
    Vector2<T> tau = Vector2<T>::Zero();
    std::size_t layer_k = 0;
    each_piece([&](auto i) {
      for (const auto& measured : detail::get<i>(measured_))
        if (layer_k++ == k) tau = detail::in_plane_times<T>(measured.flow(xi), state.shear);
    });
    return tau;
  }

 private:
  /// Absence of linear stresses in a layer.
  struct NoLinear {};
  /// The linear stresses of a layer in a step; the curvature is per reference height.
  template <class T, class Stresses>
  struct Linear {
    Stresses& stresses;
    const LinearRate<T>& rate;
    AlongEdges<T> curvature;
    LinearResultants<T>& sum;
  };

  template <class T>
  PlateKinematics::Stress<T> remembered(const State<T>& state, const T& relative_thickness) const {
    detail::Resultants<T> sum;
    each_layer(state, [&](const auto& material, const auto& measured, const auto& own) {
      detail::Resultants<T> of_layer;
      auto& own_sum = turns<std::remove_cvref_t<decltype(measured)>> ? of_layer : sum;
      for (std::size_t i = 0; i < own.points.size(); ++i)
        own_sum.add(T(measured.z[i]), T(measured.weight[i]), material.stress(own.points[i]));
      add_turned(measured, of_layer, sum);
    });
    return sum.stress(relative_thickness, state.shear, 0);
  }

  /// A layer's own axes are not those of the section.
  template <class Measured>
  static constexpr bool turns = requires(const Measured measured) { measured.turn; };
  /// Adds the resultants of a layer that has axes of its own.
  template <class Measured, class T>
  static void add_turned([[maybe_unused]] const Measured& measured,
                         [[maybe_unused]] const detail::Resultants<T>& of_layer,
                         [[maybe_unused]] detail::Resultants<T>& sum) {
    if constexpr (turns<Measured>) {
      sum.force += measured.turn.back(of_layer.force), sum.moment += measured.turn.back(of_layer.moment);
      sum.normal_rate += of_layer.normal_rate;
    }
  }

  /// Advances all layers; linear(i, p) gives the linear stresses of layer p of piece i.
  template <class T, class F>
  [[gnu::always_inline]] PlateKinematics::Stress<T> advance(State<T>& state, const PlateKinematics::Rate<T>& rate,
                                                            double dt, F linear) const {
    if (dt == 0) return remembered(state, rate.relative_thickness);  // the start of a run, without rates
    const T& stretch = rate.relative_thickness;
    const PlaneTensor<T> curvature = stretch * rate.curvature;  // per height in the reference configuration
    detail::Resultants<T> sum;
    each_piece([&](auto i) {
      const auto& measured = detail::get<i>(measured_);
      auto& own = detail::get<i>(state.pieces);
      for (std::size_t p = 0; p < measured.size(); ++p)
        if constexpr (turns<std::remove_cvref_t<decltype(measured[p])>>) {
          detail::Resultants<T> of_layer;
          const PlaneTurn<double>& turn = measured[p].turn;
          advance<T>(layer<i>(p).material, measured[p], own[p], turn.into(rate.membrane), turn.into(curvature), dt,
                     of_layer, linear(i, p));
          add_turned(measured[p], of_layer, sum);
        } else {
          advance<T>(layer<i>(p).material, measured[p], own[p], rate.membrane, curvature, dt, sum, linear(i, p));
        }
    });
    if constexpr (instantaneous)
      state.shear_stiffness = shear_.limited(state.shear_stiffness, present_shear(state).stiffness);
    if constexpr (has_fibres)
      state.shear += (T(dt) * stretch) * detail::in_plane_times<T>(fibres_.shear_stiffness, rate.shear);
    else
      state.shear += (T(dt) * stretch * stiffness(state)) * rate.shear;
    if constexpr (can_fail) state.shear = T(select(intact(state) > 0.0, T(1.0), T(0.0))) * state.shear;
    return sum.stress(stretch, state.shear, 1 / thickness_);
  }

  /// Advances the points of a layer and adds their stress to the resultants; `curvature` is per reference height.
  template <class T, class M, class Measured, class Own, class L>
  [[gnu::always_inline]] void advance(const M& material, const Measured& measured, Own& own,
                                      const PlaneTensor<T>& membrane, const PlaneTensor<T>& curvature, double dt,
                                      detail::Resultants<T>& sum, [[maybe_unused]] const L& linear) const {
    constexpr std::size_t n = std::tuple_size_v<decltype(Own::points)>;
    constexpr bool is_linear = !std::is_same_v<L, NoLinear>;
    std::array<PlaneStressKinematics::Rate<T>, n> rates;
    std::array<PlaneTensor<T>, n> before;
    struct NoMeter {};
    [[maybe_unused]] std::array<std::conditional_t<is_linear, detail::PlaneFlowMeter<M, T>, NoMeter>, n> meters;
    for (std::size_t i = 0; i < n; ++i) {
      rates[i] = {membrane + T(measured.z[i]) * curvature};
      before[i] = material.stress(std::as_const(own.points[i]));
      if constexpr (is_linear)
        meters[i].start(own.points[i], before[i], rates[i].rate_of_deformation, measured.elastic.moduli, dt);
    }
    std::array<PlaneTensor<T>, n> after = detail::stresses_of(material, own.points, rates, dt);
    if constexpr (is_linear)
      for (std::size_t i = 0; i < n; ++i) {
        const AlongEdges<T> e = linear.rate.membrane + T(measured.z[i]) * linear.curvature;
        linear.sum.power_before += T(measured.weight[i]) * dot(linear.stresses[i], e);
        detail::advance_linear<M, T>(material, own.points[i], meters[i], linear.stresses[i], after[i], T(dt) * e,
                                     linear.rate, rates[i].rate_of_deformation, measured.elastic.moduli, dt);
        linear.sum.add(measured.z[i], measured.weight[i], linear.stresses[i]);
      }
    [[maybe_unused]] detail::LayerWork<T> work;
    for (std::size_t i = 0; i < n; ++i) {
      const T weight = T(measured.weight[i]);
      const PlaneTensor<T> change = after[i] - before[i];
      sum.add(T(measured.z[i]), weight, after[i]);
      sum.normal_rate += weight * material.normal_rate(own.points[i], rates[i], dt, change);
      if constexpr (instantaneous)
        work.add(weight, T(dt) * rates[i].rate_of_deformation, change, measured.elastic.moduli);
    }
    if constexpr (instantaneous) own.share = shear_.share(own.share, work.work, work.elastic);
  }

  /// The closed form of layers with the moduli that they have left.
  template <class T>
  TransverseShear<T> present_shear(const State<T>& state) const {
    return strike::transverse_shear<T>([&](auto f) {
      each_layer(state, [&](const auto&, const auto& measured, const auto& own) {
        const auto& [h, moduli] = measured.elastic;
        f(ShearLayer<T>{T(h), {own.share * T(moduli.normal), own.share * T(moduli.shear)}});
      });
    });
  }

  template <class T>
  T stiffness(const State<T>& state) const {
    if constexpr (instantaneous)
      return state.shear_stiffness;
    else
      return (void)state, T(shear_stiffness_);
  }

  template <class F>
  static void each_piece(F f) {
    detail::each_layered_piece<Pieces...>(f);
  }
  /// Layer p of piece i.
  template <std::size_t i>
  const auto& layer(std::size_t p) const {
    const auto& piece = detail::get<i>(pieces_);
    return detail::Piece<std::remove_cvref_t<decltype(piece)>>::layer(piece, p);
  }
  /// f(material, measured, state) for every layer, bottom to top.
  template <class S, class F>
  void each_layer(S& state, F f) const {
    each_piece([&](auto i) {
      const auto& measured = detail::get<i>(measured_);
      auto& own = detail::get<i>(state.pieces);
      for (std::size_t p = 0; p < measured.size(); ++p) f(layer<i>(p).material, measured[p], own[p]);
    });
  }

  /// Heights, weights, integrals over the thickness, and transverse shear.
  [[gnu::cold]] void measure(double offset) {
    offset_ = offset;
    each_piece([&](auto i) {
      const auto& piece = detail::get<i>(pieces_);
      if constexpr (is_plies[i]) detail::check_ranges(piece);
      const std::size_t count = detail::Piece<std::remove_cvref_t<decltype(piece)>>::count(piece);
      if constexpr (is_plies[i]) detail::get<i>(measured_).resize(count);
      if constexpr (detail::Piece<std::remove_cvref_t<decltype(piece)>>::differ)
        for (std::size_t p = 0; p < count; ++p) add_thickness(1, layer<i>(p).thickness);
      else
        add_thickness(count, layer<i>(0).thickness);
    });
    if (!(thickness_ > 0)) throw Error("strike: a section has no thickness: give one of its layers more than 0.");

    double bottom = offset - 0.5 * thickness_;
    std::vector<detail::LaminaStiffness> laminae;  // of a section with fibres
    each_piece([&](auto i) {
      for (std::size_t p = 0; p < detail::get<i>(measured_).size(); ++p) {
        const auto& [material, h, rule] = layer<i>(p);
        const PlaneModuli<double> moduli = detail::moduli_at_rest(material);
        auto& measured = detail::get<i>(measured_)[p];
        const double z = bottom + 0.5 * h;
        measured.template place<std::remove_cvref_t<decltype(rule)>>(z, h);
        measured.elastic = {h, moduli};
        integrals_.add(h, z, moduli, density_of(material));
        if constexpr (has_fibres) {
          if constexpr (turns<std::remove_cvref_t<decltype(measured)>>) {
            const auto& piece = detail::get<i>(pieces_);
            measured.turn = turn_by_degrees(detail::Piece<std::remove_cvref_t<decltype(piece)>>::angle(piece, p) +
                                            material.fibre_angle());
            laminae.push_back({h, turned_back(material.plane_stiffness(), measured.turn),
                               turned_back(material.transverse_stiffness(), measured.turn)});
          } else {
            laminae.push_back({h, detail::plane_stiffness(moduli), Matrix2(moduli.shear * Matrix2::Identity())});
          }
          fibres_.stiffness.add(h, z, laminae.back().plane);
        }
        bottom += h;
      }
    });

    std::vector<Flow> flows;
    if constexpr (has_fibres) {
      detail::bound_moduli(fibres_.stiffness, integrals_);
      fibres_.shear = detail::laminate_shear(laminae, flows);
      fibres_.shear_stiffness = shear_.stiffness(fibres_.shear);
      shear_stiffness_ = detail::largest_eigenvalue(fibres_.shear_stiffness);
    } else {
      const auto layers = [&](auto f) {
        each_piece([&](auto i) {
          for (const auto& measured : detail::get<i>(measured_)) f(measured.elastic);
        });
      };
      elastic_shear_ = strike::transverse_shear<double>(layers);
      shear_stiffness_ = shear_.stiffness(elastic_shear_);
      flows = detail::shear_flows(shear_, elastic_shear_, layers);
    }
    std::size_t k = 0;
    each_piece([&](auto i) {
      for (auto& measured : detail::get<i>(measured_)) measured.flow = flows[k++];
    });
  }

  [[gnu::cold]] void add_thickness(std::size_t count, double h) {
    const detail::RangeCheck number("Layer", detail::joined({", in layer ", std::to_string(layers_), ","}));
    number("thickness", h, range::not_negative);
    layers_ += count, thickness_ += static_cast<double>(count) * h;
  }

  detail::List<Pieces...> pieces_;
  detail::List<typename detail::Piece<Pieces>::template Measured<Flow>...> measured_;
  [[no_unique_address]] Shear shear_;
  struct NoFibres {};
  [[no_unique_address]] std::conditional_t<has_fibres, detail::FibreSection, NoFibres> fibres_;
  TransverseShear<double> elastic_shear_;
  detail::SectionIntegrals integrals_;
  double thickness_ = 0, offset_ = 0, shear_stiffness_ = 0;
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
