// SPDX-License-Identifier: MIT
// The haptic lever, for sketches: its board and its program.
#pragma once

#include <engine.h>

#include <firmware/hardware/atmega328p.hpp>
#include <firmware/lever_program.hpp>
