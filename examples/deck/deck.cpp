// An LS-DYNA deck from file to film: what it becomes, the run, and the program that is the same scene.
//
//   bash examples/run deck file=../../examples/read_deck/taylor_bar.k
//   bash examples/run deck file=my.k program=my.cpp     writes the program and does not run
//   bash examples/run deck file=my.k anyway=yes         runs although something of the deck is left out
//   bash examples/run deck file=my.k end=1e-3           ends there
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <strike/deck.hpp>
#include <strike/draw.hpp>
#include <strike/input.hpp>
#include <strike/strike.hpp>

#include "../support/options.hpp"

using namespace strike;

namespace {

void print(const char* head, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  std::printf("%s\n", head);
  for (const std::string& sentence : sentences) std::printf("  %s\n", sentence.c_str());
}

/// The elements that are left, coloured by their plastic strain.
template <class Run>
void draw(const Run& run, const std::string& title, const std::string& path) {
  Picture picture{{.title = title, .quantity = "plastic strain"}};
  const std::vector<Eigen::Vector3d> x = run.positions();
  run.each_part([&]<class Part>(const Part& part) {
    const auto cells = remaining(part.cells(run.nodes()), part.alive());
    const std::vector<double> strain = remaining(part.field(PlasticStrain{}), part.alive());
    if constexpr (Part::n == 8)
      picture.add(hexahedron_surface(cells), x, strain);
    else if constexpr (Part::n == 3)
      picture.add(triangle_surface(cells), x, strain, Sides::both);
    else if constexpr (is_flat<typename Part::Element>)
      picture.add(quadrilateral_surface(cells), x, strain, Sides::both);
    else
      picture.add(tetrahedron_surface(cells), x, strain);
  });
  run.each_body([&](const auto& body) { picture.add(surface(body.cells()), x); });
  picture.write(path);
}

void run_deck(const DeckScene& scene, const std::string& name) {
  Explicit run{scene.scene(), scene.options};
  std::vector<Column> columns{{"time"}, {"kinetic energy"}, {"internal energy"}, {"hourglass energy"}, {"balance"}};
  for (const Index node : scene.watched)
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({"displacement " + std::string(axis) + " of node " + std::to_string(scene.node_numbers[node])});
  History history{name + ".csv", columns};
  VtuSeries film{name};
  run.until(scene.end, Every{scene.interval, [&] { film.write(run); }},
            Every{scene.end / 500,
                  [&] {
                    const Energy& e = run.energy();
                    std::vector<double> row{run.time(), e.kinetic, e.internal, e.hourglass, e.error()};
                    for (const Index node : scene.watched) {
                      const Eigen::Vector3d moved = run.nodes().x(node) - scene.nodes[node];
                      row.insert(row.end(), moved.begin(), moved.end());
                    }
                    history.row(row);
                  }},
            Progress{});
  draw(run, scene.title.empty() ? name : scene.title, name + ".svg");
  std::printf("%zu steps, energy error %.2g\nWritten: %s.csv, %s.pvd, %s.svg\n", run.steps(), run.energy().error(),
              name.c_str(), name.c_str(), name.c_str());
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string file = options.text("file", "../../examples/read_deck/taylor_bar.k");
    const std::string program = options.text("program", "");
    const double end = options.number("end", 0);
    const bool anyway = options.choice("anyway", {"no", "yes"}) == "yes";
    options.check();

    const std::string name = std::filesystem::path(file).stem().string();
    DeckScene scene = deck_scene(read_dyna(file, {.leave_out_elements = true}));
    if (end > 0) scene.end = end;
    print("The deck becomes", scene.becomes);
    print("Something else stands for", scene.replaced);
    print("Left out, so that the answer would be another one", scene.cannot);
    if (!program.empty()) {
      detail::replace_file(program, program_of(scene, file, name));
      std::printf("Written: %s\n", program.c_str());
      return;
    }
    if (!scene.cannot.empty() && !anyway)
      throw Error("Nothing was run: correct the deck, or run what is left of it with anyway=yes.");
    run_deck(scene, name);
  });
}
