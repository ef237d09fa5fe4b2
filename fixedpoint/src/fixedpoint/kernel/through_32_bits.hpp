// SPDX-License-Identifier: MIT
// The operations of 24-bit formats without a kernel of their own: those of the 32-bit format with
// as many fraction bits, which holds every operand. Its result is the exact one, rounded once, and
// then saturated to 24 bits; the definitions and the bounds of the errors are the same.
//
// Each is an overload of kernel::operation<Raw, F> for operands of type Int24. Included by
// dispatch.hpp, after the declarations of all operations.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace kernel {

// void if Raw is Int24; otherwise there is no Type, which removes an overload.
template <class Raw>
struct OfInt24 {};
template <>
struct OfInt24<Int24> {
    using Type = void;
};

// How far results reach: modulo 2^24 for ring operations; beyond either limit of any format, or
// only above the largest or below the smallest number; or no further than these integer bits.
struct Reach {
    static constexpr int modulo = 0, anywhere = 32, above = 33, below = 34;
};
// Formats wide enough for every result hold it without a comparison.
template <int F, int reach>
constexpr Int24 narrowed(int32_t result) {
    return reach < Reach::anywhere && reach + F <= 24                ? static_cast<Int24>(result)
           : reach != Reach::below && result > RawLimits<Int24>::max ? RawLimits<Int24>::max
           : reach != Reach::above && result < RawLimits<Int24>::min ? RawLimits<Int24>::min
                                                                     : static_cast<Int24>(result);
}
template <int count>
struct Widened {
    int32_t numbers[count];
    explicit FIXEDPOINT_CONSTEXPR Widened(const Int24* vector) : numbers() {
        for (uint8_t i = 0; i < count; ++i) numbers[i] = static_cast<int32_t>(vector[i]);
    }
};

// FIXEDPOINT_THROUGH_32_BITS(shape, operation, reach), of vectors (shape, operation, components).
#define FIXEDPOINT_THROUGH_32_BITS(shape, operation, reach)          \
    template <class Raw, int F, class = typename OfInt24<Raw>::Type> \
    FIXEDPOINT_CONSTEXPR FIXEDPOINT_RESULT_##shape(Int24)            \
        operation FIXEDPOINT_PARAMETERS_##shape(Int24) {             \
        FIXEDPOINT_THROUGH_32_BITS_##shape(operation, reach)         \
    }
#define FIXEDPOINT_THROUGH_32_BITS_UNARY(operation, reach) \
    return narrowed<F, reach>(operation<int32_t, F>(static_cast<int32_t>(a)));
#define FIXEDPOINT_THROUGH_32_BITS_BINARY(operation, reach) \
    return narrowed<F, reach>(                              \
        operation<int32_t, F>(static_cast<int32_t>(a), static_cast<int32_t>(b)));
#define FIXEDPOINT_THROUGH_32_BITS_PAIR(operation, reach) \
    int32_t wide[2] = {};                                 \
    operation<int32_t, F>(static_cast<int32_t>(a), wide); \
    pair[0] = narrowed<F, reach>(wide[0]);                \
    pair[1] = narrowed<F, reach>(wide[1]);
#define FIXEDPOINT_THROUGH_32_BITS_DIVISION(operation, reach)                      \
    int32_t wide[2] = {};                                                          \
    operation<int32_t, F>(static_cast<int32_t>(a), static_cast<int32_t>(b), wide); \
    pair[0] = narrowed<F, reach>(wide[0]);                                         \
    pair[1] = static_cast<Int24>(wide[1]);
#define FIXEDPOINT_THROUGH_32_BITS_VECTOR(operation, count) \
    return narrowed<F, Reach::above>(operation<int32_t, F>(Widened<count>(v).numbers));
#define FIXEDPOINT_THROUGH_32_BITS_TERNARY(operation, reach) \
    return narrowed<F, reach>(operation<int32_t, F>(         \
        static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)));
#define FIXEDPOINT_THROUGH_32_BITS_VECTORS(operation, count) \
    return static_cast<Int24>(                               \
        operation<int32_t, F>(Widened<count>(a).numbers, Widened<count>(b).numbers));

#ifndef __INT24_MAX__
FIXEDPOINT_THROUGH_32_BITS(BINARY, multiply, Reach::modulo)
FIXEDPOINT_THROUGH_32_BITS(BINARY, multiply_saturating, Reach::anywhere)
FIXEDPOINT_THROUGH_32_BITS(TERNARY, multiply_add, Reach::modulo)
FIXEDPOINT_THROUGH_32_BITS(VECTORS, dot2, 2)
FIXEDPOINT_THROUGH_32_BITS(VECTORS, dot3, 3)
#endif
FIXEDPOINT_THROUGH_32_BITS(BINARY, divide, Reach::anywhere)
FIXEDPOINT_THROUGH_32_BITS(BINARY, divide_small, Reach::anywhere)
FIXEDPOINT_THROUGH_32_BITS(BINARY, remainder, Reach::modulo)
FIXEDPOINT_THROUGH_32_BITS(DIVISION, divrem, Reach::anywhere)
FIXEDPOINT_THROUGH_32_BITS(DIVISION, divmod, Reach::anywhere)
FIXEDPOINT_THROUGH_32_BITS(UNARY, sqrt, Reach::modulo)
FIXEDPOINT_THROUGH_32_BITS(UNARY, sqrt_small, Reach::modulo)
FIXEDPOINT_THROUGH_32_BITS(UNARY, reciprocal_sqrt, Reach::above)
FIXEDPOINT_THROUGH_32_BITS(UNARY, reciprocal_sqrt_small, Reach::above)
FIXEDPOINT_THROUGH_32_BITS(UNARY, nearest_reciprocal_sqrt, Reach::above)
FIXEDPOINT_THROUGH_32_BITS(UNARY, sin, 2)
FIXEDPOINT_THROUGH_32_BITS(UNARY, sin_small, 2)
FIXEDPOINT_THROUGH_32_BITS(UNARY, cos, 2)
FIXEDPOINT_THROUGH_32_BITS(UNARY, cos_small, 2)
FIXEDPOINT_THROUGH_32_BITS(PAIR, sincos, 2)
FIXEDPOINT_THROUGH_32_BITS(UNARY, atan, 2)
FIXEDPOINT_THROUGH_32_BITS(UNARY, atan_small, 2)
FIXEDPOINT_THROUGH_32_BITS(BINARY, atan2, 3)
FIXEDPOINT_THROUGH_32_BITS(BINARY, atan2_small, 3)
FIXEDPOINT_THROUGH_32_BITS(UNARY, exp, Reach::above)
FIXEDPOINT_THROUGH_32_BITS(UNARY, exp_small, Reach::above)
FIXEDPOINT_THROUGH_32_BITS(UNARY, log, Reach::below)
FIXEDPOINT_THROUGH_32_BITS(UNARY, log_small, Reach::below)
FIXEDPOINT_THROUGH_32_BITS(VECTOR, length2, 2)
FIXEDPOINT_THROUGH_32_BITS(VECTOR, length3, 3)
#undef FIXEDPOINT_THROUGH_32_BITS_UNARY
#undef FIXEDPOINT_THROUGH_32_BITS_BINARY
#undef FIXEDPOINT_THROUGH_32_BITS_PAIR
#undef FIXEDPOINT_THROUGH_32_BITS_DIVISION
#undef FIXEDPOINT_THROUGH_32_BITS_VECTOR
#undef FIXEDPOINT_THROUGH_32_BITS_VECTORS
#undef FIXEDPOINT_THROUGH_32_BITS_TERNARY
#undef FIXEDPOINT_THROUGH_32_BITS

template <class Raw, int F, class = typename OfInt24<Raw>::Type>
FIXEDPOINT_CONSTEXPR void normalise3(const Int24* v, Int24* unit) {
    Widened<3> wide(v);
    normalise3<int32_t, F>(wide.numbers, wide.numbers);
    for (uint8_t i = 0; i < 3; ++i) unit[i] = narrowed<F, 2>(wide.numbers[i]);
}

}  // namespace kernel
}  // namespace fixedpoint
