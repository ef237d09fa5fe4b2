// SPDX-License-Identifier: MIT
// The whole library that a device program uses, under the name that Arduino sketches include.
// What is not used costs nothing: no function, no table.
#pragma once

#ifdef ARDUINO
// The Arduino core has macros of these names, which would break every function that is called so,
// the library's included. Integers and floats keep abs and round from <stdlib.h> and <math.h>.
#undef abs
#undef max
#undef min
#undef round
#endif

#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/literals.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/serial.hpp>
#include <fixedpoint/text.hpp>
#include <fixedpoint/vector.hpp>
