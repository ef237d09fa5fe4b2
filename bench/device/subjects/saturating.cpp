// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic that clamps instead of wrapping, where it differs from the default.
#include <fixedpoint/arithmetic/saturating.hpp>

#include "subject.hpp"

#define SATURATING(format, Raw, F)                                                          \
    SUBJECT_BINARY(add, format, saturating, Raw, F, fixedpoint::Saturating)                 \
    SUBJECT_BINARY(subtract, format, saturating, Raw, F, fixedpoint::Saturating)            \
    SUBJECT_BINARY(multiply, format, saturating, Raw, F, fixedpoint::Saturating)

SATURATING(q4_4, int8_t, 4)
SATURATING(q8_8, int16_t, 8)
SATURATING(q16_16, int32_t, 16)
SATURATING(q32_32, int64_t, 32)
