#pragma once
#include <strike/contact/contact.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/law.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/contact/surface.hpp>
