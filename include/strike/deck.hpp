#pragma once
// A deck as a scene to run, and as the program that is the same scene.
#include <strike/deck/code.hpp>
#include <strike/deck/from_dyna.hpp>
#include <strike/deck/program.hpp>
#include <strike/deck/scene.hpp>
