#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <utility>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/nodes.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The nodes of a block of elements: node[i][l] is node i of the element in lane l.
template <std::size_t n, std::size_t lanes>
using BlockNodes = std::array<std::array<Index, lanes>, n>;

namespace detail {

/// A padded vector in one register, where the machine has such.
template <class Real>
struct QuadOf {
  using type = std::array<Real, 4>;
};
template <class Real>
requires(native_lanes<Real> >= 4) struct QuadOf<Real> {
  using type = typename Register<Real, 4>::type;
};
template <class Real>
using Quad = typename QuadOf<Real>::type;

template <class Real>
Quad<Real> load(const Padded<Real>& a) {
  Quad<Real> q;
  std::memcpy(&q, a.x, sizeof q);
  return q;
}
template <class To, class Real>
Quad<To> converted(const Quad<Real>& a) {
  if constexpr (std::same_as<To, Real>) {
    return a;
  } else if constexpr (native_lanes<Real> >= 4 && native_lanes<To> >= 4) {
    return __builtin_convertvector(a, Quad<To>);
  } else {
    Quad<To> b;
    for (std::size_t c = 0; c < 4; ++c) b[c] = static_cast<To>(a[c]);
    return b;
  }
}
template <class Real>
Quad<Real> difference(const Quad<Real>& a, const Quad<Real>& b) {
  if constexpr (native_lanes<Real> >= 4)
    return a - b;
  else
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

/// Moves the padded vectors of `lanes<T>` nodes into the lanes of three numbers, and back: `from(l)` gives the vector
/// of lane l, `to(l, a)` takes it.
template <class T>
struct Transposer {
  template <class From>
  static Vector3<T> load(const From& from) {
    Vector3<T> a;
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      const Quad<RealOf<T>> q = from(l);
      for (std::size_t c = 0; c < 3; ++c) set_lane(a(static_cast<int>(c)), l, q[c]);
    }
    return a;
  }
  template <class To>
  static void store(const Vector3<T>& a, const To& to) {
    for (std::size_t l = 0; l < lanes<T>; ++l) to(l, Quad<RealOf<T>>{lane(a(0), l), lane(a(1), l), lane(a(2), l), 0});
  }
};

/// The same for registers of whole quadruples: a node is one load, and quadruples of nodes are transposed in registers.
template <class T, std::size_t N>
requires(N >= 4 && native_lanes<T> >= 4) struct Transposer<Pack<T, N>> {
  static constexpr std::size_t width = N < native_lanes<T> ? N : native_lanes<T>;
  static constexpr std::size_t registers = N / width, quads = width / 4;
  using Wide = typename Register<T, width>::type;

  /// Within each quadruple of the result the four picks p0..p3 of (a, b), of which b counts from 4.
  template <int p0, int p1, int p2, int p3>
  static Wide mix(const Wide& a, const Wide& b) {
    constexpr auto from = [](int i) {
      constexpr int pick[4] = {p0, p1, p2, p3};
      const int p = pick[i % 4];
      return i / 4 * 4 + p % 4 + (p < 4 ? 0 : static_cast<int>(width));
    };
    return [&]<int... i>(std::integer_sequence<int, i...>)->Wide { return __builtin_shufflevector(a, b, from(i)...); }
    (std::make_integer_sequence<int, static_cast<int>(width)>{});
  }

  /// The nodes of lanes l, l + 4, ... side by side.
  template <class From>
  static Wide load_row(const From& from, std::size_t l) {
    if constexpr (quads == 1) {
      return from(l);
    } else {
      const auto pair = __builtin_shufflevector(from(l), from(l + 4), 0, 1, 2, 3, 4, 5, 6, 7);
      if constexpr (quads == 2) {
        return pair;
      } else {
        const auto next = __builtin_shufflevector(from(l + 8), from(l + 12), 0, 1, 2, 3, 4, 5, 6, 7);
        return __builtin_shufflevector(pair, next, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
      }
    }
  }
  template <int q>
  static Quad<T> quad(const Wide& row) {
    return __builtin_shufflevector(row, row, 4 * q, 4 * q + 1, 4 * q + 2, 4 * q + 3);
  }

  template <class From>
  static Vector3<Pack<T, N>> load(const From& from) {
    Vector3<Pack<T, N>> v;
    for (std::size_t k = 0; k < registers; ++k) {
      const std::size_t l = k * width;
      const Wide a = load_row(from, l), b = load_row(from, l + 1), c = load_row(from, l + 2), d = load_row(from, l + 3);
      const Wide ab = mix<0, 4, 2, 6>(a, b), cd = mix<0, 4, 2, 6>(c, d);
      v(0).native(k) = mix<0, 1, 4, 5>(ab, cd);
      v(1).native(k) = mix<0, 1, 4, 5>(mix<1, 5, 3, 7>(a, b), mix<1, 5, 3, 7>(c, d));
      v(2).native(k) = mix<2, 3, 6, 7>(ab, cd);
    }
    return v;
  }

  template <class To>
  static void store(const Vector3<Pack<T, N>>& v, const To& to) {
    for (std::size_t k = 0; k < registers; ++k) {
      const Wide x = v(0).native(k), y = v(1).native(k), z = v(2).native(k), none{};
      const Wide xy = mix<0, 4, 2, 6>(x, y), yx = mix<1, 5, 3, 7>(x, y), zn = mix<0, 4, 2, 6>(z, none),
                 nz = mix<1, 5, 3, 7>(z, none);
      const Wide rows[4] = {mix<0, 1, 4, 5>(xy, zn), mix<0, 1, 4, 5>(yx, nz), mix<2, 3, 6, 7>(xy, zn),
                            mix<2, 3, 6, 7>(yx, nz)};
      [&]<int... q>(std::integer_sequence<int, q...>) {
        const auto put = [&](std::size_t l, const Quad<T>& a) { to(k * width + l, a); };
        ((put(4 * q, quad<q>(rows[0])), put(4 * q + 1, quad<q>(rows[1])), put(4 * q + 2, quad<q>(rows[2])),
          put(4 * q + 3, quad<q>(rows[3]))),
         ...);
      }
      (std::make_integer_sequence<int, static_cast<int>(quads)>{});
    }
  }
};

/// f(i) for every corner i; unrolled at every level of optimisation.
template <std::size_t n, class F>
void for_each_corner(const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(i), ...); }
  (std::make_index_sequence<n>{});
}
template <class T, int n>
void set_column(Eigen::Matrix<T, 3, n>& a, std::size_t i, const Vector3<T>& a_i) {
  for (int c = 0; c < 3; ++c) a(c, static_cast<int>(i)) = a_i(c);
}

}  // namespace detail

/// Nodal vectors into lanes.
template <class T, std::size_t n, class Real>
Eigen::Matrix<T, 3, static_cast<int>(n)> gather(const std::vector<Padded<Real>>& field,
                                                const BlockNodes<n, lanes<T>>& nodes) {
  Eigen::Matrix<T, 3, static_cast<int>(n)> a;
  detail::for_each_corner<n>([&](std::size_t i) {
    const auto from = [&](std::size_t l) {
      return detail::converted<RealOf<T>, Real>(detail::load(field[nodes[i][l]]));
    };
    detail::set_column(a, i, detail::Transposer<T>::load(from));
  });
  return a;
}

/// Positions into lanes. Where those are of a lesser precision, positions relative to the first node of each element,
/// so that nothing is lost: no element asks where it is.
template <class T, std::size_t n, class Real>
Eigen::Matrix<T, 3, static_cast<int>(n)> gather_positions(const std::vector<Padded<Real>>& field,
                                                          const BlockNodes<n, lanes<T>>& nodes) {
  if constexpr (std::same_as<Real, RealOf<T>>) {
    return gather<T, n>(field, nodes);
  } else {
    Eigen::Matrix<T, 3, static_cast<int>(n)> a;
    detail::set_column(a, 0, Vector3<T>{T(0.0), T(0.0), T(0.0)});
    detail::for_each_corner<n - 1>([&](std::size_t i) {
      const auto from = [&](std::size_t l) {
        return detail::converted<RealOf<T>, Real>(
            detail::difference<Real>(detail::load(field[nodes[i + 1][l]]), detail::load(field[nodes[0][l]])));
      };
      detail::set_column(a, i + 1, detail::Transposer<T>::load(from));
    });
    return a;
  }
}

/// field -= f for the first `count` lanes, node after node and lane after lane.
template <class T, std::size_t n, class Real>
void scatter_subtract(const Eigen::Matrix<T, 3, static_cast<int>(n)>& f, std::vector<Padded<Real>>& field,
                      const BlockNodes<n, lanes<T>>& nodes, std::size_t count) {
  detail::for_each_corner<n>([&](std::size_t i) {
    const int column = static_cast<int>(i);
    detail::Transposer<T>::store(
        {f(0, column), f(1, column), f(2, column)}, [&](std::size_t l, const detail::Quad<RealOf<T>>& f_l) {
          if (l >= count) return;
          Padded<Real>& sum = field[nodes[i][l]];
          const detail::Quad<Real> rest =
              detail::difference<Real>(detail::load(sum), detail::converted<Real, RealOf<T>>(f_l));
          std::memcpy(sum.x, &rest, sizeof rest);
        });
  });
}

}  // namespace strike
