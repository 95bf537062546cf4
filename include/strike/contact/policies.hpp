#pragma once
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/concepts.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/law.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/pick.hpp>
#include <strike/protocol.hpp>

namespace strike::detail {

template <class T>
struct IsContactLaw : std::bool_constant<ContactLaw<T>> {};
template <class T>
struct IsFriction : std::bool_constant<Friction<T>> {};

/// The body of a NodeToRigid; of any other pairing void.
template <class P>
struct BodyOf : std::type_identity<void> {};
template <class Body>
struct BodyOf<NodeToRigid<Body>> : std::type_identity<Body> {};

template <class P>
concept RefusesBody = HasName<ClearanceOf, typename BodyOf<P>::type> && !RigidObstacle<typename BodyOf<P>::type>;
template <class P>
using MeetingOf = decltype(std::declval<const P&>().start(std::declval<const ContactNodes&>()));

/// The first flaw of the arguments of a Contact.
enum class ContactFlaw {
  none,
  clearance,
  pairing,
  points,
  see,
  remove,
  closing_step,
  press,
  kappa,
  impulse,
  unknown,
  laws,
  frictions,
};

template <class P, class... Policies>
constexpr ContactFlaw contact_flaw() {
  if constexpr (RefusesBody<P>) {
    return ContactFlaw::clearance;
  } else if constexpr (!Pairing<P>) {
    return ContactFlaw::pairing;
  } else {
    if (nearly<Points, const P>) return ContactFlaw::points;
    if (nearly<See, P, std::span<const PartFaces>>) return ContactFlaw::see;
    if (nearly<Remove, MeetingOf<P>, const std::size_t, const std::vector<bool>, const ContactNodes>)
      return ContactFlaw::remove;
    if (nearly<ClosingStep, MeetingOf<P>, const ContactNodes, double, double>) return ContactFlaw::closing_step;
    if (((HasName<Press, Policies> && !ContactLaw<Policies>) || ...)) return ContactFlaw::press;
    if (((ContactLaw<Policies> && nearly<Kappa, const Policies, double>) || ...)) return ContactFlaw::kappa;
    if (((HasName<Impulse, Policies> && !Friction<Policies>) || ...)) return ContactFlaw::impulse;
    if (!((ContactLaw<Policies> || Friction<Policies>)&&...)) return ContactFlaw::unknown;
    if ((std::size_t{ContactLaw<Policies>} + ... + 0) > 1) return ContactFlaw::laws;
    if ((std::size_t{Friction<Policies>} + ... + 0) > 1) return ContactFlaw::frictions;
    return ContactFlaw::none;
  }
}

/// Placeholder for the law of an ill-formed Contact.
template <ContactFlaw flaw>
struct FlawedLaw {};

template <ContactFlaw flaw, class... Policies>
struct ChosenLaw : std::type_identity<FlawedLaw<flaw>> {};
template <class... Policies>
struct ChosenLaw<ContactFlaw::none, Policies...>
    : std::type_identity<decltype(pick<IsContactLaw>(std::declval<Policies>()..., Kinematic{}))> {};

template <class P, class... Policies>
using LawOf = typename ChosenLaw<contact_flaw<P, Policies...>(), Policies...>::type;
template <class... Policies>
using FrictionOf = decltype(pick<IsFriction>(std::declval<Policies>()..., Frictionless{}));

/// One sentence for the flaw of a Contact.
template <ContactFlaw flaw>
constexpr void refuse_contact() {
  using enum ContactFlaw;
  static_assert(
      flaw != clearance,
      "strike: the clearance of this rigid body does not fit; write Clearance clearance(const Eigen::Vector3d& "
      "x) const, which returns {gap, normal}.");
  static_assert(flaw != pairing,
                "strike: a Contact begins with who may touch whom: NodeToSurface{nodes, surface}, TwoWay{surface, "
                "surface}, SelfContact{surface} or NodeToRigid{nodes, body}, where a body has a clearance(x), or a "
                "pairing of your own with numbers(), first() and start(nodes).");
  static_assert(flaw != points,
                "strike: the points of this pairing do not fit; write std::vector<Eigen::Vector3d> points() const.");
  static_assert(flaw != remove,
                "strike: the remove of what this pairing starts does not fit; write remove(std::size_t part, const "
                "std::vector<bool>& alive, const ContactNodes& nodes).");
  static_assert(flaw != see,
                "strike: the see of this pairing does not fit; write void see(std::span<const PartFaces> parts).");
  static_assert(flaw != closing_step,
                "strike: the closing_step of what this pairing starts does not fit; write double closing_step(const "
                "ContactNodes& nodes, double moved, double dt).");
  static_assert(
      flaw != press,
      "strike: the press of this normal law does not fit; write double press(std::vector<ContactPair>& pairs, "
      "ContactNodes& nodes, const Step& step) const.");
  static_assert(flaw != kappa,
                "strike: the kappa of this normal law does not fit; write double kappa(double inverse_effective_mass) "
                "const, or leave it out.");
  static_assert(flaw != impulse,
                "strike: the impulse of this friction does not fit; write double impulse(double normal, double stops) "
                "const.");
  static_assert(flaw != unknown,
                "strike: after its pairing a Contact takes a normal law, such as Kinematic{} or Penalty{}, which has "
                "press(pairs, nodes, step), and friction, such as Coulomb{0.3}, which has impulse(normal, stops).");
  static_assert(flaw != laws, "strike: a Contact has one normal law, and this one has more; take all but one out.");
  static_assert(flaw != frictions, "strike: a Contact has one friction, and this one has more; take all but one out.");
}

}  // namespace strike::detail
