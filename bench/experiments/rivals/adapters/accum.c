/* SPDX-License-Identifier: GPL-3.0-or-later
 * GCC's fixed-point types: short _Accum, _Accum, long _Accum and long long _Accum. */
#include <stdfix.h>

#include "adapter.h"

#define OPERATORS(format, Number)                                          \
    Number SUBJECT(add, format)(Number a, Number b) { return a + b; }      \
    Number SUBJECT(subtract, format)(Number a, Number b) { return a - b; } \
    Number SUBJECT(multiply, format)(Number a, Number b) { return a * b; } \
    Number SUBJECT(divide, format)(Number a, Number b) { return a / b; }

OPERATORS(s8_7, short _Accum)
OPERATORS(s16_15, _Accum)
OPERATORS(s32_31, long _Accum)
OPERATORS(s16_47, long long _Accum)
