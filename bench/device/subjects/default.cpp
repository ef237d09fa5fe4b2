// SPDX-License-Identifier: GPL-3.0-or-later
// The library's default arithmetic, every operation in every format.
#include <fixedpoint/arithmetic/nearest.hpp>

#include "subject.hpp"

using fixedpoint::Nearest;

#define DEFAULT(format, Raw, F)                                          \
    SUBJECT_OPERATORS(format, default, Raw, F, Nearest)                  \
    SUBJECT_BINARY(remainder, format, default, Raw, F, Nearest)          \
    SUBJECT_UNARY(sqrt, format, default, Raw, F, Nearest)                \
    SUBJECT_UNARY(atan, format, default, Raw, F, Nearest)                \
    SUBJECT_BINARY(atan2, format, default, Raw, F, Nearest)

DEFAULT(q4_4, int8_t, 4)
DEFAULT(q8_8, int16_t, 8)
DEFAULT(q16_16, int32_t, 16)
DEFAULT(q32_32, int64_t, 32)
