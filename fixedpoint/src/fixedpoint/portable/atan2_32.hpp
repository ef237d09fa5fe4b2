// SPDX-License-Identifier: MIT
// atan2 and atan of 32-bit numbers of F fraction bits, bit for bit as avr/atan2_32.S computes them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/atan_32_table.hpp>
#include <fixedpoint/portable/cubic_32.hpp>

namespace fixedpoint {
namespace portable {

// The factor by which the kernel multiplies both coordinates. It makes the longer one, whose
// leading one is bit 31, 2^40 or slightly less: tables/reciprocal.py.
FIXEDPOINT_CONSTEXPR uint32_t factor_of_ratio_32(uint64_t longer) {
    const uint32_t factor =
        (uint32_t(1) << 17) / (257 + static_cast<uint32_t>(longer >> 23 & 0xff));
    return ((uint64_t(1) << 40) - longer * factor) >> 32 != 0 ? factor + 1 : factor;
}

// shorter / longer as the position in the table in units of 2^-32, and eight more bits.
struct Ratio32 {
    uint32_t position;
    uint32_t rest;
};
// Requires shorter <= longer <= 2^32 and longer > 0.
FIXEDPOINT_CONSTEXPR Ratio32 ratio_32(uint64_t shorter, uint64_t longer) {
    if (shorter == longer) return {0xffffffff, 0xff};
    const uint32_t position = static_cast<uint32_t>((shorter << 32) / longer);
    uint64_t rest = (shorter << 32) % longer;
    if (rest == 0) return {position, 0};
    while (longer >> 31 == 0) {
        longer <<= 1;
        rest <<= 1;
    }
    return {position, static_cast<uint32_t>(rest * factor_of_ratio_32(longer) >> 32)};
}
// The position or up to 2 less: three digits, and the upper byte of what is left. Requires
// shorter <= longer <= 2^31 and longer > 0.
FIXEDPOINT_CONSTEXPR uint32_t rough_ratio_32(uint64_t shorter, uint64_t longer) {
    constexpr uint64_t one = uint64_t(1) << 40;
    if (shorter == longer) return 0xffffffff;
    while (longer >> 31 == 0) {
        longer <<= 1;
        shorter <<= 1;
    }
    const uint64_t factor = factor_of_ratio_32(longer), missing = one - longer * factor;
    uint64_t rest = shorter * factor;
    uint32_t position = 0;
    for (int i = 0; i < 3; ++i) {
        uint32_t digit = static_cast<uint32_t>(rest >> 32);
        rest = (rest << 8 & (one - 1)) + digit * missing;
        // The digit was 1 too small.
        if (rest >= one) {
            ++digit;
            rest += missing - one;
        }
        position = (position << 8) + digit;
    }
    return (position << 8) + static_cast<uint32_t>(rest >> 32);
}

// The angle of (width, height), mirrored to the left half plane if `left`, in units of 2^-31, or of
// 2^-39 beyond 24 fraction bits. height and width must be at most 2^32 and not both 0.
template <int F>
FIXEDPOINT_CONSTEXPR int64_t unrounded_angle_32(uint64_t height, uint64_t width, bool left) {
    const bool steep = height > width;
    const uint64_t shorter = steep ? width : height, longer = steep ? height : width;
    constexpr bool is_coarse = is_coarse_32<F>();
    constexpr int64_t pi = is_coarse ? 6746518852 : 1727108826179;
    int64_t angle = 0;
    if (is_coarse) {
        // Plus two units for the truncation in the core and of the ratio.
        const uint32_t position = rough_ratio_32(shorter, longer);
        angle = static_cast<int64_t>(cubic_32<Atan32Table<>>(position)) + 2;
    } else {
        const Ratio32 ratio = ratio_32(shorter, longer);
        const Cubic40 core = cubic_40<Atan32Table<>>(ratio.position);
        angle = static_cast<int64_t>(core.value + (core.slope * ratio.rest >> 8));
    }
    return steep ? (left ? pi / 2 + angle : pi / 2 - angle) : (left ? pi - angle : angle);
}

// The same, rounded, and mirrored to the lower half plane if `below`.
template <int F>
FIXEDPOINT_CONSTEXPR int32_t angle_32(uint64_t height, uint64_t width, bool left, bool below) {
    constexpr int fraction_bits = is_coarse_32<F>() ? 31 : 39;
    constexpr int64_t half = F < fraction_bits ? int64_t(1) << (fraction_bits - 1 - F) : 0;
    const int64_t magnitude =
        (unrounded_angle_32<F>(height, width, left) + half) >> (fraction_bits - F);
    if (magnitude >> 31 != 0) return below ? RawLimits<int32_t>::min : RawLimits<int32_t>::max;
    return static_cast<int32_t>(below ? -magnitude : magnitude);
}

template <int F>
FIXEDPOINT_CONSTEXPR int32_t atan2_32(int32_t y, int32_t x) {
    return (x | y) == 0 ? 0 : angle_32<F>(magnitude(y), magnitude(x), x < 0, y < 0);
}

template <int F>
FIXEDPOINT_CONSTEXPR int32_t atan_32(int32_t a) {
    return angle_32<F>(magnitude(a), uint64_t(1) << F, false, a < 0);
}

}  // namespace portable
}  // namespace fixedpoint
