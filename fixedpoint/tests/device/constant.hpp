// SPDX-License-Identifier: MIT
// CHECK_CONSTANT(expression): the compiler computes what the chip computes. The expression in two
// numbers x and y with the raw values A and B is evaluated as a constant expression, with constants
// that the optimiser may fold, and with operands that are unknown to the compiler.
#pragma once

#include "numbers.hpp"

template <Raw A>
__attribute__((noinline)) Number operand() {
    return ::operand(A);
}
template <class T>
__attribute__((noinline)) bool same(T a, T b) {
    return a == b;
}

#define CHECK_CONSTANT(expression)                                                   \
    do {                                                                             \
        __attribute__((unused)) constexpr Number x = Number::from_raw(A);            \
        __attribute__((unused)) constexpr Number y = Number::from_raw(B);            \
        constexpr auto constant = expression;                                        \
        const auto folded = expression;                                              \
        {                                                                            \
            __attribute__((unused)) const Number x = operand<A>(), y = operand<B>(); \
            const auto computed = expression;                                        \
            CHECK(same(constant, computed) && same(folded, computed));               \
        }                                                                            \
    } while (false)

// x in another arithmetic.
template <class Arithmetic>
constexpr fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS, Arithmetic> as(Number x) {
    return fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS, Arithmetic>::from_raw(x.raw());
}

// Operands in the middle of the range and near 1, or near 1/2 if the format cannot represent 1.
constexpr Raw third = fixedpoint::RawLimits<Raw>::max / 3,
              fifth = fixedpoint::RawLimits<Raw>::min / 5;
constexpr Raw one = static_cast<Raw>(fixedpoint::Unsigned<Raw>(1)
                                     << (INTEGER_BITS > 1 ? FRACTION_BITS : FRACTION_BITS - 1));
constexpr Raw above_one = one + one / 3, below_one = one - one / 5;
