#pragma once
#include <strike/load/body_force.hpp>
#include <strike/load/curve.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/pressure.hpp>
#include <strike/load/support.hpp>
