// SPDX-License-Identifier: MIT
// On which side of a tie a power of e or a natural logarithm lies. A number is compared with a
// power, scaled so that Q32.32 gives it to 61 bits.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/correct_rounding_table.hpp>

namespace fixedpoint {
namespace kernel {

// Whether n 2^s >= e^x, with a relative error below 2^-60. Requires n > 0, x of Q32.32 in [-12,
// 12), and that for some s the two differ by a relative 2^-30 or less.
//
// Compares n e^c with e^(x + c), which lies in e^20..e^21, by the 64 leading bits of both. These
// may lie on different sides of a power of 2, so they are compared modulo that.
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) bool reaches_power(uint32_t n, int64_t x) {
    // c - 9.
    const uint8_t index = static_cast<uint8_t>(11 - static_cast<int32_t>(x >> 32));
    uint64_t power =
        static_cast<uint64_t>(exp<int64_t, 32>(x + (static_cast<int64_t>(index + 9) << 32)));
    while (static_cast<int64_t>(power) >= 0) power <<= 1;
    while (static_cast<int32_t>(n) >= 0) n <<= 1;
    const uint32_t* const factor = &portable::CorrectRoundingTable<>::power[2 * index];
    uint64_t product = multiply_words(n, read_program_memory(factor[1])) +
                       (multiply_words(n, read_program_memory(factor[0])) >> 32);
    if (static_cast<int64_t>(product) >= 0) product <<= 1;
    return ((product - power) >> 62 & 1) == 0;
}

struct ExponentialSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        return !reaches_power(static_cast<uint32_t>(tie >> 15), static_cast<int64_t>(a) * 65536);
    }
};
// e^a in Q16.16 rounded to nearest, given e^a rounded downward.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR FIXEDPOINT_CALLED_BY_KERNEL Raw rounded_power(Raw a, Raw floor) {
    const bool is_below =
        reaches_power(static_cast<uint32_t>(floor) * 2 + 1, static_cast<int64_t>(a) * 65536);
    return is_below ? floor : static_cast<Raw>(floor + 1);
}
struct NaturalLogarithmSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        return reaches_power(static_cast<uint32_t>(a), tie);
    }
};

}  // namespace kernel
}  // namespace fixedpoint
