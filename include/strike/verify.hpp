#pragma once
// Drivers with which a law is verified before it meets a mesh. What reports their findings,
// strike/verify/workbench.hpp, is included by its own name: it brings all the drawing.
#include <strike/verify/distortion.hpp>
#include <strike/verify/eigenmodes.hpp>
#include <strike/verify/laminate.hpp>
#include <strike/verify/material_point.hpp>
#include <strike/verify/patch_test.hpp>
#include <strike/verify/path.hpp>
#include <strike/verify/single_element.hpp>
