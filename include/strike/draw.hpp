#pragma once
#include <strike/draw/chart.hpp>
#include <strike/draw/colour.hpp>
#include <strike/draw/picture.hpp>
#include <strike/draw/svg.hpp>
