/* SPDX-License-Identifier: GPL-3.0-or-later
 * GCC's fixed-point types (ISO/IEC TR 18037): the toolchain's own fixed point, C only. A format is
 * named s<integer bits>_<fraction bits>, the sign bit apart: short _Accum s8.7, _Accum s16.15,
 * long _Accum s32.31, long long _Accum s16.47. */
#include <stdfix.h>

#define ACCUM(format, Type)                                                  \
    Type add_##format##_accum(Type a, Type b) { return a + b; }              \
    Type subtract_##format##_accum(Type a, Type b) { return a - b; }         \
    Type multiply_##format##_accum(Type a, Type b) { return a * b; }         \
    Type divide_##format##_accum(Type a, Type b) { return a / b; }

ACCUM(s8_7, short _Accum)
ACCUM(s16_15, _Accum)
ACCUM(s32_31, long _Accum)
ACCUM(s16_47, long long _Accum)
