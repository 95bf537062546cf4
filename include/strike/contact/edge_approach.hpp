#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/ascending.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/follow_touch.hpp>
#include <strike/contact/neighbourhood.hpp>
#include <strike/contact/pierced.hpp>
#include <strike/contact/rounding.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/step.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// An edge of a surface with its faces; `other` is Target::none at a border.
struct Edge {
  std::array<Index, 2> ends{};
  Index face = 0, other = 0;
};

/// Borders and crests of a surface, of more than 30 degrees: where others touch it by its edges. Plates fold either
/// way.
template <Execution E = Serial>
std::vector<Edge> crests(const Target& target, std::span<const Eigen::Vector3d> x, const E& execution = {}) {
  const std::size_t faces = target.faces().size();
  std::vector<Eigen::Vector3d> normals(faces);
  for_each_chunk(execution, faces, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) normals[f] = target.normal(static_cast<Index>(f), x);
  });
  std::vector<std::vector<Edge>> found(chunks(faces));
  for_each_chunk(execution, faces, [&](std::size_t c, std::size_t first, std::size_t last) {
    for (Index f = static_cast<Index>(first); f < last; ++f)
      for (unsigned k = 0; k < target.count(f); ++k) {
        const Index other = target.across(f, k), a = target.faces()[f][k],
                    b = target.faces()[f][(k + 1) % target.count(f)];
        if (other != Target::none) {
          if (other < f || normals[f].dot(normals[other]) > 0.866) continue;
          if (!target.is_plate(f) && normals[f].dot(target.middle(other, x) - x[a]) > 0) continue;  // a dent
        }
        found[c].push_back({{a, b}, f, other});
      }
  });
  std::vector<Edge> edges;
  for (const auto& some : found) edges.insert(edges.end(), some.begin(), some.end());
  return edges;
}

/// The points of two lines that are nearest to each other, by their places along p and q, and the unit normal of both.
struct Crossover {
  double along_p, along_q;
  Eigen::Vector3d normal;
  bool parallel;

  Crossover(const std::array<Eigen::Vector3d, 2>& p, const std::array<Eigen::Vector3d, 2>& q) {
    const Eigen::Vector3d d = p[1] - p[0], e = q[1] - q[0], r = p[0] - q[0], across = cross<double>(d, e);
    const double dd = d.squaredNorm(), de = d.dot(e), ee = e.squaredNorm(), dr = d.dot(r), er = e.dot(r);
    const double det = across.squaredNorm();
    parallel = !(det > 1e-4 * dd * ee);
    if (parallel) return;
    along_p = (de * er - ee * dr) / det, along_q = (dd * er - de * dr) / det;
    normal = (1 / std::sqrt(det)) * across;
  }
  /// True between the ends, less a share of the edges; more with a negative one.
  bool is_within(double share) const { return std::min({along_p, 1 - along_p, along_q, 1 - along_q}) > share; }
};

/// The crests and borders of two surfaces, or of one and itself, that cross: where no node touches a face.
template <bool self>
class EdgeApproach {
 public:
  EdgeApproach() = default;
  EdgeApproach(Target first, Target second) : targets_{std::move(first), std::move(second)} {}

  /// Tells of crests that pass through faces of the other surface where no node is inside.
  void begin(const ContactNodes& all, InitialPenetration& inside) {
    size_ = targets_[1].mean_size(all.x);
    largest_depth_ = targets_[0].largest_half() + targets_[1].largest_half();
    if (self && largest_depth_ > 0) start_ = all.x;
    if (!start_.empty()) neighbourhood_.find(targets_[1], start_);
    find_piercing(0, all, inside);
    if (!self) find_piercing(1, all, inside);
  }
  /// Other surfaces, after cells have gone. A touch goes on where both of its edges remain.
  void change(Target first, Target second) {
    targets_ = {std::move(first), std::move(second)};
    std::erase_if(touches_, [&](const EdgeTouch& touch) {
      return !has(targets_[0], touch.ends[0], touch.ends[1]) || !has(targets_[1], touch.ends[2], touch.ends[3]);
    });
    if (!start_.empty()) neighbourhood_.find(targets_[1], start_);
    margin_ = -1;
  }

  /// Appends the pairs of the step: those that go on, then others, each in the order of the edges, of which each is
  /// decided alone. `touches(i)` tells whether node i touches a face, as it does where a crossing is next to it.
  template <class Touches, class Execution>
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs, const Touches& touches,
            Rounding& rounding, const Execution& execution) {
    update(all, step.dt, execution);
    last_.swap(touches_), touches_.clear();
    const std::size_t first_pair = pairs.size();
    collect(execution, last_.size(), [&](std::size_t k, Found& found) { follow(last_[k], all, step.dt, found); });
    for (const Found& found : found_) {
      touches_.insert(touches_.end(), found.touches.begin(), found.touches.end());
      pairs.insert(pairs.end(), found.pairs.begin(), found.pairs.end());
      for (const Index i : found.gone_past) rounding.add(i);
    }
    const auto& awake = search_.awake();
    collect(execution, awake.size(),
            [&](std::size_t k, Found& found) { look_around(awake[k], all, step.dt, touches, rounding, found); });
    for (const Found& found : found_)
      for (std::size_t k = 0; k < found.touches.size(); ++k)
        if (!is_among(touches_, found.touches[k]))  // edges of three faces come more than once
          touches_.push_back(found.touches[k]), pairs.push_back(found.pairs[k]);
    for (std::size_t k = 0; k < touches_.size(); ++k) remember(pairs[first_pair + k], touches_[k]);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(targets_[0], targets_[1], touches_, crests_[0], crests_[1], search_, neighbourhood_, margin_, travelled_,
            reach_);
    wakes_.assign(search_.size(), 0.0);
    find_ends();
  }

 private:
  using Ends = std::array<Eigen::Vector3d, 2>;
  struct EdgeTouch {
    std::array<Index, 4> ends{};                       // of the first edge and of the second
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, to the side of the first
    double stored = 0;                                 // as in Touch [energy]
    Eigen::Vector3d friction = Eigen::Vector3d::Zero();

    template <class Archive>
    void serialize(Archive& archive) {
      archive(ends, normal, stored, friction);
    }
  };
  /// Touches of the edges of a chunk, and their pairs.
  struct Found {
    std::vector<EdgeTouch> touches;
    std::vector<ContactPair> pairs;
    std::vector<Index> gone_past;  // an end, nodes of the contact

    void clear() { touches.clear(), pairs.clear(), gone_past.clear(); }
  };
  static constexpr std::size_t per_chunk = 64;
  static constexpr double overhang = 0.02;  // of an edge, in its length

  /// Calls f(k, found) for 0, ..., n - 1 in chunks, whose `found_` stand in this order.
  template <class Execution, class F>
  void collect(const Execution& execution, std::size_t n, const F& f) {
    found_.resize((n + per_chunk - 1) / per_chunk);
    execution.for_each(found_.size(), [&](std::size_t c) {
      found_[c].clear();
      for (std::size_t k = c * per_chunk; k < std::min((c + 1) * per_chunk, n); ++k) f(k, found_[c]);
    });
  }
  static bool is_among(const std::vector<EdgeTouch>& touches, const EdgeTouch& touch) {
    return std::any_of(touches.begin(), touches.end(),
                       [&](const EdgeTouch& other) { return other.ends == touch.ends; });
  }

  static bool has(const Target& target, Index a, Index b) {
    const auto faces = target.at(a);
    return std::any_of(faces.begin(), faces.end(), [&](Index f) { return target.has(f, b); });
  }
  static Ends ends_of(const std::array<Index, 2>& edge, std::span<const Eigen::Vector3d> x) {
    return {x[edge[0]], x[edge[1]]};
  }

  /// Crests of a surface that pass through faces of the other one.
  void find_piercing(std::size_t s, const ContactNodes& all, InitialPenetration& inside) const {
    const Target &own = targets_[s], &other = targets_[1 - s];
    std::vector<bool> is_inside(all.size(), false);
    for (const Overlap& overlap : inside.overlaps) is_inside[all.local(overlap.nodes[0])] = true;
    std::vector<Edge> edges = crests(own, all.x);
    std::erase_if(edges, [&](const Edge& edge) { return is_inside[edge.ends[0]] || is_inside[edge.ends[1]]; });
    std::vector<std::array<Index, 2>> ends;
    for (const Edge& edge : edges) ends.push_back(edge.ends);
    const auto passes_by = [&](std::size_t e, Index f) {
      const auto& [p, q] = edges[e].ends;
      return self && (other.are_apart(edges[e].face, f) ||
                      (!start_.empty() && (neighbourhood_.has(p, f) || neighbourhood_.has(q, f))));
    };
    for (const auto& piercing : piercing_edges(ends, other, all.x, passes_by)) inside.add_piercing(all, piercing);
  }

  /// Finds crests and which are near, if they may have moved by the margin at the end of the step after this one.
  template <class Execution>
  void update(const ContactNodes& all, double dt, const Execution& execution) {
    // The way of the last step, with all impulses, takes the place of the one that was expected.
    last_reach_ = 2 * fastest([&](Index i) -> Eigen::Vector3d { return all.x[i] - all.x_before[i]; }, execution);
    travelled_ += last_reach_ - reach_;
    reach_ = 2 * dt * fastest([&](Index i) { return all.v[i]; }, execution);
    if (!(travelled_ + 2 * reach_ <= margin_)) sort(all, std::max(8 * reach_, 0.5 * size_), execution);
    travelled_ += reach_;
  }
  /// The largest of a vector at the ends of crests relative to their mean.
  template <class Of, class Execution>
  double fastest(const Of& of, const Execution& execution) const {
    std::vector<Eigen::Vector3d> sums(chunks(ends_.size()));
    for_each_chunk(execution, ends_.size(), [&](std::size_t c, std::size_t first, std::size_t last) {
      Eigen::Vector3d sum{0, 0, 0};
      for (std::size_t k = first; k < last; ++k) sum += of(ends_[k]);
      sums[c] = sum;
    });
    Eigen::Vector3d mean{0, 0, 0};
    for (const Eigen::Vector3d& sum : sums) mean += sum;
    mean /= static_cast<double>(std::max<std::size_t>(ends_.size(), 1));
    std::vector<double> most2(sums.size());
    for_each_chunk(execution, ends_.size(), [&](std::size_t c, std::size_t first, std::size_t last) {
      double most = 0;
      for (std::size_t k = first; k < last; ++k) most = std::max(most, (of(ends_[k]) - mean).squaredNorm());
      most2[c] = most;
    });
    return most2.empty() ? 0 : std::sqrt(*std::max_element(most2.begin(), most2.end()));
  }
  void find_ends() {
    ends_.clear();
    for (const auto& edges : crests_)
      for (const Edge& edge : edges) ends_.insert(ends_.end(), edge.ends.begin(), edge.ends.end());
    ends_ = ascending(std::move(ends_));
  }
  template <class Execution>
  void sort(const ContactNodes& all, double margin, const Execution& execution) {
    double longest = 0;
    std::vector<Eigen::Vector3d> x = all.x;
    std::vector<Index> middles;
    std::vector<FaceCorners> others;
    crests_[0] = crests(targets_[0], all.x, execution);
    crests_[1] = self ? crests_[0] : crests(targets_[1], all.x, execution);
    find_ends();
    for (const Edge& edge : crests_[0]) {
      const auto [p, q] = ends_of(edge.ends, all.x);
      longest = std::max(longest, (q - p).norm());
      middles.push_back(static_cast<Index>(x.size())), x.push_back(0.5 * (p + q));
    }
    for (const auto& [ends, face, other] : crests_[1]) others.push_back({ends[0], ends[1], ends[1], ends[1]});
    const auto less = [&](Index s, Index k) {
      const Edge &p = crests_[0][s], &q = crests_[1][k];
      if (never_meet(p, q)) return std::numeric_limits<double>::infinity();
      return largest_depth_ - largest_depth(p, q) + 0.5 * (longest - (all.x[p.ends[1]] - all.x[p.ends[0]]).norm());
    };
    const double apart = search_.sort(middles, others, x, largest_depth_ + 0.5 * longest + margin, execution, less);
    margin_ = margin + apart, travelled_ = 0;
    wakes_.assign(search_.size(), 0.0);
  }
  /// Edges that share a node, of a neighbourhood or of pieces left out; of two edges of one surface one stands first.
  bool never_meet(const Edge& first, const Edge& second) const {
    const auto& [p, q] = std::pair(first.ends, second.ends);
    return (self && (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1] || !(p < q) ||
                     targets_[1].are_apart(first.face, second.face))) ||
           (!start_.empty() && (neighbourhood_.has(p[0], second.face) || neighbourhood_.has(p[1], second.face)));
  }
  /// A bound of how far two edges are from touching [length].
  double clearance(const Edge& first, const Edge& second, const ContactNodes& all) const {
    const Ends p = ends_of(first.ends, all.x), q = ends_of(second.ends, all.x);
    return 0.5 * ((p[0] + p[1] - q[0] - q[1]).norm() - (p[1] - p[0]).norm() - (q[1] - q[0]).norm()) -
           largest_depth(first, second);
  }
  /// The largest distance of the middles of two edges when they touch [length].
  double largest_depth(const Edge& first, const Edge& second) const {
    return std::max(targets_[0].half(first.ends[0]), targets_[0].half(first.ends[1])) +
           std::max(targets_[1].half(second.ends[0]), targets_[1].half(second.ends[1]));
  }

  void follow(EdgeTouch touch, const ContactNodes& all, double dt, Found& found) const {
    const Crossover at(ends_of({touch.ends[0], touch.ends[1]}, all.x), ends_of({touch.ends[2], touch.ends[3]}, all.x));
    if (at.parallel || !at.is_within(-overhang)) {
      found.gone_past.insert(found.gone_past.end(), touch.ends.begin(), touch.ends.end());
      return;
    }
    const double side = at.normal.dot(touch.normal) < 0 ? -1 : 1;
    const ContactPair pair = pair_of(touch.ends, at, side * at.normal, all);
    if (pair.gap > 0 && pair.gap + dt * pair.normal.dot(pair.velocity(all)) >= 0) return;
    touch.normal = pair.normal;
    found.touches.push_back(touch), found.pairs.push_back(pair);
  }
  ContactPair pair_of(const std::array<Index, 4>& ends, const Crossover& at, const Eigen::Vector3d& normal,
                      const ContactNodes& all) const {
    ContactPair pair(normal, -depth_of(ends, at));
    const double weights[] = {1 - at.along_p, at.along_p, at.along_q - 1, -at.along_q};
    for (std::size_t k = 0; k < 4; ++k) {
      pair.add(ends[k], weights[k]);
      pair.gap += weights[k] * normal.dot(all.x[ends[k]]);
    }
    return pair;
  }

  /// The distance of the middles of two edges, by their ends, when they touch [length].
  double depth_of(const std::array<Index, 4>& ends, const Crossover& at) const {
    const auto half = [&](const Target& target, Index p, Index q, double along) {
      return (1 - along) * target.half(p) + along * target.half(q);
    };
    return largest_depth_ > 0
               ? half(targets_[0], ends[0], ends[1], at.along_p) + half(targets_[1], ends[2], ends[3], at.along_q)
               : 0;
  }

  /// Begins the touches of a crest of the first surface with those near it that do not rest.
  template <class Touches>
  void look_around(Index s, const ContactNodes& all, double dt, const Touches& touches, const Rounding& rounding,
                   Found& found) {
    double* wakes = wakes_.data() + search_.first(s);
    for (const Index k : search_.near(s)) {
      const Edge &p = crests_[0][s], &q = crests_[1][k];
      if (double& wake = *wakes++; !(travelled_ < wake)) {
        const double apart = clearance(p, q, all);
        wake = travelled_ - reach_ + apart;
        if (!(apart > std::max(reach_, last_reach_) + 1e-6 * size_))
          begin_touch(p, q, all, dt, touches, rounding, found);
      }
    }
  }
  template <class Touches>
  void begin_touch(const Edge& first, const Edge& second, const ContactNodes& all, double dt, const Touches& touches,
                   const Rounding& rounding, Found& found) const {
    const auto& [p, q] = std::pair(first.ends, second.ends);
    Ends way_p, way_q, back_p, back_q;
    for (std::size_t k = 0; k < 2; ++k) {
      way_p[k] = dt * all.v[p[k]], way_q[k] = dt * all.v[q[k]];
      back_p[k] = all.x[p[k]] - all.x_before[p[k]], back_q[k] = all.x[q[k]] - all.x_before[q[k]];
    }
    const Ends P = ends_of(p, all.x), Q = ends_of(q, all.x);
    if (!may_cross(P, way_p, Q, way_q) && !may_cross(P, back_p, Q, back_q)) return;
    EdgeTouch touch{{p[0], p[1], q[0], q[1]}};
    if (is_among(touches_, touch)) return;
    const bool comes_round = !rounding.is_empty() && std::any_of(touch.ends.begin(), touch.ends.end(),
                                                                 [&](Index end) { return rounding.has(end); });
    const double slack = comes_round ? 0.05 * size_ : 0.0;
    if (!crosses(first, second, P, way_p, Q, way_q, slack, all, touch.normal) &&
        !crosses(first, second, ends_of(p, all.x_before), back_p, ends_of(q, all.x_before), back_q, 0, all,
                 touch.normal))
      return;
    const Crossover at(P, Q);
    if (at.parallel || !at.is_within(-0.5)) return;
    if ((at.along_p < overhang && touches(p[0])) || (at.along_p > 1 - overhang && touches(p[1])) ||
        (at.along_q < overhang && touches(q[0])) || (at.along_q > 1 - overhang && touches(q[1])))
      return;
    touch.normal = at.normal.dot(touch.normal) < 0 ? Eigen::Vector3d(-at.normal) : at.normal;
    found.pairs.push_back(pair_of(touch.ends, at, touch.normal, all));
    found.touches.push_back(touch);
  }
  /// False if boxes around both ways stay apart.
  bool may_cross(const Ends& P, const Ends& U, const Ends& Q, const Ends& V) const {
    const double margin = largest_depth_ + 1e-6 * size_;
    for (int c = 0; c < 3; ++c) {
      const auto [a, b] =
          std::minmax({P[0](c), P[1](c), P[0](c) + U[0](c), P[1](c) + U[1](c), P[0](c) - U[0](c), P[1](c) - U[1](c)});
      const auto [l, u] =
          std::minmax({Q[0](c), Q[1](c), Q[0](c) + V[0](c), Q[1](c) + V[1](c), Q[0](c) - V[0](c), Q[1](c) - V[1](c)});
      if (b < l - margin || u < a - margin) return false;
    }
    return true;
  }

  /// True if the edges meet from outside between their ends during a motion, and both bodies lie behind the normal.
  bool crosses(const Edge& first, const Edge& second, const Ends& P, const Ends& U, const Ends& Q, const Ends& V,
               double slack, const ContactNodes& all, Eigen::Vector3d& normal) const {
    const double tolerance = 1e-6 * size_;
    const std::array<Index, 4> ends{first.ends[0], first.ends[1], second.ends[0], second.ends[1]};
    double t = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      const Crossover at({P[0] + t * U[0], P[1] + t * U[1]}, {Q[0] + t * V[0], Q[1] + t * V[1]});
      if (at.parallel) return false;
      const double a = at.along_p, b = at.along_q;
      const Eigen::Vector3d apart =
          (1 - a) * (P[0] + t * U[0]) + a * (P[1] + t * U[1]) - (1 - b) * (Q[0] + t * V[0]) - b * (Q[1] + t * V[1]);
      const Eigen::Vector3d way = (1 - a) * U[0] + a * U[1] - (1 - b) * V[0] - b * V[1];
      if (iteration == 0)
        normal = side_of(first, second, at.normal, apart, all) * at.normal;
      else
        normal = at.normal.dot(normal) < 0 ? Eigen::Vector3d(-at.normal) : at.normal;
      const double gap = normal.dot(apart) - depth_of(ends, at), rate = -normal.dot(way);
      const bool is_shallow = iteration == 0 && gap < 0 && gap > -slack;
      if (is_shallow || std::abs(gap) <= tolerance)
        return (is_shallow || rate > 0) && at.is_within(1e-6) && is_crest(targets_[1], second, normal, all) &&
               is_crest(targets_[0], first, -normal, all);
      if ((iteration == 0 && gap < 0) || !(rate > 0)) return false;
      t += gap / rate;
      if (!(t <= 1)) return false;
      t = std::max(t, 0.0);
    }
    return false;
  }
  /// 1 if the first edge comes from the side to which the normal points, else -1: by the sides of solids, or where
  /// plates are.
  double side_of(const Edge& first, const Edge& second, const Eigen::Vector3d& normal, const Eigen::Vector3d& apart,
                 const ContactNodes& all) const {
    if (targets_[0].is_plate(first.face) || targets_[1].is_plate(second.face)) return normal.dot(apart) < 0 ? -1 : 1;
    return normal.dot(outside(targets_[1], second, all) - outside(targets_[0], first, all)) < 0 ? -1 : 1;
  }
  static Eigen::Vector3d outside(const Target& target, const Edge& edge, const ContactNodes& all) {
    const auto normal = [&](Index f) { return target.normal(f, all.x); };
    return edge.other == Target::none ? normal(edge.face) : direction(normal(edge.face) + normal(edge.other));
  }
  /// True if no face of the edge rises along the normal, but for what bends them.
  static bool is_crest(const Target& target, const Edge& edge, const Eigen::Vector3d& normal, const ContactNodes& all) {
    const auto rises = [&](Index f) {
      const Eigen::Vector3d along = direction(all.x[edge.ends[1]] - all.x[edge.ends[0]]);
      const Eigen::Vector3d in = target.middle(f, all.x) - all.x[edge.ends[0]];
      const Eigen::Vector3d inwards = in - along.dot(in) * along;
      return normal.dot(inwards) > 0.1 * inwards.norm();
    };
    return !rises(edge.face) && (edge.other == Target::none || !rises(edge.other));
  }

  std::array<Target, 2> targets_;
  double largest_depth_ = 0, size_ = 0;
  std::vector<EdgeTouch> touches_, last_;  // of this step and of the last
  std::vector<Found> found_;               // by their chunks
  std::array<std::vector<Edge>, 2> crests_;
  std::vector<Index> ends_;  // of all crests, each once
  BucketSearch search_;      // of the crests of the second near the middle of each of the first
  double margin_ = -1, travelled_ = 0, reach_ = 0, last_reach_ = 0;
  std::vector<double> wakes_;           // what has to be travelled first, of each edge near another
  std::vector<Eigen::Vector3d> start_;  // of plates that may touch themselves
  Neighbourhood neighbourhood_;
};

}  // namespace strike::detail
