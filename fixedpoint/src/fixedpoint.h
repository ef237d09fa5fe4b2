// SPDX-License-Identifier: MIT
// The whole library that a device program uses, under the name that Arduino sketches include.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/literals.hpp>
#include <fixedpoint/math.hpp>
