/* SPDX-License-Identifier: MIT
 * DO NOT EDIT: written by python3 fixedpoint/tables/functions.py */
/// \file
/// The library for C, and for every language that can call C: each operation is a function on
/// plain integers. A number of Q16.16 is an int32_t, value = raw / 2^16; q16_16 names that type.
///
/// An "ulp" is the distance between adjacent numbers; a "faithful" result errs by less than 0.75
/// ulp. Compare numbers with the operators of C. On an AVR with a multiplier, a function that has
/// an assembly kernel is that kernel. All other functions are in fixedpoint_c.cpp: link the library
/// that CMake builds from it, or compile it with the program. Define FIXEDPOINT_NO_ASSEMBLY for
/// both to turn the kernels off.
#ifndef FIXEDPOINT_C_H
#define FIXEDPOINT_C_H

/* clang-format off */
#include <stddef.h>
#include <stdint.h>

#ifndef FIXEDPOINT_C_KERNEL
#if defined(__AVR__) && defined(__AVR_HAVE_MUL__) && !defined(FIXEDPOINT_NO_ASSEMBLY)
#define FIXEDPOINT_C_KERNEL(symbol) __asm__(#symbol)
#else
#define FIXEDPOINT_C_KERNEL(symbol)
#endif
#endif

/// \cond internal
/* n 2^F / d rounded to nearest, half up, as an integer constant expression. */
#define FIXEDPOINT_C_FLOOR(p, q) ((p) / (q) - ((p) % (q) < 0))
#define FIXEDPOINT_C_RATIO(n, d, F) \
    FIXEDPOINT_C_FLOOR((int64_t)(n) * (INT64_C(2) << (F)) + (d), INT64_C(2) * (d))
/// \endcond

#ifdef __cplusplus
extern "C" {
#endif

/// What a parse function reports: one of the four values below.
typedef uint8_t fixedpoint_text_status;
/// The text is a number in the range.
#define FIXEDPOINT_TEXT_OK 0
/// The text is empty.
#define FIXEDPOINT_TEXT_EMPTY 1
/// The text is not a decimal number.
#define FIXEDPOINT_TEXT_MALFORMED 2
/// The text is a decimal number outside the range of the format.
#define FIXEDPOINT_TEXT_OUT_OF_RANGE 3

/* Q4.4 */

/// A number of Q4.4: raw / 2^4, from -2^3 to 2^3 - 2^-4.
typedef int8_t q4_4;
/// The largest number.
#define Q4_4_MAX INT8_MAX
/// The smallest number.
#define Q4_4_MIN INT8_MIN
/// The number 1.
#define Q4_4_ONE ((q4_4)(INT64_C(1) << 4))
/// The constant n / d of two integers, rounded to nearest, half up: Q4_4_RATIO(38, 100) is 0.38. d
/// must be in 1..2^30, n in -2^29..2^29, and the quotient in range.
#define Q4_4_RATIO(n, d) ((q4_4)FIXEDPOINT_C_RATIO(n, d, 4))
/// The capacity that is enough for the text of every number, including its terminating zero.
#define Q4_4_TEXT_CAPACITY 8
/// a + b modulo 2^4: a sum out of range wraps.
q4_4 q4_4_add(q4_4 a, q4_4 b);
/// a - b modulo 2^4: a difference out of range wraps.
q4_4 q4_4_subtract(q4_4 a, q4_4 b);
/// -a; Q4_4_MIN stays Q4_4_MIN.
q4_4 q4_4_negate(q4_4 a);
/// |a|; Q4_4_MIN stays Q4_4_MIN.
q4_4 q4_4_abs(q4_4 a);
/// a b rounded to nearest, half up, modulo 2^4: a product out of range wraps.
q4_4 q4_4_multiply(q4_4 a, q4_4 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_q4_4);
/// a b + c rounded once, to nearest, half up, modulo 2^4.
q4_4 q4_4_multiply_add(q4_4 a, q4_4 b, q4_4 c);
/// a / b rounded to nearest, half up, saturated to Q4_4_MIN and Q4_4_MAX. If b is 0: Q4_4_MAX if a
/// > 0, Q4_4_MIN if a < 0, 0 if a is 0.
q4_4 q4_4_divide(q4_4 a, q4_4 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_divide_q4_4);
/// a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0.
q4_4 q4_4_remainder(q4_4 a, q4_4 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_remainder_q4_4);
/// a 2^count modulo 2^4; 0 from count = 8 on.
q4_4 q4_4_shift_left(q4_4 a, uint8_t count);
/// a / 2^count rounded downward; from count = 8 on 0, or -1 ulp if a < 0.
q4_4 q4_4_shift_right(q4_4 a, uint8_t count);
/// The square root rounded to nearest; 0 if a < 0.
q4_4 q4_4_sqrt(q4_4 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_sqrt_q4_4);
/// 1 / sqrt(a), faithful, saturated to Q4_4_MAX; Q4_4_MAX if a is 0, and 0 if a < 0.
q4_4 q4_4_reciprocal_sqrt(q4_4 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_reciprocal_sqrt_q4_4);
/// The sine of any angle in radians, faithful, never outside [-1, 1].
q4_4 q4_4_sin(q4_4 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_sin_q4_4);
/// The cosine of any angle in radians, faithful, never outside [-1, 1].
q4_4 q4_4_cos(q4_4 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_cos_q4_4);
/// Writes what sin and cos return, in that order, in less time than two calls.
void q4_4_sincos(q4_4 angle, q4_4 sine_and_cosine[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_sincos_q4_4);
/// The arc tangent in radians, faithful.
q4_4 q4_4_atan(q4_4 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan_q4_4);
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0.
q4_4 q4_4_atan2(q4_4 y, q4_4 x);
/// e^a, faithful, saturated to Q4_4_MAX; it may be 0 if e^a is below 0.75 ulp.
q4_4 q4_4_exp(q4_4 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_exp_q4_4);
/// The natural logarithm, faithful; Q4_4_MIN if a <= 0.
q4_4 q4_4_log(q4_4 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log_q4_4);
/// The tangent of any angle in radians, faithful, saturated near a pole.
q4_4 q4_4_tan(q4_4 angle);
/// The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q4_4 q4_4_asin(q4_4 a);
/// The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q4_4 q4_4_acos(q4_4 a);
/// 2^a, faithful, saturated to Q4_4_MAX.
q4_4 q4_4_exp2(q4_4 a);
/// e^a - 1, faithful, saturated to Q4_4_MAX.
q4_4 q4_4_expm1(q4_4 a);
/// The logarithm to base 2, faithful, exact for powers of 2; Q4_4_MIN if a <= 0.
q4_4 q4_4_log2(q4_4 a);
/// The logarithm to base 10, faithful; Q4_4_MIN if a <= 0.
q4_4 q4_4_log10(q4_4 a);
/// ln(1 + a), faithful; Q4_4_MIN if a <= -1.
q4_4 q4_4_log1p(q4_4 a);
/// The hyperbolic sine, faithful, saturated.
q4_4 q4_4_sinh(q4_4 a);
/// The hyperbolic cosine, faithful, saturated to Q4_4_MAX.
q4_4 q4_4_cosh(q4_4 a);
/// The hyperbolic tangent, faithful, never outside [-1, 1].
q4_4 q4_4_tanh(q4_4 a);
/// The cube root, faithful, negative if a is.
q4_4 q4_4_cbrt(q4_4 a);
/// x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or Q4_4_MAX if y < 0. If x < 0:
/// the power of |x|, negated if y is odd, and 0 if y is not an integer.
q4_4 q4_4_pow(q4_4 x, q4_4 y);
/// The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q4_4 q4_4_sin_turns(q4_4 angle);
/// The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q4_4 q4_4_cos_turns(q4_4 angle);
/// Writes what sin_turns and cos_turns return, in that order.
void q4_4_sincos_turns(q4_4 angle, q4_4 sine_and_cosine[2]);
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0.
q4_4 q4_4_atan2_turns(q4_4 y, q4_4 x);
/// The sine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q4_4 q4_4_sin_degrees(q4_4 angle);
/// The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q4_4 q4_4_cos_degrees(q4_4 angle);
/// Writes what sin_degrees and cos_degrees return, in that order.
void q4_4_sincos_degrees(q4_4 angle, q4_4 sine_and_cosine[2]);
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if both are
/// 0.
q4_4 q4_4_atan2_degrees(q4_4 y, q4_4 x);
/// Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is
/// 0 or has the sign of a. If b is 0, the quotient is Q4_4_MAX if a > 0, Q4_4_MIN if a < 0, 0 if a
/// is 0, and the remainder is a.
void q4_4_divrem(q4_4 a, q4_4 b, q4_4 quotient_and_remainder[2]);
/// Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is
/// 0 or has the sign of b. If b is 0, the results are those of divrem.
void q4_4_divmod(q4_4 a, q4_4 b, q4_4 quotient_and_remainder[2]);
/// a + t (b - a) rounded once, to nearest, half up, modulo 2^4; for t in [0, 1] between a and b.
q4_4 q4_4_lerp(q4_4 a, q4_4 b, q4_4 t);
/// 3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1.
q4_4 q4_4_smoothstep(q4_4 t);
/// (a + b) / 2 rounded to nearest, half up. No intermediate sum overflows.
q4_4 q4_4_midpoint(q4_4 a, q4_4 b);
/// |a - b| modulo 2^4.
q4_4 q4_4_abs_diff(q4_4 a, q4_4 b);
/// -1, 0 or 1 if a is negative, zero or positive.
int8_t q4_4_sign(q4_4 a);
/// floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0.
int8_t q4_4_isqrt(int8_t n);
/// |a| with the sign of b, where 0 counts as positive; Q4_4_MIN if a is Q4_4_MIN.
q4_4 q4_4_copysign(q4_4 a, q4_4 b);
/// x^n, faithful, saturated; 1 if n is 0, and Q4_4_MAX if x is 0 and n < 0.
q4_4 q4_4_power(q4_4 x, int32_t n);
/// a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^4.
q4_4 q4_4_dot2(const q4_4 a[2], const q4_4 b[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot2_q4_4);
/// a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^4.
q4_4 q4_4_dot3(const q4_4 a[3], const q4_4 b[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot3_q4_4);
/// The length of v rounded to nearest, saturated to Q4_4_MAX. No square overflows.
q4_4 q4_4_length2(const q4_4 v[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_length2_q4_4);
/// The length of v rounded to nearest, saturated to Q4_4_MAX. No square overflows.
q4_4 q4_4_length3(const q4_4 v[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_length3_q4_4);
/// Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero.
/// `unit` may be `v`.
void q4_4_normalise3(const q4_4 v[3], q4_4 unit[3]);
/// The number n modulo 2^4: n itself if the format can represent it.
q4_4 q4_4_from_int32(int32_t n);
/// The integer nearest to a, half up.
int32_t q4_4_to_int32(q4_4 a);
/// x rounded to nearest, half up, saturated to Q4_4_MIN and Q4_4_MAX; 0 if x is NaN.
q4_4 q4_4_from_float(float x);
/// The float nearest to a, half to even.
float q4_4_to_float(q4_4 a);
/// Reads zero-terminated text: an optional sign, digits with an optional point, an optional
/// exponent, and nothing else. Writes the number, rounded to nearest, half up; Q4_4_MIN or Q4_4_MAX
/// if it is out of range, and 0 if the text is not a number. The status returned says which.
fixedpoint_text_status q4_4_parse(const char* text, q4_4* number);
/// Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its
/// length without the zero. A `capacity` of Q4_4_TEXT_CAPACITY is always enough. If the text does
/// not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0.
size_t q4_4_print(q4_4 a, char* text, size_t capacity);
/// As print, with that many decimals, rounded to nearest, half up; more than 4 count as 4, which
/// are exact.
size_t q4_4_print_decimals(q4_4 a, uint8_t decimals, char* text, size_t capacity);
#ifndef __AVR__  /* whose double is a float */
/// As q4_4_from_float.
q4_4 q4_4_from_double(double x);
/// The double nearest to a, half to even.
double q4_4_to_double(q4_4 a);
#endif

/* Q8.8 */

/// A number of Q8.8: raw / 2^8, from -2^7 to 2^7 - 2^-8.
typedef int16_t q8_8;
/// The largest number.
#define Q8_8_MAX INT16_MAX
/// The smallest number.
#define Q8_8_MIN INT16_MIN
/// The number 1.
#define Q8_8_ONE ((q8_8)(INT64_C(1) << 8))
/// The constant n / d of two integers, rounded to nearest, half up: Q8_8_RATIO(38, 100) is 0.38. d
/// must be in 1..2^30, n in -2^29..2^29, and the quotient in range.
#define Q8_8_RATIO(n, d) ((q8_8)FIXEDPOINT_C_RATIO(n, d, 8))
/// The capacity that is enough for the text of every number, including its terminating zero.
#define Q8_8_TEXT_CAPACITY 14
/// a + b modulo 2^8: a sum out of range wraps.
q8_8 q8_8_add(q8_8 a, q8_8 b);
/// a - b modulo 2^8: a difference out of range wraps.
q8_8 q8_8_subtract(q8_8 a, q8_8 b);
/// -a; Q8_8_MIN stays Q8_8_MIN.
q8_8 q8_8_negate(q8_8 a);
/// |a|; Q8_8_MIN stays Q8_8_MIN.
q8_8 q8_8_abs(q8_8 a);
/// a b rounded to nearest, half up, modulo 2^8: a product out of range wraps.
q8_8 q8_8_multiply(q8_8 a, q8_8 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_q8_8);
/// a b + c rounded once, to nearest, half up, modulo 2^8.
q8_8 q8_8_multiply_add(q8_8 a, q8_8 b, q8_8 c);
/// a / b rounded to nearest, half up, saturated to Q8_8_MIN and Q8_8_MAX. If b is 0: Q8_8_MAX if a
/// > 0, Q8_8_MIN if a < 0, 0 if a is 0.
q8_8 q8_8_divide(q8_8 a, q8_8 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_divide_q8_8);
/// a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0.
q8_8 q8_8_remainder(q8_8 a, q8_8 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_remainder_q8_8);
/// a 2^count modulo 2^8; 0 from count = 16 on.
q8_8 q8_8_shift_left(q8_8 a, uint8_t count);
/// a / 2^count rounded downward; from count = 16 on 0, or -1 ulp if a < 0.
q8_8 q8_8_shift_right(q8_8 a, uint8_t count);
/// The square root rounded to nearest; 0 if a < 0.
q8_8 q8_8_sqrt(q8_8 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_sqrt_q8_8);
/// 1 / sqrt(a), faithful, saturated to Q8_8_MAX; Q8_8_MAX if a is 0, and 0 if a < 0.
q8_8 q8_8_reciprocal_sqrt(q8_8 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_reciprocal_sqrt_q8_8);
/// The sine of any angle in radians, faithful, never outside [-1, 1].
q8_8 q8_8_sin(q8_8 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_sin_q8_8);
/// The cosine of any angle in radians, faithful, never outside [-1, 1].
q8_8 q8_8_cos(q8_8 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_cos_q8_8);
/// Writes what sin and cos return, in that order, in less time than two calls.
void q8_8_sincos(q8_8 angle, q8_8 sine_and_cosine[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_sincos_q8_8);
/// The arc tangent in radians, faithful.
q8_8 q8_8_atan(q8_8 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan_q8_8);
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0.
q8_8 q8_8_atan2(q8_8 y, q8_8 x)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan2_q8_8);
/// e^a, faithful, saturated to Q8_8_MAX; it may be 0 if e^a is below 0.75 ulp.
q8_8 q8_8_exp(q8_8 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_exp_q8_8);
/// The natural logarithm, faithful; Q8_8_MIN if a <= 0.
q8_8 q8_8_log(q8_8 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log_q8_8);
/// The tangent of any angle in radians, faithful, saturated near a pole.
q8_8 q8_8_tan(q8_8 angle);
/// The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q8_8 q8_8_asin(q8_8 a);
/// The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q8_8 q8_8_acos(q8_8 a);
/// 2^a, faithful, saturated to Q8_8_MAX.
q8_8 q8_8_exp2(q8_8 a);
/// e^a - 1, faithful, saturated to Q8_8_MAX.
q8_8 q8_8_expm1(q8_8 a);
/// The logarithm to base 2, faithful, exact for powers of 2; Q8_8_MIN if a <= 0.
q8_8 q8_8_log2(q8_8 a);
/// The logarithm to base 10, faithful; Q8_8_MIN if a <= 0.
q8_8 q8_8_log10(q8_8 a);
/// ln(1 + a), faithful; Q8_8_MIN if a <= -1.
q8_8 q8_8_log1p(q8_8 a);
/// The hyperbolic sine, faithful, saturated.
q8_8 q8_8_sinh(q8_8 a);
/// The hyperbolic cosine, faithful, saturated to Q8_8_MAX.
q8_8 q8_8_cosh(q8_8 a);
/// The hyperbolic tangent, faithful, never outside [-1, 1].
q8_8 q8_8_tanh(q8_8 a);
/// The cube root, faithful, negative if a is.
q8_8 q8_8_cbrt(q8_8 a);
/// x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or Q8_8_MAX if y < 0. If x < 0:
/// the power of |x|, negated if y is odd, and 0 if y is not an integer.
q8_8 q8_8_pow(q8_8 x, q8_8 y);
/// The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q8_8 q8_8_sin_turns(q8_8 angle);
/// The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q8_8 q8_8_cos_turns(q8_8 angle);
/// Writes what sin_turns and cos_turns return, in that order.
void q8_8_sincos_turns(q8_8 angle, q8_8 sine_and_cosine[2]);
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0.
q8_8 q8_8_atan2_turns(q8_8 y, q8_8 x);
/// The sine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q8_8 q8_8_sin_degrees(q8_8 angle);
/// The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q8_8 q8_8_cos_degrees(q8_8 angle);
/// Writes what sin_degrees and cos_degrees return, in that order.
void q8_8_sincos_degrees(q8_8 angle, q8_8 sine_and_cosine[2]);
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if both are
/// 0.
q8_8 q8_8_atan2_degrees(q8_8 y, q8_8 x);
/// Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is
/// 0 or has the sign of a. If b is 0, the quotient is Q8_8_MAX if a > 0, Q8_8_MIN if a < 0, 0 if a
/// is 0, and the remainder is a.
void q8_8_divrem(q8_8 a, q8_8 b, q8_8 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divrem_q8_8);
/// Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is
/// 0 or has the sign of b. If b is 0, the results are those of divrem.
void q8_8_divmod(q8_8 a, q8_8 b, q8_8 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divmod_q8_8);
/// a + t (b - a) rounded once, to nearest, half up, modulo 2^8; for t in [0, 1] between a and b.
q8_8 q8_8_lerp(q8_8 a, q8_8 b, q8_8 t);
/// 3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1.
q8_8 q8_8_smoothstep(q8_8 t);
/// (a + b) / 2 rounded to nearest, half up. No intermediate sum overflows.
q8_8 q8_8_midpoint(q8_8 a, q8_8 b);
/// |a - b| modulo 2^8.
q8_8 q8_8_abs_diff(q8_8 a, q8_8 b);
/// -1, 0 or 1 if a is negative, zero or positive.
int8_t q8_8_sign(q8_8 a);
/// floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0.
int16_t q8_8_isqrt(int16_t n);
/// |a| with the sign of b, where 0 counts as positive; Q8_8_MIN if a is Q8_8_MIN.
q8_8 q8_8_copysign(q8_8 a, q8_8 b);
/// x^n, faithful, saturated; 1 if n is 0, and Q8_8_MAX if x is 0 and n < 0.
q8_8 q8_8_power(q8_8 x, int32_t n);
/// a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^8.
q8_8 q8_8_dot2(const q8_8 a[2], const q8_8 b[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot2_q8_8);
/// a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^8.
q8_8 q8_8_dot3(const q8_8 a[3], const q8_8 b[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot3_q8_8);
/// The length of v rounded to nearest, saturated to Q8_8_MAX. No square overflows.
q8_8 q8_8_length2(const q8_8 v[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_length2_q8_8);
/// The length of v rounded to nearest, saturated to Q8_8_MAX. No square overflows.
q8_8 q8_8_length3(const q8_8 v[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_length3_q8_8);
/// Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero.
/// `unit` may be `v`.
void q8_8_normalise3(const q8_8 v[3], q8_8 unit[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_normalise3_q8_8);
/// The number n modulo 2^8: n itself if the format can represent it.
q8_8 q8_8_from_int32(int32_t n);
/// The integer nearest to a, half up.
int32_t q8_8_to_int32(q8_8 a);
/// x rounded to nearest, half up, saturated to Q8_8_MIN and Q8_8_MAX; 0 if x is NaN.
q8_8 q8_8_from_float(float x);
/// The float nearest to a, half to even.
float q8_8_to_float(q8_8 a);
/// Reads zero-terminated text: an optional sign, digits with an optional point, an optional
/// exponent, and nothing else. Writes the number, rounded to nearest, half up; Q8_8_MIN or Q8_8_MAX
/// if it is out of range, and 0 if the text is not a number. The status returned says which.
fixedpoint_text_status q8_8_parse(const char* text, q8_8* number);
/// Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its
/// length without the zero. A `capacity` of Q8_8_TEXT_CAPACITY is always enough. If the text does
/// not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0.
size_t q8_8_print(q8_8 a, char* text, size_t capacity);
/// As print, with that many decimals, rounded to nearest, half up; more than 8 count as 8, which
/// are exact.
size_t q8_8_print_decimals(q8_8 a, uint8_t decimals, char* text, size_t capacity);
#ifndef __AVR__  /* whose double is a float */
/// As q8_8_from_float.
q8_8 q8_8_from_double(double x);
/// The double nearest to a, half to even.
double q8_8_to_double(q8_8 a);
#endif

/* Q16.16 */

/// A number of Q16.16: raw / 2^16, from -2^15 to 2^15 - 2^-16.
typedef int32_t q16_16;
/// The largest number.
#define Q16_16_MAX INT32_MAX
/// The smallest number.
#define Q16_16_MIN INT32_MIN
/// The number 1.
#define Q16_16_ONE ((q16_16)(INT64_C(1) << 16))
/// The constant n / d of two integers, rounded to nearest, half up: Q16_16_RATIO(38, 100) is 0.38.
/// d must be in 1..2^30, n in -2^29..2^29, and the quotient in range.
#define Q16_16_RATIO(n, d) ((q16_16)FIXEDPOINT_C_RATIO(n, d, 16))
/// The capacity that is enough for the text of every number, including its terminating zero.
#define Q16_16_TEXT_CAPACITY 24
/// a + b modulo 2^16: a sum out of range wraps.
q16_16 q16_16_add(q16_16 a, q16_16 b);
/// a - b modulo 2^16: a difference out of range wraps.
q16_16 q16_16_subtract(q16_16 a, q16_16 b);
/// -a; Q16_16_MIN stays Q16_16_MIN.
q16_16 q16_16_negate(q16_16 a);
/// |a|; Q16_16_MIN stays Q16_16_MIN.
q16_16 q16_16_abs(q16_16 a);
/// a b rounded to nearest, half up, modulo 2^16: a product out of range wraps.
q16_16 q16_16_multiply(q16_16 a, q16_16 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_q16_16);
/// a b + c rounded once, to nearest, half up, modulo 2^16.
q16_16 q16_16_multiply_add(q16_16 a, q16_16 b, q16_16 c)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_add_q16_16);
/// a / b rounded to nearest, half up, saturated to Q16_16_MIN and Q16_16_MAX. If b is 0: Q16_16_MAX
/// if a > 0, Q16_16_MIN if a < 0, 0 if a is 0.
q16_16 q16_16_divide(q16_16 a, q16_16 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_divide_q16_16);
/// a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0.
q16_16 q16_16_remainder(q16_16 a, q16_16 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_remainder_q16_16);
/// a 2^count modulo 2^16; 0 from count = 32 on.
q16_16 q16_16_shift_left(q16_16 a, uint8_t count);
/// a / 2^count rounded downward; from count = 32 on 0, or -1 ulp if a < 0.
q16_16 q16_16_shift_right(q16_16 a, uint8_t count);
/// The square root rounded to nearest; 0 if a < 0.
q16_16 q16_16_sqrt(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_sqrt_q16_16);
/// 1 / sqrt(a), faithful, saturated to Q16_16_MAX; Q16_16_MAX if a is 0, and 0 if a < 0.
q16_16 q16_16_reciprocal_sqrt(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_reciprocal_sqrt_q16_16);
/// The sine of any angle in radians, faithful, never outside [-1, 1].
q16_16 q16_16_sin(q16_16 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_sin_q16_16);
/// The cosine of any angle in radians, faithful, never outside [-1, 1].
q16_16 q16_16_cos(q16_16 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_cos_q16_16);
/// Writes what sin and cos return, in that order, in less time than two calls.
void q16_16_sincos(q16_16 angle, q16_16 sine_and_cosine[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_sincos_q16_16);
/// The arc tangent in radians, faithful.
q16_16 q16_16_atan(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan_q16_16);
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0.
q16_16 q16_16_atan2(q16_16 y, q16_16 x)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan2_q16_16);
/// e^a, faithful, saturated to Q16_16_MAX; it may be 0 if e^a is below 0.75 ulp.
q16_16 q16_16_exp(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_exp_q16_16);
/// The natural logarithm, faithful; Q16_16_MIN if a <= 0.
q16_16 q16_16_log(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log_q16_16);
/// The tangent of any angle in radians, faithful, saturated near a pole.
q16_16 q16_16_tan(q16_16 angle);
/// The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q16_16 q16_16_asin(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_asin_q16_16);
/// The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q16_16 q16_16_acos(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_acos_q16_16);
/// 2^a, faithful, saturated to Q16_16_MAX.
q16_16 q16_16_exp2(q16_16 a);
/// e^a - 1, faithful, saturated to Q16_16_MAX.
q16_16 q16_16_expm1(q16_16 a);
/// The logarithm to base 2, faithful, exact for powers of 2; Q16_16_MIN if a <= 0.
q16_16 q16_16_log2(q16_16 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log2_q16_16);
/// The logarithm to base 10, faithful; Q16_16_MIN if a <= 0.
q16_16 q16_16_log10(q16_16 a);
/// ln(1 + a), faithful; Q16_16_MIN if a <= -1.
q16_16 q16_16_log1p(q16_16 a);
/// The hyperbolic sine, faithful, saturated.
q16_16 q16_16_sinh(q16_16 a);
/// The hyperbolic cosine, faithful, saturated to Q16_16_MAX.
q16_16 q16_16_cosh(q16_16 a);
/// The hyperbolic tangent, faithful, never outside [-1, 1].
q16_16 q16_16_tanh(q16_16 a);
/// The cube root, faithful, negative if a is.
q16_16 q16_16_cbrt(q16_16 a);
/// x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or Q16_16_MAX if y < 0. If x <
/// 0: the power of |x|, negated if y is odd, and 0 if y is not an integer.
q16_16 q16_16_pow(q16_16 x, q16_16 y);
/// The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q16_16 q16_16_sin_turns(q16_16 angle);
/// The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q16_16 q16_16_cos_turns(q16_16 angle);
/// Writes what sin_turns and cos_turns return, in that order.
void q16_16_sincos_turns(q16_16 angle, q16_16 sine_and_cosine[2]);
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0.
q16_16 q16_16_atan2_turns(q16_16 y, q16_16 x);
/// The sine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q16_16 q16_16_sin_degrees(q16_16 angle);
/// The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q16_16 q16_16_cos_degrees(q16_16 angle);
/// Writes what sin_degrees and cos_degrees return, in that order.
void q16_16_sincos_degrees(q16_16 angle, q16_16 sine_and_cosine[2]);
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if both are
/// 0.
q16_16 q16_16_atan2_degrees(q16_16 y, q16_16 x);
/// Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is
/// 0 or has the sign of a. If b is 0, the quotient is Q16_16_MAX if a > 0, Q16_16_MIN if a < 0, 0
/// if a is 0, and the remainder is a.
void q16_16_divrem(q16_16 a, q16_16 b, q16_16 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divrem_q16_16);
/// Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is
/// 0 or has the sign of b. If b is 0, the results are those of divrem.
void q16_16_divmod(q16_16 a, q16_16 b, q16_16 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divmod_q16_16);
/// a + t (b - a) rounded once, to nearest, half up, modulo 2^16; for t in [0, 1] between a and b.
q16_16 q16_16_lerp(q16_16 a, q16_16 b, q16_16 t);
/// 3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1.
q16_16 q16_16_smoothstep(q16_16 t);
/// (a + b) / 2 rounded to nearest, half up. No intermediate sum overflows.
q16_16 q16_16_midpoint(q16_16 a, q16_16 b);
/// |a - b| modulo 2^16.
q16_16 q16_16_abs_diff(q16_16 a, q16_16 b);
/// -1, 0 or 1 if a is negative, zero or positive.
int8_t q16_16_sign(q16_16 a);
/// floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0.
int32_t q16_16_isqrt(int32_t n);
/// |a| with the sign of b, where 0 counts as positive; Q16_16_MIN if a is Q16_16_MIN.
q16_16 q16_16_copysign(q16_16 a, q16_16 b);
/// x^n, faithful, saturated; 1 if n is 0, and Q16_16_MAX if x is 0 and n < 0.
q16_16 q16_16_power(q16_16 x, int32_t n);
/// a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^16.
q16_16 q16_16_dot2(const q16_16 a[2], const q16_16 b[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot2_q16_16);
/// a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^16.
q16_16 q16_16_dot3(const q16_16 a[3], const q16_16 b[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot3_q16_16);
/// The length of v rounded to nearest, saturated to Q16_16_MAX. No square overflows.
q16_16 q16_16_length2(const q16_16 v[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_length2_q16_16);
/// The length of v rounded to nearest, saturated to Q16_16_MAX. No square overflows.
q16_16 q16_16_length3(const q16_16 v[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_length3_q16_16);
/// Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero.
/// `unit` may be `v`.
void q16_16_normalise3(const q16_16 v[3], q16_16 unit[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_normalise3_q16_16);
/// The number n modulo 2^16: n itself if the format can represent it.
q16_16 q16_16_from_int32(int32_t n);
/// The integer nearest to a, half up.
int32_t q16_16_to_int32(q16_16 a);
/// x rounded to nearest, half up, saturated to Q16_16_MIN and Q16_16_MAX; 0 if x is NaN.
q16_16 q16_16_from_float(float x);
/// The float nearest to a, half to even.
float q16_16_to_float(q16_16 a);
/// Reads zero-terminated text: an optional sign, digits with an optional point, an optional
/// exponent, and nothing else. Writes the number, rounded to nearest, half up; Q16_16_MIN or
/// Q16_16_MAX if it is out of range, and 0 if the text is not a number. The status returned says
/// which.
fixedpoint_text_status q16_16_parse(const char* text, q16_16* number);
/// Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its
/// length without the zero. A `capacity` of Q16_16_TEXT_CAPACITY is always enough. If the text does
/// not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0.
size_t q16_16_print(q16_16 a, char* text, size_t capacity);
/// As print, with that many decimals, rounded to nearest, half up; more than 16 count as 16, which
/// are exact.
size_t q16_16_print_decimals(q16_16 a, uint8_t decimals, char* text, size_t capacity);
#ifndef __AVR__  /* whose double is a float */
/// As q16_16_from_float.
q16_16 q16_16_from_double(double x);
/// The double nearest to a, half to even.
double q16_16_to_double(q16_16 a);
#endif

/* Q8.24 */

/// A number of Q8.24: raw / 2^24, from -2^7 to 2^7 - 2^-24.
typedef int32_t q8_24;
/// The largest number.
#define Q8_24_MAX INT32_MAX
/// The smallest number.
#define Q8_24_MIN INT32_MIN
/// The number 1.
#define Q8_24_ONE ((q8_24)(INT64_C(1) << 24))
/// The constant n / d of two integers, rounded to nearest, half up: Q8_24_RATIO(38, 100) is 0.38. d
/// must be in 1..2^30, n in -2^29..2^29, and the quotient in range.
#define Q8_24_RATIO(n, d) ((q8_24)FIXEDPOINT_C_RATIO(n, d, 24))
/// The capacity that is enough for the text of every number, including its terminating zero.
#define Q8_24_TEXT_CAPACITY 30
/// a + b modulo 2^8: a sum out of range wraps.
q8_24 q8_24_add(q8_24 a, q8_24 b);
/// a - b modulo 2^8: a difference out of range wraps.
q8_24 q8_24_subtract(q8_24 a, q8_24 b);
/// -a; Q8_24_MIN stays Q8_24_MIN.
q8_24 q8_24_negate(q8_24 a);
/// |a|; Q8_24_MIN stays Q8_24_MIN.
q8_24 q8_24_abs(q8_24 a);
/// a b rounded to nearest, half up, modulo 2^8: a product out of range wraps.
q8_24 q8_24_multiply(q8_24 a, q8_24 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_q8_24);
/// a b + c rounded once, to nearest, half up, modulo 2^8.
q8_24 q8_24_multiply_add(q8_24 a, q8_24 b, q8_24 c)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_add_q8_24);
/// a / b rounded to nearest, half up, saturated to Q8_24_MIN and Q8_24_MAX. If b is 0: Q8_24_MAX if
/// a > 0, Q8_24_MIN if a < 0, 0 if a is 0.
q8_24 q8_24_divide(q8_24 a, q8_24 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_divide_q8_24);
/// a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0.
q8_24 q8_24_remainder(q8_24 a, q8_24 b);
/// a 2^count modulo 2^8; 0 from count = 32 on.
q8_24 q8_24_shift_left(q8_24 a, uint8_t count);
/// a / 2^count rounded downward; from count = 32 on 0, or -1 ulp if a < 0.
q8_24 q8_24_shift_right(q8_24 a, uint8_t count);
/// The square root rounded to nearest; 0 if a < 0.
q8_24 q8_24_sqrt(q8_24 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_sqrt_q8_24);
/// 1 / sqrt(a), faithful, saturated to Q8_24_MAX; Q8_24_MAX if a is 0, and 0 if a < 0.
q8_24 q8_24_reciprocal_sqrt(q8_24 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_reciprocal_sqrt_q8_24);
/// The sine of any angle in radians, faithful, never outside [-1, 1].
q8_24 q8_24_sin(q8_24 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_sin_q8_24);
/// The cosine of any angle in radians, faithful, never outside [-1, 1].
q8_24 q8_24_cos(q8_24 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_cos_q8_24);
/// Writes what sin and cos return, in that order, in less time than two calls.
void q8_24_sincos(q8_24 angle, q8_24 sine_and_cosine[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_sincos_q8_24);
/// The arc tangent in radians, faithful.
q8_24 q8_24_atan(q8_24 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan_q8_24);
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0.
q8_24 q8_24_atan2(q8_24 y, q8_24 x)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan2_q8_24);
/// e^a, faithful, saturated to Q8_24_MAX; it may be 0 if e^a is below 0.75 ulp.
q8_24 q8_24_exp(q8_24 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_exp_q8_24);
/// The natural logarithm, faithful; Q8_24_MIN if a <= 0.
q8_24 q8_24_log(q8_24 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log_q8_24);
/// The tangent of any angle in radians, faithful, saturated near a pole.
q8_24 q8_24_tan(q8_24 angle);
/// The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q8_24 q8_24_asin(q8_24 a);
/// The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q8_24 q8_24_acos(q8_24 a);
/// 2^a, faithful, saturated to Q8_24_MAX.
q8_24 q8_24_exp2(q8_24 a);
/// e^a - 1, faithful, saturated to Q8_24_MAX.
q8_24 q8_24_expm1(q8_24 a);
/// The logarithm to base 2, faithful, exact for powers of 2; Q8_24_MIN if a <= 0.
q8_24 q8_24_log2(q8_24 a);
/// The logarithm to base 10, faithful; Q8_24_MIN if a <= 0.
q8_24 q8_24_log10(q8_24 a);
/// ln(1 + a), faithful; Q8_24_MIN if a <= -1.
q8_24 q8_24_log1p(q8_24 a);
/// The hyperbolic sine, faithful, saturated.
q8_24 q8_24_sinh(q8_24 a);
/// The hyperbolic cosine, faithful, saturated to Q8_24_MAX.
q8_24 q8_24_cosh(q8_24 a);
/// The hyperbolic tangent, faithful, never outside [-1, 1].
q8_24 q8_24_tanh(q8_24 a);
/// The cube root, faithful, negative if a is.
q8_24 q8_24_cbrt(q8_24 a);
/// x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or Q8_24_MAX if y < 0. If x < 0:
/// the power of |x|, negated if y is odd, and 0 if y is not an integer.
q8_24 q8_24_pow(q8_24 x, q8_24 y);
/// The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q8_24 q8_24_sin_turns(q8_24 angle);
/// The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q8_24 q8_24_cos_turns(q8_24 angle);
/// Writes what sin_turns and cos_turns return, in that order.
void q8_24_sincos_turns(q8_24 angle, q8_24 sine_and_cosine[2]);
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0.
q8_24 q8_24_atan2_turns(q8_24 y, q8_24 x);
/// The sine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q8_24 q8_24_sin_degrees(q8_24 angle);
/// The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q8_24 q8_24_cos_degrees(q8_24 angle);
/// Writes what sin_degrees and cos_degrees return, in that order.
void q8_24_sincos_degrees(q8_24 angle, q8_24 sine_and_cosine[2]);
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if both are
/// 0.
q8_24 q8_24_atan2_degrees(q8_24 y, q8_24 x);
/// Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is
/// 0 or has the sign of a. If b is 0, the quotient is Q8_24_MAX if a > 0, Q8_24_MIN if a < 0, 0 if
/// a is 0, and the remainder is a.
void q8_24_divrem(q8_24 a, q8_24 b, q8_24 quotient_and_remainder[2]);
/// Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is
/// 0 or has the sign of b. If b is 0, the results are those of divrem.
void q8_24_divmod(q8_24 a, q8_24 b, q8_24 quotient_and_remainder[2]);
/// a + t (b - a) rounded once, to nearest, half up, modulo 2^8; for t in [0, 1] between a and b.
q8_24 q8_24_lerp(q8_24 a, q8_24 b, q8_24 t);
/// 3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1.
q8_24 q8_24_smoothstep(q8_24 t);
/// (a + b) / 2 rounded to nearest, half up. No intermediate sum overflows.
q8_24 q8_24_midpoint(q8_24 a, q8_24 b);
/// |a - b| modulo 2^8.
q8_24 q8_24_abs_diff(q8_24 a, q8_24 b);
/// -1, 0 or 1 if a is negative, zero or positive.
int8_t q8_24_sign(q8_24 a);
/// floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0.
int32_t q8_24_isqrt(int32_t n);
/// |a| with the sign of b, where 0 counts as positive; Q8_24_MIN if a is Q8_24_MIN.
q8_24 q8_24_copysign(q8_24 a, q8_24 b);
/// x^n, faithful, saturated; 1 if n is 0, and Q8_24_MAX if x is 0 and n < 0.
q8_24 q8_24_power(q8_24 x, int32_t n);
/// a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^8.
q8_24 q8_24_dot2(const q8_24 a[2], const q8_24 b[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot2_q8_24);
/// a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^8.
q8_24 q8_24_dot3(const q8_24 a[3], const q8_24 b[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot3_q8_24);
/// The length of v rounded to nearest, saturated to Q8_24_MAX. No square overflows.
q8_24 q8_24_length2(const q8_24 v[2]);
/// The length of v rounded to nearest, saturated to Q8_24_MAX. No square overflows.
q8_24 q8_24_length3(const q8_24 v[3]);
/// Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero.
/// `unit` may be `v`.
void q8_24_normalise3(const q8_24 v[3], q8_24 unit[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_normalise3_q8_24);
/// The number n modulo 2^8: n itself if the format can represent it.
q8_24 q8_24_from_int32(int32_t n);
/// The integer nearest to a, half up.
int32_t q8_24_to_int32(q8_24 a);
/// x rounded to nearest, half up, saturated to Q8_24_MIN and Q8_24_MAX; 0 if x is NaN.
q8_24 q8_24_from_float(float x);
/// The float nearest to a, half to even.
float q8_24_to_float(q8_24 a);
/// Reads zero-terminated text: an optional sign, digits with an optional point, an optional
/// exponent, and nothing else. Writes the number, rounded to nearest, half up; Q8_24_MIN or
/// Q8_24_MAX if it is out of range, and 0 if the text is not a number. The status returned says
/// which.
fixedpoint_text_status q8_24_parse(const char* text, q8_24* number);
/// Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its
/// length without the zero. A `capacity` of Q8_24_TEXT_CAPACITY is always enough. If the text does
/// not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0.
size_t q8_24_print(q8_24 a, char* text, size_t capacity);
/// As print, with that many decimals, rounded to nearest, half up; more than 24 count as 24, which
/// are exact.
size_t q8_24_print_decimals(q8_24 a, uint8_t decimals, char* text, size_t capacity);
#ifndef __AVR__  /* whose double is a float */
/// As q8_24_from_float.
q8_24 q8_24_from_double(double x);
/// The double nearest to a, half to even.
double q8_24_to_double(q8_24 a);
#endif

/* Q32.32 */

/// A number of Q32.32: raw / 2^32, from -2^31 to 2^31 - 2^-32.
typedef int64_t q32_32;
/// The largest number.
#define Q32_32_MAX INT64_MAX
/// The smallest number.
#define Q32_32_MIN INT64_MIN
/// The number 1.
#define Q32_32_ONE ((q32_32)(INT64_C(1) << 32))
/// The constant n / d of two integers, rounded to nearest, half up: Q32_32_RATIO(38, 100) is 0.38.
/// d must be in 1..2^30, n in -2^29..2^29, and the quotient in range.
#define Q32_32_RATIO(n, d) ((q32_32)FIXEDPOINT_C_RATIO(n, d, 32))
/// The capacity that is enough for the text of every number, including its terminating zero.
#define Q32_32_TEXT_CAPACITY 45
/// a + b modulo 2^32: a sum out of range wraps.
q32_32 q32_32_add(q32_32 a, q32_32 b);
/// a - b modulo 2^32: a difference out of range wraps.
q32_32 q32_32_subtract(q32_32 a, q32_32 b);
/// -a; Q32_32_MIN stays Q32_32_MIN.
q32_32 q32_32_negate(q32_32 a);
/// |a|; Q32_32_MIN stays Q32_32_MIN.
q32_32 q32_32_abs(q32_32 a);
/// a b rounded to nearest, half up, modulo 2^32: a product out of range wraps.
q32_32 q32_32_multiply(q32_32 a, q32_32 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_multiply_q32_32);
/// a b + c rounded once, to nearest, half up, modulo 2^32.
q32_32 q32_32_multiply_add(q32_32 a, q32_32 b, q32_32 c);
/// a / b rounded to nearest, half up, saturated to Q32_32_MIN and Q32_32_MAX. If b is 0: Q32_32_MAX
/// if a > 0, Q32_32_MIN if a < 0, 0 if a is 0.
q32_32 q32_32_divide(q32_32 a, q32_32 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_divide_q32_32);
/// a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0.
q32_32 q32_32_remainder(q32_32 a, q32_32 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_remainder_q32_32);
/// a 2^count modulo 2^32; 0 from count = 64 on.
q32_32 q32_32_shift_left(q32_32 a, uint8_t count);
/// a / 2^count rounded downward; from count = 64 on 0, or -1 ulp if a < 0.
q32_32 q32_32_shift_right(q32_32 a, uint8_t count);
/// The square root rounded to nearest; 0 if a < 0.
q32_32 q32_32_sqrt(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_sqrt_q32_32);
/// 1 / sqrt(a), faithful, saturated to Q32_32_MAX; Q32_32_MAX if a is 0, and 0 if a < 0.
q32_32 q32_32_reciprocal_sqrt(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_reciprocal_sqrt_q32_32);
/// The sine of any angle in radians, faithful, never outside [-1, 1].
q32_32 q32_32_sin(q32_32 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_sin_q32_32);
/// The cosine of any angle in radians, faithful, never outside [-1, 1].
q32_32 q32_32_cos(q32_32 angle)
    FIXEDPOINT_C_KERNEL(fixedpoint_cos_q32_32);
/// Writes what sin and cos return, in that order, in less time than two calls.
void q32_32_sincos(q32_32 angle, q32_32 sine_and_cosine[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_sincos_q32_32);
/// The arc tangent in radians, faithful.
q32_32 q32_32_atan(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan_q32_32);
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0.
q32_32 q32_32_atan2(q32_32 y, q32_32 x)
    FIXEDPOINT_C_KERNEL(fixedpoint_atan2_q32_32);
/// e^a, faithful, saturated to Q32_32_MAX; it may be 0 if e^a is below 0.75 ulp.
q32_32 q32_32_exp(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_exp_q32_32);
/// The natural logarithm, faithful; Q32_32_MIN if a <= 0.
q32_32 q32_32_log(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_log_q32_32);
/// The tangent of any angle in radians, faithful, saturated near a pole.
q32_32 q32_32_tan(q32_32 angle);
/// The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q32_32 q32_32_asin(q32_32 a);
/// The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the nearer
/// end.
q32_32 q32_32_acos(q32_32 a);
/// 2^a, faithful, saturated to Q32_32_MAX.
q32_32 q32_32_exp2(q32_32 a);
/// e^a - 1, faithful, saturated to Q32_32_MAX.
q32_32 q32_32_expm1(q32_32 a);
/// The logarithm to base 2, faithful, exact for powers of 2; Q32_32_MIN if a <= 0.
q32_32 q32_32_log2(q32_32 a);
/// The logarithm to base 10, faithful; Q32_32_MIN if a <= 0.
q32_32 q32_32_log10(q32_32 a);
/// ln(1 + a), faithful; Q32_32_MIN if a <= -1.
q32_32 q32_32_log1p(q32_32 a);
/// The hyperbolic sine, faithful, saturated.
q32_32 q32_32_sinh(q32_32 a);
/// The hyperbolic cosine, faithful, saturated to Q32_32_MAX.
q32_32 q32_32_cosh(q32_32 a);
/// The hyperbolic tangent, faithful, never outside [-1, 1].
q32_32 q32_32_tanh(q32_32 a);
/// The cube root, faithful, negative if a is.
q32_32 q32_32_cbrt(q32_32 a)
    FIXEDPOINT_C_KERNEL(fixedpoint_cbrt_q32_32);
/// x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or Q32_32_MAX if y < 0. If x <
/// 0: the power of |x|, negated if y is odd, and 0 if y is not an integer.
q32_32 q32_32_pow(q32_32 x, q32_32 y);
/// The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q32_32 q32_32_sin_turns(q32_32 angle);
/// The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1].
q32_32 q32_32_cos_turns(q32_32 angle);
/// Writes what sin_turns and cos_turns return, in that order.
void q32_32_sincos_turns(q32_32 angle, q32_32 sine_and_cosine[2]);
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0.
q32_32 q32_32_atan2_turns(q32_32 y, q32_32 x);
/// The sine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q32_32 q32_32_sin_degrees(q32_32 angle);
/// The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside [-1, 1].
q32_32 q32_32_cos_degrees(q32_32 angle);
/// Writes what sin_degrees and cos_degrees return, in that order.
void q32_32_sincos_degrees(q32_32 angle, q32_32 sine_and_cosine[2]);
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if both are
/// 0.
q32_32 q32_32_atan2_degrees(q32_32 y, q32_32 x);
/// Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is
/// 0 or has the sign of a. If b is 0, the quotient is Q32_32_MAX if a > 0, Q32_32_MIN if a < 0, 0
/// if a is 0, and the remainder is a.
void q32_32_divrem(q32_32 a, q32_32 b, q32_32 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divrem_q32_32);
/// Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is
/// 0 or has the sign of b. If b is 0, the results are those of divrem.
void q32_32_divmod(q32_32 a, q32_32 b, q32_32 quotient_and_remainder[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_divmod_q32_32);
/// a + t (b - a) rounded once, to nearest, half up, modulo 2^32; for t in [0, 1] between a and b.
q32_32 q32_32_lerp(q32_32 a, q32_32 b, q32_32 t);
/// 3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1.
q32_32 q32_32_smoothstep(q32_32 t);
/// (a + b) / 2 rounded to nearest, half up. No intermediate sum overflows.
q32_32 q32_32_midpoint(q32_32 a, q32_32 b);
/// |a - b| modulo 2^32.
q32_32 q32_32_abs_diff(q32_32 a, q32_32 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_abs_diff_q32_32);
/// -1, 0 or 1 if a is negative, zero or positive.
int8_t q32_32_sign(q32_32 a);
/// floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0.
int64_t q32_32_isqrt(int64_t n);
/// |a| with the sign of b, where 0 counts as positive; Q32_32_MIN if a is Q32_32_MIN.
q32_32 q32_32_copysign(q32_32 a, q32_32 b)
    FIXEDPOINT_C_KERNEL(fixedpoint_copysign_q32_32);
/// x^n, faithful, saturated; 1 if n is 0, and Q32_32_MAX if x is 0 and n < 0.
q32_32 q32_32_power(q32_32 x, int32_t n);
/// a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^32.
q32_32 q32_32_dot2(const q32_32 a[2], const q32_32 b[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot2_q32_32);
/// a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^32.
q32_32 q32_32_dot3(const q32_32 a[3], const q32_32 b[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_dot3_q32_32);
/// The length of v rounded to nearest, saturated to Q32_32_MAX. No square overflows.
q32_32 q32_32_length2(const q32_32 v[2])
    FIXEDPOINT_C_KERNEL(fixedpoint_length2_q32_32);
/// The length of v rounded to nearest, saturated to Q32_32_MAX. No square overflows.
q32_32 q32_32_length3(const q32_32 v[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_length3_q32_32);
/// Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero.
/// `unit` may be `v`.
void q32_32_normalise3(const q32_32 v[3], q32_32 unit[3])
    FIXEDPOINT_C_KERNEL(fixedpoint_normalise3_q32_32);
/// The number n modulo 2^32: n itself if the format can represent it.
q32_32 q32_32_from_int32(int32_t n);
/// The integer nearest to a, half up; -2^31 from 2^31 - 1/2 on.
int32_t q32_32_to_int32(q32_32 a);
/// x rounded to nearest, half up, saturated to Q32_32_MIN and Q32_32_MAX; 0 if x is NaN.
q32_32 q32_32_from_float(float x);
/// The float nearest to a, half to even.
float q32_32_to_float(q32_32 a);
/// Reads zero-terminated text: an optional sign, digits with an optional point, an optional
/// exponent, and nothing else. Writes the number, rounded to nearest, half up; Q32_32_MIN or
/// Q32_32_MAX if it is out of range, and 0 if the text is not a number. The status returned says
/// which.
fixedpoint_text_status q32_32_parse(const char* text, q32_32* number);
/// Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its
/// length without the zero. A `capacity` of Q32_32_TEXT_CAPACITY is always enough. If the text does
/// not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0.
size_t q32_32_print(q32_32 a, char* text, size_t capacity);
/// As print, with that many decimals, rounded to nearest, half up; more than 32 count as 32, which
/// are exact.
size_t q32_32_print_decimals(q32_32 a, uint8_t decimals, char* text, size_t capacity);
#ifndef __AVR__  /* whose double is a float */
/// As q32_32_from_float.
q32_32 q32_32_from_double(double x);
/// The double nearest to a, half to even.
double q32_32_to_double(q32_32 a);
#endif

/* From one format to another */

/// a rounded to nearest, half up, modulo 2^4.
q4_4 q4_4_from_q8_8(q8_8 a);
/// a rounded to nearest, half up, modulo 2^4.
q4_4 q4_4_from_q16_16(q16_16 a);
/// a rounded to nearest, half up, modulo 2^4.
q4_4 q4_4_from_q8_24(q8_24 a);
/// a rounded to nearest, half up, modulo 2^4.
q4_4 q4_4_from_q32_32(q32_32 a);
/// a itself: exact.
q8_8 q8_8_from_q4_4(q4_4 a);
/// a rounded to nearest, half up, modulo 2^8.
q8_8 q8_8_from_q16_16(q16_16 a);
/// a rounded to nearest, half up, modulo 2^8.
q8_8 q8_8_from_q8_24(q8_24 a);
/// a rounded to nearest, half up, modulo 2^8.
q8_8 q8_8_from_q32_32(q32_32 a);
/// a itself: exact.
q16_16 q16_16_from_q4_4(q4_4 a);
/// a itself: exact.
q16_16 q16_16_from_q8_8(q8_8 a);
/// a rounded to nearest, half up.
q16_16 q16_16_from_q8_24(q8_24 a);
/// a rounded to nearest, half up, modulo 2^16.
q16_16 q16_16_from_q32_32(q32_32 a);
/// a itself: exact.
q8_24 q8_24_from_q4_4(q4_4 a);
/// a itself: exact.
q8_24 q8_24_from_q8_8(q8_8 a);
/// a modulo 2^8.
q8_24 q8_24_from_q16_16(q16_16 a);
/// a rounded to nearest, half up, modulo 2^8.
q8_24 q8_24_from_q32_32(q32_32 a);
/// a itself: exact.
q32_32 q32_32_from_q4_4(q4_4 a);
/// a itself: exact.
q32_32 q32_32_from_q8_8(q8_8 a);
/// a itself: exact.
q32_32 q32_32_from_q16_16(q16_16 a);
/// a itself: exact.
q32_32 q32_32_from_q8_24(q8_24 a);

#ifdef __cplusplus
}
#endif

/* clang-format on */
#endif
