// SPDX-License-Identifier: MIT
// The operations that Checked reports, as X(operation, ...).
#pragma once

#include <fixedpoint/portable/elementary_functions.hpp>

// clang-format off
#define FIXEDPOINT_REPORTED_OPERATIONS(X)                                                    \
    X(add, ) X(subtract, ) X(negate, ) X(multiply, ) X(divide, ) X(remainder, )              \
    X(shift_left, ) X(convert, ) X(sqrt, ) X(reciprocal_sqrt, ) X(log, ) X(multiply_add, )   \
    X(dot, ) X(length, ) X(scale_down, ) X(cos, ) X(atan2, ) X(exp, ) X(normalise, )         \
    X(ceil, ) X(round, ) X(from_float, ) X(from_decimal, )                                   \
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(X)                                                       \
    X(lerp, ) X(power, )
// clang-format on
#define FIXEDPOINT_ENUMERATOR(name, ...) name,
