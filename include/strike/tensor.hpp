#pragma once
#include <strike/tensor/rotation.hpp>
#include <strike/tensor/tensor.hpp>
