#pragma once
// All that a scene needs. Beside it stand <strike/draw.hpp>, <strike/input.hpp>, <strike/verify.hpp>,
// <strike/calibrate.hpp>: included by the programs that use them.
#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion.hpp>
#include <strike/output.hpp>
#include <strike/scalar.hpp>
#include <strike/section.hpp>
#include <strike/tensor.hpp>
#include <strike/version.hpp>
