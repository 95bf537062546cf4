#pragma once
#include <cstddef>
#include <vector>

#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>

namespace strike {

namespace detail {
template <class Real>
struct NodalNumber {
  using Padded = Pack<Real, 4>;
  using Value = double;
};
template <class Real, std::size_t N>
struct NodalNumber<Dual<Real, N>> {
  using Padded = Dual<Pack<Real, 4>, N>;
  using Value = Dual<Real, N>;
};
}  // namespace detail

/// A vector at a node in one register; the fourth component is padding.
template <class Real>
using Padded = typename detail::NodalNumber<Real>::Padded;

/// A vector for each place.
template <class Real>
using NodalField = std::vector<Padded<Real>>;

/// Fields that elements read and write, place by place: positions, velocities and forces, and of nodes that turn
/// angular velocities and moments.
template <class Real, bool turn = false>
struct Motion {
  NodalField<Real> position, velocity, force;

  explicit Motion(std::size_t places = 0) : position(places, zero()), velocity(position), force(position) {}
  void resize(std::size_t places) {
    for (NodalField<Real>* field : {&position, &velocity, &force}) {
      field->reserve(places);  // and no more
      field->resize(places, zero());
    }
  }
  static Padded<Real> zero() { return Padded<Real>(0); }
};
template <class Real>
struct Motion<Real, true> : Motion<Real> {
  NodalField<Real> angular_velocity, moment;

  explicit Motion(std::size_t places = 0)
      : Motion<Real>(places), angular_velocity(places, this->zero()), moment(angular_velocity) {}
  void resize(std::size_t places) {
    Motion<Real>::resize(places);
    for (NodalField<Real>* field : {&angular_velocity, &moment}) {
      field->reserve(places);
      field->resize(places, this->zero());
    }
  }
};

}  // namespace strike
