#pragma once
#include <strike/material/failure/failure.hpp>

namespace strike {

/// Rankine: what is brittle, as glass is, fails when its largest principal stress reaches its strength in tension.
struct PrincipalStress {
  double strength;

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return largest_principal(state.stress) >= strength;
  }
};

}  // namespace strike
