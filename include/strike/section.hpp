#pragma once
#include <strike/section/integrals.hpp>
#include <strike/section/layered.hpp>
#include <strike/section/piece.hpp>
#include <strike/section/slots.hpp>
#include <strike/section/thickness_rule.hpp>
#include <strike/section/transverse_shear.hpp>
