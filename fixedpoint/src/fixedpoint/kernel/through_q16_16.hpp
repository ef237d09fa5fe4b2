// SPDX-License-Identifier: MIT
// Functions of the formats of 8 and 16 bits by way of Q16.16, which holds all their numbers: its
// kernels are many times faster than the portable code of a narrow format, and exact enough. An
// error of e ulp in Q16.16 leaves 1/2 + e 2^(F-16) ulp after the rounding to F fraction bits: at
// most 0.6 ulp for e < 0.8 and F <= 13.
#pragma once

#include <fixedpoint/portable/convert.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr bool through_q16_16 = sizeof(Raw) <= 2 && F <= 13;

// a as Q16.16, exact. Precondition: through_q16_16<Raw, F>.
template <class Raw, int F>
constexpr int32_t to_q16_16(Raw a) {
    return portable::convert<int32_t, 16, Raw, F>(a);
}

// a rounded to F fraction bits and clamped.
template <class Raw, int F>
constexpr Raw from_q16_16(int32_t a) {
    return portable::convert_clamped<Raw, F, int32_t, 16>(a).number;
}

}  // namespace kernel
}  // namespace fixedpoint
