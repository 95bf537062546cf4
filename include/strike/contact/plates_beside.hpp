#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/scalar/math.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Plates whose middle is beside their nodes, by their Offset, some of which are in a list of nodes.
class PlatesBeside {
 public:
  static constexpr Index none = std::numeric_limits<Index>::max();

  /// Adds those of a part; `entry_of(number)` is the place of a node in the list, or none.
  template <class EntryOf>
  void add(std::size_t part, const PartFaces& plates, const EntryOf& entry_of) {
    if (plates.offset == 0) return;
    for (const Face& face : plates.faces) {
      Plate plate{face.nodes, {}, plates.offset, part, face.cell};
      for (std::size_t k = 0; k < 4; ++k) plate.entries[k] = entry_of(face.nodes[k]);
      if (std::any_of(plate.entries.begin(), plate.entries.end(), [](Index entry) { return entry != none; }))
        plates_.push_back(plate);
    }
  }
  bool empty() const { return plates_.empty(); }
  /// The numbers of all their nodes.
  std::vector<Index> nodes_named() const {
    std::vector<Index> all;
    for (const Plate& plate : plates_) all.insert(all.end(), plate.nodes.begin(), plate.nodes.end());
    return all;
  }
  /// Plates that are not alive no longer shift their nodes.
  void remove(std::size_t part, const std::vector<bool>& alive) {
    std::erase_if(plates_, [&](const Plate& plate) { return plate.part == part && !alive.at(plate.cell); });
  }

  /// From the nodes of the list, which has a `size`, to the middle of their plates: the mean offset along the normals
  /// of those around, zero of other nodes [length].
  template <class N>
  std::vector<typename N::Vector> ways(const N& nodes, std::size_t size) const {
    using Number = typename N::Number;
    using Vector = typename N::Vector;
    std::vector<Vector> sum(size, Vector::Zero());
    std::vector<int> plates(size, 0);
    for (const Plate& plate : plates_) {
      const auto at = [&](std::size_t k) { return nodes.x(plate.nodes[k]); };
      const Vector area = cross<Number>(at(2) - at(0), at(3) - at(1));
      const Number squared = area.dot(area);
      const Vector along = squared > 0 ? Vector((plate.offset / sqrt(squared)) * area) : Vector(Vector::Zero());
      for (const Index i : plate.entries)
        if (i != none) sum[i] += along, ++plates[i];
    }
    for (std::size_t i = 0; i < size; ++i)
      if (plates[i] > 0) sum[i] = (1.0 / plates[i]) * sum[i];
    return sum;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(plates_);
  }

 private:
  struct Plate {
    std::array<Index, 4> nodes, entries;  // their numbers, and places in the list, or none
    double offset;                        // [length]
    std::size_t part;
    Index cell;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(nodes, entries, offset, part, cell);
    }
  };

  std::vector<Plate> plates_;
};

}  // namespace strike::detail
