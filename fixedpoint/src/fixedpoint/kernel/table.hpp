// SPDX-License-Identifier: MIT
// The assembly kernels: for each of them, FIXEDPOINT_KERNELS(KERNEL) expands
//     KERNEL(shape, operation, Raw, fraction bits, symbol, implementation)
// `symbol` is the function in avr/ that kernel::operation<Raw, fraction bits> calls instead of
// portable::implementation<Raw, fraction bits>, with the same results. `shape` stands for its
// result and parameters.
#pragma once

// clang-format off
// The result of kernel::operation<Raw, F>, its parameters, and the arguments of a call, by shape.
#define FIXEDPOINT_RESULT_UNARY(Raw) Raw
#define FIXEDPOINT_PARAMETERS_UNARY(Raw) (Raw a)
#define FIXEDPOINT_ARGUMENTS_UNARY (a)
#define FIXEDPOINT_RESULT_BINARY(Raw) Raw
#define FIXEDPOINT_PARAMETERS_BINARY(Raw) (Raw a, Raw b)
#define FIXEDPOINT_ARGUMENTS_BINARY (a, b)
#define FIXEDPOINT_RESULT_TERNARY(Raw) Raw
#define FIXEDPOINT_PARAMETERS_TERNARY(Raw) (Raw a, Raw b, Raw c)
#define FIXEDPOINT_ARGUMENTS_TERNARY (a, b, c)
#define FIXEDPOINT_RESULT_DIVISION(Raw) void
#define FIXEDPOINT_PARAMETERS_DIVISION(Raw) (Raw a, Raw b, Raw* pair)
#define FIXEDPOINT_ARGUMENTS_DIVISION (a, b, pair)
// From one vector and from two vectors; into a pair from a number, and into a vector from a vector.
#define FIXEDPOINT_RESULT_VECTOR(Raw) Raw
#define FIXEDPOINT_PARAMETERS_VECTOR(Raw) (const Raw* v)
#define FIXEDPOINT_ARGUMENTS_VECTOR (v)
#define FIXEDPOINT_RESULT_VECTORS(Raw) Raw
#define FIXEDPOINT_PARAMETERS_VECTORS(Raw) (const Raw* a, const Raw* b)
#define FIXEDPOINT_ARGUMENTS_VECTORS (a, b)
#define FIXEDPOINT_RESULT_PAIR(Raw) void
#define FIXEDPOINT_PARAMETERS_PAIR(Raw) (Raw a, Raw* pair)
#define FIXEDPOINT_ARGUMENTS_PAIR (a, pair)
#define FIXEDPOINT_RESULT_MAPPING(Raw) void
#define FIXEDPOINT_PARAMETERS_MAPPING(Raw) (const Raw* v, Raw* mapped)
#define FIXEDPOINT_ARGUMENTS_MAPPING (v, mapped)
// From a vector and the difference of two others; a scaled vector added to one sum, and moved
// between two.
#define FIXEDPOINT_RESULT_DIFFERENCE(Raw) Raw
#define FIXEDPOINT_PARAMETERS_DIFFERENCE(Raw) (const Raw* n, const Raw* u, const Raw* v)
#define FIXEDPOINT_ARGUMENTS_DIFFERENCE (n, u, v)
#define FIXEDPOINT_RESULT_ADDITION(Raw) void
#define FIXEDPOINT_PARAMETERS_ADDITION(Raw) (Raw* sum, const Raw* v, Raw factor)
#define FIXEDPOINT_ARGUMENTS_ADDITION (sum, v, factor)
#define FIXEDPOINT_RESULT_EXCHANGE(Raw) void
#define FIXEDPOINT_PARAMETERS_EXCHANGE(Raw) (Raw* a, Raw* b, const Raw* v, Raw factor)
#define FIXEDPOINT_ARGUMENTS_EXCHANGE (a, b, v, factor)
// From a matrix of n rows and a vector.
#define FIXEDPOINT_RESULT_TRANSFORM(Raw) void
#define FIXEDPOINT_PARAMETERS_TRANSFORM(Raw) (Raw* result, const Raw* v, const Raw* m, uint8_t n)
#define FIXEDPOINT_ARGUMENTS_TRANSFORM (result, v, m, n)
// From two vectors into a third.
#define FIXEDPOINT_RESULT_OUTER(Raw) void
#define FIXEDPOINT_PARAMETERS_OUTER(Raw) (Raw* result, const Raw* a, const Raw* b)
#define FIXEDPOINT_ARGUMENTS_OUTER (result, a, b)
// From a reduced angle.
#define FIXEDPOINT_RESULT_TURNS(Raw) Raw
#define FIXEDPOINT_PARAMETERS_TURNS(Raw) (uint64_t turns)
#define FIXEDPOINT_ARGUMENTS_TURNS (turns)
// A result scaled by 2^unit, with fraction bits.
#define FIXEDPOINT_RESULT_SCALED(Raw) uint64_t
#define FIXEDPOINT_PARAMETERS_SCALED(Raw) (Raw a, uint8_t unit)
#define FIXEDPOINT_ARGUMENTS_SCALED (a, unit)
// From two words into one of twice the width.
#define FIXEDPOINT_RESULT_WORDS(Raw) uint64_t
#define FIXEDPOINT_PARAMETERS_WORDS(Raw) (Raw a, Raw b)
#define FIXEDPOINT_ARGUMENTS_WORDS (a, b)
// In any format of the width: the fraction bits are an operand.
#define FIXEDPOINT_RESULT_SPLIT_UNARY(Raw) Raw
#define FIXEDPOINT_PARAMETERS_SPLIT_UNARY(Raw) (Raw a, uint8_t fraction)
#define FIXEDPOINT_ARGUMENTS_SPLIT_UNARY (a, fraction)
#define FIXEDPOINT_RESULT_SPLIT_BINARY(Raw) Raw
#define FIXEDPOINT_PARAMETERS_SPLIT_BINARY(Raw) (Raw a, Raw b, uint8_t fraction)
#define FIXEDPOINT_ARGUMENTS_SPLIT_BINARY (a, b, fraction)
#define FIXEDPOINT_RESULT_SPLIT_PAIR(Raw) void
#define FIXEDPOINT_PARAMETERS_SPLIT_PAIR(Raw) (Raw a, Raw* pair, uint8_t fraction)
#define FIXEDPOINT_ARGUMENTS_SPLIT_PAIR (a, pair, fraction)
#define FIXEDPOINT_RESULT_SPLIT_VECTORS(Raw) Raw
#define FIXEDPOINT_PARAMETERS_SPLIT_VECTORS(Raw) (const Raw* a, const Raw* b, uint8_t n, uint8_t fraction)
#define FIXEDPOINT_ARGUMENTS_SPLIT_VECTORS (a, b, n, fraction)
// A power or its reciprocal.
#define FIXEDPOINT_RESULT_POWER(Raw) ::fixedpoint::Unsigned<Raw>
#define FIXEDPOINT_PARAMETERS_POWER(Raw) (::fixedpoint::Unsigned<Raw> a, uint16_t n, int8_t exponent, bool reciprocal)
#define FIXEDPOINT_ARGUMENTS_POWER (a, n, exponent, reciprocal)
// On which side of a tie an angle lies.
#define FIXEDPOINT_RESULT_SIDE(Raw) bool
#define FIXEDPOINT_PARAMETERS_SIDE(Raw) (Raw y, Raw x, uint32_t tie)
#define FIXEDPOINT_ARGUMENTS_SIDE (y, x, tie)

// The operations of kernel::, as OPERATION(shape, operation). In formats without a kernel of their
// own, those of the first list run what dispatch.hpp defines, and those of the second list
// portable::operation.
#define FIXEDPOINT_COMPOSED_OPERATIONS(OPERATION) \
    OPERATION(BINARY, multiply) \
    OPERATION(BINARY, multiply_short) \
    OPERATION(TERNARY, multiply_add) \
    OPERATION(TERNARY, wrapping_lerp) \
    OPERATION(BINARY, divide) \
    OPERATION(BINARY, divide_small) \
    OPERATION(BINARY, remainder) \
    OPERATION(DIVISION, divrem) \
    OPERATION(DIVISION, divmod) \
    OPERATION(BINARY, copysign) \
    OPERATION(BINARY, abs_diff) \
    OPERATION(UNARY, sqrt) \
    OPERATION(UNARY, sqrt_small) \
    OPERATION(UNARY, reciprocal_sqrt) \
    OPERATION(UNARY, reciprocal_sqrt_small) \
    OPERATION(UNARY, sin) \
    OPERATION(UNARY, sin_small) \
    OPERATION(UNARY, cos) \
    OPERATION(UNARY, cos_small) \
    OPERATION(PAIR, sincos) \
    OPERATION(UNARY, atan) \
    OPERATION(UNARY, atan_small) \
    OPERATION(BINARY, atan2) \
    OPERATION(BINARY, atan2_small) \
    OPERATION(UNARY, exp) \
    OPERATION(UNARY, log) \
    OPERATION(VECTORS, dot2) \
    OPERATION(VECTORS, dot3) \
    OPERATION(VECTORS, project2) \
    OPERATION(VECTORS, project3) \
    OPERATION(VECTOR, square2) \
    OPERATION(VECTOR, square3) \
    OPERATION(DIFFERENCE, dot_difference2) \
    OPERATION(DIFFERENCE, dot_difference3) \
    OPERATION(ADDITION, add_scaled2) \
    OPERATION(ADDITION, add_scaled3) \
    OPERATION(EXCHANGE, exchange2) \
    OPERATION(EXCHANGE, exchange3) \
    OPERATION(VECTOR, length2) \
    OPERATION(VECTOR, length3) \
    OPERATION(MAPPING, normalise3)
#define FIXEDPOINT_PORTABLE_OPERATIONS(OPERATION) \
    OPERATION(BINARY, upper_product) \
    OPERATION(WORDS, multiply_upper_halves) \
    OPERATION(SPLIT_UNARY, byte_fraction) \
    OPERATION(SPLIT_BINARY, multiply_64) \
    OPERATION(BINARY, multiply_saturating) \
    OPERATION(SPLIT_BINARY, divide_64) \
    OPERATION(SPLIT_UNARY, sqrt_64) \
    OPERATION(UNARY, cbrt) \
    OPERATION(UNARY, nearest_reciprocal_sqrt) \
    OPERATION(UNARY, sine_of_phase) \
    OPERATION(UNARY, sine_of_turns) \
    OPERATION(TURNS, sine_of_quarter_turns) \
    OPERATION(SPLIT_UNARY, tan_of_rest) \
    OPERATION(UNARY, asin) \
    OPERATION(UNARY, acos) \
    OPERATION(SPLIT_UNARY, exp_64) \
    OPERATION(SPLIT_UNARY, sin_64) \
    OPERATION(SPLIT_UNARY, cos_64) \
    OPERATION(SPLIT_PAIR, sincos_64) \
    OPERATION(SPLIT_BINARY, atan2_64) \
    OPERATION(SPLIT_UNARY, log_64) \
    OPERATION(UNARY, exp_fine) \
    OPERATION(UNARY, exp2_unsaturated) \
    OPERATION(BINARY, pow_unsaturated) \
    OPERATION(UNARY, sinh_unsaturated) \
    OPERATION(UNARY, cosh_unsaturated) \
    OPERATION(SCALED, exp_wide) \
    OPERATION(POWER, short_power) \
    OPERATION(POWER, short_power_64) \
    OPERATION(UNARY, exp_small) \
    OPERATION(UNARY, log_fine) \
    OPERATION(UNARY, log_small) \
    OPERATION(UNARY, log2) \
    OPERATION(SPLIT_VECTORS, dot_64) \
    OPERATION(TRANSFORM, transform) \
    OPERATION(TRANSFORM, matrix_product) \
    OPERATION(OUTER, matrix_product_2) \
    OPERATION(OUTER, cross) \
    OPERATION(OUTER, twice_cross) \
    OPERATION(OUTER, quaternion_times_vector) \
    OPERATION(OUTER, quaternion_product) \
    OPERATION(OUTER, complex_product) \
    OPERATION(MAPPING, cofactors)

// ROW(KERNEL, shape, operation, integer bits, fraction bits) for every split, that is division into
// integer and fraction bits, of 16 bits except Q8.8, of 24 bits, and of 32 bits except Q16.16; the
// two have kernels of their own. Coarse splits have fewer fraction bits than Q8.8.
#define FIXEDPOINT_COARSE_SPLITS_16(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 16, 0) \
    ROW(KERNEL, shape, operation, 15, 1) \
    ROW(KERNEL, shape, operation, 14, 2) \
    ROW(KERNEL, shape, operation, 13, 3) \
    ROW(KERNEL, shape, operation, 12, 4) \
    ROW(KERNEL, shape, operation, 11, 5) \
    ROW(KERNEL, shape, operation, 10, 6) \
    ROW(KERNEL, shape, operation, 9, 7)
#define FIXEDPOINT_SPLITS_16(ROW, KERNEL, shape, operation) \
    FIXEDPOINT_COARSE_SPLITS_16(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 7, 9) \
    ROW(KERNEL, shape, operation, 6, 10) \
    ROW(KERNEL, shape, operation, 5, 11) \
    ROW(KERNEL, shape, operation, 4, 12) \
    ROW(KERNEL, shape, operation, 3, 13) \
    ROW(KERNEL, shape, operation, 2, 14) \
    ROW(KERNEL, shape, operation, 1, 15) \
    ROW(KERNEL, shape, operation, 0, 16)

#define FIXEDPOINT_SPLITS_24(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 24, 0) \
    ROW(KERNEL, shape, operation, 23, 1) \
    ROW(KERNEL, shape, operation, 22, 2) \
    ROW(KERNEL, shape, operation, 21, 3) \
    ROW(KERNEL, shape, operation, 20, 4) \
    ROW(KERNEL, shape, operation, 19, 5) \
    ROW(KERNEL, shape, operation, 18, 6) \
    ROW(KERNEL, shape, operation, 17, 7) \
    ROW(KERNEL, shape, operation, 16, 8) \
    ROW(KERNEL, shape, operation, 15, 9) \
    ROW(KERNEL, shape, operation, 14, 10) \
    ROW(KERNEL, shape, operation, 13, 11) \
    ROW(KERNEL, shape, operation, 12, 12) \
    ROW(KERNEL, shape, operation, 11, 13) \
    ROW(KERNEL, shape, operation, 10, 14) \
    ROW(KERNEL, shape, operation, 9, 15) \
    ROW(KERNEL, shape, operation, 8, 16) \
    ROW(KERNEL, shape, operation, 7, 17) \
    ROW(KERNEL, shape, operation, 6, 18) \
    ROW(KERNEL, shape, operation, 5, 19) \
    ROW(KERNEL, shape, operation, 4, 20) \
    ROW(KERNEL, shape, operation, 3, 21) \
    ROW(KERNEL, shape, operation, 2, 22) \
    ROW(KERNEL, shape, operation, 1, 23)

#define FIXEDPOINT_COARSE_SPLITS_32(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 32, 0) \
    ROW(KERNEL, shape, operation, 31, 1) \
    ROW(KERNEL, shape, operation, 30, 2) \
    ROW(KERNEL, shape, operation, 29, 3) \
    ROW(KERNEL, shape, operation, 28, 4) \
    ROW(KERNEL, shape, operation, 27, 5) \
    ROW(KERNEL, shape, operation, 26, 6) \
    ROW(KERNEL, shape, operation, 25, 7) \
    ROW(KERNEL, shape, operation, 24, 8) \
    ROW(KERNEL, shape, operation, 23, 9) \
    ROW(KERNEL, shape, operation, 22, 10) \
    ROW(KERNEL, shape, operation, 21, 11) \
    ROW(KERNEL, shape, operation, 20, 12) \
    ROW(KERNEL, shape, operation, 19, 13) \
    ROW(KERNEL, shape, operation, 18, 14) \
    ROW(KERNEL, shape, operation, 17, 15) \
    ROW(KERNEL, shape, operation, 15, 17) \
    ROW(KERNEL, shape, operation, 14, 18) \
    ROW(KERNEL, shape, operation, 13, 19) \
    ROW(KERNEL, shape, operation, 12, 20) \
    ROW(KERNEL, shape, operation, 11, 21) \
    ROW(KERNEL, shape, operation, 10, 22) \
    ROW(KERNEL, shape, operation, 9, 23) \
    ROW(KERNEL, shape, operation, 8, 24) \
    ROW(KERNEL, shape, operation, 7, 25) \
    ROW(KERNEL, shape, operation, 6, 26) \
    ROW(KERNEL, shape, operation, 5, 27)

#define FIXEDPOINT_SPLITS_32(ROW, KERNEL, shape, operation) \
    FIXEDPOINT_COARSE_SPLITS_32(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 4, 28) \
    ROW(KERNEL, shape, operation, 3, 29) \
    ROW(KERNEL, shape, operation, 2, 30) \
    ROW(KERNEL, shape, operation, 1, 31) \
    ROW(KERNEL, shape, operation, 0, 32)

#define FIXEDPOINT_KERNEL_OF_SPLIT_16(KERNEL, shape, operation, I, F) \
    KERNEL(shape, operation, int16_t, F, fixedpoint_##operation##_q##I##_##F, operation)
#define FIXEDPOINT_KERNEL_OF_SPLIT_24(KERNEL, shape, operation, I, F) \
    KERNEL(shape, operation, ::fixedpoint::Int24, F, fixedpoint_##operation##_q##I##_##F, operation)
#define FIXEDPOINT_KERNEL_OF_SPLIT_32(KERNEL, shape, operation, I, F) \
    KERNEL(shape, operation, int32_t, F, fixedpoint_##operation##_q##I##_##F, operation)

// The same for numbers without a sign.
#define FIXEDPOINT_KERNEL_OF_UNSIGNED_SPLIT_16(KERNEL, shape, operation, I, F) \
    KERNEL(shape, operation, uint16_t, F, fixedpoint_##operation##_u##I##_##F, operation)
#define FIXEDPOINT_KERNEL_OF_UNSIGNED_SPLIT_32(KERNEL, shape, operation, I, F) \
    KERNEL(shape, operation, uint32_t, F, fixedpoint_##operation##_u##I##_##F, operation)
// Those of 24 bits take and return three bytes, which only the compiler that has __int24 passes in
// registers as they expect.
#ifdef __INT24_MAX__
#define FIXEDPOINT_KERNELS_24(KERNEL) \
    FIXEDPOINT_SPLITS_24(FIXEDPOINT_KERNEL_OF_SPLIT_24, KERNEL, BINARY, multiply) \
    FIXEDPOINT_SPLITS_24(FIXEDPOINT_KERNEL_OF_SPLIT_24, KERNEL, BINARY, multiply_saturating) \
    FIXEDPOINT_SPLITS_24(FIXEDPOINT_KERNEL_OF_SPLIT_24, KERNEL, TERNARY, multiply_add) \
    FIXEDPOINT_SPLITS_24(FIXEDPOINT_KERNEL_OF_SPLIT_24, KERNEL, VECTORS, dot2) \
    FIXEDPOINT_SPLITS_24(FIXEDPOINT_KERNEL_OF_SPLIT_24, KERNEL, VECTORS, dot3)
#else
#define FIXEDPOINT_KERNELS_24(KERNEL)
#endif

#define FIXEDPOINT_KERNELS(KERNEL) \
    FIXEDPOINT_KERNELS_24(KERNEL) \
    KERNEL(BINARY, multiply, int8_t, 4, fixedpoint_multiply_q4_4, multiply) \
    KERNEL(BINARY, multiply, int16_t, 8, fixedpoint_multiply_q8_8, multiply) \
    KERNEL(BINARY, multiply, int32_t, 16, fixedpoint_multiply_q16_16, multiply) \
    KERNEL(BINARY, multiply, int64_t, 32, fixedpoint_multiply_q32_32, multiply) \
    FIXEDPOINT_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, BINARY, multiply) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, BINARY, multiply) \
    KERNEL(BINARY, multiply, uint8_t, 4, fixedpoint_multiply_u4_4, multiply) \
    KERNEL(BINARY, multiply, uint16_t, 8, fixedpoint_multiply_u8_8, multiply) \
    KERNEL(BINARY, multiply, uint32_t, 16, fixedpoint_multiply_u16_16, multiply) \
    FIXEDPOINT_SPLITS_16(FIXEDPOINT_KERNEL_OF_UNSIGNED_SPLIT_16, KERNEL, BINARY, multiply) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_UNSIGNED_SPLIT_32, KERNEL, BINARY, multiply) \
    KERNEL(WORDS, multiply_words, uint32_t, 0, fixedpoint_multiply_words, multiply_words) \
    KERNEL(BINARY, upper_product, uint32_t, 0, fixedpoint_upper_product, upper_product) \
    KERNEL(WORDS, multiply_upper_halves, uint64_t, 0, fixedpoint_multiply_upper_halves, multiply_upper_halves) \
    KERNEL(SPLIT_UNARY, byte_fraction, uint64_t, 0, fixedpoint_byte_fraction, byte_fraction) \
    KERNEL(SPLIT_BINARY, multiply_64, int64_t, 0, fixedpoint_multiply_64, multiply_64) \
    KERNEL(BINARY, multiply_saturating, int16_t, 8, fixedpoint_multiply_saturating_q8_8, multiply_saturating) \
    KERNEL(BINARY, multiply_saturating, int32_t, 16, fixedpoint_multiply_q16_16_saturating, multiply_saturating) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, BINARY, multiply_saturating) \
    KERNEL(BINARY, multiply_short, int32_t, 16, fixedpoint_multiply_short_q16_16, multiply) \
    KERNEL(TERNARY, multiply_add, int32_t, 16, fixedpoint_multiply_add_q16_16, multiply_add) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, TERNARY, multiply_add) \
    KERNEL(TERNARY, wrapping_lerp, int64_t, 32, fixedpoint_lerp_q32_32, wrapping_lerp) \
    KERNEL(BINARY, divide, int8_t, 4, fixedpoint_divide_q4_4, divide) \
    KERNEL(BINARY, divide, int16_t, 8, fixedpoint_divide_q8_8, divide) \
    KERNEL(BINARY, divide, int32_t, 16, fixedpoint_divide_q16_16, divide) \
    KERNEL(BINARY, divide, int64_t, 32, fixedpoint_divide_q32_32, divide) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, BINARY, divide) \
    KERNEL(SPLIT_BINARY, divide_64, int64_t, 0, fixedpoint_divide_64, divide_64) \
    KERNEL(BINARY, divide_small, int32_t, 16, fixedpoint_divide_q16_16_small, divide) \
    KERNEL(BINARY, remainder, int8_t, 4, fixedpoint_remainder_q4_4, remainder) \
    KERNEL(BINARY, remainder, int16_t, 8, fixedpoint_remainder_q8_8, remainder) \
    KERNEL(BINARY, remainder, int32_t, 16, fixedpoint_remainder_q16_16, remainder) \
    KERNEL(BINARY, remainder, int64_t, 32, fixedpoint_remainder_q32_32, remainder) \
    KERNEL(DIVISION, divrem, int16_t, 8, fixedpoint_divrem_q8_8, divrem) \
    KERNEL(DIVISION, divrem, int32_t, 16, fixedpoint_divrem_q16_16, divrem) \
    KERNEL(DIVISION, divrem, int64_t, 32, fixedpoint_divrem_q32_32, divrem) \
    KERNEL(DIVISION, divmod, int16_t, 8, fixedpoint_divmod_q8_8, divmod) \
    KERNEL(DIVISION, divmod, int32_t, 16, fixedpoint_divmod_q16_16, divmod) \
    KERNEL(DIVISION, divmod, int64_t, 32, fixedpoint_divmod_q32_32, divmod) \
    KERNEL(BINARY, copysign, int64_t, 32, fixedpoint_copysign_q32_32, copysign) \
    KERNEL(BINARY, abs_diff, int64_t, 32, fixedpoint_abs_diff_q32_32, abs_diff) \
    KERNEL(UNARY, sqrt, int8_t, 4, fixedpoint_sqrt_q4_4, sqrt) \
    KERNEL(UNARY, sqrt, int16_t, 8, fixedpoint_sqrt_q8_8, sqrt) \
    KERNEL(UNARY, sqrt, int32_t, 16, fixedpoint_sqrt_q16_16, sqrt) \
    KERNEL(UNARY, sqrt, int64_t, 32, fixedpoint_sqrt_q32_32, sqrt) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, sqrt) \
    KERNEL(SPLIT_UNARY, sqrt_64, int64_t, 0, fixedpoint_sqrt_64, sqrt_64) \
    KERNEL(UNARY, sqrt_small, int32_t, 16, fixedpoint_sqrt_q16_16_small, sqrt) \
    KERNEL(UNARY, cbrt, int64_t, 32, fixedpoint_cbrt_q32_32, cbrt) \
    KERNEL(UNARY, reciprocal_sqrt, int8_t, 4, fixedpoint_reciprocal_sqrt_q4_4, reciprocal_sqrt) \
    KERNEL(UNARY, reciprocal_sqrt, int16_t, 8, fixedpoint_reciprocal_sqrt_q8_8, reciprocal_sqrt) \
    KERNEL(UNARY, reciprocal_sqrt, int32_t, 16, fixedpoint_reciprocal_sqrt_q16_16, reciprocal_sqrt) \
    KERNEL(UNARY, reciprocal_sqrt, int64_t, 32, fixedpoint_reciprocal_sqrt_q32_32, reciprocal_sqrt) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, reciprocal_sqrt) \
    KERNEL(UNARY, reciprocal_sqrt_small, int32_t, 16, fixedpoint_reciprocal_sqrt_q16_16_small, reciprocal_sqrt_small) \
    KERNEL(UNARY, nearest_reciprocal_sqrt, int32_t, 16, fixedpoint_reciprocal_sqrt_q16_16_correctly_rounded, nearest_reciprocal_sqrt) \
    KERNEL(UNARY, sine_of_phase, int16_t, 8, fixedpoint_sine_of_phase_q8_8, sine_of_phase) \
    FIXEDPOINT_COARSE_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, UNARY, sine_of_phase) \
    KERNEL(UNARY, sine_of_phase, int32_t, 16, fixedpoint_sine_of_phase_q16_16, sine_of_phase) \
    KERNEL(UNARY, sine_of_turns, int16_t, 8, fixedpoint_sine_of_turns_q8_8, sine_of_turns) \
    KERNEL(UNARY, sine_of_turns, int32_t, 16, fixedpoint_sine_of_turns_q16_16, sine_of_turns) \
    KERNEL(TURNS, sine_of_quarter_turns, int64_t, 32, fixedpoint_sine_of_quarter_turns_q32_32, sine_of_quarter_turns) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, TURNS, sine_of_quarter_turns) \
    KERNEL(UNARY, sin, int8_t, 4, fixedpoint_sin_q4_4, sin) \
    KERNEL(UNARY, sin, int16_t, 8, fixedpoint_sin_q8_8, sin) \
    FIXEDPOINT_COARSE_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, UNARY, sin) \
    KERNEL(UNARY, sin, int32_t, 16, fixedpoint_sin_q16_16, sin) \
    KERNEL(UNARY, sin, int64_t, 32, fixedpoint_sin_q32_32, sin) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, sin) \
    KERNEL(UNARY, sin_small, int32_t, 16, fixedpoint_sin_q16_16_small, sin_small) \
    KERNEL(UNARY, cos, int8_t, 4, fixedpoint_cos_q4_4, cos) \
    KERNEL(UNARY, cos, int16_t, 8, fixedpoint_cos_q8_8, cos) \
    FIXEDPOINT_COARSE_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, UNARY, cos) \
    KERNEL(UNARY, cos, int32_t, 16, fixedpoint_cos_q16_16, cos) \
    KERNEL(UNARY, cos, int64_t, 32, fixedpoint_cos_q32_32, cos) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, cos) \
    KERNEL(UNARY, cos_small, int32_t, 16, fixedpoint_cos_q16_16_small, cos_small) \
    KERNEL(SPLIT_UNARY, tan_of_rest, int64_t, 32, fixedpoint_tan_of_rest, tan_of_rest) \
    KERNEL(UNARY, atan, int8_t, 4, fixedpoint_atan_q4_4, atan) \
    KERNEL(UNARY, atan, int16_t, 8, fixedpoint_atan_q8_8, atan) \
    KERNEL(UNARY, atan, int32_t, 16, fixedpoint_atan_q16_16, atan) \
    KERNEL(UNARY, atan, int64_t, 32, fixedpoint_atan_q32_32, atan) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, atan) \
    KERNEL(UNARY, atan_small, int32_t, 16, fixedpoint_atan_q16_16_small, atan_small) \
    KERNEL(PAIR, sincos, int8_t, 4, fixedpoint_sincos_q4_4, sincos) \
    KERNEL(PAIR, sincos, int16_t, 8, fixedpoint_sincos_q8_8, sincos) \
    FIXEDPOINT_COARSE_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, PAIR, sincos) \
    KERNEL(PAIR, sincos, int32_t, 16, fixedpoint_sincos_q16_16, sincos) \
    KERNEL(PAIR, sincos, int64_t, 32, fixedpoint_sincos_q32_32, sincos) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, PAIR, sincos) \
    KERNEL(BINARY, atan2, int16_t, 8, fixedpoint_atan2_q8_8, atan2) \
    KERNEL(BINARY, atan2, int32_t, 16, fixedpoint_atan2_q16_16, atan2) \
    KERNEL(BINARY, atan2, int64_t, 32, fixedpoint_atan2_q32_32, atan2) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, BINARY, atan2) \
    KERNEL(BINARY, atan2_small, int32_t, 16, fixedpoint_atan2_q16_16_small, atan2_small) \
    KERNEL(UNARY, asin, int32_t, 16, fixedpoint_asin_q16_16, asin) \
    KERNEL(UNARY, acos, int32_t, 16, fixedpoint_acos_q16_16, acos) \
    KERNEL(UNARY, exp, int8_t, 4, fixedpoint_exp_q4_4, exp) \
    KERNEL(UNARY, exp, int16_t, 8, fixedpoint_exp_q8_8, exp) \
    KERNEL(UNARY, exp, int32_t, 16, fixedpoint_exp_q16_16, exp) \
    KERNEL(UNARY, exp, int64_t, 32, fixedpoint_exp_q32_32, exp) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, exp) \
    KERNEL(SPLIT_UNARY, sin_64, int64_t, 0, fixedpoint_sin_64, sin_64) \
    KERNEL(SPLIT_UNARY, cos_64, int64_t, 0, fixedpoint_cos_64, cos_64) \
    KERNEL(SPLIT_PAIR, sincos_64, int64_t, 0, fixedpoint_sincos_64, sincos_64) \
    KERNEL(SPLIT_BINARY, atan2_64, int64_t, 0, fixedpoint_atan2_64, atan2_64) \
    KERNEL(SPLIT_UNARY, log_64, int64_t, 0, fixedpoint_log_64, log_64) \
    KERNEL(SPLIT_UNARY, exp_64, int64_t, 0, fixedpoint_exp_64, exp_64) \
    KERNEL(UNARY, exp_fine, int64_t, 32, fixedpoint_exp_q32_32_fine, exp_fine) \
    KERNEL(UNARY, exp2_unsaturated, int32_t, 16, fixedpoint_exp2_q16_16_unsaturated, exp2_unsaturated) \
    KERNEL(UNARY, exp2_unsaturated, int64_t, 32, fixedpoint_exp2_q32_32_unsaturated, exp2_unsaturated) \
    KERNEL(BINARY, pow_unsaturated, int64_t, 32, fixedpoint_pow_q32_32_unsaturated, pow_unsaturated) \
    KERNEL(UNARY, sinh_unsaturated, int64_t, 32, fixedpoint_sinh_q32_32_unsaturated, sinh_unsaturated) \
    KERNEL(UNARY, cosh_unsaturated, int64_t, 32, fixedpoint_cosh_q32_32_unsaturated, cosh_unsaturated) \
    KERNEL(SCALED, exp_wide, int64_t, 40, fixedpoint_exp_wide, exp_wide) \
    KERNEL(POWER, short_power, int32_t, 0, fixedpoint_short_power, short_power) \
    KERNEL(POWER, short_power_64, int64_t, 0, fixedpoint_short_power_64, short_power_64) \
    KERNEL(UNARY, exp_small, int32_t, 16, fixedpoint_exp_q16_16_small, exp_small) \
    KERNEL(UNARY, log, int8_t, 4, fixedpoint_log_q4_4, log) \
    KERNEL(UNARY, log, int16_t, 8, fixedpoint_log_q8_8, log) \
    FIXEDPOINT_COARSE_SPLITS_16(FIXEDPOINT_KERNEL_OF_SPLIT_16, KERNEL, UNARY, log) \
    KERNEL(UNARY, log, int32_t, 16, fixedpoint_log_q16_16, log) \
    KERNEL(UNARY, log, int64_t, 32, fixedpoint_log_q32_32, log) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, UNARY, log) \
    KERNEL(UNARY, log_fine, int64_t, 32, fixedpoint_log_q32_32_fine, log_fine) \
    KERNEL(UNARY, log2, int32_t, 16, fixedpoint_log2_q16_16, log2) \
    KERNEL(UNARY, log_small, int32_t, 16, fixedpoint_log_q16_16_small, log_small) \
    KERNEL(VECTORS, dot2, int8_t, 4, fixedpoint_dot2_q4_4, dot2) \
    KERNEL(VECTORS, dot2, int16_t, 8, fixedpoint_dot2_q8_8, dot2) \
    KERNEL(VECTORS, dot2, int32_t, 16, fixedpoint_dot2_q16_16, dot2) \
    KERNEL(VECTORS, dot2, int64_t, 32, fixedpoint_dot2_q32_32, dot2) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, VECTORS, dot2) \
    KERNEL(VECTORS, dot3, int8_t, 4, fixedpoint_dot3_q4_4, dot3) \
    KERNEL(VECTORS, dot3, int16_t, 8, fixedpoint_dot3_q8_8, dot3) \
    KERNEL(VECTORS, dot3, int32_t, 16, fixedpoint_dot3_q16_16, dot3) \
    KERNEL(VECTORS, dot3, int64_t, 32, fixedpoint_dot3_q32_32, dot3) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, VECTORS, dot3) \
    KERNEL(SPLIT_VECTORS, dot_64, int64_t, 0, fixedpoint_dot_64, dot_64) \
    KERNEL(TRANSFORM, transform, int32_t, 16, fixedpoint_transform_q16_16, transform) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, TRANSFORM, transform) \
    KERNEL(TRANSFORM, matrix_product, int32_t, 16, fixedpoint_matrix_product_q16_16, matrix_product) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, TRANSFORM, matrix_product) \
    KERNEL(OUTER, matrix_product_2, int32_t, 16, fixedpoint_matrix_product_2_q16_16, matrix_product_2) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, matrix_product_2) \
    KERNEL(OUTER, cross, int32_t, 16, fixedpoint_cross_q16_16, cross) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, cross) \
    KERNEL(OUTER, twice_cross, int32_t, 16, fixedpoint_twice_cross_q16_16, twice_cross) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, twice_cross) \
    KERNEL(OUTER, quaternion_times_vector, int32_t, 16, fixedpoint_quaternion_times_vector_q16_16, quaternion_times_vector) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, quaternion_times_vector) \
    KERNEL(OUTER, quaternion_product, int32_t, 16, fixedpoint_quaternion_product_q16_16, quaternion_product) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, quaternion_product) \
    KERNEL(OUTER, complex_product, int32_t, 16, fixedpoint_complex_product_q16_16, complex_product) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, OUTER, complex_product) \
    KERNEL(MAPPING, cofactors, int32_t, 16, fixedpoint_cofactors_q16_16, cofactors) \
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, MAPPING, cofactors) \
    KERNEL(VECTORS, project2, int32_t, 16, fixedpoint_project2_q16_16, dot2) \
    KERNEL(VECTORS, project3, int32_t, 16, fixedpoint_project3_q16_16, dot3) \
    KERNEL(VECTOR, square2, int32_t, 16, fixedpoint_square2_q16_16, square2) \
    KERNEL(VECTOR, square3, int32_t, 16, fixedpoint_square3_q16_16, square3) \
    KERNEL(DIFFERENCE, dot_difference2, int32_t, 16, fixedpoint_dot_difference2_q16_16, dot_difference2) \
    KERNEL(DIFFERENCE, dot_difference3, int32_t, 16, fixedpoint_dot_difference3_q16_16, dot_difference3) \
    KERNEL(ADDITION, add_scaled2, int32_t, 16, fixedpoint_add_scaled2_q16_16, add_scaled2) \
    KERNEL(ADDITION, add_scaled3, int32_t, 16, fixedpoint_add_scaled3_q16_16, add_scaled3) \
    KERNEL(EXCHANGE, exchange2, int32_t, 16, fixedpoint_exchange2_q16_16, exchange2) \
    KERNEL(EXCHANGE, exchange3, int32_t, 16, fixedpoint_exchange3_q16_16, exchange3) \
    KERNEL(VECTOR, length2, int8_t, 4, fixedpoint_length2_q4_4, length2) \
    KERNEL(VECTOR, length2, int16_t, 8, fixedpoint_length2_q8_8, length2) \
    KERNEL(VECTOR, length2, int32_t, 16, fixedpoint_length2_q16_16, length2) \
    KERNEL(VECTOR, length2, int64_t, 32, fixedpoint_length2_q32_32, length2) \
    KERNEL(VECTOR, length3, int8_t, 4, fixedpoint_length3_q4_4, length3) \
    KERNEL(VECTOR, length3, int16_t, 8, fixedpoint_length3_q8_8, length3) \
    KERNEL(VECTOR, length3, int32_t, 16, fixedpoint_length3_q16_16, length3) \
    KERNEL(VECTOR, length3, int64_t, 32, fixedpoint_length3_q32_32, length3) \
    KERNEL(MAPPING, normalise3, int16_t, 8, fixedpoint_normalise3_q8_8, normalise3) \
    KERNEL(MAPPING, normalise3, int32_t, 16, fixedpoint_normalise3_q16_16, normalise3) \
    KERNEL(MAPPING, normalise3, int64_t, 32, fixedpoint_normalise3_q32_32, normalise3) \
    FIXEDPOINT_COARSE_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, KERNEL, MAPPING, normalise3)

// The kernels that jump to code of kernel/nearest.hpp if a 32-bit core leaves the rounding
// undecided.
#define FIXEDPOINT_ROUNDED_KERNELS(KERNEL) \
    KERNEL(UNARY, nearest_sin, int32_t, 16, fixedpoint_sin_q16_16_correctly_rounded, nearest_sin) \
    KERNEL(UNARY, nearest_cos, int32_t, 16, fixedpoint_cos_q16_16_correctly_rounded, nearest_cos) \
    KERNEL(UNARY, nearest_exp, int32_t, 16, fixedpoint_exp_q16_16_correctly_rounded, nearest_exp) \
    KERNEL(UNARY, nearest_log, int32_t, 16, fixedpoint_log_q16_16_correctly_rounded, nearest_log)
// Those of angles call the kernel that compares an angle with a tie.
#define FIXEDPOINT_ROUNDED_ANGLE_KERNELS(KERNEL) \
    KERNEL(UNARY, nearest_atan, int32_t, 16, fixedpoint_atan_q16_16_correctly_rounded, nearest_atan) \
    KERNEL(BINARY, nearest_atan2, int32_t, 16, fixedpoint_atan2_q16_16_correctly_rounded, nearest_atan2)
#define FIXEDPOINT_SIDE_KERNELS(KERNEL) \
    KERNEL(SIDE, angle_reaches, int32_t, 16, fixedpoint_angle_reaches_q16_16, angle_reaches)
// clang-format on
