#pragma once
#include <strike/contact/rigid_wall.hpp>
