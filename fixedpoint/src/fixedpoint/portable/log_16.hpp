// SPDX-License-Identifier: MIT
// log in 16-bit formats with up to 8 fraction bits, bit for bit as avr/log_q8_8.inc computes it;
// within 0.522 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/chords_of_bytes.hpp>
#include <fixedpoint/portable/log_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

template <int F>
FIXEDPOINT_CONSTEXPR int16_t log_16(int16_t a) {
    if (a <= 0) return RawLimits<int16_t>::min;
    // In units of 2^-16: the logarithm of 2^(15 - F), plus the difference between half an ulp and
    // that of Q8.8, which the table includes; and ln 2.
    constexpr int32_t largest =
        ((15 - F) * int32_t(4542609) + 50) / 100 + 128 * ((int32_t(1) << (8 - F)) - 1);
    constexpr int32_t log_2 = 45426;
    uint16_t mantissa = static_cast<uint16_t>(a);
    int32_t logarithm = largest;
    for (; (mantissa & 0x8000) == 0; mantissa = static_cast<uint16_t>(mantissa << 1))
        logarithm -= log_2;
    // Without the leading one.
    const uint16_t position = (mantissa & 0x7fff) >> 1;
    return static_cast<int16_t>(
        (logarithm + chord_of_bytes<LogQ8_8Table<>>(position) * int32_t(8)) >> (16 - F));
}

}  // namespace portable
}  // namespace fixedpoint
