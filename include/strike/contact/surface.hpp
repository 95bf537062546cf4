#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/text.hpp>

namespace strike {

/// Faces of a contact. Without a thickness they bound a solid and are touched from outside, the side from which their
/// corners run counter-clockwise; with one they are the middle surface of a plate, touched from both sides half a
/// thickness away.
///   Surface{surface(mesh)}                 Surface{quadrilateral_surface(mesh.quadrilaterals), 2e-3}
/// Of a part that may lose cells, by its place among the parts:
///   solid_surface(mesh.hexahedra, 0)       plate_surface(mesh.quadrilaterals, 2e-3, 1)
class Surface {
 public:
  /// `thickness` of the plate [length]. Errors: no face; a negative thickness.
  explicit Surface(std::vector<Face> faces, double thickness = 0) : faces_(std::move(faces)), thickness_(thickness) {
    if (faces_.empty())
      throw Error("strike: a Surface has no faces; give it some, such as surface(mesh) or solid_surface(cells, part).");
    if (!(thickness >= 0))
      throw Error(detail::joined({"strike: a Surface has the thickness ", detail::text(thickness),
                                  "; give that of the plate, or none if the faces bound a solid."}));
  }

  const std::vector<Face>& faces() const { return faces_; }
  double thickness() const { return thickness_; }

  /// True of the cells of a part, which may be deleted.
  bool is_of(std::size_t part) const { return part_ == part; }

  /// Numbers of the nodes that are on the surface or may become so when cells are removed, in ascending order.
  std::vector<Index> nodes() const { return surface_nodes(of_cells_.empty() ? faces_ : of_cells_); }

  /// Error: it is of a part that the scene does not have, or of other cells than the elements of its part.
  void check_part(const std::vector<std::size_t>& elements) const {
    if (!part_) return;
    if (*part_ >= elements.size())
      throw Error(detail::joined({"strike: a Surface is of part ", std::to_string(*part_), ", but the scene has ",
                                  std::to_string(elements.size()), elements.size() == 1 ? " part" : " parts",
                                  "; count its parts from 0."}));
    if (cells_ != elements[*part_])
      throw Error(detail::joined({"strike: a Surface of part ", std::to_string(*part_), " was made of ",
                                  std::to_string(cells_), " cells, but the part has ", std::to_string(elements[*part_]),
                                  "; give it the cells of the part and its place."}));
  }

  /// Removes the cells of a part that are not alive and their faces; the faces that they covered are outside from now
  /// on. Returns true if the surface has changed. Linear in the cells of the part. Error: fewer flags than cells.
  bool remove(std::size_t part, const std::vector<bool>& alive) {
    if (part_ != part) return false;
    const auto is_gone = [&](const Face& face) {
      if (face.cell >= alive.size())
        throw Error(detail::joined({"strike: the cells of part ", std::to_string(part), " have ",
                                    std::to_string(alive.size()), " flags, but one of them is cell ",
                                    std::to_string(face.cell), "; give one flag for each."}));
      return !alive[face.cell];
    };
    const auto gone = std::remove_if(of_cells_.begin(), of_cells_.end(), is_gone);
    if (gone == of_cells_.end()) return false;
    of_cells_.erase(gone, of_cells_.end());
    faces_ = thickness_ > 0 ? of_cells_ : detail::unshared(of_cells_);
    return true;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(faces_, of_cells_);
  }

 private:
  friend Surface solid_surface(const Cells<8>&, std::size_t);
  friend Surface solid_surface(const Cells<4>&, std::size_t);
  friend Surface plate_surface(const Cells<4>&, double, std::size_t);

  /// `of_cells` are all faces of all cells, inner ones too.
  Surface(std::vector<Face> faces, std::vector<Face> of_cells, std::size_t cells, double thickness, std::size_t part)
      : Surface(std::move(faces), thickness) {
    of_cells_ = std::move(of_cells), cells_ = cells, part_ = part;
  }

  std::vector<Face> faces_, of_cells_;
  double thickness_;
  std::size_t cells_ = 0;  ///< number of the cells that it was made of
  std::optional<std::size_t> part_;
};

/// The outside of the hexahedra of a part, by its place among the parts of the scene.
inline Surface solid_surface(const Cells<8>& cells, std::size_t part) {
  std::vector<Face> all;
  detail::append_faces(all, cells, detail::hexahedron_faces, 0);
  return {detail::unshared(all), all, cells.size(), 0, part};
}
/// The outside of the tetrahedra of a part.
inline Surface solid_surface(const Cells<4>& cells, std::size_t part) {
  std::vector<Face> all;
  detail::append_faces(all, cells, detail::tetrahedron_faces, 0);
  return {detail::unshared(all), all, cells.size(), 0, part};
}
/// The middle surface of the plates of a part, of that thickness [length].
inline Surface plate_surface(const Cells<4>& cells, double thickness, std::size_t part) {
  return {quadrilateral_surface(cells), quadrilateral_surface(cells), cells.size(), thickness, part};
}

}  // namespace strike
