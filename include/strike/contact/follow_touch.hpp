#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// A touch goes on from face to face where their normals differ by less than 60 degrees; else their edge is a crest,
/// past which a node is not behind the other face but beside the body.
inline bool goes_on(const Eigen::Vector3d& normal, const Eigen::Vector3d& other) { return normal.dot(other) > 0.5; }

/// A node that touches, which follows its face and those around.
template <bool self>
class FollowedTouch {
 public:
  FollowedTouch(const Touch& touch, Index i, const TouchedFaces& faces, const ContactNodes& all,
                std::span<const Index> near)
      : touch_(touch), i_(i), faces_(faces), all_(all), near_(near) {}

  /// Where the node is now; nothing if it has gone past a border or a crest.
  std::optional<Place> place() const { return faces_.is_at_a_distance(i_, touch_.face) ? at_a_distance() : on_solid(); }

 private:
  bool is_own(Index f) const { return self && faces_.target.has(f, i_); }

  /// Where plates are in it, which touch at a distance from their middle: the closest point of its face or of those
  /// around; of those beyond a crest only while its middle is outside of the solid, for within it they are beside it
  /// and not behind. The side of a plate is given by the vector at its present face, and at those around by their
  /// common order of corners.
  std::optional<Place> at_a_distance() const {
    const Foot own = faces_.foot(touch_.face, all_, i_, touch_.place);
    const bool is_plate = faces_.target.is_plate(touch_.face), is_inside = !is_plate && own.height < 0;
    Foot best = nearest_from(
        own, [&](Index f) { return !is_own(f) && (!is_inside || goes_on(touch_.normal, faces_.normal(f, all_))); });
    const auto is_behind = [&](Index f, const std::array<double, 4>& N) {
      return is_plate && touch_.normal.dot(faces_.normal(f, N, all_)) < 0;
    };
    bool behind = is_behind(touch_.face, own.point.N);
    if (best.point.where != ClosestPoint::inside)
      each_in_line(faces_.projection(touch_.face, all_, i_).away, [&](Index f, const Projection& foot) {
        if (foot.beyond > closed || foot.away.squaredNorm() >= best.point.distance2) return;
        best = faces_.foot(f, all_, i_), behind = is_behind(f, foot.N);
      });
    if (best.on_border) {
      if (is_plate)
        behind = is_within(best) && !slid_off(best) ? behind : best.height < 0;  // round the edge of a plate
      else if (slid_off(best))
        return std::nullopt;
    }
    const double side = behind ? -1 : 1;
    return Place{best.face, best.point.N, side * best.normal, side * best.height};
  }
  /// True if the node went past the border of a plate or an open surface rather than through it.
  bool slid_off(const Foot& foot) const {
    const double down = faces_.normal(foot.face, foot.point.N, all_).dot(foot.point.away);
    return foot.point.distance2 > 2 * down * down + 1e-24 * faces_.size * faces_.size;
  }
  /// True if the node is within the thickness of a plate.
  bool is_within(const Foot& foot) const {
    const double depth = faces_.depth(i_, foot.face, foot.point.N);
    return foot.point.distance2 < depth * depth;
  }

  /// Of a solid: the foot of the perpendicular on its face, or on one that goes on there; else on the edge of a dent.
  std::optional<Place> on_solid() const {
    const Projection own = faces_.projection(touch_.face, all_, i_, touch_.place);
    if (own.beyond <= closed) return at(touch_.face, own);

    Index least = touch_.face;
    Projection best = own;
    const auto look = [&](Index f, const Projection& foot) {
      const bool both_hold = foot.beyond <= closed && best.beyond <= closed;
      if (both_hold ? foot.away.squaredNorm() < best.away.squaredNorm() : foot.beyond < best.beyond)
        best = foot, least = f;
    };
    faces_.each_around(touch_.face, [&](Index f) {
      if (f == touch_.face || is_own(f) || !goes_on(touch_.normal, faces_.normal(f, all_))) return;
      look(f, faces_.projection(f, all_, i_));
    });
    if (best.beyond > closed)
      each_in_line(own.away, [&](Index f, const Projection& foot) {
        if (foot.beyond <= closed) look(f, foot);
      });
    if (best.beyond <= closed || (best.beyond <= overhang && ends(least, best.edge))) return at(least, best);

    const Foot nearest = nearest_from(faces_.foot(touch_.face, all_, i_), [&](Index f) {
      return !is_own(f) && goes_on(touch_.normal, faces_.normal(f, all_));
    });
    if (is_at_end(nearest)) return best.beyond <= overhang ? std::optional(at(least, best)) : std::nullopt;
    const double side = touch_.normal.dot(nearest.normal) < 0 ? -1 : 1;
    return Place{nearest.face, nearest.point.N, side * nearest.normal, side * nearest.height};
  }

  /// The nearest foot, from face to face as long as one around is nearer.
  template <class Admits>
  Foot nearest_from(Foot best, const Admits& admits) const {
    for (Index from = Target::none; best.face != from;) {
      from = best.face;
      faces_.each_around(from, [&](Index f) {
        if (f == from || !may_be_nearer(f, best) || !admits(f)) return;
        if (const Foot foot = faces_.foot(f, all_, i_); foot.point.distance2 < best.point.distance2) best = foot;
      });
    }
    return best;
  }
  /// False if all corners of a face, and so their hull, in which it lies, are beyond the plane through a foot, or in it
  /// to rounding, or if their box is farther than the foot.
  bool may_be_nearer(Index f, const Foot& foot) const {
    const Corners X = faces_.target.corners(f, all_.x);
    const Eigen::Vector3d& x = all_.x[i_];
    const double plane = (1 - 1e-9) * foot.point.distance2;
    if (std::none_of(X.begin(), X.end(), [&](const auto& corner) { return foot.point.away.dot(x - corner) < plane; }))
      return false;
    return squared_distance_to_box(X, x) < foot.point.distance2;
  }

  /// Calls g(f, foot) for other faces near that go on in the plane of the present one: those of another part, at a
  /// seam, or those that a fast node has come to past its neighbours. `away` leads from that plane to the node.
  template <class G>
  void each_in_line(const Eigen::Vector3d& away, const G& g) const {
    for (const Index f : near_) {
      if (!faces_.target.are_alike(f, touch_.face) || faces_.are_connected(f, touch_.face) || is_own(f)) continue;
      const double cosine = touch_.normal.dot(faces_.normal(f, all_));
      if (!(faces_.target.is_plate(f) ? std::abs(cosine) > 0.5 : cosine > 0.5)) continue;
      const Projection foot = faces_.projection(f, all_, i_);
      if (std::abs(touch_.normal.dot(foot.away - away)) < overhang * faces_.size) g(f, foot);
    }
  }

  /// True for a border or a crest.
  bool ends(Index face, unsigned edge) const {
    const Index other = faces_.target.across(face, edge);
    return other == Target::none || !goes_on(touch_.normal, faces_.normal(other, all_));
  }
  /// True on a border or a crest.
  bool is_at_end(const Foot& foot) const {
    const Target& target = faces_.target;
    if (foot.point.where == ClosestPoint::inside) return false;
    if (foot.point.where == ClosestPoint::on_edge) return ends(foot.face, foot.point.which);
    const Index corner = target.faces()[foot.face][foot.point.which];
    for (const Index face : target.at(corner)) {
      if (!target.are_alike(face, foot.face)) continue;
      if (!goes_on(touch_.normal, faces_.normal(face, all_))) return true;
      const unsigned n = target.count(face);
      for (unsigned k = 0; k < n; ++k)
        if (target.faces()[face][k] == corner && (ends(face, k) || ends(face, (k + n - 1) % n))) return true;
    }
    return false;
  }

  static Place at(Index f, const Projection& foot) { return {f, foot.N, foot.normal, foot.normal.dot(foot.away)}; }

  static constexpr double closed = 1e-9, overhang = 0.02;  // of the edges of a face, in its widths

  const Touch& touch_;
  Index i_;
  const TouchedFaces& faces_;
  const ContactNodes& all_;
  std::span<const Index> near_;
};

}  // namespace strike::detail
