#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/overlap.hpp>
#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/dynamics/running_scene.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/element/cell_shape.hpp>
#include <strike/error.hpp>
#include <strike/mesh/check_cell.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/text.hpp>

namespace strike {

/// The report of pushed_apart, the last item of its scene; its warning says the same in a sentence.
struct PushedApart {
  std::size_t moved = 0;  ///< number of nodes that have been moved
  Index farthest = 0;     ///< number of the one that has been moved farthest
  double way = 0;         ///< its way [length]

  void begin(const auto&) {}
  std::string warning() const {
    if (moved == 0) return {};
    return detail::joined({std::to_string(moved), moved == 1 ? " node has" : " nodes have",
                           " been moved before the run, so that nothing overlaps, the farthest, node ",
                           std::to_string(farthest), ", by ", detail::text(way), "."});
  }
  void serialize(auto&) {}
};

namespace detail {

/// Moves the nodes of a run to where nothing overlaps, whatever its scene is.
template <class Nodes>
class OverlapRemoval {
 public:
  explicit OverlapRemoval(Nodes& nodes) : nodes_(nodes), ways_(nodes.size(), Eigen::Vector3d::Zero()) {}

  /// find(warns) gives the overlaps as the nodes lie, and whether a contact warns of any. Each round takes them and
  /// moves their nodes as little as may be, sum of m u^2/2, to where none is left along the normals; after a few
  /// rounds, to where no contact warns of any. Errors: conditions hold both sides of an overlap; some is left after the
  /// last round.
  void move(const std::function<std::vector<Overlap>(bool&)>& find) {
    constexpr int rounds = 100, few = 20;
    std::vector<Overlap> overlaps;
    for (int round = 0; round <= rounds; ++round) {
      bool warns = false;
      overlaps = find(warns);
      if (overlaps.empty() || (round >= few && !warns)) return;
      if (round < rounds) push_apart(overlaps);
    }
    const Overlap& deepest = *std::max_element(overlaps.begin(), overlaps.end(),
                                               [](const auto& a, const auto& b) { return a.depth < b.depth; });
    throw Error(joined({"strike: after ", std::to_string(rounds), " rounds of moving nodes apart ", text_of(deepest),
                        "; move the meshes apart, or leave them as they are without pushed_apart."}));
  }

 private:
  /// Projected Gauss-Seidel over the overlaps, forward and backward in turn, with multipliers J >= 0 [mass length].
  void push_apart(const std::vector<Overlap>& overlaps) {
    constexpr int sweeps = 2000;
    std::vector<double> pushed(overlaps.size(), 0.0);
    double deepest = 0, change = std::numeric_limits<double>::infinity();
    for (const Overlap& overlap : overlaps) deepest = std::max(deepest, overlap.depth);
    for (int sweep = 0; sweep < sweeps && change > 1e-13 * deepest; ++sweep) {
      change = 0;
      for (std::size_t k = 0; k < overlaps.size(); ++k) {
        const std::size_t p = sweep % 2 == 0 ? k : overlaps.size() - 1 - k;
        const Overlap& overlap = overlaps[p];
        double free = 0, all = 0, apart = 0;
        for (unsigned i = 0; i < overlap.count; ++i) {
          const Index node = overlap.nodes[i];
          const double w = overlap.weights[i], share = w * w / nodes_.mass(node);
          free += share * nodes_.free(node, overlap.normal).dot(overlap.normal), all += share;
          apart += w * overlap.normal.dot(ways_[node]);
        }
        if (!(free > 1e-6 * all))
          throw Error(joined({"strike: ", text_of(overlap),
                              ", and conditions hold both sides; move the meshes apart, or leave them as they are "
                              "without pushed_apart."}));
        const double J = std::max(-pushed[p], (overlap.depth - apart) / free);
        pushed[p] += J, change = std::max(change, std::abs(J) * free);
        for (unsigned i = 0; i < overlap.count; ++i) {
          const Index node = overlap.nodes[i];
          ways_[node] += (overlap.weights[i] * J / nodes_.mass(node)) * nodes_.free(node, overlap.normal);
        }
      }
    }
    for (const Overlap& overlap : overlaps)
      for (unsigned i = 0; i < overlap.count; ++i) {
        Eigen::Vector3d& way = ways_[overlap.nodes[i]];
        nodes_.set_position(overlap.nodes[i], nodes_.x(overlap.nodes[i]) + way);
        way.setZero();
      }
  }

  std::string text_of(const Overlap& overlap) const {
    return joined({"node ", std::to_string(overlap.nodes[0]), " at ", text(nodes_.x(overlap.nodes[0])), " is ",
                   text(overlap.depth), " inside what it may touch"});
  }

  Nodes& nodes_;
  std::vector<Eigen::Vector3d> ways_;  // of all nodes in a round; zero between
};

/// The overlaps that an item finds when it is begun anew where the nodes are. Error: it warns of what it does not
/// describe.
template <class Item, class Nodes>
void add_overlaps(const Item& item, Nodes& nodes, std::span<const PartFaces> parts, std::vector<Overlap>& all,
                  bool& warned) {
  if constexpr (requires { item.overlaps(); }) {
    auto begun = item;
    call_if_present<item::Begin>(begun, nodes, parts);
    const std::vector<Overlap>& overlaps = begun.overlaps();
    const std::string warning = begun.warning();
    bool warns = !warning.empty();
    if constexpr (requires { begun.inside(); }) warns = begun.inside() > 0;  // and not of edges
    warned = warned || warns;
    if (overlaps.empty() && warns)
      throw Error(
          joined({"strike: pushed_apart cannot move nodes of a pairing that does not say what they overlap; "
                  "add pairs to its InitialPenetration. Its warning: ",
                  warning}));
    all.insert(all.end(), overlaps.begin(), overlaps.end());
  }
}

/// A scene whose nodes move to where nothing overlaps.
template <class... Items>
class MovedApart : RunningScene<Method<>, Items...> {
  using Running = RunningScene<Method<>, Items...>;
  using typename Running::Nodes;

 public:
  explicit MovedApart(const Scene<Items...>& scene) : MovedApart(scene, Scene<Items...>(scene)) {}

  using Running::positions;

 private:
  MovedApart(const Scene<Items...>& given, Scene<Items...> scene) : Running(scene, arrange(scene)) {
    check_masses(this->nodes_);
    this->begin_items();  // conditions take directions from the nodes
    const std::vector<PartFaces> parts = this->part_faces();
    OverlapRemoval<Nodes>(this->nodes_).move([&](bool& warns) {
      std::vector<Overlap> all;
      each_item(given.items, [&](const auto& item) { add_overlaps(item, this->nodes_, parts, all, warns); });
      return all;
    });
  }
};

/// Error: a cell of a part that was sound is flat, inside out or twisted now.
template <class E, class M, std::size_t n, class R>
void check_moved(const Part<E, M, n, R>& part, std::size_t number, std::span<const Eigen::Vector3d> before,
                 std::span<const Eigen::Vector3d> after) {
  const auto sound = [](std::span<const Eigen::Vector3d> x, const std::array<Index, n>& cell) {
    if constexpr (HasCellShape<E>)
      return is_sound<E::shape>(cell, corners_of(x, cell));
    else
      return true;
  };
  for (std::size_t e = 0; e < part.cells.size(); ++e)
    if (!sound(after, part.cells[e]) && sound(before, part.cells[e]))
      throw Error(joined({"strike: where nothing overlaps, element ", std::to_string(e), " of part ",
                          std::to_string(number), " at ", text(centroid<n>(before, part.cells[e])),
                          " would be inside out, for its nodes are too deep in what they may touch; move the meshes "
                          "apart, or leave them as they are without pushed_apart."}));
}

}  // namespace detail

/// The scene with its nodes moved to where nothing overlaps that its contacts may touch, before the run, without strain
/// or energy: their positions are those of bodies at rest. Both sides of an overlap move along its normal, each node
/// against its mass, and not where conditions hold it. It has a further item at the end, the PushedApart. Errors:
/// conditions hold both sides of an overlap; a cell would be inside out; some overlap is left.
///   Explicit run{pushed_apart(Scene{nodes, part, Contact{Everything{}}})};
template <class... Items>
Scene<Items..., PushedApart> pushed_apart(const Scene<Items...>& scene) {
  std::vector<Eigen::Vector3d> moved = scene.nodes;
  PushedApart report;
  if constexpr (Scene<Items...>::sound) {
    moved = detail::MovedApart<Items...>(scene).positions();
    std::vector<double> ways;
    for (std::size_t i = 0; i < moved.size(); ++i) ways.push_back((moved[i] - scene.nodes[i]).norm());
    const auto farthest = std::max_element(ways.begin(), ways.end());
    report.farthest = static_cast<Index>(farthest - ways.begin()), report.way = *farthest;
    report.moved = static_cast<std::size_t>(
        std::count_if(ways.begin(), ways.end(), [&](double way) { return way > 1e-6 * report.way; }));
    std::size_t number = 0;
    detail::each_item(scene.items, [&](const auto& item) {
      if constexpr (detail::is_part<std::remove_cvref_t<decltype(item)>>)
        detail::check_moved(item, number++, scene.nodes, moved);
    });
  }
  return std::apply(
      [&](const Items&... items) { return Scene<Items..., PushedApart>(std::move(moved), items..., report); },
      scene.items);
}

}  // namespace strike
