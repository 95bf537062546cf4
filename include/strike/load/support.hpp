#pragma once
#include <utility>
#include <vector>

#include <strike/mesh/select.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// A support: nodes that do not move along some directions and, where plates turn them, do not turn about some axes.
/// Supports may meet at any angle. Errors: no such node; a held direction whose motion is prescribed.
///   Support{edge, {unit(Axis::z)}, {unit(Axis::x)}}   // a hard simple support along y: slides, and turns about y
class Support {
 public:
  Support(std::vector<Index> nodes, std::vector<Eigen::Vector3d> directions, std::vector<Eigen::Vector3d> axes = {})
      : nodes_(std::move(nodes)), directions_(std::move(directions)), axes_(std::move(axes)) {}

  void ranges(const auto& number) const {
    for (const auto& direction : directions_) number("direction", direction, range::direction);
    for (const auto& axis : axes_) number("axis", axis, range::direction);
  }

  template <class N>
  void begin(N& nodes) {
    for (const Index i : nodes_) {
      for (const auto& direction : directions_) motions_.push_back({i, nodes.hold(i, detail::direction(direction))});
      if constexpr (N::nodes_turn)
        for (const auto& axis : axes_) turns_.push_back({i, nodes.hold_turn(i, detail::direction(axis))});
    }
  }

  const std::vector<Index>& nodes_named() const { return nodes_; }

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) const {
    using namespace detail;
    double work = 0;  // of nodes that move along a held direction at the start
    using Vector = typename N::Vector;
    const auto without = [&](const Vector& v, const Eigen::Vector3d& held, double m, const Vector& f) {
      const typename N::Number along = v.dot(held), before = along - step.kick() / m * f.dot(held);
      work += static_cast<double>(m * along * before);
      return Vector(v - along * held);
    };
    for (const auto& [i, held] : motions_) nodes.set_velocity(i, without(nodes.v(i), held, nodes.mass(i), nodes.f(i)));
    if constexpr (N::nodes_turn)
      for (const auto& [i, held] : turns_)
        nodes.set_angular_velocity(i, without(nodes.w(i), held, nodes.inertia(i), nodes.moment(i)));
    ledger.contact.book_impulse(work, 0);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
  }

 private:
  struct Hold {
    Index node;
    Eigen::Vector3d held;  // less the part that another support holds already
  };

  std::vector<Index> nodes_;
  std::vector<Eigen::Vector3d> directions_, axes_;
  std::vector<Hold> motions_, turns_;
};

/// A clamped support: nodes that neither move nor turn.
class Clamped : public Support {
 public:
  explicit Clamped(std::vector<Index> nodes)
      : Support(std::move(nodes), {unit(Axis::x), unit(Axis::y), unit(Axis::z)},
                {unit(Axis::x), unit(Axis::y), unit(Axis::z)}) {}
};

/// A pinned support: nodes that do not move, but turn.
class Pinned : public Support {
 public:
  explicit Pinned(std::vector<Index> nodes)
      : Support(std::move(nodes), {unit(Axis::x), unit(Axis::y), unit(Axis::z)}) {}
};

/// Another name of Pinned.
using Hinged = Pinned;

/// A plane of symmetry: its nodes do not move along the normal, and turn about that alone.
class Symmetry : public Support {
 public:
  Symmetry(const Eigen::Vector3d& normal, std::vector<Index> nodes)
      : Support(std::move(nodes), {normal}, {across(normal), cross<double>(normal, across(normal))}), normal_(normal) {}
  Symmetry(Axis axis, std::vector<Index> nodes) : Symmetry(unit(axis), std::move(nodes)) {}

  void ranges(const auto& number) const { number("normal", normal_, range::direction); }

 private:
  /// A vector orthogonal to another.
  static Eigen::Vector3d across(const Eigen::Vector3d& normal) {
    Axis least = Axis::x;
    for (const Axis axis : {Axis::y, Axis::z})
      if (std::abs(normal(int(axis))) < std::abs(normal(int(least)))) least = axis;
    return cross(normal, unit(least));
  }

  Eigen::Vector3d normal_;
};

}  // namespace strike
