// Steps of one element for `count`, which asks what their instructions are:
//
//   build/bench/bench/instructions element=hexahedra steps=20
#include <cstdio>
#include <functional>
#include <map>
#include <string>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/section/layered.hpp>

#include "../support/materials.hpp"
#include "../support/squeezed_bar.hpp"
#include "../support/stretched_sheet.hpp"
#include "support/options.hpp"

int main(int count, char** arguments) {
  using namespace strike;
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string chosen = options.text("element", "hexahedra");
    const std::size_t steps = options.count("steps", 20);
    options.check();
    const Solid copper{bench::linear, bench::hardening};
    const Mesh bar = bench::bar({10, 12, 12}), split = tetrahedralized(bench::bar({6, 6, 7})),
               sheet = bench::sheet({40, 36});
    const auto run = [&](const Mesh& mesh, const auto& part, const auto& motion) {
      Explicit scene{Scene{mesh.nodes, part, motion}};
      for (std::size_t i = 0; i < steps; ++i) scene.step();
      const auto& elements = scene.template part<0>();
      std::printf("%zu elements in %zu blocks\n", elements.size(), elements.blocks().size());
    };
    const std::map<std::string, std::function<void()>> elements{
        {"hexahedra",
         [&] {
           run(bar, Part{Hex8{ViscousHourglass{}}, copper, bar.hexahedra}, bench::Squeeze{});
         }},
        {"physical",
         [&] {
           run(bar, Part{Hex8{}, copper, bar.hexahedra}, bench::Squeeze{});
         }},
        {"tetrahedra",
         [&] {
           run(split, Part{Tet4{}, copper, split.tetrahedra}, bench::Squeeze{});
         }},
        {"plates", [&] {
           const Homogeneous section{PlaneStress{copper}, bench::sheet_thickness};
           run(sheet, Part{Plate4{}, section, sheet.quadrilaterals}, bench::Stretch{});
         }}};
    const auto element = elements.find(chosen);
    if (element == elements.end())
      throw Error("strike: element=" + chosen + " is none of hexahedra, physical, tetrahedra and plates.");
    element->second();
  });
}
