// The workbench: a material along every kind of path, a hexahedron and a plate distorted until they fail.
//
//   bash examples/run workbench
//   bash examples/run workbench study=materials strain=0.5 rate=1e3
//   bash examples/run workbench study=solids
#include <cstdlib>
#include <string>

#include "../support/options.hpp"
#include "studies.hpp"

int main(int count, char** arguments) {
  int failed = EXIT_SUCCESS;
  const int stopped = examples::run(count, arguments, [&](examples::Options& options) {
    const std::string study = options.choice("study", {"all", "materials", "solids", "plates"});
    const double strain = options.number("strain", 0.2), rate = options.number("rate", 1);
    options.check();

    strike::verify::Workbench bench;  // writes into the present folder
    if (study == "all" || study == "materials") study_materials(bench, strain, rate);
    if (study == "all" || study == "solids") study_solids(bench);
    if (study == "all" || study == "plates") study_plates(bench);
    failed = bench.finish();
  });
  return stopped != EXIT_SUCCESS ? stopped : failed;
}
