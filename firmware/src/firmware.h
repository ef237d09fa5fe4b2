// SPDX-License-Identifier: MIT
/// \file
/// The haptic lever, for sketches: its board and its program.
#pragma once

/// \namespace firmware
/// The haptic lever: hardware layer, clock, renderer, calibration and the lever itself.

#include <engine.h>

#include <firmware/hardware/atmega328p.hpp>
#include <firmware/lever_program.hpp>
