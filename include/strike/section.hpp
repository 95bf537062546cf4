#pragma once
#include <strike/section/layered.hpp>
#include <strike/section/thickness_rule.hpp>
#include <strike/section/transverse_shear.hpp>
