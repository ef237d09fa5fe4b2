// SPDX-License-Identifier: MIT
// The angle of a vector of Q32.32 in degrees. Results have up to nine bits before the point, so the
// angle in radians does not have enough fraction bits to scale it.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/atan_degrees_table.hpp>

namespace fixedpoint {
namespace kernel {
namespace q32_32 {

// The magnitude of a 64-bit number, or 1 less for the smallest one, in two words, which the chip
// shifts by bytes without a call.
struct Length {
    uint32_t high, low;

    FIXEDPOINT_CONSTEXPR void up() {
        high = word_from_byte_3(high, low);
        low <<= 8;
    }
};
FIXEDPOINT_IN_PLACE Length length_of(int64_t a) {
    const uint32_t high = upper_word(static_cast<uint64_t>(a)), low = static_cast<uint32_t>(a);
    if (static_cast<int32_t>(high) >= 0) return {high, low};
    const uint32_t negated = ~high + (low == 0 ? 1 : 0);
    return {negated - (negated >> 31), negated >> 31 != 0 ? 0xffffffff : 0 - low};
}

// The arc tangent of height / width in units of 2^-48 degrees. Requires height <= width < 2^63 and
// width > 0. With i / 64 nearest to the ratio, it is atan(i / 64) + atan(d), d = (height - width i
// / 64) / (width + height i / 64), |d| < 2^-6.9, and atan(d) = d - d^3 (1/3 - d^2/5).
FIXEDPOINT_CONSTEXPR uint64_t degrees_of_ratio(Length height, Length width) {
    while (width.high < uint32_t(1) << 23) {
        width.up();
        height.up();
    }
    uint32_t rest = height.high + (width.high >> 7);
    uint8_t i = 0;
    for (uint8_t bit = 64; bit != 0; bit = static_cast<uint8_t>(bit >> 1)) {
        if (rest >= width.high) {
            rest -= width.high;
            i = static_cast<uint8_t>(i | bit);
        }
        rest <<= 1;
    }
    // Equal sides leave d = 1 / 127.
    if (i == 64) i = 63;
    const uint8_t j = static_cast<uint8_t>(i << 2);
    const uint64_t h = join_words(height.high, height.low), w = join_words(width.high, width.low);
    const int64_t across = static_cast<int64_t>(h - byte_fraction<uint64_t, 0>(w, j));
    const uint64_t sum = w + byte_fraction<uint64_t, 0>(h, j);
    const uint32_t upper = upper_word(sum);
    const int64_t along = static_cast<int64_t>(join_words(  // of 2^16
        upper_half(upper), upper << 16 | upper_half(static_cast<uint32_t>(sum))));
    const int64_t d = divide<int64_t, 32>(across, along);  // 2^-48
    const int32_t coarse =                                 // 2^-32
        static_cast<int32_t>(upper_word(static_cast<uint64_t>(d)) << 16 |
                             upper_half(static_cast<uint32_t>(d)));
    const int32_t square = multiply<int32_t, 20>(coarse, coarse);  // 2^-44
    const int32_t third =                                          // 2^-32
        1431655765 -
        static_cast<int32_t>(multiply_halves(upper_half(static_cast<uint32_t>(square)), 819) >> 8);
    const int32_t bend = multiply<int32_t, 32>(multiply<int32_t, 28>(coarse, square), third);
    constexpr int64_t degrees_per_radian = 246083499208;  // 2^-32
    return read_program_memory(portable::AtanDegreesTable<>::angle[i]) +
           static_cast<uint64_t>(multiply<int64_t, 32>(d - bend, degrees_per_radian));
}

FIXEDPOINT_CONSTEXPR int64_t atan2_degrees(int64_t y, int64_t x) {
    const Length height = length_of(y), width = length_of(x);
    const bool steep =
        height.high > width.high || (height.high == width.high && height.low > width.low);
    if (!steep && (width.high | width.low) == 0) return 0;
    const bool left = static_cast<int32_t>(upper_word(static_cast<uint64_t>(x))) < 0;
    const uint64_t angle =
        steep ? degrees_of_ratio(width, height) : degrees_of_ratio(height, width);
    uint32_t upper = upper_word(angle), lower = static_cast<uint32_t>(angle);
    if (steep != left) {
        upper = ~upper + (lower == 0 ? 1 : 0);
        lower = 0 - lower;
    }
    if (steep) {
        upper += uint32_t(90) << 16;
    } else if (left) {
        upper += uint32_t(180) << 16;
    }
    // Rounded to units of 2^-32.
    lower += uint32_t(1) << 15;
    if (lower < uint32_t(1) << 15) ++upper;
    uint32_t result1 = upper_half(upper), result0 = upper << 16 | upper_half(lower);
    if (static_cast<int32_t>(upper_word(static_cast<uint64_t>(y))) < 0) {
        result1 = ~result1 + (result0 == 0 ? 1 : 0);
        result0 = 0 - result0;
    }
    return static_cast<int64_t>(join_words(result1, result0));
}

}  // namespace q32_32
}  // namespace kernel
}  // namespace fixedpoint
