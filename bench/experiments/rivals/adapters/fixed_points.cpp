// SPDX-License-Identifier: GPL-3.0-or-later
// FixedPointsArduino names a format by its bits without the sign: SQ15x16 is Q16.16.
#include <FixedPoints.h>
#include <FixedPointsCommon.h>

#include "adapter.h"

#define OPERATORS(format, Raw, Number)                                            \
    extern "C" Raw SUBJECT(add, format)(Raw a, Raw b) {                           \
        return (Number::fromInternal(a) + Number::fromInternal(b)).getInternal(); \
    }                                                                             \
    extern "C" Raw SUBJECT(subtract, format)(Raw a, Raw b) {                      \
        return (Number::fromInternal(a) - Number::fromInternal(b)).getInternal(); \
    }                                                                             \
    extern "C" Raw SUBJECT(multiply, format)(Raw a, Raw b) {                      \
        return (Number::fromInternal(a) * Number::fromInternal(b)).getInternal(); \
    }                                                                             \
    extern "C" Raw SUBJECT(divide, format)(Raw a, Raw b) {                        \
        return (Number::fromInternal(a) / Number::fromInternal(b)).getInternal(); \
    }

OPERATORS(q4_4, int8_t, SQ3x4)
OPERATORS(q8_8, int16_t, SQ7x8)
OPERATORS(q16_16, int32_t, SQ15x16)
