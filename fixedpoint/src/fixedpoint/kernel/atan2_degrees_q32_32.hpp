// SPDX-License-Identifier: MIT
// The angle of a vector of Q32.32 in degrees. Results have up to nine bits before the point, so the
// angle in radians does not have enough fraction bits to scale it.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/atan_degrees_table.hpp>

namespace fixedpoint {
namespace kernel {
namespace q32_32 {

// A 64-bit number in two words, which the chip can shift by bytes without a call.
struct Words {
    uint32_t high, low;

    FIXEDPOINT_CONSTEXPR void up() {
        high = high << 8 | low >> 24;
        low <<= 8;
    }
};
FIXEDPOINT_CONSTEXPR Words words(uint64_t a) {
    return {static_cast<uint32_t>(a >> 32), static_cast<uint32_t>(a)};
}

constexpr uint16_t upper_half(uint32_t a) { return static_cast<uint16_t>(a >> 16); }

// 32 a + i b. i must be in 0..32.
FIXEDPOINT_CONSTEXPR uint32_t sum_of_multiples(uint16_t a, uint8_t i, uint16_t b) {
    return (static_cast<uint32_t>(a) << 5) + static_cast<uint32_t>(b) * i;
}

// The arc tangent of height / width in units of 2^-48 degrees. Requires height <= width < 2^63 and
// width > 0. With i / 32 nearest to the ratio, it is atan(i / 32) + atan(d), d = (32 height - i
// width) / (32 width + i height), |d| < 2^-5.9, and atan(d) = d - d^3 (1/3 - d^2/5 + d^4/7).
FIXEDPOINT_CONSTEXPR uint64_t degrees_of_ratio(Words height, Words width) {
    while (width.high < uint32_t(1) << 23) {
        width.up();
        height.up();
    }
    const uint32_t half_a_node = width.high >> 6;
    uint32_t rest = height.high + half_a_node;
    uint8_t i = 0;
    for (uint8_t bit = 32; bit != 0; bit = static_cast<uint8_t>(bit >> 1)) {
        if (rest >= width.high) {
            rest -= width.high;
            i = static_cast<uint8_t>(i | bit);
        }
        rest <<= 1;
    }
    const int32_t upper = static_cast<int32_t>(rest >> 1) - static_cast<int32_t>(half_a_node << 5);
    const int32_t lower =
        static_cast<int32_t>(((height.low >> 8) << 5) - (width.low >> 8) * uint32_t(i));
    const int64_t across = int64_t(upper) * (int32_t(1) << 24) + lower;  // of 2^8
    const uint32_t first = sum_of_multiples(upper_half(width.high), i, upper_half(height.high));
    const uint32_t second =
        sum_of_multiples(static_cast<uint16_t>(width.high), i, static_cast<uint16_t>(height.high));
    const uint32_t last = sum_of_multiples(upper_half(width.low), i, upper_half(height.low));
    const uint64_t along =  // of 2^16
        (((static_cast<uint64_t>(first) << 16) + second) << 16) + last;
    const int64_t d = divide<int64_t, 32>(across * 256, static_cast<int64_t>(along));  // 2^-48
    const int32_t coarse = static_cast<int32_t>(d >> 16);                              // 2^-32
    const int32_t square = multiply<int32_t, 22>(coarse, coarse);                      // 2^-42
    const int32_t fifth = 838861 - multiply<int32_t, 32>(square, 585);                 // 2^-22
    const int32_t third = 1431655765 - multiply<int32_t, 32>(square, fifth);           // 2^-32
    const int32_t bend = multiply<int32_t, 30>(multiply<int32_t, 28>(coarse, square), third);
    constexpr int64_t degrees_per_radian = 246083499208;  // 2^-32
    return read_program_memory(portable::AtanDegreesTable<>::angle[i]) +
           static_cast<uint64_t>(multiply<int64_t, 32>(d - bend, degrees_per_radian));
}

// |a|, or 1 less if a is the smallest number.
FIXEDPOINT_CONSTEXPR uint64_t below_2_63(int64_t a) {
    return magnitude(a == RawLimits<int64_t>::min ? -RawLimits<int64_t>::max : a);
}

FIXEDPOINT_CONSTEXPR int64_t atan2_degrees(int64_t y, int64_t x) {
    if ((x | y) == 0) return 0;
    constexpr uint64_t quarter_turn = uint64_t(90) << 48;
    const uint64_t height = below_2_63(y), width = below_2_63(x);
    const bool steep = height > width;
    uint64_t angle = steep ? degrees_of_ratio(words(width), words(height))
                           : degrees_of_ratio(words(height), words(width));
    if (steep) angle = quarter_turn - angle;
    if (x < 0) angle = 2 * quarter_turn - angle;
    const int64_t rounded = static_cast<int64_t>((angle + (uint32_t(1) << 15)) >> 16);
    return y < 0 ? -rounded : rounded;
}

}  // namespace q32_32
}  // namespace kernel
}  // namespace fixedpoint
