// SPDX-License-Identifier: MIT
// The seam of multiply_add: which code a format's product and sum run through.
#pragma once

#include <fixedpoint/kernel/multiply.hpp>
#include <fixedpoint/portable/multiply_add.hpp>

#ifdef __AVR__
extern "C" int32_t fixedpoint_multiply_add_q16_16(int32_t a, int32_t b, int32_t c);
#endif

namespace fixedpoint {
namespace kernel {

// A whole number of ulps may be added after the rounding.
template <class Raw, int F>
constexpr Raw multiply_add(Raw a, Raw b, Raw c) {
    return wrapping_add(multiply<Raw, F>(a, b), c);
}

#ifdef __AVR__
template <>
constexpr int32_t multiply_add<int32_t, 16>(int32_t a, int32_t b, int32_t c) {
    return __builtin_constant_p(a) && __builtin_constant_p(b) && __builtin_constant_p(c)
               ? portable::multiply_add<int32_t, 16>(a, b, c)
               : fixedpoint_multiply_add_q16_16(a, b, c);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
