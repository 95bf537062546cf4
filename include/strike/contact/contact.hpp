#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/law.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/motion/step.hpp>
#include <strike/pick.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

template <class P>
concept Pairing = requires(const P pairing, const ContactNodes nodes) {
  pairing.numbers();
  pairing.first();
  pairing.start(nodes);
};

/// What the compiler has been asked to take for a law.
struct NoContactPolicy {};

template <class T>
struct IsContactLaw : std::bool_constant<ContactLaw<T>> {};
template <class T>
struct IsFriction : std::bool_constant<Friction<T>> {};

template <class... Policies>
using LawOf =
    std::conditional_t<((ContactLaw<Policies> || Friction<Policies>)&&...),
                       decltype(pick<IsContactLaw>(std::declval<Policies>()..., Kinematic{})), NoContactPolicy>;
template <class... Policies>
using FrictionOf = decltype(pick<IsFriction>(std::declval<Policies>()..., Frictionless{}));

}  // namespace detail

/// Contact of what a pairing pairs, with a law along the normals and with friction, in any order after it:
///   Contact{NodeToSurface{bird_nodes, canopy}, Penalty{.fraction = 0.2}, Coulomb{0.3}}
///   Contact{TwoWay{one, other}}      Contact{SelfContact{surface}}      Contact{NodeToRigid{nodes, RigidSphere{c, R}}}
/// Unless told otherwise it is Kinematic and Frictionless. Pair after pair in the order of the nodes' numbers.
template <class P, class Law, class F>
class Contact {
 public:
  template <class... Policies>
  explicit Contact(P pairing, const Policies&... policies)
      : pairing_(std::move(pairing)),
        law_(detail::pick<detail::IsContactLaw>(policies..., Kinematic{})),
        friction_(detail::pick<detail::IsFriction>(policies..., Frictionless{})) {
    detail::check_law(law_);
  }

  template <class N>
  void begin(const N& nodes) {
    std::vector<Eigen::Vector3d> points;
    if constexpr (requires { pairing_.points(); }) points = pairing_.points();
    all_.begin(nodes, pairing_.numbers(), points);
    is_first_.assign(all_.size(), 0);
    for (const Index i : pairing_.first()) is_first_[all_.local(i)] = 1;
    meeting_.emplace(pairing_.start(all_));
    meeting_->begin(all_, beginners_);
  }

  template <class N, class Ledger>
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger) {
    all_.gather(nodes);
    all_.learn_what_is_held(nodes);
    pairs_.clear();
    meeting_->find(all_, step, pairs_);
    all_.gather_forces(nodes, pairs_, step.kick());
    kappa_ = law_.press(pairs_, all_, step);
    if constexpr (!std::is_same_v<F, Frictionless>)
      for (const ContactPair& pair : pairs_) rub(pair);
    meeting_->moved(all_, step.dt);
    all_.give_back(nodes, ledger);
    step_ = step;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Index i : all_.touched())
      if (is_first_[i]) sum += all_.pushed[i] + all_.dragged[i];
    impulse_ += sum;
  }

  /// The stable step together with elements that have the stable step `dt` alone.
  double stable_step(double dt) const {
    double kappa = kappa_;
    if constexpr (requires { law_.kappa(1.0); }) kappa = std::max(kappa, law_.kappa(meeting_->largest_inverse_mass()));
    return stable_step_with_contact(dt, kappa);
  }

  /// Takes the cells of a part that are not alive from the surfaces.
  void remove(std::size_t part, const std::vector<bool>& alive) {
    if constexpr (requires { meeting_->remove(part, alive, all_); }) meeting_->remove(part, alive, all_);
  }

  std::string warning() const {
    if (beginners_.count == 0) return {};
    return detail::joined({std::to_string(beginners_.count),
                           " nodes begin inside what they may touch, the deepest, node ",
                           std::to_string(beginners_.deepest), ", by ", detail::text(beginners_.depth),
                           "; they stay so deep without force until they leave: move the meshes apart if that is not "
                           "meant."});
  }

  /// The force on the nodes of the first surface in the last step.
  Eigen::Vector3d force() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& [i, f] : forces())
      if (is_first_[all_.local(i)]) sum += f;
    return sum;
  }
  /// The impulse on them since the start.
  const Eigen::Vector3d& impulse() const { return impulse_; }
  /// The forces of the last step, on every node of the scene.
  std::vector<Eigen::Vector3d> forces(std::size_t nodes) const {
    std::vector<Eigen::Vector3d> all(nodes, Eigen::Vector3d::Zero());
    for (const auto& [i, f] : forces()) all.at(i) = f;
    return all;
  }
  /// The largest depth in the last step, less what was given away at the start [length].
  double penetration() const {
    double most = 0;
    for (const ContactPair& pair : pairs_) most = std::max(most, -pair.gap);
    return most;
  }
  /// What touched in the last step.
  const std::vector<ContactPair>& pairs() const { return pairs_; }
  /// Who is paired, at work.
  const auto& meeting() const { return *meeting_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(all_, *meeting_, pairs_, impulse_, step_, kappa_);
  }

 private:
  /// Against the velocity along the surface that the normal impulses have left.
  void rub(const ContactPair& pair) {
    if (!(pair.impulse > 0)) return;
    const Eigen::Vector3d v = pair.velocity(all_);
    const Eigen::Vector3d sliding = v - pair.normal.dot(v) * pair.normal;
    const double speed = sliding.norm();
    if (!(speed > 0)) return;
    const Eigen::Vector3d along = (1 / speed) * sliding;
    const double inverse_effective_mass = pair.inverse_effective_mass_along(all_, along);
    if (!(inverse_effective_mass > 0)) return;
    pair.drag(all_, -friction_.impulse(pair.impulse, speed / inverse_effective_mass) * along);
  }

  std::vector<std::pair<Index, Eigen::Vector3d>> forces() const {
    std::vector<std::pair<Index, Eigen::Vector3d>> of_nodes;
    for (const Index i : all_.touched())
      of_nodes.push_back({all_.number(i), (all_.pushed[i] + all_.dragged[i]) / step_.kick()});
    return of_nodes;
  }

  using Meeting = decltype(std::declval<const P&>().start(std::declval<const ContactNodes&>()));

  P pairing_;
  Law law_;
  [[no_unique_address]] F friction_;
  ContactNodes all_;
  std::optional<Meeting> meeting_;
  std::vector<ContactPair> pairs_;
  std::vector<unsigned char> is_first_;
  detail::Beginners beginners_;
  Eigen::Vector3d impulse_ = Eigen::Vector3d::Zero();
  Step step_;
  double kappa_ = 0;
};

template <class P, class... Policies>
Contact(P, const Policies&...) -> Contact<P, detail::LawOf<Policies...>, detail::FrictionOf<Policies...>>;

/// What is no contact gets one sentence.
template <class P, class Law, class F>
  requires(!detail::Pairing<P> || std::is_same_v<Law, detail::NoContactPolicy>)
class Contact<P, Law, F> {
 public:
  static constexpr bool pairs = detail::Pairing<P>, has_laws = !std::is_same_v<Law, detail::NoContactPolicy>;

  explicit Contact(const P&, const auto&...) {
    static_assert(pairs,
                  "strike: a Contact begins with who may touch whom: NodeToSurface{nodes, surface}, TwoWay{surface, "
                  "surface}, SelfContact{surface} or NodeToRigid{nodes, body}, where a body has a clearance(x).");
    static_assert(!pairs || has_laws,
                  "strike: after its pairing a Contact takes a normal law, such as Kinematic{} or Penalty{}, and "
                  "friction, such as Coulomb{0.3}.");
  }
  void begin(const auto&) {}
};

}  // namespace strike
