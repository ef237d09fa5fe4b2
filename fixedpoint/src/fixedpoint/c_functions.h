/* SPDX-License-Identifier: MIT
 * DO NOT EDIT: written by python3 fixedpoint/tables/functions.py
 * What fixedpoint_c.h declares, for fixedpoint_c.cpp and the tests. */
#ifndef FIXEDPOINT_C_FUNCTIONS_H
#define FIXEDPOINT_C_FUNCTIONS_H

/* clang-format off */
/* X(format, its constants' prefix, integer bits, fraction bits) */
#define FIXEDPOINT_C_FORMATS(X) \
    X(q4_4, Q4_4, 4, 4) \
    X(q8_8, Q8_8, 8, 8) \
    X(q16_16, Q16_16, 16, 16) \
    X(q8_24, Q8_24, 8, 24) \
    X(q32_32, Q32_32, 32, 32)
/* X(each other format than q4_4, ...) */
#define FIXEDPOINT_C_BESIDE_q4_4(X, ...) \
    X(q8_8, __VA_ARGS__) \
    X(q16_16, __VA_ARGS__) \
    X(q8_24, __VA_ARGS__) \
    X(q32_32, __VA_ARGS__)
/* X(each other format than q8_8, ...) */
#define FIXEDPOINT_C_BESIDE_q8_8(X, ...) \
    X(q4_4, __VA_ARGS__) \
    X(q16_16, __VA_ARGS__) \
    X(q8_24, __VA_ARGS__) \
    X(q32_32, __VA_ARGS__)
/* X(each other format than q16_16, ...) */
#define FIXEDPOINT_C_BESIDE_q16_16(X, ...) \
    X(q4_4, __VA_ARGS__) \
    X(q8_8, __VA_ARGS__) \
    X(q8_24, __VA_ARGS__) \
    X(q32_32, __VA_ARGS__)
/* X(each other format than q8_24, ...) */
#define FIXEDPOINT_C_BESIDE_q8_24(X, ...) \
    X(q4_4, __VA_ARGS__) \
    X(q8_8, __VA_ARGS__) \
    X(q16_16, __VA_ARGS__) \
    X(q32_32, __VA_ARGS__)
/* X(each other format than q32_32, ...) */
#define FIXEDPOINT_C_BESIDE_q32_32(X, ...) \
    X(q4_4, __VA_ARGS__) \
    X(q8_8, __VA_ARGS__) \
    X(q16_16, __VA_ARGS__) \
    X(q8_24, __VA_ARGS__)
/* X(function, what it takes and returns, ...) */
#define FIXEDPOINT_C_FUNCTIONS(X, ...) \
    X(add, operator, __VA_ARGS__) \
    X(subtract, operator, __VA_ARGS__) \
    X(negate, negation, __VA_ARGS__) \
    X(abs, unary, __VA_ARGS__) \
    X(multiply, operator, __VA_ARGS__) \
    X(multiply_add, ternary, __VA_ARGS__) \
    X(divide, operator, __VA_ARGS__) \
    X(remainder, operator, __VA_ARGS__) \
    X(shift_left, shift, __VA_ARGS__) \
    X(shift_right, shift, __VA_ARGS__) \
    X(sqrt, unary, __VA_ARGS__) \
    X(reciprocal_sqrt, unary, __VA_ARGS__) \
    X(sin, unary, __VA_ARGS__) \
    X(cos, unary, __VA_ARGS__) \
    X(sincos, direct_pair, __VA_ARGS__) \
    X(atan, unary, __VA_ARGS__) \
    X(atan2, binary, __VA_ARGS__) \
    X(exp, unary, __VA_ARGS__) \
    X(log, unary, __VA_ARGS__) \
    X(tan, unary, __VA_ARGS__) \
    X(asin, unary, __VA_ARGS__) \
    X(acos, unary, __VA_ARGS__) \
    X(exp2, unary, __VA_ARGS__) \
    X(expm1, unary, __VA_ARGS__) \
    X(log2, unary, __VA_ARGS__) \
    X(log10, unary, __VA_ARGS__) \
    X(log1p, unary, __VA_ARGS__) \
    X(sinh, unary, __VA_ARGS__) \
    X(cosh, unary, __VA_ARGS__) \
    X(tanh, unary, __VA_ARGS__) \
    X(cbrt, unary, __VA_ARGS__) \
    X(pow, binary, __VA_ARGS__) \
    X(sin_turns, unary, __VA_ARGS__) \
    X(cos_turns, unary, __VA_ARGS__) \
    X(sincos_turns, pair, __VA_ARGS__) \
    X(atan2_turns, binary, __VA_ARGS__) \
    X(sin_degrees, unary, __VA_ARGS__) \
    X(cos_degrees, unary, __VA_ARGS__) \
    X(sincos_degrees, pair, __VA_ARGS__) \
    X(atan2_degrees, binary, __VA_ARGS__) \
    X(divrem, binary_pair, __VA_ARGS__) \
    X(divmod, binary_pair, __VA_ARGS__) \
    X(lerp, ternary, __VA_ARGS__) \
    X(smoothstep, unary, __VA_ARGS__) \
    X(midpoint, binary, __VA_ARGS__) \
    X(abs_diff, binary, __VA_ARGS__) \
    X(sign, sign, __VA_ARGS__) \
    X(isqrt, integer, __VA_ARGS__) \
    X(copysign, binary, __VA_ARGS__) \
    X(power, power, __VA_ARGS__) \
    X(dot2, dot, __VA_ARGS__) \
    X(dot3, dot, __VA_ARGS__) \
    X(length2, length, __VA_ARGS__) \
    X(length3, length, __VA_ARGS__) \
    X(normalise3, direction, __VA_ARGS__)

/* clang-format on */
#endif
