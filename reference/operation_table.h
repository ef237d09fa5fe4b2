/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every operation, once: OPERATION_<name>(X, ...) passes its row to the macro X, further arguments
 * after it. What lists operations expands these rows: the reference, the subjects of the host, and
 * those of the device, whose compilers speak C11 and C++14.
 *
 * X(name, signature, operands, results, kind, bound_ulp, domain, ...)
 *
 * signature  how the function is called (bench/lab/catalogue/invoke.h)
 * operands   how many numbers it takes, and `results` how many it gives. Vectors lie one after the
 *            other: the operands of dot3 are a0 a1 a2 b0 b1 b2. atan2 takes y, x. The second
 * operand of a shift is a count, a plain integer, and that of power an exponent, a raw that stands
 * for itself, as do operand and result of isqrt and the result of sign. The results of sincos are
 * sine and cosine; those of divrem and divmod the quotient, an integer in the raw, and the
 * remainder. kind ring: exact, rounded, then taken modulo 2^W in the
 * wrapping arithmetics, so that sums whose intermediates overflow still come out right; rounded:
 * exact, rounded, clamped; function: within bound_ulp of the exact value, clamped domain     where
 * it has an exact value; what it returns elsewhere stands behind the row
 *
 * Notation: a, b raws of W bits, value = raw / 2^F; x the exact result in units of the last place.
 */
#ifndef REFERENCE_OPERATION_TABLE_H
#define REFERENCE_OPERATION_TABLE_H

/* clang-format off */
#define OPERATION_add(X, ...) /* x = a + b */ \
    X(add, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_subtract(X, ...) /* x = a - b */ \
    X(subtract, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_multiply(X, ...) /* x = a b / 2^F */ \
    X(multiply, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_divide(X, ...) /* x = a 2^F / b; b = 0: MAX if a > 0, MIN if a < 0, 0 if a = 0 */ \
    X(divide, binary, 2, 1, rounded, 0, nonzero_divisor, __VA_ARGS__)
#define OPERATION_remainder(X, ...) /* x = a - b trunc(a / b), exact; b = 0: a */ \
    X(remainder, binary, 2, 1, rounded, 0, nonzero_divisor, __VA_ARGS__)
#define OPERATION_sqrt(X, ...) /* x = sqrt(a 2^F), never a tie; a < 0: 0 */ \
    X(sqrt, unary, 1, 1, rounded, 0, not_negative, __VA_ARGS__)
#define OPERATION_atan(X, ...) \
    X(atan, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_atan2(X, ...) /* in (-pi, pi]; a = b = 0: 0 */ \
    X(atan2, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
#define OPERATION_reciprocal_sqrt(X, ...) /* a = 0: MAX; a < 0: 0 */ \
    X(reciprocal_sqrt, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
#define OPERATION_sin(X, ...) /* any angle; never beyond +-1, which errs by 1 ulp or more */ \
    X(sin, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_cos(X, ...) /* as sin */ \
    X(cos, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_sincos(X, ...) /* of each result */ \
    X(sincos, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_exp(X, ...) /* underflows to 0 by rounding */ \
    X(exp, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_log(X, ...) /* a <= 0: MIN */ \
    X(log, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
#define OPERATION_tan(X, ...) /* any angle; clamps beside a pole */ \
    X(tan, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_asin(X, ...) /* beyond +-1: +-pi/2, rounded */ \
    X(asin, unary, 1, 1, function, 0.75, unit_interval, __VA_ARGS__)
#define OPERATION_acos(X, ...) /* beyond 1: 0; beyond -1: pi, rounded */ \
    X(acos, unary, 1, 1, function, 0.75, unit_interval, __VA_ARGS__)
#define OPERATION_exp2(X, ...) /* 2^a */ \
    X(exp2, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_expm1(X, ...) /* e^a - 1 */ \
    X(expm1, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_log2(X, ...) /* a <= 0: MIN */ \
    X(log2, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
#define OPERATION_log10(X, ...) /* a <= 0: MIN */ \
    X(log10, unary, 1, 1, function, 0.75, positive, __VA_ARGS__)
#define OPERATION_log1p(X, ...) /* ln(1 + a); a <= -1: MIN */ \
    X(log1p, unary, 1, 1, function, 0.75, above_minus_one, __VA_ARGS__)
#define OPERATION_sinh(X, ...) \
    X(sinh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_cosh(X, ...) \
    X(cosh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_tanh(X, ...) \
    X(tanh, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_cbrt(X, ...) /* negative where a is */ \
    X(cbrt, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_pow(X, ...) /* a^b; b = 0: 1; a = 0, b < 0: MAX; a < 0, b no integer: 0 */ \
    X(pow, binary, 2, 1, function, 0.75, power, __VA_ARGS__)
#define OPERATION_sin_turns(X, ...) /* sin(2 pi a), any angle; never beyond +-1 */ \
    X(sin_turns, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_cos_turns(X, ...) /* as sin_turns */ \
    X(cos_turns, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_sincos_turns(X, ...) /* of each result */ \
    X(sincos_turns, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_atan2_turns(X, ...) /* in -1/2..1/2; a = b = 0: 0 */ \
    X(atan2_turns, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
#define OPERATION_sin_degrees(X, ...) /* sin(2 pi a / 360), any angle; never beyond +-1 */ \
    X(sin_degrees, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_cos_degrees(X, ...) /* as sin_degrees */ \
    X(cos_degrees, unary, 1, 1, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_sincos_degrees(X, ...) /* of each result */ \
    X(sincos_degrees, pair, 1, 2, function, 0.75, everywhere, __VA_ARGS__)
#define OPERATION_atan2_degrees(X, ...) /* in -180..180; a = b = 0: 0 */ \
    X(atan2_degrees, binary, 2, 1, function, 0.75, nonzero_vector, __VA_ARGS__)
#define OPERATION_divrem(X, ...) /* trunc(a / b), an integer, and a - b trunc(a / b); b = 0: as divide, and a */ \
    X(divrem, binary_pair, 2, 2, rounded, 0, nonzero_divisor, __VA_ARGS__)
#define OPERATION_divmod(X, ...) /* floor(a / b), an integer, and a - b floor(a / b); b = 0: as divrem */ \
    X(divmod, binary_pair, 2, 2, rounded, 0, nonzero_divisor, __VA_ARGS__)
#define OPERATION_lerp(X, ...) /* x = a + (b - a) c / 2^F, one rounding */ \
    X(lerp, ternary, 3, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_smoothstep(X, ...) /* 3 a^2 - 2 a^3 of a held to 0..1, one rounding */ \
    X(smoothstep, unary, 1, 1, rounded, 0, everywhere, __VA_ARGS__)
#define OPERATION_midpoint(X, ...) /* x = (a + b) / 2 */ \
    X(midpoint, binary, 2, 1, rounded, 0, everywhere, __VA_ARGS__)
#define OPERATION_abs_diff(X, ...) /* x = |a - b| */ \
    X(abs_diff, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_copysign(X, ...) /* x = |a|, negative where b is */ \
    X(copysign, binary, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_power(X, ...) /* a^n, 1 where n = 0; a = 0, n < 0: MAX */ \
    X(power, binary, 2, 1, function, 0.75, integer_power, __VA_ARGS__)
#define OPERATION_sign(X, ...) /* -1, 0 or 1, an integer */ \
    X(sign, unary, 1, 1, rounded, 0, everywhere, __VA_ARGS__)
#define OPERATION_isqrt(X, ...) /* floor(sqrt(a)) of an integer; a < 0: 0 */ \
    X(isqrt, unary, 1, 1, rounded, 0, not_negative, __VA_ARGS__)
#define OPERATION_multiply_add(X, ...) /* x = a b / 2^F + c, one rounding */ \
    X(multiply_add, ternary, 3, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_dot2(X, ...) /* x = sum of a_i b_i / 2^F, one rounding */ \
    X(dot2, dot, 4, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_dot3(X, ...) /* as dot2 */ \
    X(dot3, dot, 6, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_length2(X, ...) /* no overflow of the squares */ \
    X(length2, length, 2, 1, function, 1, everywhere, __VA_ARGS__)
#define OPERATION_length3(X, ...) /* as length2 */ \
    X(length3, length, 3, 1, function, 1, everywhere, __VA_ARGS__)
#define OPERATION_normalise3(X, ...) /* of each component; the zero vector stays zero */ \
    X(normalise3, direction, 3, 3, function, 1, nonzero_vector, __VA_ARGS__)
#define OPERATION_negate(X, ...) /* x = -a */ \
    X(negate, unary, 1, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_abs(X, ...) /* x = |a| */ \
    X(abs, unary, 1, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_shift_left(X, ...) /* x = a 2^n */ \
    X(shift_left, shift, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_shift_right(X, ...) /* x = a / 2^n, rounded downward: an arithmetic shift */ \
    X(shift_right, shift, 2, 1, ring, 0, everywhere, __VA_ARGS__)
#define OPERATION_convert(X, ...) /* x = the value in the result's last places */ \
    X(convert, conversion, 1, 1, ring, 0, everywhere, __VA_ARGS__)
/* clang-format on */

/* Those that are measured on the device in every format. */
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

/* Those made of the first, measured on the device too, in programs of their own: the first do not
 * leave them room. Of angles, and of powers and logarithms. */
#define ANGLE_OPERATIONS(X, ...) \
    OPERATION_tan(X, __VA_ARGS__) OPERATION_asin(X, __VA_ARGS__) OPERATION_acos(X, __VA_ARGS__)
#define POWER_OPERATIONS(X, ...)                                                                  \
    OPERATION_exp2(X, __VA_ARGS__) OPERATION_expm1(X, __VA_ARGS__) OPERATION_log2(X, __VA_ARGS__) \
        OPERATION_log10(X, __VA_ARGS__) OPERATION_log1p(X, __VA_ARGS__)                           \
            OPERATION_sinh(X, __VA_ARGS__) OPERATION_cosh(X, __VA_ARGS__)                         \
                OPERATION_tanh(X, __VA_ARGS__) OPERATION_cbrt(X, __VA_ARGS__)                     \
                    OPERATION_pow(X, __VA_ARGS__)
#define ELEMENTARY_OPERATIONS(X, ...) \
    ANGLE_OPERATIONS(X, __VA_ARGS__) POWER_OPERATIONS(X, __VA_ARGS__)

/* Those that every arithmetic takes from others, in programs of their own too: angles in turns and
 * degrees, and what is exact or rounded once. */
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
