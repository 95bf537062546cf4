#pragma once
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/rigid.hpp>
#include <strike/input/dyna_load_cards.hpp>
#include <strike/input/source.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>

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
/// 3}, 0}}}`; what moves is `Carried`.
struct WallCard {
  Eigen::Vector3d point, normal;  ///< the normal of length 1
  std::vector<Index> nodes;
  double friction;                        ///< FRIC
  bool sticks = false;                    ///< FRIC 1 and 3: no sliding
  std::optional<WallEdges> edges = {};    ///< FINITE and FLAT
  double mass = 0, speed = 0;             ///< MOVING: along the normal at the start
  std::optional<WallMotion> motion = {};  ///< MOTION

  /// The corners of a wall with edges, counter-clockwise about its normal. Where it does not end it is `far` long to
  /// both sides, if that is not 0; none of a wall without edges.
  std::vector<Eigen::Vector3d> corners(double far = 0) const {
    if (!edges || (!(edges->length > 0) && !(edges->width > 0))) return {};
    const double length = edges->length > 0 ? edges->length : 2 * far,
                 width = edges->width > 0 ? edges->width : 2 * far;
    if (!(length > 0) || !(width > 0)) return {};
    Eigen::Vector3d first = point;
    if (!(edges->length > 0)) first -= far * edges->along;
    if (!(edges->width > 0)) first -= far * edges->across;
    const Eigen::Vector3d l = length * edges->along, m = width * edges->across;
    return {first, first + l, first + l + m, first + m};
  }
};

/// *RIGIDWALL_GEOMETRIC_SPHERE and _CYLINDER, which LENCYL ends, with _MOTION: `Contact{NodeToRigid{o.nodes,
/// std::get<RigidSphere>(o.shape)}, Coulomb{o.friction}}`; what moves is `Carried`.
struct ObstacleCard {
  std::variant<RigidSphere, RigidCylinder> shape;
  std::vector<Index> nodes;
  double friction;                        ///< FRIC
  bool sticks = false;                    ///< FRIC 1 and 3: no sliding
  std::optional<WallMotion> motion = {};  ///< MOTION
};

/// One side of a contact: the parts, the nodes or the faces that it names. Without any: all parts.
struct ContactSide {
  std::vector<FileNumber> parts = {};
  std::vector<Index> nodes = {};
  std::vector<std::array<Index, 4>> segments = {};
  double stiffness = 1;        ///< SFS or SFM: scale of the penalty
  double thickness = 0;        ///< SST or MST, 0 for that of the section [length]
  double thickness_scale = 1;  ///< SFST or SFMT

  std::vector<Face> faces() const {
    std::vector<Face> all;
    for (const auto& corners : segments) all.push_back({corners, 0});
    return all;
  }
};

/// *CONTACT_AUTOMATIC_..., _ERODING_..., _TIED_... and those without: SURFACE_TO_SURFACE, NODES_TO_SURFACE and so on.
struct ContactCard {
  std::string kind;  ///< what follows *CONTACT_ and AUTOMATIC_: "SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET"
  ContactSide slave, master;
  double static_friction = 0, dynamic_friction = 0, decay = 0;  ///< FS, FD, DC: FD + (FS - FD) exp(-DC v)
  FileNumber number = 0;                                        ///< CID of _ID, 0 without
  std::string title = {};
  bool automatic = true;                                   ///< AUTOMATIC: either side of a plate is touched
  double damping = 0;                                      ///< VDC, of the critical one [percent]
  double birth = 0;                                        ///< BT [time]
  double death = std::numeric_limits<double>::infinity();  ///< DT [time]
  FileNumber soft = 0;                                     ///< SOFT
  double soft_scale = 0.1;                                 ///< SOFSCL
  FileNumber depth = 2;                                    ///< DEPTH
  bool exposes = false;  ///< EROSOP or IADJ of ERODING: faces that deletions expose are touched

  bool is_tied() const { return kind.starts_with("TIED_"); }
  bool is_eroding() const { return kind.starts_with("ERODING_"); }
};

}  // namespace strike
