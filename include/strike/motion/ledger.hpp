#pragma once
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <strike/cxx20.hpp>

namespace strike {

/// The energies of a scene at one time. The initial energy and the external work must equal the energy held or
/// dissipated.
struct Energy {
  double kinetic =
      0;  ///< sum of m v-.v+/2 with the velocities half a step before and after, which central differences conserve
  double internal = 0;        ///< work of the stresses, and the energy stored at the start
  double hourglass = 0;       ///< work against the hourglass control
  double bulk_viscosity = 0;  ///< dissipated by bulk viscosity
  double contact = 0;         ///< taken by contact: stored by penalties, lost in impacts of nodes on walls
  double friction = 0;        ///< dissipated by friction
  double damping = 0;         ///< taken from the motion by a relaxation
  double external = 0;        ///< work of loads and prescribed motion
  double eroded = 0;          ///< left with deleted elements
  double initial = 0;         ///< kinetic and stored energy at the start

  double held() const {
    return kinetic + internal + hourglass + bulk_viscosity + contact + friction + damping + eroded;
  }
  /// The largest of the energies that must balance: the scale of the error.
  double scale() const { return std::max({initial, std::abs(kinetic), std::abs(internal), std::abs(external)}); }
  /// Error of the balance.
  double imbalance() const { return held() - initial - external; }
  /// Error of the balance relative to the scale.
  double error() const { return scale() > 0 ? imbalance() / scale() : 0.0; }
};

/// One kind of work in the balance.
class Account {
 public:
  /// Books work that belongs to the present balance.
  void book(double work) { settled_ += work; }
  /// Books the work of an impulse of a constraint at the time n, which acts along the mean of the velocities before and
  /// after it: the half along the velocity before belongs to the balance at n, the other to the next.
  void book_impulse(double along_before, double along_after) {
    settled_ += 0.5 * along_before;
    before_ += 0.5 * along_before;
    pending_ += 0.5 * along_after;
  }
  /// Moves the pending work into the balance, for the next step.
  void settle() {
    settled_ += pending_;
    before_ = pending_ = 0;
  }
  double settled() const { return settled_; }
  double impulses_before() const { return before_; }

 private:
  double settled_ = 0, before_ = 0, pending_ = 0;
};

/// The accounts that the items of a scene book in.
struct Ledger {
  Account internal, hourglass, bulk_viscosity, contact, friction, damping, external, eroded;
  double kinetic = 0, initial = 0;

  void settle() {
    for (Account* account : {&contact, &friction, &external}) account->settle();
  }
  /// Work of this step's impulses of constraints along the velocities before them.
  double impulses_before() const {
    return external.impulses_before() - contact.impulses_before() - friction.impulses_before();
  }
  Energy energy() const {
    return {.kinetic = kinetic,
            .internal = internal.settled(),
            .hourglass = hourglass.settled(),
            .bulk_viscosity = bulk_viscosity.settled(),
            .contact = contact.settled(),
            .friction = friction.settled(),
            .damping = damping.settled(),
            .external = external.settled(),
            .eroded = eroded.settled(),
            .initial = initial};
  }
};

}  // namespace strike
