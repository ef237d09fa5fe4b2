// SPDX-License-Identifier: MIT
// atan2 and atan of Q32.32, bit for bit as avr/atan2_q32_32.S computes them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/atan_64_table.hpp>
#include <fixedpoint/portable/cubic_64.hpp>
#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/multiply_high_24.hpp>
#include <fixedpoint/portable/ratio_table.hpp>

namespace fixedpoint {
namespace portable {

// shorter / longer with 40 fraction bits, below 1. Requires shorter <= longer and longer > 0.
FIXEDPOINT_CONSTEXPR uint64_t ratio_q32_32(uint64_t shorter, uint64_t longer) {
    while (longer >> 63 == 0) {
        longer <<= 1;
        shorter <<= 1;
    }
    const uint64_t n = shorter >> 24, d = longer >> 24;
    // 2^63 / d: at most 34 too large before the bias, and never too large after it.
    constexpr uint32_t bias = 40;
    const uint32_t inverse = interpolate_falling<RatioTable<>>(
                                 static_cast<uint32_t>(d >> 15 & 0xffffff) & ~uint32_t(1)) -
                             bias;
    const uint32_t g = multiply_high_24(static_cast<uint32_t>(n >> 16), inverse) << 1;

    // n 2^24 - g d from byte products, without the lowest two bytes.
    uint32_t product = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 2 - i; j < 6 - i && j < 5; ++j) {
            product += (g >> 8 * i & 0xff) * static_cast<uint32_t>(d >> 8 * j & 0xff)
                       << 8 * (i + j - 2);
        }
    }
    const uint32_t remainder = (static_cast<uint32_t>(n) << 8) - product;
    const uint64_t ratio =
        (static_cast<uint64_t>(g) << 16) + multiply_high_24(remainder << 1 >> 8, inverse + bias);
    return ratio >> 40 != 0 ? 0xffffffffff : ratio;
}

// The angle of (width, height), mirrored to the left and to the lower half plane if `left` and
// `below`. height and width must not both be 0.
FIXEDPOINT_CONSTEXPR int64_t angle_q32_32(uint64_t height, uint64_t width, bool left, bool below) {
    // In units of 2^-39; the angle from the table includes half an ulp for rounding.
    constexpr int64_t half_pi = 863554413090, pi = 1727108826179, half = 1 << 6;
    const bool steep = height >= width;
    const int64_t angle = static_cast<int64_t>(
        cubic_64<Atan64Table<>>(steep ? ratio_q32_32(width, height) : ratio_q32_32(height, width)));
    const int64_t folded = steep  ? (left ? half_pi + angle : half_pi + 2 * half - angle)
                           : left ? pi + 2 * half - angle
                                  : angle;
    const int64_t magnitude = folded >> 7;
    return below ? -magnitude : magnitude;
}

FIXEDPOINT_CONSTEXPR int64_t atan2_q32_32(int64_t y, int64_t x) {
    return (x | y) == 0 ? 0 : angle_q32_32(magnitude(y), magnitude(x), x < 0, y < 0);
}

FIXEDPOINT_CONSTEXPR int64_t atan_q32_32(int64_t a) {
    return angle_q32_32(magnitude(a), uint64_t(1) << 32, false, a < 0);
}

}  // namespace portable
}  // namespace fixedpoint
