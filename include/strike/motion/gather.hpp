#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The nodes of a block of elements: node[i][l] is node i of the element in lane l.
template <std::size_t n, std::size_t lanes>
using BlockNodes = std::array<std::array<Index, lanes>, n>;

namespace detail {

/// Moves the padded vectors of `lanes<T>` nodes into the lanes of three numbers, and back onto the nodes.
template <class T>
struct Transposer {
  using Places = std::array<Index, lanes<T>>;

  template <class Field>
  static Vector3<T> load(const Field& field, const Places& nodes) {
    Vector3<T> a;
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      const Padded<RealOf<T>>& node = field[nodes[l]];
      set_lane(a(0), l, node[0]), set_lane(a(1), l, node[1]), set_lane(a(2), l, node[2]);
    }
    return a;
  }
  template <class Field>
  static void subtract(const Vector3<T>& a, Field& field, const Places& nodes, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) {
      Padded<RealOf<T>>& node = field[nodes[l]];
      node.set(0, node[0] - lane(a(0), l)), node.set(1, node[1] - lane(a(1), l)), node.set(2, node[2] - lane(a(2), l));
    }
  }
};

/// Transposer for registers of whole quadruples: a node is one load, and quadruples of nodes are transposed in
/// registers.
template <class T, std::size_t N>
  requires(N >= 4 && native_lanes<T> >= 4)
struct Transposer<Pack<T, N>> {
  using Places = std::array<Index, N>;
  static constexpr std::size_t width = N < native_lanes<T> ? N : native_lanes<T>;
  static constexpr std::size_t registers = N / width, quads = width / 4;
  using Wide = typename Register<T, width>::type;
  using Quad = typename Register<T, 4>::type;

  /// Within each quadruple of the result the four picks p0..p3 of (a, b), of which b counts from 4.
  template <int p0, int p1, int p2, int p3>
  static Wide mix(const Wide& a, const Wide& b) {
    constexpr auto from = [](int i) {
      constexpr int pick[4] = {p0, p1, p2, p3};
      const int p = pick[i % 4];
      return i / 4 * 4 + p % 4 + (p < 4 ? 0 : static_cast<int>(width));
    };
    return [&]<int... i>(std::integer_sequence<int, i...>) -> Wide {
      return __builtin_shufflevector(a, b, from(i)...);
    }(std::make_integer_sequence<int, static_cast<int>(width)>{});
  }

  /// The nodes first, first + 4, ... side by side.
  template <class Field>
  static Wide load_row(const Field& field, const Index* nodes) {
    const Quad q0 = field[nodes[0]].native(0);
    if constexpr (quads == 1) {
      return q0;
    } else {
      const auto pair = __builtin_shufflevector(q0, field[nodes[4]].native(0), 0, 1, 2, 3, 4, 5, 6, 7);
      if constexpr (quads == 2) {
        return pair;
      } else {
        const auto next =
            __builtin_shufflevector(field[nodes[8]].native(0), field[nodes[12]].native(0), 0, 1, 2, 3, 4, 5, 6, 7);
        return __builtin_shufflevector(pair, next, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
      }
    }
  }
  template <int q>
  static Quad quad(const Wide& row) {
    return __builtin_shufflevector(row, row, 4 * q, 4 * q + 1, 4 * q + 2, 4 * q + 3);
  }
  template <class Field>
  static Vector3<Pack<T, N>> load(const Field& field, const Places& nodes) {
    Vector3<Pack<T, N>> v;
    for (std::size_t k = 0; k < registers; ++k) {
      const Index* first = nodes.data() + k * width;
      const Wide a = load_row(field, first), b = load_row(field, first + 1), c = load_row(field, first + 2),
                 d = load_row(field, first + 3);
      const Wide ab = mix<0, 4, 2, 6>(a, b), cd = mix<0, 4, 2, 6>(c, d);
      v(0).native(k) = mix<0, 1, 4, 5>(ab, cd);
      v(1).native(k) = mix<0, 1, 4, 5>(mix<1, 5, 3, 7>(a, b), mix<1, 5, 3, 7>(c, d));
      v(2).native(k) = mix<2, 3, 6, 7>(ab, cd);
    }
    return v;
  }

  template <class Field>
  static void subtract(const Vector3<Pack<T, N>>& v, Field& field, const Places& nodes, std::size_t count) {
    for (std::size_t k = 0; k < registers; ++k) {
      const Wide x = v(0).native(k), y = v(1).native(k), z = v(2).native(k);
      const Wide xy = mix<0, 4, 2, 6>(x, y), yx = mix<1, 5, 3, 7>(x, y);
      const Wide rows[4] = {mix<0, 1, 4, 4>(xy, z), mix<0, 1, 5, 5>(yx, z), mix<2, 3, 6, 6>(xy, z),
                            mix<2, 3, 7, 7>(yx, z)};  // z into the padding too, which is not used
      const Index* first = nodes.data() + k * width;
      const std::size_t left = count - std::min(count, k * width);
      [&]<int... q>(std::integer_sequence<int, q...>) {
        const auto put = [&](std::size_t l, const Quad& change) {
          if (left >= width || l < left) field[first[l]].native(0) -= change;
        };
        ((put(4 * q, quad<q>(rows[0])), put(4 * q + 1, quad<q>(rows[1])), put(4 * q + 2, quad<q>(rows[2])),
          put(4 * q + 3, quad<q>(rows[3]))),
         ...);
      }(std::make_integer_sequence<int, static_cast<int>(quads)>{});
    }
  }
};

/// Transposer for dual numbers: their values, then each derivative.
template <class T, std::size_t N>
struct Transposer<Dual<T, N>> {
  using Places = std::array<Index, lanes<T>>;

  /// Number k of the vectors of a field: their values, or a derivative.
  template <class Field>
  struct Numbers {
    Field& field;
    std::size_t k;

    auto& operator[](Index place) const { return numbers_of<Padded<RealOf<T>>>(field[place])[k]; }
  };
  template <class Field>
  static Vector3<Dual<T, N>> load(const Field& field, const Places& nodes) {
    Vector3<Dual<T, N>> a;
    for (std::size_t k = 0; k <= N; ++k) {
      const Vector3<T> a_k = Transposer<T>::load(Numbers<const Field>{field, k}, nodes);
      for (int c = 0; c < 3; ++c) numbers_of<T>(a(c))[k] = a_k(c);
    }
    return a;
  }
  template <class Field>
  static void subtract(const Vector3<Dual<T, N>>& a, Field& field, const Places& nodes, std::size_t count) {
    for (std::size_t k = 0; k <= N; ++k) {
      const auto number = [&](int c) -> const T& { return numbers_of<T>(a(c))[k]; };
      const Numbers<Field> numbers{field, k};
      Transposer<T>::subtract(Vector3<T>(number(0), number(1), number(2)), numbers, nodes, count);
    }
  }
};

/// f(i) for every corner i; unrolled at every level of optimisation.
template <std::size_t n, class F>
void for_each_corner(const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(i), ...); }(std::make_index_sequence<n>{});
}

}  // namespace detail

/// Nodal vectors into lanes.
template <class T, std::size_t n>
Eigen::Matrix<T, 3, static_cast<int>(n)> gather(const NodalField<LaneOf<T>>& field,
                                                const BlockNodes<n, lanes<T>>& nodes) {
  Eigen::Matrix<T, 3, static_cast<int>(n)> a;
  detail::for_each_corner<n>([&](std::size_t i) { set_column(a, i, detail::Transposer<T>::load(field, nodes[i])); });
  return a;
}

/// Nodal vectors of two fields into lanes, the second behind the first.
template <class T, std::size_t n>
Eigen::Matrix<T, 3, static_cast<int>(2 * n)> gather(const NodalField<LaneOf<T>>& first,
                                                    const NodalField<LaneOf<T>>& second,
                                                    const BlockNodes<n, lanes<T>>& nodes) {
  Eigen::Matrix<T, 3, static_cast<int>(2 * n)> a;
  detail::for_each_corner<n>([&](std::size_t i) {
    set_column(a, i, detail::Transposer<T>::load(first, nodes[i]));
    set_column(a, n + i, detail::Transposer<T>::load(second, nodes[i]));
  });
  return a;
}

/// field -= f for the first `count` lanes, node after node and lane after lane; f from its column `first` on.
template <class T, std::size_t n, int m>
void scatter_subtract(const Eigen::Matrix<T, 3, m>& f, NodalField<LaneOf<T>>& field,
                      const BlockNodes<n, lanes<T>>& nodes, std::size_t count, std::size_t first = 0) {
  detail::for_each_corner<n>(
      [&](std::size_t i) { detail::Transposer<T>::subtract(column(f, first + i), field, nodes[i], count); });
}

}  // namespace strike
