// SPDX-License-Identifier: MIT
// The seam of sqrt: which code a format's square root runs through.
#pragma once

#include <fixedpoint/portable/sqrt.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline int32_t fixedpoint_sqrt_q16_16(
    int32_t a) {
    return fixedpoint::portable::sqrt<int32_t, 16>(a);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw sqrt(Raw a) {
    return portable::sqrt<Raw, F>(a);
}

#ifdef __AVR__
template <>
constexpr int32_t sqrt<int32_t, 16>(int32_t a) {
    return fixedpoint_sqrt_q16_16(a);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
