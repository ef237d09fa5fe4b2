// SPDX-License-Identifier: GPL-3.0-or-later
// The report's arithmetic, the baseline.
#include <fixedpoint/arithmetic/published.hpp>

#include "subject.hpp"

using fixedpoint::Published;

#define PUBLISHED(format, Raw, F)                             \
    SUBJECT_OPERATORS(format, published, Raw, F, Published)   \
    SUBJECT_UNARY(sqrt, format, published, Raw, F, Published) \
    SUBJECT_BINARY(atan2, format, published, Raw, F, Published)

PUBLISHED(q4_4, int8_t, 4)
PUBLISHED(q8_8, int16_t, 8)
PUBLISHED(q16_16, int32_t, 16)
PUBLISHED(q32_32, int64_t, 32)
