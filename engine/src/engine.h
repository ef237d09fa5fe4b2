// SPDX-License-Identifier: MIT
/// \file
/// The physics engine, for sketches: everything but the hash of a world's state.
#pragma once

/// \namespace engine
/// A physics engine of particles, templated on the scalar.

/// \namespace engine::literals
/// Decimal constants such as 0.38_d, which become any scalar.

#include <fixedpoint.h>
#ifdef ARDUINO
#undef constrain  // a macro of Arduino's core
#endif

#include <engine/broad_phase/cached_sort_and_sweep.hpp>
#include <engine/broad_phase/sort_and_sweep.hpp>
#include <engine/integrators/direct_springs.hpp>
#include <engine/integrators/explicit_euler.hpp>
#include <engine/integrators/gauss_seidel_springs.hpp>
#include <engine/integrators/implicit_midpoint.hpp>
#include <engine/integrators/implicit_springs.hpp>
#include <engine/integrators/velocity_verlet.hpp>
#include <engine/solvers/direct_rods.hpp>
#include <engine/solvers/warm_started.hpp>
#include <engine/solvers/worst_first.hpp>
#include <engine/world.hpp>
