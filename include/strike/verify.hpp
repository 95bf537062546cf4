#pragma once
// Drivers with which a law is verified before it meets a mesh.
#include <strike/verify/laminate.hpp>
#include <strike/verify/material_point.hpp>
#include <strike/verify/path.hpp>
#include <strike/verify/single_element.hpp>
