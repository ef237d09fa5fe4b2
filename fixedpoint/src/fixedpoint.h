// SPDX-License-Identifier: MIT
// The whole library that a device program uses, under the name that Arduino sketches include.
// What is not used costs nothing: no function, no table.
#pragma once

#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/literals.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/printable.hpp>
#include <fixedpoint/serial.hpp>
#include <fixedpoint/text.hpp>
#include <fixedpoint/vector.hpp>
