// SPDX-License-Identifier: MIT
/// \file
/// The whole library for device programs, under the name that Arduino sketches include. What a
/// program does not use costs it neither a function nor a table.
///
/// The public interface is what `///` documents; everything marked as internal may change.
#pragma once

/// \namespace fixedpoint
/// Fixed-point numbers: their formats, arithmetics, functions, conversions and text.

/// \namespace fixedpoint::literals
/// Literals such as 0.38_q16_16.

#include <fixedpoint/angle.hpp>
#include <fixedpoint/constants.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/integer_root.hpp>
#include <fixedpoint/literals.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/printable.hpp>
#include <fixedpoint/serial.hpp>
#include <fixedpoint/text.hpp>
#include <fixedpoint/unsigned.hpp>
#include <fixedpoint/vector.hpp>
#include <fixedpoint/widening.hpp>
