#pragma once
#include <strike/load/initial_velocity.hpp>
#include <strike/load/symmetry.hpp>
