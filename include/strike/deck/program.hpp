#pragma once
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <strike/deck/code.hpp>
#include <strike/deck/scene.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

/// The text of a program that is the scene of a deck.
class DeckProgram {
 public:
  DeckProgram(const DeckScene& scene, const std::string& deck, const std::string& name) {
    add_comment(joined({scene.title.empty() ? std::string_view("The scene of a deck") : scene.title, ": the scene of ",
                        deck, ", in its units."}));
    for (const auto* sentences : {&scene.replaced, &scene.cannot})
      for (const std::string& sentence : *sentences) add_comment(sentence);
    add(
        {"#include <cstdio>\n\n#include <strike/input.hpp>\n#include <strike/strike.hpp>\n\nusing namespace "
         "strike;\n"});
    add({"int main() try {"});
    add({"  const DynaDeck deck = read_dyna(\"", escaped(deck), "\");"});
    for (const StatedMaterial& material : scene.materials)
      add_wrapped({"  const auto ", material.name, " = ", material.code, ";"}, 6);
    std::set<std::string> known;
    for (const StatedPart& part : scene.parts)
      if (known.insert(part.name).second) add_wrapped({"  const auto ", part.name, " = ", part.material, ";"}, 6);
    if (!scene.more_nodes.empty()) add({"  std::vector<Eigen::Vector3d> nodes = deck.mesh.nodes;"});
    for (const std::string& line : scene.more_nodes) add_wrapped({"  ", line}, 6);
    add({});

    std::vector<std::string> items;
    for (const StatedPart& part : scene.parts)
      items.push_back(joined({"Part{", part.element, ", ", part.name, ", ", part.cells,
                              part.removal.empty() ? "" : ", ", part.removal, "}"}));
    add_codes(scene.bodies, items), add_codes(scene.velocities, items), add_codes(scene.supports, items);
    add_codes(scene.motions, items), add_codes(scene.body_forces, items), add_codes(scene.nodal_forces, items);
    add_codes(scene.pressures, items), add_codes(scene.blasts, items), add_codes(scene.walls, items);
    add_codes(scene.obstacles, items), add_codes(scene.ties, items), add_codes(scene.contacts, items);
    add({"  Explicit run{Scene{", scene.more_nodes.empty() ? "deck.mesh.nodes" : "nodes", ","});
    for (std::size_t i = 0; i < items.size(); ++i)
      add_wrapped({"                     ", items[i], i + 1 < items.size() ? "," : "},"}, 25);
    add({"               {.step_factor = ", code_of(scene.options.step_factor), "}};"});
    const bool watches = !scene.watched.empty();
    add(
        {"  std::vector<Column> columns{{\"time\"}, {\"kinetic energy\"}, {\"internal energy\"}, {\"hourglass "
         "energy\"}, ",
         "{\"balance\"}};"});
    if (watches) {
      add({"  for (const Index node : deck.history_nodes)"});
      add({"    for (const char* axis : {\"x\", \"y\", \"z\"})"});
      add({"      columns.push_back({\"displacement \" + std::string(axis) + \" of node \" +"});
      add({"                         std::to_string(deck.node_numbers[node])});"});
    }
    add({"  History history{\"", name, ".csv\", columns};"});
    add({"  VtuSeries film{\"", name, "\"};"});
    add({"  run.until(", code_of(scene.end), ", Every{", code_of(scene.interval), ", [&] { film.write(run); }},"});
    add({"            Every{", code_of(scene.end / 500), ", [&] {"});
    add({"                    const Energy& e = run.energy();"});
    add({"                    std::vector<double> row{run.time(), e.kinetic, e.internal, e.hourglass, e.error()};"});
    if (watches) {
      add({"                    for (const Index node : deck.history_nodes) {"});
      add({"                      const Eigen::Vector3d moved = run.nodes().x(node) - deck.mesh.nodes[node];"});
      add({"                      row.insert(row.end(), moved.begin(), moved.end());"});
      add({"                    }"});
    }
    add({"                    history.row(row);"});
    add({"                  }},"});
    add({"            Progress{});"});
    add({"  std::printf(\"%zu steps, energy error %.2g\\n\", run.steps(), run.energy().error());"});
    add({"} catch (const Error& error) {\n  return std::fprintf(stderr, \"%s\\n\", error.what()), 1;\n}"});
  }
  const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t width = 120;

  template <class All>
  static void add_codes(const All& all, std::vector<std::string>& items) {
    for (const auto& one : all) items.push_back(one.code);
  }
  void add(std::initializer_list<std::string_view> parts) { text_ += joined(parts) + "\n"; }
  /// Broken behind commas.
  void add_wrapped(std::initializer_list<std::string_view> parts, std::size_t indent) {
    std::string rest = joined(parts);
    while (rest.size() > width) {
      std::size_t comma = rest.rfind("}, ", width - 3);  // rather behind a piece than within it
      comma = comma == rest.npos || comma < width / 2 ? rest.rfind(", ", width - 2) : comma + 1;
      if (comma == rest.npos || comma < indent + 1) break;
      add({std::string_view(rest).substr(0, comma + 1)});
      rest = std::string(indent, ' ') + rest.substr(comma + 2);
    }
    add({rest});
  }
  void add_comment(std::string_view sentence) {
    while (sentence.size() > width - 3) {
      const std::size_t space = sentence.rfind(' ', width - 3);
      if (space == sentence.npos) break;
      add({"// ", sentence.substr(0, space)});
      sentence.remove_prefix(space + 1);
    }
    add({"// ", sentence});
  }
  static std::string escaped(std::string_view path) {
    std::string text;
    for (const char c : path) {
      if (c == '\\' || c == '"') text += '\\';
      text += c;
    }
    return text;
  }

  std::string text_;
};

}  // namespace detail

/// The C++ of a program that runs the scene of a deck with the same bits as the scene itself: it reads the file `deck`
/// and writes `name`.csv and `name`.pvd. What the scene replaces or leaves out stands in its head.
inline std::string program_of(const DeckScene& scene, const std::string& deck, const std::string& name) {
  return detail::DeckProgram(scene, deck, name).text();
}

}  // namespace strike
