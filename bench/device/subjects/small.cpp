// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of Q16.16 that take little flash instead of little time.
#include <fixedpoint/arithmetic/small.hpp>

#include "subject.hpp"

using fixedpoint::Small;

SUBJECT_UNARY(sqrt, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(reciprocal_sqrt, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(atan, q16_16, small, int32_t, 16, Small)
SUBJECT_BINARY(atan2, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(sin, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(cos, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(exp, q16_16, small, int32_t, 16, Small)
SUBJECT_UNARY(log, q16_16, small, int32_t, 16, Small)
SUBJECT_SINCOS(q16_16, small, int32_t, 16, Small)
