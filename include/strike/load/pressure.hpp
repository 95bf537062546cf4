#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/load/loaded_faces.hpp>

namespace strike {

/// A pressure p(t) on faces, along their current normals: each corner takes an equal share of -p times the vector area,
/// so that the resultant is exact on any face. It ends with the elements that have the face, which are found by its
/// corners. Error: no such node.
template <class History>
class Pressure {
 public:
  using LoadHistory = History;

  Pressure(std::vector<Face> faces, History history) : faces_(std::move(faces)), history_(std::move(history)) {}

  void ranges(const auto& number) const { number(history_); }

  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts = {}) {
    faces_.begin(nodes, parts);
  }
  std::vector<Index> nodes_named() const { return faces_.nodes_named(); }

  template <class N>
  void apply_loads(N& nodes, double time) {
    faces_.apply(nodes, [p = double(history_(time))](std::size_t, const typename N::Vector&) { return p; });
  }
  template <class N>
  double power(const N& nodes) const {
    return faces_.power(nodes);
  }
  /// Ends on the faces all of whose elements are gone.
  void remove(std::size_t part, const std::vector<bool>& alive) { faces_.remove(part, alive); }

  template <class Archive>
  void serialize(Archive& archive) {
    faces_.serialize(archive);
  }

 private:
  detail::LoadedFaces faces_;
  History history_;
};

}  // namespace strike
