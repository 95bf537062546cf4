#pragma once
#include <strike/verify/workbench.hpp>

// Copper in millimetres, milliseconds, kilograms; so kN and GPa.
inline constexpr double density = 8.93e-6, K = 130, G = 43.3, Y = 0.4, H = 0.1;

void study_materials(strike::verify::Workbench& bench, double strain, double rate);
void study_solids(strike::verify::Workbench& bench);
void study_plates(strike::verify::Workbench& bench);
