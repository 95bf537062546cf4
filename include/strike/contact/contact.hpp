#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/law.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/plane_contact.hpp>
#include <strike/contact/policies.hpp>
#include <strike/contact/rub.hpp>
#include <strike/contact/touch.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/pick.hpp>
#include <strike/protocol.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Contact of the nodes and surfaces of a pairing, with a law along the normals and with friction, in any order after
/// it:
///   Contact{NodeToSurface{bird_nodes, canopy}, Penalty{.fraction = 0.2}, Coulomb{0.3}}
///   Contact{TwoWay{one, other}}      Contact{SelfContact{surface}}      Contact{NodeToRigid{nodes, RigidSphere{c, R}}}
/// By default it is Kinematic and Frictionless. Error: a number out of its range. Pairs are served in the order of the
/// nodes' numbers.
template <class P, class Law, class F>
class Contact {
 public:
  template <class... Policies>
  explicit Contact(P pairing, const Policies&... policies)
      : pairing_(std::move(pairing)),
        law_(detail::pick<detail::IsContactLaw>(policies..., Kinematic{})),
        friction_(detail::pick<detail::IsFriction>(policies..., Frictionless{})) {
    detail::check_ranges(*this);
  }

  void ranges(const auto& number) const { number(pairing_), number(law_), number(friction_); }

  /// Errors: no such node; those of the pairing.
  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts = {}) {
    detail::refuse_dual_numbers<N>();
    if constexpr (detail::is_plain<N>) {
      if (!parts.empty()) detail::call_if_present<detail::See>(pairing_, parts);
      std::vector<Eigen::Vector3d> points;
      if constexpr (detail::answers<detail::Points, const P>) points = detail::Points::call(pairing_);
      all_.begin(nodes, pairing_.numbers(), points, parts);
      is_first_.assign(all_.size(), 0);
      for (const Index i : pairing_.first()) is_first_[all_.local(i)] = 1;
      meeting_.emplace(pairing_.start(all_));
      inside_.around = detail::CellsAround(all_, nodes, parts);
      meeting_->begin(all_, inside_);
      inside_.around = {};
    }
  }

  std::vector<Index> nodes_named() const { return all_.nodes_named(); }
  template <class N>
  void find_places(const N& nodes) {
    all_.find_places(nodes);
  }

  template <class N, class Ledger, Execution E = Serial>
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger, const E& execution = {})
    requires detail::is_plain<N>
  {
    all_.gather(nodes, execution);
    all_.find_held_directions(nodes);
    pairs_.clear();
    detail::Find::call(*meeting_, all_, step, pairs_, execution);
    all_.gather_forces(nodes, pairs_, step.kick(), execution);
    all_.note(step);
    kappa_ = detail::Press::call(law_, pairs_, all_, step, execution);
    step_ = step;
    if constexpr (!std::is_same_v<F, Frictionless>) detail::rub(friction_, pairs_, all_, step, execution);
    all_.scatter(nodes, ledger, execution);
    using namespace detail;
    Eigen::Vector3d sum{0, 0, 0};
    for (const Index i : all_.touched())
      if (is_first_[i]) sum += all_.normal_impulse[i] + all_.friction_impulse[i];
    impulse_ += sum;
  }

  /// The stable step together with elements whose own stable step is `dt`, and for what is about to touch.
  template <class N>
  double stable_step(double dt, const N& nodes) {
    if constexpr (detail::is_plain<N>) {
      double kappa = kappa_;
      if constexpr (detail::answers<detail::Kappa, const Law, const double>)
        kappa = std::max(kappa, detail::Kappa::call(law_, meeting_->largest_inverse_mass()));
      dt = stable_step_with_contact(dt, kappa);
      if constexpr (closes) {
        if (step_.dt == 0) all_.gather(nodes, Serial{});  // before the first step
        dt = detail::least_of_ranks(nodes.ranks(), meeting_->closing_step(all_, step_.dt, dt));
      }
    }
    return dt;
  }

  /// Removes the cells of a part that are not alive from the surfaces.
  void remove(std::size_t part, const std::vector<bool>& alive) {
    all_.remove(part, alive);
    detail::call_if_present<detail::Remove>(*meeting_, part, alive, all_);
  }

  /// A sentence on nodes that start inside, and one on bodies that begin crossed; empty if there are none.
  std::string warning() const { return inside_.warning(); }
  /// Number of the nodes that started inside.
  std::size_t inside() const { return inside_.count; }
  /// Points that started inside each other.
  const std::vector<Overlap>& overlaps() const { return inside_.overlaps; }

  /// The force on the nodes of the first surface in the last step.
  Eigen::Vector3d force() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& [i, f] : forces())
      if (is_first_[all_.local(i)]) sum += f;
    return sum;
  }
  /// The impulse on those nodes since the start [force time]. Zero but for rounding of SelfContact and Everything,
  /// which count both bodies: pair two to know it.
  const Eigen::Vector3d& impulse() const { return impulse_; }
  /// The forces of the last step on every node of the scene, whose number is `nodes`.
  std::vector<Eigen::Vector3d> forces(std::size_t nodes) const {
    std::vector<Eigen::Vector3d> all(nodes, Eigen::Vector3d::Zero());
    for (const auto& [i, f] : forces()) all.at(i) = f;
    return all;
  }
  /// The largest depth in the last step, less the initial depth [length].
  double penetration() const {
    double most = 0;
    for (const ContactPair& pair : pairs_) most = std::max(most, -pair.gap);
    return most;
  }
  /// The pairs of the last step.
  const std::vector<ContactPair>& pairs() const { return pairs_; }
  /// The pairing at work.
  const auto& meeting() const { return *meeting_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(all_, *meeting_, pairs_, impulse_, step_, kappa_);
  }

 private:
  static constexpr bool closes =
      detail::answers<detail::ClosingStep, detail::MeetingOf<P>, const ContactNodes, double, double>;

  std::vector<std::pair<Index, Eigen::Vector3d>> forces() const {
    using namespace detail;
    std::vector<std::pair<Index, Eigen::Vector3d>> of_nodes;
    for (const Index i : all_.touched())
      of_nodes.emplace_back(all_.number(i), (all_.normal_impulse[i] + all_.friction_impulse[i]) / step_.kick());
    return of_nodes;
  }

  P pairing_;
  Law law_;
  [[no_unique_address]] F friction_;
  ContactNodes all_;
  std::optional<detail::MeetingOf<P>> meeting_;
  std::vector<ContactPair> pairs_;
  std::vector<unsigned char> is_first_;  // of the nodes whose force is summed
  detail::InitialPenetration inside_;
  Eigen::Vector3d impulse_ = Eigen::Vector3d::Zero();
  Step step_;
  double kappa_ = 0;
};

template <class P, class... Policies>
Contact(P, const Policies&...) -> Contact<P, detail::LawOf<P, Policies...>, detail::FrictionOf<Policies...>>;

/// Kinematic contact with a rigid plane: that of a RigidWall, in runs of any numbers. It has no pairs() and no
/// meeting().
template <class F>
class Contact<NodeToRigid<RigidPlane>, Kinematic, F> : public detail::PlaneContact<F> {
 public:
  template <class... Policies>
  explicit Contact(const NodeToRigid<RigidPlane>& pairing, const Policies&... policies)
      : detail::PlaneContact<F>(pairing.body, detail::ascending(pairing.nodes),
                                detail::pick<detail::IsFriction>(policies..., Frictionless{}), pairing.thickness) {
    detail::check_ranges(pairing);
    detail::check_ranges(detail::pick<detail::IsContactLaw>(policies..., Kinematic{}));
    detail::check_ranges(detail::pick<detail::IsFriction>(policies..., Frictionless{}));
  }
};

/// Fallback for an ill-formed contact: one sentence on its flaw.
template <class P, detail::ContactFlaw flaw, class F>
class Contact<P, detail::FlawedLaw<flaw>, F> {
 public:
  explicit Contact(const P&, const auto&...) { detail::refuse_contact<flaw>(); }
  void begin(const auto&) {}
  double stable_step(double dt, const auto&) const { return dt; }
  std::string warning() const { return {}; }
  Eigen::Vector3d force() const { return {}; }
  Eigen::Vector3d impulse() const { return {}; }
  std::vector<Eigen::Vector3d> forces(std::size_t) const { return {}; }
  double penetration() const { return 0; }
  std::vector<ContactPair> pairs() const { return {}; }
};

}  // namespace strike
