// SPDX-License-Identifier: MIT
// Powers of e with more digits than a 32-bit number has, bit for bit as avr/exp_wide.S computes
// them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_32.hpp>

namespace fixedpoint {
namespace portable {

// e^(x 2^-40) 2^unit in units of 2^-32, rounded downward to 2^-8, with a relative error of 2^-33
// plus 2^-8. unit must be in 0..29. 0 if x is below -24; 2^32 - 1 without a fraction if the power
// is 2^32 or more, possibly already from 0.9 2^32 on.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR uint64_t exp_wide(Raw x, uint8_t unit) {
    static_assert(sizeof(Raw) == 8 && F == 40, "The argument has 24 bits before the point.");
    constexpr int64_t ln2 = 762123384786;  // 2^-40
    constexpr int offset = 35;
    constexpr uint64_t largest = uint64_t(0xffffffff) << 32;
    if (x >= int64_t(46) << 40) return largest;
    if (x < -(int64_t(24) << 40)) return 0;

    // k + 35, where x is k ln 2 minus a rest in 0..0.79.
    const int32_t whole = static_cast<int32_t>(x >> 40);
    const int32_t fraction = static_cast<int32_t>(x >> 32 & 0xff);
    const int k =
        static_cast<int>((whole * 185 + (fraction * 185 >> 8) + 128 * (offset + 1) + 9) >> 7);
    const uint64_t rest = static_cast<uint64_t>((k - offset) * ln2 - x) & 0xffffffffff;

    const int place = k - offset + 9 + unit;
    if (place < 0) return 0;
    if (place >= 42) return largest;
    const uint64_t mantissa = exp_mantissa_40(rest);
    return (place > 40 ? mantissa << (place - 40) : mantissa >> (40 - place)) << 24;
}

}  // namespace portable
}  // namespace fixedpoint
