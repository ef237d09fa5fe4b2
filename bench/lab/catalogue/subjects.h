/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every implementation that is measured, once, with the formats and operations that it has. The
 * subjects of the host and of the device, the device programs, and the names, order and labels in
 * the figures are expanded from these rows. */
#ifndef BENCH_LAB_CATALOGUE_SUBJECTS_H
#define BENCH_LAB_CATALOGUE_SUBJECTS_H

#include "bench/lab/catalogue/formats.h"
#include "reference/operation_table.h"

/* Formats of others, as X(format, raw type, fraction bits, ...). */
#define SINGLE(X, ...) X(float, float, 0, __VA_ARGS__)
#define INTEGERS(X, ...)              \
    X(int8, int8_t, 0, __VA_ARGS__)   \
    X(int16, int16_t, 0, __VA_ARGS__) \
    X(int32, int32_t, 0, __VA_ARGS__) \
    X(int64, int64_t, 0, __VA_ARGS__)
/* GCC's, by integer and fraction bits; the sign bit is not counted. */
#define ACCUMS(X, ...)                      \
    X(s8_7, short _Accum, 7, __VA_ARGS__)   \
    X(s16_15, _Accum, 15, __VA_ARGS__)      \
    X(s32_31, long _Accum, 31, __VA_ARGS__) \
    X(s16_47, long long _Accum, 47, __VA_ARGS__)

#define SUMS_AND_PRODUCTS(X, ...)                                    \
    OPERATION_add(X, __VA_ARGS__) OPERATION_subtract(X, __VA_ARGS__) \
        OPERATION_multiply(X, __VA_ARGS__)
#define OPERATORS(X, ...)             \
    SUMS_AND_PRODUCTS(X, __VA_ARGS__) \
    OPERATION_divide(X, __VA_ARGS__)
#define INTEGER_OPERATORS(X, ...) \
    OPERATORS(X, __VA_ARGS__)     \
    OPERATION_remainder(X, __VA_ARGS__)
#define UNSIGNED_OPERATIONS(X, ...)   \
    INTEGER_OPERATORS(X, __VA_ARGS__) \
    OPERATION_sqrt(X, __VA_ARGS__) OPERATION_multiply_add(X, __VA_ARGS__)
#define UNSIGNED_AUXILIARY_OPERATIONS(X, ...)                                         \
    OPERATION_divrem(X, __VA_ARGS__) OPERATION_divmod(X, __VA_ARGS__) OPERATION_lerp( \
        X, __VA_ARGS__) OPERATION_midpoint(X, __VA_ARGS__) OPERATION_abs_diff(X, __VA_ARGS__)
#define PORTABLE_OPERATIONS(X, ...)                                     \
    OPERATION_multiply(X, __VA_ARGS__) OPERATION_divide(X, __VA_ARGS__) \
        OPERATION_sqrt(X, __VA_ARGS__)
#define PUBLISHED_OPERATIONS(X, ...) \
    OPERATORS(X, __VA_ARGS__)        \
    OPERATION_sqrt(X, __VA_ARGS__) OPERATION_atan2(X, __VA_ARGS__)
#define SMALL_OPERATIONS(X, ...)                                                                   \
    OPERATION_divide(X, __VA_ARGS__) OPERATION_sqrt(X, __VA_ARGS__) OPERATION_atan(X, __VA_ARGS__) \
        OPERATION_atan2(X, __VA_ARGS__) OPERATION_reciprocal_sqrt(X, __VA_ARGS__)                  \
            OPERATION_sin(X, __VA_ARGS__) OPERATION_cos(X, __VA_ARGS__)                            \
                OPERATION_sincos(X, __VA_ARGS__) OPERATION_exp(X, __VA_ARGS__)                     \
                    OPERATION_log(X, __VA_ARGS__)
#define PRODUCTS_AND_QUOTIENTS(X, ...) \
    OPERATION_multiply(X, __VA_ARGS__) OPERATION_divide(X, __VA_ARGS__)
/* Those of CorrectlyRounded that are not the default's. In Q8.24 it does not have atan2 and pow. */
#define CORRECTLY_ROUNDED_UNARY_ANGLES(X, ...)                                                 \
    OPERATION_atan(X, __VA_ARGS__) OPERATION_sin(X, __VA_ARGS__) OPERATION_cos(X, __VA_ARGS__) \
        OPERATION_sincos(X, __VA_ARGS__)
#define CORRECTLY_ROUNDED_ANGLES(X, ...)           \
    CORRECTLY_ROUNDED_UNARY_ANGLES(X, __VA_ARGS__) \
    OPERATION_atan2(X, __VA_ARGS__)
#define CORRECTLY_ROUNDED_POWERS(X, ...)                                    \
    OPERATION_reciprocal_sqrt(X, __VA_ARGS__) OPERATION_exp(X, __VA_ARGS__) \
        OPERATION_log(X, __VA_ARGS__)
#define CORRECTLY_ROUNDED_LENGTHS_AND_POW(X, ...)                       \
    OPERATION_length2(X, __VA_ARGS__) OPERATION_length3(X, __VA_ARGS__) \
        OPERATION_pow(X, __VA_ARGS__)
#define EVERY_UNARY_POWER(X, ...) \
    CORRECTLY_ROUNDED_POWERS(X, __VA_ARGS__) UNARY_POWER_OPERATIONS(X, __VA_ARGS__)

/* X(implementation, policy, provenance, on the host, formats, operations, label)
 *
 * policy       the struct of static member functions that computes; on the device it is used by the
 *              file of that name in bench/device/subjects/
 * provenance   ours and published: each result is held to its definition; rival: the error is
 *              measured and not judged
 * on the host  own: through the same policy; as_default: by definition the default's results; none:
 *              part of the device's toolchain */
/* clang-format off */
#define IMPLEMENTATION_default(X) \
    X(default, Nearest, ours, own, LIBRARY_FORMATS, MEASURED_OPERATIONS, "ours, default")
#define IMPLEMENTATION_angles(X) \
    X(default, Nearest, ours, own, LIBRARY_FORMATS, ANGLE_OPERATIONS, "ours, default")
#define IMPLEMENTATION_powers(X) \
    X(default, Nearest, ours, own, LIBRARY_FORMATS, POWER_OPERATIONS, "ours, default")
#define IMPLEMENTATION_auxiliary(X) \
    X(default, Functions, ours, own, LIBRARY_FORMATS, AUXILIARY_OPERATIONS, "ours, default")
#define IMPLEMENTATION_unsigned(X) \
    X(default, Nearest, ours, own, UNSIGNED_FORMATS, UNSIGNED_OPERATIONS, "ours, default")
#define IMPLEMENTATION_unsigned_auxiliary(X) \
    X(default, Functions, ours, own, UNSIGNED_FORMATS, UNSIGNED_AUXILIARY_OPERATIONS, "ours, default")
#define IMPLEMENTATION_portable(X) \
    X(portable, Portable, ours, as_default, SQUARE_FORMATS, PORTABLE_OPERATIONS, "ours, portable C++")
#define IMPLEMENTATION_published(X) \
    X(published, Published, published, own, SQUARE_FORMATS, PUBLISHED_OPERATIONS, "2016 design")
#define IMPLEMENTATION_saturating(X) \
    X(saturating, Saturating, ours, own, LIBRARY_FORMATS, SUMS_AND_PRODUCTS, "ours, saturating")
#define IMPLEMENTATION_widening(X) \
    X(widening, Widening, ours, as_default, FORMAT_q16_16, OPERATION_divide, "ours, widening")
#define IMPLEMENTATION_small(X) \
    X(small, Small, ours, own, FORMAT_q16_16, SMALL_OPERATIONS, "ours, small tables")
#define IMPLEMENTATION_correctly_rounded_angles(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q16_16, CORRECTLY_ROUNDED_ANGLES, "ours, correctly rounded")
#define IMPLEMENTATION_correctly_rounded_arcs(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q16_16, ANGLE_OPERATIONS, "ours, correctly rounded")
#define IMPLEMENTATION_correctly_rounded_powers(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q16_16, CORRECTLY_ROUNDED_POWERS, "ours, correctly rounded")
#define IMPLEMENTATION_correctly_rounded_exponentials(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q16_16, UNARY_POWER_OPERATIONS, "ours, correctly rounded")
#define IMPLEMENTATION_correctly_rounded_lengths_and_pow(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q16_16, CORRECTLY_ROUNDED_LENGTHS_AND_POW, "ours, correctly rounded")
/* Without the functions that no kernel decides: in Q8.24 their simulation takes too long. */
#define IMPLEMENTATION_correctly_rounded_q8_24_angles(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q8_24, CORRECTLY_ROUNDED_UNARY_ANGLES, "ours, correctly rounded")
#define IMPLEMENTATION_correctly_rounded_q8_24_powers(X) \
    X(correctly_rounded, CorrectlyRounded, ours, own, FORMAT_q8_24, CORRECTLY_ROUNDED_POWERS, "ours, correctly rounded")
#define IMPLEMENTATION_toward_zero(X) \
    X(toward_zero, TowardZero, ours, own, LIBRARY_FORMATS, PRODUCTS_AND_QUOTIENTS, "ours, toward zero")
#define IMPLEMENTATION_downward(X) \
    X(downward, Downward, ours, own, LIBRARY_FORMATS, PRODUCTS_AND_QUOTIENTS, "ours, downward")
#define IMPLEMENTATION_half_to_even(X) \
    X(half_to_even, HalfToEven, ours, own, LIBRARY_FORMATS, PRODUCTS_AND_QUOTIENTS, "ours, half to even")
#define IMPLEMENTATION_libc(X) \
    X(libc, Libc, rival, none, SINGLE, MEASURED_OPERATIONS, "avr-libc float")
#define IMPLEMENTATION_libc_elementary(X) \
    X(libc, Libc, rival, none, SINGLE, ELEMENTARY_OPERATIONS, "avr-libc float")
#define IMPLEMENTATION_libc_auxiliary(X) \
    X(libc, Libc, rival, none, SINGLE, AUXILIARY_OPERATIONS, "avr-libc float")
#define IMPLEMENTATION_accum(X) \
    X(accum, Accum, rival, none, ACCUMS, OPERATORS, "GCC _Accum")
#define IMPLEMENTATION_native(X) \
    X(native, Native, rival, none, INTEGERS, INTEGER_OPERATORS, "plain integer")
/* clang-format on */

#define IMPLEMENTATIONS(X)                                                                        \
    IMPLEMENTATION_default(X) IMPLEMENTATION_angles(X) IMPLEMENTATION_powers(                     \
        X) IMPLEMENTATION_auxiliary(X) IMPLEMENTATION_unsigned(X)                                 \
        IMPLEMENTATION_unsigned_auxiliary(X) IMPLEMENTATION_portable(X) IMPLEMENTATION_published( \
            X) IMPLEMENTATION_saturating(X) IMPLEMENTATION_widening(X) IMPLEMENTATION_small(X)    \
            IMPLEMENTATION_correctly_rounded_angles(X) IMPLEMENTATION_correctly_rounded_arcs(X)   \
                IMPLEMENTATION_correctly_rounded_powers(X)                                        \
                    IMPLEMENTATION_correctly_rounded_exponentials(X)                              \
                        IMPLEMENTATION_correctly_rounded_lengths_and_pow(X)                       \
                            IMPLEMENTATION_correctly_rounded_q8_24_angles(X)                      \
                                IMPLEMENTATION_correctly_rounded_q8_24_powers(X)                  \
                                    IMPLEMENTATION_toward_zero(X) IMPLEMENTATION_downward(X)      \
                                        IMPLEMENTATION_half_to_even(X) IMPLEMENTATION_libc(X)     \
                                            IMPLEMENTATION_libc_elementary(X)                     \
                                                IMPLEMENTATION_libc_auxiliary(X)                  \
                                                    IMPLEMENTATION_accum(X)                       \
                                                        IMPLEMENTATION_native(X)

#endif
