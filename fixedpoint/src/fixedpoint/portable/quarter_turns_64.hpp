// SPDX-License-Identifier: MIT
// Angles of the splits of 64 bits with up to 30 fraction bits for the sine of Q32.32.
#pragma once

#include <fixedpoint/portable/short_turns.hpp>

namespace fixedpoint {
namespace portable {

// The angle in quarter turns, modulo 2^8, with 40 fraction bits, of which the last errs by 1. F is
// at most 30.
template <int F>
FIXEDPOINT_CONSTEXPR uint64_t quarter_turns_64(int64_t angle) {
    // 2/pi in units of 2^-128, and in units of 2^-56 that of an ulp of the angle, with its
    // fraction.
    constexpr uint64_t high = 0xa2f9836e4e441529, low = 0xfc2757d1f534ddc0;
    constexpr uint64_t whole = high >> (8 + F), fraction = high << (56 - F) | low >> (8 + F);
    const uint64_t a = static_cast<uint64_t>(angle);
    const uint64_t product = a * whole + multiply_high(a, fraction);
    return (angle < 0 ? product - fraction : product) >> 16;
}

}  // namespace portable
}  // namespace fixedpoint
