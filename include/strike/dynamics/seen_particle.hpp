#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include <strike/element/particle.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// A particle as its neighbours see it: position less the origin, velocity, reference volume, 0 if it had been deleted
/// before the step, and relative density.
template <class Real>
struct SeenParticle {
  Real x[3], weight, v[3], density;
};

/// ParticleAnswer of one particle.
template <class Real>
struct SeenAnswer {
  Real stress[9], rate[6], impedance;

  /// Takes lane l.
  template <class T>
  void take(const ParticleAnswer<T>& answer, std::size_t l) {
    for (int i = 0; i < 9; ++i) stress[i] = lane(answer.stress(i), l);
    const SymmetricTensor<T>& D = answer.half_rate;
    const Real taken[] = {lane(D.xx, l), lane(D.yy, l), lane(D.zz, l), lane(D.xy, l), lane(D.yz, l), lane(D.zx, l)};
    std::copy(std::begin(taken), std::end(taken), rate);
    impedance = lane(answer.impedance, l);
  }
  /// Fills lane l.
  template <class T>
  void give(ParticleAnswer<T>& answer, std::size_t l) const {
    for (int i = 0; i < 9; ++i) set_lane(answer.stress(i), l, stress[i]);
    SymmetricTensor<T>& D = answer.half_rate;
    set_lane(D.xx, l, rate[0]), set_lane(D.yy, l, rate[1]), set_lane(D.zz, l, rate[2]);
    set_lane(D.xy, l, rate[3]), set_lane(D.yz, l, rate[4]), set_lane(D.zx, l, rate[5]);
    set_lane(answer.impedance, l, impedance);
  }
  /// In all lanes.
  template <class T>
  ParticleAnswer<T> in_lanes() const {
    const auto column = [&](int i) { return Vector3<T>(T(stress[i]), T(stress[i + 1]), T(stress[i + 2])); };
    return {columns<T>(column(0), column(3), column(6)),
            {T(rate[0]), T(rate[1]), T(rate[2]), T(rate[3]), T(rate[4]), T(rate[5])},
            T(impedance)};
  }
};

/// The particles of a block in lanes of T.
template <class T>
struct ParticleBlock {
  Vector3<T> x, v;
  T density, weight;

  /// Idle lanes repeat the last particle.
  explicit ParticleBlock(std::span<const SeenParticle<LaneOf<T>>> particles) {
    for (std::size_t l = 0; l < lanes<T>; ++l) {
      const auto& seen = particles[std::min(l, particles.size() - 1)];
      for (int c = 0; c < 3; ++c) set_lane(x(c), l, seen.x[c]), set_lane(v(c), l, seen.v[c]);
      set_lane(density, l, seen.density), set_lane(weight, l, seen.weight);
    }
  }
  /// From here to there.
  static Vector3<T> difference(const LaneOf<T>* there, const Vector3<T>& here) {
    return {T(there[0]) - here(0), T(there[1]) - here(1), T(there[2]) - here(2)};
  }
};

}  // namespace strike::detail
