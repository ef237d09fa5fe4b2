// SPDX-License-Identifier: MIT
// The operations of 24-bit formats without a kernel of their own. They are those of the 32-bit
// format with as many fraction bits, which holds every operand: the exact result is rounded once,
// and then saturated to 24 bits, so definitions and bounds of the errors are the same.
//
// Functions of formats that Q16.16 holds go through Q16.16 instead (portable/through_q16_16.hpp),
// whose kernels are faster than those of other splits.
//
// Each is an overload of kernel::operation<Raw, F> for operands of type Int24. Included by
// dispatch.hpp, after the declarations of all operations.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/through_q16_16.hpp>

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

// The 32-bit format that evaluates the functions of a format with F fraction bits: its own, how
// many more these are, and an ulp of the narrow format in its units.
template <int F>
struct WideFormat {
    static constexpr int fraction = portable::through_q16_16<Int24, F>() ? 16 : F;
    static constexpr int guard = fraction - F;
    static constexpr int32_t ulp = int32_t(1) << guard;
};
// a 2^-F in that format, exact.
template <int F>
constexpr int32_t widened(Int24 a) {
    return static_cast<int32_t>(a) * WideFormat<F>::ulp;
}
// A result in that format, rounded half up and narrowed. Shifts upward and by whole bytes are
// faster on the chip than shifts downward.
template <int F, int reach>
FIXEDPOINT_CONSTEXPR Int24 rounded(int32_t result) {
    constexpr int guard = WideFormat<F>::guard;
    if (guard == 0) return narrowed<F, reach>(result);
    constexpr int32_t ulp = WideFormat<F>::ulp, half = ulp >> 1;
    constexpr int32_t largest = RawLimits<Int24>::max * ulp + half - 1;
    constexpr int32_t smallest = RawLimits<Int24>::min * ulp - (guard < 8 ? half : 0);
    const bool fits = reach < Reach::anywhere && reach + F <= 24;
    if (!fits && reach != Reach::below && result > largest) return RawLimits<Int24>::max;
    if (!fits && reach != Reach::above && result < smallest) return RawLimits<Int24>::min;
    return static_cast<Int24>(static_cast<uint32_t>(result + half) << (8 - guard) >> 8);
}
template <int count>
struct Widened {
    int32_t numbers[count];
    explicit FIXEDPOINT_CONSTEXPR Widened(const Int24* vector) : numbers() {
        for (uint8_t i = 0; i < count; ++i) numbers[i] = static_cast<int32_t>(vector[i]);
    }
};

// FIXEDPOINT_OF_24_BITS(shape, operation, form, reach), of vectors (shape, operation, form,
// components).
#define FIXEDPOINT_OF_24_BITS(shape, operation, form, reach)         \
    template <class Raw, int F, class = typename OfInt24<Raw>::Type> \
    FIXEDPOINT_CONSTEXPR FIXEDPOINT_RESULT_##shape(Int24)            \
        operation FIXEDPOINT_PARAMETERS_##shape(Int24) {             \
        FIXEDPOINT_##form(operation, reach)                          \
    }
#define FIXEDPOINT_EXACT_1(operation, reach) \
    return narrowed<F, reach>(operation<int32_t, F>(static_cast<int32_t>(a)));
#define FIXEDPOINT_EXACT_2(operation, reach) \
    return narrowed<F, reach>(               \
        operation<int32_t, F>(static_cast<int32_t>(a), static_cast<int32_t>(b)));
#define FIXEDPOINT_EXACT_3(operation, reach)         \
    return narrowed<F, reach>(operation<int32_t, F>( \
        static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)));
// a 2^F / b is a 2^16 / (b 2^(16 - F)), rounded once in either format.
#define FIXEDPOINT_QUOTIENT(operation, reach) \
    return narrowed<F, reach>(                \
        operation<int32_t, WideFormat<F>::fraction>(static_cast<int32_t>(a), widened<F>(b)));
#define FIXEDPOINT_DIVISION(operation, reach)                                      \
    int32_t wide[2] = {};                                                          \
    operation<int32_t, F>(static_cast<int32_t>(a), static_cast<int32_t>(b), wide); \
    pair[0] = narrowed<F, reach>(wide[0]);                                         \
    pair[1] = static_cast<Int24>(wide[1]);
#define FIXEDPOINT_LENGTH(length, components) \
    return narrowed<F, Reach::above>(length<int32_t, F>(Widened<components>(v).numbers));
#define FIXEDPOINT_DOT(dot, components) \
    return static_cast<Int24>(          \
        dot<int32_t, F>(Widened<components>(a).numbers, Widened<components>(b).numbers));
#define FIXEDPOINT_FUNCTION(function, reach) \
    return rounded<F, reach>(function<int32_t, WideFormat<F>::fraction>(widened<F>(a)));
// Angles of vectors do not depend on the units of their operands.
#define FIXEDPOINT_ANGLE(function, reach)                                                        \
    return rounded<F, reach>(function<int32_t, WideFormat<F>::fraction>(static_cast<int32_t>(a), \
                                                                        static_cast<int32_t>(b)));
#define FIXEDPOINT_FUNCTION_PAIR(function, reach)                    \
    int32_t wide[2] = {};                                            \
    function<int32_t, WideFormat<F>::fraction>(widened<F>(a), wide); \
    pair[0] = rounded<F, reach>(wide[0]);                            \
    pair[1] = rounded<F, reach>(wide[1]);

#ifndef __INT24_MAX__
FIXEDPOINT_OF_24_BITS(BINARY, multiply, EXACT_2, Reach::modulo)
FIXEDPOINT_OF_24_BITS(BINARY, multiply_saturating, EXACT_2, Reach::anywhere)
FIXEDPOINT_OF_24_BITS(TERNARY, multiply_add, EXACT_3, Reach::modulo)
FIXEDPOINT_OF_24_BITS(VECTORS, dot2, DOT, 2)
FIXEDPOINT_OF_24_BITS(VECTORS, dot3, DOT, 3)
#endif
FIXEDPOINT_OF_24_BITS(BINARY, divide, QUOTIENT, Reach::anywhere)
FIXEDPOINT_OF_24_BITS(BINARY, divide_small, QUOTIENT, Reach::anywhere)
FIXEDPOINT_OF_24_BITS(BINARY, remainder, EXACT_2, Reach::modulo)
FIXEDPOINT_OF_24_BITS(DIVISION, divrem, DIVISION, Reach::anywhere)
FIXEDPOINT_OF_24_BITS(DIVISION, divmod, DIVISION, Reach::anywhere)
FIXEDPOINT_OF_24_BITS(UNARY, sqrt, EXACT_1, Reach::modulo)
FIXEDPOINT_OF_24_BITS(UNARY, sqrt_small, EXACT_1, Reach::modulo)
FIXEDPOINT_OF_24_BITS(UNARY, nearest_reciprocal_sqrt, EXACT_1, Reach::above)
FIXEDPOINT_OF_24_BITS(VECTOR, length2, LENGTH, 2)
FIXEDPOINT_OF_24_BITS(VECTOR, length3, LENGTH, 3)
FIXEDPOINT_OF_24_BITS(UNARY, reciprocal_sqrt, FUNCTION, Reach::above)
FIXEDPOINT_OF_24_BITS(UNARY, reciprocal_sqrt_small, FUNCTION, Reach::above)
FIXEDPOINT_OF_24_BITS(UNARY, sin, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(UNARY, sin_small, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(UNARY, cos, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(UNARY, cos_small, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(PAIR, sincos, FUNCTION_PAIR, 2)
FIXEDPOINT_OF_24_BITS(UNARY, atan, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(UNARY, atan_small, FUNCTION, 2)
FIXEDPOINT_OF_24_BITS(BINARY, atan2, ANGLE, 3)
FIXEDPOINT_OF_24_BITS(BINARY, atan2_small, ANGLE, 3)
FIXEDPOINT_OF_24_BITS(UNARY, exp, FUNCTION, Reach::above)
FIXEDPOINT_OF_24_BITS(UNARY, exp_small, FUNCTION, Reach::above)
FIXEDPOINT_OF_24_BITS(UNARY, log, FUNCTION, Reach::below)
FIXEDPOINT_OF_24_BITS(UNARY, log_small, FUNCTION, Reach::below)
#undef FIXEDPOINT_EXACT_1
#undef FIXEDPOINT_EXACT_2
#undef FIXEDPOINT_EXACT_3
#undef FIXEDPOINT_QUOTIENT
#undef FIXEDPOINT_DIVISION
#undef FIXEDPOINT_LENGTH
#undef FIXEDPOINT_DOT
#undef FIXEDPOINT_FUNCTION
#undef FIXEDPOINT_ANGLE
#undef FIXEDPOINT_FUNCTION_PAIR
#undef FIXEDPOINT_OF_24_BITS

template <class Raw, int F, class = typename OfInt24<Raw>::Type>
FIXEDPOINT_CONSTEXPR void normalise3(const Int24* v, Int24* unit) {
    int32_t wide[3] = {widened<F>(v[0]), widened<F>(v[1]), widened<F>(v[2])};
    normalise3<int32_t, WideFormat<F>::fraction>(wide, wide);
    for (uint8_t i = 0; i < 3; ++i) unit[i] = rounded<F, 2>(wide[i]);
}

}  // namespace kernel
}  // namespace fixedpoint
