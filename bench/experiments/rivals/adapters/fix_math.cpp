// SPDX-License-Identifier: GPL-3.0-or-later
// Mozzi's FixMath widens the type of each result; the subject narrows it to the operands' format.
// It has inverses but no division.
#include <FixMath.h>

#include "adapter.h"

#define OPERATORS(format, Raw, Number)                                  \
    extern "C" Raw SUBJECT(add, format)(Raw a, Raw b) {                 \
        return Number(Number::fromRaw(a) + Number::fromRaw(b)).asRaw(); \
    }                                                                   \
    extern "C" Raw SUBJECT(subtract, format)(Raw a, Raw b) {            \
        return Number(Number::fromRaw(a) - Number::fromRaw(b)).asRaw(); \
    }                                                                   \
    extern "C" Raw SUBJECT(multiply, format)(Raw a, Raw b) {            \
        return Number(Number::fromRaw(a) * Number::fromRaw(b)).asRaw(); \
    }

using Q8_8 = SFix<7, 8>;
using Q16_16 = SFix<15, 16>;

OPERATORS(q8_8, int16_t, Q8_8)
OPERATORS(q16_16, int32_t, Q16_16)
