#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <strike/input/source.hpp>
#include <strike/load/air_blast.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>

// The loads and prescribed motions of an LS-DYNA deck as values (LS-DYNA Keyword User's Manual R13, volume I, *LOAD and
// *BOUNDARY_PRESCRIBED_MOTION). Numbers are in the units of the deck.
namespace strike {

/// The history of a load or a motion: its scale times the ordinate of its curve at the time since its birth, and 0
/// outside of its life. Linear between the points, constant before the first and after the last; of two points at one
/// time the later counts from there. Wherever a history is taken: `BodyForce{b.direction, b.history}`.
struct CardHistory {
  FileNumber curve = 0;  ///< LCID
  double scale = 1;      ///< SF
  double birth = 0;      ///< AT or BIRTH, where the time of the curve begins [time]
  double death = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> points = {};  ///< of the curve, by ascending times

  double operator()(double time) const {
    if (time < birth || time >= death) return 0;
    if (points.empty()) return scale;
    const auto next = std::upper_bound(points.begin(), points.end(), time - birth,
                                       [](double t, const std::array<double, 2>& point) { return t < point[0]; });
    if (next == points.begin()) return scale * points.front()[1];
    if (next == points.end()) return scale * points.back()[1];
    const auto& [t, v] = *(next - 1);
    const auto& [t_next, v_next] = *next;
    return scale * (v + (v_next - v) * ((time - birth - t) / (t_next - t)));
  }
  /// Its integral over the time up to this: the velocity of an acceleration, from rest.
  double integral(double time) const {
    const double end = std::min(time, death) - birth;
    if (!(end > 0)) return 0;
    if (points.empty()) return scale * end;
    double sum = std::clamp(points.front()[0], 0.0, end) * points.front()[1];
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto& [a, v] = points[i - 1];
      const auto& [b, w] = points[i];
      const double from = std::clamp(0.0, a, b), to = std::clamp(end, a, b);
      if (from < to) sum += (to - from) * (v + (w - v) * ((0.5 * (from + to) - a) / (b - a)));
    }
    sum += (end - std::clamp(points.back()[0], 0.0, end)) * points.back()[1];
    return scale * sum;
  }
};

/// *LOAD_BODY_X, _Y and _Z: `BodyForce{b.direction, b.history}`. The curve of the card accelerates the ground along its
/// axis, so that a positive value pushes the nodes the other way, which `direction` does: gravity along -z has a
/// positive curve of *LOAD_BODY_Z.
struct BodyLoadCard {
  Eigen::Vector3d direction;           ///< against the axis, of length 1
  CardHistory history;                 ///< [length/time^2]
  std::vector<FileNumber> parts = {};  ///< of *LOAD_BODY_PARTS, the only ones that feel it; all parts if there are none
};

/// *LOAD_NODE_POINT and _SET: `NodalForce{f.direction, f.nodes, f.history}` on each node; a node that the deck loads
/// twice is in two of them.
struct NodalLoadCard {
  std::vector<Index> nodes;
  Eigen::Vector3d direction;
  bool turns = false;  ///< a moment about the direction, not a force along it
  CardHistory history;
};

/// *LOAD_SEGMENT, *LOAD_SEGMENT_SET, *LOAD_SHELL_ELEMENT and _SET: `Pressure{p.faces(), p.history}`. A positive value
/// pushes against the normal, which looks to where the corners run counter-clockwise: a `Pressure` does the same.
struct PressureLoadCard {
  std::vector<std::array<Index, 4>> segments;  ///< a triangle repeats its last corner
  CardHistory history;                         ///< [stress]

  std::vector<Face> faces() const {
    std::vector<Face> all;
    for (const auto& corners : segments) all.push_back({corners, 0});
    return all;
  }
};

/// *BOUNDARY_PRESCRIBED_MOTION_NODE, _SET and _RIGID: `PrescribedVelocity{m.direction, m.nodes, m.history}`, or a
/// `PrescribedDisplacement`; of an acceleration the velocity is `m.history.integral(t)`. Before its birth and after its
/// death what it moves is free.
struct PrescribedMotionCard {
  enum class Kind { velocity, acceleration, displacement };  ///< VAD
  std::vector<Index> nodes;                                  ///< none of a rigid body
  FileNumber body = 0;                                       ///< the part that is a rigid body; 0 for nodes
  Eigen::Vector3d direction;                                 ///< of length 1
  bool turns = false;                                        ///< about the direction, not along it
  bool holds_others = false;  ///< DOF -4 and -8: no motion along, or about, the directions across it
  Kind kind = Kind::velocity;
  CardHistory history;
};

/// *LOAD_BLAST_ENHANCED with its *LOAD_BLAST_SEGMENT and _SET, and *LOAD_BLAST with the pressures whose LCID is -2: a
/// charge of TNT in air, and the faces that it loads: `AirBlast{b.faces(), b.charge()}`.
struct BlastCard {
  /// BLAST or ISURF: half a charge on the ground, a free one, a moving one, a charge above the ground.
  enum class Kind { on_ground = 1, in_air = 2, moving = 3, above_ground = 4 };
  FileNumber number = 0;  ///< BID, 0 of *LOAD_BLAST
  double mass;            ///< M or WGT, of TNT
  Eigen::Vector3d centre;
  double start = 0;  ///< TBO, when it detonates [time]
  Kind kind = Kind::in_air;
  FileNumber unit = 2;                   ///< UNIT
  std::array<double, 4> si{1, 1, 1, 1};  ///< kilograms, metres, seconds and pascals in a unit of the deck
  double death = std::numeric_limits<double>::infinity();
  bool without_suction = false;                     ///< NEGPHS 1: no pressure below that of the air
  std::vector<std::array<Index, 4>> segments = {};  ///< a triangle repeats its last corner

  std::vector<Face> faces() const {
    std::vector<Face> all;
    for (const auto& corners : segments) all.push_back({corners, 0});
    return all;
  }
  /// The charge, of BLAST 1 or 2.
  Charge charge() const {
    return {.mass = mass,
            .centre = centre,
            .start = start,
            .burst = kind == Kind::on_ground ? Burst::surface : Burst::free_air,
            .units = {.mass = si[0], .length = si[1], .time = si[2], .pressure = si[3]},
            .end = death,
            .suction = !without_suction};
  }
};

}  // namespace strike
