// SPDX-License-Identifier: MIT
// Argument reduction in the 64-bit formats with up to 30 fraction bits, for the sine of Q32.32.
#pragma once

#include <fixedpoint/kernel/multiply_high.hpp>

namespace fixedpoint {
namespace kernel {

// The angle in quarter turns, modulo 2^8, with 40 fraction bits, within one unit in the last place.
// F must be at most 30.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR uint64_t quarter_turns(Raw angle) {
    // 2/pi in units of 2^-128, and the quarter turns in one ulp of the angle, in units of 2^-56 and
    // with a 64-bit fraction.
    constexpr uint64_t high = 0xa2f9836e4e441529, low = 0xfc2757d1f534ddc0;
    constexpr int shift = 8 + (F <= 30 ? F : 0);
    constexpr uint64_t whole = high >> shift, fraction = high << (64 - shift) | low >> shift;
    const uint64_t a = static_cast<uint64_t>(angle);
    const uint64_t product = a * whole + multiply_high(a, fraction);
    return (angle < 0 ? product - fraction : product) >> 16;
}

}  // namespace kernel
}  // namespace fixedpoint
