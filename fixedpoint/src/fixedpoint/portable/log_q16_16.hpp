// SPDX-License-Identifier: MIT
// The natural logarithm in Q16.16, bit for bit as avr/log_q16_16.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/log_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t log_q16_16(int32_t a) {
    if (a <= 0) return RawLimits<int32_t>::min;
    uint32_t normalised = static_cast<uint32_t>(a);
    int exponent = 31;
    while (normalised >> 31 == 0) {
        normalised <<= 1;
        --exponent;
    }
    const uint8_t interval = static_cast<uint8_t>(normalised >> 23);
    const uint16_t fraction = static_cast<uint16_t>(normalised >> 8 << 1);
    const uint32_t mantissa_logarithm =
        read_program_memory(LogTable<>::value[interval]) +
        rise(read_program_memory(LogTable<>::slope[interval]), fraction);
    return static_cast<int32_t>(read_program_memory(LogTable<>::exponent[exponent]) +
                                mantissa_logarithm) >>
           8;
}

}  // namespace portable
}  // namespace fixedpoint
