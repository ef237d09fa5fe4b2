// SPDX-License-Identifier: MIT
// The physics engine, for sketches: everything but the hash of a world's state.
#pragma once

#include <fixedpoint.h>
#ifdef ARDUINO
#undef constrain  // a macro of Arduino's core
#endif

#include <engine/integrators/explicit_euler.hpp>
#include <engine/integrators/implicit_springs.hpp>
#include <engine/integrators/velocity_verlet.hpp>
#include <engine/pairs/sort_and_sweep.hpp>
#include <engine/resolvers/worst_first.hpp>
#include <engine/world.hpp>
