#pragma once
#include <strike/tensor/plane.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/tensor/tensor.hpp>
