// SPDX-License-Identifier: MIT
// Which formats have their functions computed in Q16.16: those narrower than 32 bits whose numbers
// it represents, and that are so much coarser that its errors hardly count. An error of e ulp in
// Q16.16 becomes 1/2 + e 2^(F-16) ulp after the rounding to F fraction bits: at most 0.6 ulp for
// e < 0.8 and F <= 13.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr bool through_q16_16() {
    return sizeof(Raw) < 4 && F <= 13 && RawLimits<Raw>::width - F <= 16;
}

}  // namespace portable
}  // namespace fixedpoint
