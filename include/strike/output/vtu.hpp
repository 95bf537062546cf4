#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/element/element.hpp>
#include <strike/error.hpp>
#include <strike/material/kinematics.hpp>
#include <strike/material/point_values.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/output/field.hpp>
#include <strike/output/file.hpp>
#include <strike/output/xml.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {
namespace detail {

/// Appends bytes in base64 (RFC 4648).
inline void append_base64(std::string& text, std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += digits[three >> 18];
    text += digits[three >> 12 & 63];
    text += i + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? digits[three & 63] : '=';
  }
}

/// A DataArray of a VTK XML file: the size in 8 bytes, then the numbers, in base64.
template <class Number>
class DataArray {
 public:
  void push_back(Number number) {
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    bytes_.append(bytes, sizeof number);
  }

  [[gnu::cold]] void write(Xml& xml, std::string_view name, std::size_t components = 1) const {
    constexpr std::string_view kind = std::is_floating_point_v<Number> ? "Float"
                                      : std::is_signed_v<Number>       ? "Int"
                                                                       : "UInt";
    const std::uint64_t count = bytes_.size();
    std::string block(sizeof count, '\0'), text;
    std::memcpy(block.data(), &count, sizeof count);
    append_base64(text, block += bytes_);
    xml.element("DataArray",
                {{"type", joined({kind, std::to_string(8 * sizeof(Number))})},
                 {"Name", name},
                 {"NumberOfComponents", components},
                 {"NumberOfTuples", count / (sizeof(Number) * components)},
                 {"format", "binary"}},
                text);
  }

 private:
  std::string bytes_;
};

[[gnu::cold]] inline void write_rows(Xml& xml, std::string_view name, const Rows& rows) {
  DataArray<double> data;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const double number : rows[i]) data.push_back(number);
  data.write(xml, name, rows.components());
}
[[gnu::cold]] inline void write_fields(Xml& xml, const std::vector<Field>& fields, std::size_t count,
                                       std::string_view of_what) {
  std::vector<std::string_view> names;
  for (const Field& field : fields) names.push_back(field.name);
  std::sort(names.begin(), names.end());
  if (!names.empty() && names.front().empty())
    throw Error(joined({"strike: a field by ", of_what, " has no name: give it one."}));
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    throw Error(
        joined({"strike: two fields by ", of_what, " are called '", *twice, "': give each a name of its own."}));
  for (const Field& field : fields) {
    if (field.rows.size() != count)
      throw Error(joined({"strike: the field '", field.name, "' has ", std::to_string(field.rows.size()), " rows for ",
                          std::to_string(count), " ", of_what, ": give one row for each."}));
    write_rows(xml, field.name, field.rows);
  }
}

/// Cells of a VTU file.
class VtuCells {
 public:
  /// VTK's number of the kind of a cell with n corners, whose order is that of VTK. A cell without a kind of its own is
  /// drawn as its nodes.
  static constexpr std::uint8_t kind(std::size_t n, bool solid) {
    switch (n) {
      case 1:
        return 1;  // VTK_VERTEX
      case 2:
        return 3;  // VTK_LINE
      case 3:
        return 5;  // VTK_TRIANGLE
      case 4:
        return solid ? 10 : 9;  // VTK_TETRA, VTK_QUAD
      case 5:
        if (solid) return 14;  // VTK_PYRAMID
        break;
      case 6:
        if (solid) return 13;  // VTK_WEDGE
        break;
      case 8:
        if (solid) return 12;  // VTK_HEXAHEDRON
        break;
    }
    return 2;  // VTK_POLY_VERTEX
  }
  /// Of a degenerate hexahedron the wedge or pyramid. VTK's wedge has the two triangles the other way round: the normal
  /// of its first looks away from its second.
  void add_hexahedron(const std::array<Index, 8>& cell) {
    const DegenerateHexahedron degenerate(cell);
    const auto c = in_order(cell, degenerate.order);
    if (degenerate.kind == HexahedronKind::wedge)
      add(std::array{c[0], c[2], c[1], c[4], c[6], c[5]}, kind(6, true));
    else if (degenerate.kind == HexahedronKind::pyramid)
      add(std::array{c[0], c[1], c[2], c[3], c[4]}, kind(5, true));
    else
      add(cell, kind(8, true));
  }
  /// The cells of a mesh: hexahedra, tetrahedra, quadrilaterals, triangles, particles.
  void add(const Mesh& mesh) {
    for (const auto& cell : mesh.hexahedra) add_hexahedron(cell);
    for (const auto& cell : mesh.tetrahedra) add(cell, kind(4, true));
    for (const auto& cell : mesh.quadrilaterals) add(cell, kind(4, false));
    for (const auto& cell : mesh.triangles) add(cell, kind(3, false));
    for (const auto& cell : mesh.particles) add(cell, kind(1, false));
  }
  template <class Cell>
  void add(const Cell& cell, std::uint8_t kind) {
    for (const Index node : cell) {
      connectivity_.push_back(node);
      if (node >= nodes_) nodes_ = std::size_t(node) + 1, cell_of_last_ = size();
    }
    sizes_.push_back(static_cast<std::uint8_t>(cell.size()));
    kinds_.push_back(kind);
  }
  std::size_t size() const { return sizes_.size(); }
  /// Error: a cell names a node that is not among so many.
  [[gnu::cold]] void check_nodes(std::size_t count, const std::string& path) const {
    if (nodes_ > count)
      throw Error(joined({"strike: the VTU file '", path, "' has ", std::to_string(count), " nodes, but cell ",
                          std::to_string(cell_of_last_), " names node ", std::to_string(nodes_ - 1),
                          ": give nodes below ", std::to_string(count), "."}));
  }
  /// In 32 bits as far as these hold the numbers, or in 64.
  void write(Xml& xml, std::size_t most = std::numeric_limits<std::int32_t>::max()) const {
    if (connectivity_.size() <= most && nodes_ <= most)
      write_as<std::int32_t>(xml);
    else
      write_as<std::int64_t>(xml);
  }

 private:
  template <class Number>
  void write_as(Xml& xml) const {
    DataArray<Number> connectivity, offsets;
    for (const Index node : connectivity_) connectivity.push_back(static_cast<Number>(node));
    Number offset = 0;
    for (const std::uint8_t corners : sizes_) offsets.push_back(offset = static_cast<Number>(offset + corners));
    DataArray<std::uint8_t> kinds;
    for (const std::uint8_t kind : kinds_) kinds.push_back(kind);
    connectivity.write(xml, "connectivity");
    offsets.write(xml, "offsets");
    kinds.write(xml, "types");
  }

  std::vector<Index> connectivity_;
  std::vector<std::uint8_t> sizes_, kinds_;
  std::size_t nodes_ = 0, cell_of_last_ = 0;  ///< one more than the largest node, and its cell
};

[[gnu::cold]] inline void write_vtu(const std::string& path, double time, const Rows& positions, const VtuCells& cells,
                                    const std::vector<Field>& node_fields, const std::vector<Field>& cell_fields) {
  RangeCheck("write_vtu", "")("time", time, range::finite);
  const std::size_t nodes = positions.size();
  cells.check_nodes(nodes, path);
  DataArray<double> time_value;
  time_value.push_back(time);

  Xml xml;
  xml.raw("<?xml version=\"1.0\"?>\n");
  xml.open("VTKFile", {{"type", "UnstructuredGrid"},
                       {"version", "1.0"},
                       {"byte_order", std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"},
                       {"header_type", "UInt64"}});
  xml.open("UnstructuredGrid");
  xml.open("FieldData");
  time_value.write(xml, "TimeValue");
  xml.close();
  xml.open("Piece", {{"NumberOfPoints", nodes}, {"NumberOfCells", cells.size()}});
  xml.open("Points");
  write_rows(xml, "Points", positions);
  xml.close();
  xml.open("Cells");
  cells.write(xml);
  xml.close();
  xml.open("PointData");
  write_fields(xml, node_fields, nodes, "nodes");
  xml.close();
  xml.open("CellData");
  write_fields(xml, cell_fields, cells.size(), "cells");
  for (int tag = 0; tag < 4; ++tag) xml.close();
  replace_file(path, xml.str());
}

}  // namespace detail

/// Writes one VTU file (VTK unstructured grid, XML, inline base64) as ParaView reads it: nodes at `positions`, the
/// cells of the mesh (hexahedra, of which degenerate ones are wedges and pyramids, tetrahedra, quadrilaterals,
/// triangles, then particles), fields by node and by cell in the same order. Fields of 3 components are vectors, of 6
/// symmetric tensors xx yy zz xy yz zx, of 9 tensors by rows. The file appears whole or not at all. Errors: numbers of
/// rows that do not fit; a cell with a node that is not there; a field without a name, or two of the same; a file that
/// cannot be written.
[[gnu::cold]] inline void write_vtu(const std::string& path, double time, const Mesh& mesh, const Rows& positions,
                                    const std::vector<Field>& node_fields = {},
                                    const std::vector<Field>& cell_fields = {}) {
  const std::size_t nodes = mesh.nodes.size();
  if (positions.size() != nodes || positions.components() != 3)
    throw Error(
        detail::joined({"strike: the VTU file '", path, "' needs 3 coordinates for each of ", std::to_string(nodes),
                        " nodes, but got ", std::to_string(positions.size()), " rows of ",
                        std::to_string(positions.components()), ": give the positions of the nodes of the mesh."}));
  detail::VtuCells cells;
  cells.add(mesh);
  detail::write_vtu(path, time, positions, cells, node_fields, cell_fields);
}

/// Writes the state of a run: the velocity of nodes, and of each element its part, mean stress (xx yy zz xy yz zx, of a
/// plate in the plate's frame) and mean equivalent plastic strain (0 where a material has none). Cells stand part after
/// part, without those that have been deleted; rigid bodies follow, numbered behind the parts. Error: a file that
/// cannot be written.
template <class Run>
  requires requires(const Run& run) { run.each_part([](const auto&) {}); }
void write_vtu(const std::string& path, const Run& run) {
  detail::VtuCells cells;
  std::vector<double> parts, plastic_strains;
  std::vector<SymmetricTensor<double>> stresses;
  run.each_part([&]<class Part>(const Part& part) {
    const std::vector<bool> alive = part.alive();
    const auto all = part.cells(run.nodes());
    const std::vector<SymmetricTensor<double>> stress = part.field(StressTensor{});
    const std::vector<double> plastic_strain = part.field(PlasticStrain{});
    [[maybe_unused]] constexpr auto kind = detail::VtuCells::kind(Part::n, !is_flat<typename Part::Element>);
    for (std::size_t e = 0; e < all.size(); ++e) {
      if (!alive[e]) continue;
      if constexpr (Part::n == 8)
        cells.add_hexahedron(all[e]);
      else
        cells.add(all[e], kind);
      parts.push_back(static_cast<double>(part.number()));
      stresses.push_back(stress[e]);
      plastic_strains.push_back(plastic_strain[e]);
    }
  });
  double body = 0;
  run.each_part([&](const auto&) { ++body; });
  run.each_body([&](const auto& rigid) {
    const Mesh& mesh = rigid.cells();
    cells.add(mesh);
    const std::size_t all = parts.size() + mesh.hexahedra.size() + mesh.tetrahedra.size() + mesh.quadrilaterals.size() +
                            mesh.triangles.size();
    parts.resize(all, body++), stresses.resize(all), plastic_strains.resize(all);
  });
  const std::vector<Eigen::Vector3d> positions = run.positions(), velocities = run.velocities();
  detail::write_vtu(path, run.time(), positions, cells, {{"velocity", velocities}},
                    {{"part", parts}, {"stress", stresses}, {"equivalent plastic strain", plastic_strains}});
}

/// A film for ParaView: `stem_0000.vtu`, `stem_0001.vtu`, ... and two lists of them, `stem.pvd` and `stem.vtu.series`
/// (open either). The lists are rewritten whole after each file, so that the film of a killed run opens too.
class VtuSeries {
 public:
  /// `stem` is the path without extension, e.g. "out/taylor".
  /// Error: its name is not in UTF-8, or has control characters, so that no list could name the files.
  explicit VtuSeries(std::string stem) : stem_(std::move(stem)) {
    if (!detail::is_plain_text(name()))
      throw Error(detail::joined(
          {"strike: the film '", stem_, "' has bytes in its name that are no text in UTF-8: give it another name."}));
  }

  /// Adds one time; see `write_vtu`. Fields may be listed in place: `{{"velocity", v}}, {{"plastic strain", eps}}`.
  [[gnu::cold]] void write(double time, const Mesh& mesh, const Rows& positions,
                           const std::vector<Field>& node_fields = {}, const std::vector<Field>& cell_fields = {}) {
    check(time);
    write_vtu(stem_ + number(times_.size()), time, mesh, positions, node_fields, cell_fields);
    times_.push_back(time);
    write_lists();
  }
  /// Adds the state of a run: velocities, parts, stresses and plastic strains, see `write_vtu`.
  template <class Run>
  void write(const Run& run) {
    check(run.time());
    write_vtu(stem_ + number(times_.size()), run);
    times_.push_back(run.time());
    write_lists();
  }

  /// Times written so far.
  const std::vector<double>& times() const { return times_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(times_);
  }

 private:
  /// Name of the files, relative to the lists.
  std::string name() const { return stem_.substr(stem_.rfind('/') + 1); }
  [[gnu::cold]] void check(double time) const {
    if (!std::isfinite(time))
      throw Error(
          detail::joined({"strike: the film '", stem_, "' got the time ", detail::text(time), ": give a finite one."}));
  }
  [[gnu::cold]] static std::string number(std::size_t k) {
    char text[32];
    std::snprintf(text, sizeof text, "_%04zu.vtu", k);
    return text;
  }

  [[gnu::cold]] void write_lists() const {
    detail::Xml list;
    std::string series;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      const std::string t = detail::shortest(times_[k]), file = name() + number(k);
      list.element("DataSet", {{"timestep", t}, {"part", 0}, {"file", file}});
      series +=
          detail::joined({k > 0 ? ",\n" : "", "{ \"name\": \"", detail::json_escaped(file), "\", \"time\": ", t, " }"});
    }
    detail::replace_file(stem_ + ".pvd",
                         detail::joined({"<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                                         "<Collection>\n",
                                         list.str(), "</Collection>\n</VTKFile>\n"}));
    detail::replace_file(stem_ + ".vtu.series",
                         detail::joined({"{ \"file-series-version\": \"1.0\", \"files\": [\n", series, "\n] }\n"}));
  }

  std::string stem_;
  std::vector<double> times_;
};

}  // namespace strike
