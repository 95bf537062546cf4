#pragma once
// The numbers that strike computes with.
#include <strike/scalar/bisect.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/eigen.hpp>
#include <strike/scalar/flush_denormals.hpp>
#include <strike/scalar/math.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/scalar/scalar.hpp>
