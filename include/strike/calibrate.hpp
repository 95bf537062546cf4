#pragma once
// Fits parameters of materials to measurements. Not in strike.hpp, for it needs Eigen's unsupported modules.
#include <strike/calibrate/bar_profile.hpp>
#include <strike/calibrate/fit.hpp>
#include <strike/calibrate/student_t.hpp>
#include <strike/calibrate/uniaxial_stresses.hpp>
