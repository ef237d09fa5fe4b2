// SPDX-License-Identifier: MIT
// The natural logarithm of Q32.32, bit for bit as avr/log_q32_32.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cubic_64.hpp>
#include <fixedpoint/portable/log_64_table.hpp>

namespace fixedpoint {
namespace portable {

// ln a in units of 2^-39 plus half an ulp, for rounding. Only in Q32.32; a must be greater than 0.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw log_fine(Raw a) {
    uint64_t normalised = static_cast<uint64_t>(a);
    int exponent = 31;
    while (normalised >> 63 == 0) {
        normalised <<= 1;
        --exponent;
    }
    constexpr int64_t ln2 = 24973259072661437;  // 2^-55
    const int64_t multiple = (exponent * ln2 + (1 << 15)) >> 16;
    const uint64_t position = (normalised << 1) >> 24;
    return static_cast<int64_t>(cubic_64<Log64Table<>>(position)) + multiple;
}

FIXEDPOINT_CONSTEXPR int64_t log_q32_32(int64_t a) {
    return a > 0 ? log_fine<int64_t, 32>(a) >> 7 : RawLimits<int64_t>::min;
}

}  // namespace portable
}  // namespace fixedpoint
