/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every operation, once: OPERATION_<name>(X, ...) passes the operation's row to the macro X, and
 * any further arguments after it. Whatever lists operations expands these rows: the reference, the
 * subjects on the host, and those on the device, whose compilers speak C11 and C++14.
 *
 * X(name, signature, operands, results, kind, bound_ulp, domain, ...)
 *
 * signature: how the function is called (bench/lab/catalogue/invoke.h).
 *
 * operands, results: how many numbers it takes and returns. Vectors are passed one after the other:
 * the operands of dot3 are a0 a1 a2 b0 b1 b2. atan2 takes y, then x.
 *
 * kind: what becomes of the exact result x, which is given in ulp (units of 2^-F).
 *   ring: x is rounded half up, then taken modulo 2^W in the wrapping arithmetics, so that a sum
 *     whose intermediate results overflow is still right; a saturating arithmetic saturates it.
 *   rounded: x is rounded half up, then saturated.
 *   function: the result is an integer at most bound_ulp from x, saturated.
 * The arithmetics that round or overflow otherwise are in definition.hpp.
 *
 * domain: the operands for which x exists. The sentence above each row also defines the result for
 * all other operands.
 *
 * Notation: a, b, c are the operands in order, as numbers: raw / 2^F. MAX and MIN are the largest
 * and the smallest number of the format. An operand or result that is called an integer is stored
 * as a raw that equals it.
 */
#ifndef REFERENCE_OPERATION_TABLE_H
#define REFERENCE_OPERATION_TABLE_H

/* clang-format off */
/* a + b. */
#define OPERATION_add(X, ...) \
    X(add, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a - b. */
#define OPERATION_subtract(X, ...) \
    X(subtract, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a b. */
#define OPERATION_multiply(X, ...) \
    X(multiply, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a / b. If b = 0: MAX for a > 0, MIN for a < 0, 0 for a = 0. */
#define OPERATION_divide(X, ...) \
    X(divide, binary, 2, 1, rounded, 0, nonzero_divisor, __VA_ARGS__)
/* a - b trunc(a / b), which is exact and 0 or of the sign of a. If b = 0: a. */
#define OPERATION_remainder(X, ...) \
    X(remainder, binary, 2, 1, rounded, 0, nonzero_divisor, __VA_ARGS__)
/* The square root of a, which is never a tie. If a < 0: 0. */
#define OPERATION_sqrt(X, ...) \
    X(sqrt, unary, 1, 1, rounded, 0, not_negative, __VA_ARGS__)
/* The arc tangent of a, in radians. */
#define OPERATION_atan(X, ...) \
    X(atan, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The angle of the point (x, y) = (b, a), in radians, in (-pi, pi]. If a = b = 0: 0. */
#define OPERATION_atan2(X, ...) \
    X(atan2, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
/* 1 / sqrt(a). If a = 0: MAX. If a < 0: 0. */
#define OPERATION_reciprocal_sqrt(X, ...) \
    X(reciprocal_sqrt, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
/* The sine of any angle a in radians. A result beyond +-1 would be off by at least 1 ulp. */
#define OPERATION_sin(X, ...) \
    X(sin, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The cosine of any angle a in radians, under the rule of sin. */
#define OPERATION_cos(X, ...) \
    X(cos, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The sine and the cosine of any angle a in radians, each within the bound. */
#define OPERATION_sincos(X, ...) \
    X(sincos, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
/* e^a. A value below half an ulp may become 0. */
#define OPERATION_exp(X, ...) \
    X(exp, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The natural logarithm of a. If a <= 0: MIN. */
#define OPERATION_log(X, ...) \
    X(log, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
/* The tangent of any angle a in radians. Next to a pole it saturates. */
#define OPERATION_tan(X, ...) \
    X(tan, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The arc sine of a, in radians. If a < -1 or a > 1: -pi/2 or pi/2, rounded, saturated. */
#define OPERATION_asin(X, ...) \
    X(asin, unary, 1, 1, function, 0.75, unit_interval, __VA_ARGS__)
/* The arc cosine of a, in radians. If a > 1: 0. If a < -1: pi, rounded, saturated. */
#define OPERATION_acos(X, ...) \
    X(acos, unary, 1, 1, function, 0.75, unit_interval, __VA_ARGS__)
/* 2^a. A value below half an ulp may become 0. */
#define OPERATION_exp2(X, ...) \
    X(exp2, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* e^a - 1. */
#define OPERATION_expm1(X, ...) \
    X(expm1, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The binary logarithm of a. If a <= 0: MIN. */
#define OPERATION_log2(X, ...) \
    X(log2, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
/* The decimal logarithm of a. If a <= 0: MIN. */
#define OPERATION_log10(X, ...) \
    X(log10, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
/* The natural logarithm of 1 + a. If a <= -1: MIN. */
#define OPERATION_log1p(X, ...) \
    X(log1p, unary, 1, 1, function, 0.75, above_minus_one, __VA_ARGS__)
/* The hyperbolic sine of a. */
#define OPERATION_sinh(X, ...) \
    X(sinh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The hyperbolic cosine of a. */
#define OPERATION_cosh(X, ...) \
    X(cosh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The hyperbolic tangent of a. */
#define OPERATION_tanh(X, ...) \
    X(tanh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* The cube root of a, negative for a < 0. */
#define OPERATION_cbrt(X, ...) \
    X(cbrt, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* a^b; 1 if b = 0. If a = 0 and b < 0: MAX. If a < 0 and b is not a whole number: 0. */
#define OPERATION_pow(X, ...) \
    X(pow, binary, 2, 1, function, 0.75, power, __VA_ARGS__)
/* sin(2 pi a), for any a. A result beyond +-1 would be off by at least 1 ulp. */
#define OPERATION_sin_turns(X, ...) \
    X(sin_turns, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* cos(2 pi a), for any a, under the rule of sin_turns. */
#define OPERATION_cos_turns(X, ...) \
    X(cos_turns, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* sin(2 pi a) and cos(2 pi a), for any a, each within the bound. */
#define OPERATION_sincos_turns(X, ...) \
    X(sincos_turns, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
/* atan2(a, b) / (2 pi), in -1/2..1/2. If a = b = 0: 0. */
#define OPERATION_atan2_turns(X, ...) \
    X(atan2_turns, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
/* sin(pi a / 180), for any a. A result beyond +-1 would be off by at least 1 ulp. */
#define OPERATION_sin_degrees(X, ...) \
    X(sin_degrees, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* cos(pi a / 180), for any a, under the rule of sin_degrees. */
#define OPERATION_cos_degrees(X, ...) \
    X(cos_degrees, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
/* sin(pi a / 180) and cos(pi a / 180), for any a, each within the bound. */
#define OPERATION_sincos_degrees(X, ...) \
    X(sincos_degrees, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
/* 180 atan2(a, b) / pi, in -180..180. If a = b = 0: 0. */
#define OPERATION_atan2_degrees(X, ...) \
    X(atan2_degrees, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
/* The integer q = trunc(a / b), and a - b q. If b = 0: the result of divide as a raw, and a. */
#define OPERATION_divrem(X, ...) \
    X(divrem, binary_pair, 2, 2, rounded, 0, nonzero_divisor, __VA_ARGS__)
/* The integer q = floor(a / b), and a - b q. If b = 0: the results of divrem. */
#define OPERATION_divmod(X, ...) \
    X(divmod, binary_pair, 2, 2, rounded, 0, nonzero_divisor, __VA_ARGS__)
/* a + (b - a) c for any c, rounded once. */
#define OPERATION_lerp(X, ...) \
    X(lerp, ternary, 3, 1, ring, 0, everywhere, __VA_ARGS__)
/* 3 t^2 - 2 t^3, rounded once, where t is a limited to 0..1. */
#define OPERATION_smoothstep(X, ...) \
    X(smoothstep, unary, 1, 1, rounded, 0, everywhere, __VA_ARGS__)
/* (a + b) / 2, without overflow of the sum. */
#define OPERATION_midpoint(X, ...) \
    X(midpoint, binary, 2, 1, rounded, 0, everywhere, __VA_ARGS__)
/* |a - b|. */
#define OPERATION_abs_diff(X, ...) \
    X(abs_diff, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* |a| if b >= 0, -|a| if b < 0. */
#define OPERATION_copysign(X, ...) \
    X(copysign, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a^n, where the second operand n is an integer; 1 if n = 0. If a = 0 and n < 0: MAX. */
#define OPERATION_power(X, ...) \
    X(power, binary, 2, 1, function, 0.75, integer_power, __VA_ARGS__)
/* The integer -1, 0 or 1: the sign of a. */
#define OPERATION_sign(X, ...) \
    X(sign, unary, 1, 1, rounded, 0, everywhere, __VA_ARGS__)
/* floor(sqrt(a)), where a and the result are integers. If a < 0: 0. */
#define OPERATION_isqrt(X, ...) \
    X(isqrt, unary, 1, 1, rounded, 0, not_negative, __VA_ARGS__)
/* a b + c, rounded once. */
#define OPERATION_multiply_add(X, ...) \
    X(multiply_add, ternary, 3, 1, ring, 0, everywhere, __VA_ARGS__)
/* a0 b0 + a1 b1, rounded once. */
#define OPERATION_dot2(X, ...) \
    X(dot2, dot, 4, 1, ring, 0, everywhere, __VA_ARGS__)
/* a0 b0 + a1 b1 + a2 b2, rounded once. */
#define OPERATION_dot3(X, ...) \
    X(dot3, dot, 6, 1, ring, 0, everywhere, __VA_ARGS__)
/* sqrt(a0^2 + a1^2), which is never a tie. The squares do not overflow. */
#define OPERATION_length2(X, ...) \
    X(length2, length, 2, 1, rounded, 0, everywhere, __VA_ARGS__)
/* sqrt(a0^2 + a1^2 + a2^2), which is never a tie. The squares do not overflow. */
#define OPERATION_length3(X, ...) \
    X(length3, length, 3, 1, rounded, 0, everywhere, __VA_ARGS__)
/* The three components of a / |a|, each within the bound. If a = 0: the zero vector. */
#define OPERATION_normalise3(X, ...) \
    X(normalise3, direction, 3, 3, function, 1, nonzero_vector, __VA_ARGS__)
/* -a. */
#define OPERATION_negate(X, ...) \
    X(negate, unary, 1, 1, ring, 0, everywhere, __VA_ARGS__)
/* |a|. */
#define OPERATION_abs(X, ...) \
    X(abs, unary, 1, 1, ring, 0, everywhere, __VA_ARGS__)
/* a 2^n, where the count n is an integer, at least 0. */
#define OPERATION_shift_left(X, ...) \
    X(shift_left, shift, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a / 2^n, rounded downward, where the count n is an integer, at least 0. */
#define OPERATION_shift_right(X, ...) \
    X(shift_right, shift, 2, 1, ring, 0, everywhere, __VA_ARGS__)
/* a, in the format of the result. */
#define OPERATION_convert(X, ...) \
    X(convert, conversion, 1, 1, ring, 0, everywhere, __VA_ARGS__)
/* clang-format on */

/* Measured on the device in every format. */
#define MEASURED_OPERATIONS(X, ...)                                                             \
    OPERATION_add(X, __VA_ARGS__) OPERATION_subtract(X, __VA_ARGS__) OPERATION_multiply(        \
        X, __VA_ARGS__) OPERATION_divide(X, __VA_ARGS__) OPERATION_remainder(X, __VA_ARGS__)    \
        OPERATION_sqrt(X, __VA_ARGS__) OPERATION_atan(X, __VA_ARGS__)                           \
            OPERATION_atan2(X, __VA_ARGS__) OPERATION_reciprocal_sqrt(X, __VA_ARGS__)           \
                OPERATION_sin(X, __VA_ARGS__) OPERATION_cos(X, __VA_ARGS__) OPERATION_sincos(   \
                    X, __VA_ARGS__) OPERATION_exp(X, __VA_ARGS__) OPERATION_log(X, __VA_ARGS__) \
                    OPERATION_multiply_add(X, __VA_ARGS__) OPERATION_dot2(X, __VA_ARGS__)       \
                        OPERATION_dot3(X, __VA_ARGS__) OPERATION_length2(X, __VA_ARGS__)        \
                            OPERATION_length3(X, __VA_ARGS__) OPERATION_normalise3(X, __VA_ARGS__)

/* Made of the measured operations: functions of angles, and powers and logarithms. They are also
 * measured on the device, in programs of their own, since the others leave no room in flash. */
#define ANGLE_OPERATIONS(X, ...) \
    OPERATION_tan(X, __VA_ARGS__) OPERATION_asin(X, __VA_ARGS__) OPERATION_acos(X, __VA_ARGS__)
#define UNARY_POWER_OPERATIONS(X, ...)                                                            \
    OPERATION_exp2(X, __VA_ARGS__) OPERATION_expm1(X, __VA_ARGS__) OPERATION_log2(X, __VA_ARGS__) \
        OPERATION_log10(X, __VA_ARGS__) OPERATION_log1p(X, __VA_ARGS__)                           \
            OPERATION_sinh(X, __VA_ARGS__) OPERATION_cosh(X, __VA_ARGS__)                         \
                OPERATION_tanh(X, __VA_ARGS__) OPERATION_cbrt(X, __VA_ARGS__)
#define POWER_OPERATIONS(X, ...) \
    UNARY_POWER_OPERATIONS(X, __VA_ARGS__) OPERATION_pow(X, __VA_ARGS__)
#define ELEMENTARY_OPERATIONS(X, ...) \
    ANGLE_OPERATIONS(X, __VA_ARGS__) POWER_OPERATIONS(X, __VA_ARGS__)

/* The same in every arithmetic, except for overflow: angles in turns and degrees, and operations
 * that are exact or rounded once. They are in programs of their own, too. */
#define AUXILIARY_OPERATIONS(X, ...)                                                               \
    OPERATION_sin_turns(X, __VA_ARGS__) OPERATION_cos_turns(X, __VA_ARGS__)                        \
        OPERATION_sincos_turns(X, __VA_ARGS__) OPERATION_atan2_turns(X, __VA_ARGS__)               \
            OPERATION_sin_degrees(X, __VA_ARGS__) OPERATION_cos_degrees(X, __VA_ARGS__)            \
                OPERATION_sincos_degrees(X, __VA_ARGS__) OPERATION_atan2_degrees(X, __VA_ARGS__)   \
                    OPERATION_divrem(X, __VA_ARGS__) OPERATION_divmod(X, __VA_ARGS__)              \
                        OPERATION_lerp(X, __VA_ARGS__) OPERATION_smoothstep(X, __VA_ARGS__)        \
                            OPERATION_midpoint(X, __VA_ARGS__) OPERATION_abs_diff(X, __VA_ARGS__)  \
                                OPERATION_copysign(X, __VA_ARGS__) OPERATION_power(X, __VA_ARGS__) \
                                    OPERATION_sign(X, __VA_ARGS__) OPERATION_isqrt(X, __VA_ARGS__)

/* All. */
#define OPERATIONS(X, ...)                                                               \
    MEASURED_OPERATIONS(X, __VA_ARGS__)                                                  \
    ELEMENTARY_OPERATIONS(X, __VA_ARGS__)                                                \
    AUXILIARY_OPERATIONS(X, __VA_ARGS__)                                                 \
    OPERATION_negate(X, __VA_ARGS__) OPERATION_abs(X, __VA_ARGS__) OPERATION_shift_left( \
        X, __VA_ARGS__) OPERATION_shift_right(X, __VA_ARGS__) OPERATION_convert(X, __VA_ARGS__)

#ifdef __cplusplus
namespace reference {
#define OPERATION_NAME(name, ...) name,
enum class Operation : unsigned char { OPERATIONS(OPERATION_NAME) };
#undef OPERATION_NAME
}  // namespace reference
#endif

#endif
