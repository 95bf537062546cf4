#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/dynamics/debris.hpp>
#include <strike/dynamics/kept.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/removal.hpp>
#include <strike/element/element.hpp>
#include <strike/element/merged_corners.hpp>
#include <strike/error.hpp>
#include <strike/material/material.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/motion/gather.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The type of a value per element: a number in lanes becomes a double, a tensor or vector of such one of doubles.
template <class Value>
struct ElementValue {
  using Number = Value;
  using type = double;
};
template <class T>
struct ElementValue<SymmetricTensor<T>> {
  using Number = T;
  using type = SymmetricTensor<double>;
};
template <class T>
struct ElementValue<PlaneTensor<T>> {
  using Number = T;
  using type = PlaneTensor<double>;
};
template <class T, int rows, int columns, int options>
struct ElementValue<Eigen::Matrix<T, rows, columns, options>> {
  using Number = T;
  using type = Eigen::Matrix<double, rows, columns>;
};

/// The state of a material point: that of the material, or of a section that of the points in its first layer.
template <class M, class T>
struct PointStateOf {
  using type = typename M::template State<T>;
};
template <class M, class T>
  requires requires { typename M::template PointState<T>; }
struct PointStateOf<M, T> {
  using type = typename M::template PointState<T>;
};

/// The type of f(state of a point) in lanes of T: a built-in number, the same in all lanes, as a double.
template <class F, class M, class T>
struct PointValueOf {
  using Value = std::remove_cvref_t<std::invoke_result_t<const F&, const typename PointStateOf<M, T>::type&>>;
  using type = std::conditional_t<std::is_arithmetic_v<Value>, double, Value>;
};
template <class F, class M, class T>
using PointValue = typename PointValueOf<F, M, T>::type;

/// f(section, its state, further arguments) is a number.
template <class F, class M, class T, class... More>
concept ValueOfSection = std::same_as<typename M::Kinematics, PlateKinematics> &&
                         requires(const F f, const M section, const typename M::template State<T> state, More... more) {
                           { f(section, state, more...) } -> std::convertible_to<T>;
                         };

/// The elements of a part in memory: model, material, and states in blocks of lanes, neighbours together. Elements are
/// known by their places, lane after lane and block after block; `order[p]` is the user's number of that at place p.
template <class E, class M, class T, class Removal>
struct Elements {
  static constexpr std::size_t n = static_cast<std::size_t>(E::nodes);
  static constexpr std::size_t width = lanes<T>;
  static constexpr bool erodes = !std::same_as<Removal, NoErosion>;
  static constexpr bool has_geometry = needs_geometric_strain<Removal, M, E::nodes>();
  static constexpr bool measures_strain = has_geometry || has_plastic_strain<M>();
  static constexpr bool is_born = strike::detail::is_born<Removal>;
  static constexpr bool averages_volume = requires { requires E::averages_volume; };
  static constexpr bool merges = merges_corners<E>();
  using State = typename E::template State<M, T>;
  /// Elements of such a part may give no force any more.
  static constexpr bool loses_elements = erodes || requires(const M m, const State s) { m.intact(s.material); };

  struct Nothing {};
  struct Block {
    BlockNodes<n, width> nodes;
    State state;
    [[no_unique_address]] std::conditional_t<erodes, RemovalState<T, has_geometry>, Nothing> removal{};
    [[no_unique_address]] std::conditional_t<is_born, Birth<T>, NoBirth> birth{};
  };

  E element;
  M material;
  [[no_unique_address]] Removal removal;
  std::size_t size;    ///< number of elements
  std::size_t number;  ///< of the part among those of the scene, from 0
  Kept<Index> order;
  Kept<Block> blocks{};
  [[no_unique_address]] std::conditional_t<merges, std::vector<MergedCorners<T>>, Nothing> merged{};  ///< of blocks

  /// Elements of block b have corners in the same node.
  bool merges_in(std::size_t b) const {
    if constexpr (merges)
      return !merged.empty() && any(merged[b].wedge + merged[b].pyramid > 0.0);
    else
      return (void)b, false;
  }
  /// Their part in the bounds of the vibrations, at the positions of their corners; nothing: there are none.
  std::optional<MergedGradient<T>> merged_in(std::size_t b, const NodalField<LaneOf<T>>& positions) const
    requires merges
  {
    if (!merges_in(b)) return std::nullopt;
    return MergedGradient<T>(merged[b], gather<T, n>(positions, blocks[b].nodes));
  }
  /// Sets the elements of block b at rest, as E::begin does.
  auto begin_block(std::size_t b, const Nodal<T, E::nodes>& x,
                   [[maybe_unused]] const NodalField<LaneOf<T>>& positions) {
    if constexpr (requires { blocks[b].state.mass_factor; } && merges)
      return element.begin(blocks[b].state, material, x, merged_in(b, positions));
    else
      return element.begin(blocks[b].state, material, x);
  }
  /// Their critical rate, from that by the masses of corners, which is 0 of those that have failed.
  [[gnu::noinline]] T merged_rate(std::size_t b, const NodalField<LaneOf<T>>& positions, const T& rate, const T& V,
                                  const VibrationSources<T>& sources) const
    requires merges
  {
    const T own = element.merged_rate(blocks[b].state, material, *merged_in(b, positions), V, sources);
    return select(rate > 0.0, own, rate);
  }
  /// The cell of the element at a place, of `cells` by their numbers; if it merges corners as canonical_hexahedron has
  /// it.
  template <class Cells>
  std::array<Index, n> take(const Cells& cells, std::size_t place) {
    std::array<Index, n> cell = cells[order[place]];
    if constexpr (merges) {
      const DegenerateHexahedron degenerate(cell);
      if (degenerate.kind != HexahedronKind::wedge && degenerate.kind != HexahedronKind::pyramid) return cell;
      merged.resize(blocks.size());
      MergedCorners<T>& in_block = merged[place / width];
      T& lanes_of_kind = degenerate.kind == HexahedronKind::wedge ? in_block.wedge : in_block.pyramid;
      set_lane(lanes_of_kind, place % width, RealOf<T>(1));
      cell = in_order(cell, degenerate.order);
    }
    return cell;
  }

  /// The lanes of block b that hold elements: the first ones.
  std::size_t count(std::size_t b) const { return b + 1 < blocks.size() ? width : size - b * width; }
  /// 1 in those lanes of the last block, 0 in the idle ones, which repeat the last element.
  T busy() const {
    T ones = T(0.0);
    for (std::size_t l = 0; l < count(blocks.size() - 1); ++l) set_lane(ones, l, RealOf<T>(1));
    return ones;
  }

  /// The values of elements, by their numbers, in the lanes of block b.
  T in_lanes(std::size_t b, const std::vector<double>& values) const {
    T in_lanes = T(0.0);
    for (std::size_t l = 0; l < width; ++l)
      set_lane(in_lanes, l, static_cast<RealOf<T>>(values[order[std::min(b * width + l, size - 1)]]));
    return in_lanes;
  }

  /// The size of the part, if other processes have the element. Error: there is no element of this number.
  std::size_t place_of(std::size_t e) const {
    if (e >= size)
      throw Error(joined({"strike: part ", std::to_string(number), " has no element ", std::to_string(e),
                          "; count its ", std::to_string(size), " elements from 0."}));
    const auto found = std::find(order.begin(), order.end(), e);
    return found == order.end() ? size : order.first() + static_cast<std::size_t>(found - order.begin());
  }
  /// The numbers of the nodes of the element at a place.
  template <class N>
  std::array<Index, n> cell(const N& nodes, std::size_t place) const {
    std::array<Index, n> c;
    for (std::size_t i = 0; i < n; ++i) c[i] = nodes.number(blocks[place / width].nodes[i][place % width]);
    return c;
  }
  /// "element 7 of part 0 at (x, y, z)", of the element at a place.
  template <class N>
  [[gnu::cold]] std::string describe(const N& nodes, std::size_t place) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    const std::array<Index, n> corners = cell(nodes, place);
    for (std::size_t i = 0; i < n; ++i) {
      if (n == 8 && std::find(corners.begin(), corners.begin() + i, corners[i]) != corners.begin() + i) continue;
      sum += nodes.x(corners[i]).template cast<double>(), count += 1;
    }
    return joined({"element ", std::to_string(order[place]), " of part ", std::to_string(number), " at ",
                   text(Eigen::Vector3d((1 / count) * sum))});
  }

  /// The same of the first element whose state is NaN; empty: there is none.
  template <class N>
  [[gnu::cold]] std::string describe_nan(const N& nodes) const {
    for (std::size_t place = blocks.first() * width; place < std::min(blocks.last() * width, size); ++place) {
      bool is_nan = false;
      const auto look = [&](const auto& numbers) {
        for (const T& one : numbers_of<T>(numbers))
          is_nan = is_nan || std::isnan(static_cast<double>(lane(one, place % width)));
      };
      const State& state = blocks[place / width].state;
      if constexpr (std::is_trivially_destructible_v<State>)
        look(state);
      else  // a list of points
        state.each_point(look);
      if (is_nan) return describe(nodes, place);
    }
    return {};
  }
  // Values of the elements, place by place, where their blocks are kept.

  /// False if deleted.
  std::vector<char> alive() const {
    std::vector<char> alive(size, true);
    if constexpr (erodes)
      for (std::size_t b = blocks.first(); b < blocks.last(); ++b)
        for (std::size_t l = 0; l < count(b); ++l) alive[b * width + l] = lane(blocks[b].removal.alive, l) > 0;
    return alive;
  }

  /// The mean over the points that visit(state, add) adds as f(point). Error: it
  /// adds none.
  template <class F, class Visit>
  auto mean_over_points(const F& f, const Visit& visit) const {
    using Sum = PointValue<F, M, T>;
    using Number = typename ElementValue<Sum>::Number;  // T, or of a value that is the same in all lanes double
    std::vector<typename ElementValue<Sum>::type> values(size);
    for (std::size_t b = blocks.first(); b < blocks.last(); ++b) {
      Sum sum;
      const auto in_sum = numbers_of<Number>(sum);
      std::fill(in_sum.begin(), in_sum.end(), Number(0.0));
      double points = 0;
      visit(blocks[b].state, [&](const auto& point) {
        const Sum value = Sum(f(point));
        const auto in_value = numbers_of<Number>(value);
        for (std::size_t k = 0; k < in_sum.size(); ++k) in_sum[k] += in_value[k];
        points += 1;
      });
      if (!(points > 0))
        throw Error(joined({"strike: the elements of part ", std::to_string(number),
                            " have no point of material, so there is no field of it; visit them in each_point."}));
      for (std::size_t l = 0; l < count(b); ++l) {
        const auto in_element = numbers_of<double>(values[b * width + l]);
        for (std::size_t k = 0; k < in_sum.size(); ++k)
          in_element[k] = static_cast<double>(lane(in_sum[k], l)) / points;
      }
    }
    return values;
  }

  /// f(state of an element), a number.
  template <class F>
  std::vector<double> per_element(const F& f) const {
    std::vector<double> values(size);
    for (std::size_t b = blocks.first(); b < blocks.last(); ++b) {
      const T value = f(blocks[b].state);
      for (std::size_t l = 0; l < count(b); ++l) values[b * width + l] = static_cast<double>(lane(value, l));
    }
    return values;
  }

  /// Of every element: the mean over its points of f(point), or of a section f(section, its state).
  template <class F>
  auto field(const F& f) const {
    check_ranges(f);
    if constexpr (ValueOfSection<F, M, T>)
      return per_element([&](const State& state) { return f(material, state.material); });
    else
      return mean_over_points(
          f, [&](const State& state, const auto& add) { state.each_point([&](const auto& point) { add(point); }); });
  }
  /// The same of layer k. Error: it has none.
  template <class F>
  auto field(std::size_t k, const F& f) const {
    check_ranges(f);
    if constexpr (ValueOfSection<F, M, T, std::size_t>) {
      check_layer(k);
      return per_element([&](const State& state) { return f(material, state.material, k); });
    } else {
      return mean_over_layer(k, f);
    }
  }

  static constexpr bool has_layers = requires(const State s) { s.each_point(std::size_t{}, PointVisitor{}); };
  /// The same over the points of layer k. Error: it has none.
  template <class F>
  auto mean_over_layer(std::size_t k, const F& f) const {
    static_assert(has_layers, "strike: the elements of this part have no layers: leave the layer out, as in field(f).");
    if constexpr (has_layers) {
      check_layer(k);
      return mean_over_points(
          f, [&](const State& state, const auto& add) { state.each_point(k, [&](const auto& point) { add(point); }); });
    } else {
      return std::vector<double>{};
    }
  }
  [[gnu::cold]] void check_layer(std::size_t k) const {
    const auto exists = [&](std::size_t layer) {
      bool any = false;
      blocks[blocks.first()].state.each_point(layer, [&](const auto&) { any = true; });
      return any;
    };
    if (exists(k)) return;
    std::size_t layers = 0;
    while (exists(layers)) ++layers;
    throw Error(joined({"strike: part ", std::to_string(number), " has no layer ",
                        std::to_string(static_cast<std::ptrdiff_t>(k)), "; count its ", std::to_string(layers),
                        layers == 1 ? " layer" : " layers", " from 0 at the bottom."}));
  }
};

}  // namespace strike::detail
