#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

/// Faces of a contact. Without a thickness they bound a solid and are touched from outside, the side from which their
/// corners run counter-clockwise; with one they are the middle surface of a plate, touched from both sides half a
/// thickness away.
///   Surface{surface(mesh)}                 Surface{quadrilateral_surface(mesh.quadrilaterals), 2e-3}
/// Of a part that may lose cells, by its place among the parts:
///   solid_surface(mesh.hexahedra, 0)       plate_surface(mesh.quadrilaterals, 2e-3, 1)
/// Surfaces of several parts are one by `+`, such as that of a frame and its pane: faces that cells of two solids share
/// are inside then, and where plates of two thicknesses meet, their nodes have the mean.
class Surface {
 public:
  /// Faces of one thickness: of a part, or as the user gave them.
  struct Piece {
    std::vector<Face> faces{};
    double thickness = 0;  ///< of plates, 0 of solids [length]
    std::optional<std::size_t> part{};
    std::size_t cells = 0;         ///< number of the cells that it was made of
    bool erodes = false;           ///< its cells may be deleted
    std::vector<Face> of_cells{};  ///< all faces of those, inner ones too

    template <class Archive>
    void serialize(Archive& archive) {
      archive.same(thickness, cells, erodes);
      archive(faces, of_cells);
    }
  };

  /// `thickness` of the plate [length]. Errors: no face; a negative thickness.
  explicit Surface(std::vector<Face> faces, double thickness = 0)
      : Surface(Piece{.faces = std::move(faces), .thickness = thickness}) {}
  explicit Surface(Piece piece) : Surface(std::vector<Piece>{std::move(piece)}) {}
  /// Errors: no face; a negative thickness.
  explicit Surface(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
    uncover();
    detail::check_ranges(*this);
    for (const Piece& piece : pieces_)
      if (piece.faces.empty() && piece.of_cells.empty())
        throw Error(
            "strike: a Surface has no faces; give it some, such as surface(mesh) or solid_surface(cells, part).");
  }

  void ranges(const auto& number) const {
    for (const Piece& piece : pieces_) number("thickness", piece.thickness, range::not_negative);
  }

  friend Surface operator+(Surface one, const Surface& other) {
    const auto before = static_cast<Index>(one.pieces_.size());
    for (const auto& [p, q] : other.apart_) one.apart_.push_back({p + before, q + before});
    one.pieces_.insert(one.pieces_.end(), other.pieces_.begin(), other.pieces_.end());
    one.uncover();
    return one;
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Pairs of pieces, by their places, that do not touch each other when the surface is in contact with itself.
  const std::vector<std::array<Index, 2>>& apart() const { return apart_; }
  void keep_apart(Index piece, Index other) { apart_.push_back({piece, other}); }
  std::vector<Face> faces() const {
    std::vector<Face> all;
    for (const Piece& piece : pieces_) all.insert(all.end(), piece.faces.begin(), piece.faces.end());
    return all;
  }

  /// True of the cells of a part, which may be deleted.
  bool is_of(std::size_t part) const {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return piece.part == part; });
  }

  /// Numbers of the nodes that are on the surface or may become so when cells are removed, in ascending order.
  std::vector<Index> nodes() const {
    std::vector<Index> all;
    for (const Piece& piece : pieces_)
      all = detail::ascending(std::move(all), surface_nodes(piece.erodes ? piece.of_cells : piece.faces));
    return all;
  }

  /// Error: it is of a part that the scene does not have, or of other cells than the elements of its part.
  void check_parts(std::span<const PartFaces> parts) const {
    for (const Piece& piece : pieces_) {
      if (!piece.part) continue;
      if (*piece.part >= parts.size())
        throw Error(detail::joined({"strike: a Surface is of part ", std::to_string(*piece.part),
                                    ", but the scene has ", std::to_string(parts.size()),
                                    parts.size() == 1 ? " part" : " parts", "; count its parts from 0."}));
      if (const std::size_t elements = parts[*piece.part].cells; piece.cells != elements)
        throw Error(detail::joined({"strike: a Surface of part ", std::to_string(*piece.part), " was made of ",
                                    std::to_string(piece.cells), " cells, but the part has ", std::to_string(elements),
                                    "; give it the cells of the part and its place."}));
    }
  }

  /// Forgets the cells of a part, none of which will be deleted.
  void settle(std::size_t part) {
    for (Piece& piece : pieces_)
      if (piece.part == part) piece.erodes = false, piece.of_cells = {};
  }
  /// Forgets the faces between cells of solid parts that never erode, by their places: none will come to the outside.
  template <class NeverErodes>
  void settle_inside(const NeverErodes& never_erodes) {
    const auto is_settled = [&](const Piece& piece) { return !(piece.thickness > 0) && never_erodes(*piece.part); };
    std::vector<Face> solid;
    for (const Piece& piece : pieces_)
      if (is_settled(piece)) solid.insert(solid.end(), piece.of_cells.begin(), piece.of_cells.end());
    std::vector<char> stays(solid.size(), false);
    for (const std::size_t k : detail::places_of_unshared(solid)) stays[k] = true;
    std::size_t k = 0;
    for (Piece& piece : pieces_)
      if (is_settled(piece)) std::erase_if(piece.of_cells, [&](const Face&) { return !stays[k++]; });
  }
  /// Removes the cells of a part that are not alive and their faces; the faces that they covered are outside from now
  /// on. Returns true if the surface has changed. Linear in the cells of the part. Error: fewer flags than cells.
  bool remove(std::size_t part, const std::vector<bool>& alive) {
    bool changed = false;
    for (Piece& piece : pieces_) {
      if (piece.part != part) continue;
      const auto is_gone = [&](const Face& face) {
        if (face.cell >= alive.size())
          throw Error(detail::joined({"strike: the cells of part ", std::to_string(part), " have ",
                                      std::to_string(alive.size()), " flags, but one of them is cell ",
                                      std::to_string(face.cell), "; give one flag for each."}));
        return !alive[face.cell];
      };
      changed = std::erase_if(piece.of_cells, is_gone) > 0 || changed;
    }
    if (changed) uncover();
    return changed;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(std::span(pieces_));
  }

 private:
  /// Finds the faces of cells that are outside: all of plates, and those of solids that no two cells share.
  void uncover() {
    std::vector<Face> solid;
    std::vector<Piece*> of;
    for (Piece& piece : pieces_) {
      if (!piece.erodes) continue;
      const bool is_plate = piece.thickness > 0;
      piece.faces = is_plate ? piece.of_cells : std::vector<Face>{};
      if (is_plate) continue;
      solid.insert(solid.end(), piece.of_cells.begin(), piece.of_cells.end());
      of.insert(of.end(), piece.of_cells.size(), &piece);
    }
    for (const std::size_t k : detail::places_of_unshared(solid)) of[k]->faces.push_back(solid[k]);
  }

  std::vector<Piece> pieces_;
  std::vector<std::array<Index, 2>> apart_;
};

/// The outside of the hexahedra of a part, by its place among the parts of the scene.
inline Surface solid_surface(const Cells<8>& cells, std::size_t part) {
  std::vector<Face> all;
  detail::append_faces(all, cells, detail::hexahedron_faces, 0);
  return Surface({.part = part, .cells = cells.size(), .erodes = true, .of_cells = std::move(all)});
}
/// The outside of the tetrahedra of a part.
inline Surface solid_surface(const Cells<4>& cells, std::size_t part) {
  std::vector<Face> all;
  detail::append_faces(all, cells, detail::tetrahedron_faces, 0);
  return Surface({.part = part, .cells = cells.size(), .erodes = true, .of_cells = std::move(all)});
}
/// The middle surface of the plates of a part, of that thickness [length].
inline Surface plate_surface(const Cells<4>& cells, double thickness, std::size_t part) {
  return Surface({.thickness = thickness,
                  .part = part,
                  .cells = cells.size(),
                  .erodes = true,
                  .of_cells = quadrilateral_surface(cells)});
}
inline Surface plate_surface(const Cells<3>& cells, double thickness, std::size_t part) {
  return Surface({.thickness = thickness,
                  .part = part,
                  .cells = cells.size(),
                  .erodes = true,
                  .of_cells = triangle_surface(cells)});
}

}  // namespace strike
