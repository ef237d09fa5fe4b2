// SPDX-License-Identifier: MIT
// e^a in Q16.16 by two small tables, bit for bit as avr/exp_q16_16_small.S computes it, which says
// what each step is; within 0.73 ulp for every input.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_small_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t exp_small_q16_16(int32_t a) {
    constexpr int64_t ln2 = 0xb17217f8, correction = 3;
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
    const uint32_t j = r >> 24;
    const uint32_t s2 = r >> 16 & 0xff, s1 = r >> 8 & 0xff, s0 = r & 0xff;
    const uint32_t square = s2 * s2;
    const uint64_t v = static_cast<uint64_t>(r & 0xffffff) * 256 + (square << 7) + s2 * s1 +
                       (s2 * s0 >> 8) + (s2 * (square >> 8) >> 8) * sixth;
    const uint32_t v3 = v >> 24 & 0xff, v2 = v >> 16 & 0xff, v1 = v >> 8 & 0xff;
    const uint64_t fine =
        static_cast<uint64_t>(j) << 32 | read_program_memory(ExponentialSmallTable<>::fine[j]);
    const uint32_t t3 = fine >> 24 & 0xff, t2 = fine >> 16 & 0xff, t1 = fine >> 8 & 0xff;
    const uint64_t c = fine + v + (v >> 32 != 0 ? fine >> 8 : 0) + (j * v3 << 16) +
                       ((j * v2 + t3 * v3) << 8) + j * v1 + t3 * v2 + t2 * v3 + (t3 * v1 >> 8) +
                       (t2 * v2 >> 8) + (t1 * v3 >> 8);

    const uint64_t mantissa = (uint64_t(1) << 32) + (b << 24) + ((c + (b * c >> 8)) >> 8);
    return static_cast<int32_t>(((mantissa >> (shift - 1)) + 1) >> 1);
}

}  // namespace portable
}  // namespace fixedpoint
