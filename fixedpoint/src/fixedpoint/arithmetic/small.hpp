// SPDX-License-Identifier: MIT
// Small: as Nearest, with a division and functions that take little flash instead of little time.
// In Q16.16 they share code and have tables of 112 bytes at most; elsewhere they have no tables but
// a few constants. Bounds are the same; quotients and roots are the same too, other results may
// differ in the last place.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>

namespace fixedpoint {

struct Small : Nearest {
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return kernel::divide_small<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return kernel::sqrt_small<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::reciprocal_sqrt_small<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::atan_small<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::atan2_small<Raw, F>(y, x);
    }
    template <class Raw, int F>
    static constexpr Raw sin(Raw angle) {
        return kernel::sin_small<Raw, F>(angle);
    }
    template <class Raw, int F>
    static constexpr Raw cos(Raw angle) {
        return kernel::cos_small<Raw, F>(angle);
    }
    template <class Raw, int F>
    static constexpr Raw exp(Raw a) {
        return kernel::exp_small<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw log(Raw a) {
        return kernel::log_small<Raw, F>(a);
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        sine_and_cosine[0] = sin<Raw, F>(angle);
        sine_and_cosine[1] = cos<Raw, F>(angle);
    }
};

}  // namespace fixedpoint
