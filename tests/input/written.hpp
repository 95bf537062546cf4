#pragma once
#include <cstdio>
#include <string>

#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

// A mesh of solids as a file of each format, with numbers from 1 and coordinates to the last bit.

inline std::string exact(double x) { return strike::detail::shortest(x); }

template <class... Numbers>
std::string line_of(const char* separator, Numbers... numbers) {
  std::string line;
  ((line += (line.empty() ? "" : separator) + std::to_string(numbers)), ...);
  return line;
}

inline std::string written_gmsh(const strike::Mesh& mesh, const std::string& name) {
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"" + name +
                     "\"\n$EndPhysicalNames\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 7 0\n$EndEntities\n$Nodes\n";
  const auto nodes = mesh.nodes.size(), hexahedra = mesh.hexahedra.size(), tetrahedra = mesh.tetrahedra.size();
  text += line_of(" ", 1, nodes, 1, nodes) + "\n" + line_of(" ", 3, 1, 0, nodes) + "\n";
  for (std::size_t n = 1; n <= nodes; ++n) text += std::to_string(n) + "\n";
  for (const auto& x : mesh.nodes) text += exact(x[0]) + " " + exact(x[1]) + " " + exact(x[2]) + "\n";
  text += "$EndNodes\n$Elements\n" + line_of(" ", 2, hexahedra + tetrahedra, 1, hexahedra + tetrahedra) + "\n";
  std::size_t number = 0;
  const auto add = [&](const auto& cells, int type) {
    text += line_of(" ", 3, 1, type, cells.size()) + "\n";
    for (const auto& cell : cells) {
      text += std::to_string(++number);
      for (const auto node : cell) text += " " + std::to_string(node + 1);
      text += "\n";
    }
  };
  add(mesh.hexahedra, 5), add(mesh.tetrahedra, 4);
  return text + "$EndElements\n";
}

inline std::string written_abaqus(const strike::Mesh& mesh, const std::string& name) {
  std::string text = "*HEADING\nwritten by a test\n** nodes\n*NODE\n";
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto& x = mesh.nodes[n];
    text += std::to_string(n + 1) + ", " + exact(x[0]) + ", " + exact(x[1]) + ", " + exact(x[2]) + "\n";
  }
  std::size_t number = 0;
  const auto add = [&](const auto& cells, const char* type) {
    if (cells.empty()) return;
    text += std::string("*Element, type=") + type + ", elset=" + name + "\n";
    for (const auto& cell : cells) {
      text += std::to_string(++number);
      for (const auto node : cell) text += ", " + std::to_string(node + 1);
      text += "\n";
    }
  };
  add(mesh.hexahedra, "C3D8R"), add(mesh.tetrahedra, "C3D4");
  return text;
}

/// Fixed columns of 8; coordinates of up to 24 characters do not fit 16, so the nodes have commas.
inline std::string written_dyna(const strike::Mesh& mesh, const std::string& name) {
  const auto column = [](std::size_t n) {
    char field[32];
    std::snprintf(field, sizeof field, "%8zu", n);
    return std::string(field);
  };
  std::string text = "*KEYWORD\n$ written by a test\n*PART\n" + name + "\n         1\n*ELEMENT_SOLID\n";
  std::size_t number = 0;
  for (const auto& cell : mesh.hexahedra) {
    text += column(++number) + column(1);
    for (const auto node : cell) text += column(node + 1);
    text += "\n";
  }
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    text += column(++number) + column(1);
    for (const auto node : {a, b, c, d, d, d, d, d}) text += column(node + 1);
    text += "\n";
  }
  text += "*NODE\n";
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto& x = mesh.nodes[n];
    text += std::to_string(n + 1) + "," + exact(x[0]) + "," + exact(x[1]) + "," + exact(x[2]) + "\n";
  }
  return text + "*END\n";
}
