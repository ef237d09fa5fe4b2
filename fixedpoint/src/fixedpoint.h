// SPDX-License-Identifier: MIT
// The whole library that a device program uses, under the name that Arduino sketches include.
// What is not used costs nothing: no function, no table.
#pragma once

#if __cplusplus < 201402L
#error \
    "The library fixedpoint is written in C++14: compile with -std=gnu++14 (README.md says how in Arduino)."
#endif

#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/literals.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/text.hpp>
#include <fixedpoint/vector.hpp>
