#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <strike/mesh/part_faces.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Faces that a load presses on along their current normals: each corner takes an equal share of -p times the vector
/// area, so that the resultant is exact on any face. A face ends with the elements that have it, which are found by its
/// corners.
class LoadedFaces {
 public:
  explicit LoadedFaces(std::vector<Face> faces) : faces_(std::move(faces)) {}

  std::size_t size() const { return faces_.size(); }
  std::vector<Index> nodes_named() const { return surface_nodes(faces_); }
  const Face& operator[](std::size_t i) const { return faces_[i]; }

  /// Error: no such node.
  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts) {
    for (const Face& face : faces_)
      for (const Index i : face.nodes) nodes.check_number(i);
    ended_.assign(faces_.size(), 0);
    if (std::any_of(parts.begin(), parts.end(), [](const PartFaces& part) { return part.erodes; })) find_owners(parts);
  }
  /// `pressure(i, normal)` is that on face i, whose normal is twice its vector area.
  template <class N, class F>
  void apply(N& nodes, const F& pressure) {
    using Vector = typename N::Vector;
    forces_.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (has_ended(i)) {
        forces_[i].setZero();
        continue;
      }
      const auto& corner = faces_[i].nodes;
      const auto x = [&](std::size_t k) { return nodes.x(corner[k]); };
      const Vector along = x(2) - x(0), across = x(3) - x(1), normal = cross<typename N::Number>(along, across);
      const double share = corner[2] == corner[3] ? 1.0 / 3 : 0.25;
      const Vector force = -share * pressure(i, normal) * 0.5 * normal;
      for (std::size_t k = 0; k < corners(corner); ++k) nodes.add_force(corner[k], force);
      forces_[i] = force.template cast<double>();
    }
  }
  /// Power of the forces as applied last.
  template <class N>
  double power(const N& nodes) const {
    double sum = 0;
    for (std::size_t i = 0; i < forces_.size(); ++i)
      for (std::size_t k = 0; k < corners(faces_[i].nodes); ++k)
        sum += forces_[i].dot(nodes.v(faces_[i].nodes[k]).template cast<double>());
    return sum;
  }
  /// Ends on the faces all of whose elements are gone.
  void remove(std::size_t part, const std::vector<bool>& alive) {
    std::vector<char> left(faces_.size(), 0);
    for (Owner& owner : owners_) {
      if (owner.part == part && !alive.at(owner.cell)) owner.is_gone = true;
      if (!owner.is_gone) left[owner.face] = 1;
    }
    for (const Owner& owner : owners_) ended_[owner.face] = !left[owner.face];
  }

  template <class Archive>
  void serialize(Archive& archive) {
    for (const Face& face : faces_) archive.same(face.nodes);
    archive(forces_, owners_, ended_);
  }

 private:
  /// An element that has a face.
  struct Owner {
    std::size_t face, part, cell;
    bool is_gone = false;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(face, part, cell, is_gone);
    }
  };

  static std::size_t corners(const std::array<Index, 4>& corner) { return corner[2] == corner[3] ? 3 : 4; }
  bool has_ended(std::size_t face) const { return face < ended_.size() && ended_[face]; }

  void find_owners(std::span<const PartFaces> parts) {
    using Key = std::array<Index, 4>;
    const auto key_of = [](const Face& face) {
      Key key = face.nodes;
      std::sort(key.begin(), key.end());
      if (face.is_triangle()) std::fill(std::unique(key.begin(), key.end()), key.end(), key.back());
      return key;
    };
    std::vector<std::pair<Key, std::size_t>> keys;
    for (std::size_t i = 0; i < faces_.size(); ++i) keys.emplace_back(key_of(faces_[i]), i);
    std::sort(keys.begin(), keys.end());
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const Face& face : parts[p].faces) {
        const Key key = key_of(face);
        for (auto at = std::lower_bound(keys.begin(), keys.end(), std::pair{key, std::size_t{0}});
             at != keys.end() && at->first == key; ++at)
          owners_.push_back({at->second, p, face.cell});
      }
  }

  std::vector<Face> faces_;
  std::vector<Eigen::Vector3d> forces_;  // on each corner of each face, as applied last
  std::vector<Owner> owners_;
  std::vector<char> ended_;  // of each face
};

}  // namespace strike::detail
