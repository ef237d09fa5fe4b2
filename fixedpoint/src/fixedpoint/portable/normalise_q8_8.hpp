// SPDX-License-Identifier: MIT
// normalise3 in Q8.8, bit for bit as avr/normalise3_q8_8.S computes it; within 0.66 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q8_8.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR void normalise3_q8_8(const int16_t* v, int16_t* unit) {
    uint32_t scaled[3] = {};
    uint32_t largest = 0;
    for (int i = 0; i < 3; ++i) {
        scaled[i] =
            v[i] == RawLimits<int16_t>::min ? magnitude(RawLimits<int16_t>::max) : magnitude(v[i]);
        largest |= scaled[i];
    }
    if (largest == 0) {
        for (int i = 0; i < 3; ++i) unit[i] = 0;
        return;
    }
    int shift = 0;
    for (; largest >> 14 == 0; largest <<= 1) ++shift;
    uint32_t sum = 0;
    for (uint32_t& a : scaled) {
        a <<= shift;
        const uint32_t high = a >> 8, low = a & 0xff;
        sum += (high * high << 8) + 2 * high * low + (low * low >> 8);
    }
    const bool small = sum >> 22 == 0;
    const uint32_t root = static_cast<uint32_t>(reciprocal_root_q8_8(
                              static_cast<uint16_t>((small ? sum << 2 : sum) >> 8)))
                          << (small ? 2 : 1);
    for (int i = 0; i < 3; ++i) {
        const uint32_t product = (scaled[i] >> 8) * root + ((scaled[i] & 0xff) * (root >> 8));
        const int16_t component = static_cast<int16_t>(((product >> 8) + 16) >> 5);
        unit[i] = v[i] < 0 ? static_cast<int16_t>(-component) : component;
    }
}

}  // namespace portable
}  // namespace fixedpoint
