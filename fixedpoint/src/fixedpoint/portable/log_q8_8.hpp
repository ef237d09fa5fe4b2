// SPDX-License-Identifier: MIT
// log in Q8.8, bit for bit as avr/log_q8_8.S computes it; within 0.522 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/chords_of_bytes.hpp>
#include <fixedpoint/portable/log_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int16_t log_q8_8(int16_t a) {
    if (a <= 0) return RawLimits<int16_t>::min;
    // The logarithm of 2^7, and ln 2, in units of 2^-8 ulp.
    constexpr int32_t log_128 = 317983, log_2 = 45426;
    uint16_t mantissa = static_cast<uint16_t>(a);
    int32_t logarithm = log_128;
    for (; (mantissa & 0x8000) == 0; mantissa = static_cast<uint16_t>(mantissa << 1))
        logarithm -= log_2;
    // Without the leading one.
    const uint16_t position = (mantissa & 0x7fff) >> 1;
    return static_cast<int16_t>(
        (logarithm + chord_of_bytes<LogQ8_8Table<>>(position) * int32_t(8)) >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
