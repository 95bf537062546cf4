#pragma once
#include <strike/input/abaqus.hpp>
#include <strike/input/abaqus_cards.hpp>
#include <strike/input/deck.hpp>
#include <strike/input/dyna.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/input/gmsh.hpp>
#include <strike/input/read_mesh.hpp>
