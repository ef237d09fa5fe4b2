// SPDX-License-Identifier: MIT
// The reciprocal square root of 32-bit numbers of F fraction bits, bit for bit as
// avr/reciprocal_sqrt_32.S computes it.
#pragma once

#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_32_table.hpp>
#include <fixedpoint/portable/scale_40.hpp>

namespace fixedpoint {
namespace portable {

// mantissa / sqrt(2), or up to 4 units less: byte by byte, without the bytes below the result.
FIXEDPOINT_CONSTEXPR uint64_t over_root_of_two_40(uint64_t mantissa) {
    constexpr uint32_t factor = 0xb504f334;  // 2^-32
    uint64_t result = 0;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 4; ++j) {
            const uint32_t product =
                static_cast<uint32_t>(mantissa >> 8 * i & 0xff) * (factor >> 8 * j & 0xff);
            if (i + j == 3) result += product >> 8;
            if (i + j > 3)
                result += static_cast<uint64_t>(product) << 8 * (i + j > 3 ? i + j - 4 : 0);
        }
    }
    return result;
}

template <int F>
FIXEDPOINT_CONSTEXPR int32_t reciprocal_sqrt_32(int32_t a) {
    if (a <= 0) return a < 0 ? 0 : RawLimits<int32_t>::max;
    uint32_t normalised = static_cast<uint32_t>(a);
    int exponent = 31;
    while (normalised >> 31 == 0) {
        normalised <<= 1;
        --exponent;
    }
    // The result is the mantissa 2^(twice - 19) / 2.
    const int twice = 3 * F + 19 - exponent;
    if (twice > 81) return RawLimits<int32_t>::max;
    if (twice < 14) return 0;
    const uint64_t core = cubic_40<ReciprocalSqrt32Table<>>(normalised << 1).value;
    const uint64_t mantissa = ((uint64_t(1) << 39) - 1 - core) & 0xffffffffff;
    return scale_40(twice % 2 == 0 ? over_root_of_two_40(mantissa) : mantissa, twice / 2);
}

}  // namespace portable
}  // namespace fixedpoint
