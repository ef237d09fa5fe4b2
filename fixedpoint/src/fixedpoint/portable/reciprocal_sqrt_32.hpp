// SPDX-License-Identifier: MIT
// The reciprocal square root of 32-bit numbers of F fraction bits, bit for bit as
// avr/reciprocal_sqrt_32.S computes it.
#pragma once

#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_32_table.hpp>
#include <fixedpoint/portable/scale_40.hpp>

namespace fixedpoint {
namespace portable {

// sqrt(1/m) in units of 2^-39, within 30 of them: for m from 2 to 4 in the lower half of all
// positions and from 1 to 2 in the upper half.
FIXEDPOINT_CONSTEXPR uint64_t reciprocal_root_40(uint32_t position) {
    using Table = ReciprocalSqrt32Table<>;
    const uint8_t interval = static_cast<uint8_t>(position >> 24);
    const uint32_t t = position & 0xffffff, t1 = t >> 8 & 0xff, t2 = t >> 16;
    const uint32_t twist = read_program_memory(Table::twist[interval]);
    const uint32_t bent = (static_cast<uint32_t>(read_program_memory(Table::bend[interval])) << 8) -
                          2 * (twist * t2 + (twist * t1 >> 8));
    const uint32_t slope = read_program_memory(Table::slope[interval]) - multiply_high_24(bent, t);
    return value_of<Table>(interval) - rise_40(slope, t);
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
    // The result is the mantissa 2^(twice / 2 - 9), with twice / 2 rounded down. The parity takes
    // the place of the leading one.
    const int twice = 3 * F + 19 - exponent;
    if (twice > 81) return RawLimits<int32_t>::max;
    if (twice < 14) return 0;
    const uint32_t parity = static_cast<uint32_t>(twice % 2) << 31;
    return scale_40(reciprocal_root_40((normalised & 0x7fffffff) | parity), twice / 2);
}

}  // namespace portable
}  // namespace fixedpoint
