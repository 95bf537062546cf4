#pragma once
#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/element.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_modes.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/element/stable_step.hpp>
