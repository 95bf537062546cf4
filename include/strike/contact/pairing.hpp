#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/contact/approach.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/contact/surface.hpp>
#include <strike/contact/target.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/motion/step.hpp>

namespace strike {

namespace detail {

inline std::vector<Index> ascending(std::vector<Index> a, const std::vector<Index>& b = {}) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}
inline std::vector<Index> to_local(std::vector<Index> numbers, const ContactNodes& all) {
  for (Index& i : numbers) i = all.local(i);
  return numbers;
}
inline Target target_of(const std::vector<Face>& faces, const ContactNodes& all) {
  std::vector<std::array<Index, 4>> corners;
  for (const Face& face : faces) {
    corners.push_back(face.nodes);
    for (Index& i : corners.back()) i = all.local(i);
  }
  return {std::move(corners), all.size()};
}

/// Nodes on their way to surfaces, one or two ways.
template <bool self>
class SurfaceMeeting {
 public:
  explicit SurfaceMeeting(std::vector<Surface> surfaces) : surfaces_(std::move(surfaces)) {}

  /// The nodes `numbers`, or if there are none those of the surface `from`, touch the surface `target`.
  void add(std::vector<Index> numbers, std::size_t from, std::size_t target, double thickness,
           const ContactNodes& all) {
    const Surface& other = surfaces_[target];
    const bool fixed = !numbers.empty();
    if (!fixed) numbers = surface_nodes(surfaces_[from].faces());
    ways_.push_back({numbers, fixed, from, target});
    approaches_.push_back(Approach<self>(to_local(numbers, all), target_of(other.faces(), all),
                                         0.5 * (thickness + other.thickness()), other.thickness() > 0));
  }

  void begin(const ContactNodes& all, Beginners& beginners) {
    for (auto& approach : approaches_) approach.begin(all, beginners);
  }
  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    for (auto& approach : approaches_) approach.find(all, step, pairs);
  }
  void moved(const ContactNodes& all, double dt) {
    for (auto& approach : approaches_) approach.moved(all, dt);
  }
  double largest_inverse_mass() const {
    double most = 0;
    for (const auto& approach : approaches_) most = std::max(most, approach.largest_inverse_mass());
    return most;
  }
  std::size_t sorts() const {
    std::size_t sum = 0;
    for (const auto& approach : approaches_) sum += approach.sorts();
    return sum;
  }

  /// Whether a surface has lost cells. Nodes that come to its outside touch from now on, and those that have lost all
  /// their cells still do.
  bool remove(std::size_t part, const std::vector<bool>& alive, const ContactNodes& all) {
    std::vector<bool> changed;
    for (Surface& surface : surfaces_) changed.push_back(surface.remove(part, alive));
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      auto& [numbers, fixed, from, target] = ways_[k];
      if (!changed[from] && !changed[target]) continue;
      if (!fixed) numbers = ascending(std::move(numbers), surface_nodes(surfaces_[from].faces()));
      approaches_[k].forget(to_local(numbers, all), target_of(surfaces_[target].faces(), all));
    }
    return std::find(changed.begin(), changed.end(), true) != changed.end();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(std::span(surfaces_), std::span(ways_), std::span(approaches_));
  }

 private:
  struct Way {
    std::vector<Index> nodes;
    bool fixed;
    std::size_t from, target;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(nodes);
    }
  };

  std::vector<Surface> surfaces_;
  std::vector<Way> ways_;
  std::vector<Approach<self>> approaches_;
};

}  // namespace detail

// Who may touch whom. A pairing knows its `numbers()`, the nodes that it is about, and its `first()`, those on which
// forces are told; `start(nodes)` puts it to work.

/// Nodes that may touch a surface: those of the finer or softer of two bodies, or of a bird. `thickness` is that of the
/// plate that they belong to, if any [length].
struct NodeToSurface {
  std::vector<Index> nodes;
  Surface surface;
  double thickness = 0;

  std::vector<Index> numbers() const { return detail::ascending(nodes, surface.nodes()); }
  const std::vector<Index>& first() const { return nodes; }
  detail::SurfaceMeeting<false> start(const ContactNodes& all) const {
    if (nodes.empty()) throw Error("strike: a NodeToSurface has no nodes; give it some, such as surface_nodes(faces).");
    detail::SurfaceMeeting<false> meeting({surface});
    meeting.add(detail::ascending(nodes), 0, 0, thickness, all);
    return meeting;
  }
};

/// Two surfaces each of whose nodes may touch the other: the nodes of the first go before those of the second.
struct TwoWay {
  Surface first_surface, second_surface;

  std::vector<Index> numbers() const { return detail::ascending(first_surface.nodes(), second_surface.nodes()); }
  std::vector<Index> first() const { return first_surface.nodes(); }
  detail::SurfaceMeeting<false> start(const ContactNodes& all) const {
    detail::SurfaceMeeting<false> meeting({first_surface, second_surface});
    meeting.add({}, 0, 1, first_surface.thickness(), all);
    meeting.add({}, 1, 0, second_surface.thickness(), all);
    return meeting;
  }
};

/// A surface that may touch itself: one that folds, or several bodies in one. What of a plate lies within a thickness
/// of a node at the start never touches it.
struct SelfContact {
  Surface surface;

  std::vector<Index> numbers() const { return surface.nodes(); }
  std::vector<Index> first() const { return surface.nodes(); }
  detail::SurfaceMeeting<true> start(const ContactNodes& all) const {
    detail::SurfaceMeeting<true> meeting({surface});
    meeting.add({}, 0, 0, surface.thickness(), all);
    return meeting;
  }
};

/// Nodes that may touch a rigid body: a RigidPlane, RigidSphere, RigidCylinder, RigidSurface or your own RigidBody.
template <class Body>
struct NodeToRigid {
  std::vector<Index> nodes;
  Body body;
  double thickness = 0;  ///< of the plate that the nodes belong to [length]

  std::vector<Index> numbers() const { return detail::ascending(nodes); }
  const std::vector<Index>& first() const { return nodes; }
  auto start(const ContactNodes& all) const
    requires RigidBody<Body>
  {
    return detail::RigidApproach<Body>{detail::to_local(numbers(), all), body, 0.5 * thickness};
  }
};
template <>
struct NodeToRigid<RigidSurface> {
  std::vector<Index> nodes;
  RigidSurface body;
  double thickness = 0;

  std::vector<Index> numbers() const { return detail::ascending(nodes); }
  const std::vector<Index>& first() const { return nodes; }
  const std::vector<Eigen::Vector3d>& points() const { return body.points; }
  detail::Approach<false> start(const ContactNodes& all) const {
    std::vector<std::array<Index, 4>> faces;
    for (const Face& face : body.faces) {
      faces.push_back(face.nodes);
      for (Index& i : faces.back()) {
        if (i >= body.points.size())
          throw Error(detail::joined({"strike: a face of a RigidSurface names point ", std::to_string(i),
                                      ", but there are ", std::to_string(body.points.size()), "; count them from 0."}));
        i += all.first_point();
      }
    }
    if (faces.empty()) throw Error("strike: a RigidSurface has no faces; give it some.");
    return {detail::to_local(numbers(), all), {std::move(faces), all.size()}, 0.5 * thickness, false};
  }
};
template <class Body>
NodeToRigid(std::vector<Index>, Body) -> NodeToRigid<Body>;
template <class Body>
NodeToRigid(std::vector<Index>, Body, double) -> NodeToRigid<Body>;

}  // namespace strike
