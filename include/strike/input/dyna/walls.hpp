#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/forces.hpp>
#include <strike/input/dyna/mesh.hpp>

// Rigid walls: planes, and spheres and cylinders.
namespace strike::detail::dyna {

/// The nodes of a wall: NSID or all, less those of NSIDEX.
inline std::vector<Choice> nodes_of_wall(Card& card, File& file) {
  const FileNumber set = card.tag("NSID", Id::set), less = card.tag("NSIDEX", Id::set);
  file.ignore(card.number("BOXID"), "BOXID");
  std::vector<Choice> choices{{set == 0 ? Named::all : Named::set, set, file.line()}};
  if (less != 0) choices.push_back({Named::set, less, file.line(), true});
  return choices;
}
/// A tail and a head. Error: they are one point.
inline Eigen::Vector3d direction_from(const Eigen::Vector3d& tail, Card& card, const char* meaning, const char* what,
                                      const File& file) {
  const Eigen::Vector3d way = card.vector(meaning) - tail;
  const double length = way.stableNorm();
  if (!(length > 0) || !std::isfinite(length))
    file.refuse({"the ", what, " of the wall has no length: give it a head that is not its tail."});
  return way / length;
}
/// FRIC, whose values 1 to 3 have meanings of their own.
inline double friction_of_wall(Card& card, bool& sticks, File& file) {
  const double friction = card.number("FRIC");
  if (friction < 0) file.refuse({"FRIC of a wall is negative: give a coefficient from 0."});
  sticks = friction == 1 || friction == 3;
  if (friction == 1) file.ignore(1, "FRIC 1 (no sliding; a coefficient of 1 is taken)");
  if (friction == 2 || friction == 3) file.ignore(1, "FRIC 2 or 3 (what has touched stays)");
  return friction == 2 ? 0 : friction == 3 ? 1 : friction;
}
/// XHEV to ZHEV, LENL and LENM, in the plane of the wall.
inline WallEdges edges_of(const WallCard& wall, Card& card, const File& file) {
  Eigen::Vector3d along = direction_from(wall.point, card, "XHEV to ZHEV", "edge", file);
  along -= along.dot(wall.normal) * wall.normal;
  if (!(along.norm() > 1e-6)) file.refuse({"the edge of the wall lies along its normal: give its head in the plane."});
  along.normalize();
  WallEdges edges{along, wall.normal.cross(along), card.number("LENL")};
  edges.width = card.number("LENM");
  if (edges.length < 0 || edges.width < 0) file.refuse({"LENL or LENM is negative: give lengths, or 0 for no end."});
  return edges;
}
/// LCID, OPT and VX to VZ.
inline WallMotion motion_of_wall(double birth, File& file) {
  Card card = file.card();
  WallMotion motion{{}, false, {.curve = card.tag("LCID", Id::curve), .birth = birth}};
  const FileNumber kind = card.integer("OPT");
  motion.displaces = kind == 1;
  motion.direction = card.vector("VX to VZ");
  const double length = motion.direction.stableNorm();
  if (motion.history.curve == 0) file.refuse({"the motion of the wall has no LCID: give it a curve."});
  if (kind != 0 && kind != 1)
    file.refuse({"OPT ", std::to_string(kind), " of a wall is none: give 0 (velocity) or 1 (displacement)."});
  if (!(length > 0)) file.refuse({"the motion of the wall has no direction: give VX, VY and VZ."});
  motion.direction /= length;
  file.ignore(1, "The motion (a RigidWall stands)");
  return motion;
}

inline constexpr std::string_view planar_wall = "*RIGIDWALL_PLANAR";
inline constexpr std::array<std::string_view, 6> planar_options{"_ORTHO",  "_FINITE",  "_MOVING",
                                                                "_FORCES", "_DISPLAY", "_ID"};
inline void wall(File& file, Draft& draft) {
  std::array<bool, 6> has;
  has_options(file.base().substr(planar_wall.size()), planar_options, has);
  if (has[0])
    file.refuse({file.name(),
                 " has a friction of its own along two directions, which is not read: give FRIC of a "
                 "*RIGIDWALL_PLANAR."});
  has[5] ? void(file.pass_card()) : void(file.title());
  Card card = file.card();
  const std::uint32_t line = file.line();
  Pending<WallCard> pending{{{}, {}, {}, 0}, nodes_of_wall(card, file), 0, line};
  WallCard& wall = pending.card;
  for (const char* what : {"OFFSET", "BIRTH"}) file.ignore(card.number(what), what);
  file.ignore(early(card.number("DEATH")), "DEATH");
  const double stiffness = card.number("RWKSF", 1);
  file.ignore(stiffness == 1 ? 0 : stiffness, "RWKSF");
  Card plane = file.card();
  wall.point = plane.vector("XT to ZT");
  wall.normal = direction_from(wall.point, plane, "XH to ZH", "normal", file);
  wall.friction = friction_of_wall(plane, wall.sticks, file);
  file.ignore_rest(card, plane);
  if (has[1]) {
    Card edges = file.card();
    wall.edges = edges_of(wall, edges, file);
    file.ignore(1, "FINITE (a RigidWall has no edges)");
  }
  if (has[2]) {
    Card moving = file.card();
    wall.mass = moving.number("MASS"), wall.speed = moving.number("V0");
    if (wall.mass < 0) file.refuse({"MASS of the wall is negative: correct it."});
    file.ignore(1, "MOVING (a RigidWall stands)");
  }
  if (has[3]) file.ignore(file.card().says_more(), "The card of FORCES");
  if (has[4]) file.pass_card();
  draft.walls.push_back(std::move(pending));
}

inline constexpr std::string_view geometric_wall = "*RIGIDWALL_GEOMETRIC";
inline constexpr std::array<std::string_view, 9> geometric_options{
    "_FLAT", "_PRISM", "_CYLINDER", "_SPHERE", "_INTERIOR", "_MOTION", "_DISPLAY", "_DEFORM", "_ID"};
inline void shaped_wall(File& file, Draft& draft) {
  std::array<bool, 9> has;
  has_options(file.base().substr(geometric_wall.size()), geometric_options, has);
  const bool flat = has[0], cylinder = has[2], sphere = has[3], moves = has[5], displays = has[6], titled = has[8];
  if (has[1] || has[4] || has[7] || flat + cylinder + sphere != 1)
    file.refuse({file.name(),
                 " is not read: give FLAT, SPHERE or CYLINDER, touched from outside, or model it as a "
                 "part that is rigid."});
  titled ? void(file.pass_card()) : void(file.title());
  Card card = file.card();
  const std::uint32_t line = file.line();
  std::vector<Choice> choices = nodes_of_wall(card, file);
  const double birth = card.number("BIRTH");
  file.ignore(birth, "BIRTH");
  file.ignore(early(card.number("DEATH")), "DEATH");
  Card place = file.card();
  WallCard wall{place.vector("XT to ZT"), {}, {}, 0};
  if (sphere)
    place.pass(3);
  else
    wall.normal = direction_from(wall.point, place, "XH to ZH", flat ? "normal" : "axis", file);
  wall.friction = friction_of_wall(place, wall.sticks, file);
  file.ignore_rest(card, place);
  Card shape = file.card();
  ObstacleCard obstacle{RigidSphere{wall.point, 0}, {}, wall.friction, wall.sticks};
  if (flat) {
    wall.edges = edges_of(wall, shape, file);
    if (wall.edges->length > 0 || wall.edges->width > 0) file.ignore(1, "LENL or LENM (a RigidWall has no edges)");
  } else {
    const double radius = shape.number("RADCYL or RADSPH");
    if (!(radius > 0)) file.refuse({"the radius of the wall is not positive: give it one."});
    if (sphere) {
      obstacle.shape = RigidSphere{wall.point, radius};
    } else {
      const double length = shape.number("LENCYL");
      if (length < 0) file.refuse({"LENCYL of the wall is negative: give a length, or 0 for no end."});
      RigidCylinder round{wall.point, wall.normal, radius};
      if (length > 0) round.length = length;
      obstacle.shape = round;
      for (FileNumber left = shape.integer("NSEGS"); left > 0 && file.pass_card(); --left)
        file.ignore(1, "A segment of the cylinder");
    }
  }
  file.ignore_rest(shape);
  if (moves) wall.motion = obstacle.motion = motion_of_wall(birth, file);
  if (displays) file.pass_card();
  if (flat)
    draft.walls.push_back({std::move(wall), std::move(choices), 0, line});
  else
    draft.obstacles.push_back({std::move(obstacle), std::move(choices), 0, line});
}

inline constexpr Meaning of_planar_walls{
    "`walls`: edges, mass and speed",
    "`RigidWall`; with edges `Contact{NodeToRigid{...}, Coulomb{FRIC}}` with a `RigidSurface`; what moves is a "
    "`RigidBody` and touched as `Carried{RigidPlane{...}}`, or with edges by `NodeToSurface`",
    "`_ORTHO`, which is refused; BOXID, OFFSET, BIRTH, DEATH, RWKSF, FRIC 1 to 3, the card of `_FORCES`"};
inline constexpr Meaning of_shaped_walls{
    "`walls` of `_FLAT`; `obstacles`: their shape; motion of both",
    "`RigidWall`; `Contact{NodeToRigid{...}, Coulomb{FRIC}}` with a `RigidSphere`, `RigidCylinder` or, of `_FLAT` with "
    "edges, `RigidSurface`; what moves is a `RigidBody` with `BodyVelocity` or `BodyDisplacement`, touched as "
    "`Carried`, or with edges by `NodeToSurface`",
    "`_PRISM`, `_INTERIOR` and `_DEFORM`, which are refused; BOXID, BIRTH, DEATH, FRIC 1 to 3, segments of a cylinder"};
/// The readers of *RIGIDWALL_PLANAR and _GEOMETRIC with any of their options; null for other keywords.
inline const Keyword* wall_keyword(std::string_view name) {
  static constexpr Keyword planar{planar_wall, wall, Invariant::none, &of_planar_walls},
      shaped{geometric_wall, shaped_wall, Invariant::none, &of_shaped_walls};
  std::array<bool, 6> of_plane;
  std::array<bool, 9> of_shape;
  if (name.starts_with(planar_wall) && has_options(name.substr(planar_wall.size()), planar_options, of_plane))
    return &planar;
  if (name.starts_with(geometric_wall) && has_options(name.substr(geometric_wall.size()), geometric_options, of_shape))
    return &shaped;
  return nullptr;
}
inline constexpr auto wall_families = std::to_array<Family>({
    {planar_wall, {}, planar_options, wall_keyword},
    {geometric_wall, {}, geometric_options, wall_keyword},
});

}  // namespace strike::detail::dyna
