#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/rigid.hpp>
#include <strike/input/dyna_load_cards.hpp>
#include <strike/input/source.hpp>
#include <strike/mesh/mesh.hpp>

// The walls and contacts of an LS-DYNA deck as values (LS-DYNA Keyword User's Manual R13, volume I, *RIGIDWALL and
// *CONTACT). Numbers are in the units of the deck.
namespace strike {

/// The edges of a wall that ends: from its point along two directions of its plane.
struct WallEdges {
  Eigen::Vector3d along, across;  ///< of length 1; along x across is the normal
  double length = 0, width = 0;   ///< LENL and LENM, 0 for no end [length]
};

/// The motion of a wall that a curve gives.
struct WallMotion {
  Eigen::Vector3d direction;  ///< of length 1
  bool displaces = false;     ///< OPT: a displacement, not a velocity
  CardHistory history;
};

/// *RIGIDWALL_PLANAR, with _FINITE and _MOVING, and *RIGIDWALL_GEOMETRIC_FLAT, with _MOTION:
/// `RigidWall{w.point, w.normal, w.nodes, w.friction}`, or a finite one as `RigidSurface{w.corners(), {Face{{0, 1, 2,
/// 3}, 0}}}`.
struct WallCard {
  Eigen::Vector3d point, normal;  ///< the normal of length 1
  std::vector<Index> nodes;
  double friction;                        ///< FRIC
  bool sticks = false;                    ///< FRIC 1 and 3: no sliding
  std::optional<WallEdges> edges = {};    ///< FINITE and FLAT
  double mass = 0, speed = 0;             ///< MOVING: along the normal at the start
  std::optional<WallMotion> motion = {};  ///< MOTION

  /// The corners of a wall with four edges, counter-clockwise about its normal; none of another one.
  std::vector<Eigen::Vector3d> corners() const {
    if (!edges || !(edges->length > 0) || !(edges->width > 0)) return {};
    const Eigen::Vector3d l = edges->length * edges->along, m = edges->width * edges->across;
    return {point, point + l, point + l + m, point + m};
  }
};

/// *RIGIDWALL_GEOMETRIC_SPHERE and _CYLINDER, with _MOTION: `Contact{NodeToRigid{o.nodes,
/// std::get<RigidSphere>(o.shape)}, Coulomb{o.friction}}`.
struct ObstacleCard {
  std::variant<RigidSphere, RigidCylinder> shape;
  std::vector<Index> nodes;
  double friction;      ///< FRIC
  bool sticks = false;  ///< FRIC 1 and 3: no sliding
  double length = 0;    ///< LENCYL, from the point of a cylinder along its axis, 0 for no end [length]
  std::optional<WallMotion> motion = {};  ///< MOTION
};

/// One side of a contact: the parts, the nodes or the faces that it names. Without any: all parts.
struct ContactSide {
  std::vector<FileNumber> parts = {};
  std::vector<Index> nodes = {};
  std::vector<std::array<Index, 4>> segments = {};
};

/// *CONTACT_AUTOMATIC_...
struct ContactCard {
  std::string kind;  ///< what follows *CONTACT_AUTOMATIC_, such as "SURFACE_TO_SURFACE"
  ContactSide slave, master;
  double static_friction = 0, dynamic_friction = 0, decay = 0;  ///< FS, FD, DC: FD + (FS - FD) exp(-DC v)
};

}  // namespace strike
