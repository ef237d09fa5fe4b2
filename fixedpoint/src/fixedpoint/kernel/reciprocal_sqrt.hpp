// SPDX-License-Identifier: MIT
// The seam of reciprocal_sqrt: which code a format's reciprocal square root runs through.
#pragma once

#include <fixedpoint/portable/reciprocal_sqrt.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline int32_t
fixedpoint_reciprocal_sqrt_q16_16(int32_t a) {
    return fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(a);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw reciprocal_sqrt(Raw a) {
    return portable::reciprocal_sqrt<Raw, F>(a);
}

#ifdef __AVR__
template <>
constexpr int32_t reciprocal_sqrt<int32_t, 16>(int32_t a) {
    return fixedpoint_reciprocal_sqrt_q16_16(a);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
