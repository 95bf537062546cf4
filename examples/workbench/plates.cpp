// The plate, 10 mm square and 1 mm thick, in one layer of copper.
#include <strike/element/plate4.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>

#include "studies.hpp"

using namespace strike;
using namespace strike::verify;

void study_plates(Workbench& bench) {
  const Elastic copper{density, 9 * K * G / (3 * K + G), (3 * K - 2 * G) / (2 * (3 * K + G))};
  bench.element("Plate4", Plate4{}, Homogeneous{PlaneStress{copper}, 1.0}, Nodal<double, 4>(10 * unit_square()));
}
