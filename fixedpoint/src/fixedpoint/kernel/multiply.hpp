// SPDX-License-Identifier: MIT
// The seam of multiply: which code a format's product runs through.
#pragma once

#include <fixedpoint/portable/multiply.hpp>

#ifdef __AVR__
extern "C" int32_t fixedpoint_multiply_q16_16(int32_t a, int32_t b);
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw multiply(Raw a, Raw b) {
    return portable::multiply<Raw, F>(a, b);
}

#ifdef __AVR__
template <>
constexpr int32_t multiply<int32_t, 16>(int32_t a, int32_t b) {
    return __builtin_constant_p(a) && __builtin_constant_p(b) ? portable::multiply<int32_t, 16>(a, b)
                                                              : fixedpoint_multiply_q16_16(a, b);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
