// SPDX-License-Identifier: MIT
// normalise3: v / |v|, in place or elsewhere; a zero vector stays zero. Each component is rounded
// to nearest, except in Q16.16: there within 0.9 ulp, bit for bit as the kernel computes it.
#pragma once

#include <fixedpoint/portable/reciprocal_sqrt.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
struct Normalisation {
    static constexpr void apply(const Raw* v, Raw* unit) {
        const DoubleWord<Raw> length_squared = sum_of_squares(v, 3);
        for (int i = 0; i < 3; ++i) {
            // The zero vector has no ratio; a zero component needs none.
            const Raw component =
                v[i] == 0 ? Raw(0)
                          : nearest_root_of_ratio<Raw>(square(v[i]), length_squared, 2 * F);
            unit[i] = v[i] < 0 ? static_cast<Raw>(-component) : component;
        }
    }
};

// The steps of the kernel; their error budget is in avr/normalise3_q16_16.S.
template <>
struct Normalisation<int32_t, 16> {
    static constexpr void apply(const int32_t* v, int32_t* unit) {
        uint32_t scaled[3] = {};
        uint32_t largest = 0;
        for (int i = 0; i < 3; ++i) {
            scaled[i] = v[i] == raw_min<int32_t> ? magnitude(raw_max<int32_t>) : magnitude(v[i]);
            largest |= scaled[i];
        }
        if (largest == 0) {
            for (int i = 0; i < 3; ++i) unit[i] = 0;
            return;
        }
        int shift = 0;
        while (largest >> 30 == 0) {
            largest <<= 1;
            ++shift;
        }
        uint32_t sum = 0;
        for (uint32_t& a : scaled) {
            a = a << shift >> 8;
            sum += (a >> 8) * (a >> 8) + 2 * (a >> 16) * (a & 0xff);
        }
        const bool small = sum >> 30 == 0;
        const uint32_t reciprocal = reciprocal_root_mantissa(small ? sum << 2 : sum)
                                    << (small ? 1 : 0);
        for (int i = 0; i < 3; ++i) {
            const uint32_t a = scaled[i];
            const uint32_t product = (a >> 8) * (reciprocal >> 8) +
                                     (a >> 16) * (reciprocal & 0xff) +
                                     (a & 0xff) * (reciprocal >> 16);
            const int32_t component = static_cast<int32_t>(((product >> 13) + 1) >> 1);
            unit[i] = v[i] < 0 ? -component : component;
        }
    }
};

template <class Raw, int F>
constexpr void normalise3(const Raw* v, Raw* unit) {
    Normalisation<Raw, F>::apply(v, unit);
}

}  // namespace portable
}  // namespace fixedpoint
