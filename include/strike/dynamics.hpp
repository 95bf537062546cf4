#pragma once
#include <strike/dynamics/every.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/gather.hpp>
#include <strike/dynamics/ledger.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/dynamics/stop_when.hpp>
