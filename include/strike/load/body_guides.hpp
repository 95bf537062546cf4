#pragma once
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/load/prescribed_motion.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

// Guides, which hold or move a RigidBody.

namespace detail {

/// A direction along which a rigid body moves, or an axis about which it turns, as a history tells.
template <class History, class Kind, bool turns>
class BodyGuide {
 public:
  using LoadHistory = History;
  static constexpr bool is_moved = true;

  BodyGuide(const Eigen::Vector3d& direction, History history) : given_(direction), history_(std::move(history)) {}
  BodyGuide(Axis axis, History history) : BodyGuide(unit(axis), std::move(history)) {}

  void ranges(const auto& number) const {
    number(turns ? "axis" : "direction", given_, range::direction);
    number(history_);
  }
  std::vector<Eigen::Vector3d> directions() const { return turns ? none() : std::vector{given_}; }
  std::vector<Eigen::Vector3d> axes() const { return turns ? std::vector{given_} : none(); }
  double velocity(const Step& step) { return Kind::velocity(history_, step); }

 private:
  static std::vector<Eigen::Vector3d> none() { return {}; }

  Eigen::Vector3d given_;
  History history_;
};

}  // namespace detail

/// Directions along which the centre of a rigid body does not move, and axes about which the body does not turn.
///   HeldBody{{unit(Axis::x)}, {unit(Axis::y), unit(Axis::z)}}
class HeldBody {
 public:
  static constexpr bool is_moved = false;

  explicit HeldBody(std::vector<Eigen::Vector3d> directions, std::vector<Eigen::Vector3d> axes = {})
      : directions_(std::move(directions)), axes_(std::move(axes)) {}

  void ranges(const auto& number) const {
    for (const auto& direction : directions_) number("direction", direction, range::direction);
    for (const auto& axis : axes_) number("axis", axis, range::direction);
  }
  const std::vector<Eigen::Vector3d>& directions() const { return directions_; }
  const std::vector<Eigen::Vector3d>& axes() const { return axes_; }
  double velocity(const Step&) const { return 0; }

 private:
  std::vector<Eigen::Vector3d> directions_, axes_;
};

/// A point of a rigid body that does not move: it turns about that.
class PinnedBody : public HeldBody {
 public:
  explicit PinnedBody(Eigen::Vector3d point)
      : HeldBody({unit(Axis::x), unit(Axis::y), unit(Axis::z)}), point_(std::move(point)) {}

  void ranges(const auto& number) const { number("point", point_, range::point); }
  const Eigen::Vector3d& point() const { return point_; }

 private:
  Eigen::Vector3d point_;
};

/// The centre of a rigid body moves along a direction with a history of velocity, or of displacement.
///   BodyVelocity{Axis::z, Constant{-5}}
template <class History>
struct BodyVelocity : detail::BodyGuide<History, detail::FromVelocity, false> {
  using detail::BodyGuide<History, detail::FromVelocity, false>::BodyGuide;
};
template <class History>
BodyVelocity(Eigen::Vector3d, History) -> BodyVelocity<History>;
template <class History>
BodyVelocity(Axis, History) -> BodyVelocity<History>;
template <class History>
struct BodyDisplacement : detail::BodyGuide<History, detail::FromDisplacement, false> {
  using detail::BodyGuide<History, detail::FromDisplacement, false>::BodyGuide;
};
template <class History>
BodyDisplacement(Eigen::Vector3d, History) -> BodyDisplacement<History>;
template <class History>
BodyDisplacement(Axis, History) -> BodyDisplacement<History>;

/// A rigid body turns about an axis that keeps its direction with a history of angular velocity, or of an angle [rad];
/// hold it about the other two where they shall not turn.
template <class History>
struct BodySpin : detail::BodyGuide<History, detail::FromVelocity, true> {
  using detail::BodyGuide<History, detail::FromVelocity, true>::BodyGuide;
};
template <class History>
BodySpin(Eigen::Vector3d, History) -> BodySpin<History>;
template <class History>
BodySpin(Axis, History) -> BodySpin<History>;
template <class History>
struct BodyAngle : detail::BodyGuide<History, detail::FromDisplacement, true> {
  using detail::BodyGuide<History, detail::FromDisplacement, true>::BodyGuide;
};
template <class History>
BodyAngle(Eigen::Vector3d, History) -> BodyAngle<History>;
template <class History>
BodyAngle(Axis, History) -> BodyAngle<History>;

}  // namespace strike
