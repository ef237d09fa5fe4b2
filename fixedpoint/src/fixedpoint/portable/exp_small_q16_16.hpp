// SPDX-License-Identifier: MIT
// e^a in Q16.16 by two small tables, bit for bit like avr/exp_q16_16_small.S, which explains each
// step; within 0.72 ulp for every input.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_small_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t exp_small_q16_16(int32_t a) {
    constexpr int64_t ln2 = 0xb17217f8, correction = 2;
    constexpr uint32_t sixth = 43;
    const int32_t whole = a >> 16;
    if (whole < -12) return 0;
    if (whole > 10) return RawLimits<int32_t>::max;
    int64_t rest = static_cast<int64_t>(a) * 65536 + correction;
    int shift = 16;
    for (; rest >= 0; rest -= ln2) --shift;
    for (; rest < 0; rest += ln2) ++shift;
    if (shift < 2) return RawLimits<int32_t>::max;

    const uint32_t i = static_cast<uint32_t>(rest) >> 28;
    const uint64_t b = read_program_memory(ExponentialSmallTable<>::factor[i]);
    const uint32_t r =
        static_cast<uint32_t>(rest) - read_program_memory(ExponentialSmallTable<>::logarithm[i]);
    const uint32_t cell = r >> 24;
    const uint32_t j = cell + (((r >> 16 & 0xff) + (cell * (cell + 1) >> 1)) >> 8);
    // r - ln(1 + j/256), below 2^-8.
    const uint32_t s = (r << 8) + read_program_memory(ExponentialSmallTable<>::shortfall[j]);
    const uint32_t s2 = s >> 24, s1 = s >> 16 & 0xff, s0 = s >> 8 & 0xff;
    const uint32_t square = s2 * s2;
    uint64_t c = static_cast<uint64_t>(s) + (square << 7) + s2 * s1 + (s1 * s1 >> 9) +
                 (s2 * s0 >> 8) + (s2 * (square >> 8) >> 8) * sixth;
    c += (c * j >> 8) + (static_cast<uint64_t>(j) << 32);
    c += (c * b >> 8) + (b << 32);

    const uint64_t mantissa = (uint64_t(1) << 32) + (c >> 8);
    return static_cast<int32_t>(((mantissa >> (shift - 1)) + 1) >> 1);
}

}  // namespace portable
}  // namespace fixedpoint
