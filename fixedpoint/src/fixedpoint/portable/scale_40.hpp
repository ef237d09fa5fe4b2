// SPDX-License-Identifier: MIT
// The last step of 32-bit functions whose results have an exponent, bit for bit as avr/scale_40.S
// computes it.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

// mantissa 2^(place - 48) rounded to nearest and saturated. The mantissa is in units of 2^-39 and
// at most about 1; place must be in 7..41.
FIXEDPOINT_CONSTEXPR int32_t scale_40(uint64_t mantissa, int place) {
    const uint64_t result = ((mantissa >> (47 - place)) + 1) >> 1;
    return result >> 31 != 0 ? RawLimits<int32_t>::max : static_cast<int32_t>(result);
}

}  // namespace portable
}  // namespace fixedpoint
