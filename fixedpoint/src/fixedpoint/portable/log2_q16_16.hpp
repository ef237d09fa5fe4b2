// SPDX-License-Identifier: MIT
// The binary logarithm in Q16.16, bit for bit as avr/log2_q16_16.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/log2_table.hpp>

namespace fixedpoint {
namespace portable {

// Only in Q16.16.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw log2(Raw a) {
    if (a <= 0) return RawLimits<int32_t>::min;
    uint32_t normalised = static_cast<uint32_t>(a);
    int32_t exponent = 31;
    while (normalised >> 31 == 0) {
        normalised <<= 1;
        --exponent;
    }
    const uint8_t interval = static_cast<uint8_t>((normalised >> 24) - 128);
    const uint16_t fraction = static_cast<uint16_t>(normalised >> 8);
    const uint32_t bend = read_program_memory(Log2Table<>::bend[interval]);
    const uint32_t sum = read_program_memory(Log2Table<>::value[interval]) +
                         rise(read_program_memory(Log2Table<>::slope[interval]), fraction) +
                         (height(fraction) * bend >> 8);
    return (exponent - 16) * 65536 + static_cast<int32_t>((2 * sum + fraction) >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
