#pragma once
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// A pressure p(t) on faces, along their current normals: each corner takes an equal share of -p times the vector area,
/// so that the resultant is exact on any face. Error: no such node.
template <class History>
class Pressure {
 public:
  using LoadHistory = History;

  Pressure(std::vector<Face> faces, History history) : faces_(std::move(faces)), history_(std::move(history)) {}

  template <class N>
  void begin(const N& nodes) const {
    for (const Face& face : faces_)
      for (const Index i : face.nodes) nodes.check_number(i);
  }
  template <class N>
  void apply_loads(N& nodes, double time) {
    const double p = history_(time);
    forces_.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto& corner = faces_[i].nodes;
      const auto x = [&](std::size_t k) { return nodes.x(corner[k]); };
      const typename N::Vector along = x(2) - x(0), across = x(3) - x(1);
      const double share = corner[2] == corner[3] ? 1.0 / 3 : 0.25;
      const typename N::Vector force = -share * p * 0.5 * cross<typename N::Number>(along, across);
      for (std::size_t k = 0; k < corners(corner); ++k) nodes.add_force(corner[k], force);
      forces_[i] = force.template cast<double>();
    }
  }
  template <class N>
  double power(const N& nodes) const {
    double sum = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (std::size_t k = 0; k < corners(faces_[i].nodes); ++k)
        sum += forces_[i].dot(nodes.v(faces_[i].nodes[k]).template cast<double>());
    return sum;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    for (const Face& face : faces_) archive.same(face.nodes);
    archive(forces_);
  }

 private:
  static std::size_t corners(const std::array<Index, 4>& corner) { return corner[2] == corner[3] ? 3 : 4; }

  std::vector<Face> faces_;
  History history_;
  std::vector<Eigen::Vector3d> forces_;  // on each corner of each face, as applied last
};

}  // namespace strike
