// SPDX-License-Identifier: MIT
// The exponential function in Q16.16, bit for bit as avr/exp_q16_16.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_table.hpp>

namespace fixedpoint {
namespace portable {

// e^node (1 + growth) 2^23 from the upper three bytes of the power; growth is in units of 2^-24,
// and 16 bits of it count.
FIXEDPOINT_CONSTEXPR uint32_t grown_power_24(uint8_t node, int16_t growth) {
    const uint32_t power = read_program_memory(ExpTable<>::power[node]) >> 8;
    const int32_t power1 = power >> 8 & 0xff, power2 = static_cast<int32_t>(power >> 16);
    const int32_t growth1 = growth >> 8, growth0 = growth & 0xff;
    return power + static_cast<uint32_t>(power2 * growth1 + (power1 * growth1 >> 8) +
                                         (power2 * growth0 >> 8));
}

// e^node (1 + growth) 2^39; growth is in units of 2^-40.
FIXEDPOINT_CONSTEXPR uint64_t grown_power_40(uint8_t node, int32_t growth) {
    const uint32_t power = read_program_memory(ExpTable<>::power[node]);
    const int32_t power1 = power & 0xff, power2 = power >> 8 & 0xff, power3 = power >> 16 & 0xff,
                  power4 = static_cast<int32_t>(power >> 24);
    const int32_t growth0 = growth & 0xff, growth1 = growth >> 8 & 0xff,
                  growth2 = growth >> 16 & 0xff, growth3 = growth >> 24;
    const int32_t low = (power4 * growth0 >> 8) + (power3 * growth1 >> 8) +
                        (power2 * growth2 >> 8) + (power1 * growth3 >> 8) + power4 * growth1 +
                        power3 * growth2 + power2 * growth3;
    const int64_t high =
        static_cast<int64_t>(power4) * growth3 * 256 + power4 * growth2 + power3 * growth3;
    return (static_cast<uint64_t>(power) << 8 | read_program_memory(ExpTable<>::power_low[node])) +
           static_cast<uint64_t>(high * 256 + low);
}

// e^x 2^k from the reduced x: its position among the nodes, in units of 2^-16, and the tail of 24
// bits after it. The exponent is k + 17; the result fits in an unsigned number.
FIXEDPOINT_CONSTEXPR uint32_t small_power_q16_16(uint16_t position, uint32_t tail, int exponent) {
    uint8_t node = static_cast<uint8_t>(position >> 8);
    const int32_t s = static_cast<int32_t>(position & 0xff) - 128;
    int32_t growth = s * 256 + static_cast<int32_t>(tail >> 16) + (s * s >> 9);
    if (growth >> 15 == 1) {
        ++node;
        growth -= int32_t(1) << 16;
    }
    const uint32_t scaled = grown_power_24(node, static_cast<int16_t>(growth)) << (exponent & 7);
    const int shift = 8 * (3 - (exponent >> 3));
    return ((scaled >> (shift - 1)) + 1) >> 1;
}
// The same for large k. `tail_bits` bits of the tail count in the product with s.
FIXEDPOINT_CONSTEXPR uint32_t large_power_q16_16(uint16_t position, uint32_t tail, int tail_bits,
                                                 int exponent) {
    uint8_t node = static_cast<uint8_t>(position >> 8);
    const int32_t s = static_cast<int32_t>(position & 0xff) - 128;
    // e^r - 1 = r + r^2 / 2 + r^3 / 6 for r = s + tail.
    const int32_t square = s * s;
    const int32_t cube = s * (square >> 8) >> 8;
    int64_t growth =
        static_cast<int64_t>(s) * (int32_t(1) << 24) + static_cast<int32_t>(tail) + square * 128 +
        (s * static_cast<int32_t>(tail >> (24 - tail_bits)) >> (tail_bits - 8)) + cube * 43;
    if (growth >> 31 == 1) {
        // Only for s = 127: seen from the next node.
        ++node;
        const int32_t beyond = static_cast<int32_t>(growth >> 16 & 0xff);
        growth += (21 - beyond) * 256 - (int64_t(1) << 32);
    }
    const uint64_t mantissa = grown_power_40(node, static_cast<int32_t>(growth));
    if (exponent >= 32) return static_cast<uint32_t>(((mantissa >> 7) + 1) >> 1);
    const uint64_t scaled = mantissa << (exponent & 7);
    const int shift = 8 * (5 - (exponent >> 3));
    return static_cast<uint32_t>(((scaled >> (shift - 1)) + 1) >> 1);
}

FIXEDPOINT_CONSTEXPR int32_t exp_q16_16(int32_t a) {
    const int32_t whole = a >> 16;
    if (whole == ((a & 0x8000) != 0 ? -1 : 0)) {
        const int16_t growth = static_cast<int16_t>(((a & 0xff) - 128) * 256);
        return static_cast<int32_t>((grown_power_24(static_cast<uint8_t>(a >> 8), growth) + 64) >>
                                    7);
    }
    if (whole < -12) return 0;
    if (whole > 10) return RawLimits<int32_t>::max;

    // k + 17, where k is about x / ln 2 minus up to 0.7: x - k ln 2 is between -0.26 and 0.49.
    const int k = static_cast<int>(((whole + 12) * 185 + ((a >> 8 & 0xff) * 185 >> 8)) >> 7);
    const uint16_t position = static_cast<uint16_t>(a + read_program_memory(ExpTable<>::offset[k]));
    const uint32_t tail = read_program_memory(ExpTable<>::tail[k]);
    if (k < 21) return static_cast<int32_t>(small_power_q16_16(position, tail, k));
    const uint32_t result = large_power_q16_16(position, tail, 8, k);
    return result >> 31 != 0 ? RawLimits<int32_t>::max : static_cast<int32_t>(result);
}

// 2^a. a must be in [-17, 15).
FIXEDPOINT_CONSTEXPR int32_t exp2_unsaturated_q16_16(int32_t a) {
    constexpr int64_t ln2 = 0xb17218;  // 2^-24, too large by 8 2^-32
    const int16_t f = static_cast<int16_t>(a);
    const int exponent = static_cast<int>((a >> 16) + (f < 0 ? 1 : 0)) + 17;
    const bool small = exponent < 21;
    const int64_t rest = f * ln2 - (small ? 0x0c8000 : 0x0fffc0 + 8 * (f >> 8));
    const uint16_t position = static_cast<uint16_t>(rest >> 24);
    const uint32_t tail = static_cast<uint32_t>(rest) & 0xffffff;
    return static_cast<int32_t>(small ? small_power_q16_16(position, tail, exponent)
                                      : large_power_q16_16(position, tail, 16, exponent));
}

}  // namespace portable
}  // namespace fixedpoint
