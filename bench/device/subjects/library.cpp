// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects of one format of the library: every operation in the default arithmetic, and those
// that saturate. LIBRARY_FORMAT, LIBRARY_RAW and LIBRARY_FRACTION_BITS name the format.
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>

#include "subject.hpp"

using fixedpoint::Nearest;
using fixedpoint::Saturating;

#define LIBRARY(format, Raw, F)                                      \
    SUBJECT_OPERATORS(format, default, Raw, F, Nearest)              \
    SUBJECT_BINARY(remainder, format, default, Raw, F, Nearest)      \
    SUBJECT_UNARY(sqrt, format, default, Raw, F, Nearest)            \
    SUBJECT_UNARY(atan, format, default, Raw, F, Nearest)            \
    SUBJECT_BINARY(atan2, format, default, Raw, F, Nearest)          \
    SUBJECT_UNARY(reciprocal_sqrt, format, default, Raw, F, Nearest) \
    SUBJECT_UNARY(sin, format, default, Raw, F, Nearest)             \
    SUBJECT_UNARY(cos, format, default, Raw, F, Nearest)             \
    SUBJECT_UNARY(exp, format, default, Raw, F, Nearest)             \
    SUBJECT_UNARY(log, format, default, Raw, F, Nearest)             \
    SUBJECT_SINCOS(format, default, Raw, F, Nearest)                 \
    SUBJECT_TERNARY(multiply_add, format, default, Raw, F, Nearest)  \
    SUBJECT_DOT(dot2, format, default, Raw, F, Nearest)              \
    SUBJECT_DOT(dot3, format, default, Raw, F, Nearest)              \
    SUBJECT_LENGTH(length2, format, default, Raw, F, Nearest)        \
    SUBJECT_LENGTH(length3, format, default, Raw, F, Nearest)        \
    SUBJECT_NORMALISE(normalise3, format, default, Raw, F, Nearest)  \
    SUBJECT_BINARY(add, format, saturating, Raw, F, Saturating)      \
    SUBJECT_BINARY(subtract, format, saturating, Raw, F, Saturating) \
    SUBJECT_BINARY(multiply, format, saturating, Raw, F, Saturating)

LIBRARY(LIBRARY_FORMAT, LIBRARY_RAW, LIBRARY_FRACTION_BITS)
