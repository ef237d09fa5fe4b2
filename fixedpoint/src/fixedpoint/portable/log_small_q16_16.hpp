// SPDX-License-Identifier: MIT
// The natural logarithm in Q16.16 by 16 parabolas, bit for bit as avr/log_q16_16_small.S computes
// it; within 0.73 ulp for every input.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/log_small_table.hpp>
#include <fixedpoint/portable/parabola_small.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t log_small_q16_16(int32_t a) {
    if (a <= 0) return RawLimits<int32_t>::min;
    constexpr int32_t ln2 = 11629080;
    int32_t sum = 15 * ln2;
    uint32_t normalised = static_cast<uint32_t>(a);
    for (; normalised >> 31 == 0; normalised <<= 1) sum -= ln2;
    const uint32_t fraction = normalised >> 7 & 0xffffff;
    return (sum + static_cast<int32_t>(parabola_small<LogarithmSmallTable<>>(fraction))) >> 8;
}

}  // namespace portable
}  // namespace fixedpoint
