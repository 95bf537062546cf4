#include <array>
#include <cstdlib>
#include <filesystem>

#include <strike/mesh/box.hpp>
#include <strike/output/vtu.hpp>
#include <strike/tensor/tensor.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"
#include "support/cut_hexahedra.hpp"
#include <sys/wait.h>

using namespace strike;

namespace {

/// Eight hexahedra of unit volume in all, two tetrahedra, one quadrilateral, three particles.
Mesh mixed_mesh() {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  mesh.nodes.emplace_back(3, 0, 0);
  mesh.nodes.emplace_back(3, 1, 0);
  mesh.tetrahedra = {{0, 27, 28, 26}, {0, 1, 27, 25}};
  mesh.quadrilaterals = {{2, 27, 28, 8}};
  mesh.nodes.emplace_back(5, 1, 2);
  mesh.particles = {{{28}, {4}, {29}}, {1, 1, 1}};
  return mesh;
}

std::string base64(std::string_view bytes) {
  std::string text;
  detail::append_base64(text, bytes);
  return text;
}

}  // namespace

TEST_CASE("base64: the test vectors of RFC 4648, section 10") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");  // bytes above 127
}

TEST_CASE("vtu: foreign readers find the counts and values that were written") {
  const ScratchFolder folder("vtu");
  const Mesh mesh = mixed_mesh();
  VtuSeries film(folder / "film");
  for (const double t : {0.0, 0.125, 80.0}) {
    std::vector<double> temperature, padded_velocity, number;
    for (const Eigen::Vector3d& x : mesh.nodes) {
      temperature.push_back(x[0] + 2 * x[1] + 4 * x[2] + t);
      for (const double v : {x[0], x[1] * t, x[2] - t, -99.0}) padded_velocity.push_back(v);
    }
    std::vector<SymmetricTensor<double>> stress;
    std::vector<std::array<double, 9>> gradient;
    for (int cell = 0; cell < 14; ++cell) {
      const double c = cell;
      number.push_back(c);
      stress.push_back({c, c + 1, c + 2, c + 3, c + 4, c + 5});
      gradient.push_back({0, c, 2 * c, 3 * c, 4 * c, 5 * c, 6 * c, 7 * c, 8 * c});
    }
    film.write(t, mesh, mesh.nodes, {{"temperature <K> & more", temperature}, {"velocity", {padded_velocity, 3, 4}}},
               {{"number", number}, {"stress", stress}, {"gradient", gradient}});
  }
  const auto script = std::filesystem::path(__FILE__).parent_path() / "read_vtu.py";
  const std::string log = folder / "log";
  const std::string command = "/usr/bin/python3 '" + script.string() + "' '" + folder.path().string() +
                              "' 8 2 1 28,4,29 30 > '" + log + "' 2>&1";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  INFO(content_of(log));
  if (code == 77 || code == 127)
    WARN("No reader of VTU files in Python (meshio or VTK): values not compared.");
  else
    CHECK(code == 0);
}

TEST_CASE("vtu: foreign readers find wedges and pyramids, and their volumes") {
  const ScratchFolder folder("vtu-degenerate");
  const Mesh mesh = testing::cut_by_thirds(box({.size = {3, 1, 1}, .cells = {3, 1, 1}}));
  write_vtu(folder / "cells.vtu", 0, mesh, mesh.nodes);
  const auto script = std::filesystem::path(__FILE__).parent_path() / "read_degenerate_vtu.py";
  const std::string log = folder / "log";
  const std::string command =
      "/usr/bin/python3 '" + script.string() + "' '" + (folder / "cells.vtu") + "' > '" + log + "' 2>&1";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  INFO(content_of(log));
  if (code == 77 || code == 127)
    WARN("No meshio in Python: values not compared.");
  else
    CHECK(code == 0);
}

TEST_CASE("vtu: after each time the lists are whole and name files that are there, nothing else is left") {
  const ScratchFolder folder("vtu-lists");
  const Mesh mesh = box({.size = {1, 1, 1}});
  VtuSeries film(folder / "film");
  for (int frame = 0; frame < 3; ++frame) {
    film.write(0.5 * frame, mesh, mesh.nodes);
    const std::string pvd = content_of(folder / "film.pvd"), series = content_of(folder / "film.vtu.series");
    CHECK(pvd.ends_with("</Collection>\n</VTKFile>\n"));
    CHECK(series.ends_with("\n] }\n"));
    for (int i = 0; i < 3; ++i) {
      const std::string name = "film_000" + std::to_string(i) + ".vtu";
      CHECK((pvd.find(name) != std::string::npos) == (i <= frame));
      CHECK((series.find(name) != std::string::npos) == (i <= frame));
      CHECK(std::filesystem::exists(folder / name) == (i <= frame));
    }
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == frame + 3);
  }
  CHECK(film.times() == std::vector<double>{0, 0.5, 1});
  CHECK(content_of(folder / "film_0000.vtu").find("appended") == std::string::npos);
}

TEST_CASE("vtu: lists of a film are valid for every name that is text") {
  const ScratchFolder folder("vtu-names");
  const Mesh mesh = box({.size = {1, 1, 1}});
  VtuSeries film(folder / "a \"b\" \\ <c> & caf\xC3\xA9");
  film.write(0, mesh, mesh.nodes, {{"a\nb\x01\xFF", std::vector<double>(8)}});
  const std::string stem = folder / "a \"b\" \\ <c> & caf\xC3\xA9";
  CHECK(content_of(stem + ".vtu.series").find("\"a \\\"b\\\" \\\\ <c> & caf\xC3\xA9_0000.vtu\"") != std::string::npos);
  CHECK(content_of(stem + ".pvd").find("a &quot;b&quot; \\ &lt;c&gt; &amp; caf\xC3\xA9_0000.vtu") != std::string::npos);
  CHECK(content_of(stem + "_0000.vtu").find("\"a&#10;b\xEF\xBF\xBD\xEF\xBF\xBD\"") != std::string::npos);
  for (const char* name : {"a\nb", "a\x01", "a\xFF"})
    CHECK_THROWS_WITH(VtuSeries(folder / name), Catch::Matchers::ContainsSubstring("are no text in UTF-8"));
  CHECK_THROWS_WITH(film.write(std::nan(""), mesh, mesh.nodes),
                    Catch::Matchers::ContainsSubstring("got the time nan: give a finite one."));
}

TEST_CASE("vtu: numbers of nodes and corners beyond 2^31 are written in 64 bits") {
  detail::VtuCells cells;
  cells.add(std::array<Index, 4>{0, 1, 2, 4'000'000'000}, 9);
  detail::Xml wide, narrow;
  cells.write(wide);
  CHECK(wide.str().find("Int64\" Name=\"connectivity") != std::string::npos);
  CHECK(wide.str().find("Int64\" Name=\"offsets") != std::string::npos);
  const std::array<std::int64_t, 5> numbers{32, 0, 1, 2, 4'000'000'000};  // 4 numbers of 8 bytes
  CHECK(wide.str().find(base64({reinterpret_cast<const char*>(numbers.data()), sizeof numbers})) != std::string::npos);
  detail::VtuCells few;
  few.add(std::array<Index, 2>{0, 1}, 3);
  few.write(narrow);
  CHECK(narrow.str().find("Int32\" Name=\"offsets") != std::string::npos);
  detail::Xml many;
  few.write(many, 1);  // as if 32 bits held no more
  CHECK(many.str().find("Int64\" Name=\"offsets") != std::string::npos);
}

TEST_CASE("vtu: cells that name no node, and fields that no reader could tell apart, are errors") {
  const ScratchFolder folder("vtu-cells");
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 1, 1}});
  const std::vector<double> twelve(12);
  const std::string path = folder / "a.vtu";
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, mesh.nodes, {{"", twelve}}),
                    "strike: a field by nodes has no name: give it one.");
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, mesh.nodes, {{"v", twelve}, {"u", twelve}, {"v", twelve}}),
                    "strike: two fields by nodes are called 'v': give each a name of its own.");
  mesh.hexahedra[1][3] = 12;
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, mesh.nodes),
                    "strike: the VTU file '" + path + "' has 12 nodes, but cell 1 names node 12: give nodes below 12.");
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("vtu: numbers of rows that do not fit are errors") {
  const ScratchFolder folder("vtu-error");
  const Mesh mesh = box({.size = {1, 1, 1}});
  const std::vector<double> two{1, 2};
  const std::string path = folder / "a.vtu";
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, mesh.nodes, {{"v", two}}),
                    "strike: the field 'v' has 2 rows for 8 nodes: give one row for each.");
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, mesh.nodes, {}, {{"s", two}}),
                    "strike: the field 's' has 2 rows for 1 cells: give one row for each.");
  CHECK_THROWS_WITH(write_vtu(path, 0, mesh, two),
                    "strike: the VTU file '" + path +
                        "' needs 3 coordinates for each of 8 nodes, but got 2 rows of 1: "
                        "give the positions of the nodes of the mesh.");
  CHECK_FALSE(std::filesystem::exists(path));
}
